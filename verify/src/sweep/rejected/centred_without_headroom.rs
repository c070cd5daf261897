//! Centred and staggered, but without the headroom bit.

use super::accumulator::Accumulator;
use super::tracker::{Tracker, turn};
use crate::sweep::walk::{Circuit, Drawing};
use onepulse_core::{Error, Pulse, Sweep};

/// The centred staggered circuit for any radius: the core refuses R > 2^(n−1) − 1.
#[derive(Clone, Copy)]
pub(crate) struct CentredWithoutHeadroom {
    jr: [Accumulator; 2],
    turn: i64,
    tracker: Tracker,
}

impl CentredWithoutHeadroom {
    pub(crate) fn new(drawing: &Drawing) -> Result<Self, Error> {
        let Drawing { start, end, direction, bits, .. } = *drawing;
        // Half a step ahead, rounded towards zero as in the core.
        let ahead = turn(direction) * i64::from(start[1]) / 2;
        let jr = [ahead, 0].map(|more| Accumulator::half_loaded_and(more, bits));
        Ok(Self { jr, turn: turn(direction), tracker: Tracker::new(start, end, direction)? })
    }
}

impl Circuit for CentredWithoutHeadroom {
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
