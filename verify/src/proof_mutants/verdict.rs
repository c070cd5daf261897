//! What became of a mutant, and the file that keeps it for a later run.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

/// What found a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum By {
    /// It is no program.
    Compiler,
    /// A harness, on a few values.
    Harness,
    /// A test of the machines' own crate, and no harness.
    Test,
    /// A harness, by the prover.
    Prover,
    /// Nothing, and the prover did not decide every harness.
    Undecided,
    /// Nothing.
    Nothing,
}

/// A mutant and what became of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Verdict {
    /// The mutant's name.
    pub(super) mutant: String,
    pub(super) by: By,
    /// The harnesses or tests that failed.
    pub(super) found: Vec<String>,
}

impl Verdict {
    pub(super) const fn is_survivor(&self) -> bool {
        matches!(self.by, By::Undecided | By::Nothing)
    }
}

/// The verdicts of earlier runs, by mutant; none if there is no file yet.
pub(super) fn read(path: &Path) -> Result<BTreeMap<String, Verdict>, String> {
    let Ok(text) = std::fs::read_to_string(path) else { return Ok(BTreeMap::new()) };
    let verdict = |line: &str| {
        let verdict: Verdict =
            serde_json::from_str(line).map_err(|why| format!("{}: {why}", path.display()))?;
        Ok((verdict.mutant.clone(), verdict))
    };
    text.lines().map(verdict).collect()
}

/// Adds a verdict at the end of the file.
pub(super) fn append(path: &Path, verdict: &Verdict) -> Result<(), String> {
    let text = |why: std::io::Error| format!("{}: {why}", path.display());
    let line = serde_json::to_string(verdict).map_err(|why| why.to_string())?;
    let mut file = OpenOptions::new().create(true).append(true).open(path).map_err(text)?;
    writeln!(file, "{line}").map_err(text)
}
