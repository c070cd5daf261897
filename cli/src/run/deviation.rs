//! How far a path strays from its curve.

use crate::curve::Curve;

/// The largest distance between a path's points and the curve, kept in exact integers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Deviation {
    /// From the straight line through the origin and `to`: the largest |x_e·y − y_e·x|.
    Line { to: [i128; 2], largest: i128 },
    /// From the circle about the origin: the smallest and largest x² + y².
    Circle { radius_squared: i128, smallest: i128, largest: i128 },
}

impl Deviation {
    /// The deviation of a path that has not begun.
    pub(super) fn of(curve: &Curve) -> Self {
        match curve {
            Curve::Line { to } => Self::Line { to: [to[0].into(), to[1].into()], largest: 0 },
            &Curve::Arc { from, .. } => {
                let radius_squared = square(from.map(i64::from));
                Self::Circle { radius_squared, smallest: radius_squared, largest: radius_squared }
            }
        }
    }

    /// Takes a point of the path, relative to the curve's origin.
    pub(super) fn reach(&mut self, [x, y]: [i64; 2]) {
        match self {
            Self::Line { to: [xe, ye], largest } => {
                *largest = (*xe * i128::from(y) - *ye * i128::from(x)).abs().max(*largest);
            }
            Self::Circle { smallest, largest, .. } => {
                let here = square([x, y]);
                *smallest = here.min(*smallest);
                *largest = here.max(*largest);
            }
        }
    }

    /// In pulses.
    pub(super) fn in_pulses(self) -> f64 {
        match self {
            Self::Line { largest: 0, .. } => 0.0,
            Self::Line { to: [xe, ye], largest } => largest as f64 / (xe as f64).hypot(ye as f64),
            Self::Circle { radius_squared, smallest, largest } => {
                // √a − √b without losing the difference of two large roots.
                let gap =
                    |a: i128, b: i128| (a - b) as f64 / ((a as f64).sqrt() + (b as f64).sqrt());
                gap(largest, radius_squared).max(gap(radius_squared, smallest))
            }
        }
    }
}

fn square([x, y]: [i64; 2]) -> i128 {
    i128::from(x) * i128::from(x) + i128::from(y) * i128::from(y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use onepulse_core::Direction;

    #[test]
    fn distances_of_known_points() {
        let mut line = Deviation::of(&Curve::Line { to: vec![3, 4] });
        line.reach([1, 0]);
        assert!((line.in_pulses() - 0.8).abs() < 1e-12);
        let curve = Curve::Arc { from: [5, 0], to: [0, 5], direction: Direction::Ccw };
        let mut circle = Deviation::of(&curve);
        circle.reach([4, 4]);
        circle.reach([4, 2]);
        assert!((circle.in_pulses() - 32_f64.sqrt() + 5.0).abs() < 1e-12);
    }
}
