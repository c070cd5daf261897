//! The true curve: how long it is, how far a point is from it, and how far along it.

use crate::curve::Curve;
use onepulse_core::{Axis, Direction};
use std::f64::consts::TAU;

/// A curve, and how far a path has come along it.
#[derive(Clone, Debug)]
pub(crate) enum Truth {
    /// The straight line through the origin and `to`.
    Line { to: [i64; 4], length: f64 },
    /// The circle about the origin; `angle` is what the path has turned, positive along the arc.
    Arc { radius_squared: i128, sense: f64, length: f64, last: [i64; 2], angle: f64 },
    /// v² = 2pu, p > 0, u along the axis of symmetry and v across it.
    Parabola { axis: Axis, parameter: f64, length: f64 },
}

/// Where a path is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reached {
    /// From the curve, in pulses.
    pub(super) distance: f64,
    /// Along the curve from its start, in pulses.
    pub(super) way: f64,
}

impl Truth {
    /// Of a path that has not begun. (A helix is compared with nothing: only its arc is seen.)
    pub(crate) fn new(curve: &Curve) -> Self {
        match *curve {
            Curve::Line { ref to } => {
                let mut end = [0; 4];
                for (end, to) in end.iter_mut().zip(to) {
                    *end = i64::from(*to);
                }
                let length = end.iter().map(|c| (*c as f64).powi(2)).sum::<f64>().sqrt();
                Self::Line { to: end, length }
            }
            Curve::Arc { from, to, direction } | Curve::Helix { from, to, direction, .. } => {
                let (from, to) = (from.map(i64::from), to.map(i64::from));
                let sense = if direction == Direction::Ccw { 1.0 } else { -1.0 };
                let turn = sense * angle(from, to);
                // Equal directions mean a full turn.
                let turn = if turn > 0.0 { turn } else { turn + TAU };
                let radius_squared = square(from);
                let length = (radius_squared as f64).sqrt() * turn;
                Self::Arc { radius_squared, sense, length, last: from, angle: 0.0 }
            }
            Curve::Parabola { axis, parameter, to } => {
                let parameter = f64::from(parameter).abs();
                let [u, v] = along_and_across(axis, to.map(i64::from));
                let length = parabola_length(parameter, nearest(parameter, u, v));
                Self::Parabola { axis, parameter, length }
            }
        }
    }

    /// The curve's length in pulses.
    pub(super) fn length(&self) -> f64 {
        match *self {
            Self::Line { length, .. }
            | Self::Arc { length, .. }
            | Self::Parabola { length, .. } => length,
        }
    }

    /// Takes the next point of the path.
    pub(super) fn reach<const N: usize>(&mut self, position: [i64; N]) -> Reached {
        match self {
            Self::Line { to, length } => {
                let (mut squares, mut product) = (0.0, 0.0);
                for i in 0..N {
                    product += to[i] as f64 * position[i] as f64;
                    for j in i + 1..N {
                        squares += cross([to[i], to[j]], [position[i], position[j]]).powi(2);
                    }
                }
                Reached { distance: squares.sqrt() / *length, way: product / *length }
            }
            Self::Arc { radius_squared, sense, last, angle: turned, .. } => {
                let position = [position[0], position[1]];
                *turned += *sense * angle(*last, position);
                *last = position;
                let here = square(position);
                let radius = (*radius_squared as f64).sqrt();
                // √a − √b without losing the difference of two large roots.
                let gap = (here - *radius_squared).abs() as f64;
                Reached { distance: gap / ((here as f64).sqrt() + radius), way: *turned * radius }
            }
            &mut Self::Parabola { axis, parameter, .. } => {
                let [u, v] = along_and_across(axis, [position[0], position[1]]);
                let foot = nearest(parameter, u, v);
                let distance = (u - foot * foot / (2.0 * parameter)).hypot(v - foot);
                Reached { distance, way: parabola_length(parameter, foot) }
            }
        }
    }
}

/// The cross product of two vectors: exact before it is rounded.
fn cross([ax, ay]: [i64; 2], [bx, by]: [i64; 2]) -> f64 {
    (i128::from(ax) * i128::from(by) - i128::from(ay) * i128::from(bx)) as f64
}

fn square([x, y]: [i64; 2]) -> i128 {
    i128::from(x) * i128::from(x) + i128::from(y) * i128::from(y)
}

/// The angle from a point to another about the origin, positive counter-clockwise.
fn angle(a: [i64; 2], b: [i64; 2]) -> f64 {
    let product = i128::from(a[0]) * i128::from(b[0]) + i128::from(a[1]) * i128::from(b[1]);
    cross(a, b).atan2(product as f64)
}

fn along_and_across(axis: Axis, point: [i64; 2]) -> [f64; 2] {
    [axis, axis.other()].map(|axis| axis.of(point).unsigned_abs() as f64)
}

