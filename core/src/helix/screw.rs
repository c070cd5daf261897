//! What makes a helix of an arc.

use super::{Distributor, Plane};
use crate::Pulse;
use crate::pulse::signed;

/// All of a helix but its arc: the linear axis, what shares the cycles out between the two, and the
/// plane that says whose pulses are whose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Screw {
    plane: Plane,
    rise: i32,
    /// Pulses made on the linear axis.
    risen: u32,
    distributor: Distributor,
}

impl Screw {
    /// Across an arc of so many steps, which has not begun.
    pub(super) fn new(plane: Plane, steps: u64, rise: i32) -> Self {
        let distributor = Distributor::new(steps, rise.unsigned_abs());
        Self { plane, rise, risen: 0, distributor }
    }

    /// In this state, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(plane: Plane, rise: i32, risen: u32, distributor: Distributor) -> Self {
        Self { plane, rise, risen, distributor }
    }

    /// One cycle, in which `turn` makes a step of the arc if one is due; `None` after the last.
    #[inline]
    pub fn cycle(&mut self, turn: impl FnOnce() -> Pulse) -> Option<Pulse<3>> {
        let [turns, rises] = self.distributor.share()?;
        let Pulse([first, second]) = if turns { turn() } else { Pulse::NONE };
        self.risen += u32::from(rises);
        let across = if rises { self.rise.signum() as i8 } else { 0 };
        Some(Pulse(self.plane.place([first, second, across])))
    }

    /// The plane of the arc.
    #[must_use]
    pub const fn plane(&self) -> Plane {
        self.plane
    }

    /// What shares the cycles out.
    #[must_use]
    pub const fn distributor(&self) -> &Distributor {
        &self.distributor
    }

    /// The pulses that the linear axis still has to make.
    #[must_use]
    pub const fn to_rise(&self) -> u64 {
        self.rise.unsigned_abs().saturating_sub(self.risen) as u64
    }

    /// The present point, where the arc is at this one.
    #[must_use]
    pub const fn position(&self, [first, second]: [i64; 2]) -> [i64; 3] {
        self.plane.place([first, second, self.height()])
    }

    /// What is missing to the end point, where this is missing in the plane.
    #[must_use]
    pub const fn residual(&self, [first, second]: [i64; 2]) -> [i64; 3] {
        self.plane.place([first, second, self.rise as i64 - self.height()])
    }

    /// How far the linear axis has come.
    const fn height(&self) -> i64 {
        signed(self.rise.signum() as i8, self.risen as i64)
    }

    /// What always holds, where the arc still has so many steps to make.
    #[must_use]
    pub fn invariant(&self, to_turn: u64) -> bool {
        self.risen <= self.rise.unsigned_abs()
            && self.distributor.invariant([to_turn, self.to_rise()])
    }
}
