//! What the tests of the command line share: a folder, and the command in it.
#![allow(dead_code, reason = "each test takes what it needs")]

use assert_cmd::cargo::cargo_bin_cmd;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;
use tempfile::TempDir;

/// A file of the repository's programs.
pub(crate) fn program(name: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../programs").join(name);
    path.to_str().unwrap().to_owned()
}

/// A folder with these files.
pub(crate) fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

/// `onepulse` in a folder, with these arguments separated by blanks.
pub(crate) fn onepulse(folder: &Path, arguments: &str) -> Output {
    let mut command = cargo_bin_cmd!("onepulse");
    command.current_dir(folder).args(arguments.split_whitespace()).output().unwrap()
}

/// What a command that succeeds says on standard output; it has nothing else to say.
pub(crate) fn said(folder: &Path, arguments: &str) -> String {
    let output = onepulse(folder, arguments);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments}: {errors}");
    assert_eq!(errors, "", "{arguments}");
    String::from_utf8(output.stdout).unwrap()
}

/// What a command says that fails with this exit status.
pub(crate) fn failure(folder: &Path, arguments: &str, status: i32) -> String {
    let output = onepulse(folder, arguments);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(status), "{arguments}: {errors}");
    assert!(!errors.contains("panicked"), "{errors}");
    errors
}

/// The report of a run into `out`.
pub(crate) fn report(folder: &Path) -> Value {
    let text = fs::read_to_string(folder.join("out/report.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}
