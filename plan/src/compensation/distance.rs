//! The distance between two lines or arcs, in closed form.
//!
//! The nearest points of two curves are a point that they share, an end of one and the point of the
//! other nearest to it, or two inner points on one normal of both. The normals of a circle go
//! through its centre, so that each case is a handful of points.

use super::Element;
use super::curve::sweep;
use super::vector::{Vector, ahead, between, cross, distance, dot, left, length, scaled};
use onepulse_core::Direction;
use std::f64::consts::TAU;

/// A line, or an arc on the circle through its start.
#[derive(Clone, Copy, Debug)]
pub(super) enum Shape {
    Line { from: Vector, to: Vector },
    Arc { centre: Vector, radius: f64, start: Vector, sweep: f64, turn: f64 },
}

impl Shape {
    pub(super) fn of(element: &Element) -> Self {
        match *element {
            Element::Line { from, to } => Self::Line { from, to },
            Element::Arc { from, to, centre, direction } => {
                let radius = distance(centre, from);
                let start = scaled(1.0 / radius, between(centre, from));
                let turn = if direction == Direction::Ccw { 1.0 } else { -1.0 };
                Self::Arc { centre, radius, start, sweep: sweep(from, to, centre, direction), turn }
            }
        }
    }

    pub(super) fn ends(&self) -> [Vector; 2] {
        match *self {
            Self::Line { from, to } => [from, to],
            Self::Arc { centre, radius, start, sweep, turn } => {
                let (sin, cos) = (turn * sweep).sin_cos();
                let end = ahead(scaled(cos, start), sin, left(start));
                [start, end].map(|seen| ahead(centre, radius, seen))
            }
        }
    }

    /// The corners of the smallest upright rectangle around it.
    pub(super) fn bounds(&self) -> [Vector; 2] {
        let mut points = self.ends().to_vec();
        if let Self::Arc { centre, radius, .. } = *self {
            let extremes = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
            points.extend(
                extremes.map(|seen| ahead(centre, radius, seen)).iter().filter(|p| self.spans(**p)),
            );
        }
        let bound = |pick: fn(f64, f64) -> f64| {
            points
                .iter()
                .copied()
                .reduce(|a, b| [pick(a[0], b[0]), pick(a[1], b[1])])
                .unwrap_or_default()
        };
        [bound(f64::min), bound(f64::max)]
    }

    /// Whether a point lies between the normals at the two ends.
    fn spans(&self, point: Vector) -> bool {
        match *self {
            Self::Line { from, to } => {
                let way = between(from, to);
                (0.0..=dot(way, way)).contains(&dot(way, between(from, point)))
            }
            Self::Arc { centre, start, sweep, turn, .. } => {
                let seen = between(centre, point);
                let angle = (turn * cross(start, seen)).atan2(dot(start, seen));
                sweep >= TAU || (if angle < 0.0 { angle + TAU } else { angle }) <= sweep
            }
        }
    }

    /// Its point nearest to this one.
    fn nearest(&self, point: Vector) -> Vector {
        match *self {
            Self::Line { from, to } => {
                let way = between(from, to);
                let share = dot(way, between(from, point)) / dot(way, way);
                // Measured from the nearer end, for the rounding.
                match share {
                    ..=0.0 => from,
                    1.0.. => to,
                    ..=0.5 => ahead(from, share, way),
                    _ => ahead(to, share - 1.0, way),
                }
            }
            Self::Arc { centre, radius, .. } => {
                let seen = between(centre, point);
                let away = length(seen);
                if away > 0.0 && self.spans(point) {
                    return ahead(centre, radius / away, seen);
                }
                let [from, to] = self.ends();
                if distance(from, point) <= distance(to, point) { from } else { to }
            }
        }
    }
}

/// The distance between two curves, and the point of the second where it is taken.
pub(super) fn gap(first: &Shape, second: &Shape) -> (f64, Vector) {
    let mut least = (f64::INFINITY, second.ends()[0]);
    let mut consider = |distance: f64, at: Vector| {
        if distance < least.0 {
            least = (distance, at);
        }
    };
    for end in first.ends() {
        let at = second.nearest(end);
        consider(distance(end, at), at);
    }
    for end in second.ends() {
        consider(distance(first.nearest(end), end), end);
    }
    for [a, b] in common_normals(first, second) {
        if first.spans(a) && second.spans(b) {
            consider(distance(a, b), b);
        }
    }
    for point in crossings(first, second) {
        if first.spans(point) && second.spans(point) {
            consider(0.0, point);
        }
    }
    least
}

