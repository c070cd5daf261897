//! How far points are from lines and arcs, by their definitions.

use onepulse_core::Direction;
use onepulse_plan::compensation::Element;
use std::f64::consts::TAU;

/// A point of a plane, in millimetres.
pub(crate) type Point = [f64; 2];

pub(crate) fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// How far a point is on the left of the whole line or circle, as it is run through.
pub(crate) fn left_of(element: &Element, point: Point) -> f64 {
    match *element {
        Element::Line { from, to } => {
            let [x, y] = [to[0] - from[0], to[1] - from[1]];
            (x * (point[1] - from[1]) - y * (point[0] - from[0])) / distance(from, to)
        }
        Element::Arc { from, centre, direction, .. } => {
            let inside = distance(centre, from) - distance(centre, point);
            if direction == Direction::Ccw { inside } else { -inside }
        }
    }
}

/// How far a point is from an element, ends and all.
pub(crate) fn away(element: &Element, point: Point) -> f64 {
    let [from, to] = element.ends();
    let ends = distance(from, point).min(distance(to, point));
    let is_beside = match *element {
        Element::Line { from, to } => {
            let along = |p: Point| {
                (to[0] - from[0]) * (p[0] - from[0]) + (to[1] - from[1]) * (p[1] - from[1])
            };
            (0.0..=along(to)).contains(&along(point)) && from != to
        }
        Element::Arc { from, to, centre, direction } => {
            turn(from, point, centre, direction) <= turn(from, to, centre, direction)
        }
    };
    if is_beside { left_of(element, point).abs() } else { ends }
}

/// Points of an element from its start to its end.
pub(crate) fn samples(element: &Element) -> impl Iterator<Item = Point> {
    const PARTS: u32 = 8;
    let element = *element;
    (0..=PARTS).map(move |part| {
        let share = f64::from(part) / f64::from(PARTS);
        match element {
            Element::Line { from, to } => {
                [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]))
            }
            Element::Arc { from, to, centre, direction } => {
                let turned = share * turn(from, to, centre, direction);
                let sense = if direction == Direction::Ccw { 1.0 } else { -1.0 };
                let (sin, cos) = (sense * turned).sin_cos();
                let [x, y] = [from[0] - centre[0], from[1] - centre[1]];
                [centre[0] + x * cos - y * sin, centre[1] + x * sin + y * cos]
            }
        }
    })
}

/// The angle from a point to another about a centre: more than nothing, at most a turn.
fn turn(from: Point, to: Point, centre: Point, direction: Direction) -> f64 {
    let angle = |point: Point| (point[1] - centre[1]).atan2(point[0] - centre[0]);
    let sense = if direction == Direction::Ccw { 1.0 } else { -1.0 };
    match (sense * (angle(to) - angle(from))).rem_euclid(TAU) {
        _ if from == to => TAU,
        0.0 => TAU,
        turn => turn,
    }
}
