//! The sweep of an arc: quadrant after quadrant until the one it ends in.

use crate::{Axis, Direction, Error, Feed, Feeds, Pulse, Quadrant};

/// Where an arc is on its way round: automatic quadrant crossing (自动过象限) and the end test.
///
/// An arc about the origin sweeps more than 0 and at most a full turn; an end in the start's
/// own direction means a full turn. Between two coordinate axes its path is monotone in x and
/// in y. In the last such piece each axis *stands* at its end coordinate (the rule of two end
/// counters); when both stand, what an end point off the circle still lacks is stepped out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sweep {
    direction: Direction,
    quadrant: Quadrant,
    feeds: Feeds,
    crossings_left: u8,
    end: [i64; 2],
    peak: i64,
    radius_rounded_up: u64,
}

impl Sweep {
    /// The sweep from `start` to `end` about the origin.
    ///
    /// # Errors
    /// A start or an end in the origin, or a circle through `start` that leaves the `i32`
    /// coordinates.
    pub fn new(start: [i32; 2], end: [i32; 2], direction: Direction) -> Result<Self, Error> {
        let radius_squared = radius_squared(start);
        let most = i64::from(i32::MAX).unsigned_abs();
        if radius_squared > most * most {
            return Err(Error::CircleTooLarge { start });
        }
        let peak = peak(radius_squared) as i64;
        Self::with_roots(start, end, direction, peak, root_rounded_up(radius_squared))
    }

    /// The sweep on a circle whose roots are known.
    fn with_roots(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        peak: i64,
        radius_rounded_up: u64,
    ) -> Result<Self, Error> {
        let from = start.map(i64::from);
        let to = end.map(i64::from);
        let first = Quadrant::entered(from, direction).ok_or(Error::StartInCentre)?;
        let last = Quadrant::left(to, direction).ok_or(Error::EndInCentre)?;
        let mut crossings_left = first.quarters_to(last, direction);
        if crossings_left == 0 && !is_ahead(from, to, direction) {
            crossings_left = 4;
        }
        Ok(Self {
            direction,
            quadrant: first,
            feeds: first.feeds(direction),
            crossings_left,
            end: to,
            peak,
            radius_rounded_up,
        })
    }

    /// The sweep as [`Sweep::new`] makes it, but for the roots, which are given: the largest
    /// coordinate of point-by-point comparison, and R rounded up.
    #[cfg(feature = "proofs")]
    pub fn with_given_roots(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        peak: i64,
        radius_rounded_up: u64,
    ) -> Result<Self, Error> {
        Self::with_roots(start, end, direction, peak, radius_rounded_up)
    }

