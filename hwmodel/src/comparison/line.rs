//! The circuit of a straight line by comparison integration.

use crate::Circuit;
use crate::probe::{Kind, Probe};
use crate::word::{mask, signed, wrap};
use onepulse_core::dda::{Radix, Register};
use onepulse_core::{Error, Pulse};

/// The difference register D, the end point's magnitudes XE and YE, and an end counter an axis.
///
/// ```text
///  judge    FX ← D ≤ 0, FY ← D ≥ 0    whose pulse is due first; both when they are level
///  update   D ← D + 2·YE if FX  − 2·XE if FY, JEx and JEy count the pulses
/// ```
///
/// All in one clock: two adders behind one another, whose carries run together.
///
/// From 1 − 2·|x_e| ≤ D ≤ 2·|y_e| − 1, or D = |y_e| − |x_e| all the way on an axis, follows |D| < 2ⁿ⁺¹:
/// D has n + 2 bits, and XE, YE and their counters n. The counters stop no axis by itself: neither D's sign
/// nor its zero asks for a pulse of one that is used up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    registers: Registers,
    /// Magnitudes of the end point, n bits; loaded once.
    end: [u64; 2],
    negative: [bool; 2],
    bits: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Registers {
    /// n + 2 bits, signed.
    d: i64,
    /// End counters, n bits.
    je: [u64; 2],
}

impl Line {
    /// The circuit, loaded with the line to `end`, in registers of `bits` bits.
    ///
    /// # Errors
    /// A width of 0 or over 32 bits; an end coordinate that does not fit.
    pub fn new(end: [i32; 2], bits: u32) -> Result<Self, Error> {
        Register::new(Radix::Binary, bits)?;
        let magnitude = end.map(i32::unsigned_abs);
        let needed = Register::holding(Radix::Binary, magnitude[0].max(magnitude[1])).digits();
        if bits < needed {
            return Err(Error::RegisterTooNarrow { digits: bits, needed });
        }
        Ok(Self::loaded(magnitude.map(u64::from), end.map(|c| c < 0), bits))
    }

    /// The circuit after a load of these contents.
    const fn loaded(end: [u64; 2], negative: [bool; 2], bits: u32) -> Self {
        let d = end[1] as i64 - end[0] as i64;
        Self { registers: Registers { d, je: end }, end, negative, bits }
    }

    /// Whether each axis is fed in this step.
    #[inline(always)]
    const fn feeds(&self) -> [bool; 2] {
        let (d, runs) = (self.registers.d, !self.is_done());
        [(d <= 0) & runs, (d >= 0) & runs]
    }

    #[inline(always)]
    const fn is_done(&self) -> bool {
        let [x, y] = self.registers.je;
        x | y == 0
    }

    /// The clock edge.
    #[inline(always)]
    fn edge(&mut self, [feeds_x, feeds_y]: [bool; 2]) {
        let [xe, ye] = self.end.map(|end| end as i64);
        let q = &mut self.registers;
        // As choices, the sums would wait for guesses that are often wrong.
        let change = 2 * ye * i64::from(feeds_x) - 2 * xe * i64::from(feeds_y);
        q.d = wrap(q.d + change, self.bits + 2);
        q.je = [
            q.je[0].wrapping_sub(u64::from(feeds_x)) & mask(self.bits),
            q.je[1].wrapping_sub(u64::from(feeds_y)) & mask(self.bits),
        ];
    }
}

impl Circuit for Line {
    const CLOCKS_PER_CYCLE: u64 = 1;
    const NAME: &'static str = "comparison_line";

    #[inline]
    fn pulses(&self) -> Pulse {
        let [x, y] = self.feeds().map(i64::from);
        Pulse([signed(x, self.negative[0]) as i8, signed(y, self.negative[1]) as i8])
    }

    #[inline]
    fn done(&self) -> bool {
        self.is_done()
    }

    #[inline]
    fn clock(&mut self) -> Pulse {
        let pulses = self.pulses();
        self.edge(self.feeds());
        pulses
    }

    fn probe(&self, probe: &mut impl Probe) {
        let q = &self.registers;
        probe.signal("d", Kind::Signed(self.bits + 2), q.d as u64);
        for axis in 0..2 {
            probe.axis_signal("end_", axis, Kind::Unsigned(self.bits), self.end[axis]);
        }
        for axis in 0..2 {
            probe.axis_signal("je", axis, Kind::Unsigned(self.bits), q.je[axis]);
        }
        for axis in 0..2 {
            probe.axis_signal("negative_", axis, Kind::Bit, u64::from(self.negative[axis]));
        }
    }
}
