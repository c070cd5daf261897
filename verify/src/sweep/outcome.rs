//! What a sweep answers.

use super::curve::Case;
use super::driver::Findings;
use super::table::Table;
use super::tally::Tally;
use std::fmt;

/// The result of a sweep.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The claim.
    pub id: &'static str,
    /// The claim in words, with the domain that was swept.
    pub statement: String,
    /// Whether every item was done: not so for one shard of several.
    pub is_complete: bool,
    /// Whether the claim held on all that was done.
    pub passed: bool,
    /// What did not hold, each with its smallest counterexample.
    pub failures: Vec<String>,
    /// Curves drawn with the circuits that the claim is about.
    pub curves: u64,
    /// Their cycles.
    pub cycles: u64,
    /// The largest deviation of those circuits, in pulses.
    pub worst_deviation: f64,
    /// Where it was.
    pub worst: Option<Case>,
    /// The smallest counterexample to "no more than one pulse", if there is one.
    pub counterexample: Option<Case>,
    /// All figures.
    pub tables: Vec<Table>,
    /// What the figures say.
    pub remarks: Vec<String>,
}

impl Outcome {
    /// The figures of the circuits that the claim is about, nothing judged yet.
    pub(crate) fn new(
        id: &'static str,
        statement: String,
        findings: &Findings,
        about: &Tally,
    ) -> Self {
        Self {
            id,
            statement,
            is_complete: findings.is_complete(),
            passed: true,
            failures: Vec::new(),
            curves: about.curves,
            cycles: about.cycles,
            worst_deviation: about.deviation(),
            worst: about.worst,
            counterexample: about.first_over,
            tables: Vec::new(),
            remarks: Vec::new(),
        }
    }

    /// Demands that a part of the claim holds.
    pub(crate) fn demand(&mut self, holds: bool, otherwise: impl FnOnce() -> String) {
        if !holds {
            self.passed = false;
            self.failures.push(otherwise());
        }
    }

    /// Demands that no curve was at fault.
    pub(crate) fn demand_no_fault(&mut self, circuit: &str, tally: &Tally) {
        self.demand(tally.faults == 0, || {
            let first = tally.first_fault.as_ref().map_or(String::new(), ToString::to_string);
            format!("{circuit}: {} curves are at fault, the first: {first}", tally.faults)
        });
    }

    /// Demands that no curve was left by more than one pulse.
    pub(crate) fn demand_one_pulse(&mut self, circuit: &str, tally: &Tally) {
        self.demand(tally.over == 0, || {
            let first = tally.first_over.as_ref().map_or(String::new(), described);
            format!("{circuit}: {} curves leave the pulse, the first: {first}", tally.over)
        });
    }
}

/// A point in words, with its deviation.
pub(crate) fn described(case: &Case) -> String {
    format!("{case}, deviation {:.3}", case.deviation())
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "## {}\n\n{}", self.id, self.statement)?;
        for table in &self.tables {
            write!(f, "\n{table}")?;
        }
        for remark in &self.remarks {
            writeln!(f, "\n{remark}")?;
        }
        let verdict = match (self.passed, self.is_complete) {
            (true, true) => "It holds.",
            (true, false) => "It holds on this shard.",
            (false, _) => "It does not hold:",
        };
        writeln!(f, "\n{verdict}")?;
        for failure in &self.failures {
            writeln!(f, "\n* {failure}")?;
        }
        Ok(())
    }
}
