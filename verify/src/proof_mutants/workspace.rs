//! A copy of the repository that mutants are put into.

use super::mutant::Mutant;
use std::fs;
use std::path::{Path, PathBuf};

/// A copy with a target folder of its own, so that builds in it are incremental.
#[derive(Debug)]
pub(super) struct Workspace {
    pub(super) folder: PathBuf,
}

/// What is not copied: what is built, and the history.
const LEFT_OUT: [&str; 3] = ["target", ".git", "out"];

impl Workspace {
    /// Copies what differs, so that what an earlier run built there is not built again.
    pub(super) fn new(root: &Path, folder: PathBuf) -> Result<Self, String> {
        copy(root, &folder)?;
        Ok(Self { folder })
    }

    /// Works on the copy with one file's text changed, and changes it back.
    pub(super) fn with<T>(
        &self,
        file: &str,
        change: impl FnOnce(&str) -> Result<String, String>,
        work: impl FnOnce(&Self) -> Result<T, String>,
    ) -> Result<T, String> {
        let path = self.folder.join(file);
        let source = read(&path)?;
        write(&path, &change(&source)?)?;
        let done = work(self);
        write(&path, &source)?;
        done
    }

    /// The same with a mutant.
    pub(super) fn with_mutant<T>(
        &self,
        mutant: &Mutant,
        work: impl FnOnce(&Self) -> Result<T, String>,
    ) -> Result<T, String> {
        self.with(&mutant.file, |source| Ok(mutant.applied(source)), work)
    }
}

pub(super) fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|why| format!("{}: {why}", path.display()))
}

pub(super) fn write(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, text).map_err(|why| format!("{}: {why}", path.display()))
}

fn copy(from: &Path, to: &Path) -> Result<(), String> {
    let text = |why: std::io::Error| format!("{}: {why}", from.display());
    fs::create_dir_all(to).map_err(text)?;
    for entry in fs::read_dir(from).map_err(text)? {
        let entry = entry.map_err(text)?;
        let name = entry.file_name();
        let (from, to) = (entry.path(), to.join(&name));
        if LEFT_OUT.iter().any(|left_out| name == *left_out) {
            continue;
        }
        if entry.file_type().map_err(text)?.is_dir() {
            copy(&from, &to)?;
        } else {
            let content = fs::read(&from).map_err(text)?;
            if fs::read(&to).ok().as_ref() != Some(&content) {
                fs::write(&to, content).map_err(text)?;
            }
        }
    }
    Ok(())
}
