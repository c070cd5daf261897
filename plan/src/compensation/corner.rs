//! The form of the transition between two blocks (转接形式).

use super::curve::{End, TOUCH};
use super::vector::{Vector, ahead, cross, dot, length, sum};

/// How the path goes on from one block to the next. α is the angle between the two programmed curves on the
/// side where the tool is not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Corner {
    /// The tips of both radius vectors are one point.
    Tangent,
    /// 180° ≤ α ≤ 360°, an inside corner (缩短型).
    Shorten,
    /// 90° ≤ α < 180° (伸长型).
    Extend,
    /// 0° ≤ α < 90° (插入型).
    Insert,
}

/// A cosine below which an angle is more than a right one. At the right angle extending and inserting make
/// the same path, so that nothing but the length of the link, 2 r times this, hangs on it.
const RIGHT_ANGLE: f64 = -1e-12;

/// What rounding leaves of the sine of a straight angle.
const STRAIGHT_ANGLE: f64 = 1e-14;

impl Corner {
    /// The transition between the end of one curve and the start of the next.
    pub(super) fn between(before: &End, after: &End, radius: f64) -> Self {
        let onward = dot(before.tangent, after.tangent);
        // The sine of the turn, positive towards the tool.
        let inward = dot(before.normal, after.tangent);
        if radius * length(ahead(before.normal, -1.0, after.normal)) <= TOUCH {
            return Self::Tangent;
        }
        if turns_back(before, after, radius) {
            // Backward along the first curve and forward along the second both bend away from the
            // other's tool, or towards it: then α is 360°, and the tool fits in where they are apart.
            let bend = before.curvature + after.curvature;
            let least = 1e-9 * (before.curvature.abs() + after.curvature.abs());
            return if bend < -least { Self::Shorten } else { Self::Insert };
        }
        if inward > 0.0 {
            Self::Shorten
        } else if onward >= RIGHT_ANGLE {
            Self::Extend
        } else {
            Self::Insert
        }
    }

    pub(super) fn is_outside(self) -> bool {
        matches!(self, Self::Extend | Self::Insert)
    }

    /// The points at which the path along the two tangents turns: one if the corner is extended, two
    /// if a link is inserted, none otherwise.
    pub(super) fn turns(self, before: &End, after: &End, radius: f64) -> Vec<Vector> {
        match self {
            Self::Extend => {
                let both = sum(before.normal, after.normal);
                let share = 1.0 + dot(before.normal, after.normal);
                vec![ahead(before.point, radius / share, both)]
            }
            Self::Insert => {
                vec![before.lengthened(radius, radius), after.lengthened(radius, -radius)]
            }
            Self::Tangent | Self::Shorten => vec![],
        }
    }
}

/// Whether the tangents of two curves are opposed, but for rounding.
pub(super) fn turns_back(before: &End, after: &End, radius: f64) -> bool {
    let inward = dot(before.normal, after.tangent);
    dot(before.tangent, after.tangent) < 0.0
        && (inward.abs() <= STRAIGHT_ANGLE
            || radius * length(sum(before.normal, after.normal)) <= TOUCH)
}

/// 1 + the cosine of the turn, to full precision even where the curves nearly turn back.
pub(super) fn openness(before: &End, after: &End) -> f64 {
    let onward = dot(before.tangent, after.tangent);
    if onward < 0.0 {
        cross(before.tangent, after.tangent).powi(2) / (1.0 - onward)
    } else {
        1.0 + onward
    }
}
