//! Straight line by point-by-point comparison.

use crate::pulse::signed;
use crate::{Axis, EndRule, Error, Pulse};

/// A line from the origin to `(x_e, y_e)`.
///
/// F = |x_e|·y − |y_e|·x in absolute coordinates: F ≥ 0 (on the line or above it) feeds x and
/// takes |y_e| from F; F < 0 feeds y and adds |x_e|. Always −|y_e| ≤ F ≤ |x_e|, and as |F|/L is
/// the distance from the line, that is at most one pulse.
///
/// ```
/// use onepulse_core::{EndRule, ppc};
/// let mut line = ppc::Line::new([3, -5], EndRule::Total)?;
/// while line.step().is_some() {}
/// assert_eq!(line.position(), [3, -5]);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    f: i64,
    /// Absolute end coordinates.
    end: [u32; 2],
    sign: [i8; 2],
    /// Pulses still to come, an axis each.
    left: [u32; 2],
    rule: EndRule,
}

impl Line {
    /// The line to `end`: any `i32` coordinates, those on an axis and the origin itself too.
    ///
    /// # Errors
    /// None: every end point is served. (All machines of this crate are built alike.)
    pub fn new(end: [i32; 2], rule: EndRule) -> Result<Self, Error> {
        let magnitude = end.map(i32::unsigned_abs);
        Ok(Self {
            f: 0,
            end: magnitude,
            sign: end.map(|c| c.signum() as i8),
            left: magnitude,
            rule,
        })
    }

    /// The line to `end` in this state, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn in_state(end: [i32; 2], rule: EndRule, f: i64, left: [u32; 2]) -> Self {
        let (end, sign) = (end.map(i32::unsigned_abs), end.map(|c| c.signum() as i8));
        Self { f, end, sign, left, rule }
    }

    /// One step of four beats; `None` once the end rule is met.
    ///
    /// Both feeds are computed and one is chosen: on most lines no processor can predict F's
    /// sign, and a wrong guess costs more than the sums.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        if self.is_done() {
            return None;
        }
        let feeds_x = self.judge() == Axis::X;
        let [xe, ye] = self.end.map(i64::from);
        self.f += if feeds_x { -ye } else { xe };
        self.left[0] -= u32::from(feeds_x);
        self.left[1] -= u32::from(!feeds_x);
        debug_assert!(self.invariant());
        let [x, y] = self.sign;
        Some(Pulse([if feeds_x { x } else { 0 }, if feeds_x { 0 } else { y }]))
    }

    /// The axis that the next step feeds.
    ///
    /// F alone decides but for one case: on the line x_e = 0, F is 0 throughout and the plain
    /// rule would feed x for ever. (Elsewhere an axis whose pulses are used up is never due: with
    /// x at its end F < 0, with y at its end F ≥ 0.)
    #[inline]
    #[must_use]
    pub const fn judge(&self) -> Axis {
        if self.f >= 0 && self.end[0] != 0 { Axis::X } else { Axis::Y }
    }

    /// The deviation function F at the present point.
    #[must_use]
    pub const fn deviation_function(&self) -> i64 {
        self.f
    }

    /// Whether the end rule is met.
    #[inline]
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.rule.is_met(self.pulses_to_go(), self.larger())
    }

    /// What the counters of the end rule still hold, in pulses.
    #[must_use]
    pub const fn remaining(&self) -> u64 {
        self.rule.remaining(self.pulses_to_go(), self.larger())
    }

    /// Pulses of each axis between here and the end point.
    #[must_use]
    pub const fn pulses_to_go(&self) -> [u64; 2] {
        [self.left[0] as u64, self.left[1] as u64]
    }

    /// The present point, counted from the line's start.
    #[must_use]
    pub fn position(&self) -> [i64; 2] {
        [0, 1].map(|axis| signed(self.sign[axis], i64::from(self.end[axis] - self.left[axis])))
    }

    /// What is missing to the end point: zero when done, but under [`EndRule::Larger`] the
    /// shorter axis may be left short.
    #[must_use]
    pub fn residual(&self) -> [i64; 2] {
        [0, 1].map(|axis| signed(self.sign[axis], i64::from(self.left[axis])))
    }

    /// What always holds: −|y_e| ≤ F ≤ |x_e|, and no axis has more pulses to go than it began
    /// with.
    #[must_use]
    pub const fn invariant(&self) -> bool {
        -(self.end[1] as i64) <= self.f
            && self.f <= self.end[0] as i64
            && self.left[0] <= self.end[0]
            && self.left[1] <= self.end[1]
    }

    #[inline]
    const fn larger(&self) -> Axis {
        if self.end[0] >= self.end[1] { Axis::X } else { Axis::Y }
    }
}

impl Iterator for Line {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
