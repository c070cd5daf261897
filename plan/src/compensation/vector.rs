//! Vectors of the plane.

/// A point or a vector; millimetres unless it is a direction.
pub(super) type Vector = [f64; 2];

/// `start` + `factor` · `along`.
pub(super) fn ahead(start: Vector, factor: f64, along: Vector) -> Vector {
    [start[0] + factor * along[0], start[1] + factor * along[1]]
}

/// The vector from one point to another.
pub(super) fn between(from: Vector, to: Vector) -> Vector {
    ahead(to, -1.0, from)
}

pub(super) fn sum(a: Vector, b: Vector) -> Vector {
    ahead(a, 1.0, b)
}

pub(super) fn scaled(factor: f64, [x, y]: Vector) -> Vector {
    [factor * x, factor * y]
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Positive if `b` is counter-clockwise of `a`.
pub(super) fn cross(a: Vector, b: Vector) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

pub(super) fn length([x, y]: Vector) -> f64 {
    x.hypot(y)
}

pub(super) fn distance(a: Vector, b: Vector) -> f64 {
    length(between(a, b))
}

/// A quarter turn counter-clockwise.
pub(super) fn left([x, y]: Vector) -> Vector {
    [-y, x]
}
