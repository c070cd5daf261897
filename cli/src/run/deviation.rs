//! How far a path strays from its curve.

/// The largest distance between a path's points and the curve, kept in exact integers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Deviation {
    /// From the straight line through the origin and `to`: the largest |x_e·y − y_e·x|.
    Line { to: [i128; 2], largest: i128 },
    /// The same in space: the largest square of the cross product of `to` and the point.
    SpaceLine { to: [i128; 3], largest: i128 },
    /// From the circle about the origin: the smallest and largest x² + y².
    Circle { radius_squared: i128, smallest: i128, largest: i128 },
}

impl Deviation {
    /// Of a path along the line from the origin, before it begins. In a plane the third coordinate is 0, and
    /// stays so.
    pub(super) fn from_line(to: [i64; 3]) -> Self {
        let to = to.map(i128::from);
        match to {
            [x, y, 0] => Self::Line { to: [x, y], largest: 0 },
            _ => Self::SpaceLine { to, largest: 0 },
        }
    }

    /// Of a path along the circle about the origin of its plane through a point, before it begins.
    pub(super) fn from_circle(through: [i32; 2]) -> Self {
        let radius_squared = square(through.map(i64::from));
        Self::Circle { radius_squared, smallest: radius_squared, largest: radius_squared }
    }

    /// Takes a point of the path, relative to the curve's origin. Along a line no axis goes back or
    /// passes its end.
    pub(super) fn reach(&mut self, [x, y, z]: [i64; 3]) {
        match self {
            Self::Line { to: [xe, ye], largest } => {
                *largest = (*xe * i128::from(y) - *ye * i128::from(x)).abs().max(*largest);
            }
            Self::SpaceLine { to: [xe, ye, ze], largest } => {
                // Factors of up to 2³¹ with equal signs: products and their differences are within 2⁶²,
                // and three squares of those within 2¹²⁶.
                let [x, y, z] = [x, y, z].map(i128::from);
                let across = [*xe * y - *ye * x, *ye * z - *ze * y, *ze * x - *xe * z];
                *largest = across.iter().map(|c| c * c).sum::<i128>().max(*largest);
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
            Self::Line { largest: 0, .. } | Self::SpaceLine { largest: 0, .. } => 0.0,
            Self::Line { to: [xe, ye], largest } => largest as f64 / (xe as f64).hypot(ye as f64),
            Self::SpaceLine { to, largest } => {
                let length_squared: i128 = to.iter().map(|c| c * c).sum();
                (largest as f64).sqrt() / (length_squared as f64).sqrt()
            }
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

    #[test]
    fn distances_of_known_points() {
        let mut line = Deviation::from_line([3, 4, 0]);
        line.reach([1, 0, 0]);
        assert!((line.in_pulses() - 0.8).abs() < 1e-12);
        // In the plane that two points and the line span, (1, 2, 2) of length 3 and (0, 0, 1): 1·sin of the
        // angle whose cosine is ⅔.
        let mut line = Deviation::from_line([10, 20, 20]);
        line.reach([0, 0, 1]);
        assert!((line.in_pulses() - 5_f64.sqrt() / 3.0).abs() < 1e-12);
        line.reach([1, 2, 2]);
        assert!((line.in_pulses() - 5_f64.sqrt() / 3.0).abs() < 1e-12);
        // As far as it can be, from corner to corner.
        let far = 1 << 31;
        let mut line = Deviation::from_line([far, far, -far]);
        line.reach([far, 0, 0]);
        assert!((line.in_pulses() / (far as f64 * (2.0_f64 / 3.0).sqrt()) - 1.0).abs() < 1e-12);
        let mut circle = Deviation::from_circle([5, 0]);
        circle.reach([4, 4, 0]);
        circle.reach([4, 2, 0]);
        assert!((circle.in_pulses() - 32_f64.sqrt() + 5.0).abs() < 1e-12);
    }
}
