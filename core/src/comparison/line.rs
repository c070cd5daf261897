//! Straight line by comparison integration.

use crate::pulse::signed;
use crate::{Error, Pulse};

/// A line from the origin to `(x_e, y_e)`.
///
/// A pulse of x takes an interval |y_e|, a pulse of y an interval |x_e|, each in the middle of its
/// interval. D is twice the difference between the times at which the next pulses of x and of y are
/// due, |y_e| − |x_e| at the start: D < 0 feeds x and adds 2·|y_e|, D > 0 feeds y and takes 2·|x_e|, and
/// D = 0 feeds both. So 1 − 2·|x_e| ≤ D ≤ 2·|y_e| − 1 off the axes. With F = |x_e|·y − |y_e|·x, D is
/// |y_e| − |x_e| − 2F, and |F| ≤ (|x_e| + |y_e| − 1)/2: the distance |F|/L from the line is below ½√2, and
/// what is nearest to that are lines near the diagonal.
///
/// ```
/// use onepulse_core::{Pulse, comparison::Line};
/// let mut line = Line::new([3, 1])?;
/// assert_eq!(line.step(), Some(Pulse([1, 0])));
/// assert_eq!(line.step(), Some(Pulse([1, 1]))); // level: both are due in the middle
/// assert_eq!(line.step(), Some(Pulse([1, 0])));
/// assert_eq!(line.step(), None);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    d: i64,
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
        let [xe, ye] = magnitude.map(i64::from);
        let sign = end.map(|c| c.signum() as i8);
        Ok(Self { d: ye - xe, end: magnitude, sign, left: magnitude })
    }

    /// The line to `end` in this state, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn in_state(end: [i32; 2], d: i64, left: [u32; 2]) -> Self {
        let (end, sign) = (end.map(i32::unsigned_abs), end.map(|c| c.signum() as i8));
        Self { d, end, sign, left }
    }

    /// A pulse on the axis that is due, or on both; `None` once the end is reached.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        if self.is_done() {
            return None;
        }
        let [xe, ye] = self.end.map(i64::from);
        let (feeds_x, feeds_y) = (self.d <= 0, self.d >= 0);
        self.d += if feeds_x { 2 * ye } else { 0 };
        self.d -= if feeds_y { 2 * xe } else { 0 };
        self.left = [self.left[0] - u32::from(feeds_x), self.left[1] - u32::from(feeds_y)];
        debug_assert!(self.invariant());
        let [x, y] = self.sign;
        Some(Pulse([if feeds_x { x } else { 0 }, if feeds_y { y } else { 0 }]))
    }

    /// D, twice the time by which the next pulse of x is due before (below 0) or after that of y.
    #[must_use]
    pub const fn difference(&self) -> i64 {
        self.d
    }

    /// Whether the end is reached.
    #[inline]
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.left[0] == 0 && self.left[1] == 0
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

    /// What always holds: 1 − 2·|x_e| ≤ D ≤ 2·|y_e| − 1, or on an axis D as it was at the start, and no
    /// more is to go than then.
    #[must_use]
    pub const fn invariant(&self) -> bool {
        let [xe, ye] = [self.end[0] as i64, self.end[1] as i64];
        let is_on_axis = xe == 0 || ye == 0;
        (if is_on_axis { self.d == ye - xe } else { -2 * xe < self.d && self.d < 2 * ye })
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
