//! What discharges a claim beside harnesses: lemmas, sweeps, tests.

use super::outcome::{Counterexample, Outcome};
use super::tools::root;
use std::process::Command;

/// A lemma of `verify/lemmas`, asked of both solvers.
pub(crate) fn run_lemma(name: &str) -> Outcome {
    Outcome::CouldNotRun(format!("lemma {name}: nothing runs lemmas yet"))
}

/// An exhaustive sweep. Of a claim that is false it finds the counterexample.
pub(crate) fn run_sweep(id: &str) -> Outcome {
    Outcome::CouldNotRun(format!("sweep {id}: nothing runs sweeps yet"))
}

/// A test, named as PACKAGE:TEST: it must be there and pass.
pub(crate) fn run_test(name: &str) -> Outcome {
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