/// Pairs of points, one of each unbounded curve, on a normal of both.
fn common_normals(first: &Shape, second: &Shape) -> Vec<[Vector; 2]> {
    match (first, second) {
        // What parallels have in common, their ends have too.
        (Shape::Line { .. }, Shape::Line { .. }) => vec![],
        (Shape::Line { from, to }, Shape::Arc { centre, radius, .. }) => {
            let (foot, normal) = perpendicular(*centre, *from, *to);
            [-radius, *radius].map(|radius| [foot, ahead(*centre, radius, normal)]).to_vec()
        }
        (Shape::Arc { .. }, Shape::Line { .. }) => {
            common_normals(second, first).into_iter().map(|[a, b]| [b, a]).collect()
        }
        (Shape::Arc { centre: c1, radius: r1, .. }, Shape::Arc { centre: c2, radius: r2, .. }) => {
            let way = between(*c1, *c2);
            let apart = length(way);
            // About one centre all normals are common, those at the ends among them.
            if apart == 0.0 {
                return vec![];
            }
            let [first, second] = [(c1, r1), (c2, r2)]
                .map(|(centre, radius)| [-radius, *radius].map(|r| ahead(*centre, r / apart, way)));
            first.iter().flat_map(|a| second.iter().map(|b| [*a, *b])).collect()
        }
    }
}

/// The points that the unbounded curves share, where they cross.
fn crossings(first: &Shape, second: &Shape) -> Vec<Vector> {
    match (first, second) {
        (Shape::Line { from, to }, Shape::Line { from: other, to: end }) => {
            let (way, across) = (between(*from, *to), between(*other, *end));
            let turn = cross(way, across);
            if turn == 0.0 {
                return vec![];
            }
            let share = cross(between(*from, *other), across) / turn;
            vec![ahead(*from, share, way)]
        }
        (Shape::Line { from, to }, Shape::Arc { centre, radius, .. }) => {
            let (foot, normal) = perpendicular(*centre, *from, *to);
            let away = distance(*centre, foot);
            let half = half_chord(*radius, away);
            half.map_or(vec![], |half| {
                [-half, half].map(|half| ahead(foot, half, left(normal))).to_vec()
            })
        }
        (Shape::Arc { .. }, Shape::Line { .. }) => crossings(second, first),
        (Shape::Arc { centre: c1, radius: r1, .. }, Shape::Arc { centre: c2, radius: r2, .. }) => {
            let way = between(*c1, *c2);
            let apart = length(way);
            let along = (apart + (r1 - r2) * (r1 + r2) / apart) / 2.0;
            let Some(half) = half_chord(*r1, along) else { return vec![] };
            let foot = ahead(*c1, along / apart, way);
            [-half, half].map(|half| ahead(foot, half / apart, left(way))).to_vec()
        }
    }
}

/// Half the chord of a circle at a distance from its centre; none if it does not come so far, or if the
/// distance is that from a circle about the same centre, which is no number.
fn half_chord(radius: f64, away: f64) -> Option<f64> {
    let square = (radius - away) * (radius + away);
    (square >= 0.0).then(|| square.sqrt())
}

