//! Up and down with both axes at once.

use super::accumulator::Accumulator;
use super::tracker::{Tracker, turn};
use crate::sweep::walk::{Circuit, Drawing};
use onepulse_core::{Error, Pulse, Sweep};

/// Signed coordinates, half load, remainders that run up and down, and both axes add the coordinates
/// as they stood before the cycle: each cycle turns the point along the tangent, and it spirals out.
#[derive(Clone, Copy)]
pub(crate) struct SimultaneousUpDown {
    jr: [Accumulator; 2],
    turn: i64,
    tracker: Tracker,
}

impl SimultaneousUpDown {
    pub(crate) fn new(drawing: &Drawing) -> Result<Self, Error> {
        let Drawing { start, end, direction, bits, .. } = *drawing;
        let jr = [Accumulator::half_loaded_and(0, bits); 2];
        Ok(Self { jr, turn: turn(direction), tracker: Tracker::new(start, end, direction)? })
    }
}

impl Circuit for SimultaneousUpDown {
    fn step(&mut self) -> Option<Pulse> {
        let Self { jr, turn, tracker } = self;
        tracker.step(|position, stands| {
            let [x, y] = *position;
            if !stands[0] {
                position[0] += jr[0].add(-*turn * y);
            }
            if !stands[1] {
                position[1] += jr[1].add(*turn * x);
            }
        })
    }

    fn sweep(&self) -> &Sweep {
        &self.tracker.sweep
    }
}
