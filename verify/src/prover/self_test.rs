//! The prover against harnesses that are wrong on purpose.

use super::Error;
use super::build::build;
use super::native::Tests;
use super::outcome::Outcome;
use super::{cbmc, progress};
use std::time::Duration;

/// The verdict that each harness of `verify/proofs/src/wrong.rs` must have: the word, and a part of
/// the reason.
const EXPECTED: [(&str, &str, &str); 10] = [
    ("wrong_assertion", "fails", "wrong.rs"),
    ("wrong_overflow", "fails", "wrong.rs"),
    ("wrong_index", "fails", "wrong.rs"),
    ("wrong_division", "fails", "wrong.rs"),
    ("wrong_order_of_values", "fails", "wrong.rs"),
    ("wrong_contradiction", "vacuous", "end"),
    ("wrong_cover", "vacuous", "cover"),
    ("wrong_assume_without_cover", "vacuous", "assumes"),
    ("wrong_unwind", "could not run", "unwound"),
    ("wrong_endless_loop", "could not run", "unwound"),
];

/// Whether every wrong harness is found out.
pub(crate) fn run(jobs: usize, limit: Duration) -> Result<bool, Error> {
    let program = build(true)?;
    let names = EXPECTED.map(|(name, ..)| name.to_owned());
    let runs = progress::run_all(&names, jobs, |name| cbmc::check_named(&program, name, limit));
    let tests = Tests::build(true)?;
    let mut is_right = true;
    for (name, word, part) in EXPECTED {
        let Some(run) = runs.get(name) else { continue };
        let reason = match &run.outcome {
            Outcome::Proved => String::new(),
            Outcome::Fails(counterexample) => {
                let again = tests.replay(name, &counterexample.values);
                if !matches!(again, Ok((false, _))) {
                    println!("{name}: its counterexample natively: {again:?}");
                    is_right = false;
                }
                counterexample.location.as_ref().map_or_else(String::new, ToString::to_string)
            }
            Outcome::Vacuous(why) | Outcome::CouldNotRun(why) => why.clone(),
        };
        if run.outcome.word() != word || !reason.contains(part) {
            println!("{name} should be: {word} ({part}); but is: {:?}", run.outcome);
            is_right = false;
        }
    }
    for harness in
        program.module.harnesses.iter().filter(|harness| harness.name.starts_with("wrong_"))
    {
        if !names.contains(&harness.name) {
            println!("nothing is expected of {}", harness.name);
            is_right = false;
        }
    }
    Ok(is_right)
}
