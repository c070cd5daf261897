//! Whether a block can be made, and how a block that cannot is refused.

use super::coarse::Coarse;
use super::config::Config;
use super::interpolated::Interpolated;
use super::planned::PlannedBlock;
use crate::choice::Method;
use crate::failure::Failure;
use crate::machine::{Refusal, Visitor, with_machines};
use onepulse_core::Pulse;
use onepulse_hwmodel::Circuit;
use onepulse_plan::{Diagnostic, Motion, Place};

/// Checks the blocks of a program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Checker<'a> {
    pub(super) config: &'a Config,
    pub(super) method: &'a Method,
    /// The program's.
    pub(super) name: &'a str,
}

impl<'a> Checker<'a> {
    /// Refuses a block that the machine's method or registers do not serve.
    pub(super) fn check(
        self,
        motion: &Motion,
        place: &Place,
        planned: Option<&PlannedBlock<'_>>,
    ) -> Result<(), Diagnostic> {
        let block = Interpolated::of(motion);
        if block.is_in_space() && !self.method.has_circuit_in_space() {
            let message = format!(
                "X, Y and Z move at once: --method {} has no circuit for lines in space",
                self.method.name()
            );
            let help =
                "take --method dda, brm or min-deviation, or move two axes at most in a block";
            return Err(diagnostic(place, message, help));
        }
        let served = self.coarse(motion, &block, planned).and_then(|coarse| match coarse {
            // What serves the longest sample serves them all.
            Some(_) => Ok(()),
            None => with_machines(&block.curve, self.method, Some(self.config.bits), Built)?,
        });
        served.map_err(|why| refusal(place, &why))
    }

    /// The samples of a block, of two levels.
    pub(super) fn coarse<'r>(
        self,
        motion: &Motion,
        block: &Interpolated,
        planned: Option<&PlannedBlock<'r>>,
    ) -> Result<Option<Coarse<'r>>, Refusal> {
        let Some(levels) = &self.config.two_level else { return Ok(None) };
        let (speed, widest) = (self.config.speed(motion), self.config.bits);
        let coarse = match planned {
            None => Coarse::new(&block.curve, speed, levels, widest),
            Some(planned) => Coarse::planned(block, speed, planned, levels, widest),
        };
        coarse.map(Some)
    }

    /// The failure of a block that is refused.
    pub(super) fn refused(self, place: &Place, why: &Refusal) -> Failure {
        self.failure(vec![refusal(place, why)])
    }

    /// The failure of blocks that are refused.
    pub(super) fn failure(self, wrong: Vec<Diagnostic>) -> Failure {
        Failure::Program { file: self.name.to_owned(), wrong, gouges: Vec::new() }
    }
}

fn refusal(place: &Place, why: &Refusal) -> Diagnostic {
    let help = "change the block, or the machine: --method, --bits or machine.toml";
    diagnostic(place, why.to_string(), help)
}

fn diagnostic(place: &Place, message: String, help: &str) -> Diagnostic {
    Diagnostic { place: place.clone(), also: Vec::new(), message, help: help.to_owned() }
}

/// Builds the circuit of a curve, and lets it go.
struct Built;

impl Visitor for Built {
    type Output = Result<(), Refusal>;

    fn visit<S, C, const AXES: usize>(
        self,
        _: S,
        circuit: impl FnOnce() -> Result<C, Refusal>,
        _: [i64; AXES],
    ) -> Self::Output
    where
        S: Iterator<Item = Pulse<AXES>>,
        C: Circuit<AXES>,
    {
        circuit().map(|_| ())
    }
}
