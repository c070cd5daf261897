//! What discharges a claim beside harnesses: lemmas, sweeps, tests.

use super::outcome::{Counterexample, Outcome};
use super::tools::root;
use crate::lemmas::{self, Lemma};
use crate::sweep::{Driver, Id};
use clap::ValueEnum;
use std::collections::BTreeMap;
use std::process::Command;
use std::time::{Duration, Instant};

/// Time for one question to one solver.
const LEMMA_LIMIT: Duration = Duration::from_secs(10);

/// Runs what claims name, each once however many claims name it.
#[derive(Default)]
pub(crate) struct Beside {
    done: BTreeMap<(Kind, String), Done>,
}

/// What a claim may name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    /// A file of `verify/lemmas`, every lemma of which is asked of both solvers.
    Lemmas,
    /// An exhaustive sweep.
    Sweep,
    /// A test, as PACKAGE:TEST.
    Test,
}

/// What came of it.
#[derive(Clone, Debug)]
pub(crate) struct Done {
    pub(crate) outcome: Outcome,
    pub(crate) time: Duration,
    /// What there is to tell: figures, a counterexample.
    pub(crate) told: String,
}

impl Beside {
    /// The outcome of one of them, which is run if it was not yet.
    pub(crate) fn run(&mut self, kind: Kind, name: &str) -> &Done {
        self.done.entry((kind, name.to_owned())).or_insert_with(|| {
            let start = Instant::now();
            let (outcome, told) = match kind {
                Kind::Lemmas => run_lemmas(name),
                Kind::Sweep => run_sweep(name),
                Kind::Test => (run_test(name), String::new()),
            };
            let time = start.elapsed();
            eprintln!("{:13} {:7.1} s  {kind:?} {name}", outcome.word(), time.as_secs_f64());
            Done { outcome, time, told }
        })
    }
}

/// All lemmas of a file.
fn run_lemmas(file: &str) -> (Outcome, String) {
    let folder = root().join("verify/lemmas");
    let checked = Lemma::read_all(&folder).and_then(|mut all| {
        all.retain(|lemma| lemma.file == file);
        lemmas::check(&all, LEMMA_LIMIT)
    });
    match checked {
        Err(why) => (Outcome::CouldNotRun(why), String::new()),
        Ok(lemmas) if lemmas.is_empty() => {
            (Outcome::CouldNotRun(format!("there are no lemmas in {file}.smt2")), String::new())
        }
        Ok(lemmas) => {
            let told = format!("{} lemmas", lemmas.len());
            let open: Vec<&str> = lemmas
                .iter()
                .filter(|lemma| !lemma.holds())
                .map(|lemma| lemma.name.as_str())
                .collect();
            if open.is_empty() {
                (Outcome::Proved, told)
            } else {
                (Outcome::CouldNotRun(format!("not proved: {}", open.join(", "))), told)
            }
        }
    }
}

/// A sweep with its default ranges. Of a claim that is false it finds the counterexample.
fn run_sweep(id: &str) -> (Outcome, String) {
    let swept = Id::from_str(id, true).and_then(|id| id.sweep(&Driver::default()));
    match swept {
        Err(why) => (Outcome::CouldNotRun(why), String::new()),
        Ok(swept) => {
            let found = match &swept.counterexample {
                Some(case) => format!("; over one pulse first: {}", crate::sweep::described(case)),
                None => String::new(),
            };
            let told = format!(
                "{} curves, {} cycles, {:.3} pulses at most{found}",
                swept.curves, swept.cycles, swept.worst_deviation
            );
            if !swept.is_complete {
                (Outcome::CouldNotRun("it did not come to its end".to_owned()), told)
            } else if swept.passed {
                (Outcome::Proved, told)
            } else {
                let what = swept.failures.join("; ");
                (Outcome::Fails(Counterexample { what, location: None, values: Vec::new() }), told)
            }
        }
    }
}

/// A test: it must be there and pass.
fn run_test(name: &str) -> Outcome {
    let Some((package, test)) = name.split_once(':') else {
        return Outcome::CouldNotRun(format!("the test {name} is not named as PACKAGE:TEST"));
    };
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let run = Command::new(cargo)
        .current_dir(root())
        .args(["test", "--locked", "--quiet", "--package", package, "--", "--exact", test])
        .output();
    match run {
        Err(why) => Outcome::CouldNotRun(format!("cargo test: {why}")),
        Ok(output) => {
            let said = String::from_utf8_lossy(&output.stdout).into_owned();
            if !output.status.success() {
                Outcome::Fails(Counterexample { what: said, location: None, values: Vec::new() })
            } else if passed(&said) == 0 {
                Outcome::CouldNotRun(format!("there is no test {test} in {package}"))
            } else {
                Outcome::Proved
            }
        }
    }
}

/// The sum of the numbers in "N passed".
fn passed(said: &str) -> u32 {
    said.split(" passed;").filter_map(|before| before.rsplit(' ').next()?.parse::<u32>().ok()).sum()
}
