//! A block as the compensation sees it: its two ends, and which way the tool lies there.

use super::vector::{Vector, ahead, between, cross, distance, dot, left, length, scaled};
use super::{Block, Element, OvercutKind, Side};
use onepulse_core::Direction;
use std::f64::consts::TAU;

/// What is too small to be told from rounding, in millimetres: tips of radius vectors that close are one.
pub(super) const TOUCH: f64 = 1e-9;

/// A block of the section, not of length zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Curve {
    /// Its place: 0 the approach, then the contour's blocks from 1, then the leave.
    pub(super) index: usize,
    pub(super) block: Block,
    pub(super) start: End,
    pub(super) end: End,
    /// The length as programmed, in millimetres.
    pub(super) length: f64,
}

/// A curve near one of its ends: the circle (or line) it runs on there.
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    pub(super) point: Vector,
    /// The unit vector in the direction of travel.
    pub(super) tangent: Vector,
    /// The unit vector towards the tool.
    pub(super) normal: Vector,
    /// 1/R if the curve bends towards the tool, −1/R if away from it, 0 for a line.
    pub(super) curvature: f64,
}

impl End {
    /// The tip of the radius vector: where the tool's centre is when it touches here. On an arc that is the
    /// point scaled about the centre by 1 ± r/R.
    pub(super) fn tip(&self, radius: f64) -> Vector {
        ahead(self.point, radius, self.normal)
    }

    /// The tip carried along the tangent, in millimetres.
    pub(super) fn lengthened(&self, radius: f64, by: f64) -> Vector {
        ahead(self.tip(radius), by, self.tangent)
    }

    /// The radius of the circle on which the tool's centre runs: infinite along a line, negative if the
    /// tool is larger than the arc.
    pub(super) fn offset_radius(&self, radius: f64) -> f64 {
        1.0 / self.curvature.abs() - self.curvature.signum() * radius
    }
}

impl Curve {
    /// The block's curve; none if it is a line of no length.
    ///
    /// # Errors
    /// Numbers out of range, or what is no arc.
    pub(super) fn of(index: usize, block: Block, side: Side) -> Result<Option<Self>, OvercutKind> {
        let sign = if side == Side::Left { 1.0 } else { -1.0 };
        let (start, end, length) = match block.element {
            Element::Line { from, to } => {
                in_range(&[from, to])?;
                let way = between(from, to);
                let length = length(way);
                if length <= TOUCH {
                    return Ok(None);
                }
                let tangent = scaled(1.0 / length, way);
                let normal = scaled(sign, left(tangent));
                let end = |point| End { point, tangent, normal, curvature: 0.0 };
                (end(from), end(to), length)
            }
            Element::Arc { from, to, centre, direction } => {
                in_range(&[from, to, centre])?;
                let radii = [distance(centre, from), distance(centre, to)];
                let least = radii[0].min(radii[1]);
                if least <= TOUCH || (radii[0] - radii[1]).abs() > 0.1 * least {
                    return Err(OvercutKind::NoArc { radii });
                }
                let turn = if direction == Direction::Ccw { 1.0 } else { -1.0 };
                let end = |point, radius: f64| {
                    let seen = scaled(1.0 / radius, between(centre, point));
                    End {
                        point,
                        tangent: scaled(turn, left(seen)),
                        normal: scaled(-sign * turn, seen),
                        curvature: sign * turn / radius,
                    }
                };
                let length = sweep(from, to, centre, direction) * (radii[0] + radii[1]) / 2.0;
                (end(from, radii[0]), end(to, radii[1]), length)
            }
        };
        Ok(Some(Self { index, block, start, end, length }))
    }

    pub(super) fn is_line(&self) -> bool {
        matches!(self.block.element, Element::Line { .. })
    }

    /// The radius of an arc that is no larger than the tool, on whose side its centre is.
    pub(super) fn arc_within(&self, radius: f64) -> Option<f64> {
        let most = self.start.curvature.max(self.end.curvature);
        (most > 0.0 && 1.0 / most <= radius + TOUCH).then(|| 1.0 / most)
    }
}

/// How far an arc turns, in radians: over 0, to a full circle if its ends are equal.
pub(super) fn sweep(from: Vector, to: Vector, centre: Vector, direction: Direction) -> f64 {
    let [from, to] = [from, to].map(|point| between(centre, point));
    let turn = if direction == Direction::Ccw { 1.0 } else { -1.0 };
    let angle = (turn * cross(from, to)).atan2(dot(from, to));
    // Equal ends give 0 exactly.
    if angle > 0.0 { angle } else { angle + TAU }
}

/// Whether all coordinates are numbers in the range.
fn in_range(points: &[Vector]) -> Result<(), OvercutKind> {
    let outside = points.iter().flatten().find(|c| !(-1e7..=1e7).contains(*c));
    outside.map_or(Ok(()), |&coordinate| Err(OvercutKind::OutOfRange { coordinate }))
}
