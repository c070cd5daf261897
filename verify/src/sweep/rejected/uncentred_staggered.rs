//! Staggered, but not centred.

use super::accumulator::Accumulator;
use super::tracker::{Tracker, turn};
use crate::sweep::walk::{Circuit, Drawing};
use onepulse_core::{Error, Pulse, Sweep};

/// As the centred staggered circuit, but both remainders start at half load: the circle closes, but
/// half a step of staggering is left over and makes it an ellipse.
#[derive(Clone, Copy)]
pub(crate) struct UncentredStaggered {
    jr: [Accumulator; 2],
    turn: i64,
    tracker: Tracker,
}

impl UncentredStaggered {
    pub(crate) fn new(drawing: &Drawing) -> Result<Self, Error> {
        let Drawing { start, end, direction, bits, .. } = *drawing;
        let jr = [Accumulator::half_loaded_and(0, bits); 2];
        Ok(Self { jr, turn: turn(direction), tracker: Tracker::new(start, end, direction)? })
    }

    /// Whether a full circle from (R, 0) comes back to (R, 0) when nothing stops it there.
    pub(crate) fn closes(radius: i64, bits: u32) -> bool {
        let mut jr = [Accumulator::half_loaded_and(0, bits); 2];
        let [mut x, mut y] = [radius, 0];
        // A turn takes 2π·2ⁿ cycles.
        for _ in 0..8_u64 << bits {
            x += jr[0].add(-y);
            let pulse = jr[1].add(x);
            y += pulse;
            if pulse == 1 && y == 0 {
                return x == radius;
            }
        }
        false
    }
}

impl Circuit for UncentredStaggered {
    fn step(&mut self) -> Option<Pulse> {
        let Self { jr, turn, tracker } = self;
        tracker.step(|position, stands| {
            if !stands[0] {
                position[0] += jr[0].add(-*turn * position[1]);
            }
            if !stands[1] {
                position[1] += jr[1].add(*turn * position[0]);
            }
        })
    }

    fn sweep(&self) -> &Sweep {
        &self.tracker.sweep
    }
}
