//! The bars of the circuits, as ratios to simulators of their Verilog twins in the same run.
//!
//! Both sides start from the same command as it is loaded, load it again when it is done, and must
//! send the same pulses. Their waves are files with the same signals.
#![allow(missing_docs, clippy::unwrap_used)]

use onepulse_benches::circuit;
use onepulse_benches::stopwatch::{Runner, medians};
use onepulse_benches::twin::{Engine, Twin, modules};
use onepulse_hwmodel::Circuit;
use std::cell::RefCell;
use std::fs::{self, File};
use std::hint::black_box;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::ExitCode;

/// Where simulators are built and waves written.
const FOLDER: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/circuits");

const ROUNDS: usize = 15;
const CLOCKS: u64 = 8_000_000;
/// Long enough for the system to have found a processor for the thread that writes.
const TRACED_CLOCKS: u64 = 1_000_000;

fn main() -> ExitCode {
    // `cargo test` builds benches and runs them with --test: there is nothing to time then.
    if std::env::args().any(|argument| argument == "--test") {
        return ExitCode::SUCCESS;
    }
    match compare_all() {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn compare_all() -> Result<(), String> {
    compare(modules::dda_line().unwrap())?;
    compare(modules::dda_arc().unwrap())?;
    compare(modules::dda_centred_arc().unwrap())?;
    compare(modules::ppc_line().unwrap())?;
    compare(modules::ppc_arc().unwrap())?;
    compare(modules::brm_line().unwrap())
}

fn compare<C: Circuit<AXES> + Clone, const AXES: usize>(
    (circuit, twin): (C, Twin),
) -> Result<(), String> {
    println!("{}", twin.module);
    let peers = [(Engine::Verilator, 5.0), (Engine::Cxxrtl, 2.0)];
    contest(&twin, "onepulse", &peers, CLOCKS, |_| circuit::untraced(black_box(&circuit), CLOCKS))?;
    contest(&twin, "onepulse VCD", &[(Engine::VerilatorVcd, 3.0)], TRACED_CLOCKS, |file| {
        circuit::vcd(black_box(&circuit), TRACED_CLOCKS, file).unwrap()
    })?;
    contest(&twin, "onepulse FST", &[(Engine::VerilatorFst, 2.0)], TRACED_CLOCKS, |file| {
        circuit::fst(black_box(&circuit), TRACED_CLOCKS, file).unwrap()
    })?;
    match twin.not_shown()[..] {
        [] => {}
        ref signals => println!("  in our waves only: {}", signals.join(" ")),
    }
    Ok(())
}

/// Measures our circuit and its peers, which have to be beaten by the ratio beside them.
fn contest(
    twin: &Twin,
    name: &'static str,
    peers: &[(Engine, f64)],
    clocks: u64,
    ours: impl Fn(&Path) -> u64,
) -> Result<(), String> {
    let file = Path::new(FOLDER).join("wave");
    let mut runners = vec![Runner::new(name, clocks as f64, || ours(&file))];
    for &(engine, _) in peers {
        let simulator = RefCell::new(engine.simulator(twin, Path::new(FOLDER))?);
        let (run, file) = (move |file: &Path| simulator.borrow_mut().run(clocks, file), &file);
        runners.push(Runner::new(engine.name(), clocks as f64, move || run(file).unwrap()));
    }

    // A round to warm up, which shows whether all do the same work.
    let mut sums = Vec::new();
    let mut written = Vec::new();
    for runner in &runners {
        sums.push((runner.run)());
        written.push(describe(&file));
    }
    if sums.iter().any(|sum| *sum != sums[0]) {
        return Err(format!("{}: the pulses differ, {sums:?}", twin.module));
    }

    // Deleting a file takes its time, and is not what is measured.
    let runners: Vec<_> =
        runners.into_iter().map(|runner| runner.tidied(|| drop(fs::remove_file(&file)))).collect();
    let rates = medians(&runners, ROUNDS);
    for (at, runner) in runners.iter().enumerate() {
        let ratio = match at.checked_sub(1) {
            Some(peer) => format!("{:6.2} (bar {:.1})", rates[0] / rates[at], peers[peer].1),
            None => String::new(),
        };
        println!(
            "  {:14} {:8.2} M clocks/s {ratio:16} {}",
            runner.name,
            rates[at] / 1e6,
            written[at]
        );
    }
    Ok(())
}

/// What a wave file contains; it is deleted.
fn describe(file: &Path) -> String {
    let Ok(wave) = File::open(file) else { return String::new() };
    let bytes = wave.metadata().unwrap().len() as f64 / TRACED_CLOCKS as f64;
    // In FST the declarations are compressed, but made from the same ones.
    let lines = BufReader::new(wave).lines().map_while(Result::ok);
    let mut signals: Vec<_> = lines
        .take_while(|line| !line.contains("$enddefinitions"))
        .filter(|line| line.trim_start().starts_with("$var"))
        .map(|line| line.split_whitespace().nth(3).unwrap_or_default().to_owned())
        .collect();
    // Verilator shows a signal in two scopes, and writes it once.
    signals.sort_unstable();
    signals.dedup();
    fs::remove_file(file).unwrap();
    match signals.len() {
        0 => format!("{bytes:6.1} bytes a clock"),
        count => format!("{bytes:6.1} bytes a clock, {count} signals"),
    }
}
