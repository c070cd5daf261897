//! Harnesses in parallel, and how far they are.

use super::outcome::{Outcome, Run};
use indicatif::{ProgressBar, ProgressStyle};
use std::collections::BTreeMap;
use std::io::IsTerminal;
use std::sync::Mutex;

/// Runs all, some at a time: a bar on standard error when it is a terminal, else a line each.
pub(crate) fn run_all(
    names: &[String],
    jobs: usize,
    run: impl Fn(&str) -> Run + Sync,
) -> BTreeMap<String, Run> {
    let bar = std::io::stderr().is_terminal().then(|| bar(names.len()));
    let next = Mutex::new(names.iter());
    let runs = Mutex::new(BTreeMap::new());
    std::thread::scope(|scope| {
        for _ in 0..jobs.max(1) {
            scope.spawn(|| {
                loop {
                    let name = next.lock().ok().and_then(|mut names| names.next());
                    let Some(name) = name else { return };
                    let done = run(name);
                    tell(bar.as_ref(), name, &done);
                    if let Ok(mut runs) = runs.lock() {
                        runs.insert(name.clone(), done);
                    }
                }
            });
        }
    });
    if let Some(bar) = bar {
        bar.finish_and_clear();
    }
    runs.into_inner().unwrap_or_default()
}

fn bar(length: usize) -> ProgressBar {
    let bar = ProgressBar::new(length as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(std::time::Duration::from_millis(200));
    bar
}

fn tell(bar: Option<&ProgressBar>, name: &str, run: &Run) {
    let seconds = run.time.as_secs_f64();
    let line = format!("{:13} {seconds:7.1} s  {name}", run.outcome.word());
    match bar {
        // What holds is only counted, what does not stays to be read.
        Some(bar) => {
            if run.outcome != Outcome::Proved {
                bar.println(line);
            }
            bar.set_message(name.to_owned());
            bar.inc(1);
        }
        None => eprintln!("{line}"),
    }
}