    /// The sweep in this state, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(
        direction: Direction,
        quadrant: Quadrant,
        crossings_left: u8,
        end: [i64; 2],
        peak: i64,
        radius_rounded_up: u64,
    ) -> Self {
        let feeds = quadrant.feeds(direction);
        Self { direction, quadrant, feeds, crossings_left, end, peak, radius_rounded_up }
    }

    /// The sense of the arc.
    #[must_use]
    pub const fn direction(&self) -> Direction {
        self.direction
    }

    /// The quadrant that the arc is in.
    #[must_use]
    pub const fn quadrant(&self) -> Quadrant {
        self.quadrant
    }

    /// The motions in this quadrant.
    #[must_use]
    pub const fn feeds(&self) -> Feeds {
        self.feeds
    }

    /// How many coordinate axes are still to be crossed: 0 in the last quadrant, 4 at most.
    #[must_use]
    pub const fn crossings_left(&self) -> u8 {
        self.crossings_left
    }

    /// The end point.
    #[must_use]
    pub const fn end(&self) -> [i64; 2] {
        self.end
    }

    /// The largest coordinate that point-by-point comparison reaches on this circle.
    #[must_use]
    pub const fn peak(&self) -> i64 {
        self.peak
    }

    /// R, rounded up.
    #[must_use]
    pub const fn radius_rounded_up(&self) -> u64 {
        self.radius_rounded_up
    }

    /// A bound on every coordinate of the circle and of the end point: R, rounded up.
    #[must_use]
    pub fn largest_coordinate(&self) -> u64 {
        let end = self.end[0].unsigned_abs().max(self.end[1].unsigned_abs());
        self.radius_rounded_up.max(end)
    }

    /// Whether each axis stands: it is at its end coordinate, or past it, in the last quadrant.
    #[inline]
    #[must_use]
    pub fn stands(&self, position: [i64; 2]) -> [bool; 2] {
        if self.crossings_left > 0 {
            return [false; 2];
        }
        let Feeds { towards, away } = self.feeds;
        let stands = |feed: Feed| {
            let to_go = feed.axis.of(self.end) - feed.axis.of(position);
            if feed.sign > 0 { to_go <= 0 } else { to_go >= 0 }
        };
        match towards.axis {
            Axis::X => [stands(towards), stands(away)],
            Axis::Y => [stands(away), stands(towards)],
        }
    }

    /// Moves on to the next quadrant when `position` has reached the axis that leads into it.
    ///
    /// The circle of radius 1 steps through its centre, which is in no quadrant: the one being
    /// left is kept there.
    #[inline]
    pub fn arrive(&mut self, position: [i64; 2]) {
        if self.feeds.towards.axis.of(position) == 0
            && self.feeds.away.axis.of(position) != 0
            && self.crossings_left > 0
        {
            self.quadrant = self.quadrant.next(self.direction);
            self.feeds = self.quadrant.feeds(self.direction);
            self.crossings_left -= 1;
        }
    }

    /// Whether integration has nothing more to do: both axes stand, or one stands on a coordinate
    /// axis, where it would feed the other nothing for ever.
    #[inline]
    #[must_use]
    pub fn is_stepping_out(&self, position: [i64; 2]) -> bool {
        match self.stands(position) {
            [true, true] => true,
            [true, false] => position[0] == 0,
            [false, true] => position[1] == 0,
            [false, false] => false,
        }
    }

    /// One pulse on every axis that is not at its end coordinate, straight towards it: how an
    /// end point off the circle is reached when both axes stand.
    #[must_use]
    pub fn step_out(&self, position: [i64; 2]) -> Pulse {
        let sign = |axis: usize| (self.end[axis] - position[axis]).signum() as i8;
        Pulse([sign(0), sign(1)])
    }

    /// The pulses of each axis from `position` to the end, where each crossing is made at the
    /// point of the axis at which point-by-point comparison makes it (exact for that method, and
    /// for every method in the last quadrant).
    #[must_use]
    pub fn pulses_to_go(&self, position: [i64; 2]) -> [u64; 2] {
        let [x, y] = position;
        match self.feeds.towards.axis {
            Axis::X => self.way_left([x.abs(), y.abs()]),
            Axis::Y => {
                let [towards, away] = self.way_left([y.abs(), x.abs()]);
                [away, towards]
            }
        }
    }

    /// The same from the magnitudes of the coordinate that is fed towards zero and of the one that
    /// is fed away from it, in their order.
    pub(crate) fn way_left(&self, [towards, away]: [i64; 2]) -> [u64; 2] {
        let is_swapped = self.crossings_left % 2 == 1;
        let last_towards = if is_swapped { self.feeds.away } else { self.feeds.towards };
        let last_away = if is_swapped { self.feeds.towards } else { self.feeds.away };
        let stop = [last_towards, last_away].map(|feed| feed.axis.of(self.end).abs());
        if self.crossings_left == 0 {
            return [towards.abs_diff(stop[0]), away.abs_diff(stop[1])];
        }
        // To the first crossing, through whole quadrants, and from the last crossing to the end.
        // What is fed towards zero in one quadrant is fed away from it in the next.
        let peak = self.peak;
        let whole = match self.crossings_left {
            1 => 0,
            2 => peak,
            3 => peak + peak,
            _ => peak + peak + peak,
        }
        .unsigned_abs();
        let [first, second] = [peak.abs_diff(stop[0]), stop[1].unsigned_abs()];
        let last = if is_swapped { [second, first] } else { [first, second] };
        [towards.unsigned_abs() + whole + last[0], peak.abs_diff(away) + whole + last[1]]
    }

    /// What always holds: the quadrant's motions are the stored ones, the sweep is at most a
    /// turn, and the last quadrant is the end point's.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let mut quadrant = self.quadrant;
        for _ in 0..self.crossings_left {
            quadrant = quadrant.next(self.direction);
        }
        self.crossings_left <= 4
            && self.feeds == self.quadrant.feeds(self.direction)
            && Quadrant::left(self.end, self.direction) == Some(quadrant)
    }
}

