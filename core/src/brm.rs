//! Binary rate multiplier (数字脉冲乘法器, BRM).
//!
//! The pulse source drives an n-stage divider chain. Of its 2ⁿ clocks the stage of weight
//! 2^(n−1) passes 1, 3, 5, …, the next one 2, 6, 10, …, the stage of weight 1 the single clock
//! 2^(n−1). No clock passes two stages, so the stages that an axis' value gates can be joined to
//! one train of exactly `value` pulses.

mod smoothed;

pub use smoothed::Smoothed;

#[cfg(feature = "proofs")]
use crate::pulse::signed;
use crate::{
    Error, Pulse,
    dda::{Radix, Register},
};

/// A line from the origin, any number of axes sharing one divider chain.
///
/// The end is exact, but the trains are uneven: the largest deviation from the line grows with
/// n and exceeds one pulse from n = 5 on (n·√5/10 at x = 1010…b, y = x/2). [`Smoothed`] is the
/// same with a divider behind.
///
/// ```
/// use onepulse_core::{Pulse, brm};
/// let line = brm::Line::new([10, 6], 4)?;
/// let clocks: [bool; 16] = core::array::from_fn({
///     let mut line = line;
///     move |_| line.step().is_some_and(|Pulse([x, _])| x == 1)
/// });
/// assert_eq!(clocks.iter().filter(|pulse| **pulse).count(), 10);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line<const AXES: usize = 2> {
    value: [u64; AXES],
    sign: [i8; AXES],
    position: [i64; AXES],
    end: [i32; AXES],
    clock: u64,
    register: Register,
}

impl<const AXES: usize> Line<AXES> {
    /// The line to `end` with a divider chain of `bits` stages.
    ///
    /// # Errors
    /// Fewer than 1 or more than 32 stages; an end coordinate that the stages cannot hold.
    pub fn new(end: [i32; AXES], bits: u32) -> Result<Self, Error> {
        let register = Register::new(Radix::Binary, bits)?;
        let largest = end.iter().fold(0, |most, c| c.unsigned_abs().max(most));
        let needed = Register::holding(Radix::Binary, largest).digits();
        if bits < needed {
            return Err(Error::RegisterTooNarrow { digits: bits, needed });
        }
        Ok(Self {
            value: end.map(|c| u64::from(c.unsigned_abs())),
            sign: end.map(|c| c.signum() as i8),
            position: [0; AXES],
            end,
            clock: 0,
            register,
        })
    }

    /// The line to `end` after so many clocks.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn after_clocks(end: [i32; AXES], register: Register, clock: u64) -> Self {
        let value = end.map(|c| u64::from(c.unsigned_abs()));
        let sign = end.map(|c| c.signum() as i8);
        let mut line = Self { value, sign, position: [0; AXES], end, clock, register };
        for axis in 0..AXES {
            line.position[axis] = signed(sign[axis], line.passed(axis) as i64);
        }
        line
    }

    /// One clock of the pulse source; `None` once the divider has overflowed.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse<AXES>> {
        if self.is_done() {
            return None;
        }
        let gate = self.gate();
        self.clock += 1;
        let mut pulse = Pulse::NONE;
        for axis in 0..AXES {
            pulse.0[axis] = if self.value[axis] & gate != 0 { self.sign[axis] } else { 0 };
            self.position[axis] += i64::from(pulse.0[axis]);
        }
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// The weight of the stage that passes the next clock; 0 for the clock that overflows the
    /// divider, which no stage passes.
    #[inline]
    #[must_use]
    pub const fn gate(&self) -> u64 {
        let clock = self.clock + 1;
        (self.register.modulus() >> 1) >> clock.trailing_zeros()
    }

    /// Clocks counted by the divider so far.
    #[must_use]
    pub const fn clock(&self) -> u64 {
        self.clock
    }

    /// The gated values: |end|.
    #[must_use]
    pub const fn values(&self) -> [u64; AXES] {
        self.value
    }

    /// The width of the divider.
    #[must_use]
    pub const fn register(&self) -> Register {
        self.register
    }

    /// Whether the divider has overflowed.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.clock == self.register.modulus()
    }

    /// Source clocks still to come.
    #[must_use]
    pub const fn remaining(&self) -> u64 {
        self.register.modulus() - self.clock
    }

    /// The present point, counted from the line's start.
    #[must_use]
    pub const fn position(&self) -> [i64; AXES] {
        self.position
    }

    /// What is missing to the end point: zero when done.
    #[must_use]
    pub fn residual(&self) -> [i64; AXES] {
        core::array::from_fn(|axis| i64::from(self.end[axis]) - self.position[axis])
    }

    /// What always holds: each gated stage has passed the clocks due to it. The stage of weight
    /// 2^(n−1−t) passes a clock whenever the divider's low t + 1 bits become 10…0.
    #[must_use]
    pub fn invariant(&self) -> bool {
        self.clock <= self.register.modulus()
            && (0..AXES).all(|axis| self.position[axis].unsigned_abs() == self.passed(axis))
    }

    /// The clocks that an axis' gated stages have passed.
    fn passed(&self, axis: usize) -> u64 {
        let bits = self.register.digits();
        (0..bits)
            .filter(|t| self.value[axis] >> (bits - 1 - t) & 1 == 1)
            .map(|t| (self.clock + (1 << t)) >> (t + 1))
            .sum()
    }
}

impl<const AXES: usize> Iterator for Line<AXES> {
    type Item = Pulse<AXES>;

    #[inline]
    fn next(&mut self) -> Option<Pulse<AXES>> {
        self.step()
    }
}
