//! The tests of a package in a copy of the repository: built, and run up to a time limit.

use super::workspace::{Workspace, read};
use crate::prover::tools::search_path;
use serde::Deserialize;
use std::fs::File;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What of cargo's messages is read.
#[derive(Deserialize)]
struct Message {
    executable: Option<PathBuf>,
}

/// How a test program ended.
#[derive(Debug, Default)]
pub(super) struct Ran {
    /// The tests that failed.
    pub(super) failed: Vec<String>,
    /// The tests that passed.
    pub(super) passed: Vec<String>,
    /// Why it did not come to its end, if it did not.
    pub(super) broken_off: Option<&'static str>,
}

/// The variables that a build of the copy is told apart by: as in the prover's own build an overflow
/// is a panic and a machine does not check itself, so that what fails is the harness.
const PROFILE: [(&str, &str); 3] = [
    ("CARGO_PROFILE_TEST_DEBUG_ASSERTIONS", "false"),
    ("CARGO_PROFILE_TEST_OVERFLOW_CHECKS", "true"),
    ("CARGO_PROFILE_TEST_DEBUG", "0"),
];

/// The test program of a package's library; none if it does not compile.
pub(super) fn build(workspace: &Workspace, package: &str) -> Result<Option<PathBuf>, String> {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    let output = cargo
        .current_dir(&workspace.folder)
        .args(["test", "--locked", "--quiet", "--lib", "--no-run", "--message-format", "json"])
        .args(["--package", package, "--target-dir"])
        .arg(workspace.folder.join("target"))
        .envs(PROFILE)
        .output()
        .map_err(|why| format!("cargo cannot be run: {why}"))?;
    if !output.status.success() {
        return Ok(None);
    }
    let messages = String::from_utf8_lossy(&output.stdout);
    let program = messages
        .lines()
        .filter_map(|line| serde_json::from_str::<Message>(line).ok()?.executable)
        .next_back();
    program.map(Some).ok_or_else(|| format!("cargo names no tests of {package}"))
}

/// Runs the tests whose names begin with one of these, one after another.
pub(super) fn run(
    workspace: &Workspace,
    program: &PathBuf,
    beginnings: &[String],
    limit: Duration,
) -> Result<Ran, String> {
    let log = workspace.folder.join("target/tests.txt");
    let text = |why: std::io::Error| format!("{}: {why}", program.display());
    let mut child = Command::new(program)
        .current_dir(&workspace.folder)
        .args(["--test-threads", "1"])
        .args(beginnings)
        .env("PATH", search_path())
        .env("RUST_BACKTRACE", "0")
        .env("ONEPULSE_RUNS", RUNS)
        .stdin(Stdio::null())
        .stdout(File::create(&log).map_err(text)?)
        .stderr(Stdio::null())
        .spawn()
        .map_err(text)?;
    let begin = Instant::now();
    let mut hangs = false;
    let status = loop {
        if let Some(status) = child.try_wait().map_err(text)? {
            break status;
        }
        if begin.elapsed() > limit && !hangs {
            hangs = true;
            child.kill().map_err(text)?;
        }
        std::thread::sleep(Duration::from_millis(10));
    };
    let mut ran = Ran::of(&read(&log)?);
    ran.broken_off = match status.code() {
        _ if hangs => Some("hangs"),
        Some(0 | 101) => None,
        _ => Some("aborts"),
    };
    Ok(ran)
}

/// Random runs of a harness: a mutant that these do not find is the solver's.
const RUNS: &str = "300";

impl Ran {
    /// Reads what a test program prints.
    fn of(printed: &str) -> Self {
        let mut ran = Self::default();
        for line in printed.lines() {
            let Some((name, verdict)) =
                line.strip_prefix("test ").and_then(|line| line.split_once(" ... "))
            else {
                continue;
            };
            match verdict {
                "ok" => ran.passed.push(name.to_owned()),
                "FAILED" => ran.failed.push(name.to_owned()),
                _ => {}
            }
        }
        ran
    }

    /// Whether the mutant was found.
    pub(super) fn found(&self) -> bool {
        !self.failed.is_empty() || self.broken_off.is_some()
    }
}

/// The harness of a test.
pub(super) fn harness(test: &str) -> &str {
    let name = test.rsplit("::").next().unwrap_or(test);
    name.strip_prefix("__test_").unwrap_or(name)
}

#[cfg(test)]
mod tests {
    use super::{Ran, harness};

    #[test]
    fn verdicts_are_read() {
        let ran = Ran::of("running 2 tests\ntest a::__test_b ... FAILED\ntest a::c ... ok\n");
        assert_eq!((ran.failed.len(), ran.passed.len(), ran.found()), (1, 1, true));
        assert_eq!(harness(&ran.failed[0]), "b");
    }
}
