//! Medians of interleaved runs.

use std::hint::black_box;
use std::time::Instant;

/// A contestant: its name, and one run of it.
pub struct Runner<'a> {
    /// The name in the table.
    pub name: &'static str,
    /// What a run counts, for example pulses.
    pub amount: f64,
    /// One run; its result keeps the compiler from leaving it out.
    pub run: Box<dyn Fn() -> u64 + 'a>,
    /// What is tidied up after each run, while the watch stands.
    pub tidy: Box<dyn Fn() + 'a>,
}

impl<'a> Runner<'a> {
    /// A contestant.
    pub fn new(name: &'static str, amount: f64, run: impl Fn() -> u64 + 'a) -> Self {
        Self { name, amount, run: Box::new(run), tidy: Box::new(|| ()) }
    }

    /// The contestant, with something to tidy up after each run.
    #[must_use]
    pub fn tidied(mut self, tidy: impl Fn() + 'a) -> Self {
        self.tidy = Box::new(tidy);
        self
    }
}

/// Runs all in turn, `rounds` times, and returns the median of each in amount a second.
#[must_use]
pub fn medians(runners: &[Runner], rounds: usize) -> Vec<f64> {
    let mut times = vec![Vec::new(); runners.len()];
    for _ in 0..rounds {
        for (runner, times) in runners.iter().zip(&mut times) {
            let begun = Instant::now();
            black_box((runner.run)());
            times.push(begun.elapsed().as_secs_f64());
            (runner.tidy)();
        }
    }
    let median = |(runner, mut times): (&Runner, Vec<f64>)| {
        times.sort_by(f64::total_cmp);
        runner.amount / times[times.len() / 2]
    };
    runners.iter().zip(times).map(median).collect()
}
