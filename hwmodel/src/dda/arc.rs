//! The textbook's circuit of an arc by digital integration.

use crate::trace::{Kind, Probe};
use crate::word::mask;
use crate::{Circuit, Sweep};
use onepulse_core::dda::{self, Preset, Radix, Register};
use onepulse_core::{Direction, Error, Pulse};

/// Two crossed integrators: JVx follows |y|, JVy follows |x|, and each pulse corrects the
/// integrand that follows its axis.
///
/// ```text
///         ┌─────┐   ┌───────┐ carry                ┌─────┐   ┌───────┐ carry
///    ┌───▶│ JVx ├──▶│ + JRx ├───────▶ Δx ──┐  ┌───▶│ JVy ├──▶│ + JRy ├───────▶ Δy ──┐
///    │    └─────┘   └───────┘              │  │    └─────┘   └───────┘              │
///    │    ±2^Q                             └──┘    ±2^Q                             │
///    └──────────────────────────────────────────────────────────────────────────────┘
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arc {
    registers: Registers,
    bits: u32,
    shift: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Registers {
    /// Integrands, n bits: |y|·2^Q and |x|·2^Q.
    jv: [u64; 2],
    /// Remainders, n bits.
    jr: [u64; 2],
    sweep: Sweep,
}

struct Wires {
    /// What the remainder registers take if their axis is not stopped.
    sum: [u64; 2],
    stands: [bool; 2],
    stepping_out: bool,
    pulse: Pulse,
}

impl Arc {
    /// The circuit, loaded with the arc from `start` to `end`, in registers of `bits` bits.
    ///
    /// # Errors
    /// As [`onepulse_core::dda::Arc::new`] with a binary register.
    pub fn new(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        bits: u32,
        preset: Preset,
        normalize: bool,
    ) -> Result<Self, Error> {
        let register = Register::new(Radix::Binary, bits)?;
        let software = dda::Arc::new(start, end, direction, register, preset, normalize)?;
        let shift = software.shift();
        let load = |c: i32| (u64::from(c.unsigned_abs()) << shift) & mask(bits);
        let registers = Registers {
            jv: [load(start[1]), load(start[0])],
            jr: [match preset {
                Preset::Zero => 0,
                Preset::Half => 1 << (bits - 1),
                Preset::Full => mask(bits),
            }; 2],
            sweep: Sweep::new(start, end, direction, bits)?,
        };
        Ok(Self { registers, bits, shift })
    }

    fn wires(&self) -> Wires {
        let q = &self.registers;
        let stands = q.sweep.stands();
        let is_zero = is_zero(q.jv);
        let stepping_out = Sweep::is_stepping_out(stands, is_zero);
        let sum = [q.jr[0] + q.jv[0], q.jr[1] + q.jv[1]];
        let pulse = if q.sweep.done() {
            Pulse::NONE
        } else if stepping_out {
            q.sweep.step_out()
        } else {
            let [sx, sy] = q.sweep.signs();
            let carries = |sum: u64, stands: bool| sum >> self.bits == 1 && !stands;
            let x = if carries(sum[0], stands[0]) { sx } else { 0 };
            let y = if carries(sum[1], stands[1]) { sy } else { 0 };
            Pulse([x, y])
        };
        Wires { sum, stands, stepping_out, pulse }
    }

    fn next(&self, wires: &Wires) -> Registers {
        let q = &self.registers;
        let iterates = !q.sweep.done() && !wires.stepping_out;
        let remainder = |jr: u64, sum: u64, stands: bool| {
            if iterates && !stands { sum & mask(self.bits) } else { jr }
        };
        // The correction: a pulse of x moves |x|, which JVy holds, and the other way round.
        let [x_grows, y_grows] = q.sweep.growth(wires.pulse);
        let correct =
            |jv: u64, grows: i64| jv.wrapping_add_signed(grows << self.shift) & mask(self.bits);
        let jv = [correct(q.jv[0], y_grows), correct(q.jv[1], x_grows)];
        let [jrx, jry] = q.jr;
        Registers {
            jv,
            jr: [
                remainder(jrx, wires.sum[0], wires.stands[0]),
                remainder(jry, wires.sum[1], wires.stands[1]),
            ],
            sweep: q.sweep.next(wires.pulse, is_zero(jv)),
        }
    }
}

/// The zero detectors of the coordinates x and y, from the integrands that follow them.
const fn is_zero([jvx, jvy]: [u64; 2]) -> [bool; 2] {
    [jvy == 0, jvx == 0]
}

impl Circuit for Arc {
    const CLOCKS_PER_CYCLE: u64 = 1;
    const NAME: &'static str = "dda_arc";

    fn pulses(&self) -> Pulse {
        self.wires().pulse
    }

    fn done(&self) -> bool {
        self.registers.sweep.done()
    }

    #[inline]
    fn clock(&mut self) -> Pulse {
        let wires = self.wires();
        self.registers = self.next(&wires);
        wires.pulse
    }

    fn probe(&self, probe: &mut impl Probe) {
        let q = &self.registers;
        let wires = self.wires();
        for axis in 0..2 {
            let carry = wires.sum[axis] >> self.bits == 1 && !wires.stands[axis];
            probe.axis_signal("carry_", axis, Kind::Bit, u64::from(carry));
        }
        for axis in 0..2 {
            probe.axis_signal("jv", axis, Kind::Unsigned(self.bits), q.jv[axis]);
            probe.axis_signal("jr", axis, Kind::Ramp(self.bits), q.jr[axis]);
        }
        q.sweep.probe(probe);
    }
}
