//! Quadrants, the sense of an arc, and which axis an arc feeds where.

use crate::Axis;

/// The sense in which an arc runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Clockwise (顺圆, SR; G02).
    Cw,
    /// Counter-clockwise (逆圆, NR; G03).
    Ccw,
}

/// One quarter of the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quadrant {
    /// x > 0, y > 0.
    I,
    /// x < 0, y > 0.
    II,
    /// x < 0, y < 0.
    III,
    /// x > 0, y < 0.
    IV,
}

/// A motion along one axis: the axis and the sign of its pulses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Feed {
    /// The axis that moves.
    pub axis: Axis,
    /// +1 or −1.
    pub sign: i8,
}

/// The two motions that an arc makes in one quadrant.
///
/// In every quadrant one coordinate shrinks (its axis is fed *towards* zero, which leads into
/// the circle) and the other grows (its axis is fed *away* from zero, out of the circle).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Feeds {
    /// The motion that takes its coordinate towards zero: the feed for F ≥ 0.
    pub towards: Feed,
    /// The motion that takes its coordinate away from zero: the feed for F < 0.
    pub away: Feed,
}

impl Quadrant {
    /// The quadrant of a point, where a point on an axis belongs to the quadrant that an arc in
    /// this direction is about to enter. The centre is in none.
    #[must_use]
    pub const fn entered([x, y]: [i64; 2], direction: Direction) -> Option<Self> {
        Some(match direction {
            Direction::Ccw => match (x, y) {
                (1.., 0..) => Self::I,
                (..=0, 1..) => Self::II,
                (..=-1, ..=0) => Self::III,
                (0.., ..=-1) => Self::IV,
                (0, 0) => return None,
            },
            Direction::Cw => match (x, y) {
                (0.., 1..) => Self::I,
                (..=-1, 0..) => Self::II,
                (..=0, ..=-1) => Self::III,
                (1.., ..=0) => Self::IV,
                (0, 0) => return None,
            },
        })
    }

    /// The quadrant of a point, where a point on an axis belongs to the quadrant that an arc in
    /// this direction has just crossed. The centre is in none.
    #[must_use]
    pub const fn left(point: [i64; 2], direction: Direction) -> Option<Self> {
        Self::entered(point, direction.reversed())
    }

    /// The quadrant after this one on an arc in this direction.
    #[must_use]
    pub const fn next(self, direction: Direction) -> Self {
        match (self, direction) {
            (Self::I, Direction::Ccw) | (Self::III, Direction::Cw) => Self::II,
            (Self::II, Direction::Ccw) | (Self::IV, Direction::Cw) => Self::III,
            (Self::III, Direction::Ccw) | (Self::I, Direction::Cw) => Self::IV,
            (Self::IV, Direction::Ccw) | (Self::II, Direction::Cw) => Self::I,
        }
    }

    /// How often an arc in this direction goes on to the next quadrant until it is in `last`: 0 to 3.
    pub(crate) const fn quarters_to(self, last: Self, direction: Direction) -> u8 {
        let quarters = match direction {
            Direction::Ccw => (last as u8).wrapping_sub(self as u8),
            Direction::Cw => (self as u8).wrapping_sub(last as u8),
        };
        quarters % 4
    }

    /// The two motions of an arc in this quadrant: the columns NR1…NR4 and SR1…SR4 of the
    /// textbooks' tables.
    ///
    /// ```text
    ///            ccw (NR)                       cw (SR)
    ///       II      |      I              II      |      I
    ///    −x ← away  |  towards −x      towards +x |  away +x
    ///    −y towards |  away +y         away +y    |  towards −y
    ///   ------------+------------     ------------+------------
    ///    away −y    |  towards +y      towards +y |  away −y
    ///    towards +x |  away +x         away −x    |  towards −x
    ///      III      |      IV            III      |      IV
    /// ```
    #[must_use]
    pub const fn feeds(self, direction: Direction) -> Feeds {
        const fn feeds(towards: (Axis, i8), away: (Axis, i8)) -> Feeds {
            Feeds {
                towards: Feed { axis: towards.0, sign: towards.1 },
                away: Feed { axis: away.0, sign: away.1 },
            }
        }
        use Axis::{X, Y};
        match (direction, self) {
            (Direction::Ccw, Self::I) => feeds((X, -1), (Y, 1)),
            (Direction::Ccw, Self::II) => feeds((Y, -1), (X, -1)),
            (Direction::Ccw, Self::III) => feeds((X, 1), (Y, -1)),
            (Direction::Ccw, Self::IV) => feeds((Y, 1), (X, 1)),
            (Direction::Cw, Self::I) => feeds((Y, -1), (X, 1)),
            (Direction::Cw, Self::II) => feeds((X, 1), (Y, 1)),
            (Direction::Cw, Self::III) => feeds((Y, 1), (X, -1)),
            (Direction::Cw, Self::IV) => feeds((X, -1), (Y, -1)),
        }
    }
}

