//! What does not hold, for a reader.

use super::native::{Tests, joined};
use super::outcome::{Counterexample, Outcome, Run};
use super::tools::root;
use std::collections::BTreeMap;
use std::fs;

/// Explains all harnesses that do not hold; counterexamples are run once more, natively.
pub(crate) fn explain(runs: &BTreeMap<String, Run>) {
    let mut tests = None;
    for (name, run) in runs {
        match &run.outcome {
            Outcome::Proved => {}
            Outcome::Vacuous(why) => println!("\n{name} is vacuous: {why}"),
            Outcome::CouldNotRun(why) => println!("\n{name} could not run: {why}"),
            Outcome::Fails(counterexample) => {
                println!("\n{name} fails: {}", headline(counterexample));
                if run.engine == "native" {
                    continue;
                }
                println!("  with the values {}", joined(&counterexample.values));
                let tests = tests.get_or_insert_with(|| Tests::build(false));
                match tests {
                    Ok(tests) => {
                        println!("  natively, {}", replay_command(name, &counterexample.values));
                        let said = match tests.replay(name, &counterexample.values) {
                            Ok((_, said)) | Err(said) => said,
                        };
                        for line in said.lines() {
                            println!("  | {line}");
                        }
                    }
                    Err(why) => println!("  which cannot be run natively: {why}"),
                }
            }
        }
    }
}

/// What happens where, and the source there.
fn headline(counterexample: &Counterexample) -> String {
    let Some(location) = &counterexample.location else { return counterexample.what.clone() };
    let line = fs::read_to_string(root().join(&location.file)).ok().and_then(|text| {
        let index = usize::try_from(location.line).ok()?.checked_sub(1)?;
        Some(format!("\n  | {}", text.lines().nth(index)?.trim()))
    });
    format!("{} at {location}{}", counterexample.what, line.unwrap_or_default())
}

fn replay_command(name: &str, values: &[u64]) -> String {
    let values = joined(values);
    format!("ONEPULSE_REPLAY={values} cargo test -p onepulse-proofs __test_{name} -- --nocapture")
}
