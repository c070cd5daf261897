//! Up, along and down again: what a trapezoid moves on each clock.

use super::Limits;

/// The speeds of a [`Trapezoid`](super::Trapezoid), a way a clock, in units of 2⁻ⁿ pulses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Speeds {
    pub(super) limits: Limits,
    /// The way that is left.
    pub(super) left: u64,
    /// The present speed; 0 standing.
    pub(super) speed: u32,
    /// D of that speed.
    pub(super) stopping: u64,
}

impl Speeds {
    /// From standstill over so many pulses, within limits that are checked.
    pub(super) const fn new(pulses: u32, limits: Limits) -> Self {
        Self { limits, left: (pulses as u64) << limits.bits, speed: 0, stopping: 0 }
    }

    /// What this clock moves, at least 1; `None` when the axis stands at its end.
    #[inline]
    pub(super) fn next_way(&mut self) -> Option<u32> {
        if self.left == 0 {
            return None;
        }
        self.change_speed();
        // Below 2³¹, as the speed is.
        let way = u64::from(self.speed).min(self.left);
        self.left -= way;
        if self.left == 0 {
            (self.speed, self.stopping) = (0, 0);
        }
        Some(way as u32)
    }

    /// Takes the highest of the three speeds from which it can stop in time.
    #[inline]
    fn change_speed(&mut self) {
        let Limits { start, acceleration, largest, .. } = self.limits;
        let (speed, stopping) = (self.speed, self.stopping);
        let faster = if speed == 0 { start } else { speed + acceleration };
        // What this speed needs on this clock and after it.
        let keeping = stopping + u64::from(speed);
        if faster <= largest && keeping + u64::from(faster) <= self.left {
            self.speed = faster;
            self.stopping = keeping;
        } else if keeping > self.left && speed > start {
            self.speed = speed - acceleration;
            self.stopping = stopping - u64::from(self.speed);
        } else if speed == 0 {
            // Less than the start speed's way.
            self.speed = start;
        }
    }

    /// Stopping does not take more than the way that is left, and the speed is within its limits.
    pub(super) const fn bounds_hold(&self) -> bool {
        self.stopping <= self.left
            && (self.speed == 0 || self.limits.start <= self.speed)
            && self.speed <= self.limits.largest
    }
}
