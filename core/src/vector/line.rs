//! Straight line by vector discrimination.

use crate::pulse::signed;
use crate::{Axis, Error, Pulse};

/// A line from the origin to `(x_e, y_e)`.
///
/// The longer axis, of length a (x of two that are alike), gets a pulse on every step. V = a·(pulses
/// of the shorter axis) − b·(pulses of the longer one), b the shorter length, is the cross product of
/// the vector to the end and that to the present point, turned so that V > 0 is the shorter axis' side:
/// V ≤ 0 (on the line or short of it) feeds the shorter axis as well and adds a − b, V > 0 takes b. So
/// 1 − b ≤ V ≤ a − b, and V/a, the distance from the line along the shorter axis, is below one pulse;
/// of the a values that V may have, the only multiple of a is 0, and so the line ends exactly.
///
/// ```
/// use onepulse_core::{Pulse, vector::Line};
/// let line = Line::new([5, 3])?;
/// let y = line.map(|Pulse([_, y])| y);
/// assert!(y.eq([1, 0, 1, 0, 1]));
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    v: i64,
    /// Absolute end coordinates.
    end: [u32; 2],
    sign: [i8; 2],
    /// Pulses still to come, an axis each.
    left: [u32; 2],
}

impl Line {
    /// The line to `end`: any `i32` coordinates.
    ///
    /// # Errors
    /// None: every end point is served. (All machines of this crate are built alike.)
    pub fn new(end: [i32; 2]) -> Result<Self, Error> {
        let magnitude = end.map(i32::unsigned_abs);
        let sign = end.map(|c| c.signum() as i8);
        Ok(Self { v: 0, end: magnitude, sign, left: magnitude })
    }

    /// The line to `end` in this state, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn in_state(end: [i32; 2], v: i64, left: [u32; 2]) -> Self {
        let (end, sign) = (end.map(i32::unsigned_abs), end.map(|c| c.signum() as i8));
        Self { v, end, sign, left }
    }

    /// A pulse on the longer axis, or on both; `None` once the end is reached.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        if self.is_done() {
            return None;
        }
        let longer = self.longer();
        let (a, b) = (longer.of(self.end), longer.other().of(self.end));
        // A line along an axis has no other one to feed.
        let feeds_both = self.v <= 0 && b != 0;
        self.v += if feeds_both { i64::from(a) - i64::from(b) } else { -i64::from(b) };
        let feeds = [longer == Axis::X || feeds_both, longer == Axis::Y || feeds_both];
        self.left = [self.left[0] - u32::from(feeds[0]), self.left[1] - u32::from(feeds[1])];
        debug_assert!(self.invariant());
        let pulse = |axis: usize| if feeds[axis] { self.sign[axis] } else { 0 };
        Some(Pulse([pulse(0), pulse(1)]))
    }

    /// The longer axis; x of two that are alike.
    #[inline]
    #[must_use]
    pub const fn longer(&self) -> Axis {
        if self.end[0] >= self.end[1] { Axis::X } else { Axis::Y }
    }

    /// The vector product V at the present point.
    #[must_use]
    pub const fn vector_product(&self) -> i64 {
        self.v
    }

    /// Whether the end is reached.
    #[inline]
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.longer().of(self.left) == 0
    }

    /// Steps still to come.
    #[must_use]
    pub const fn remaining(&self) -> u64 {
        self.longer().of(self.left) as u64
    }

    /// Pulses of each axis between here and the end point.
    #[must_use]
    pub const fn pulses_to_go(&self) -> [u64; 2] {
        [self.left[0] as u64, self.left[1] as u64]
    }

    /// The present point, counted from the line's start.
    #[must_use]
    pub fn position(&self) -> [i64; 2] {
        [0, 1].map(|axis| {
            signed(self.sign[axis], i64::from(self.end[axis]) - i64::from(self.left[axis]))
        })
    }

    /// What is missing to the end point: zero when done.
    #[must_use]
    pub fn residual(&self) -> [i64; 2] {
        [0, 1].map(|axis| signed(self.sign[axis], i64::from(self.left[axis])))
    }

    /// What always holds: 1 − b ≤ V ≤ a − b, V = 0 on an axis, and no more is to go than at the start.
    #[must_use]
    pub const fn invariant(&self) -> bool {
        let longer = self.longer();
        let (a, b) = (longer.of(self.end) as i64, longer.other().of(self.end) as i64);
        (if b == 0 { self.v == 0 } else { 1 - b <= self.v && self.v <= a - b })
            && self.left[0] <= self.end[0]
            && self.left[1] <= self.end[1]
    }
}

impl Iterator for Line {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
