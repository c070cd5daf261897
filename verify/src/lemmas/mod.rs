//! The mathematics of the proofs: the lemmas of `verify/lemmas`, over unbounded integers and real
//! numbers, put to two solvers.
//!
//! A lemma is asked for twice: its hypotheses alone must be satisfiable (or it says nothing), and
//! with its conclusion denied they must not be. Its mutants are the same lemma with a small error;
//! no solver may prove one of them.

mod file;
mod solver;

pub use file::{Lemma, Mutant};
pub use solver::{Answer, SOLVERS, Solver};

use crate::in_parallel::in_parallel;
use clap::Args;
use std::path::PathBuf;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// What to check.
#[derive(Debug, Args)]
pub struct Options {
    /// Only lemmas whose file or name contains this
    #[arg(long)]
    only: Option<String>,
    /// Instead, make the small errors that stand beside each lemma and demand that none is proved
    #[arg(long)]
    mutants: bool,
    /// Seconds for one question to one solver: 10, or 3 where one answer is enough, for a mutant
    #[arg(long)]
    limit: Option<u64>,
    /// The folder of the lemmas
    #[arg(long, default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/lemmas"))]
    lemmas: PathBuf,
}

/// What one solver says of one lemma.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// Whether the hypotheses can hold together.
    pub hypotheses: Answer,
    /// Whether they can hold without the conclusion.
    pub denied: Answer,
    /// Time for both answers.
    pub seconds: f64,
}

/// What the solvers say of one lemma.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The file, without its ending.
    pub file: String,
    /// The lemma.
    pub name: String,
    /// In the order of [`SOLVERS`].
    pub verdicts: [Verdict; 2],
}

impl Outcome {
    /// Whether the lemma is proved: by one solver at least and without contradiction by the other,
    /// on hypotheses that one of them has seen satisfied.
    #[must_use]
    pub fn holds(&self) -> bool {
        let [hypotheses, denied] = [
            self.verdicts.each_ref().map(|verdict| &verdict.hypotheses),
            self.verdicts.each_ref().map(|verdict| &verdict.denied),
        ];
        agree(hypotheses, &Answer::Sat) && agree(denied, &Answer::Unsat)
    }
}

/// What the solvers say of a lemma with an error in it.
#[derive(Clone, Debug, PartialEq)]
pub struct MutantOutcome {
    /// The file, without its ending.
    pub file: String,
    /// The lemma.
    pub name: String,
    /// The error.
    pub mutant: Mutant,
    /// Whether it can fail, in the order of [`SOLVERS`].
    pub denied: [Answer; 2],
}

impl MutantOutcome {
    /// Whether the error is found: one solver shows where the changed lemma fails, and the other
    /// does not prove it.
    #[must_use]
    pub fn is_found(&self) -> bool {
        agree(self.denied.each_ref(), &Answer::Sat)
    }
}

/// Whether one solver at least gives this answer, and the other the same one or none.
fn agree(answers: [&Answer; 2], wanted: &Answer) -> bool {
    answers.contains(&wanted)
        && answers.iter().all(|answer| *answer == wanted || answer.is_undecided())
}

/// Asks both solvers for every lemma.
///
/// # Errors
/// A solver that is not there.
pub fn check(lemmas: &[Lemma], limit: Duration) -> Result<Vec<Outcome>, String> {
    let verdicts = ask(lemmas, |solver, lemma| {
        let begun = Instant::now();
        Ok(Verdict {
            hypotheses: solver.ask(&lemma.hypotheses(), limit)?,
            denied: solver.ask(&lemma.denied(), limit)?,
            seconds: begun.elapsed().as_secs_f64(),
        })
    })?;
    let outcome = |(lemma, verdicts): (&Lemma, _)| Outcome {
        file: lemma.file.clone(),
        name: lemma.name.clone(),
        verdicts,
    };
    Ok(lemmas.iter().zip(verdicts).map(outcome).collect())
}

/// Asks both solvers for every mutant of the lemmas.
///
/// # Errors
/// A solver that is not there; a mutant that does not fit its lemma.
pub fn check_mutants(lemmas: &[Lemma], limit: Duration) -> Result<Vec<MutantOutcome>, String> {
    let mut changed = Vec::new();
    for lemma in lemmas {
        for mutant in &lemma.mutants {
            changed.push((lemma.with(mutant)?, mutant));
        }
    }
    let answers = ask(&changed, |solver, (lemma, _)| solver.ask(&lemma.denied(), limit))?;
    let outcome = |((lemma, mutant), denied): (&(Lemma, &Mutant), _)| MutantOutcome {
        file: lemma.file.clone(),
        name: lemma.name.clone(),
        mutant: (*mutant).clone(),
        denied,
    };
    Ok(changed.iter().zip(answers).map(outcome).collect())
}

