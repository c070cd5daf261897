//! The circuit of a parabola by point-by-point comparison.

use crate::Circuit;
use crate::probe::{Kind, Probe};
use crate::word::{mask, signed, wrap};
use onepulse_core::dda::{Radix, Register};
use onepulse_core::parabola::Shape;
use onepulse_core::{Axis, Error, Pulse};

/// The deviation register F, the distance v from the axis of symmetry, |p|, and an end counter along that
/// axis and one across it.
///
/// ```text
///  judge    along ← F ≥ 0 and JE along is not spent, or JE across is; else across
///  update   F ← F − 2·|p| (along)  or  F + 2v + 1, v ← v + 1 (across); the counter takes the pulse
/// ```
///
/// All in one clock, by one adder: what is taken goes in inverted, with a carry.
///
/// As long as both axes are on their way, −2·|p| ≤ F ≤ 2v − 2, or F ≤ 0 where v = 0. So |F| < 2ⁿ⁺¹: F has
/// n + 2 bits, and |p|, v and the counters n. Once an axis stands it does so to the end, and the counters
/// alone decide: F may wrap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ppc {
    registers: Registers,
    /// |p|, n bits; loaded once. Its place in the adder makes it 2·|p|.
    p: u64,
    /// The axis of symmetry.
    axis: Axis,
    /// Of x and of y.
    negative: [bool; 2],
    bits: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Registers {
    /// n + 2 bits, signed.
    f: i64,
    /// n bits.
    v: u64,
    /// End counters along the axis of symmetry and across it, n bits.
    je: [u64; 2],
}

impl Ppc {
    /// The circuit, loaded with the parabola, in registers of `bits` bits.
    ///
    /// # Errors
    /// A width of 0 or over 32 bits, or less than [`Ppc::bits`].
    pub fn new(shape: Shape, bits: u32) -> Result<Self, Error> {
        Register::new(Radix::Binary, bits)?;
        let needed = Self::bits(&shape);
        if bits < needed {
            return Err(Error::RegisterTooNarrow { digits: bits, needed });
        }
        let end = shape.end();
        let [x, y] = end.map(|c| u64::from(c.unsigned_abs()));
        let along_and_across = match shape.axis() {
            Axis::X => [x, y],
            Axis::Y => [y, x],
        };
        let p = u64::from(shape.parameter().unsigned_abs());
        Ok(Self::loaded(p, along_and_across, shape.axis(), end.map(|c| c < 0), bits))
    }

    /// The circuit after a load of these contents.
    const fn loaded(p: u64, je: [u64; 2], axis: Axis, negative: [bool; 2], bits: u32) -> Self {
        Self { registers: Registers { f: 0, v: 0, je }, p, axis, negative, bits }
    }

    /// The narrowest registers that serve the parabola, in bits: they hold |p| and the end point.
    #[must_use]
    pub fn bits(shape: &Shape) -> u32 {
        let [x, y] = shape.end().map(i32::unsigned_abs);
        let largest = x.max(y).max(shape.parameter().unsigned_abs());
        Register::holding(Radix::Binary, largest).digits()
    }

    /// Whether the axis of symmetry is the one that is due.
    #[inline(always)]
    const fn feeds_along(&self) -> bool {
        let [along, across] = self.registers.je;
        (self.registers.f >= 0) & (along != 0) | (across == 0)
    }

    #[inline(always)]
    const fn is_done(&self) -> bool {
        let [along, across] = self.registers.je;
        along | across == 0
    }

    /// The clock edge.
    #[inline(always)]
    fn edge(&mut self) {
        if self.is_done() {
            return;
        }
        let feeds_along = self.feeds_along();
        let q = &mut self.registers;
        let change = if feeds_along { -2 * self.p as i64 } else { 2 * q.v as i64 + 1 };
        q.f = wrap(q.f + change, self.bits + 2);
        q.v = (q.v + u64::from(!feeds_along)) & mask(self.bits);
        q.je = [
            q.je[0].wrapping_sub(u64::from(feeds_along)) & mask(self.bits),
            q.je[1].wrapping_sub(u64::from(!feeds_along)) & mask(self.bits),
        ];
    }
}

impl Circuit for Ppc {
    const CLOCKS_PER_CYCLE: u64 = 1;
    const NAME: &'static str = "parabola_ppc";

    #[inline]
    fn pulses(&self) -> Pulse {
        if self.is_done() {
            return Pulse::NONE;
        }
        let axis = match (self.axis, self.feeds_along()) {
            (Axis::X, true) | (Axis::Y, false) => Axis::X,
            (Axis::Y, true) | (Axis::X, false) => Axis::Y,
        };
        Pulse::on(axis, signed(1, axis.of(self.negative)) as i8)
    }

    #[inline]
    fn done(&self) -> bool {
        self.is_done()
    }

    #[inline]
    fn clock(&mut self) -> Pulse {
        let pulses = self.pulses();
        self.edge();
        pulses
    }

    fn probe(&self, probe: &mut impl Probe) {
        let q = &self.registers;
        probe.signal("f", Kind::Signed(self.bits + 2), q.f as u64);
        probe.signal("v", Kind::Unsigned(self.bits), q.v);
        probe.signal("p", Kind::Unsigned(self.bits), self.p);
        probe.signal("je_along", Kind::Unsigned(self.bits), q.je[0]);
        probe.signal("je_across", Kind::Unsigned(self.bits), q.je[1]);
        probe.signal("axis_is_y", Kind::Bit, u64::from(self.axis == Axis::Y));
        for axis in 0..2 {
            probe.axis_signal("negative_", axis, Kind::Bit, u64::from(self.negative[axis]));
        }
    }
}
