//! One block: the software machine and the circuit side by side, cycle by cycle.

use super::deviation::Deviation;
use super::interpolated::Interpolated;
use super::outputs::{Outputs, Pace};
use super::placed::{Placed, place};
use crate::failure::Failure;
use crate::machine::{Refusal, Visitor};
use onepulse_core::Pulse;
use onepulse_hwmodel::Circuit;
use onepulse_plan::Motion;

/// A block on its way: one curve, or the lines of its samples one after the other.
pub(super) struct BlockRun<'a> {
    motion: &'a Motion,
    interpolated: &'a Interpolated,
    /// How far the machine stands from where the program believes it.
    short: [i64; 3],
    /// When it began, where speeds are planned.
    since: f64,
    /// That of the last curve begun.
    pace: Option<Pace>,
    outputs: &'a mut Outputs,
    /// Where the path stands, from the interpolator's origin.
    position: [i64; 3],
    cycles: u64,
    pulses: [u64; 3],
    deviation: Deviation,
    /// The largest distance of the path from the lines of the samples.
    fine: f64,
    disagreement: Option<u64>,
}

/// What came of a block; of x, y and z.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockResult {
    pub(super) cycles: u64,
    pub(super) pulses: [u64; 3],
    pub(super) deviation: f64,
    /// The largest distance of the path from the lines of the samples; 0 if there are none.
    pub(super) fine: f64,
    pub(super) residual: [i64; 3],
    pub(super) seconds: f64,
    /// The first cycle in which hardware model and software differ.
    pub(super) disagreement: Option<u64>,
}

impl<'a> BlockRun<'a> {
    /// Begins a block of which no pulse is made yet, where speeds are planned at the time `since`.
    pub(super) fn begin(
        motion: &'a Motion,
        interpolated: &'a Interpolated,
        short: [i64; 3],
        since: f64,
        outputs: &'a mut Outputs,
    ) -> Result<Self, Failure> {
        outputs.begin(motion)?;
        let origin = interpolated.origin;
        Ok(Self {
            motion,
            interpolated,
            short,
            since,
            pace: None,
            outputs,
            position: [0, 1, 2].map(|axis| i64::from(motion.from[axis]) - origin[axis]),
            cycles: 0,
            pulses: [0; 3],
            deviation: interpolated.deviation(),
            fine: 0.0,
            disagreement: None,
        })
    }

    /// The block's next curve: all of it, or the line of a sample, which has a deviation of its own.
    pub(super) fn curve(&mut self, pace: Pace, from_line: Option<Deviation>) -> CurveRun<'_, 'a> {
        self.pace = Some(pace);
        CurveRun { pace, start: self.position, block: self, from_line }
    }

    /// Whether hardware model and software have sent the same pulses so far.
    pub(super) fn agrees(&self) -> bool {
        self.disagreement.is_none()
    }

    /// Ends the block.
    pub(super) fn end(self) -> Result<BlockResult, Failure> {
        let Self { motion, interpolated, position, cycles, pulses, fine, disagreement, .. } = self;
        self.outputs.end()?;
        let residual = [0, 1, 2]
            .map(|axis| i64::from(motion.to[axis]) - interpolated.origin[axis] - position[axis]);
        let seconds = match self.pace {
            None => 0.0,
            Some(Pace::Even { cycles_per_second }) => cycles as f64 / cycles_per_second,
            Some(Pace::Until { record, .. }) => record.time - self.since,
        };
        let deviation = self.deviation.in_pulses();
        Ok(BlockResult { cycles, pulses, deviation, fine, residual, seconds, disagreement })
    }
}

/// A curve of a block about to be run.
pub(super) struct CurveRun<'r, 'a> {
    pace: Pace,
    block: &'r mut BlockRun<'a>,
    start: [i64; 3],
    from_line: Option<Deviation>,
}

impl Visitor for CurveRun<'_, '_> {
    type Output = Result<(), Failure>;

    fn visit<S, C, const N: usize>(
        self,
        software: S,
        circuit: impl FnOnce() -> Result<C, Refusal>,
        _: [i64; N],
    ) -> Self::Output
    where
        S: Iterator<Item = Pulse<N>>,
        C: Circuit<N>,
    {
        let circuit = circuit().map_err(|why| Failure::Fault(why.to_string()))?;
        let plane = self.block.interpolated.plane;
        self.block.outputs.begin_curve::<C, N>(self.pace, plane);
        self.run(software.map(move |pulse| place(plane, pulse)), Placed { circuit, plane })
    }
}

impl CurveRun<'_, '_> {
    fn run<S, C>(self, mut software: S, mut circuit: C) -> Result<(), Failure>
    where
        S: Iterator<Item = Pulse<3>>,
        C: Circuit<3>,
    {
        let Self { block, start, mut from_line, .. } = self;
        let before = block.cycles;
        loop {
            let due = match cycle(&mut software, &mut circuit, |c| block.outputs.clock(c)) {
                Cycle::Sent(due) => due,
                Cycle::Over => break,
                Cycle::Differs => {
                    block.disagreement = Some(block.cycles + 1);
                    break;
                }
            };
            block.cycles += 1;
            if !due.is_none() {
                block.pulse(due)?;
                if let Some(from_line) = &mut from_line {
                    let way = [0, 1, 2].map(|axis| block.position[axis] - start[axis]);
                    from_line.reach(block.interpolated.in_order(way));
                }
            }
        }
        block.fine = from_line.map_or(0.0, Deviation::in_pulses).max(block.fine);
        block.outputs.end_curve(block.cycles - before, &circuit)
    }
}

impl BlockRun<'_> {
    /// Takes the pulses of the cycle that was counted last.
    fn pulse(&mut self, pulse: Pulse<3>) -> Result<(), Failure> {
        for axis in 0..3 {
            self.position[axis] += i64::from(pulse.0[axis]);
            self.pulses[axis] += u64::from(pulse.0[axis].unsigned_abs());
        }
        self.deviation.reach(self.interpolated.in_order(self.position));
        let origin = self.interpolated.origin;
        let absolute = [0, 1, 2].map(|axis| origin[axis] + self.position[axis] - self.short[axis]);
        self.outputs.pulse(self.cycles, pulse, absolute)
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
