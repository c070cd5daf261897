//! The circuit of the centred staggered arc.

use crate::trace::{Kind, Probe};
use crate::word::{mask, wrap};
use crate::{Circuit, Sweep};
use onepulse_core::dda::{self, Radix, Register};
use onepulse_core::{Direction, Error, Pulse};

/// Two crossed integrators with signed integrands and remainders that run up and down; the y
/// integrator adds the x that already has this clock's pulse.
///
/// ```text
///      ┌──────────────── y ◀───────────────┐
///      ▼                                   │
///  JRx − y ──carry +1, borrow −1──▶ x ──▶ JRy + x ──carry +1, borrow −1──▶ y
/// ```
///
/// (Clockwise: JRx + y and JRy − x.)
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CentredArc {
    registers: Registers,
    bits: u32,
    shift: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Registers {
    /// The coordinates x·2^Q and y·2^Q that the integrands are, n bits, signed.
    j: [i64; 2],
    /// Remainders, n bits.
    jr: [u64; 2],
    sweep: Sweep,
}

struct Wires {
    remainder: [u64; 2],
    pulse: Pulse,
}

impl CentredArc {
    /// The circuit, loaded with the arc from `start` to `end`, in registers of `bits` bits.
    ///
    /// # Errors
    /// As [`onepulse_core::dda::CentredArc::new`] with a binary register.
    pub fn new(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        bits: u32,
        normalize: bool,
    ) -> Result<Self, Error> {
        let register = Register::new(Radix::Binary, bits)?;
        let software = dda::CentredArc::new(start, end, direction, register, normalize)?;
        let shift = software.shift();
        let j = start.map(|c| wrap(i64::from(c) << shift, bits));
        let half_step = match direction {
            Direction::Ccw => j[1] / 2,
            Direction::Cw => -(j[1] / 2),
        };
        let half = 1_u64 << (bits - 1);
        let registers = Registers {
            j,
            jr: [half.wrapping_add_signed(half_step) & mask(bits), half],
            sweep: Sweep::new(start, end, direction, bits)?,
        };
        Ok(Self { registers, bits, shift })
    }

    fn wires(&self) -> Wires {
        let q = &self.registers;
        let stands = q.sweep.stands();
        let is_zero = q.j.map(|c| c == 0);
        if q.sweep.done() {
            return Wires { remainder: q.jr, pulse: Pulse::NONE };
        }
        if Sweep::is_stepping_out(stands, is_zero) {
            return Wires { remainder: q.jr, pulse: q.sweep.step_out() };
        }
        let turn = match q.sweep.direction() {
            Direction::Ccw => 1,
            Direction::Cw => -1,
        };
        let (jrx, px) = if stands[0] { (q.jr[0], 0) } else { self.add(q.jr[0], -turn * q.j[1]) };
        let x_updated = self.moved(q.j[0], px);
        let (jry, py) = if stands[1] { (q.jr[1], 0) } else { self.add(q.jr[1], turn * x_updated) };
        Wires { remainder: [jrx, jry], pulse: Pulse([px, py]) }
    }

    /// An n-bit adder: its sum, and +1 for a carry out of it, −1 for a borrow.
    fn add(&self, remainder: u64, integrand: i64) -> (u64, i8) {
        let sum = remainder as i64 + integrand;
        // Bit n is the carry, the sign above it the borrow.
        (sum as u64 & mask(self.bits), (sum >> self.bits) as i8)
    }

    /// A coordinate after a pulse: ±2^Q.
    fn moved(&self, coordinate: i64, pulse: i8) -> i64 {
        wrap(coordinate + (i64::from(pulse) << self.shift), self.bits)
    }

    fn next(&self, wires: &Wires) -> Registers {
        let q = &self.registers;
        let Pulse([px, py]) = wires.pulse;
        let j = [self.moved(q.j[0], px), self.moved(q.j[1], py)];
        Registers { j, jr: wires.remainder, sweep: q.sweep.next(wires.pulse, j.map(|c| c == 0)) }
    }
}

impl Circuit for CentredArc {
    const CLOCKS_PER_CYCLE: u64 = 1;
    const NAME: &'static str = "dda_centred_arc";

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
        for axis in 0..2 {
            probe.axis_signal("", axis, Kind::Signed(self.bits), q.j[axis] as u64);
            probe.axis_signal("jr", axis, Kind::Ramp(self.bits), q.jr[axis]);
        }
        q.sweep.probe(probe);
    }
}
