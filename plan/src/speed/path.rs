//! A motion's curve in millimetres: how long it is, and the point at a way.

use super::SpeedError;
use crate::{Curve, Length, Motion};
use onepulse_core::{Direction, Plane};
use std::f64::consts::TAU;

/// The curve of a [`Motion`] in millimetres; points and directions are x, y and z.
///
/// An arc whose end is off the circle, as programs rounded to pulses have it, runs on the circle through
/// its start until it sees the end in its own direction; the end point itself is what it programs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    shape: Shape,
    length: f64,
    end: [f64; 3],
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    Line {
        from: [f64; 3],
        direction: [f64; 3],
    },
    Arc {
        plane: Plane,
        /// Along the plane's two axes, as the vectors.
        centre: [f64; 2],
        /// The constant coordinate across the plane.
        across: f64,
        radius: f64,
        /// The unit vectors from the centre to the start and towards the end.
        seen: [[f64; 2]; 2],
        /// 1 counter-clockwise, −1 clockwise.
        turn: f64,
    },
}

impl Path {
    /// The curve of a motion in pulses of this length.
    ///
    /// # Errors
    /// An arc that starts or ends in its centre, or over 2³¹ pulses from it.
    pub fn of(motion: &Motion, pulse: Length) -> Result<Self, SpeedError> {
        let millimetres = |c: i64| {
            let picometres = i128::from(c) * i128::from(pulse.picometres());
            picometres as f64 / Length::MILLIMETRE.picometres() as f64
        };
        let pulse = pulse.millimetres();
        let [from, to] = [motion.from, motion.to].map(|point| point.map(i64::from));
        let end = to.map(millimetres);
        let (shape, length) = match motion.curve {
            Curve::Line => {
                let along = [0, 1, 2].map(|axis| to[axis] - from[axis]);
                let shape = Shape::Line { from: from.map(millimetres), direction: unit(along) };
                (shape, distance(along) * pulse)
            }
            Curve::Arc { plane, centre, direction } => {
                let [start, end] = motion.ends_in(plane).map(|point| relative(point, centre));
                let (Some(start), Some(end)) = (start, end) else {
                    return Err(SpeedError::NoArc);
                };
                let radius = distance(start) * pulse;
                let turn = if direction == Direction::Ccw { 1.0 } else { -1.0 };
                let ahead = angle(start, end) * turn;
                let sweep = if ahead > 0.0 { ahead } else { ahead + TAU };
                let (centre, seen) = (centre.map(millimetres), [start, end].map(unit));
                let [_, _, across] = plane.axes();
                let across = millimetres(from[across]);
                (Shape::Arc { plane, centre, across, radius, seen, turn }, radius * sweep)
            }
        };
        Ok(Self { shape, length, end })
    }

    /// How long it is, in millimetres.
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// The radius of an arc, in millimetres.
    #[must_use]
    pub const fn radius(&self) -> Option<f64> {
        match self.shape {
            Shape::Line { .. } => None,
            Shape::Arc { radius, .. } => Some(radius),
        }
    }

    /// The directions of motion at the start and at the end, as unit vectors.
    #[must_use]
    pub fn directions(&self) -> [[f64; 3]; 2] {
        match self.shape {
            Shape::Line { direction, .. } => [direction; 2],
            Shape::Arc { plane, seen, turn, .. } => {
                seen.map(|[x, y]| plane.place([-turn * y, turn * x, 0.0]))
            }
        }
    }

    /// The point this many millimetres from the start along the curve; from its length on, the end
    /// point.
    #[must_use]
    pub fn point(&self, way: f64) -> [f64; 3] {
        if way >= self.length {
            return self.end;
        }
        match self.shape {
            Shape::Line { from, direction } => {
                [0, 1, 2].map(|axis| from[axis] + way * direction[axis])
            }
            Shape::Arc { plane, centre, across, radius, seen: [[x, y], _], turn } => {
                let (sin, cos) = (turn * way / radius).sin_cos();
                plane.place([
                    centre[0] + radius * (x * cos - y * sin),
                    centre[1] + radius * (y * cos + x * sin),
                    across,
                ])
            }
        }
    }
}

/// A point seen from the centre, in pulses; none in the centre itself or too far from it.
fn relative(point: [i32; 2], centre: [i64; 2]) -> Option<[i64; 2]> {
    let seen = |axis: usize| {
        let c = i64::from(point[axis]).checked_sub(centre[axis])?;
        i32::try_from(c).is_ok().then_some(c)
    };
    let seen = [seen(0)?, seen(1)?];
    (seen != [0; 2]).then_some(seen)
}

