//! The circuit of the binary rate multiplier.

use crate::probe::{Kind, Probe};
#[cfg(feature = "proofs")]
use crate::word::same;
use crate::{Circuit, word::mask};
use onepulse_core::{self as software, Error, Pulse};

/// A divider chain shared by all axes, a value register an axis, and the control flip-flop TG.
///
/// Starting (SD) clears the divider and sets TG; TG opens gate I, which lets the source clocks
/// through; the divider's overflow resets TG.
///
/// ```text
///  source ─▶[I]─▶ divider, n stages ──overflow──▶ resets TG
///            ▲      │ │ │ │ stage pulses
///           TG      & & & &  value bits, most significant bit with the fastest stage
///                    \│ │/
///                      OR ──▶ Δx
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line<const AXES: usize = 2> {
    registers: Registers,
    /// The value registers, n bits; loaded once.
    value: [u64; AXES],
    negative: [bool; AXES],
    bits: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Registers {
    /// The divider chain's flip-flops, n bits.
    divider: u64,
    tg: bool,
}

struct Wires<const AXES: usize> {
    /// The stage that passes this clock, one-hot; stage 0 is the fastest.
    stages: u64,
    overflow: bool,
    train: [bool; AXES],
}

impl<const AXES: usize> Line<AXES> {
    /// The circuit, loaded with the line to `end`, with `bits` stages.
    ///
    /// # Errors
    /// As [`onepulse_core::brm::Line::new`].
    pub fn new(end: [i32; AXES], bits: u32) -> Result<Self, Error> {
        software::brm::Line::new(end, bits)?;
        let value = end.map(|c| u64::from(c.unsigned_abs()));
        Ok(Self::loaded(value, end.map(|c| c < 0), bits))
    }

    /// The circuit after a load of these contents, which starts it.
    pub(crate) const fn loaded(value: [u64; AXES], negative: [bool; AXES], bits: u32) -> Self {
        Self { registers: Registers { divider: 0, tg: true }, value, negative, bits }
    }

    /// The circuit in this state, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(
        divider: u64,
        tg: bool,
        value: [u64; AXES],
        negative: [bool; AXES],
        bits: u32,
    ) -> Self {
        Self { registers: Registers { divider, tg }, value, negative, bits }
    }

    /// Whether every register agrees with that of another circuit.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn agrees_with(&self, other: &Self) -> bool {
        let (q, r) = (self.registers, other.registers);
        q.divider == r.divider
            && q.tg == r.tg
            && same(self.value, other.value)
            && same(self.negative, other.negative)
            && self.bits == other.bits
    }

    /// The circuit after a reset.
    pub(crate) const fn reset(bits: u32) -> Self {
        let registers = Registers { divider: 0, tg: false };
        Self { registers, ..Self::loaded([0; AXES], [false; AXES], bits) }
    }

    #[inline(always)]
    fn wires(&self) -> Wires<AXES> {
        let Registers { divider, tg } = self.registers;
        // The flip-flop that is about to rise: the lowest one that is clear.
        let rising = (divider + 1) & !divider;
        let stages = if tg { rising & mask(self.bits) } else { 0 };
        // Behind the gates only that flip-flop's is left to be looked at: the bit of the value that
        // is as far from the highest as the flip-flop is from the lowest.
        let gate = 1 << (self.bits - 1) >> divider.trailing_ones();
        let train = self.value.map(|value| tg & (value & gate != 0));
        Wires { stages, overflow: tg && rising >> self.bits == 1, train }
    }

    /// The pulses with the directions of the sign flip-flops.
    #[inline(always)]
    fn signed(&self, wires: &Wires<AXES>) -> Pulse<AXES> {
        Pulse(core::array::from_fn(|axis| match (wires.train[axis], self.negative[axis]) {
            (false, _) => 0,
            (true, false) => 1,
            (true, true) => -1,
        }))
    }

    #[inline(always)]
    fn next(&self, wires: &Wires<AXES>) -> Registers {
        let Registers { divider, tg } = self.registers;
        Registers {
            divider: (divider + u64::from(tg)) & mask(self.bits),
            tg: tg && !wires.overflow,
        }
    }
}

impl<const AXES: usize> Circuit<AXES> for Line<AXES> {
    const CLOCKS_PER_CYCLE: u64 = 1;
    const NAME: &'static str = "brm_line";

    #[inline]
    fn pulses(&self) -> Pulse<AXES> {
        self.signed(&self.wires())
    }

    #[inline]
    fn done(&self) -> bool {
        !self.registers.tg
    }

    #[inline]
    fn clock(&mut self) -> Pulse<AXES> {
        let wires = self.wires();
        self.registers = self.next(&wires);
        self.signed(&wires)
    }

    fn probe(&self, probe: &mut impl Probe) {
        let wires = self.wires();
        probe.signal("tg", Kind::Bit, u64::from(self.registers.tg));
        probe.signal("divider", Kind::Unsigned(self.bits), self.registers.divider);
        probe.signal("stages", Kind::Unsigned(self.bits), wires.stages);
        probe.signal("overflow", Kind::Bit, u64::from(wires.overflow));
        for axis in 0..AXES {
            probe.axis_signal("value_", axis, Kind::Unsigned(self.bits), self.value[axis]);
            probe.axis_signal("train_", axis, Kind::Bit, u64::from(wires.train[axis]));
            probe.axis_signal("negative_", axis, Kind::Bit, u64::from(self.negative[axis]));
        }
    }
}
