//! What was found by what.

use super::explained::{ByHand, Explained};
use super::mutant::Mutant;
use super::verdict::{By, Verdict};
use std::collections::BTreeMap;
use std::fmt::Write;

/// The verdicts, added up.
#[derive(Debug)]
pub(super) struct Report {
    /// How many mutants of each file came to each verdict.
    files: BTreeMap<String, BTreeMap<By, usize>>,
    /// How many each harness found: natively, by the prover, and of those made by hand.
    harnesses: BTreeMap<String, [usize; 3]>,
    /// The lines of those that survive, and why they may.
    survivors: Vec<(String, Option<String>)>,
    /// Those that a test of the machines' own crate found, and no harness natively.
    by_tests: Vec<String>,
}

impl Report {
    pub(super) fn new(
        done: &[(&Mutant, &Verdict)],
        harnesses: &BTreeMap<String, Vec<String>>,
        explained: &Explained,
    ) -> Self {
        let known = harnesses.values().flatten().map(|harness| (harness.clone(), [0; 3]));
        let mut report = Self {
            files: BTreeMap::new(),
            harnesses: known.collect(),
            survivors: Vec::new(),
            by_tests: Vec::new(),
        };
        for (mutant, verdict) in done {
            let file = report.files.entry(mutant.file.clone()).or_default();
            *file.entry(verdict.by).or_default() += 1;
            if verdict.is_survivor() {
                let why = explained.why(mutant).map(str::to_owned);
                report.survivors.push((mutant.name(), why));
            }
            let place = match verdict.by {
                By::Harness => 0,
                By::Prover => 1,
                By::Test => {
                    report.by_tests.push(mutant.name());
                    continue;
                }
                _ => continue,
            };
            for name in &verdict.found {
                if let Some(found) = report.harnesses.get_mut(name) {
                    found[place] += 1;
                }
            }
        }
        report
    }

    pub(super) fn add_by_hand(&mut self, by_hand: &ByHand) {
        self.harnesses.entry(by_hand.harness.clone()).or_default()[2] += 1;
    }

    /// How many survive without an explanation.
    pub(super) fn survivors(&self) -> usize {
        self.survivors.iter().filter(|(_, why)| why.is_none()).count()
    }

    /// The harnesses that found nothing.
    pub(super) fn idle(&self) -> Vec<&str> {
        let is_idle = |(_, found): &(&String, &[usize; 3])| **found == [0; 3];
        self.harnesses.iter().filter(is_idle).map(|(name, _)| &**name).collect()
    }

    /// For a terminal, and the greater part of the document.
    pub(super) fn text(&self, specified: usize) -> String {
        let mut text = String::from(
            "\n| file | mutants | harnesses, a few values | harnesses, CBMC | core's tests alone | \
             do not compile | survive |\n|---|---|---|---|---|---|---|\n",
        );
        let mut total = BTreeMap::<By, usize>::new();
        for (file, counts) in &self.files {
            row(&mut text, &format!("`{file}`"), counts);
            for (by, count) in counts {
                *total.entry(*by).or_default() += count;
            }
        }
        row(&mut text, "all", &total);
        let _ = writeln!(
            text,
            "\n{specified} more would be in the invariants and in what they call: those are what the \
             harnesses assume and assert.\n"
        );
        text.push_str("| harness | finds natively | by CBMC | of those made by hand |\n");
        text.push_str("|---|---|---|---|\n");
        for (harness, [natively, solved, by_hand]) in &self.harnesses {
            let _ = writeln!(text, "| `{harness}` | {natively} | {solved} | {by_hand} |");
        }
        if !self.by_tests.is_empty() {
            text.push_str("\nFound by core's own tests, and by no harness natively:\n\n");
            for mutant in &self.by_tests {
                let _ = writeln!(text, "- `{mutant}`");
            }
        }
        if !self.survivors.is_empty() {
            text.push_str("\nSurvivors:\n\n");
            for (mutant, why) in &self.survivors {
                let why = why.as_deref().unwrap_or("NOT EXPLAINED");
                let _ = writeln!(text, "- `{mutant}`  \n  {why}");
            }
        }
        text
    }

    /// For docs/mutants.md.
    pub(super) fn document(&self, specified: usize, proves: bool) -> String {
        let left_out = if proves { "" } else { "\nHere with `--natively`: CBMC was left out.\n" };
        [HEAD, left_out, &self.text(specified)].concat()
    }
}

const HEAD: &str = "\
# Do the proofs see?

Every small change of the machines' code — an operator turned round, a sign lost — should break a \
harness of `verify/proofs`.
Written by

    cargo run --release -p onepulse-verify -- mutants --write docs/mutants.md

A mutant is built in a copy of the repository and given to the harnesses on a few hundred random and \
narrow values, then to core's own tests, and what is left to CBMC. What survives even that must be \
explained in `verify/mutants.toml`. Without CBMC (`--natively`) all take about five \
minutes on two processors; a mutant that comes to CBMC takes some minutes more, up to twenty in \
`sweep.rs`; `--shard 1/4` does a part, and `--keep FILE` puts parts together. It is no part \
of the tests.
";

fn row(text: &mut String, name: &str, counts: &BTreeMap<By, usize>) {
    let count = |by: &[By]| by.iter().filter_map(|by| counts.get(by)).sum::<usize>();
    let all: usize = counts.values().sum();
    let _ = writeln!(
        text,
        "| {name} | {all} | {} | {} | {} | {} | {} |",
        count(&[By::Harness]),
        count(&[By::Prover]),
        count(&[By::Test]),
        count(&[By::Compiler]),
        count(&[By::Undecided, By::Nothing])
    );
}
