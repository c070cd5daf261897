//! Elements of a program as curves of the library `cavalier_contours`, and distances between them.

use cavalier_contours::core::math::{Vector2, angle_from_bulge};
use cavalier_contours::polyline::{
    PlineSegIntr, PlineSource, PlineSourceMut, PlineVertex, Polyline, pline_seg_intr,
    seg_arc_radius_and_center, seg_closest_point,
};
use onepulse_core::Direction;
use onepulse_plan::compensation::Element;
use std::f64::consts::TAU;

/// Positions that the library may take for the same.
pub(crate) const SAME: f64 = 1e-9;

pub(crate) fn vector([x, y]: [f64; 2]) -> Vector2 {
    Vector2::new(x, y)
}

pub(crate) fn polyline_of<'a>(elements: impl IntoIterator<Item = &'a Element>) -> Polyline {
    let mut path = Polyline::new();
    let mut last = [0.0; 2];
    for element in elements {
        add(&mut path, element);
        last = match *element {
            Element::Line { to, .. } | Element::Arc { to, .. } => to,
        };
    }
    path.add(last[0], last[1], 0.0);
    path
}

/// An element as the library has it, in segments of at most half a circle.
fn add(path: &mut Polyline, element: &Element) {
    match *element {
        Element::Line { from: [x, y], .. } => path.add(x, y, 0.0),
        Element::Arc { from, to, centre, direction } => {
            let (start, end) = (vector(from) - vector(centre), vector(to) - vector(centre));
            let swept = start.perp_dot(end).atan2(start.dot(end));
            let sweep = match direction {
                _ if from == to => TAU,
                Direction::Ccw => swept.rem_euclid(TAU),
                Direction::Cw => (-swept).rem_euclid(TAU),
            };
            let sign = if direction == Direction::Ccw { 1.0 } else { -1.0 };
            let bulge = sign * (sweep / 12.0).tan();
            for part in 0..3 {
                let angle = sign * sweep * f64::from(part) / 3.0;
                let (sin, cos) = angle.sin_cos();
                let at = vector(centre)
                    + Vector2::new(start.x * cos - start.y * sin, start.x * sin + start.y * cos);
                path.add(at.x, at.y, bulge);
            }
        }
    }
}

/// Points of a segment of the path: evenly, and all that can be the nearest to the contour.
pub(crate) fn points(start: PlineVertex, end: PlineVertex, contour: &Polyline) -> Vec<Vector2> {
    let chord = end.pos() - start.pos();
    let sweep = angle_from_bulge(start.bulge);
    let at = |share: f64| {
        if sweep.abs() < 1e-9 {
            return start.pos() + chord.scale(share);
        }
        let (sin, cos) = (sweep * (share - 1.0) / 2.0).sin_cos();
        let way = chord.scale(cos) + chord.perp().scale(sin);
        start.pos() + way.scale((sweep * share / 2.0).sin() / (sweep / 2.0).sin())
    };
    let mut points: Vec<_> = (0..=32).map(|step| at(f64::from(step) / 32.0)).collect();
    // The library does not see shorter ones clearly.
    if chord.length() < 1e-3 {
        return points;
    }
    let arc = (start.bulge != 0.0).then(|| seg_arc_radius_and_center(start, end));
    // All points of an arc are as near to its centre.
    let has_nearest = |point: &Vector2| {
        arc.is_none_or(|(radius, centre)| (*point - centre).length() > 1e-6 * radius)
    };
    let nearest = |point| seg_closest_point(start, end, point, SAME);
    for (from, to) in contour.iter_segments() {
        let centre = (from.bulge != 0.0).then(|| seg_arc_radius_and_center(from, to).1);
        let across = arc.map(|(_, centre)| seg_closest_point(from, to, centre, SAME));
        let towards = [Some(from.pos()), centre, across].into_iter().flatten();
        points.extend(towards.filter(has_nearest).map(nearest));
        match pline_seg_intr(start, end, from, to, SAME) {
            PlineSegIntr::OneIntersect { point } => points.push(point),
            PlineSegIntr::TwoIntersects { point1, point2 } => points.extend([point1, point2]),
            _ => {}
        }
    }
    points
}

/// The least distance of the path's points from the contour, and where.
pub(crate) fn clearance(path: &Polyline, contour: &Polyline) -> (f64, Vector2) {
    let points = path.iter_segments().flat_map(|(start, end)| points(start, end, contour));
    let distances =
        points.map(|point| (contour.closest_point(point, SAME).unwrap().distance, point));
    distances.min_by(|one, other| one.0.total_cmp(&other.0)).unwrap()
}
