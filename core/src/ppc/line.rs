//! Straight line by point-by-point comparison.

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

    /// One step of four beats; `None` once the end rule is met.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        if self.is_done() {
            return None;
        }
        let axis = self.judge();
        let fed = axis.index();
        match axis {
            Axis::X => self.f -= i64::from(self.end[1]),
            Axis::Y => self.f += i64::from(self.end[0]),
        }
        self.left[fed] -= 1;
        debug_assert!(self.invariant());
        Some(Pulse::on(axis, self.sign[fed]))
    }

    /// The axis that the next step feeds.
    ///
    /// F alone decides but for one case: on the line x_e = 0, F is 0 throughout and the plain
    /// rule would feed x for ever. An axis whose pulses are used up is never fed.
    #[inline]
    #[must_use]
    pub const fn judge(&self) -> Axis {
        if self.f >= 0 && self.left[0] > 0 || self.left[1] == 0 { Axis::X } else { Axis::Y }
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
        [0, 1].map(|axis| i64::from(self.sign[axis]) * i64::from(self.end[axis] - self.left[axis]))
    }

    /// What is missing to the end point: zero when done, but under [`EndRule::Larger`] the
    /// shorter axis may be left short.
    #[must_use]
    pub fn residual(&self) -> [i64; 2] {
        [0, 1].map(|axis| i64::from(self.sign[axis]) * i64::from(self.left[axis]))
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

    const fn larger(&self) -> usize {
        if self.end[0] >= self.end[1] { 0 } else { 1 }
    }
}

impl Iterator for Line {
    type Item = Pulse;

    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
