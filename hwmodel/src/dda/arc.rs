//! The textbook's circuit of an arc by digital integration.

use crate::trace::{Kind, Probe};
use crate::word::mask;
use crate::{Circuit, Sweep};
use onepulse_core::dda::{self, Preset, Radix, Register};
use onepulse_core::{Axis, Direction, Error, Pulse};

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
            let mut pulse = Pulse::NONE;
            let feeds = q.sweep.feeds();
            for feed in [feeds.towards, feeds.away] {
                let axis = feed.axis.index();
                let carry = sum[axis] >> self.bits == 1;
                if carry && !stands[axis] {
                    pulse.0[axis] = feed.sign;
                }
            }
            pulse
        };
        Wires { sum, stands, stepping_out, pulse }
    }

    fn next(&self, wires: &Wires) -> Registers {
        let q = &self.registers;
        let iterates = !q.sweep.done() && !wires.stepping_out;
        let remainder = |axis: usize| {
            if iterates && !wires.stands[axis] {
                wires.sum[axis] & mask(self.bits)
            } else {
                q.jr[axis]
            }
        };
        // The correction: a pulse of x moves |x|, which JVy holds, and the other way round.
        let mut jv = q.jv;
        let feeds = q.sweep.feeds();
        for (feed, outwards) in [(feeds.towards, -1), (feeds.away, 1)] {
            let steps = i64::from(wires.pulse.0[feed.axis.index()] * feed.sign) * outwards;
            let follower = &mut jv[feed.axis.other().index()];
            *follower = follower.wrapping_add_signed(steps << self.shift) & mask(self.bits);
        }
        Registers {
            jv,
            jr: [remainder(0), remainder(1)],
            sweep: q.sweep.next(wires.pulse, is_zero(jv)),
        }
    }
}

/// The zero detectors of the coordinates x and y, from the integrands that follow them.
fn is_zero(jv: [u64; 2]) -> [bool; 2] {
    [Axis::X, Axis::Y].map(|axis| jv[axis.other().index()] == 0)
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
