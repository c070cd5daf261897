//! Where the offsets of two curves meet at an inside corner.
//!
//! Put the corner at the origin. A curve through it with the unit vector n towards the tool and the
//! curvature κ (positive towards the tool, 0 for a line) has the offset
//!
//! n·x − κ x²/2 = r − κ r²/2,  or  n·x = r + κ w  with  w = (x² − r²)/2.
//!
//! Two such equations are linear in x, given w: x = x₀ + w x₁. Here x₀ is where the tangents'
//! offsets meet, and x² = r² + 2w leaves a quadratic equation, A w² − 2 B w + C = 0. The root
//! C/(B + √(B² − A C)) is the one that comes out of the corner as the radius grows from nothing; the
//! other comes from the other point that the two programmed curves have in common, where they cross
//! the other way. In A C, B and w x₁ the sine of the turn, by which x₁ divides, cancels, so that
//! nearly tangent curves do no harm.

use super::corner::{openness, turns_back};
use super::curve::End;
use super::vector::{Vector, ahead, cross, dot, length, scaled, sum};

/// What rounding may make of a discriminant of nothing, that of offsets that just touch.
const ROUNDING: f64 = 1e-12;

/// A point of both offsets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Meeting {
    pub(super) point: Vector,
    /// How much of the curve before the corner is not touched, in millimetres along it.
    pub(super) before: f64,
    /// How much of the curve after it.
    pub(super) after: f64,
}

/// Where the offsets meet at a corner that is neither tangent nor turns back; none if the tool is
/// too large.
pub(super) fn meeting(before: &End, after: &End, radius: f64) -> Option<Meeting> {
    let (k1, k2) = (before.curvature, after.curvature);
    let (n1, n2) = (before.normal, after.normal);
    if turns_back(before, after, radius) {
        return cusp(before, after, radius).map(|x| Meeting::at(x, before, after, radius));
    }
    let open = openness(before, after);
    let b = 1.0 - radius * (k1 + k2) / open;
    let discriminant = 1.0 - 2.0 / open * radius * (k1 + k2 - radius * k1 * k2);
    // As long as the tool is smaller than both arcs, the discriminant falls as the radius grows,
    // and b is positive up to where it vanishes.
    if !(b > 0.0 && discriminant >= -ROUNDING) {
        return None;
    }
    let x0 = scaled(radius / open, sum(n1, n2));
    // x₁ times the sine of the turn, and w divided by it.
    let x1 = [k1 * n2[1] - k2 * n1[1], k2 * n1[0] - k1 * n2[0]];
    let w = (radius / open).powi(2) * cross(n1, n2) / (b + discriminant.max(0.0).sqrt());
    Some(Meeting::at(ahead(x0, w, x1), before, after, radius))
}

/// Where the offsets of curves that turn back meet, away from their common tangent: with n₂ = −n₁ the sum of
/// the two equations is 0 = 2r + (κ₁ + κ₂) w.
fn cusp(before: &End, after: &End, radius: f64) -> Option<Vector> {
    let w = -2.0 * radius / (before.curvature + after.curvature);
    let across = radius + before.curvature * w;
    let along = radius * radius + 2.0 * w - across * across;
    let backward = scaled(-along.max(0.0).sqrt(), before.tangent);
    (w > 0.0 && along >= 0.0).then(|| ahead(backward, across, before.normal))
}

impl Meeting {
    /// At x or next to it, seen from the corner.
    fn at(x: Vector, before: &End, after: &End, radius: f64) -> Self {
        let once = settled(x, before, after, radius);
        let x = settled(once, before, after, radius);
        Self {
            point: sum(before.point, x),
            before: way(before, x, -1.0),
            after: way(after, x, 1.0),
        }
    }
}

/// The meeting once more, by a step of Newton's method: far from a corner that nearly turns back, x₀ and w x₁
/// are large and nearly cancel. Where the offsets nearly touch, such a step would go astray, and x is as good
/// as it gets.
fn settled(x: Vector, before: &End, after: &End, radius: f64) -> Vector {
    let missed = |end: &End| {
        let w = (dot(x, x) - radius * radius) / 2.0;
        dot(end.normal, x) - radius - end.curvature * w
    };
    let slope = |end: &End| ahead(end.normal, -end.curvature, x);
    let (s1, s2) = (slope(before), slope(after));
    let (m1, m2) = (missed(before), missed(after));
    let determinant = cross(s1, s2);
    let step = [(m1 * s2[1] - m2 * s1[1]) / determinant, (m2 * s1[0] - m1 * s2[0]) / determinant];
    let is_small = length(step) <= 1e-6 * (length(x) + radius);
    if is_small { ahead(x, -1.0, step) } else { x }
}

/// How far along the programmed curve the point is that the tool touches from x, forward or backward.
fn way(end: &End, x: Vector, sense: f64) -> f64 {
    let along = sense * dot(end.tangent, x);
    let bend = end.curvature.abs();
    let way = if bend > 0.0 {
        (bend * along).atan2(1.0 - end.curvature * dot(end.normal, x)) / bend
    } else {
        along
    };
    // The meeting stays on its side of the line through the centres: less than half a turn ahead.
    way.max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compensation::vector::{distance, left};

    fn end(tangent: Vector, curvature: f64) -> End {
        End { point: [0.0, 0.0], tangent, normal: left(tangent), curvature }
    }

    #[test]
    fn a_line_into_a_circle() {
        // Along y = 0, then on the circle about (-3, 4) of radius 5, its tangent at the origin
        // (0.8, 0.6). The offsets for r = 2, y = 2 and the circle of radius 3, meet in (-3 + √5,
        // 2).
        let meeting = meeting(&end([1.0, 0.0], 0.0), &end([0.8, 0.6], 0.2), 2.0).unwrap();
        let x = f64::sqrt(5.0) - 3.0;
        assert!(distance(meeting.point, [x, 2.0]) < 1e-12);
        assert!((meeting.before + x).abs() < 1e-12);
        // From the angle of (3, -4), seen from the centre, to that of (√5, -2).
        let turn = f64::atan2(-2.0, f64::sqrt(5.0)) - f64::atan2(-4.0, 3.0);
        assert!((meeting.after - 5.0 * turn).abs() < 1e-12);
    }

    #[test]
    fn lines_that_nearly_turn_back_lose_no_digits() {
        let slight = 1e-6_f64;
        let back = [-slight.cos(), slight.sin()];
        let meeting = meeting(&end([1.0, 0.0], 0.0), &end(back, 0.0), 3.0).unwrap();
        let expected = 3.0 / (slight / 2.0).tan();
        assert!((meeting.before / expected - 1.0).abs() < 1e-9);
        assert!((meeting.after / expected - 1.0).abs() < 1e-9);
    }
}