/// The angle from one point to another, counter-clockwise, −π to π; zero only if it is.
fn angle(from: [i64; 2], to: [i64; 2]) -> f64 {
    let [x, y] = from.map(i128::from);
    let [to_x, to_y] = to.map(i128::from);
    let (cross, dot) = (x * to_y - y * to_x, x * to_x + y * to_y);
    (cross as f64).atan2(dot as f64)
}

fn distance<const AXES: usize>(point: [i64; AXES]) -> f64 {
    point.iter().fold(0.0, |length: f64, &c| length.hypot(c as f64))
}

fn unit<const AXES: usize>(point: [i64; AXES]) -> [f64; AXES] {
    point.map(|c| c as f64 / distance(point))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Rate;
    use proptest::prelude::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn path(from: [i32; 3], to: [i32; 3], curve: Curve) -> Result<Path, SpeedError> {
        Path::of(&Motion { line: 1, from, to, curve, rate: Rate::Rapid }, "0.01".parse().unwrap())
    }

    /// An arc in the XY plane.
    fn arc(from: [i32; 2], to: [i32; 2], centre: [i64; 2], direction: Direction) -> Path {
        let [from, to] = [from, to].map(|[x, y]| [x, y, 0]);
        path(from, to, Curve::Arc { plane: Plane::Xy, centre, direction }).unwrap()
    }

    fn assert_near<const AXES: usize>(found: [f64; 3], expected: [f64; AXES]) {
        // What is not given is 0.
        let off = (0..3).map(|axis| found[axis] - expected.get(axis).unwrap_or(&0.0));
        let off = off.fold(0.0, f64::hypot);
        assert!(off < 1e-9, "{found:?} is not {expected:?}");
    }

    #[test]
    fn a_line_of_the_3_4_5_triangle() {
        let line = path([100, 200, 0], [400, 600, 0], Curve::Line).unwrap();
        assert!((line.length() - 5.0).abs() < 1e-12);
        assert_eq!(line.radius(), None);
        assert_near(line.directions()[0], [0.6, 0.8]);
        assert_near(line.directions()[1], [0.6, 0.8]);
        assert_near(line.point(0.0), [1.0, 2.0]);
        assert_near(line.point(2.5), [2.5, 4.0]);
        assert_eq!(line.point(6.0), [4.0, 6.0, 0.0]);
    }

    #[test]
    fn arcs_of_a_quarter_three_quarters_and_a_turn() {
        // About (10, 0), from the right of it.
        let quarter = arc([1500, 0], [1000, 500], [1000, 0], Direction::Ccw);
        assert!((quarter.length() - 5.0 * FRAC_PI_2).abs() < 1e-12);
        assert_eq!(quarter.radius(), Some(5.0));
        assert_near(quarter.directions()[0], [0.0, 1.0]);
        assert_near(quarter.directions()[1], [-1.0, 0.0]);
        let eighth = 5.0 * std::f64::consts::FRAC_1_SQRT_2;
        assert_near(quarter.point(quarter.length() / 2.0), [10.0 + eighth, eighth]);

        let rest = arc([1500, 0], [1000, 500], [1000, 0], Direction::Cw);
        assert!((rest.length() - 15.0 * FRAC_PI_2).abs() < 1e-12);
        assert_near(rest.directions()[0], [0.0, -1.0]);
        assert_near(rest.directions()[1], [1.0, 0.0]);
        assert_near(rest.point(5.0 * FRAC_PI_2), [10.0, -5.0]);

        let turn = arc([1500, 0], [1500, 0], [1000, 0], Direction::Cw);
        assert!((turn.length() - 10.0 * PI).abs() < 1e-12);
        assert_near(turn.directions()[1], turn.directions()[0]);
        assert_near(turn.point(5.0 * PI), [5.0, 0.0]);
        assert_eq!(turn.point(turn.length()), [15.0, 0.0, 0.0]);
    }

    #[test]
    fn a_line_in_space_goes_2_3_6_in_7() {
        let line = path([100, 200, -100], [300, 500, -700], Curve::Line).unwrap();
        assert!((line.length() - 7.0).abs() < 1e-12);
        assert_near(line.directions()[0], [2.0 / 7.0, 3.0 / 7.0, -6.0 / 7.0]);
        assert_near(line.point(3.5), [2.0, 3.5, -4.0]);
        assert_eq!(line.point(7.1), [3.0, 5.0, -7.0]);
    }

    /// Counter-clockwise is from the first axis of the plane to the second: in G18 from z to x, in G19
    /// from y to z (ISO 841: right-handed about the axis across).
    #[test]
    fn quarter_turns_in_the_other_planes() {
        let direction = Direction::Ccw;
        let zx = Curve::Arc { plane: Plane::Zx, centre: [200, 100], direction };
        // From z = centre + 5 mm to x = centre + 5 mm; y stays.
        let zx = path([100, 300, 700], [600, 300, 200], zx).unwrap();
        assert!((zx.length() - 5.0 * FRAC_PI_2).abs() < 1e-12);
        assert_near(zx.directions()[0], [1.0, 0.0, 0.0]);
        assert_near(zx.directions()[1], [0.0, 0.0, -1.0]);
        let eighth = 5.0 * std::f64::consts::FRAC_1_SQRT_2;
        assert_near(zx.point(zx.length() / 2.0), [1.0 + eighth, 3.0, 2.0 + eighth]);
        assert_eq!(zx.point(zx.length()), [6.0, 3.0, 2.0]);

        let yz = Curve::Arc { plane: Plane::Yz, centre: [0, 100], direction };
        // From y = centre + 5 mm to z = centre + 5 mm; x stays.
        let yz = path([-400, 500, 100], [-400, 0, 600], yz).unwrap();
        assert_near(yz.directions()[0], [0.0, 0.0, 1.0]);
        assert_near(yz.directions()[1], [0.0, -1.0, 0.0]);
        assert_near(yz.point(yz.length() / 2.0), [-4.0, eighth, 1.0 + eighth]);
    }

    #[test]
    fn an_end_off_the_circle_is_met_from_the_circle_of_the_start() {
        let off = arc([500, 0], [0, 502], [0, 0], Direction::Ccw);
        assert!((off.length() - 5.0 * FRAC_PI_2).abs() < 1e-12);
        assert_near(off.point(off.length() * (1.0 - 1e-12)), [0.0, 5.0]);
        assert_eq!(off.point(off.length()), [0.0, 5.02, 0.0]);
    }

    #[test]
    fn neighbours_far_from_the_centre_are_no_full_turn() {
        // The cross product is −1 of products over 2⁶¹, which floats do not tell apart.
        let far = i32::MAX;
        let near = arc([far, far - 1], [far - 1, far - 2], [0, 0], Direction::Cw);
        let angle = 1.0 / (2.0 * f64::from(far).powi(2));
        assert!((near.length() / near.radius().unwrap() / angle - 1.0).abs() < 1e-6);
    }

    #[test]
    fn what_is_no_arc_is_refused() {
        for (from, to, centre) in [
            ([5, 5], [0, 0], [5, 5]),
            ([0, 0], [5, 5], [5, 5]),
            ([0, 0], [1, 1], [i64::MAX, 0]),
            ([0, -2], [1, 1], [0, i64::MAX]),
            ([0, 0], [1, 1], [0, 1 << 32]),
        ] {
            let curve = Curve::Arc { plane: Plane::Xy, centre, direction: Direction::Cw };
            let [from, to] = [from, to].map(|[x, y]: [i32; 2]| [x, y, 0]);
            assert_eq!(path(from, to, curve), Err(SpeedError::NoArc), "{centre:?}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(500) })]

        /// From points to ways and directions: those of chords so short that they are as the arc.
        #[test]
        fn points_advance_by_the_way_and_in_the_direction(
            start in [-5000..5000, -5000..5000],
            end in [-5000..5000, -5000..5000],
            share in 0.0..0.999,
            clockwise: bool,
        ) {
            prop_assume!(start != [0; 2] && end != [0; 2]);
            let direction = if clockwise { Direction::Cw } else { Direction::Ccw };
            let arc = arc(start, end, [0, 0], direction);
            let radius = f64::from(start[0]).hypot(f64::from(start[1])) * 0.01;
            prop_assert!(arc.length() > 0.0 && arc.length() <= radius * TAU * (1.0 + 1e-12));
            let (way, step) = (share * arc.length(), arc.length() * 1e-4);
            let (from, to) = (arc.point(way), arc.point(way + step));
            let chord = (to[0] - from[0]).hypot(to[1] - from[1]);
            prop_assert!((chord / step - 1.0).abs() < 1e-6, "{} of {}", chord, step);
            prop_assert!((from[0].hypot(from[1]) / radius - 1.0).abs() < 1e-12);
            // At both ends: the secant's direction is that of the tangent but for half its angle.
            let before_end = [arc.point(arc.length() - step), arc.point(arc.length() * (1.0 - 1e-13))];
            let ends = [[arc.point(0.0), arc.point(step)], before_end];
            for (secant, tangent) in ends.into_iter().zip(arc.directions()) {
                let [x, y, _] = [0, 1, 2].map(|axis| secant[1][axis] - secant[0][axis]);
                let along = (x * tangent[0] + y * tangent[1]) / x.hypot(y);
                prop_assert!(along > 1.0 - 1e-6, "{:?} {:?}", secant, tangent);
            }
        }
    }
}
