//! One harness by CBMC.

use super::build::Program;
use super::data::STACK_BYTES;
use super::module::Harness;
use super::outcome::{Counterexample, Outcome, Run};
use super::source;
use super::tools::{find, search_path};
use super::verdict::{Trace, Verdict, trace, verdict};
use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// How often loops are unwound where a harness does not say. Those that run a constant number of
/// times stop by themselves before.
const UNWIND: u32 = 17;

/// Checks all properties of a harness at once; if one fails, asks for its counterexample.
pub(crate) fn check(program: &Program, harness: &Harness, limit: Duration) -> Run {
    let start = Instant::now();
    let (outcome, met) = match solve(program, harness, limit) {
        Ok(done) => done,
        Err(why) => (Outcome::CouldNotRun(why), 0),
    };
    Run {
        outcome,
        time: start.elapsed(),
        covers: [met, harness.covers.len()],
        assumes: harness.assumes,
        engine: format!("CBMC, {}", solver(harness)),
    }
}

/// The same by name.
pub(crate) fn check_named(program: &Program, name: &str, limit: Duration) -> Run {
    match program.module.harnesses.iter().find(|harness| harness.name == name) {
        Some(harness) => check(program, harness, limit),
        None => Run {
            outcome: Outcome::CouldNotRun(format!("there is no harness {name}")),
            time: Duration::ZERO,
            covers: [0, 0],
            assumes: 0,
            engine: "CBMC".to_owned(),
        },
    }
}

fn solver(harness: &Harness) -> &str {
    harness.solver.as_deref().unwrap_or("cadical")
}

fn solve(
    program: &Program,
    harness: &Harness,
    limit: Duration,
) -> Result<(Outcome, usize), String> {
    let output = cbmc(program, harness, limit, &[])?;
    let (verdict, met) = verdict(&program.module, harness, &output);
    let outcome = match verdict {
        Verdict::Proved => Outcome::Proved,
        Verdict::Vacuous(why) => Outcome::Vacuous(why),
        Verdict::Unclear(why) => Outcome::CouldNotRun(why),
        Verdict::Fails { property, text } => {
            let output = cbmc(program, harness, limit, &["--trace", "--property", &property])?;
            Outcome::Fails(counterexample(program, text, trace(&output)?))
        }
    };
    Ok((outcome, met))
}

fn counterexample(program: &Program, text: String, trace: Trace) -> Counterexample {
    let location = trace.location.and_then(|address| program.module.data.location(address));
    Counterexample { what: text, location, values: trace.values }
}

/// What CBMC prints. Its verdict is in there; its exit status says the same but not more.
fn cbmc(
    program: &Program,
    harness: &Harness,
    limit: Duration,
    more: &[&str],
) -> Result<String, String> {
    let tool = |name| find(name).map_err(|why| why.to_string());
    let unwind = harness.unwind.unwrap_or(UNWIND).to_string();
    let bound = |name: &String| format!("{name}:{}", STACK_BYTES + 1);
    let memory_loops = program.memory_loops.iter().map(bound).collect::<Vec<_>>().join(",");
    let mut command = Command::new(tool("cbmc")?);
    command
        .arg(&program.goto)
        .args(["--function", &source::entry(&harness.name), "--json-ui"])
        // Rust's own checks are in the code; those of C would only find fault with wasm2c.
        .args(["--no-standard-checks", "--unwinding-assertions"])
        // `loop {}` is an endless loop and not a promise that it is never reached.
        .arg("--no-self-loops-to-assumptions")
        .args(["--unwind", &unwind])
        // Each byte of the stack is a variable.
        .args(["--max-field-sensitivity-array-size", &STACK_BYTES.to_string()])
        .args(["--unwindset", &memory_loops])
        .args(more)
        .env("PATH", search_path());
    if more.is_empty() {
        // What a property does not depend on is left out. A trace wants all of it.
        command.arg("--slice-formula");
    }
    match solver(harness) {
        "minisat" => {}
        "cadical" => {
            let script = limited_cadical(&program.folder, &tool("cadical")?, limit)
                .map_err(|why| format!("no script for cadical: {why}"))?;
            command.arg("--external-sat-solver").arg(script);
        }
        smt @ ("z3" | "cvc5") => {
            command.arg(format!("--{smt}"));
        }
        other => return Err(format!("the solver {other} is not one of those here")),
    }
    let name = if more.is_empty() { "json" } else { "trace.json" };
    let path = program.folder.join(format!("{}.{name}", harness.name));
    run(&mut command, &path, limit)
}

/// CBMC's solver would outlive it when the time is up, so that it has its own limit.
fn limited_cadical(
    folder: &Path,
    cadical: &Path,
    limit: Duration,
) -> std::io::Result<std::path::PathBuf> {
    use std::os::unix::fs::PermissionsExt;
    let script = folder.join("cadical");
    let seconds = limit.as_secs().max(1);
    // What takes time is the last question, after all covers are met: that nothing else can be.
    let text = format!("#!/bin/sh\nexec '{}' --unsat -t {seconds} \"$@\"\n", cadical.display());
    if fs::read_to_string(&script).ok().as_ref() != Some(&text) {
        // Another harness may be starting it at this moment: beside, then renamed.
        let beside = folder.join(format!("cadical-{:?}", std::thread::current().id()));
        fs::write(&beside, &text)?;
        fs::set_permissions(&beside, fs::Permissions::from_mode(0o755))?;
        fs::rename(&beside, &script)?;
    }
    Ok(script)
}

/// Runs with the output in a file, and ends it when the time is up.
fn run(command: &mut Command, path: &Path, limit: Duration) -> Result<String, String> {
    let said = |why: std::io::Error| format!("CBMC cannot be run: {why}");
    let file = File::create(path).map_err(said)?;
    let mut child =
        command.stdin(Stdio::null()).stdout(file).stderr(Stdio::null()).spawn().map_err(said)?;
    let start = Instant::now();
    let mut pause = Duration::from_millis(5);
    while child.try_wait().map_err(said)?.is_none() {
        if start.elapsed() > limit {
            child.kill().map_err(said)?;
            child.wait().map_err(said)?;
            return Err(format!("not done after {} s", limit.as_secs()));
        }
        std::thread::sleep(pause);
        pause = (pause * 2).min(Duration::from_millis(100));
    }
    fs::read_to_string(path).map_err(said)
}
