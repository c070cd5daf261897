//! How far a machine has come on its parabola.

use super::Shape;
use crate::Pulse;
use crate::pulse::signed;

/// The places of the two motions in every pair below: along the axis of symmetry, and across it.
pub(super) const ALONG: usize = 0;
pub(super) const ACROSS: usize = 1;

/// The moving point, and the counters to the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Way {
    shape: Shape,
    /// Magnitudes: u and v.
    point: [u32; 2],
}

impl Way {
    pub(super) const fn new(shape: Shape) -> Self {
        Self { shape, point: [0; 2] }
    }

    #[cfg(feature = "proofs")]
    pub(super) const fn in_state(shape: Shape, point: [u32; 2]) -> Self {
        Self { shape, point }
    }

    pub(super) const fn shape(&self) -> &Shape {
        &self.shape
    }

    #[inline]
    pub(super) const fn point(&self) -> [u32; 2] {
        self.point
    }

    /// Whether each axis stands: it is at its end coordinate.
    #[inline]
    pub(super) fn stands(&self) -> [bool; 2] {
        let [along, across] = self.shape.magnitude();
        [self.point[ALONG] >= along, self.point[ACROSS] >= across]
    }

    #[inline]
    pub(super) fn is_done(&self) -> bool {
        self.stands() == [true, true]
    }

    /// Moves the axes that are fed by one pulse.
    #[inline]
    pub(super) fn feed(&mut self, feeds: [bool; 2]) -> Pulse {
        let [along, across] = self.shape.sign();
        self.point[ALONG] += u32::from(feeds[ALONG]);
        self.point[ACROSS] += u32::from(feeds[ACROSS]);
        Pulse(self.shape.reorder([
            if feeds[ALONG] { along } else { 0 },
            if feeds[ACROSS] { across } else { 0 },
        ]))
    }

    /// Pulses of x and of y still to come.
    pub(super) fn pulses_to_go(&self) -> [u64; 2] {
        self.shape.reorder(self.left()).map(u64::from)
    }

    pub(super) fn position(&self) -> [i64; 2] {
        self.with_signs(self.point)
    }

    pub(super) fn residual(&self) -> [i64; 2] {
        self.with_signs(self.left())
    }

    /// No axis is past its end.
    pub(super) fn invariant(&self) -> bool {
        let [along, across] = self.shape.magnitude();
        self.point[ALONG] <= along && self.point[ACROSS] <= across
    }

    /// v² − 2|p|·u.
    pub(super) fn deviation_function(&self) -> i64 {
        let [u, v] = self.point.map(u64::from);
        // 2⁶² and 2⁶³ at most; their difference is an `i64` again.
        let (square, product) = (v * v, self.shape.double_parameter().unsigned_abs() * u);
        square.wrapping_sub(product) as i64
    }

    #[inline]
    fn left(&self) -> [u32; 2] {
        let [along, across] = self.shape.magnitude();
        [along.saturating_sub(self.point[ALONG]), across.saturating_sub(self.point[ACROSS])]
    }

    fn with_signs(&self, [along, across]: [u32; 2]) -> [i64; 2] {
        let sign = self.shape.sign();
        let along = signed(sign[ALONG], i64::from(along));
        self.shape.reorder([along, signed(sign[ACROSS], i64::from(across))])
    }
}
