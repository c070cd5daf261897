//! Random closed contours of lines and arcs that do not meet themselves, some 100 mm wide.
//!
//! They are polylines of the library `cavalier_contours`: each vertex carries the bulge of the segment behind
//! it, which is the tangent of a quarter of its sweep: 0 for a line, positive for counter-clockwise.

use cavalier_contours::polyline::{BooleanOp, PlineSource, PlineSourceMut, Polyline};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Half the width of the contours.
const SIZE: f64 = 50.0;

/// Any contour, beginning in the middle of one of its segments. Every fourth has its corners rounded to a
/// thousandth, as programs have: what was tangent is nearly so.
pub(crate) fn contours() -> impl Strategy<Value = Polyline> {
    let kinds = prop_oneof![stars(), rounded(), merged(), circles()];
    let written = (kinds, prop::bool::weighted(0.25)).prop_map(|(mut contour, is_written)| {
        if is_written {
            for k in 0..contour.vertex_count() {
                let corner = contour.at(k);
                let [x, y] = [corner.x, corner.y].map(|part| (part * 1000.0).round() / 1000.0);
                contour.set(k, x, y, corner.bulge);
            }
        }
        contour
    });
    let simple = written.prop_filter("the contour meets itself", |contour| {
        contour.vertex_count() >= 2
            && contour.iter_segments().all(|(start, end)| (end.pos() - start.pos()).length() > 1e-3)
            // The library is not exact along arcs that are nearly lines.
            && contour.iter_vertexes().all(|v| v.bulge == 0.0 || v.bulge.abs() > 1e-3)
            && !contour.scan_for_self_intersect()
    });
    (simple, any::<bool>(), any::<prop::sample::Index>()).prop_map(
        |(mut contour, is_turned, first)| {
            if is_turned {
                contour.invert_direction_mut();
            }
            from_the_middle(&contour, first.index(contour.vertex_count()))
        },
    )
}

/// The same contour from the middle of one of its segments.
pub(crate) fn from_the_middle(contour: &Polyline, segment: usize) -> Polyline {
    let next = contour.at(contour.next_wrapping_index(segment));
    let middle = cavalier_contours::polyline::seg_midpoint(contour.at(segment), next);
    contour.rotate_start(segment, middle, 1e-9).unwrap()
}

pub(crate) fn polyline(vertices: impl IntoIterator<Item = ([f64; 2], f64)>) -> Polyline {
    let mut contour = Polyline::new_closed();
    for ([x, y], bulge) in vertices {
        contour.add(x, y, bulge);
    }
    contour
}

/// The corners of a polygon that a ray from the origin meets once.
fn corners() -> impl Strategy<Value = Vec<[f64; 2]>> {
    prop::collection::vec((0.3..1.0_f64, 0.2..1.0_f64), 3..9).prop_map(|polar| {
        let all: f64 = polar.iter().map(|(_, share)| share).sum();
        let mut angle = 0.0;
        let corner = |(radius, share): (f64, f64)| {
            angle += TAU * share / all;
            [SIZE * radius * f64::cos(angle), SIZE * radius * f64::sin(angle)]
        };
        polar.into_iter().map(corner).collect()
    })
}

/// Lines and arcs, which bulge either way, from corner to corner: no corner is tangent.
fn stars() -> impl Strategy<Value = Polyline> {
    let bulge = prop_oneof![Just(0.0), 0.05..0.9_f64, -0.9..-0.05_f64];
    (corners(), prop::collection::vec(bulge, 8))
        .prop_map(|(corners, bulges)| polyline(corners.into_iter().zip(bulges)))
}

/// Polygons, some of whose corners are rounded by a tangent arc.
fn rounded() -> impl Strategy<Value = Polyline> {
    let share = prop_oneof![1 => Just(0.0), 3 => 0.02..0.49_f64];
    (corners(), prop::collection::vec(share, 8)).prop_map(|(corners, shares)| {
        let count = corners.len();
        let mut contour = Polyline::new_closed();
        for (k, [x, y]) in corners.iter().enumerate() {
            let to = |other: usize| [corners[other % count][0] - x, corners[other % count][1] - y];
            let (back, on) = (to(k + count - 1), to(k + 1));
            let length = back[0].hypot(back[1]).min(on[0].hypot(on[1]));
            let at = |[dx, dy]: [f64; 2]| {
                let share = shares[k] * length / dx.hypot(dy);
                (x + share * dx, y + share * dy)
            };
            let turn =
                (back[1] * on[0] - back[0] * on[1]).atan2(-back[0] * on[0] - back[1] * on[1]);
            if shares[k] > 0.0 {
                let start = at(back);
                contour.add(start.0, start.1, (turn / 4.0).tan());
            }
            let end = at(on);
            contour.add(end.0, end.1, 0.0);
        }
        contour
    })
}

/// Circles and slots over each other, some of them taken away: necks, pockets, bridges.
fn merged() -> impl Strategy<Value = Polyline> {
    let shape = (
        (-0.6..0.6_f64, -0.6..0.6_f64),
        (0.1..0.6_f64, 0.05..0.3_f64, 0.0..PI),
        prop_oneof![Just(0.0), Just(1.0), 0.05..0.9_f64],
        prop::bool::weighted(0.7),
    );
    prop::collection::vec(shape, 2..7).prop_map(|shapes| {
        let mut all = None;
        for ((x, y), (length, width, angle), bulge, is_added) in shapes {
            let corner = |along: f64, across: f64| {
                let (along, across) = (along * length * SIZE, across * width * SIZE);
                [
                    x * SIZE + along * angle.cos() - across * angle.sin(),
                    y * SIZE + along * angle.sin() + across * angle.cos(),
                ]
            };
            let slot = polyline([
                (corner(-1.0, -1.0), 0.0),
                (corner(1.0, -1.0), bulge),
                (corner(1.0, 1.0), 0.0),
                (corner(-1.0, 1.0), bulge),
            ]);
            let Some(before) = all.take() else {
                all = Some(slot);
                continue;
            };
            let operation = if is_added { BooleanOp::Or } else { BooleanOp::Not };
            let parts = Polyline::boolean(&before, &slot, operation).pos_plines;
            let largest = parts.into_iter().map(|part| part.pline);
            all = largest.max_by(|one, other| one.area().abs().total_cmp(&other.area().abs()));
        }
        all.unwrap_or_default()
    })
}

/// Full circles, in two halves.
fn circles() -> impl Strategy<Value = Polyline> {
    (0.02..1.0_f64, 0.0..FRAC_PI_2).prop_map(|(radius, angle)| {
        let [x, y] = [angle.cos(), angle.sin()].map(|part| radius * SIZE * part);
        polyline([([x, y], 1.0), ([-x, -y], 1.0)])
    })
}
