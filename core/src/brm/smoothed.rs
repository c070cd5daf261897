//! The rate multiplier with a pulse smoother (均匀器) behind it.

use super::Line;
use crate::{
    Error, Pulse,
    dda::{Radix, Register},
};

/// A line by rate multiplier whose trains pass a divider by 2^k, an axis each.
///
/// The n-stage multiplier runs for 2^k periods, 2^(n+k) clocks, and makes 2^k times the pulses (the
/// same trains as of n + k stages with the values shifted left by k); of the pulses of an axis the
/// divider passes every 2^k-th, from half load 2^(k−1). So each axis gets exactly its |end| pulses
/// again, in clocks that must be 2^k times as fast for the same feed.
///
/// What it buys: let the train have made q pulses after c clocks and D be the multiplier's largest
/// deviation from v·c/2ⁿ, the same in every period. The divider has passed ⌊q/2^k + ½⌋ (k ≥ 1), which is
/// within ½ of q/2^k, which is within D/2^k of v·c/2^(n+k). **An axis is off by D/2^k + ½ at most**, and a
/// plane line by the multiplier's largest distance from the line, divided by 2^k, plus √2/2. The bound of
/// an axis is attained: by the value 1 in one stage (D = ½), k = 1, which is off by ¾ at the first clock.
/// The line to (682, 341), n = 10, strays by 2.236 pulses, and with k = 1, 2, 3, 4 by 1.342, 0.894, 0.894
/// and 0.447. With k = 0 it is [`Line`].
///
/// ```
/// use onepulse_core::{Pulse, brm};
/// let mut line = brm::Smoothed::new([10, 6], 4, 2)?;
/// assert_eq!(line.remaining(), 64);
/// let clocks = [(); 64].map(|()| line.step());
/// assert_eq!(clocks.iter().filter(|pulse| pulse.is_some_and(|pulse| pulse.0[0] == 1)).count(), 10);
/// assert_eq!(line.position(), [10, 6]);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Smoothed<const AXES: usize = 2> {
    /// The multiplier of n + k stages with the values shifted left; its position counts the pulses of
    /// the trains, its end is that of this line.
    train: Line<AXES>,
    divider: [u64; AXES],
    position: [i64; AXES],
    smoothing: u32,
}

impl<const AXES: usize> Smoothed<AXES> {
    /// The line to `end` with a divider chain of `bits` stages (n), smoothed by dividers of
    /// `smoothing` stages (k).
    ///
    /// # Errors
    /// As [`Line::new`]; n + k over 32.
    pub fn new(end: [i32; AXES], bits: u32, smoothing: u32) -> Result<Self, Error> {
        let plain = Line::new(end, bits)?;
        let register = Register::new(Radix::Binary, bits.saturating_add(smoothing))?;
        let value = plain.value.map(|value| value << smoothing);
        Ok(Self {
            train: Line { value, register, ..plain },
            divider: [(1 << smoothing) >> 1; AXES],
            position: [0; AXES],
            smoothing,
        })
    }

    /// The line after so many clocks of its source, its dividers and counters in this state,
    /// reachable or not; `register` has n + k stages.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn in_state(
        end: [i32; AXES],
        register: Register,
        smoothing: u32,
        clock: u64,
        passed: [i64; AXES],
        divider: [u64; AXES],
        position: [i64; AXES],
    ) -> Self {
        let value = end.map(|c| u64::from(c.unsigned_abs()) << smoothing);
        let sign = end.map(|c| c.signum() as i8);
        let train = Line { value, sign, position: passed, end, clock, register };
        Self { train, divider, position, smoothing }
    }

    /// One clock of the pulse source; `None` once the multiplier's divider has overflowed.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse<AXES>> {
        let train = self.train.step()?;
        let modulus = 1 << self.smoothing;
        let mut pulse = Pulse::NONE;
        for axis in 0..AXES {
            let sum = self.divider[axis] + u64::from(train.0[axis] != 0);
            let carry = sum >= modulus;
            self.divider[axis] = if carry { sum - modulus } else { sum };
            pulse.0[axis] = if carry { train.0[axis] } else { 0 };
            self.position[axis] += i64::from(pulse.0[axis]);
        }
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// Clocks counted by the multiplier's divider so far, all periods together.
    #[must_use]
    pub const fn clock(&self) -> u64 {
        self.train.clock()
    }

    /// What the dividers behind the trains hold, an axis each.
    #[must_use]
    pub const fn dividers(&self) -> [u64; AXES] {
        self.divider
    }

    /// k, the stages of these dividers.
    #[must_use]
    pub const fn smoothing(&self) -> u32 {
        self.smoothing
    }

    /// The multiplier in front: of n + k stages, its position counted in pulses of the trains.
    #[must_use]
    pub const fn train(&self) -> &Line<AXES> {
        &self.train
    }

    /// Whether all periods are over.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.train.is_done()
    }

    /// Source clocks still to come.
    #[must_use]
    pub const fn remaining(&self) -> u64 {
        self.train.remaining()
    }

    /// The present point, counted from the line's start.
    #[must_use]
    pub const fn position(&self) -> [i64; AXES] {
        self.position
    }

    /// What is missing to the end point: zero when done.
    #[must_use]
    pub fn residual(&self) -> [i64; AXES] {
        core::array::from_fn(|axis| i64::from(self.train.end[axis]) - self.position[axis])
    }

    /// What always holds: the multiplier's own invariant, and each divider has its train's pulses,
    /// passed on or kept.
    #[must_use]
    pub fn invariant(&self) -> bool {
        self.train.invariant() && self.dividers_hold()
    }

    /// The invariant but for the multiplier's: half load and the pulses of the train are 2^k times the
    /// pulses passed on, and the divider's content.
    #[must_use]
    pub fn dividers_hold(&self) -> bool {
        let load = (1 << self.smoothing) >> 1;
        (0..AXES).all(|axis| {
            let train = self.train.position[axis].unsigned_abs();
            let passed = self.position[axis].unsigned_abs() << self.smoothing;
            self.divider[axis] >> self.smoothing == 0 && load + train == passed + self.divider[axis]
        })
    }
}

impl<const AXES: usize> Iterator for Smoothed<AXES> {
    type Item = Pulse<AXES>;

    #[inline]
    fn next(&mut self) -> Option<Pulse<AXES>> {
        self.step()
    }
}
