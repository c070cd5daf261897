//! Parabola by minimum deviation: the nearest of three steps.

use super::Shape;
use super::way::{ACROSS, Way};
use crate::{Error, Pulse};

/// A parabola from its vertex, one or both axes a step.
///
/// Of the points that a pulse along the axis of symmetry, one across it, or both lead to, the one
/// with the smallest |F| is taken, F = v² − 2|p|·u. Between the step across and the diagonal one
/// F differs by 2|p|, so it may be |p| and −|p|: then the single pulse is made. (No other two can
/// be alike: their F differ, or add up, to an odd number.) An axis at its end coordinate stands
/// and leaves the other's single pulse alone.
///
/// Before one does, always −max(|p|, v) ≤ F ≤ max(|p|, v − 1), which is derived so. Let F be within
/// these bounds, F_u, F_v and F_d the three candidates.
///
/// * F_d ≥ 0 ≥ F_u: they differ by 2v + 1, so the nearer is v from 0 at most; if it is F_d, then v
///   grows by one.
/// * F_d ≤ 0 ≤ F_v: they differ by 2|p|, so the nearer is |p| from 0 at most.
/// * Else F_u > 0, and F_u = F − 2|p| is within the upper bound as F was; or F_v < 0, and
///   F_v = F + 2v + 1 is within the lower one.
///
/// Where |F| ≤ |p| the parabola is |F|/2|p| ≤ ½ away along the axis of symmetry. Otherwise it is
/// at √(v² − F) across, and (v − ½)² < v² − (v − 1) and v² + v < (v + ½)²: less than ½ away. **So
/// the point is within half a pulse of the parabola**, measured along an axis, and all the more in
/// the plane. The first step of y² = 2x is the tie, to (0, 1), half a pulse before (½, 1).
///
/// ```
/// use onepulse_core::{Axis, Pulse, parabola};
/// let shape = parabola::Shape::new(Axis::X, 1, [8, 4])?; // y² = 2x
/// let steps = parabola::MinimumDeviation::new(shape)?;
/// assert_eq!(steps.count(), 9);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MinimumDeviation {
    f: i64,
    way: Way,
}

impl MinimumDeviation {
    /// The parabola of this shape.
    ///
    /// # Errors
    /// None: every shape is served. (All machines of this crate are built alike.)
    pub const fn new(shape: Shape) -> Result<Self, Error> {
        Ok(Self { f: 0, way: Way::new(shape) })
    }

    /// The parabola at this place, reachable or not; `point` holds the magnitudes along the axis
    /// of symmetry and across it.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(shape: Shape, f: i64, point: [u32; 2]) -> Self {
        Self { f, way: Way::in_state(shape, point) }
    }

    /// One step, of one axis or of both; `None` once the end point is reached.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        let feeds = match self.way.stands() {
            [true, true] => return None,
            [false, false] => self.judge(),
            [stands, stands_across] => [!stands, !stands_across],
        };
        let [along, across] = self.changes();
        self.f += if feeds[0] { along } else { 0 } + if feeds[1] { across } else { 0 };
        let pulse = self.way.feed(feeds);
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// The axes that lead to the smallest |F|: along the axis of symmetry, and across it.
    #[inline]
    fn judge(&self) -> [bool; 2] {
        let [along, across] = self.changes();
        let off = |change: i64| (self.f + change).abs();
        let (straight, crosswise, diagonal) = (off(along), off(across), off(along + across));
        if straight < crosswise && straight < diagonal {
            [true, false]
        } else if crosswise <= diagonal {
            [false, true]
        } else {
            [true, true]
        }
    }

    /// What a pulse along the axis of symmetry and one across it add to F.
    #[inline]
    fn changes(&self) -> [i64; 2] {
        let across = i64::from(self.way.point()[ACROSS]);
        [-self.way.shape().double_parameter(), 2 * across + 1]
    }

    /// The deviation function F at the present point.
    #[must_use]
    pub const fn deviation_function(&self) -> i64 {
        self.f
    }

    /// The parabola.
    #[must_use]
    pub const fn shape(&self) -> &Shape {
        self.way.shape()
    }

    /// Whether the end point is reached.
    #[inline]
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.way.is_done()
    }

    /// Pulses of each axis between here and the end point.
    #[must_use]
    pub fn pulses_to_go(&self) -> [u64; 2] {
        self.way.pulses_to_go()
    }

    /// The present point, counted from the vertex.
    #[must_use]
    pub fn position(&self) -> [i64; 2] {
        self.way.position()
    }

    /// What is missing to the end point: zero when done.
    #[must_use]
    pub fn residual(&self) -> [i64; 2] {
        self.way.residual()
    }

    /// What always holds: F is that of the point, no axis is past its end, and while both are on
    /// their way −max(|p|, v) ≤ F ≤ max(|p|, v − 1).
    #[must_use]
    pub fn invariant(&self) -> bool {
        self.f == self.way.deviation_function() && self.bounds_hold()
    }

    /// The invariant but for F's own formula, whose products a proof may know otherwise than by
    /// multiplying.
    #[must_use]
    pub fn bounds_hold(&self) -> bool {
        let [stands, stands_across] = self.way.stands();
        let across = i64::from(self.way.point()[ACROSS]);
        let parameter = self.way.shape().double_parameter() / 2;
        self.way.invariant()
            && (stands
                || stands_across
                || -parameter.max(across) <= self.f && self.f <= parameter.max(across - 1))
    }

    /// The magnitudes of the present point along the axis of symmetry and across it.
    #[must_use]
    pub const fn along_and_across(&self) -> [u32; 2] {
        self.way.point()
    }
}

impl Iterator for MinimumDeviation {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
