//! The trapezoid: constant acceleration, constant speed, constant deceleration.

use crate::Error;

/// What an axis may do, in units of 2⁻ⁿ pulses a clock.
///
/// A frequency of f pulses a second is f·2ⁿ/f_clock units; an acceleration of so many pulses a second,
/// each second, is that times 2ⁿ/f_clock² units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// n, 1 to 31.
    pub bits: u32,
    /// The speed that the axis starts with and stops from at once: at least 1.
    pub start: u32,
    /// By how much the speed changes from one clock to the next at most: at least 1, and not more than
    /// the largest speed.
    pub acceleration: u32,
    /// The speed that it never exceeds: below 2ⁿ, a pulse on every clock, and not below the start's.
    pub largest: u32,
}

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
    limits: Limits,
    /// The way that is left.
    left: u64,
    /// The present speed; 0 standing.
    speed: u32,
    /// D of that speed.
    stopping: u64,
    phase: u32,
    pulses: u32,
}

impl Trapezoid {
    /// So many pulses within the limits.
    ///
    /// # Errors
    /// Limits out of their ranges.
    pub fn new(pulses: u32, limits: Limits) -> Result<Self, Error> {
        let Limits { bits, start, acceleration, largest } = limits;
        if !(1..=31).contains(&bits) {
            return Err(Error::RegisterWidth { digits: bits, widest: 31 });
        }
        let is_some = 1 <= start && 1 <= acceleration;
        if !is_some || start.max(acceleration) > largest || largest >> bits != 0 {
            return Err(Error::RampLimits);
        }
        let left = u64::from(pulses) << bits;
        Ok(Self { limits, left, speed: 0, stopping: 0, phase: 0, pulses: 0 })
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
        Self { limits, left, speed, stopping, phase, pulses }
    }

    /// One clock: whether there is a pulse; `None` when the axis stands at its end.
    #[inline]
    pub fn step(&mut self) -> Option<bool> {
        if self.left == 0 {
            return None;
        }
        self.change_speed();
        let way = u64::from(self.speed).min(self.left);
        self.left -= way;
        if self.left == 0 {
            (self.speed, self.stopping) = (0, 0);
        }
        // Both are below 2³¹.
        let phase = self.phase + way as u32;
        let pulse = phase >> self.limits.bits != 0;
        self.phase = phase & ((1 << self.limits.bits) - 1);
        self.pulses += u32::from(pulse);
        debug_assert!(self.invariant());
        Some(pulse)
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

    /// The speed of the last clock, in units of 2⁻ⁿ pulses; 0 standing. (The last clock may move by
    /// less.)
    #[must_use]
    pub const fn speed(&self) -> u32 {
        self.speed
    }

    /// The way that is left, in units of 2⁻ⁿ pulses.
    #[must_use]
    pub const fn left(&self) -> u64 {
        self.left
    }

    /// What stopping from the present speed takes, in the same units.
    #[must_use]
    pub const fn stopping(&self) -> u64 {
        self.stopping
    }

    /// The phase register.
    #[must_use]
    pub const fn phase(&self) -> u32 {
        self.phase
    }

    /// Pulses made.
    #[must_use]
    pub const fn pulses(&self) -> u32 {
        self.pulses
    }

    /// Whether the axis stands at its end.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.left == 0
    }

    /// What always holds: stopping does not take more than the way that is left, speed and phase are
    /// within their limits, and phase and way make whole pulses together.
    #[must_use]
    pub const fn invariant(&self) -> bool {
        let Limits { bits, start, largest, .. } = self.limits;
        let modulus = 1 << bits;
        self.stopping <= self.left
            && (self.speed == 0 || start <= self.speed)
            && self.speed <= largest
            && (self.phase as u64) < modulus
            && (self.left + self.phase as u64) % modulus == 0
    }
}

impl Iterator for Trapezoid {
    type Item = bool;

    #[inline]
    fn next(&mut self) -> Option<bool> {
        self.step()
    }
}