/// Whether `to` lies ahead of `from` on an arc in this direction, both in one quadrant.
fn is_ahead(from: [i64; 2], to: [i64; 2], direction: Direction) -> bool {
    let turn = from[0] * to[1] - from[1] * to[0];
    match direction {
        Direction::Ccw => turn > 0,
        Direction::Cw => turn < 0,
    }
}

/// The largest coordinate that point-by-point comparison reaches: it turns into the last column
/// before an axis, at 1, and leaves that column at the first c with c² + 1 ≥ R².
fn peak(radius_squared: u64) -> u64 {
    match radius_squared {
        0 | 1 => radius_squared,
        _ => root_rounded_up(radius_squared - 1),
    }
}

fn root_rounded_up(value: u64) -> u64 {
    let root = value.isqrt();
    root + u64::from(root * root < value)
}

fn radius_squared([x, y]: [i32; 2]) -> u64 {
    let square = |c: i32| u64::from(c.unsigned_abs()) * u64::from(c.unsigned_abs());
    square(x) + square(y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn full_turns_and_short_ways() {
        let crossings = |start, end, direction| {
            Sweep::new(start, end, direction).map(|sweep| sweep.crossings_left())
        };
        use Direction::{Ccw, Cw};
        assert_eq!(crossings([5, 0], [5, 0], Ccw), Ok(3));
        assert_eq!(crossings([3, 4], [3, 4], Cw), Ok(4));
        assert_eq!(crossings([3, 4], [3, 4], Ccw), Ok(4));
        assert_eq!(crossings([5, 0], [0, 5], Ccw), Ok(0));
        assert_eq!(crossings([5, 0], [0, 5], Cw), Ok(2));
        assert_eq!(crossings([3, 4], [4, 3], Cw), Ok(0));
        assert_eq!(crossings([3, 4], [4, 3], Ccw), Ok(4));
        assert_eq!(crossings([5, 0], [6, 0], Ccw), Ok(3));
    }

    #[test]
    fn roots_are_rounded_up() {
        for start in (0..40).flat_map(|x| (1..40).map(move |y| [x, y])) {
            let sweep = Sweep::new(start, start, Direction::Ccw).unwrap();
            let squared = radius_squared(start);
            let radius = sweep.radius_rounded_up();
            assert!((radius - 1).pow(2) < squared && squared <= radius.pow(2));
            let peak = sweep.peak() as u64;
            let is_before = (peak - 1).pow(2) + 1 < squared;
            assert!(is_before == (squared > 1) && squared <= peak.pow(2) + 1);
        }
    }

    #[test]
    fn what_has_no_circle_is_refused() {
        let new = |start, end| Sweep::new(start, end, Direction::Ccw).unwrap_err();
        assert_eq!(new([0, 0], [1, 0]), Error::StartInCentre);
        assert_eq!(new([1, 0], [0, 0]), Error::EndInCentre);
        let start = [i32::MIN, 0];
        assert_eq!(new(start, [1, 0]), Error::CircleTooLarge { start });
        let start = [1 << 30, 1 << 29];
        assert!(Sweep::new(start, [1, 0], Direction::Cw).is_ok());
        let start = [i32::MAX, 1];
        assert_eq!(new(start, start), Error::CircleTooLarge { start });
        assert!(Sweep::new([i32::MAX, 0], [0, i32::MAX], Direction::Cw).is_ok());
    }
}
