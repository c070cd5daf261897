//! One block: the software machine and the circuit side by side, cycle by cycle.

use super::deviation::Deviation;
use super::outputs::Outputs;
use crate::failure::Failure;
use crate::machine::Visitor;
use onepulse_core::{Error, Pulse};
use onepulse_hwmodel::Circuit;
use onepulse_plan::Motion;

/// A block about to be run.
pub(super) struct BlockRun<'a> {
    pub(super) motion: &'a Motion,
    /// What the interpolator's coordinates count from.
    pub(super) origin: [i64; 2],
    /// How far the machine stands from where the program believes it.
    pub(super) short: [i64; 2],
    pub(super) deviation: Deviation,
    pub(super) cycles_per_second: f64,
    pub(super) outputs: &'a mut Outputs,
}

/// What came of a block.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockResult {
    pub(super) cycles: u64,
    pub(super) pulses: [u64; 2],
    pub(super) deviation: f64,
    pub(super) residual: [i64; 2],
    pub(super) seconds: f64,
    /// The first cycle in which hardware model and software differ.
    pub(super) disagreement: Option<u64>,
}

impl Visitor for BlockRun<'_> {
    type Output = Result<BlockResult, Failure>;

    fn visit<S, C, const N: usize>(
        self,
        software: S,
        circuit: impl FnOnce() -> Result<C, Error>,
        start: [i64; N],
    ) -> Self::Output
    where
        S: Iterator<Item = Pulse<N>>,
        C: Circuit<N>,
    {
        // A program's curves lie in a plane.
        let Some(start) = start.first_chunk::<2>().copied() else {
            return Err(Failure::Fault("a curve of fewer than two axes".into()));
        };
        let circuit = circuit().map_err(|why| Failure::Fault(why.to_string()))?;
        self.run(software, circuit, start)
    }
}

impl BlockRun<'_> {
    fn run<S, C, const N: usize>(
        mut self,
        mut software: S,
        mut circuit: C,
        start: [i64; 2],
    ) -> Result<BlockResult, Failure>
    where
        S: Iterator<Item = Pulse<N>>,
        C: Circuit<N>,
    {
        let mut position = start;
        let mut cycles = 0;
        let mut pulses = [0; 2];
        let mut disagreement = None;
        self.outputs.begin(self.motion, self.cycles_per_second, &circuit)?;
        loop {
            let due = software.next();
            if circuit.done() != due.is_none() {
                disagreement = Some(cycles + 1);
            }
            let Some(due) = due.filter(|_| disagreement.is_none()) else {
                break;
            };
            let mut sent = [0; N];
            for _ in 0..C::CLOCKS_PER_CYCLE {
                let clock = self.outputs.clock(&mut circuit);
                for axis in 0..N {
                    sent[axis] += clock.0[axis];
                }
            }
            cycles += 1;
            if sent != due.0 {
                disagreement = Some(cycles);
                break;
            }
            if !due.is_none() {
                let pulse = [due.0[0], due.0[1]];
                for axis in 0..2 {
                    position[axis] += i64::from(pulse[axis]);
                    pulses[axis] += u64::from(pulse[axis].unsigned_abs());
                }
                self.deviation.reach(position);
                let absolute =
                    [0, 1].map(|axis| self.origin[axis] + position[axis] - self.short[axis]);
                self.outputs.pulse(cycles, Pulse(pulse), absolute)?;
            }
        }
        let seconds = cycles as f64 / self.cycles_per_second;
        self.outputs.end(seconds, &circuit)?;
        let residual =
            [0, 1].map(|axis| i64::from(self.motion.to[axis]) - self.origin[axis] - position[axis]);
        let deviation = self.deviation.in_pulses();
        Ok(BlockResult { cycles, pulses, deviation, residual, seconds, disagreement })
    }
}