/// Puts every question to both solvers, as many at a time as there are processors.
fn ask<Q: Sync, A: Send>(
    questions: &[Q],
    question: impl Fn(&Solver, &Q) -> Result<A, String> + Sync,
) -> Result<Vec<[A; 2]>, String> {
    let jobs: Vec<_> = questions
        .iter()
        .flat_map(|asked| SOLVERS.each_ref().map(|solver| (solver, asked)))
        .collect();
    let answers: Vec<_> = jobs.iter().map(|_| Mutex::new(None)).collect();
    let numbered: Vec<_> = jobs.iter().zip(&answers).collect();
    in_parallel(&numbered, |((solver, asked), place)| {
        let answer = question(solver, asked)?;
        *place.lock().map_err(|e| e.to_string())? = Some(answer);
        Ok(())
    })?;
    let mut answers = answers.into_iter().filter_map(|place| place.into_inner().ok().flatten());
    let pair = |_| Some([answers.next()?, answers.next()?]);
    Ok(questions.iter().map_while(pair).collect())
}

/// Runs the checks that are asked for.
///
/// # Errors
/// A lemma that is not proved, a mutant that is not found, or what could not be run.
pub fn run(options: &Options) -> Result<(), String> {
    let begun = Instant::now();
    let limit = options.limit.unwrap_or(if options.mutants { 3 } else { 10 });
    let limit = Duration::from_secs(limit);
    let mut lemmas = Lemma::read_all(&options.lemmas)?;
    if let Some(only) = &options.only {
        lemmas.retain(|lemma| lemma.file.contains(only) || lemma.name.contains(only));
    }
    if lemmas.is_empty() {
        return Err("there is no such lemma".to_owned());
    }
    let (failed, all) = if options.mutants {
        let outcomes = check_mutants(&lemmas, limit)?;
        (report_mutants(&outcomes), format!("{} mutants, all found", outcomes.len()))
    } else {
        let outcomes = check(&lemmas, limit)?;
        (report(&outcomes), format!("{} lemmas, all proved", outcomes.len()))
    };
    if failed > 0 {
        return Err(format!("{failed} failed"));
    }
    println!("{all}, {:.1} s", begun.elapsed().as_secs_f64());
    Ok(())
}

/// Prints a line a lemma; how many are not proved.
fn report(outcomes: &[Outcome]) -> usize {
    for outcome in outcomes {
        let Outcome { file, name, verdicts } = outcome;
        let said = SOLVERS.iter().zip(verdicts).map(|(solver, verdict)| {
            let Verdict { hypotheses, denied, seconds } = verdict;
            format!("{} {hypotheses}, {denied} ({seconds:.2} s)", solver.name)
        });
        let said = said.collect::<Vec<_>>().join("; ");
        let holds = if outcome.holds() { "proved" } else { "NOT PROVED" };
        println!("{:52} {holds}: {said}", format!("{file}/{name}"));
    }
    outcomes.iter().filter(|outcome| !outcome.holds()).count()
}

/// Prints a line a mutant; how many are not found.
fn report_mutants(outcomes: &[MutantOutcome]) -> usize {
    for outcome in outcomes {
        let MutantOutcome { file, name, mutant, denied } = outcome;
        let said = SOLVERS.iter().zip(denied);
        let said = said.map(|(solver, answer)| format!("{} {answer}", solver.name));
        let said = said.collect::<Vec<_>>().join("; ");
        let found = if outcome.is_found() { "found" } else { "NOT FOUND" };
        println!("{file}/{name}: {} -> {}\n    {found}: {said}", mutant.from, mutant.to);
    }
    outcomes.iter().filter(|outcome| !outcome.is_found()).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outcome(hypotheses: [Answer; 2], denied: [Answer; 2]) -> Outcome {
        let [h, d] = [hypotheses, denied];
        let [[h0, h1], [d0, d1]] = [h, d];
        let verdict = |hypotheses, denied| Verdict { hypotheses, denied, seconds: 0.0 };
        let verdicts = [verdict(h0, d0), verdict(h1, d1)];
        Outcome { file: String::new(), name: String::new(), verdicts }
    }

    #[test]
    fn one_solver_is_enough_and_none_may_contradict() {
        use Answer::{Sat, TimedOut, Unknown, Unsat};
        let broken = || Answer::Other("(error)".to_owned());
        assert!(outcome([Sat, Sat], [Unsat, Unsat]).holds());
        assert!(outcome([Sat, Unknown], [TimedOut, Unsat]).holds());
        assert!(!outcome([Sat, Unsat], [Unsat, Unsat]).holds());
        assert!(!outcome([Unknown, TimedOut], [Unsat, Unsat]).holds());
        assert!(!outcome([Sat, Sat], [Unsat, Sat]).holds());
        assert!(!outcome([Sat, Sat], [Unknown, TimedOut]).holds());
        assert!(!outcome([Sat, Sat], [Unsat, broken()]).holds());
        assert!(!outcome([broken(), Sat], [Unsat, Unsat]).holds());
    }
}
