//! The circuit of the centred staggered arc.

use crate::probe::{Kind, Probe};
#[cfg(feature = "proofs")]
use crate::word::same;
use crate::word::{mask, signed, wrap};
use crate::{Circuit, Sweep};
use onepulse_core::dda::{self, Radix, Register};
use onepulse_core::{Direction, Error, Pulse};

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
pub enum Beat {
    /// The sum of x, and a look where the arc is.
    AddX,
    /// What x takes of it.
    MoveX,
    /// The sum of y.
    AddY,
    /// What y takes of it.
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

    /// The circuit in this state, reachable or not, at the start of a beat.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(
        beat: Beat,
        j: [i64; 2],
        jr: [u64; 2],
        sum: u64,
        unit: u64,
        sweep: Sweep,
        bits: u32,
    ) -> Self {
        Self { registers: Registers { beat, j, jr, sum, sweep }, unit, bits }
    }

    /// Whether every register agrees with that of another circuit, but for a sum that nothing is
    /// made of any more, and before a look for what it will see.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn agrees_with(&self, other: &Self) -> bool {
        let (q, r) = (&self.registers, &other.registers);
        let (takes_sum, sweeps_agree) = match q.beat {
            Beat::AddX => (false, q.sweep.agrees_before_look(&r.sweep)),
            Beat::MoveX => (self.takes_sum(0), q.sweep.agrees_with(&r.sweep)),
            Beat::AddY => (false, q.sweep.agrees_with(&r.sweep)),
            Beat::MoveY => (self.takes_sum(1), q.sweep.agrees_with(&r.sweep)),
        };
        q.beat == r.beat
            && same(q.j, r.j)
            && same(q.jr, r.jr)
            && (!takes_sum || q.sum == r.sum)
            && sweeps_agree
            && self.unit == other.unit
            && self.bits == other.bits
    }

    /// The circuit after a reset.
    pub(crate) fn reset(bits: u32) -> Self {
        Self::loaded([0; 2], [0; 2], 0, Sweep::reset(bits), bits)
    }

    /// Whether this axis takes its sum, in the clock in which it moves.
    #[inline(always)]
    const fn takes_sum(&self, axis: usize) -> bool {
        let sweep = &self.registers.sweep;
        !sweep.is_stepping_out() && !sweep.stands()[axis]
    }

    /// Whether this axis is sent a pulse, if this is the clock in which it moves.
    #[inline(always)]
    const fn is_due(&self, axis: usize) -> bool {
        let q = &self.registers;
        if q.sweep.is_stepping_out() {
            !q.sweep.at_end()[axis]
        } else {
            (q.sum >> self.bits & 1 == 1) & !q.sweep.stands()[axis]
        }
    }

    /// The direction of a pulse: a borrow's is negative, stepping out has the end counter's.
    #[inline(always)]
    const fn is_negative(&self, axis: usize) -> bool {
        let q = &self.registers;
        if q.sweep.is_stepping_out() {
            q.sweep.is_negative(axis)
        } else {
            q.sum >> (self.bits + 1) == 1
        }
    }

    /// The pulse of an axis in the clock in which it moves.
    #[inline(always)]
    const fn moved(&self, axis: usize) -> i8 {
        signed(self.is_due(axis) as i64, self.is_negative(axis)) as i8
    }

    /// The adder: JRx − y and JRy + x, clockwise JRx + y and JRy − x.
    #[inline(always)]
    const fn sum(&self, axis: usize) -> u64 {
        let q = &self.registers;
        let subtracts = matches!(q.sweep.direction(), Direction::Ccw) == (axis == 0);
        let integrand = signed(q.j[1 - axis], subtracts);
        q.jr[axis].wrapping_add_signed(integrand) & mask(self.bits + 2)
    }

    /// The edge of a beat that moves: remainder, coordinate and end counter of an axis.
    #[inline(always)]
    fn take(&mut self, axis: usize) {
        let (is_due, is_negative) = (self.is_due(axis), self.is_negative(axis));
        let takes_sum = self.takes_sum(axis);
        let q = &mut self.registers;
        if takes_sum {
            q.jr[axis] = q.sum & mask(self.bits);
        }
        let unit = signed(self.unit as i64 * i64::from(is_due), is_negative);
        q.j[axis] = wrap(q.j[axis] + unit, self.bits);
        q.sweep.count(axis, is_due, is_negative);
    }

    /// The clock edge. No beat writes what another of its registers is made of, so they can be
    /// written one by one.
    #[inline(always)]
    fn edge(&mut self) {
        match self.registers.beat {
            Beat::AddX => {
                self.registers.sum = self.sum(0);
                let q = &mut self.registers;
                if !q.sweep.done() {
                    q.beat = Beat::MoveX;
                }
                q.sweep.look([q.j[0] == 0, q.j[1] == 0]);
            }
            Beat::MoveX => {
                self.registers.beat = Beat::AddY;
                self.take(0);
            }
            Beat::AddY => {
                self.registers.beat = Beat::MoveY;
                self.registers.sum = self.sum(1);
            }
            Beat::MoveY => {
                self.registers.beat = Beat::AddX;
                self.take(1);
            }
        }
    }
}

impl Circuit for CentredArc {
    const CLOCKS_PER_CYCLE: u64 = 4;
    const NAME: &'static str = "dda_centred_arc";

    #[inline]
    fn pulses(&self) -> Pulse {
        match self.registers.beat {
            Beat::AddX | Beat::AddY => Pulse::NONE,
            Beat::MoveX => Pulse([self.moved(0), 0]),
            Beat::MoveY => Pulse([0, self.moved(1)]),
        }
    }

    #[inline]
    fn done(&self) -> bool {
        self.registers.beat == Beat::AddX && self.registers.sweep.done()
    }

    #[inline]
    fn is_mid_cycle(&self) -> bool {
        self.registers.beat != Beat::AddX
    }

    // So that a loop of clocks keeps in the processor's registers what it can.
    #[inline(always)]
    fn clock(&mut self) -> Pulse {
        let pulses = self.pulses();
        self.edge();
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
