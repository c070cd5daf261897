//! The trapezoid: constant acceleration, constant speed, constant deceleration.

use super::Limits;
use super::phase::Phase;
use super::speeds::Speeds;
use crate::Error;

/// Pulses of one axis, from standstill to standstill.
///
/// The speeds are v(1) = start, v(k) = start + (k − 1)·a, up to the largest. To stop from v(k) takes
/// D(k) = v(1) + … + v(k − 1) beyond this clock. Every clock the axis takes the next speed up, its own,
/// or the next one down: the first of these from which it can stop within the way that is left. Its way
/// may end with less than v(1), which the last clock makes. So D ≤ way left always: it arrives without
/// ever changing its speed by more than a (or the start speed, at both ends), and just there, because
/// what it moves is taken from the way.
///
/// ```
/// use onepulse_core::ramp::{Limits, Trapezoid};
/// let limits = Limits { bits: 8, start: 16, acceleration: 4, largest: 128 };
/// let ramp = Trapezoid::new(100, limits)?;
/// assert_eq!(ramp.filter(|pulse| *pulse).count(), 100);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Trapezoid {
    pub(super) speeds: Speeds,
    phase: Phase,
}

impl Trapezoid {
    /// So many pulses within the limits.
    ///
    /// # Errors
    /// Limits out of their ranges.
    pub fn new(pulses: u32, limits: Limits) -> Result<Self, Error> {
        let limits = limits.checked()?;
        Ok(Self { speeds: Speeds::new(pulses, limits), phase: Phase::new(limits.bits) })
    }

    /// The ramp in this state, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(
        limits: Limits,
        left: u64,
        speed: u32,
        stopping: u64,
        phase: u32,
        pulses: u32,
    ) -> Self {
        let speeds = Speeds { limits, left, speed, stopping };
        Self { speeds, phase: Phase { bits: limits.bits, register: phase, pulses } }
    }

    /// One clock: whether there is a pulse; `None` when the axis stands at its end.
    #[inline]
    pub fn step(&mut self) -> Option<bool> {
        let way = self.speeds.next_way()?;
        let pulse = self.phase.add(way);
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// The speed of the last clock, in units of 2⁻ⁿ pulses; 0 standing. (The last clock may move by
    /// less.)
    #[must_use]
    pub const fn speed(&self) -> u32 {
        self.speeds.speed
    }

    /// The way that is left, in units of 2⁻ⁿ pulses.
    #[must_use]
    pub const fn left(&self) -> u64 {
        self.speeds.left
    }

    /// What stopping from the present speed takes, in the same units.
    #[must_use]
    pub const fn stopping(&self) -> u64 {
        self.speeds.stopping
    }

    /// The phase register.
    #[must_use]
    pub const fn phase(&self) -> u32 {
        self.phase.register
    }

    /// Pulses made.
    #[must_use]
    pub const fn pulses(&self) -> u32 {
        self.phase.pulses
    }

    /// Whether the axis stands at its end.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.speeds.left == 0
    }

    /// What always holds: stopping does not take more than the way that is left, speed and phase are
    /// within their limits, and phase and way make whole pulses together.
    #[must_use]
    pub const fn invariant(&self) -> bool {
        self.speeds.bounds_hold() && self.phase.completes(self.speeds.left)
    }
}

impl Iterator for Trapezoid {
    type Item = bool;

    #[inline]
    fn next(&mut self) -> Option<bool> {
        self.step()
    }
}
