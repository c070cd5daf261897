//! Arcs by minimum deviation, vector discrimination and comparison integration, between lattice points
//! of one circle.

use super::{Machine, demand, path, take};
use crate::sweep::rings::all_arcs;
use crate::sweep::tally::Tally;
use crate::sweep::walk::Drawing;
use onepulse_core::{Direction, Error, Pulse, comparison, minimum_deviation, vector};

/// Whether F at a point with these magnitudes is within the method's bound.
type Bound = fn(f: i64, x: i64, y: i64) -> bool;

pub(super) fn machines(radius: i32) -> [Machine; 3] {
    let most = i64::from(radius).pow(2);
    [
        machine(
            "minimum deviation arcs",
            "−m ≤ F ≤ m, m the larger coordinate",
            most,
            |f, x, y| f.abs() <= x.max(y),
            |d| minimum_deviation::Arc::new(d.start, d.end, d.direction),
        ),
        machine(
            "vector arcs",
            "−2m ≤ F < 2m, m the larger coordinate",
            most,
            |f, x, y| (-2 * x.max(y)..2 * x.max(y)).contains(&f),
            |d| vector::Arc::new(d.start, d.end, d.direction),
        ),
        machine(
            "comparison arcs",
            "−s ≤ F ≤ s, s the sum of both coordinates",
            most,
            |f, x, y| f.abs() <= x + y,
            |d| comparison::Arc::new(d.start, d.end, d.direction),
        ),
    ]
}

fn machine<A: Iterator<Item = Pulse> + 'static>(
    name: &str,
    bound: &'static str,
    most: i64,
    is_within: Bound,
    new: fn(&Drawing) -> Result<A, Error>,
) -> Machine {
    let items = all_arcs(name, 0, most, move |drawing, tally| match new(drawing) {
        Ok(arc) => draw(drawing, arc, is_within, tally),
        Err(why) => tally.fault(drawing.curve(), 0, why.to_string()),
    });
    Machine { name: name.to_owned(), bound, items }
}

/// One arc: every point is within the bound, and every lattice point of the circle that lies on it is
/// passed, in their order, the last one at the end.
fn draw(drawing: &Drawing, arc: impl Iterator<Item = Pulse>, is_within: Bound, tally: &mut Tally) {
    let Drawing { start, end, direction, .. } = *drawing;
    let [from, to] = [start, end].map(|point| point.map(i64::from));
    let square = |[x, y]: [i64; 2]| x * x + y * y;
    // A full turn has 8R steps at most, of one axis each.
    let walked = path(from, arc, 8 * (square(from).isqrt() as usize + 1));
    let strays = |&&point: &&[i64; 2]| {
        let [x, y] = point.map(i64::abs);
        !is_within(square(point) - square(from), x, y)
    };
    let passed = walked[1..].iter().copied().filter(|point| square(*point) == square(from));
    let checked = demand(walked.last() == Some(&to), || "misses its end point".to_owned())
        .and_then(|()| match walked.iter().find(strays) {
            Some([x, y]) => Err(format!("leaves its bound at {x},{y}")),
            None => Ok(()),
        })
        .and_then(|()| {
            let is_right = passed.eq(ahead(from, to, direction));
            demand(is_right, || "passes other points of its circle than lie on it".to_owned())
        });
    take(tally, drawing.curve(), 0, &walked, checked);
}

/// The lattice points of the circle after `from` up to `to`, in the order of the arc.
fn ahead(from: [i64; 2], to: [i64; 2], direction: Direction) -> Vec<[i64; 2]> {
    let square = from[0] * from[0] + from[1] * from[1];
    let most = square.isqrt();
    // Half a turn ahead (0) or behind (1), then by the sign of the cross product.
    let cross = |a: [i64; 2], b: [i64; 2]| {
        let turn = a[0] * b[1] - a[1] * b[0];
        if direction == Direction::Ccw { turn } else { -turn }
    };
    let half = |point: [i64; 2]| {
        let ahead = cross(from, point);
        let is_opposite = point == from.map(|c| -c);
        // The start itself is a whole turn ahead.
        if point == from { 2 } else { u8::from(ahead < 0 && !is_opposite) }
    };
    let mut points: Vec<_> = (-most..=most)
        .flat_map(|x| {
            let y = (square - x * x).isqrt();
            [[x, y], [x, -y]]
        })
        .filter(|[x, y]| x * x + y * y == square)
        .collect();
    points.sort_unstable_by(|a, b| half(*a).cmp(&half(*b)).then(cross(*b, *a).cmp(&0)));
    points.dedup();
    let last = points.iter().position(|point| *point == to).map_or(0, |place| place + 1);
    points.truncate(last);
    points
}
