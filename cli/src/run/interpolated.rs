//! A block as its interpolator sees it.

use super::deviation::Deviation;
use crate::curve::Curve;
use onepulse_core::Plane;
use onepulse_plan::{self as plan, Motion};

/// The curve of a block: a line from its start, an arc about its centre.
///
/// What moves in one plane is a curve of two axes, the plane's first and second; a line that moves
/// three has them all, x, y and z.
#[derive(Clone, Debug)]
pub(super) struct Interpolated {
    pub(super) curve: Curve,
    /// XY for a line in space too, so that z comes third.
    pub(super) plane: Plane,
    /// What the curve's coordinates count from, x, y and z.
    pub(super) origin: [i64; 3],
}

impl Interpolated {
    /// Of a motion.
    pub(super) fn of(motion: &Motion) -> Self {
        let from = motion.from.map(i64::from);
        match motion.curve {
            // Any two points of a program are an i32 apart, and an arc's are from its centre.
            plan::Curve::Line => {
                let to = [0, 1, 2].map(|axis| (i64::from(motion.to[axis]) - from[axis]) as i32);
                let (plane, axes) = match motion.plane() {
                    Some(plane) => (plane, 2),
                    None => (Plane::Xy, 3),
                };
                let to = plane.axes()[..axes].iter().map(|&axis| to[axis]).collect();
                Self { curve: Curve::Line { to }, plane, origin: from }
            }
            plan::Curve::Arc { plane, centre, direction } => {
                let seen = |point: [i32; 2]| {
                    [0, 1].map(|axis| (i64::from(point[axis]) - centre[axis]) as i32)
                };
                let [start, end] = motion.ends_in(plane).map(seen);
                let curve = Curve::Arc { from: start, to: end, direction };
                let [_, _, across] = plane.axes();
                let origin = plane.place([centre[0], centre[1], from[across]]);
                Self { curve, plane, origin }
            }
        }
    }

    /// Whether all three axes move.
    pub(super) fn is_in_space(&self) -> bool {
        self.curve.end().len() > 2
    }

    /// The deviation of a path along the curve, before it begins.
    pub(super) fn deviation(&self) -> Deviation {
        match &self.curve {
            Curve::Arc { from, .. } => Deviation::from_circle(*from),
            curve => {
                // What a plane does not have is 0.
                let mut to = [0; 3];
                to.iter_mut().zip(curve.end()).for_each(|(slot, c)| *slot = c);
                Deviation::from_line(to)
            }
        }
    }

    /// From x, y, z to the order of the curve's axes, that across its plane last.
    pub(super) fn in_order<T: Copy>(&self, point: [T; 3]) -> [T; 3] {
        self.plane.axes().map(|axis| point[axis])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use onepulse_core::Direction;
    use onepulse_plan::Rate;

    fn of(from: [i32; 3], to: [i32; 3], curve: plan::Curve) -> Interpolated {
        Interpolated::of(&Motion { line: 1, from, to, curve, rate: Rate::Rapid })
    }

    #[test]
    fn lines_have_the_axes_that_move() {
        let line = |to| of([10, 20, 30], to, plan::Curve::Line);
        for (to, plane, expected) in [
            ([11, 22, 30], Plane::Xy, vec![1, 2]),
            // Z before X.
            ([11, 20, 33], Plane::Zx, vec![3, 1]),
            ([10, 20, 33], Plane::Zx, vec![3, 0]),
            ([10, 22, 33], Plane::Yz, vec![2, 3]),
            ([11, 22, 33], Plane::Xy, vec![1, 2, 3]),
        ] {
            let Interpolated { curve, plane: found, origin } = line(to);
            assert_eq!((curve, found), (Curve::Line { to: expected }, plane), "{to:?}");
            assert_eq!(origin, [10, 20, 30]);
        }
    }

    #[test]
    fn arcs_lie_about_their_centre_at_the_height_of_their_start() {
        let direction = Direction::Cw;
        let arc = plan::Curve::Arc { plane: Plane::Zx, centre: [7, 4], direction };
        let arc = of([4, 9, 12], [9, 9, 7], arc);
        assert_eq!(arc.curve, Curve::Arc { from: [5, 0], to: [0, 5], direction });
        assert_eq!(arc.origin, [4, 9, 7]);
        assert_eq!(arc.in_order([4, 9, 12]), [12, 4, 9]);
    }
}
