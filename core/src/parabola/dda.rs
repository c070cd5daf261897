//! Parabola by digital integration.

use super::Shape;
use super::way::{ACROSS, ALONG, Way};
use crate::dda::{Preset, Radix, Register};
use crate::{Error, Pulse};

/// A parabola from its vertex, by two integrators.
///
/// From v² = 2|p|·u follows v dv = |p| du: the integrand register of the axis of symmetry holds v and
/// is corrected by one with every pulse across, that of the other axis holds |p| for good. Every
/// clock adds both, with the integrands as they stood before it; the carries out of the n-bit
/// remainder registers are the pulses. Two end counters: an axis whose counter is spent stops
/// iterating.
///
/// It always ends. The integrand |p| ≥ 1 brings the crosswise axis a carry in every 2ⁿ clocks at
/// least, until it stands; then v ≥ 1 does the same for the other, unless the end point is on the
/// axis of symmetry itself: there v stays 0, and the remaining pulses are sent one a clock.
///
/// **It keeps within one pulse of the parabola with half load and one headroom bit**: if |p| and
/// the last v are below 2ⁿ⁻¹, no point is farther from it than that, for every n. That holds until an
/// axis stands, and to an end point on the parabola until the end. What it rests on is
/// F = v² − 2|p|·u with the remainders in it, Φ = 2ⁿ·v² + 2av − 2|p|(2ⁿ·u + b), where a and b are they,
/// across and along, less 2ⁿ⁻¹: a pulse across adds 0 to 2(|p| − 1) to it, and nothing else changes it.
/// The argument is in `docs/proofs/parabola_dda.md`.
///
/// With no headroom, or with the other presets, a pulse is not kept:
///
/// | preset | proved for every n | with one headroom bit | with two |
/// |---|---|---|---|
/// | zero | 5√2/4 = 1.768 | √2 = 1.414 | √2 |
/// | half load | √2 | 1 | 5√2/8 = 0.884 |
/// | full load | √5/2 = 1.118 | √5/2 | √5/2 |
///
/// The farthest points of all parabolas that an n-bit register holds, up to the pulse with which an
/// axis stands (measured on every one):
///
/// | preset | n = 2 | 3 | 4 | 5 | 6 | 7 | 8 | |
/// |---|---|---|---|---|---|---|---|---|
/// | zero | 1.126 | 1.225 | 1.251 | 1.335 | 1.350 | 1.365 | 1.371 | p = 255 at (112, 241) |
/// | half load | 0.567 | 0.624 | 0.783 | 0.870 | 0.976 | 0.974 | 1.017 | p = 232 at (130, 247) |
/// | full load | 0.647 | 0.843 | 0.929 | 0.967 | 1.006 | 1.038 | 1.062 | p = 18 at (4, 10) |
///
/// With full load p = 66 in 11 bits comes to 1.103 at (10, 34); with half load and one headroom bit p = 95
/// in 8 bits to 0.837 at (59, 107).
///
/// ```
/// use onepulse_core::dda::{Preset, Radix, Register};
/// use onepulse_core::{Axis, parabola};
/// let shape = parabola::Shape::new(Axis::X, 2, [4, 4])?; // y² = 4x
/// let register = Register::new(Radix::Binary, 3)?;
/// let mut curve = parabola::Dda::new(shape, register, Preset::Half)?;
/// assert_eq!(curve.by_ref().filter(|pulse| !pulse.is_none()).count(), 6); // two of both axes
/// assert_eq!(curve.position(), [4, 4]);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dda {
    jr: [u64; 2],
    way: Way,
    register: Register,
}

impl Dda {
    /// The parabola of this shape in registers like `register`.
    ///
    /// # Errors
    /// A decimal register; one narrower than [`Dda::bits`].
    pub fn new(shape: Shape, register: Register, preset: Preset) -> Result<Self, Error> {
        if register.radix() != Radix::Binary {
            return Err(Error::ParabolaNeedsBinary);
        }
        let needed = Self::bits(&shape);
        if register.digits() < needed {
            return Err(Error::RegisterTooNarrow { digits: register.digits(), needed });
        }
        Ok(Self { jr: [preset.value(register); 2], way: Way::new(shape), register })
    }

    /// The parabola in this state, reachable or not; `jr` and `point` along the axis of symmetry
    /// and across it.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(shape: Shape, register: Register, jr: [u64; 2], point: [u32; 2]) -> Self {
        Self { jr, way: Way::in_state(shape, point), register }
    }

    /// The narrowest register that serves the parabola, in bits: it holds |p|, and v at the end,
    /// where it is largest.
    #[must_use]
    pub fn bits(shape: &Shape) -> u32 {
        let largest = shape.parameter().unsigned_abs().max(shape.magnitude()[ACROSS]);
        Register::holding(Radix::Binary, largest).digits()
    }

    /// One accumulation of both integrators; `None` once the end point is reached.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        let stands = self.way.stands();
        if stands == [true, true] {
            return None;
        }
        let jv = self.addends();
        let feeds = if stands[ACROSS] && jv[ALONG] == 0 {
            [true, false]
        } else {
            [ALONG, ACROSS].map(|axis| !stands[axis] && self.add(axis, jv[axis]))
        };
        let pulse = self.way.feed(feeds);
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// Adds to a remainder register; whether it overflowed.
    #[inline]
    fn add(&mut self, axis: usize, integrand: u64) -> bool {
        let modulus = self.register.modulus();
        let sum = self.jr[axis] + integrand;
        let carry = sum >= modulus;
        self.jr[axis] = if carry { sum - modulus } else { sum };
        carry
    }

    #[inline]
    fn addends(&self) -> [u64; 2] {
        let parameter = self.way.shape().parameter().unsigned_abs();
        [self.way.point()[ACROSS], parameter].map(u64::from)
    }

    /// The integrand registers of x and of y.
    #[must_use]
    pub fn integrands(&self) -> [u64; 2] {
        self.shape().reorder(self.addends())
    }

    /// The remainder registers of x and of y.
    #[must_use]
    pub const fn remainders(&self) -> [u64; 2] {
        self.shape().reorder(self.jr)
    }

    /// The width of the registers.
    #[must_use]
    pub const fn register(&self) -> Register {
        self.register
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

    /// What the two end counters hold together: pulses, not clocks.
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

    /// What always holds: every register is within its width, and no axis is past its end.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let is_held = |content: &u64| *content < self.register.modulus();
        self.way.invariant() && self.jr.iter().all(is_held) && self.addends().iter().all(is_held)
    }
}

impl Iterator for Dda {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
