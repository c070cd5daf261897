//! The programs that the prover calls.

use super::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Where `tools/install-proof-tools` unpacks, seen from the repository's root.
const FOLDER: &str = "target/proof-tools/bin";

/// Names another copy of the repository whose harnesses are to be proved: one with a mutant in it.
pub(crate) const ROOT: &str = "ONEPULSE_ROOT";

/// The root of the repository.
pub(crate) fn root() -> PathBuf {
    if let Some(root) = std::env::var_os(ROOT) {
        return root.into();
    }
    let verify = Path::new(env!("CARGO_MANIFEST_DIR"));
    verify.parent().unwrap_or(verify).to_owned()
}

/// The unpacked program, or else the one in the PATH.
pub(crate) fn find(name: &'static str) -> Result<PathBuf, Error> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::iter::once(root().join(FOLDER))
        .chain(std::env::split_paths(&path))
        .map(|folder| folder.join(name))
        .find(|program| program.is_file())
        .ok_or(Error::MissingTool(name))
}

/// The PATH with the unpacked programs first, for tools that call others.
pub(crate) fn search_path() -> std::ffi::OsString {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders = std::iter::once(root().join(FOLDER)).chain(std::env::split_paths(&path));
    std::env::join_paths(folders).unwrap_or(path)
}

/// Runs to the end; its standard output, if it succeeded.
pub(crate) fn output(command: &mut Command) -> Result<String, Error> {
    let program = command.get_program().to_string_lossy().into_owned();
    let output =
        command.output().map_err(|source| Error::Spawn { program: program.clone(), source })?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() {
        return Ok(text);
    }
    let errors = String::from_utf8_lossy(&output.stderr);
    Err(Error::Tool { program, output: format!("{errors}{text}") })
}

/// Name and version of what a proof rests on.
pub(crate) fn versions() -> Result<Vec<(&'static str, String)>, Error> {
    ["rustc", "wasm2c", "cbmc", "cadical", "z3", "cvc5"]
        .into_iter()
        .map(|name| {
            let said = output(Command::new(find(name)?).arg("--version"))?;
            let line = said.lines().next().unwrap_or_default();
            Ok((name, version_of(line)))
        })
        .collect()
}

/// The first word that begins with a digit.
fn version_of(line: &str) -> String {
    let is_number = |word: &&str| word.starts_with(|first: char| first.is_ascii_digit());
    line.split_whitespace().find(is_number).unwrap_or(line).to_owned()
}
