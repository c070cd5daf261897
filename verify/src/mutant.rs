//! Copies of the Verilog with one small change.

use std::fs;
use std::path::Path;

/// A small change of one Verilog file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mutant {
    /// The file's name.
    pub(crate) file: &'static str,
    /// What stands there once.
    pub(crate) from: &'static str,
    /// What is put there.
    pub(crate) to: &'static str,
}

impl Mutant {
    /// For messages.
    pub(crate) fn name(&self) -> String {
        format!("{}: {} -> {}", self.file, self.from, self.to)
    }

    /// Copies the Verilog files of a folder and of its `formal/`, with the change, into an empty
    /// folder.
    ///
    /// # Errors
    /// A file that cannot be copied; a change that does not fit the source any more.
    pub(crate) fn copy(&self, rtl: &Path, folder: &Path) -> Result<(), String> {
        let text = |e: std::io::Error| format!("{}: {e}", self.name());
        let _ = fs::remove_dir_all(folder);
        fs::create_dir_all(folder.join("formal")).map_err(text)?;
        let mut is_changed = false;
        for part in [".", "formal"] {
            for entry in fs::read_dir(rtl.join(part)).map_err(text)? {
                let path = entry.map_err(text)?.path();
                let Some(name) = path.file_name().filter(|_| is_verilog(&path)) else { continue };
                let mut source = fs::read_to_string(&path).map_err(text)?;
                if name == self.file {
                    is_changed = source.matches(self.from).count() == 1;
                    source = source.replace(self.from, self.to);
                }
                fs::write(folder.join(part).join(name), source).map_err(text)?;
            }
        }
        if is_changed { Ok(()) } else { Err(format!("{}: does not stand there once", self.name())) }
    }
}

/// Whether a path is that of a Verilog file.
pub(crate) fn is_verilog(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "v")
}
