//! Files that appear whole or not at all.

use crate::failure::Failure;
use onepulse_hwmodel::trace::BackgroundWriter;
use std::fs;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// An output file that is written beside its place and moved there when it is complete.
#[derive(Debug)]
pub(crate) struct OutputFile {
    path: PathBuf,
    file: NamedTempFile,
}

impl OutputFile {
    /// Begins the file that will be `path`.
    pub(crate) fn create(path: &Path) -> Result<Self, Failure> {
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        if path.is_dir() {
            return Err(Failure::Fault(format!("{}: is a directory", path.display())));
        }
        if !folder.is_dir() {
            let why = format!("{}: there is no folder {}", path.display(), folder.display());
            return Err(Failure::Fault(why));
        }
        let mut builder = tempfile::Builder::new();
        builder.prefix(".onepulse-");
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // As any new file: the umask takes away what it should.
            builder.permissions(fs::Permissions::from_mode(0o666));
        }
        let file = builder.tempfile_in(folder).map_err(|error| Failure::file(path, &error))?;
        Ok(Self { path: path.to_owned(), file })
    }

    /// A buffered writer into the file.
    pub(crate) fn writer(&self) -> Result<BufWriter<fs::File>, Failure> {
        let file = self.file.as_file().try_clone().map_err(|error| self.failure(&error))?;
        Ok(BufWriter::with_capacity(1 << 16, file))
    }

    /// A writer into the file that works beside its caller: for waves, the largest of all files.
    pub(crate) fn background_writer(&self) -> Result<BackgroundWriter<fs::File>, Failure> {
        let writer = self.file.as_file().try_clone().and_then(BackgroundWriter::new);
        writer.map_err(|error| self.failure(&error))
    }

    /// An error of this file.
    pub(crate) fn failure(&self, error: &std::io::Error) -> Failure {
        Failure::file(&self.path, error)
    }

    /// Moves the complete file to its place.
    pub(crate) fn finish(self) -> Result<(), Failure> {
        let path = self.path;
        self.file.persist(&path).map_err(|error| Failure::file(&path, &error.error))?;
        Ok(())
    }
}

/// Writes a small file whole.
pub(crate) fn write_whole(path: &Path, text: &str) -> Result<OutputFile, Failure> {
    let file = OutputFile::create(path)?;
    let mut writer = file.writer()?;
    let written = writer.write_all(text.as_bytes()).and_then(|()| writer.flush());
    written.map_err(|error| file.failure(&error))?;
    Ok(file)
}

/// A folder for output files, made if it is not there, and removed again if nothing came of it.
#[derive(Debug)]
pub(crate) struct OutputFolder {
    path: PathBuf,
    /// The folders that were made for it, the innermost first.
    made: Vec<PathBuf>,
}

impl OutputFolder {
    /// The folder, made now if it does not exist.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        let missing = |folder: &&Path| !folder.as_os_str().is_empty() && !folder.exists();
        let made = path.ancestors().take_while(missing).map(Path::to_owned).collect();
        let folder = Self { path: path.to_owned(), made };
        fs::create_dir_all(path).map_err(|error| Failure::file(path, &error))?;
        Ok(folder)
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Begins a file in it.
    pub(crate) fn create(&self, name: &str) -> Result<OutputFile, Failure> {
        OutputFile::create(&self.path.join(name))
    }
}

impl Drop for OutputFolder {
    fn drop(&mut self) {
        for folder in &self.made {
            // Fails, rightly, unless the folder is empty.
            let _ = fs::remove_dir(folder);
        }
    }
}
