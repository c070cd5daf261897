//! The moving point of a rejected circuit, which ends as the arcs of the core do.

use onepulse_core::{Direction, Error, Pulse, Sweep};

/// The point and its way round.
#[derive(Clone, Copy)]
pub(super) struct Tracker {
    position: [i64; 2],
    pub(super) sweep: Sweep,
}

impl Tracker {
    pub(super) fn new(start: [i32; 2], end: [i32; 2], direction: Direction) -> Result<Self, Error> {
        Ok(Self { position: start.map(i64::from), sweep: Sweep::new(start, end, direction)? })
    }

    /// One cycle, `None` at the end; `accumulate` moves the axes that do not stand.
    pub(super) fn step(
        &mut self,
        accumulate: impl FnOnce(&mut [i64; 2], [bool; 2]),
    ) -> Option<Pulse> {
        let before = self.position;
        if self.sweep.crossings_left() == 0 && before == self.sweep.end() {
            return None;
        }
        if self.sweep.is_stepping_out(before) {
            let Pulse([dx, dy]) = self.sweep.step_out(before);
            self.position = [before[0] + i64::from(dx), before[1] + i64::from(dy)];
        } else {
            accumulate(&mut self.position, self.sweep.stands(before));
        }
        self.sweep.arrive(self.position);
        Some(Pulse([0, 1].map(|axis| (self.position[axis] - before[axis]) as i8)))
    }
}

/// +1 for a counter-clockwise arc, −1 for a clockwise one.
pub(super) fn turn(direction: Direction) -> i64 {
    if direction == Direction::Ccw { 1 } else { -1 }
}
