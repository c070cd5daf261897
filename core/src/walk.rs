//! The way round a circle, step by step: what all machines that judge F share.

use crate::circle::Due;
use crate::pulse::signed;
use crate::{Axis, Feed, Feeds, Pulse, Sweep};

/// The place of a machine on its circle about the origin.
///
/// F = x² + y² − R². A pulse of sign s on coordinate c changes F by 2sc + 1: by −2t + 1 when the
/// coordinate that shrinks in this quadrant is t (it is fed *towards* zero), by 2a + 1 when the one
/// that grows is a (it is fed *away* from zero). Quadrants are crossed by themselves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Walk {
    f: i64,
    /// The coordinate that is fed towards zero in this quadrant, and the one that is fed away
    /// from it: magnitudes.
    point: [i64; 2],
    /// Where each of them stands; out of reach before the last quadrant.
    stop: [i64; 2],
    /// The pulse of each.
    pulse: [Pulse; 2],
    sweep: Sweep,
}

/// The places of the two motions in the arrays of a walk.
pub(crate) const TOWARDS: usize = 0;
/// See [`TOWARDS`].
pub(crate) const AWAY: usize = 1;

impl Walk {
    /// At `start`, where the sweep begins.
    pub(crate) fn new(sweep: Sweep, start: [i32; 2]) -> Self {
        let [x, y] = start.map(|c| i64::from(c).abs());
        let point = if sweep.feeds().towards.axis == Axis::X { [x, y] } else { [y, x] };
        let mut walk = Self { f: 0, point, stop: [0; 2], pulse: [Pulse::NONE; 2], sweep };
        walk.enter_quadrant();
        walk
    }

    /// At this place, reachable or not; `point` holds the magnitudes of the coordinate that is fed
    /// towards zero and of the one that is fed away from it.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn in_state(sweep: Sweep, f: i64, point: [i64; 2]) -> Self {
        let mut walk = Self { f, point, stop: [0; 2], pulse: [Pulse::NONE; 2], sweep };
        walk.enter_quadrant();
        walk
    }

    /// One pulse towards zero or away from it.
    ///
    /// Both feeds are computed and one is chosen: on most circles no processor can predict F's
    /// sign, and a wrong guess costs more than the sums.
    #[inline]
    pub(crate) fn feed(&mut self, feeds_towards: bool) -> Pulse {
        let [towards, away] = self.point;
        let outwards = if feeds_towards { -towards } else { away };
        self.f += 2 * outwards + 1;
        self.point = [towards - i64::from(feeds_towards), away + i64::from(!feeds_towards)];
        if feeds_towards { self.pulse[TOWARDS] } else { self.pulse[AWAY] }
    }

    /// One pulse on both motions together.
    #[inline]
    fn feed_both(&mut self) -> Pulse {
        let [towards, away] = self.point;
        self.f += 2 * (away - towards) + 2;
        self.point = [towards - 1, away + 1];
        let [Pulse([x, y]), Pulse([other_x, other_y])] = self.pulse;
        // They move different axes.
        Pulse([x + other_x, y + other_y])
    }

    /// Goes on into the next quadrant when an axis is reached and this was not the last one: what
    /// was fed away from zero is fed towards it then. Whether it did.
    #[inline]
    pub(crate) fn cross(&mut self) -> bool {
        if self.point[TOWARDS] != 0 {
            return false;
        }
        let crossings = self.sweep.crossings_left();
        let position = self.position();
        self.sweep.arrive(position);
        let crosses = self.sweep.crossings_left() < crossings;
        if crosses {
            self.point.swap(TOWARDS, AWAY);
            self.enter_quadrant();
        }
        crosses
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

    /// Whether each coordinate stands: it is at its end, or past it, in the last quadrant. In the
    /// order of the motions.
    #[inline]
    pub(crate) const fn stands(&self) -> [bool; 2] {
        [self.point[TOWARDS] <= self.stop[TOWARDS], self.point[AWAY] >= self.stop[AWAY]]
    }

    /// What is fed straight to an end point off the circle when both coordinates stand: x first.
    #[inline]
    pub(crate) fn out(&self) -> Feed {
        let Pulse([x, y]) = self.sweep.step_out(self.position());
        if x != 0 { Feed { axis: Axis::X, sign: x } } else { Feed { axis: Axis::Y, sign: y } }
    }

    /// One pulse straight to an end point off the circle.
    #[inline]
    pub(crate) fn step_out(&mut self) -> Feed {
        let feed = self.out();
        let moves_away = self.moves_away(feed);
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
        feed
    }

    /// Whether a feed is along the axis that is fed away from zero in this quadrant.
    #[inline]
    pub(crate) fn moves_away(&self, feed: Feed) -> bool {
        self.sweep.feeds().away.axis == feed.axis
    }

    /// One step of a machine that judges what is due by F and the magnitudes: an axis that stands
    /// at its end coordinate is not fed, the other one is, whatever F says; when both stand, an end
    /// point off the circle is stepped out, x first.
    #[inline]
    pub(crate) fn step(&mut self, judge: impl FnOnce(i64, [i64; 2]) -> Due) -> Pulse {
        let pulse = match self.stands() {
            [false, false] => match judge(self.f, self.point) {
                Due::Both => self.feed_both(),
                due => self.feed(due == Due::Towards),
            },
            [true, true] => {
                let Feed { axis, sign } = self.step_out();
                return Pulse::on(axis, sign);
            }
            [towards_stands, _] => self.feed(!towards_stands),
        };
        self.cross();
        pulse
    }

    /// The deviation function F at the present point.
    #[must_use]
    pub const fn deviation_function(&self) -> i64 {
        self.f
    }

    /// The magnitudes of the coordinate that is fed towards zero in this quadrant, and of the one
    /// that is fed away from it.
    #[inline]
    #[must_use]
    pub const fn magnitudes(&self) -> [i64; 2] {
        self.point
    }

    /// Where the machine is on its way round.
    #[must_use]
    pub const fn sweep(&self) -> &Sweep {
        &self.sweep
    }

    /// Whether this is the end point, on the last piece of the way.
    #[inline]
    #[must_use]
    pub const fn is_at_end(&self) -> bool {
        self.point[TOWARDS] == self.stop[TOWARDS] && self.point[AWAY] == self.stop[AWAY]
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

    /// What is missing to the end point.
    #[must_use]
    pub fn residual(&self) -> [i64; 2] {
        let (end, position) = (self.sweep.end(), self.position());
        [end[0] - position[0], end[1] - position[1]]
    }

    /// Whether F alone decides what is fed next: neither coordinate stands.
    #[inline]
    #[must_use]
    pub fn is_free(&self) -> bool {
        let [towards, away] = self.stands();
        !towards && !away
    }

    /// What always holds of the place, whatever the method: the sweep is right, the stops are this
    /// quadrant's, and magnitudes have no sign.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let [stop, stop_away] = self.stops();
        self.sweep.invariant()
            && (self.stop[TOWARDS] == stop && self.stop[AWAY] == stop_away)
            && (0 <= self.point[TOWARDS] && 0 <= self.point[AWAY])
    }

    /// From the order of the motions to that of the axes.
    #[inline]
    pub(crate) fn by_axis<T: Copy>(&self, [towards, away]: [T; 2]) -> [T; 2] {
        match self.sweep.feeds().towards.axis {
            Axis::X => [towards, away],
            Axis::Y => [away, towards],
        }
    }
}
