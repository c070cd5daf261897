//! The core's files, and which of them are state machines.

use super::Error;
use std::fs;
use std::path::Path;

/// What every state machine of the core has.
const STEP: &str = "pub fn step(&mut self)";

/// The files below a folder as claims name them (`ppc/line`): all of them, and those with a step.
pub(crate) fn machines(folder: &Path) -> Result<(Vec<String>, Vec<String>), Error> {
    let mut files = Vec::new();
    let mut with_step = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(inner) = folders.pop() {
        for entry in fs::read_dir(&inner).map_err(Error::file(&inner))? {
            let path = entry.map_err(Error::file(&inner))?.path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let name = path.strip_prefix(folder).unwrap_or(&path).with_extension("");
            let name = name.to_string_lossy().into_owned();
            if fs::read_to_string(&path).map_err(Error::file(&path))?.contains(STEP) {
                with_step.push(name.clone());
            }
            files.push(name);
        }
    }
    with_step.sort();
    Ok((files, with_step))
}
