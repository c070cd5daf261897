//! The circuit of the centred staggered arc.

use crate::trace::{Kind, Probe};
use crate::word::{mask, wrap};
use crate::{Circuit, Sweep};
use onepulse_core::dda::{self, Radix, Register};
use onepulse_core::{Axis, Direction, Error, Pulse};

/// Two crossed integrators with signed integrands and remainders that run up and down; the y
/// integrator adds the x that already has this cycle's pulse. Four clocks a cycle, which share one
/// adder.
///
/// ```text
///      ┌──────────────── y ◀───────────────┐
///      ▼                                   │
///  JRx − y ──carry +1, borrow −1──▶ x ──▶ JRy + x ──carry +1, borrow −1──▶ y
///
///  add_x    S ← JRx − y, n + 2 bits: the two on top tell carry and borrow
///  move_x   JRx takes the sum, and x the pulse
///  add_y    S ← JRy + x
///  move_y   JRy takes the sum, and y the pulse
/// ```
///
/// (Clockwise: JRx + y and JRy − x.)
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CentredArc {
    registers: Registers,
    /// What a pulse moves its coordinate by, 2^Q; loaded once.
    unit: u64,
    bits: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Registers {
    beat: Beat,
    /// The coordinates x·2^Q and y·2^Q that the integrands are, n bits, signed.
    j: [i64; 2],
    /// Remainders, n bits.
    jr: [u64; 2],
    /// The adder's sum, n + 2 bits: the two top bits are 00 (no pulse), 01 (carry) or 11 (borrow).
    sum: u64,
    sweep: Sweep,
}

/// The beats of a cycle, a clock each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Beat {
    AddX,
    MoveX,
    AddY,
    MoveY,
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
        let jr = [half.wrapping_add_signed(half_step) & mask(bits), half];
        Ok(Self::loaded(j, jr, 1 << shift, Sweep::new(start, end, direction, bits)?, bits))
    }

    /// The circuit after a load of these contents.
    pub(crate) const fn loaded(
        j: [i64; 2],
        jr: [u64; 2],
        unit: u64,
        sweep: Sweep,
        bits: u32,
    ) -> Self {
        Self { registers: Registers { beat: Beat::AddX, j, jr, sum: 0, sweep }, unit, bits }
    }

    /// The circuit after a reset.
    pub(crate) fn reset(bits: u32) -> Self {
        Self::loaded([0; 2], [0; 2], 0, Sweep::reset(bits), bits)
    }

    /// The axis that is sent a pulse in this clock, if one is.
    #[inline]
    const fn pulse(&self) -> Option<Axis> {
        let q = &self.registers;
        let axis = match q.beat {
            Beat::AddX | Beat::AddY => return None,
            Beat::MoveX => Axis::X,
            Beat::MoveY => Axis::Y,
        };
        let is_due = if q.sweep.is_stepping_out() {
            !q.sweep.at_end()[axis.index()]
        } else {
            !q.sweep.stands()[axis.index()] && q.sum >> self.bits & 1 == 1
        };
        if is_due { Some(axis) } else { None }
    }

    /// The adder: ±y to JRx, ±x to JRy.
    #[inline]
    const fn sum(&self, axis: Axis) -> u64 {
        let q = &self.registers;
        let (integrand, subtracts) = match (axis, q.sweep.direction()) {
            (Axis::X, Direction::Ccw) => (q.j[1], true),
            (Axis::X, Direction::Cw) => (q.j[1], false),
            (Axis::Y, Direction::Ccw) => (q.j[0], false),
            (Axis::Y, Direction::Cw) => (q.j[0], true),
        };
        let integrand = if subtracts { -integrand } else { integrand };
        q.jr[axis.index()].wrapping_add_signed(integrand) & mask(self.bits + 2)
    }

    #[inline]
    fn next(&self, pulse: Option<Axis>) -> Registers {
        let q = &self.registers;
        let mut next = *q;
        match q.beat {
            Beat::AddX => {
                if !q.sweep.done() {
                    next.beat = Beat::MoveX;
                }
                next.sum = self.sum(Axis::X);
                next.sweep = q.sweep.look([q.j[0] == 0, q.j[1] == 0]);
            }
            Beat::MoveX => {
                next.beat = Beat::AddY;
                self.take(&mut next, Axis::X);
            }
            Beat::AddY => {
                next.beat = Beat::MoveY;
                next.sum = self.sum(Axis::Y);
            }
            Beat::MoveY => {
                next.beat = Beat::AddX;
                self.take(&mut next, Axis::Y);
            }
        }
        if let Some(axis) = pulse {
            let axis = axis.index();
            let sign = self.sign(axis);
            let unit = i64::from(sign) * self.unit as i64;
            next.j[axis] = wrap(q.j[axis] + unit, self.bits);
            next.sweep.count(axis, sign);
        }
        next
    }

    /// The remainder of an axis that does not stand takes the sum.
    #[inline]
    fn take(&self, next: &mut Registers, axis: Axis) {
        let q = &self.registers;
        if !q.sweep.is_stepping_out() && !q.sweep.stands()[axis.index()] {
            next.jr[axis.index()] = q.sum & mask(self.bits);
        }
    }

    /// The direction of a pulse: a borrow's is negative, stepping out has the end counter's.
    #[inline]
    const fn sign(&self, axis: usize) -> i8 {
        let q = &self.registers;
        if q.sweep.is_stepping_out() {
            q.sweep.sign(axis)
        } else if q.sum >> (self.bits + 1) == 1 {
            -1
        } else {
            1
        }
    }

    /// The pulse with its direction.
    #[inline]
    fn signed(&self, pulse: Option<Axis>) -> Pulse {
        pulse.map_or(Pulse::NONE, |axis| Pulse::on(axis, self.sign(axis.index())))
    }
}

impl Circuit for CentredArc {
    const CLOCKS_PER_CYCLE: u64 = 4;
    const NAME: &'static str = "dda_centred_arc";

    fn pulses(&self) -> Pulse {
        self.signed(self.pulse())
    }

    fn done(&self) -> bool {
        self.registers.beat == Beat::AddX && self.registers.sweep.done()
    }

    fn is_mid_cycle(&self) -> bool {
        self.registers.beat != Beat::AddX
    }

    #[inline]
    fn clock(&mut self) -> Pulse {
        let pulse = self.pulse();
        let pulses = self.signed(pulse);
        self.registers = self.next(pulse);
        pulses
    }

    fn probe(&self, probe: &mut impl Probe) {
        const WORDS: &[&str] = &["ADD_X", "MOVE_X", "ADD_Y", "MOVE_Y"];
        let q = &self.registers;
        probe.signal("beat", Kind::Word(WORDS), q.beat as u64);
        probe.signal("unit", Kind::Unsigned(self.bits), self.unit);
        for axis in 0..2 {
            probe.axis_signal("", axis, Kind::Signed(self.bits), q.j[axis] as u64);
            probe.axis_signal("jr", axis, Kind::Ramp(self.bits), q.jr[axis]);
        }
        probe.signal("sum", Kind::Unsigned(self.bits + 2), q.sum);
        q.sweep.probe(probe);
    }
}
