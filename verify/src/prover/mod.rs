//! The prover: holds the claims of `verify/claims.toml` to their harnesses, lemmas, sweeps and tests.
//!
//! A harness of `onepulse-proofs` is compiled to WebAssembly (`build`), read (`module`), put into C
//! together with the glue (`source`), and decided by CBMC (`cbmc`, `verdict`). Whatever is
//! not clearly a proof is not one.

mod beside;
mod build;
mod cbmc;
mod claims;
mod data;
mod error;
mod ledger;
mod machines;
mod module;
mod native;
mod outcome;
mod progress;
mod report;
mod self_test;
mod source;
pub(crate) mod tools;
mod verdict;

pub use error::Error;

use claims::{Claim, Claims};
use clap::{Args, ValueEnum};
use ledger::{Discharged, Status};
use outcome::Run;
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::time::Duration;

/// What to prove.
#[derive(Debug, Args)]
pub struct Options {
    /// Only the claims of this id (may be given more than once)
    #[arg(long, value_name = "ID")]
    only: Vec<String>,
    /// Only this harness (may be given more than once), whatever it is for
    #[arg(long, value_name = "NAME", conflicts_with = "only")]
    harness: Vec<String>,
    /// What runs the harnesses
    #[arg(long, value_enum, default_value_t = Engine::Cbmc)]
    engine: Engine,
    /// Harnesses at a time [default: as many as there are processors]
    #[arg(long, value_name = "N")]
    jobs: Option<usize>,
    /// Time for one harness
    #[arg(long, value_name = "SECONDS", default_value_t = 300)]
    timeout: u64,
    /// Writes the ledger of all claims to this file, usually docs/theorems.md
    #[arg(long, value_name = "FILE", conflicts_with_all = ["only", "harness"])]
    write: Option<PathBuf>,
    /// Instead, demands the right verdict on harnesses that are wrong on purpose
    #[arg(long, conflicts_with_all = ["only", "harness", "write"])]
    self_test: bool,
}

/// What runs harnesses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Engine {
    /// CBMC: all values
    Cbmc,
    /// Tests: random, boundary and narrow values
    Native,
}

impl Options {
    fn jobs(&self) -> usize {
        self.jobs.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from))
    }

    const fn limit(&self) -> Duration {
        Duration::from_secs(self.timeout)
    }
}

/// Proves what is asked for.
///
/// # Errors
/// If a claim asked for does not hold, holds of nothing, or was not decided.
pub fn run(options: &Options) -> Result<(), String> {
    let done = if options.self_test {
        self_test::run(options.jobs(), options.limit())
    } else if options.harness.is_empty() {
        prove_claims(options)
    } else {
        prove_harnesses(options)
    };
    match done {
        Ok(true) => Ok(()),
        Ok(false) => Err("not everything holds".to_owned()),
        Err(why) => Err(why.to_string()),
    }
}

/// The harnesses by one engine.
enum Prover {
    Cbmc(Box<build::Program>),
    Native(native::Tests),
}

impl Prover {
    fn new(engine: Engine) -> Result<Self, Error> {
        Ok(match engine {
            Engine::Cbmc => Self::Cbmc(Box::new(build::build(false)?)),
            Engine::Native => Self::Native(native::Tests::build(false)?),
        })
    }

    fn harnesses(&self) -> Vec<String> {
        match self {
            Self::Cbmc(program) => {
                program.module.harnesses.iter().map(|harness| harness.name.clone()).collect()
            }
            Self::Native(tests) => tests.harnesses().map(str::to_owned).collect(),
        }
    }

    fn run(&self, names: &[String], options: &Options) -> BTreeMap<String, Run> {
        progress::run_all(names, options.jobs(), |name| match self {
            Self::Native(tests) => tests.check(name),
            Self::Cbmc(program) => cbmc::check_named(program, name, options.limit()),
        })
    }
}

fn prove_harnesses(options: &Options) -> Result<bool, Error> {
    let prover = Prover::new(options.engine)?;
    let known = prover.harnesses();
    if let Some(unknown) = options.harness.iter().find(|name| !known.contains(name)) {
        return Err(Error::Options(format!("there is no harness {unknown}")));
    }
    let runs = prover.run(&options.harness, options);
    report::explain(&runs);
    Ok(runs.values().all(|run| run.outcome.holds()))
}

fn prove_claims(options: &Options) -> Result<bool, Error> {
    let path = tools::root().join("verify/claims.toml");
    let claims = Claims::read(&fs::read_to_string(&path).map_err(Error::file(&path))?)?;
    let is_asked = |claim: &&Claim| options.only.is_empty() || options.only.contains(&claim.id);
    let asked: Vec<&Claim> = claims.claims.iter().filter(is_asked).collect();
    if let Some(id) = options.only.iter().find(|id| !asked.iter().any(|claim| claim.id == **id)) {
        return Err(Error::Options(format!("there is no claim {id}")));
    }
    let prover = Prover::new(options.engine)?;
    let harnesses = prover.harnesses();
    if options.only.is_empty() {
        let (files, machines) = machines::machines(&tools::root().join("core/src"))?;
        claims.check(&harnesses, &files, &machines)?;
    }
    let wanted: Vec<String> = harnesses
        .into_iter()
        .filter(|harness| asked.iter().any(|claim| claim.has(harness)))
        .collect();
    let runs = prover.run(&wanted, options);
    report::explain(&runs);

    let mut beside = beside::Beside::default();
    let discharged: Vec<Discharged<'_>> =
        asked.iter().map(|claim| Discharged::new(claim, &runs, &mut beside)).collect();
    println!();
    for claim in &discharged {
        claim.tell();
    }
    if let (Some(file), Engine::Cbmc) = (&options.write, options.engine) {
        let text = ledger::text(&discharged, &runs, &tools::versions()?);
        fs::write(file, text).map_err(Error::file(file))?;
    }
    Ok(discharged.iter().all(|claim| claim.status != Status::Open))
}
