//! One block: the software machine and the circuit side by side, cycle by cycle.

use super::deviation::Deviation;
use super::outputs::Outputs;
use crate::failure::Failure;
use crate::machine::{Refusal, Visitor};
use onepulse_core::Pulse;
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
        circuit: impl FnOnce() -> Result<C, Refusal>,
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
        self.outputs.begin::<C, N>(self.motion, self.cycles_per_second)?;
        let disagreement = loop {
            let due = match cycle(&mut software, &mut circuit, |c| self.outputs.clock(c)) {
                Cycle::Sent(due) => due,
                Cycle::Over => break None,
                Cycle::Differs => break Some(cycles + 1),
            };
            cycles += 1;
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
        };
        let seconds = cycles as f64 / self.cycles_per_second;
        self.outputs.end(seconds, &circuit)?;
        let residual =
            [0, 1].map(|axis| i64::from(self.motion.to[axis]) - self.origin[axis] - position[axis]);
        let deviation = self.deviation.in_pulses();
        Ok(BlockResult { cycles, pulses, deviation, residual, seconds, disagreement })
    }
}

/// What came of one interpolation cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Cycle<const N: usize> {
    /// Both sent these pulses.
    Sent(Pulse<N>),
    /// Both are done.
    Over,
    /// They sent different pulses, or one of them is done.
    Differs,
}

/// Runs software and circuit for one interpolation cycle; `clock` gives the circuit its clocks.
fn cycle<S, C, const N: usize>(
    software: &mut S,
    circuit: &mut C,
    mut clock: impl FnMut(&mut C) -> Pulse<N>,
) -> Cycle<N>
where
    S: Iterator<Item = Pulse<N>>,
    C: Circuit<N>,
{
    match (software.next(), circuit.done()) {
        (None, true) => Cycle::Over,
        (Some(due), false) => {
            let mut sent = Pulse::NONE;
            for _ in 0..C::CLOCKS_PER_CYCLE {
                let pulses = clock(circuit);
                for axis in 0..N {
                    sent.0[axis] += pulses.0[axis];
                }
            }
            if sent == due { Cycle::Sent(due) } else { Cycle::Differs }
        }
        _ => Cycle::Differs,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use onepulse_core::{EndRule, ppc};
    use onepulse_hwmodel as hw;

    /// The cycles in which both agree, and whether they agree to the end.
    fn agreement(software: [i32; 2], circuit: [i32; 2]) -> (u32, bool) {
        let mut software = ppc::Line::new(software, EndRule::Total).unwrap();
        let mut circuit = hw::ppc::Line::new(circuit, 4, EndRule::Total).unwrap();
        let mut cycles = 0;
        loop {
            match cycle(&mut software, &mut circuit, |c| c.clock()) {
                Cycle::Sent(_) => cycles += 1,
                Cycle::Over => return (cycles, true),
                Cycle::Differs => return (cycles, false),
            }
        }
    }

    #[test]
    fn a_circuit_of_another_curve_is_found_out() {
        assert_eq!(agreement([5, 3], [5, 3]), (8, true));
        // x y x y x x against x y x y x y.
        assert_eq!(agreement([5, 3], [5, 4]), (5, false));
        // The same pulses in the other direction.
        assert_eq!(agreement([5, 3], [-5, 3]), (0, false));
        // One is done before the other.
        assert_eq!(agreement([5, 0], [6, 0]), (5, false));
        assert_eq!(agreement([6, 0], [5, 0]), (5, false));
    }
}
