//! Copies of the Verilog with one small change.

use std::borrow::Cow;
use std::fs;
use std::path::Path;

/// A small change of one Verilog file.
#[derive(Clone, Debug)]
pub(crate) struct Mutant {
    /// The file's name.
    pub(crate) file: Cow<'static, str>,
    /// What stands there.
    pub(crate) from: Cow<'static, str>,
    /// What is put there.
    pub(crate) to: Cow<'static, str>,
    /// Where: at this byte of the file, or else at the only place.
    at: Option<usize>,
}

impl Mutant {
    /// A change where `from` stands once in the file.
    pub(crate) const fn new(file: &'static str, from: &'static str, to: &'static str) -> Self {
        let [file, from, to] = [Cow::Borrowed(file), Cow::Borrowed(from), Cow::Borrowed(to)];
        Self { file, from, to, at: None }
    }

    /// For every assignment to a register in the files of a folder, the mutant that assigns the
    /// complement.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub(crate) fn of_every_register(rtl: &Path) -> Result<Vec<Self>, String> {
        let text = |e: std::io::Error| format!("{}: {e}", rtl.display());
        let mut files = Vec::new();
        for entry in fs::read_dir(rtl).map_err(text)? {
            let path = entry.map_err(text)?.path();
            if is_verilog(&path) {
                files.push(path);
            }
        }
        files.sort();
        let mut mutants = Vec::new();
        for path in files {
            let source = fs::read_to_string(&path).map_err(text)?;
            let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            // The twins have this operator for nothing else.
            for (arrow, _) in source.match_indices("<= ") {
                let begin = source[..arrow].rfind('\n').map_or(0, |end| end + 1);
                let end = source[arrow..].find(';').map_or(source.len(), |end| arrow + end);
                let from = &source[begin..end];
                let (target, value) = from.split_at(arrow - begin);
                let to = format!("{target}<= ~({})", &value["<= ".len()..]);
                let (file, from) = (file.clone().into(), from.to_owned().into());
                mutants.push(Self { file, from, to: to.into(), at: Some(begin) });
            }
        }
        Ok(mutants)
    }

    /// For messages.
    pub(crate) fn name(&self) -> String {
        let [from, to] = [&self.from, &self.to]
            .map(|text| text.split_whitespace().collect::<Vec<_>>().join(" "));
        format!("{}: {from} -> {to}", self.file)
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
                if *name == *self.file {
                    is_changed = self.change(&mut source);
                }
                fs::write(folder.join(part).join(name), source).map_err(text)?;
            }
        }
        if is_changed { Ok(()) } else { Err(format!("{}: does not stand there once", self.name())) }
    }

    /// Changes the file, if the text stands where it should.
    fn change(&self, source: &mut String) -> bool {
        let only = || match &*source.match_indices(&*self.from).collect::<Vec<_>>() {
            [(at, _)] => Some(*at),
            _ => None,
        };
        let Some(at) = self.at.or_else(only) else { return false };
        let range = at..at + self.from.len();
        if source.get(range.clone()) != Some(&*self.from) {
            return false;
        }
        source.replace_range(range, &self.to);
        true
    }
}

/// Whether a path is that of a Verilog file.
pub(crate) fn is_verilog(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "v")
}
