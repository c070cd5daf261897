//! Verdicts.

use super::data::Location;
use std::time::Duration;

/// What became of a harness, a lemma, a sweep or a test.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// It holds, and says something.
    Proved,
    /// There is a counterexample.
    Fails(Counterexample),
    /// It holds of nothing, or may: why.
    Vacuous(String),
    /// There is no verdict: why.
    CouldNotRun(String),
}

/// A run that breaks a harness.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Counterexample {
    /// What happens.
    pub(crate) what: String,
    /// Where, if it is a panic.
    pub(crate) location: Option<Location>,
    /// The values in the order in which the harness drew them.
    pub(crate) values: Vec<u64>,
}

impl Outcome {
    /// One word, for tables.
    pub(crate) const fn word(&self) -> &'static str {
        match self {
            Self::Proved => "proved",
            Self::Fails(_) => "fails",
            Self::Vacuous(_) => "vacuous",
            Self::CouldNotRun(_) => "could not run",
        }
    }

    /// Whether it holds.
    pub(crate) const fn holds(&self) -> bool {
        matches!(self, Self::Proved)
    }
}

/// An outcome and what it took.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    pub(crate) outcome: Outcome,
    pub(crate) time: Duration,
    /// Covers met, of how many.
    pub(crate) covers: [usize; 2],
    pub(crate) assumes: usize,
    pub(crate) engine: String,
}
