//! Circular arc by point-by-point comparison.

use crate::walk::{AWAY, TOWARDS, Walk};
use crate::{Axis, Direction, EndRule, Error, Feed, Pulse, Sweep};

/// An arc about the origin, any sweep up to a full turn.
///
/// F = x² + y² − R²: F ≥ 0 (on the circle or outside) feeds the axis that leads towards a
/// coordinate axis and so into the circle; F < 0 feeds the one that leads out. A pulse of sign s
/// on coordinate c changes F by 2sc + 1, and quadrants are crossed by themselves. Always
/// (R − 1)² ≤ x² + y² ≤ (R + 1)²: one pulse at most.
///
/// The path runs through every lattice point of its circle within the sweep. An end point off
/// the circle (a program rounded to pulses) is reached too: see [`Sweep`].
///
/// ```
/// use onepulse_core::{Direction, EndRule, ppc};
/// let arc = ppc::Arc::new([5, 0], [0, 5], Direction::Ccw, EndRule::Total)?;
/// assert_eq!(arc.count(), 10);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arc {
    walk: Walk,
    /// Pulses of each motion still to come.
    left: [u64; 2],
    /// The axis that had more of them at the start of the arc.
    larger: Axis,
    rule: EndRule,
}

impl Arc {
    /// The arc from `start` to `end`; equal ends mean a full circle.
    ///
    /// # Errors
    /// As [`Sweep::new`].
    pub fn new(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        rule: EndRule,
    ) -> Result<Self, Error> {
        Ok(Self::along(Sweep::new(start, end, direction)?, start, rule))
    }

    /// The arc from `start` along a sweep that begins there.
    fn along(sweep: Sweep, start: [i32; 2], rule: EndRule) -> Self {
        let walk = Walk::new(sweep, start);
        let left = sweep.way_left(walk.magnitudes());
        let [x, y] = walk.by_axis(left);
        Self { walk, left, larger: if x >= y { Axis::X } else { Axis::Y }, rule }
    }

    /// The arc from `start` along a sweep that begins there: [`Arc::new`] without its roots.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn along_given(sweep: Sweep, start: [i32; 2], rule: EndRule) -> Self {
        Self::along(sweep, start, rule)
    }

    /// The arc at this place, reachable or not; `point` holds the magnitudes of the coordinate that
    /// is fed towards zero and of the one that is fed away from it.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn in_state(sweep: Sweep, rule: EndRule, larger: Axis, f: i64, point: [i64; 2]) -> Self {
        let walk = Walk::in_state(sweep, f, point);
        Self { walk, left: sweep.way_left(point), larger, rule }
    }

    /// One step of four beats; `None` once the end rule is met.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        if self.is_done() {
            return None;
        }
        let stands = self.walk.stands();
        if stands == [true, true] {
            return Some(self.step_out());
        }
        let feeds_towards = self.walk.deviation_function() >= 0 && !stands[TOWARDS] || stands[AWAY];
        let pulse = self.walk.feed(feeds_towards);
        self.left[TOWARDS] -= u64::from(feeds_towards);
        self.left[AWAY] -= u64::from(!feeds_towards);
        if self.walk.cross() {
            self.left.swap(TOWARDS, AWAY);
        }
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// One pulse straight to an end point off the circle, x first.
    #[inline]
    fn step_out(&mut self) -> Pulse {
        let feed = self.walk.step_out();
        let moves_away = self.walk.moves_away(feed);
        self.left[AWAY] -= u64::from(moves_away);
        self.left[TOWARDS] -= u64::from(!moves_away);
        debug_assert!(self.invariant());
        Pulse::on(feed.axis, feed.sign)
    }

    /// The motion that the next step makes.
    ///
    /// F decides while both axes are on their way. In the last quadrant an axis that stands at
    /// its end coordinate is not fed; when both stand, an end point off the circle is stepped
    /// out, x first.
    #[inline]
    #[must_use]
    pub fn judge(&self) -> Feed {
        let feeds = self.sweep().feeds();
        match self.walk.stands() {
            [false, false] if self.deviation_function() >= 0 => feeds.towards,
            [false, true] => feeds.towards,
            [_, false] => feeds.away,
            [true, true] => self.walk.out(),
        }
    }

    /// The deviation function F at the present point.
    #[must_use]
    pub const fn deviation_function(&self) -> i64 {
        self.walk.deviation_function()
    }

    /// Where the arc is on its way round.
    #[must_use]
    pub const fn sweep(&self) -> &Sweep {
        self.walk.sweep()
    }

    /// Whether the end rule is met.
    #[inline]
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.rule.is_met(self.pulses_to_go(), self.larger)
    }

    /// What the counters of the end rule still hold, in pulses.
    #[must_use]
    pub fn remaining(&self) -> u64 {
        self.rule.remaining(self.pulses_to_go(), self.larger)
    }

    /// Pulses of each axis between here and the end point.
    #[inline]
    #[must_use]
    pub fn pulses_to_go(&self) -> [u64; 2] {
        self.walk.by_axis(self.left)
    }

    /// The present point.
    #[inline]
    #[must_use]
    pub fn position(&self) -> [i64; 2] {
        self.walk.position()
    }

    /// What is missing to the end point: zero when done, but under [`EndRule::Larger`] the other
    /// axis may be left short.
    #[must_use]
    pub fn residual(&self) -> [i64; 2] {
        self.walk.residual()
    }

    /// What always holds: the counters hold the pulses of the way that is left, and while F
    /// alone decides, −2R' < F ≤ 2R', where R' is the largest coordinate on the way. The
    /// coordinate that is fed towards zero has not come there yet, but for the circle of radius 1,
    /// which steps through its centre.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let peak = self.sweep().peak();
        let point = self.walk.magnitudes();
        let [towards, away] = point;
        let f = self.deviation_function();
        let [to_go, to_go_away] = self.sweep().way_left(point);
        self.walk.invariant()
            && (self.left[TOWARDS] == to_go && self.left[AWAY] == to_go_away)
            && (!self.walk.is_free()
                || (-2 * peak < f && f <= 2 * peak)
                    && (towards <= peak && away <= peak)
                    && (towards > 0 || away == 0 && peak == 1))
    }

    /// Whether the counters hold the pulses of the way that is left.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn counters_hold(&self) -> bool {
        let [towards, away] = self.sweep().way_left(self.walk.magnitudes());
        self.left[TOWARDS] == towards && self.left[AWAY] == away
    }

    /// The axis that had more pulses to go at the start of the arc.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn larger(&self) -> Axis {
        self.larger
    }
}

impl Iterator for Arc {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