impl Direction {
    /// The other sense.
    #[must_use]
    pub const fn reversed(self) -> Self {
        match self {
            Self::Cw => Self::Ccw,
            Self::Ccw => Self::Cw,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_feeds_lead_round_the_circle() {
        // Geometry, not the table again: "towards" shrinks its coordinate, "away" grows the
        // other, and each turns about the centre in the arc's sense (cross product).
        for (quadrant, [x, y]) in [
            (Quadrant::I, [3, 4]),
            (Quadrant::II, [-3, 4]),
            (Quadrant::III, [-3, -4]),
            (Quadrant::IV, [3, -4]),
        ] {
            for (direction, turn) in [(Direction::Ccw, 1), (Direction::Cw, -1)] {
                let Feeds { towards, away } = quadrant.feeds(direction);
                let moved = |feed: Feed| match feed.axis {
                    Axis::X => [i64::from(feed.sign), 0],
                    Axis::Y => [0, i64::from(feed.sign)],
                };
                for (feed, grows) in [(towards, false), (away, true)] {
                    let [dx, dy] = moved(feed);
                    assert_eq!(x * dx + y * dy > 0, grows, "{quadrant:?} {direction:?}");
                    assert_eq!((x * dy - y * dx).signum(), turn, "{quadrant:?} {direction:?}");
                }
                assert_eq!(towards.axis, away.axis.other());
            }
        }
    }

    #[test]
    fn quarters_are_counted_as_they_are_gone() {
        for first in [Quadrant::I, Quadrant::II, Quadrant::III, Quadrant::IV] {
            for direction in [Direction::Cw, Direction::Ccw] {
                let mut quadrant = first;
                for quarters in 0..4 {
                    assert_eq!(first.quarters_to(quadrant, direction), quarters);
                    quadrant = quadrant.next(direction);
                }
                assert_eq!(quadrant, first);
            }
        }
    }

    #[test]
    fn a_point_on_an_axis_belongs_to_the_quadrant_being_entered() {
        for (point, ccw, cw) in [
            ([5, 0], Quadrant::I, Quadrant::IV),
            ([0, 5], Quadrant::II, Quadrant::I),
            ([-5, 0], Quadrant::III, Quadrant::II),
            ([0, -5], Quadrant::IV, Quadrant::III),
        ] {
            assert_eq!(Quadrant::entered(point, Direction::Ccw), Some(ccw));
            assert_eq!(Quadrant::entered(point, Direction::Cw), Some(cw));
            assert_eq!(Quadrant::left(point, Direction::Ccw), Some(cw));
            assert_eq!(Quadrant::left(point, Direction::Cw), Some(ccw));
        }
        assert_eq!(Quadrant::entered([0, 0], Direction::Ccw), None);
    }

    #[test]
    fn four_quadrants_make_a_turn() {
        for direction in [Direction::Cw, Direction::Ccw] {
            let mut quadrant = Quadrant::III;
            for _ in 0..4 {
                // The axis fed towards zero arrives there and is fed away from then on.
                let next = quadrant.next(direction);
                assert_eq!(quadrant.feeds(direction).towards, next.feeds(direction).away);
                quadrant = next;
            }
            assert_eq!(quadrant, Quadrant::III);
        }
    }
}
