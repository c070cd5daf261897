//! The circuit of a straight line by point-by-point comparison.

use super::{Beat, end::EndCounter};
use crate::Circuit;
use crate::probe::{Kind, Probe};
#[cfg(feature = "proofs")]
use crate::word::same;
use crate::word::{signed, wrap};
use onepulse_core::dda::{Radix, Register};
use onepulse_core::{Axis, EndRule, Error, Pulse};

/// One adder, the deviation register F, and the end point's magnitudes XE and YE.
///
/// ```text
///  judge     FX ← F ≥ 0 and x not done, or y done    which axis is due
///  feed      pulse on x if FX, else on y
///  update    F ← F − YE if FX, else F + XE
///  compare   JEx or JEy, and E, count the pulse
/// ```
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
    beat: Beat,
    /// Which axis is due.
    due: Axis,
    /// The deviation function, n + 1 bits, signed.
    f: i64,
    /// The axes' own end counters, n bits.
    je: [u64; 2],
    end: EndCounter,
}

impl Line {
    /// The circuit, loaded with the line to `end`, in registers of `bits` bits.
    ///
    /// # Errors
    /// A width of 0 or over 32 bits; an end coordinate that does not fit.
    pub fn new(end: [i32; 2], bits: u32, rule: EndRule) -> Result<Self, Error> {
        Register::new(Radix::Binary, bits)?;
        let magnitude = end.map(i32::unsigned_abs);
        let needed = Register::holding(Radix::Binary, magnitude[0].max(magnitude[1])).digits();
        if bits < needed {
            return Err(Error::RegisterTooNarrow { digits: bits, needed });
        }
        let end_counter = EndCounter::new(rule, magnitude.map(u64::from));
        Ok(Self::loaded(magnitude.map(u64::from), end.map(|c| c < 0), end_counter, bits))
    }

    /// The circuit after a load of these contents.
    const fn loaded(end: [u64; 2], negative: [bool; 2], counter: EndCounter, bits: u32) -> Self {
        let registers = Registers { beat: Beat::Judge, due: Axis::X, f: 0, je: end, end: counter };
        Self { registers, end, negative, bits }
    }

    /// The circuit after a load under the rule of two counters.
    pub(crate) const fn loaded_per_axis(end: [u64; 2], negative: [bool; 2], bits: u32) -> Self {
        Self::loaded(end, negative, EndCounter::new(EndRule::PerAxis, [0; 2]), bits)
    }

    /// The circuit in this state at the start of a step, reachable or not; `e` is what the counter of
    /// the end rule holds, which counts `larger` under the third.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(
        due: Axis,
        f: i64,
        je: [u64; 2],
        (rule, larger, e): (EndRule, Axis, u64),
        end: [u64; 2],
        negative: [bool; 2],
        bits: u32,
    ) -> Self {
        let end_counter = EndCounter::in_state(rule, larger, e);
        let registers = Registers { beat: Beat::Judge, due, f, je, end: end_counter };
        Self { registers, end, negative, bits }
    }

    /// Whether every register agrees with that of another circuit, but for the axis that was due last:
    /// each step begins by writing it.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn agrees_with(&self, other: &Self) -> bool {
        let (q, r) = (&self.registers, &other.registers);
        q.beat == r.beat
            && q.f == r.f
            && same(q.je, r.je)
            && q.end == r.end
            && same(self.end, other.end)
            && same(self.negative, other.negative)
            && self.bits == other.bits
    }

    /// The circuit after a reset.
    pub(crate) const fn reset(bits: u32) -> Self {
        Self::loaded([0; 2], [false; 2], EndCounter::new(EndRule::Total, [0; 2]), bits)
    }

    /// The clock edge. No beat writes what another of its registers is made of, so they can be
    /// written one by one.
    #[inline(always)]
    fn edge(&mut self) {
        if self.done() {
            return;
        }
        let q = &mut self.registers;
        match q.beat {
            Beat::Judge => {
                let feeds_x = (q.f >= 0) & (q.je[0] != 0) | (q.je[1] == 0);
                q.due = if feeds_x { Axis::X } else { Axis::Y };
            }
            Beat::Feed => {}
            Beat::Update => {
                // As a choice of two, F would wait for a guess that is often wrong.
                let (xe, ye) = (self.end[0] as i64, self.end[1] as i64);
                let change = xe - (xe + ye) * i64::from(q.due == Axis::X);
                q.f = wrap(q.f + change, self.bits + 1);
            }
            Beat::Compare => {
                q.je[q.due.index()] -= 1;
                q.end.count(q.due);
            }
        }
        q.beat = q.beat.next();
    }
}

impl Circuit for Line {
    const CLOCKS_PER_CYCLE: u64 = 4;
    const NAME: &'static str = "ppc_line";

    #[inline]
    fn pulses(&self) -> Pulse {
        let q = &self.registers;
        match q.beat {
            Beat::Feed => Pulse::on(q.due, signed(1, self.negative[q.due.index()]) as i8),
            Beat::Judge | Beat::Update | Beat::Compare => Pulse::NONE,
        }
    }

    #[inline]
    fn done(&self) -> bool {
        let q = &self.registers;
        q.beat == Beat::Judge && q.end.done(q.je == [0, 0])
    }

    #[inline]
    fn is_mid_cycle(&self) -> bool {
        self.registers.beat != Beat::Judge
    }

    #[inline]
    fn clock(&mut self) -> Pulse {
        let pulses = self.pulses();
        self.edge();
        pulses
    }

    fn probe(&self, probe: &mut impl Probe) {
        let q = &self.registers;
        probe.signal("beat", Kind::Word(Beat::WORDS), q.beat as u64);
        probe.signal("fx", Kind::Bit, u64::from(q.due == Axis::X));
        probe.signal("f", Kind::Signed(self.bits + 1), q.f as u64);
        for axis in 0..2 {
            probe.axis_signal("end_", axis, Kind::Unsigned(self.bits), self.end[axis]);
        }
        for axis in 0..2 {
            probe.axis_signal("je", axis, Kind::Unsigned(self.bits), q.je[axis]);
        }
        for axis in 0..2 {
            probe.axis_signal("negative_", axis, Kind::Bit, u64::from(self.negative[axis]));
        }
        q.end.probe(self.bits + 1, probe);
    }
}
