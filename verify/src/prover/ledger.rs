//! The ledger: what is claimed, by what it is discharged, and what came of it.

use super::beside::{Beside, Kind};
use super::claims::Claim;
use super::outcome::{Outcome, Run};
use super::tools::root;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// What became of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    /// By harnesses, lemmas or sweeps, all of which hold.
    Proved,
    /// By sweeps alone, which come to every curve of their domain.
    Swept,
    /// By tests alone, all of which pass.
    Tested,
    /// False, and the counterexample was found.
    False,
    /// Anything else.
    Open,
}

/// A claim and the outcomes of all that discharges it.
pub(crate) struct Discharged<'c> {
    pub(crate) claim: &'c Claim,
    pub(crate) status: Status,
    seconds: f64,
    engines: Vec<&'static str>,
    /// Why it is open.
    why: String,
    /// What its sweeps found.
    found: Vec<String>,
}

impl<'c> Discharged<'c> {
    /// Adds up the harnesses that ran already, and runs what else there is.
    pub(crate) fn new(claim: &'c Claim, runs: &BTreeMap<String, Run>, beside: &mut Beside) -> Self {
        let mut seconds = 0.0;
        let mut engines = Vec::new();
        let mut open = Vec::new();
        for (name, run) in runs.iter().filter(|(name, _)| claim.has(name)) {
            seconds += run.time.as_secs_f64();
            let engine = if run.engine == "native" { "native" } else { "CBMC" };
            if !engines.contains(&engine) {
                engines.push(engine);
            }
            if !run.outcome.holds() {
                open.push(format!("{name} {}", run.outcome.word()));
            }
        }
        let mut found = Vec::new();
        for (names, engine, kind) in [
            (&claim.lemmas, "z3, cvc5", Kind::Lemmas),
            (&claim.sweeps, "sweep", Kind::Sweep),
            (&claim.tests, "tests", Kind::Test),
        ] {
            if !names.is_empty() {
                engines.push(engine);
            }
            for name in names {
                let done = beside.run(kind, name);
                match &done.outcome {
                    Outcome::Proved => {}
                    Outcome::CouldNotRun(why) | Outcome::Vacuous(why) => {
                        open.push(format!("{name}: {why}"));
                    }
                    Outcome::Fails(counterexample) => {
                        open.push(format!("{name} fails: {}", counterexample.what));
                    }
                }
                if kind == Kind::Sweep {
                    found.push(format!("sweep {name}: {}", done.told));
                }
                seconds += done.time.as_secs_f64();
            }
        }
        let status = if engines.is_empty() || !open.is_empty() {
            Status::Open
        } else if claim.false_with.is_some() {
            Status::False
        } else if engines == ["sweep"] {
            Status::Swept
        } else if engines == ["tests"] {
            Status::Tested
        } else {
            Status::Proved
        };
        let why = if engines.is_empty() { "nothing was run".to_owned() } else { open.join("; ") };
        Self { claim, status, seconds, engines, why, found }
    }

    /// One line for the reader at the terminal.
    pub(crate) fn tell(&self) {
        let Claim { id, machine, statement, .. } = self.claim;
        println!("{id:4} {machine:16} {:9} {statement}", self.word());
        if self.status == Status::Open {
            println!("     {}", self.why);
        }
    }

    /// Natively nothing is proved: some values were tried.
    fn word(&self) -> &'static str {
        match self.status {
            Status::Proved if self.engines.contains(&"native") => "tried",
            Status::Proved => "proved",
            Status::Swept => "swept",
            Status::Tested => "tested",
            Status::False => "false",
            Status::Open => "unproved",
        }
    }
}

/// The ledger's text, for `docs/theorems.md`.
pub(crate) fn text(
    claims: &[Discharged<'_>],
    runs: &BTreeMap<String, Run>,
    versions: &[(&str, String)],
) -> String {
    let mut text = String::from(HEAD);
    for claim in claims {
        let Claim { id, machine, statement, domain, notes, false_with, .. } = claim.claim;
        let mut status = claim.word().to_owned();
        if let Some(counterexample) = false_with {
            let _ = write!(status, ": {counterexample}");
        }
        if claim.status == Status::Open {
            let _ = write!(status, ": {}", claim.why);
        }
        if !claim.found.is_empty() {
            let _ = write!(status, " ({})", claim.found.join("; "));
        }
        let more = if notes.is_empty() { String::new() } else { format!(" *{}*", cell(notes)) };
        let _ = writeln!(
            text,
            "| {id} | [{machine}](../core/src/{machine}.rs) | {}{more} | {} | {} | {} | {:.1} | {} |",
            cell(statement),
            cell(domain),
            claim.engines.join(", "),
            by(claim.claim, runs),
            claim.seconds,
            cell(&status),
        );
    }
    text.push_str(HARNESSES);
    for (name, run) in runs {
        let [met, covers] = run.covers;
        let _ = writeln!(
            text,
            "| {name} | {} | {:.1} | {met} of {covers} | {} | {} |",
            run.engine,
            run.time.as_secs_f64(),
            run.assumes,
            run.outcome.word(),
        );
    }
    text.push_str("\n## Tools\n\n");
    for (name, version) in versions {
        let _ = writeln!(text, "* {name} {version}");
    }
    text
}

const HEAD: &str = "# Theorems

What is claimed of the interpolators, and by what. Written by

    cargo run --release -p onepulse-verify -- prove --write docs/theorems.md

A claim is *proved* when all its harnesses, lemmas and sweeps hold and none of them is vacuous: every cover is met, and
what assumes something covers something. *Swept* stands on every single curve of its domain, *tested* on tests alone. *False* claims are shown with the counterexample that
their sweep finds. How harnesses are run is told in [verify/proofs](../verify/proofs/README.md).

| id | machine | statement | domain | engines | by | s | status |
|---|---|---|---|---|---|---|---|
";

const HARNESSES: &str = "
## Harnesses

| harness | engine | s | covers met | assumes | status |
|---|---|---|---|---|---|
";

/// Links to what discharges a claim.
fn by(claim: &Claim, runs: &BTreeMap<String, Run>) -> String {
    let harnesses = runs.keys().filter(|name| claim.has(name)).map(|name| {
        let file = harness_file(name).unwrap_or_default();
        format!("[{name}](../verify/proofs/src/{file})")
    });
    let lemmas = claim.lemmas.iter().map(|name| format!("[{name}](../verify/lemmas/{name}.smt2)"));
    let sweeps = claim.sweeps.iter().map(|id| format!("[sweep {id}](../verify/src/sweep)"));
    let tests = claim.tests.iter().map(|test| format!("test {test}"));
    harnesses.chain(lemmas).chain(sweeps).chain(tests).collect::<Vec<_>>().join(", ")
}

/// The file below `verify/proofs/src` that a harness is in.
fn harness_file(name: &str) -> Option<String> {
    let folder = root().join("verify/proofs/src");
    let definition = format!("fn {name}()");
    let in_folder = |inner: &Path| {
        fs::read_dir(inner)
            .ok()?
            .flatten()
            .map(|entry| entry.path())
            .find(|path| fs::read_to_string(path).is_ok_and(|text| text.contains(&definition)))
    };
    let path = in_folder(&folder).or_else(|| in_folder(&folder.join("hardware")))?;
    Some(path.strip_prefix(&folder).ok()?.display().to_string())
}

/// Text in a table's cell.
fn cell(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ").replace('|', "\\|")
}
