//! Parabola by point-by-point comparison.

use super::Shape;
use super::way::{ACROSS, ALONG, Way};
use crate::{Error, Pulse};

/// A parabola from its vertex, one pulse a step.
///
/// F = v² − 2|p|·u: F ≥ 0 (on the parabola or outside) feeds the axis of symmetry and takes 2|p|
/// from F; F < 0 (inside) feeds across it and adds 2v + 1. An axis at its end coordinate stands.
///
/// Before one does, always −2|p| ≤ F ≤ 2v − 2 (F ≤ 0 while v = 0), for 2|p| is taken from F ≥ 0
/// only, and 2v + 1 added to F ≤ −1 only, after which v is one more. Where F < 0 the parabola lies
/// |F|/2|p| ≤ 1 further back along the axis of symmetry; where F > 0, it lies at
/// √(v² − F) ≥ √((v − 1)² + 1) across, less than 1 from v. So the point is within one pulse of the
/// parabola, measured along an axis, and all the more in the plane. The first pulse of every
/// parabola goes along the axis of symmetry to (1, 0), which is just one pulse away.
///
/// F is kept by additions alone and fits an `i64` whatever p and the end are: with both axes on
/// their way by the bounds above, and with one standing because −2·2³¹·2³¹ ≤ F ≤ 2³¹·2³¹.
///
/// ```
/// use onepulse_core::{Axis, Pulse, parabola};
/// let shape = parabola::Shape::new(Axis::X, 2, [4, -4])?; // y² = 4x, the lower branch
/// let mut curve = parabola::Ppc::new(shape)?;
/// assert_eq!(curve.step(), Some(Pulse([1, 0])));
/// assert_eq!(curve.step(), Some(Pulse([0, -1])));
/// assert_eq!(curve.count(), 6); // eight steps in all: 4 + 4
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ppc {
    f: i64,
    way: Way,
}

impl Ppc {
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

    /// One step of four beats; `None` once the end point is reached.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        if self.is_done() {
            return None;
        }
        let [stands, stands_across] = self.way.stands();
        let feeds_along = self.f >= 0 && !stands || stands_across;
        let across = i64::from(self.way.point()[ACROSS]);
        self.f += if feeds_along { -self.way.shape().double_parameter() } else { 2 * across + 1 };
        let pulse = self.way.feed([feeds_along, !feeds_along]);
        debug_assert!(self.invariant());
        Some(pulse)
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

    /// Steps still to come: the pulses of both axes together.
    #[must_use]
    pub fn remaining(&self) -> u64 {
        let [x, y] = self.pulses_to_go();
        x + y
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
    /// their way −2|p| ≤ F ≤ 2v − 2, or F ≤ 0 where v = 0.
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
        self.way.invariant()
            && (stands
                || stands_across
                || -self.way.shape().double_parameter() <= self.f
                    && self.f <= (2 * across - 2).max(0))
    }

    /// The magnitudes of the present point along the axis of symmetry and across it.
    #[must_use]
    pub const fn along_and_across(&self) -> [u32; 2] {
        let point = self.way.point();
        [point[ALONG], point[ACROSS]]
    }
}

impl Iterator for Ppc {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
