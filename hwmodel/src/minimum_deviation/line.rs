//! The circuit of a straight line by minimum deviation.

use crate::probe::{Kind, Probe};
use crate::word::{mask, wrap};
use crate::{Circuit, word::signed};
use onepulse_core::dda::{Radix, Register};
use onepulse_core::{Error, Pulse};

/// One adder an axis, and one counter of steps for all.
///
/// ```text
///  judge    FEEDSi ← Di ≥ 0
///  update   Di ← Di − 2·RESTi if FEEDSi, else Di + 2·ENDi; STEPS ← STEPS − 1, until it is 0
/// ```
///
/// An axis is fed when it would be more than half a pulse behind: d + 2·|e_i| > |e_M|, with the d of
/// [`onepulse_core::minimum_deviation::Line`]. The register Di holds d + 2·|e_i| − |e_M| − 1, so that its
/// sign decides, and no comparison stands before the adder. It grows by 2·END without a pulse and loses
/// 2·REST with one. REST is kept, though it is a difference of other registers, so that the sum needs one
/// adder only.
///
/// END and REST lie between 0 and |e_M| < 2ⁿ, and STEPS counts from |e_M|: n bits. −2·REST ≤ Di < 2·END, which
/// is −|e_M| < d ≤ |e_M| and which each of the two changes keeps: n + 2 bits. (Of no line at all Di is −1.)
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line<const AXES: usize = 2> {
    registers: Registers<AXES>,
    /// Magnitudes of the end point, n bits; loaded once.
    end: [u64; AXES],
    /// By how much each is less than the largest, n bits; loaded once.
    rest: [u64; AXES],
    negative: [bool; AXES],
    bits: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Registers<const AXES: usize> {
    /// n + 2 bits, signed.
    d: [i64; AXES],
    /// Steps still to be made, n bits.
    steps: u64,
}

impl<const AXES: usize> Line<AXES> {
    /// The circuit, loaded with the line to `end`, in registers of `bits` bits.
    ///
    /// # Errors
    /// A width of 0 or over 32 bits; an end coordinate that does not fit.
    pub fn new(end: [i32; AXES], bits: u32) -> Result<Self, Error> {
        Register::new(Radix::Binary, bits)?;
        let magnitude = end.map(i32::unsigned_abs);
        let longest = magnitude.iter().fold(0, |most, c| (*c).max(most));
        let needed = Register::holding(Radix::Binary, longest).digits();
        if bits < needed {
            return Err(Error::RegisterTooNarrow { digits: bits, needed });
        }
        let rest = magnitude.map(|c| u64::from(longest - c));
        let end_and_sign = (magnitude.map(u64::from), end.map(|c| c < 0));
        Ok(Self::loaded(end_and_sign, rest, u64::from(longest), bits))
    }

    /// The circuit after a load of these contents.
    fn loaded(
        (end, negative): ([u64; AXES], [bool; AXES]),
        rest: [u64; AXES],
        steps: u64,
        bits: u32,
    ) -> Self {
        // 2·|e_i| − |e_M| − 1.
        let d =
            core::array::from_fn(|axis| wrap(end[axis] as i64 - rest[axis] as i64 - 1, bits + 2));
        Self { registers: Registers { d, steps }, end, rest, negative, bits }
    }

    /// Whether each axis is fed in this step.
    #[inline(always)]
    fn feeds(&self) -> [bool; AXES] {
        let is_done = self.registers.steps == 0;
        self.registers.d.map(|d| (d >= 0) & !is_done)
    }

    /// The clock edge.
    #[inline(always)]
    fn edge(&mut self, feeds: [bool; AXES]) {
        if self.registers.steps == 0 {
            return;
        }
        let q = &mut self.registers;
        for axis in 0..AXES {
            // A choice of two would wait for a guess that is often wrong.
            let (end, rest) = (self.end[axis] as i64, self.rest[axis] as i64);
            let change = end - (end + rest) * i64::from(feeds[axis]);
            q.d[axis] = wrap(q.d[axis] + 2 * change, self.bits + 2);
        }
        q.steps = (q.steps - 1) & mask(self.bits);
    }
}

impl<const AXES: usize> Circuit<AXES> for Line<AXES> {
    const CLOCKS_PER_CYCLE: u64 = 1;
    const NAME: &'static str = "minimum_deviation_line";

    #[inline]
    fn pulses(&self) -> Pulse<AXES> {
        let feeds = self.feeds();
        Pulse(core::array::from_fn(|axis| {
            signed(i64::from(feeds[axis]), self.negative[axis]) as i8
        }))
    }

    #[inline]
    fn done(&self) -> bool {
        self.registers.steps == 0
    }

    #[inline]
    fn clock(&mut self) -> Pulse<AXES> {
        let pulses = self.pulses();
        self.edge(self.feeds());
        pulses
    }

    fn probe(&self, probe: &mut impl Probe) {
        let q = &self.registers;
        for axis in 0..AXES {
            probe.axis_signal("d", axis, Kind::Signed(self.bits + 2), q.d[axis] as u64);
        }
        for axis in 0..AXES {
            probe.axis_signal("end_", axis, Kind::Unsigned(self.bits), self.end[axis]);
            probe.axis_signal("rest_", axis, Kind::Unsigned(self.bits), self.rest[axis]);
        }
        probe.signal("steps", Kind::Unsigned(self.bits), q.steps);
        for axis in 0..AXES {
            probe.axis_signal("negative_", axis, Kind::Bit, u64::from(self.negative[axis]));
        }
    }
}