/// The v of the parabola's point that is nearest to (u, v), both not negative.
///
/// It is the largest zero of t³/2p² + t·(1 − u/p) − v. At the larger of v and √(2pu) that is not
/// negative, and from there to the zero it is convex: so Newton's steps fall to it and never pass
/// it. They are few, for the start is as near as the point is to the parabola; but near the centre
/// of the vertex' curvature a step may take no more than a third of the way.
fn nearest(parameter: f64, u: f64, v: f64) -> f64 {
    let slope = 1.0 - u / parameter;
    let cube = 1.0 / (2.0 * parameter * parameter);
    let mut t = v.max((2.0 * parameter * u).sqrt());
    for _ in 0..80 {
        let step = (t * (cube * t * t + slope) - v) / (3.0 * cube * t * t + slope);
        // Not a number where both are zero: at the zero itself.
        if step.is_nan() || step.abs() <= t * 1e-15 {
            break;
        }
        t -= step;
    }
    t
}

/// The parabola's length from its vertex to the point across by v.
fn parabola_length(parameter: f64, v: f64) -> f64 {
    let t = v / parameter;
    0.5 * parameter * (t * t.hypot(1.0) + t.asinh())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check_close(found: f64, expected: f64) {
        assert!((found - expected).abs() < 1e-9, "{found}: {expected} is due");
    }

    #[test]
    fn points_beside_a_line() {
        let mut line = Truth::new(&Curve::Line { to: vec![3, -4] });
        check_close(line.length(), 5.0);
        let beside = line.reach([1, 0]);
        check_close(beside.distance, 0.8);
        check_close(beside.way, 0.6);
        // A corner of a cube, from its diagonal.
        let mut space = Truth::new(&Curve::Line { to: vec![2, 2, 2] });
        let corner = space.reach([1, 0, 0]);
        check_close(corner.distance, (2.0_f64 / 3.0).sqrt());
        check_close(corner.way, 1.0 / 3.0_f64.sqrt());
    }

    #[test]
    fn points_beside_an_arc() {
        let arc = |to, direction| Truth::new(&Curve::Arc { from: [5, 0], to, direction });
        check_close(arc([0, 5], Direction::Ccw).length(), 5.0 * TAU / 4.0);
        check_close(arc([0, 5], Direction::Cw).length(), 5.0 * TAU * 0.75);
        check_close(arc([5, 0], Direction::Cw).length(), 5.0 * TAU);
        check_close(arc([7, 0], Direction::Ccw).length(), 5.0 * TAU);
        let mut arc = arc([5, 0], Direction::Cw);
        check_close(arc.reach([4, -4]).distance, 32.0_f64.sqrt() - 5.0);
        check_close(arc.reach([0, -6]).way, 5.0 * TAU / 4.0);
        check_close(arc.reach([-5, 0]).way, 5.0 * TAU / 2.0);
    }

    #[test]
    fn points_beside_a_parabola() {
        let shape = |axis, parameter, to| Truth::new(&Curve::Parabola { axis, parameter, to });
        let mut wide = shape(Axis::X, 2, [4, 4]);
        check_close(wide.reach([4, -4]).distance, 0.0);
        check_close(wide.reach([1, 0]).distance, 1.0);
        // The normal of y² = 2x at (2, 2) meets the axis of symmetry at (3, 0).
        let mut narrow = shape(Axis::X, 1, [8, 4]);
        check_close(narrow.reach([3, 0]).distance, 5.0_f64.sqrt());
        check_close(shape(Axis::Y, -1, [4, -8]).reach([0, -3]).distance, 5.0_f64.sqrt());
        // The centre of the vertex' curvature.
        let centre = narrow.reach([1, 0]);
        check_close(centre.distance, 1.0);
        assert!(centre.way < 1e-3, "{centre:?}");
        // The length, in chords.
        let point = |i: i32| [f64::from(i * i) / 2e8, f64::from(i) / 1e4];
        let chord = |i| {
            let ([x, y], [next_x, next_y]) = (point(i), point(i + 1));
            (next_x - x).hypot(next_y - y)
        };
        let chords: f64 = (0..40_000).map(chord).sum();
        assert!((narrow.length() - chords).abs() < 1e-6, "{} {chords}", narrow.length());
        check_close(narrow.reach([8, 4]).way, narrow.length());
    }

    #[test]
    fn the_largest_curves_have_finite_measures() {
        let (least, most) = (i32::MIN, i32::MAX);
        for curve in [
            Curve::Line { to: vec![least; 4] },
            Curve::Arc { from: [most, 0], to: [least, least], direction: Direction::Cw },
            Curve::Parabola { axis: Axis::X, parameter: 1, to: [most, least] },
            Curve::Parabola { axis: Axis::Y, parameter: least, to: [1, least] },
        ] {
            let mut truth = Truth::new(&curve);
            assert!(truth.length() > 0.0 && truth.length().is_finite(), "{curve:?}");
            let end = curve.end();
            let Reached { distance, way } = truth.reach([end[0], end[1]]);
            assert!(distance.is_finite() && way.is_finite(), "{curve:?}");
        }
    }
}
