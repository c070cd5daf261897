//! Proof that the proofs see: every small change of the machines' code must break a harness.

mod explained;
mod functions;
mod judge;
mod mutant;
mod native;
mod report;
mod solved;
mod tokens;
mod verdict;
mod workspace;

use crate::prover::tools::root;
use clap::Args;
use explained::Explained;
use judge::{FILES, Judge};
use mutant::Mutant;
use report::Report;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Mutex;
use verdict::{By, Verdict, append};
use workspace::{Workspace, read, write};

/// Which mutants, and what is done with them.
#[derive(Debug, Args)]
pub struct Options {
    /// Only the mutants of files whose name has this in it (may be given more than once)
    #[arg(long, value_name = "PART")]
    file: Vec<String>,
    /// Every n-th mutant, beginning with the i-th: 1/4, 2/4, 3/4, 4/4 are all
    #[arg(long, value_name = "I/N", value_parser = shard, default_value = "1/1")]
    shard: (usize, usize),
    /// Mutants at a time
    #[arg(long, value_name = "N", default_value_t = 1)]
    jobs: usize,
    /// Time of the prover for one harness
    #[arg(long, value_name = "SECONDS", default_value_t = 120)]
    timeout: u64,
    /// Keeps every verdict in this file, and takes those that are there already as they are: for
    /// shards, and to go on with a run that was broken off
    #[arg(long, value_name = "FILE")]
    keep: Option<PathBuf>,
    /// Only lists the mutants
    #[arg(long)]
    list: bool,
    /// Leaves the prover out: what it alone would find survives
    #[arg(long)]
    natively: bool,
    /// Writes the tables to this file, usually docs/mutants.md
    #[arg(long, value_name = "FILE")]
    write: Option<PathBuf>,
}

fn shard(text: &str) -> Result<(usize, usize), String> {
    let parsed = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    match parsed {
        Some((i, n)) if 1 <= i && i <= n => Ok((i, n)),
        _ => Err("not like 1/4".to_owned()),
    }
}

/// Judges the mutants that are asked for.
///
/// # Errors
/// If a mutant survives that is not explained, a harness finds none, or something cannot be run.
pub fn run(options: &Options) -> Result<(), String> {
    let (mutants, specified) = all_mutants()?;
    let is_asked = |name: &str| {
        options.file.is_empty() || options.file.iter().any(|part| name.contains(part.as_str()))
    };
    let asked: Vec<&Mutant> = mutants.iter().filter(|mutant| is_asked(&mutant.file)).collect();
    if options.list {
        for mutant in &asked {
            println!("{} ({})", mutant.name(), mutant.function);
        }
        println!("{} mutants; {specified} more in the specification", asked.len());
        return Ok(());
    }
    let explained = Explained::read(&read(&root().join("verify/mutants.toml"))?)?;
    let judges = judges(options)?;
    let mut harnesses = BTreeMap::new();
    for (file, _) in FILES.into_iter().filter(|(file, _)| is_asked(file)) {
        let judge = judges.first().ok_or("there is no job to be done at a time")?;
        harnesses.insert(file.to_owned(), judge.harnesses(file)?);
    }

    let mut verdicts = options.keep.as_deref().map(verdict::read).transpose()?.unwrap_or_default();
    let (first, every) = options.shard;
    let jobs: Vec<&Mutant> = asked
        .iter()
        .skip(first - 1)
        .step_by(every)
        .filter(|mutant| !is_decided(verdicts.get(&mutant.name()), options))
        .copied()
        .collect();
    verdicts.extend(judge_all(&judges, &jobs, &harnesses, options)?);
    let done: Vec<(&Mutant, &Verdict)> =
        asked.iter().filter_map(|mutant| Some((*mutant, verdicts.get(&mutant.name())?))).collect();
    let mut report = Report::new(&done, &harnesses, &explained);
    let is_whole = done.len() == asked.len();
    if is_whole {
        for by_hand in explained.by_hand.iter().filter(|by_hand| is_asked(&by_hand.file)) {
            if judges[0].finds(by_hand)? {
                report.add_by_hand(by_hand);
            }
        }
    }
    print!("{}", report.text(specified));
    if let Some(path) = &options.write {
        write(path, &report.document(specified, !options.natively))?;
    }
    let outdated = explained.outdated(&mutants);
    for entry in &outdated {
        println!("verify/mutants.toml explains what is no mutant: {} {}", entry.file, entry.line);
    }
    let idle = if is_whole { report.idle() } else { Vec::new() };
    for harness in &idle {
        println!("{harness} finds no mutant");
    }
    if report.survivors() == 0 && idle.is_empty() && outdated.is_empty() {
        return Ok(());
    }
    Err("the harnesses do not see everything".to_owned())
}

/// Whether an earlier run's verdict can stay. The prover may decide now what it did not then.
fn is_decided(verdict: Option<&Verdict>, options: &Options) -> bool {
    verdict.is_some_and(|verdict| options.natively || verdict.by != By::Undecided)
}

/// The mutants of all machines, and how many more their specification would have.
fn all_mutants() -> Result<(Vec<Mutant>, usize), String> {
    let (mut mutants, mut specified) = (Vec::new(), 0);
    for (file, _) in FILES {
        let (own, left_out) = Mutant::of_file(file, &read(&root().join(file))?);
        mutants.extend(own);
        specified += left_out;
    }
    Ok((mutants, specified))
}

/// A copy of the repository for each mutant at a time.
fn judges(options: &Options) -> Result<Vec<Judge>, String> {
    let folder = root().join("target/proof-mutants");
    let (shard, _) = options.shard;
    let judge = |job: usize| {
        let workspace = Workspace::new(&root(), folder.join(format!("{shard}-{job}")))?;
        Ok(Judge { workspace, timeout: options.timeout, proves: !options.natively })
    };
    (0..options.jobs).map(judge).collect()
}

/// Judges mutants, in each copy one at a time.
fn judge_all(
    judges: &[Judge],
    jobs: &[&Mutant],
    harnesses: &BTreeMap<String, Vec<String>>,
    options: &Options,
) -> Result<Vec<(String, Verdict)>, String> {
    let next = Mutex::new(jobs.iter());
    let done = Mutex::new(Ok(Vec::new()));
    std::thread::scope(|scope| {
        for judge in judges {
            scope.spawn(|| {
                loop {
                    let mutant = next.lock().ok().and_then(|mut mutants| mutants.next());
                    let Some(mutant) = mutant else { return };
                    let own = harnesses.get(&mutant.file).map_or(&[][..], Vec::as_slice);
                    let verdict = judge.judge(mutant, own);
                    let Ok(mut done) = done.lock() else { return };
                    let kept = verdict.and_then(|verdict| {
                        println!("{:9} {}", format!("{:?}", verdict.by), verdict.mutant);
                        if let Some(path) = &options.keep {
                            append(path, &verdict)?;
                        }
                        Ok(verdict)
                    });
                    match (kept, &mut *done) {
                        (Ok(verdict), Ok(done)) => done.push((verdict.mutant.clone(), verdict)),
                        (Err(why), Ok(_)) => {
                            *done = Err(format!("{}: {why}", mutant.name()));
                            return;
                        }
                        (_, Err(_)) => return,
                    }
                }
            });
        }
    });
    done.into_inner().map_err(|why| why.to_string())?
}
