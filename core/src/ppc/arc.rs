//! Circular arc by point-by-point comparison.

use crate::pulse::signed;
use crate::{Axis, Direction, EndRule, Error, Feed, Feeds, Pulse, Sweep};

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
    f: i64,
    /// The coordinate that is fed towards zero in this quadrant, and the one that is fed away
    /// from it: magnitudes.
    point: [i64; 2],
    /// Where each of them stands; out of reach before the last quadrant.
    stop: [i64; 2],
    /// The pulse of each.
    pulse: [Pulse; 2],
    /// Pulses of each still to come.
    left: [u64; 2],
    /// The axis that had more of them at the start of the arc.
    larger: Axis,
    rule: EndRule,
    sweep: Sweep,
}

/// The places of the two motions in the arrays above.
const TOWARDS: usize = 0;
const AWAY: usize = 1;

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
        let [x, y] = start.map(|c| i64::from(c).abs());
        let point = if sweep.feeds().towards.axis == Axis::X { [x, y] } else { [y, x] };
        let mut arc = Self {
            f: 0,
            point,
            stop: [0; 2],
            pulse: [Pulse::NONE; 2],
            left: sweep.way_left(point),
            larger: Axis::X,
            rule,
            sweep,
        };
        let [x, y] = arc.pulses_to_go();
        arc.larger = if x >= y { Axis::X } else { Axis::Y };
        arc.enter_quadrant();
        arc
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
        let (stop, pulse, left) = ([0; 2], [Pulse::NONE; 2], sweep.way_left(point));
        let mut arc = Self { f, point, stop, pulse, left, larger, rule, sweep };
        arc.enter_quadrant();
        arc
    }

    /// One step of four beats; `None` once the end rule is met.
    ///
    /// Both feeds are computed and one is chosen, as for the line.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        if self.is_done() {
            return None;
        }
        let stands = self.stands();
        if stands == [true, true] {
            return Some(self.step_out());
        }
        let feeds_towards = self.f >= 0 && !stands[TOWARDS] || stands[AWAY];
        let [towards, away] = self.point;
        let outwards = if feeds_towards { -towards } else { away };
        self.f += 2 * outwards + 1;
        self.point = [towards - i64::from(feeds_towards), away + i64::from(!feeds_towards)];
        self.left[TOWARDS] -= u64::from(feeds_towards);
        self.left[AWAY] -= u64::from(!feeds_towards);
        let pulse = if feeds_towards { self.pulse[TOWARDS] } else { self.pulse[AWAY] };
        if self.point[TOWARDS] == 0 {
            self.cross();
        }
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// Whether each coordinate stands: it is at its end, or past it, in the last quadrant.
    #[inline]
    const fn stands(&self) -> [bool; 2] {
        [self.point[TOWARDS] <= self.stop[TOWARDS], self.point[AWAY] >= self.stop[AWAY]]
    }

    /// Goes on into the next quadrant, if this was not the last: what was fed away from zero is
    /// fed towards it now.
    #[inline]
    fn cross(&mut self) {
        let crossings = self.sweep.crossings_left();
        let position = Self::position(self);
        self.sweep.arrive(position);
        if self.sweep.crossings_left() < crossings {
            self.point.swap(TOWARDS, AWAY);
            self.left.swap(TOWARDS, AWAY);
            self.enter_quadrant();
        }
    }

    #[inline]
    fn enter_quadrant(&mut self) {
        let Feeds { towards, away } = self.sweep.feeds();
        self.pulse = [towards, away].map(|feed| Pulse::on(feed.axis, feed.sign));
        self.stop = self.stops();
    }

    /// Where each coordinate stands in this quadrant.
    #[inline]
    fn stops(&self) -> [i64; 2] {
        let Feeds { towards, away } = self.sweep.feeds();
        if self.sweep.crossings_left() > 0 {
            [i64::MIN, i64::MAX]
        } else {
            [towards, away].map(|feed| feed.axis.of(self.sweep.end()).abs())
        }
    }

    /// One pulse straight to an end point off the circle, x first.
    #[inline]
    fn step_out(&mut self) -> Pulse {
        let Feed { axis, sign } = self.judge();
        let moves_away = self.sweep.feeds().away.axis == axis;
        let (c, stop) = if moves_away {
            (self.point[AWAY], self.stop[AWAY])
        } else {
            (self.point[TOWARDS], self.stop[TOWARDS])
        };
        let outwards = c < stop;
        self.f += 2 * if outwards { c } else { -c } + 1;
        let step = if outwards { 1 } else { -1 };
        self.point[AWAY] += if moves_away { step } else { 0 };
        self.point[TOWARDS] += if moves_away { 0 } else { step };
        self.left[AWAY] -= u64::from(moves_away);
        self.left[TOWARDS] -= u64::from(!moves_away);
        debug_assert!(self.invariant());
        Pulse::on(axis, sign)
    }

    /// The motion that the next step makes.
    ///
    /// F decides while both axes are on their way. In the last quadrant an axis that stands at
    /// its end coordinate is not fed; when both stand, an end point off the circle is stepped
    /// out, x first.
    #[inline]
    #[must_use]
    pub fn judge(&self) -> Feed {
        let feeds = self.sweep.feeds();
        match self.stands() {
            [false, false] if self.f >= 0 => feeds.towards,
            [false, true] => feeds.towards,
            [_, false] => feeds.away,
            [true, true] => {
                let Pulse([x, y]) = self.sweep.step_out(self.position());
                if x != 0 {
                    Feed { axis: Axis::X, sign: x }
                } else {
                    Feed { axis: Axis::Y, sign: y }
                }
            }
        }
    }

    /// The deviation function F at the present point.
    #[must_use]
    pub const fn deviation_function(&self) -> i64 {
        self.f
    }

    /// Where the arc is on its way round.
    #[must_use]
    pub const fn sweep(&self) -> &Sweep {
        &self.sweep
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
        self.by_axis(self.left)
    }

    /// The present point.
    #[inline]
    #[must_use]
    pub fn position(&self) -> [i64; 2] {
        // What is fed towards zero lies on the side that its pulses come from.
        let Feeds { towards, away } = self.sweep.feeds();
        let towards = signed(-towards.sign, self.point[TOWARDS]);
        let away = signed(away.sign, self.point[AWAY]);
        self.by_axis([towards, away])
    }

    /// What is missing to the end point: zero when done, but under [`EndRule::Larger`] the other
    /// axis may be left short.
    #[must_use]
    pub fn residual(&self) -> [i64; 2] {
        let (end, position) = (self.sweep.end(), self.position());
        [end[0] - position[0], end[1] - position[1]]
    }

    /// What always holds: the counters hold the pulses of the way that is left, and while F
    /// alone decides, −2R' < F ≤ 2R', where R' is the largest coordinate on the way. The
    /// coordinate that is fed towards zero has not come there yet, but for the circle of radius 1,
    /// which steps through its centre.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let peak = self.sweep.peak();
        let [towards, away] = self.point;
        let [to_go, to_go_away] = self.sweep.way_left(self.point);
        let [stop, stop_away] = self.stops();
        let [stands, stands_away] = self.stands();
        self.sweep.invariant()
            && (self.left[TOWARDS] == to_go && self.left[AWAY] == to_go_away)
            && (self.stop[TOWARDS] == stop && self.stop[AWAY] == stop_away)
            && (0 <= towards && 0 <= away)
            && (stands
                || stands_away
                || (-2 * peak < self.f && self.f <= 2 * peak)
                    && (towards <= peak && away <= peak)
                    && (towards > 0 || away == 0 && peak == 1))
    }

    /// Whether the counters hold the pulses of the way that is left.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn counters_hold(&self) -> bool {
        let [towards, away] = self.sweep.way_left(self.point);
        self.left[TOWARDS] == towards && self.left[AWAY] == away
    }

    /// The axis that had more pulses to go at the start of the arc.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn larger(&self) -> Axis {
        self.larger
    }

    /// From the order of the motions to that of the axes.
    #[inline]
    fn by_axis<T: Copy>(&self, [towards, away]: [T; 2]) -> [T; 2] {
        match self.sweep.feeds().towards.axis {
            Axis::X => [towards, away],
            Axis::Y => [away, towards],
        }
    }
}

impl Iterator for Arc {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
