//! Harnesses as tests: the same bodies on random values, boundaries, and all narrow values.

mod source;

use source::Source;
use std::cell::RefCell;
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

/// Random runs that are wanted of a harness, and after how many tries it gives up.
const RANDOM_RUNS: u32 = 3_000;
const RANDOM_TRIES: u32 = 100_000;

/// As many random runs instead, and less of all else in proportion: for runs of many mutants.
const RUNS: &str = "ONEPULSE_RUNS";

/// Runs that enumeration may take in all. It starts at one bit and goes on for as long as a width
/// can be finished.
const NARROW_TRIES: u32 = 200_000;

/// The values of a counterexample to run a harness with, as the prover and a failed test print
/// them.
const REPLAY: &str = "ONEPULSE_REPLAY";

thread_local! {
    static SOURCE: RefCell<Source> = const { RefCell::new(Source::none()) };
}

/// What unwinds from an assumption that does not hold.
struct Rejected;

/// How a run of a harness ended.
enum Ending {
    Accepted,
    Rejected,
}

/// Runs a harness natively: on the values named by the environment if there are any, else at
/// random and then exhaustively at narrow widths.
///
/// # Panics
/// When the harness does, and when none of the values satisfies what it assumes.
pub fn check(name: &str, harness: fn()) {
    if let Ok(values) = std::env::var(REPLAY) {
        replay(name, harness, &values);
        return;
    }
    let (accepted, tries) = at_random(name, harness);
    assert!(accepted > 0, "{name}: none of {tries} random runs satisfies what is assumed");
    let (width, runs) = exhaustively(name, harness);
    println!(
        "{name}: {accepted} of {tries} random runs; every value of up to {width} bits, {runs} runs"
    );
}

/// A number of runs or tries, in proportion to the random runs that are asked for.
fn effort(usual: u32) -> u32 {
    let runs = std::env::var(RUNS).ok().and_then(|runs| runs.parse::<u32>().ok());
    let part = u64::from(usual) * u64::from(runs.unwrap_or(RANDOM_RUNS)) / u64::from(RANDOM_RUNS);
    u32::try_from(part).unwrap_or(u32::MAX).max(1)
}

fn at_random(name: &str, harness: fn()) -> (u32, u32) {
    let (runs, tries) = (effort(RANDOM_RUNS), effort(RANDOM_TRIES));
    let mut accepted = 0;
    for attempt in 0..tries {
        if accepted == runs {
            return (accepted, attempt);
        }
        let seed = name.bytes().fold(u64::from(attempt), |seed, byte| {
            seed.wrapping_mul(0x0100_0000_01b3) ^ u64::from(byte)
        });
        SOURCE.set(Source::random(seed));
        accepted += u32::from(matches!(run(name, harness), Ending::Accepted));
    }
    (accepted, tries)
}

/// The widest width that all values were run of, and in how many runs.
fn exhaustively(name: &str, harness: fn()) -> (u32, u32) {
    let mut left = effort(NARROW_TRIES);
    let mut finished = (0, 0);
    for width in 1.. {
        let mut runs = 0;
        let mut choices = Vec::new();
        loop {
            SOURCE.set(Source::enumeration(width, choices));
            run(name, harness);
            runs += 1;
            match SOURCE.take().next_choices() {
                Some(next) => choices = next,
                None => break,
            }
            left -= 1;
            if left == 0 {
                return finished;
            }
        }
        if runs == finished.1 {
            // Nothing is wider than this.
            return finished;
        }
        finished = (width, runs);
    }
    finished
}

/// One run; a panic goes on with the values that led to it.
fn run(name: &str, harness: fn()) -> Ending {
    match catch_unwind(AssertUnwindSafe(harness)) {
        Ok(()) => Ending::Accepted,
        Err(panic) if panic.is::<Rejected>() => Ending::Rejected,
        Err(panic) => {
            let mut values = String::new();
            for value in SOURCE.take().drawn() {
                let comma = if values.is_empty() { "" } else { "," };
                let _ = write!(values, "{comma}{value}");
            }
            eprintln!("{name} fails; again with {REPLAY}={values}");
            resume_unwind(panic)
        }
    }
}

fn replay(name: &str, harness: fn(), values: &str) {
    let parsed: Result<Vec<u64>, _> =
        values.split(',').filter(|value| !value.is_empty()).map(str::parse).collect();
    let Ok(values) = parsed else { panic!("{REPLAY}={values}: not numbers with commas") };
    SOURCE.set(Source::replay(values));
    match run(name, harness) {
        Ending::Accepted => println!("{name} holds for these values"),
        Ending::Rejected => println!("{name}: these values do not satisfy what is assumed"),
    }
}

pub(crate) fn any(bits: u32, is_signed: bool) -> u64 {
    SOURCE.with_borrow_mut(|source| source.draw(bits, is_signed))
}

pub(crate) fn assume(condition: bool) {
    if !condition {
        resume_unwind(Box::new(Rejected));
    }
}

/// Covers are for the provers: random values may never come where a solver finds a way.
pub(crate) const fn cover(_condition: bool, _file: &str, _line: u32) {}

/// A number that a harness derives from its values natively, where a solver is to choose it freely:
/// it is drawn only when a counterexample is run again.
#[must_use]
pub fn given(value: u64) -> u64 {
    SOURCE.with_borrow_mut(|source| source.given(value))
}

/// A number that a harness makes of a drawn one natively, where a solver is to choose it freely: a
/// counterexample's is taken as it is.
#[must_use]
pub fn chosen(make: impl FnOnce(u64) -> u64) -> u64 {
    SOURCE.with_borrow_mut(|source| {
        let drawn = source.draw(u64::BITS, false);
        if source.is_replay() { drawn } else { make(drawn) }
    })
}