/// The foot of the perpendicular from a point on a line, and its unit vector.
fn perpendicular(point: Vector, from: Vector, to: Vector) -> (Vector, Vector) {
    let way = between(from, to);
    let along = scaled(1.0 / length(way), way);
    (ahead(from, dot(along, between(from, point)), along), left(along))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn shape(from: Vector, to: Vector, centre: Vector, direction: Direction) -> Shape {
        Shape::of(&Element::Arc { from, to, centre, direction })
    }

    fn line(from: Vector, to: Vector) -> Shape {
        Shape::of(&Element::Line { from, to })
    }

    fn assert_gap(first: &Shape, second: &Shape, expected: f64) {
        for (a, b) in [(first, second), (second, first)] {
            let (found, at) = gap(a, b);
            assert!((found - expected).abs() < 1e-12, "{a:?} {b:?}: {found}, not {expected}");
            // The place lies on the second.
            assert!(distance(b.nearest(at), at) < 1e-12);
        }
    }

    #[test]
    fn known_gaps() {
        let flat = line([0.0, 0.0], [10.0, 0.0]);
        assert_gap(&flat, &line([2.0, 3.0], [20.0, 3.0]), 3.0);
        assert_gap(&flat, &line([13.0, 4.0], [20.0, 4.0]), 5.0);
        assert_gap(&flat, &line([5.0, -1.0], [6.0, 1.0]), 0.0);
        assert_gap(&flat, &line([5.0, 2.0], [6.0, 9.0]), 2.0);
        // On one straight line.
        assert_gap(&flat, &line([12.0, 0.0], [20.0, 0.0]), 2.0);
        assert_gap(&flat, &line([3.0, 0.0], [20.0, 0.0]), 0.0);

        // The upper half of a circle about (5, 4) of radius 3, and the lower one.
        let (right, left) = ([8.0, 4.0], [2.0, 4.0]);
        let upper = shape(right, left, [5.0, 4.0], Direction::Ccw);
        let lower = shape(right, left, [5.0, 4.0], Direction::Cw);
        assert_gap(&flat, &upper, 4.0);
        assert_gap(&flat, &lower, 1.0);
        let through = line([5.0, -9.0], [5.0, 9.0]);
        assert_gap(&through, &upper, 0.0);
        assert_gap(&line([5.0, 3.0], [5.0, 5.0]), &lower, 2.0);

        // Full circles: one inside the other, apart, crossing, about one centre, the same.
        let circle = |centre: Vector, radius| {
            let from = ahead(centre, radius, [0.6, 0.8]);
            shape(from, from, centre, Direction::Cw)
        };
        let large = circle([0.0, 0.0], 10.0);
        assert_gap(&large, &circle([3.0, 4.0], 2.0), 3.0);
        assert_gap(&large, &circle([12.0, 16.0], 4.0), 6.0);
        assert_gap(&large, &circle([6.0, 8.0], 4.0), 0.0);
        assert_gap(&large, &circle([0.0, 0.0], 4.0), 6.0);
        assert_gap(&large, &large, 0.0);
        assert_gap(&large, &line([0.0, 0.0], [1.0, 1.0]), 10.0 - f64::sqrt(2.0));
    }

    #[test]
    fn bounds_reach_as_far_as_the_arc() {
        let arc = shape([3.0, 4.0], [4.0, -3.0], [0.0, 0.0], Direction::Ccw);
        let [least, most] = arc.bounds();
        assert!(distance(least, [-5.0, -5.0]) < 1e-12 && distance(most, [4.0, 5.0]) < 1e-12);
        let arc = shape([3.0, 4.0], [4.0, -3.0], [0.0, 0.0], Direction::Cw);
        let [least, most] = arc.bounds();
        assert!(distance(least, [3.0, -3.0]) < 1e-12 && distance(most, [5.0, 4.0]) < 1e-12);
    }

    fn any_element() -> impl Strategy<Value = Element> {
        let point = || [-10.0..10.0, -10.0..10.0];
        let arc = (point(), 0.1..10.0, 0.0..TAU, 0.0..TAU, any::<bool>(), 0..8).prop_map(
            |(centre, radius, first, second, is_left, full)| {
                let at = |angle: f64| ahead(centre, radius, [angle.cos(), angle.sin()]);
                let (from, to) = (at(first), at(if full == 0 { first } else { second }));
                let direction = if is_left { Direction::Ccw } else { Direction::Cw };
                Element::Arc { from, to, centre, direction }
            },
        );
        let line = (point(), point()).prop_map(|(from, to)| Element::Line { from, to });
        prop_oneof![line, arc]
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1500) })]

        /// No two sampled points are nearer, and some are as near but for half the steps between them.
        #[test]
        fn the_gap_is_that_of_the_nearest_samples(first in any_element(), second in any_element()) {
            const STEPS: usize = 250;
            let points = [first, second].map(|element| super::super::tests::sample(&element, STEPS));
            let [a, b] = &points;
            let sampled = a
                .iter()
                .flat_map(|a| b.iter().map(|b| distance(*a, *b)))
                .fold(f64::INFINITY, f64::min);
            // No element is longer than 2π 10 mm; a point is at most half a step from a sample.
            let step: f64 = points.iter().map(|p| distance(p[0], p[1])).sum();
            let (found, at) = gap(&Shape::of(&first), &Shape::of(&second));
            prop_assert!(found <= sampled + 1e-9, "{} over {}", found, sampled);
            prop_assert!(found >= sampled - 0.51 * step - 1e-9, "{} far below {}", found, sampled);
            let off = b.iter().map(|b| distance(*b, at)).fold(f64::INFINITY, f64::min);
            prop_assert!(off <= 0.51 * step + 1e-9, "{:?} is off the second by {}", at, off);
        }
    }
}
