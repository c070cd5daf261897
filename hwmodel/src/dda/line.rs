//! The circuit of a straight line by digital integration.

use crate::probe::{Kind, Probe};
#[cfg(feature = "proofs")]
use crate::word::same;
use crate::{Circuit, word::mask};
use onepulse_core::dda::{self, Preset, Radix, Register};
use onepulse_core::{Error, Pulse};

/// One integrator an axis and one counter of accumulations for all.
///
/// ```text
///            ┌─────┐  n   ┌───────┐ carry
///  |end|·2^Q │ JVx ├──/──▶│ adder ├────────▶ Δx
///            └─────┘   ┌─▶└───┬───┘
///                      │      ▼ n
///                      │   ┌─────┐              ┌────┐ = 0
///                      └───┤ JRx │   2^(n−Q) ──▶│ JE ├──────▶ done
///                          └─────┘    counts    └────┘
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line<const AXES: usize = 2> {
    registers: Registers<AXES>,
    /// The sign flip-flops: set for an axis that runs in its negative direction.
    negative: [bool; AXES],
    bits: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Registers<const AXES: usize> {
    /// Integrands, n bits.
    jv: [u64; AXES],
    /// Remainders, n bits.
    jr: [u64; AXES],
    /// Accumulations still to be made, n + 1 bits.
    je: u64,
}

struct Wires<const AXES: usize> {
    sum: [u64; AXES],
    carry: [bool; AXES],
    done: bool,
}

impl<const AXES: usize> Line<AXES> {
    /// The circuit, loaded with the line to `end`, in registers of `bits` bits.
    ///
    /// # Errors
    /// As [`onepulse_core::dda::Line::new`] with a binary register.
    pub fn new(
        end: [i32; AXES],
        bits: u32,
        preset: Preset,
        normalize: bool,
    ) -> Result<Self, Error> {
        let register = Register::new(Radix::Binary, bits)?;
        let shift = dda::Line::new(end, register, preset, normalize)?.shift();
        let jv = end.map(|c| (u64::from(c.unsigned_abs()) << shift) & mask(bits));
        let preset = match preset {
            Preset::Zero => 0,
            Preset::Half => 1 << (bits - 1),
            Preset::Full => mask(bits),
        };
        Ok(Self::loaded(jv, preset, 1 << (bits - shift), end.map(|c| c < 0), bits))
    }

    /// The circuit after a load of these contents.
    pub(crate) const fn loaded(
        jv: [u64; AXES],
        preset: u64,
        je: u64,
        negative: [bool; AXES],
        bits: u32,
    ) -> Self {
        Self { registers: Registers { jv, jr: [preset; AXES], je }, negative, bits }
    }

    /// The circuit in this state, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(
        jv: [u64; AXES],
        jr: [u64; AXES],
        je: u64,
        negative: [bool; AXES],
        bits: u32,
    ) -> Self {
        Self { registers: Registers { jv, jr, je }, negative, bits }
    }

    /// Whether every register agrees with that of another circuit.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn agrees_with(&self, other: &Self) -> bool {
        let (q, r) = (&self.registers, &other.registers);
        same(q.jv, r.jv)
            && same(q.jr, r.jr)
            && q.je == r.je
            && same(self.negative, other.negative)
            && self.bits == other.bits
    }

    /// The circuit after a reset.
    pub(crate) const fn reset(bits: u32) -> Self {
        Self::loaded([0; AXES], 0, 0, [false; AXES], bits)
    }

    #[inline(always)]
    fn wires(&self) -> Wires<AXES> {
        let q = &self.registers;
        let done = q.je == 0;
        let sum = core::array::from_fn(|axis| q.jr[axis] + q.jv[axis]);
        Wires { sum, carry: sum.map(|sum| !done && sum >> self.bits == 1), done }
    }

    /// The pulses with the directions of the sign flip-flops.
    #[inline(always)]
    fn signed(&self, wires: &Wires<AXES>) -> Pulse<AXES> {
        Pulse(core::array::from_fn(|axis| match (wires.carry[axis], self.negative[axis]) {
            (false, _) => 0,
            (true, false) => 1,
            (true, true) => -1,
        }))
    }

    #[inline(always)]
    fn next(&self, wires: &Wires<AXES>) -> Registers<AXES> {
        if wires.done {
            return self.registers;
        }
        Registers {
            jv: self.registers.jv,
            jr: wires.sum.map(|sum| sum & mask(self.bits)),
            je: self.registers.je - 1,
        }
    }
}

impl<const AXES: usize> Circuit<AXES> for Line<AXES> {
    const CLOCKS_PER_CYCLE: u64 = 1;
    const NAME: &'static str = "dda_line";

    #[inline]
    fn pulses(&self) -> Pulse<AXES> {
        self.signed(&self.wires())
    }

    #[inline]
    fn done(&self) -> bool {
        self.wires().done
    }

    #[inline]
    fn clock(&mut self) -> Pulse<AXES> {
        let wires = self.wires();
        self.registers = self.next(&wires);
        self.signed(&wires)
    }

    fn probe(&self, probe: &mut impl Probe) {
        let q = &self.registers;
        let wires = self.wires();
        for axis in 0..AXES {
            probe.axis_signal("carry_", axis, Kind::Bit, u64::from(wires.carry[axis]));
        }
        for axis in 0..AXES {
            probe.axis_signal("jv", axis, Kind::Unsigned(self.bits), q.jv[axis]);
            probe.axis_signal("jr", axis, Kind::Ramp(self.bits), q.jr[axis]);
        }
        probe.signal("je", Kind::Unsigned(self.bits + 1), q.je);
        for axis in 0..AXES {
            probe.axis_signal("negative_", axis, Kind::Bit, u64::from(self.negative[axis]));
        }
    }
}
