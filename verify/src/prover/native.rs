//! Harnesses as tests, and counterexamples once more.

use super::Error;
use super::outcome::{Counterexample, Outcome, Run};
use super::tools::{output, root};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::Command;
use std::time::Instant;

/// The tests of the harnesses' crate, compiled.
#[derive(Debug)]
pub(crate) struct Tests {
    program: PathBuf,
    /// The test of each harness.
    names: BTreeMap<String, String>,
}

/// What of cargo's messages is read.
#[derive(Deserialize)]
struct Message {
    executable: Option<PathBuf>,
}

impl Tests {
    /// Compiles the tests and lists them.
    pub(crate) fn build(wrong: bool) -> Result<Self, Error> {
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo
            .current_dir(root())
            .args(["test", "--locked", "--quiet", "--package", "onepulse-proofs", "--lib"])
            .args(["--no-run", "--message-format", "json"]);
        if wrong {
            cargo.args(["--features", "wrong"]);
        }
        let messages = output(&mut cargo)?;
        let program = messages
            .lines()
            .filter_map(|line| serde_json::from_str::<Message>(line).ok()?.executable)
            .next_back()
            .ok_or_else(|| Error::Tool {
                program: "cargo test".to_owned(),
                output: "it names no executable".to_owned(),
            })?;
        let list = output(Command::new(&program).args(["--list", "--format", "terse"]))?;
        let names = list
            .lines()
            .filter_map(|line| {
                let test = line.strip_suffix(": test")?;
                let name = test.rsplit("::").next()?.strip_prefix("__test_")?;
                Some((name.to_owned(), test.to_owned()))
            })
            .collect();
        Ok(Self { program, names })
    }

    /// Names of all harnesses.
    pub(crate) fn harnesses(&self) -> impl Iterator<Item = &str> {
        self.names.keys().map(String::as_str)
    }

    /// The harness on random and on all narrow values.
    pub(crate) fn check(&self, harness: &str) -> Run {
        let start = Instant::now();
        let outcome = match self.run(harness, None) {
            Ok((true, _)) => Outcome::Proved,
            Ok((false, said)) => {
                Outcome::Fails(Counterexample { what: said, location: None, values: Vec::new() })
            }
            Err(why) => Outcome::CouldNotRun(why),
        };
        Run {
            outcome,
            time: start.elapsed(),
            covers: [0, 0],
            assumes: 0,
            engine: "native".to_owned(),
        }
    }

    /// Whether the harness holds for the values of a counterexample, and what it says.
    pub(crate) fn replay(&self, harness: &str, values: &[u64]) -> Result<(bool, String), String> {
        self.run(harness, Some(values))
    }

    fn run(&self, harness: &str, values: Option<&[u64]>) -> Result<(bool, String), String> {
        let test = self.names.get(harness).ok_or_else(|| format!("no test of {harness}"))?;
        let mut command = Command::new(&self.program);
        command
            .current_dir(root().join("verify/proofs"))
            .args([test, "--exact", "--nocapture", "--quiet"])
            .env("RUST_BACKTRACE", "0");
        match values {
            Some(values) => command.env("ONEPULSE_REPLAY", joined(values)),
            None => command.env_remove("ONEPULSE_REPLAY"),
        };
        let output = command.output().map_err(|why| why.to_string())?;
        let said = [output.stdout, output.stderr].concat();
        let text = String::from_utf8_lossy(&said);
        let lines = text.lines().filter(|line| !is_of_the_runner(line, test));
        Ok((output.status.success(), lines.collect::<Vec<_>>().join("\n")))
    }
}

/// Whether a line says no more than that the test ran and with what exit status.
fn is_of_the_runner(line: &str, test: &str) -> bool {
    let line = line.trim();
    let beginnings =
        ["running ", "test result:", "note: run with", "failures:", "error: test failed"];
    line.is_empty()
        || line == "."
        || line == "F"
        || line == test
        || line.ends_with("--- FAILED")
        // Values that were given are not drawn anew.
        || line.ends_with("ONEPULSE_REPLAY=")
        || beginnings.iter().any(|beginning| line.starts_with(beginning))
}

/// The values as the environment takes them.
pub(crate) fn joined(values: &[u64]) -> String {
    values.iter().map(u64::to_string).collect::<Vec<_>>().join(",")
}
