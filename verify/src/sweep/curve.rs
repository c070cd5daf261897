//! A curve, a point of its path, and how far that is from it: in integers where it decides.

use onepulse_core::Direction;
use std::fmt;
use std::str::SplitWhitespace;

/// What was drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curve {
    /// A line from the origin.
    Line {
        /// Where it ends.
        end: [i64; 2],
    },
    /// An arc about the origin; equal ends mean a full circle.
    Arc {
        /// Where it starts.
        start: [i64; 2],
        /// Where it ends.
        end: [i64; 2],
        /// Its sense.
        direction: Direction,
    },
    /// One axis' pulses against the clock: a point is (clocks, pulses).
    Train {
        /// Pulses in 2ⁿ clocks.
        value: i64,
    },
}

/// A point of a path, after a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Case {
    /// The curve.
    pub curve: Curve,
    /// The width of the registers; 0 where the method has none.
    pub bits: u32,
    /// Cycles since the start.
    pub cycle: u64,
    /// The point.
    pub point: [i64; 2],
}

impl Case {
    /// The distance of the point from the curve, in pulses: to be read, not to decide.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        let [x, y] = self.point;
        match self.curve {
            Curve::Line { end: [0, 0] } => root(x * x + y * y),
            Curve::Line { end: [xe, ye] } => {
                (xe * y - ye * x).abs() as f64 / root(xe * xe + ye * ye)
            }
            Curve::Arc { start, .. } => {
                let [square, r_squared] = [x * x + y * y, square_of(start)];
                (square - r_squared).abs() as f64 / (root(square) + root(r_squared))
            }
            Curve::Train { value } => {
                ((y << self.bits) - value * x).abs() as f64 / (1_u64 << self.bits) as f64
            }
        }
    }

    /// Whether the point is more than one pulse from the curve.
    #[must_use]
    pub fn leaves_one_pulse(&self) -> bool {
        let [x, y] = self.point.map(i128::from);
        match self.curve {
            Curve::Line { end } => {
                let [xe, ye] = end.map(i128::from);
                // The distance is |x_e·y − y_e·x|/L; a line without length is a point.
                if end == [0, 0] {
                    x * x + y * y > 1
                } else {
                    (xe * y - ye * x).pow(2) > xe * xe + ye * ye
                }
            }
            // (R − 1)² ≤ x² + y² ≤ (R + 1)² is |x² + y² − R² − 1| ≤ 2R.
            Curve::Arc { start, .. } => {
                let r_squared = i128::from(square_of(start));
                (x * x + y * y - r_squared - 1).pow(2) > 4 * r_squared
            }
            Curve::Train { value } => {
                ((y << self.bits) - i128::from(value) * x).abs() > 1 << self.bits
            }
        }
    }

    /// Reads what [`Display`](fmt::Display) wrote.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let mut words = text.split_whitespace();
        let curve = Curve::parse(&mut words)?;
        let bits = after("n", &mut words)?.parse().ok()?;
        let cycle = after("cycle", &mut words)?.parse().ok()?;
        let point = pair(after("at", &mut words)?)?;
        Some(Self { curve, bits, cycle, point })
    }
}

impl Curve {
    /// Reads what [`Display`](fmt::Display) wrote, word by word.
    pub(crate) fn parse(words: &mut SplitWhitespace<'_>) -> Option<Self> {
        Some(match words.next()? {
            "line" => Self::Line { end: pair(words.next()?)? },
            "arc" => Self::Arc {
                start: pair(words.next()?)?,
                end: pair(words.next()?)?,
                direction: match words.next()? {
                    "cw" => Direction::Cw,
                    "ccw" => Direction::Ccw,
                    _ => return None,
                },
            },
            "train" => Self::Train { value: words.next()?.parse().ok()? },
            _ => return None,
        })
    }
}

impl fmt::Display for Curve {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line { end: [x, y] } => write!(f, "line {x},{y}"),
            Self::Arc { start: [x, y], end: [xe, ye], direction } => {
                let sense = if *direction == Direction::Cw { "cw" } else { "ccw" };
                write!(f, "arc {x},{y} {xe},{ye} {sense}")
            }
            Self::Train { value } => write!(f, "train {value}"),
        }
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { curve, bits, cycle, point: [x, y] } = self;
        write!(f, "{curve} n {bits} cycle {cycle} at {x},{y}")
    }
}

fn after<'a>(word: &str, words: &mut SplitWhitespace<'a>) -> Option<&'a str> {
    (words.next()? == word).then(|| words.next())?
}

fn pair(text: &str) -> Option<[i64; 2]> {
    let (x, y) = text.split_once(',')?;
    Some([x.parse().ok()?, y.parse().ok()?])
}

fn square_of([x, y]: [i64; 2]) -> i64 {
    x * x + y * y
}

fn root(value: i64) -> f64 {
    (value as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arc(start: [i64; 2], point: [i64; 2]) -> Case {
        let curve = Curve::Arc { start, end: start, direction: Direction::Cw };
        Case { curve, bits: 5, cycle: 3, point }
    }

    #[test]
    fn one_pulse_is_kept_and_a_hair_more_is_not() {
        for (point, leaves) in [([6, 0], false), ([4, 0], false), ([6, 1], true), ([3, 2], true)] {
            assert_eq!(arc([5, 0], point).leaves_one_pulse(), leaves, "{point:?}");
            assert_eq!(arc([3, 4], point).leaves_one_pulse(), leaves, "{point:?}");
        }
        let line = |end, point| Case { curve: Curve::Line { end }, bits: 0, cycle: 1, point };
        assert!(!line([4, 0], [2, 1]).leaves_one_pulse());
        assert!(line([4, 0], [2, 2]).leaves_one_pulse());
        assert!(!line([4, 3], [1, 2]).leaves_one_pulse());
        assert!(line([4, 3], [0, 2]).leaves_one_pulse());
        assert!(line([0, 0], [1, 1]).leaves_one_pulse());
        let train = |point| Case { curve: Curve::Train { value: 8 }, bits: 4, cycle: 1, point };
        assert!(!train([2, 2]).leaves_one_pulse());
        assert!(train([1, 2]).leaves_one_pulse());
    }

    #[test]
    fn the_figure_agrees_with_the_decision() {
        for x in -9..=9 {
            for y in -9..=9 {
                let case = arc([4, 3], [x, y]);
                if (case.deviation() - 1.0).abs() > 1e-9 {
                    assert_eq!(case.leaves_one_pulse(), case.deviation() > 1.0, "{case}");
                }
            }
        }
    }

    #[test]
    fn what_is_written_can_be_read() {
        let mut cases = vec![arc([5, 0], [-6, 1])];
        for curve in [Curve::Line { end: [-3, 4] }, Curve::Train { value: 21 }] {
            cases.push(Case { curve, bits: 0, cycle: 7, point: [0, -1] });
        }
        for case in cases {
            assert_eq!(Case::parse(&case.to_string()), Some(case));
        }
        assert_eq!(Case::parse("arc 5,0 0,5 up n 1 cycle 1 at 0,0"), None);
        assert_eq!(Case::parse(""), None);
    }
}
