//! One mutant after another: by harnesses on a few values, by tests, by the prover.

use super::explained::ByHand;
use super::mutant::Mutant;
use super::native::{Ran, build, harness, run};
use super::solved::{Solved, solve};
use super::verdict::{By, Verdict};
use super::workspace::Workspace;
use std::time::Duration;

/// The packages of the harnesses and of the machines.
const PROOFS: &str = "onepulse-proofs";
const CORE: &str = "onepulse-core";

/// Longer than any harness runs natively that has not been caught in a loop.
const NATIVE_LIMIT: Duration = Duration::from_secs(120);

/// Finds mutants in one copy of the repository.
#[derive(Debug)]
pub(super) struct Judge {
    pub(super) workspace: Workspace,
    /// Seconds for one harness.
    pub(super) timeout: u64,
    /// Whether what the tests do not find is given to the prover.
    pub(super) proves: bool,
}

/// The files of the machines, and the modules of the harnesses that run each.
pub(super) const FILES: [(&str, &[&str]); 31] = [
    ("core/src/ppc/line.rs", &["ppc_line"]),
    ("core/src/ppc/arc.rs", &["ppc_arc"]),
    ("core/src/dda/line.rs", &["dda_line"]),
    ("core/src/dda/arc.rs", &["dda_arc"]),
    ("core/src/dda/centred_arc.rs", &["centred_arc"]),
    ("core/src/brm.rs", &["brm"]),
    ("core/src/minimum_deviation/line.rs", &["minimum_deviation_line"]),
    ("core/src/minimum_deviation/arc.rs", &["minimum_deviation_arc"]),
    ("core/src/vector/line.rs", &["vector_line"]),
    ("core/src/vector/arc.rs", &["vector_arc"]),
    ("core/src/comparison/line.rs", &["comparison_line"]),
    ("core/src/comparison/arc.rs", &["comparison_arc"]),
    ("core/src/parabola/shape.rs", &["parabola"]),
    ("core/src/parabola/way.rs", &["parabola"]),
    ("core/src/parabola/ppc.rs", &["parabola"]),
    ("core/src/parabola/minimum_deviation.rs", &["parabola"]),
    ("core/src/parabola/dda.rs", &["parabola"]),
    ("core/src/helix.rs", &["helix"]),
    ("core/src/helix/distributor.rs", &["helix"]),
    ("core/src/helix/screw.rs", &["helix"]),
    ("core/src/ppc/space_line.rs", &["space_line"]),
    ("core/src/brm/smoothed.rs", &["brm_smoothed"]),
    ("core/src/circle.rs", &["circle"]),
    ("core/src/walk.rs", &["ppc_arc", "circle"]),
    ("core/src/ramp/limits.rs", &["ramp_trapezoid", "ramp_s_curve"]),
    ("core/src/ramp/speeds.rs", &["ramp_trapezoid", "ramp_s_curve"]),
    ("core/src/ramp/phase.rs", &["ramp_trapezoid", "ramp_s_curve"]),
    ("core/src/ramp/trapezoid.rs", &["ramp_trapezoid"]),
    ("core/src/ramp/s_curve.rs", &["ramp_s_curve"]),
    ("core/src/sweep.rs", &["ppc_arc", "dda_arc", "centred_arc"]),
    ("core/src/quadrant.rs", &["ppc_arc", "dda_arc", "centred_arc"]),
];

/// How the names of a file's harnesses begin, as tests.
fn beginnings(file: &str) -> Vec<String> {
    let modules = FILES.iter().find(|(known, _)| *known == file).map_or(&[][..], |(_, own)| own);
    modules.iter().map(|module| format!("{module}::__test_")).collect()
}

impl Judge {
    /// The harnesses of a file, all of which must hold where nothing is changed.
    pub(super) fn harnesses(&self, file: &str) -> Result<Vec<String>, String> {
        let program = build(&self.workspace, PROOFS)?.ok_or("the harnesses do not compile")?;
        let ran = run(&self.workspace, &program, &beginnings(file), NATIVE_LIMIT)?;
        if ran.found() {
            return Err(format!("without a mutant: {:?} {:?}", ran.failed, ran.broken_off));
        }
        Ok(ran.passed.iter().map(|test| harness(test).to_owned()).collect())
    }

    /// What finds the mutant first.
    pub(super) fn judge(&self, mutant: &Mutant, harnesses: &[String]) -> Result<Verdict, String> {
        let (by, found) = self.workspace.with_mutant(mutant, |workspace| {
            let Some(ran) = self.tests(PROOFS, &beginnings(&mutant.file))? else {
                return Ok((By::Compiler, Vec::new()));
            };
            if ran.found() {
                return Ok((By::Harness, names(ran)));
            }
            if let Some(ran) = self.tests(CORE, &[])?.filter(Ran::found) {
                return Ok((By::Test, names(ran)));
            }
            if !self.proves {
                return Ok((By::Undecided, Vec::new()));
            }
            let Solved { failed, undecided } = solve(workspace, harnesses, self.timeout)?;
            Ok(match (failed.is_empty(), undecided.is_empty()) {
                (false, _) => (By::Prover, failed),
                (true, false) => (By::Undecided, undecided),
                (true, true) => (By::Nothing, Vec::new()),
            })
        })?;
        Ok(Verdict { mutant: mutant.name(), by, found })
    }

    /// Whether a mutant is found by the harness that it is for: by the prover, if it is used.
    pub(super) fn finds(&self, by_hand: &ByHand) -> Result<bool, String> {
        let harnesses = [by_hand.harness.clone()];
        let change = |source: &str| by_hand.applied(source);
        self.workspace.with(&by_hand.file, change, |workspace| {
            if self.proves {
                return Ok(!solve(workspace, &harnesses, self.timeout)?.failed.is_empty());
            }
            let test = format!("::__test_{}", by_hand.harness);
            Ok(self.tests(PROOFS, &[test])?.is_some_and(|ran| ran.found()))
        })
    }

    fn tests(&self, package: &str, beginnings: &[String]) -> Result<Option<Ran>, String> {
        let Some(program) = build(&self.workspace, package)? else { return Ok(None) };
        run(&self.workspace, &program, beginnings, NATIVE_LIMIT).map(Some)
    }
}

/// What failed, or else how the program ended.
fn names(ran: Ran) -> Vec<String> {
    let mut names: Vec<String> = ran.failed.iter().map(|test| harness(test).to_owned()).collect();
    names.extend(ran.broken_off.map(str::to_owned));
    names
}
