//! The circuit of an arc by point-by-point comparison.

use super::{Beat, end::EndCounter};
use crate::trace::{Kind, Probe};
use crate::word::{mask, wrap};
use crate::{Circuit, Sweep};
use onepulse_core::dda::{Radix, Register};
use onepulse_core::{self as software, Axis, Direction, EndRule, Error, Pulse};

/// One adder, the deviation register F, and the magnitudes of the moving point.
///
/// ```text
///  judge     due ← towards the axis if F ≥ 0, else away from it; a stopped axis is never due
///  feed      pulse on the due axis; a coordinate that goes towards zero takes it
///  update    F ← F − 2c − 1 (towards)  or  F + 2c + 1, c ← c + 1 (away); the counters count it
///  compare   which counters have come to their end; the quadrant is left when c has reached 0
/// ```
///
/// A pulse changes F by twice the smaller of the two coordinates that it lies between, and 1: that
/// is why one goes first and the other afterwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arc {
    registers: Registers,
    bits: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Registers {
    beat: Beat,
    /// Which axis is due.
    due: Axis,
    /// The deviation function, n + 2 bits, signed. It may wrap once it decides nothing any more:
    /// when an end point off the circle is stepped out to.
    f: i64,
    /// |x| and |y|, n bits.
    c: [u64; 2],
    sweep: Sweep,
    end: EndCounter,
}

impl Arc {
    /// The circuit, loaded with the arc from `start` to `end`, in registers of `bits` bits.
    ///
    /// # Errors
    /// As [`onepulse_core::ppc::Arc::new`]; a width of 0 or over 32 bits, or less than
    /// [`Arc::bits`].
    pub fn new(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        bits: u32,
        rule: EndRule,
    ) -> Result<Self, Error> {
        Register::new(Radix::Binary, bits)?;
        let needed = Self::bits(start, end, direction)?;
        if bits < needed {
            return Err(Error::RegisterTooNarrow { digits: bits, needed });
        }
        let software = software::ppc::Arc::new(start, end, direction, rule)?;
        let c = start.map(|c| u64::from(c.unsigned_abs()));
        let end_counter = EndCounter::new(rule, software.pulses_to_go());
        Ok(Self::loaded(c, Sweep::new(start, end, direction, bits)?, end_counter, bits))
    }

    /// The circuit after a load of these contents.
    const fn loaded(c: [u64; 2], sweep: Sweep, end: EndCounter, bits: u32) -> Self {
        let due = sweep.towards();
        Self { registers: Registers { beat: Beat::Judge, due, f: 0, c, sweep, end }, bits }
    }

    /// The circuit after a load under the rule of two counters.
    pub(crate) const fn loaded_per_axis(c: [u64; 2], sweep: Sweep, bits: u32) -> Self {
        Self::loaded(c, sweep, EndCounter::new(EndRule::PerAxis, [0; 2]), bits)
    }

    /// The circuit after a reset.
    pub(crate) fn reset(bits: u32) -> Self {
        let end_counter = EndCounter::new(EndRule::Total, [0; 2]);
        Self::loaded([0; 2], Sweep::reset(bits), end_counter, bits)
    }

    /// The narrowest registers that serve the arc, in bits.
    ///
    /// # Errors
    /// As [`onepulse_core::Sweep::new`].
    pub fn bits(start: [i32; 2], end: [i32; 2], direction: Direction) -> Result<u32, Error> {
        let sweep = software::Sweep::new(start, end, direction)?;
        Ok(sweep.largest_coordinate().ilog2() + 1)
    }

    /// The judge beat's decision.
    fn judge(&self) -> Axis {
        let q = &self.registers;
        let (towards, away) = match q.sweep.towards() {
            Axis::X => (Axis::X, Axis::Y),
            Axis::Y => (Axis::Y, Axis::X),
        };
        let stands = q.sweep.stands();
        match (stands[towards.index()], stands[away.index()]) {
            (false, false) if q.f >= 0 => towards,
            (false, true) => towards,
            (_, false) => away,
            (true, true) if q.sweep.at_end()[0] => Axis::Y,
            (true, true) => Axis::X,
        }
    }

    fn next(&self) -> Registers {
        let q = &self.registers;
        let mut next = *q;
        if self.done() {
            return next;
        }
        next.beat = q.beat.next();
        let due = q.due.index();
        let growth = q.sweep.growth(due);
        match (q.beat, growth) {
            (Beat::Feed, -1) | (Beat::Update, 1) => {
                next.c[due] = q.c[due].wrapping_add_signed(growth) & mask(self.bits);
            }
            _ => {}
        }
        match q.beat {
            Beat::Judge => next.due = self.judge(),
            Beat::Feed => {}
            Beat::Update => {
                let change = growth * (2 * q.c[due] as i64 + 1);
                next.f = wrap(q.f + change, self.bits + 2);
                next.sweep.count(due, q.sweep.sign(due));
                next.end = q.end.next(q.due);
            }
            Beat::Compare => next.sweep = q.sweep.look(q.c.map(|c| c == 0)),
        }
        next
    }
}

impl Circuit for Arc {
    const CLOCKS_PER_CYCLE: u64 = 4;
    const NAME: &'static str = "ppc_arc";

    fn pulses(&self) -> Pulse {
        match self.registers {
            Registers { beat: Beat::Feed, due, sweep, .. } => {
                Pulse::on(due, sweep.sign(due.index()))
            }
            _ => Pulse::NONE,
        }
    }

    fn done(&self) -> bool {
        let q = &self.registers;
        q.beat == Beat::Judge && q.end.done(q.sweep.done())
    }

    fn is_mid_cycle(&self) -> bool {
        self.registers.beat != Beat::Judge
    }

    #[inline]
    fn clock(&mut self) -> Pulse {
        let pulses = self.pulses();
        self.registers = self.next();
        pulses
    }

    fn probe(&self, probe: &mut impl Probe) {
        let q = &self.registers;
        probe.signal("beat", Kind::Word(Beat::WORDS), q.beat as u64);
        probe.signal("fx", Kind::Bit, u64::from(q.due == Axis::X));
        probe.signal("f", Kind::Signed(self.bits + 2), q.f as u64);
        for axis in 0..2 {
            probe.axis_signal("c", axis, Kind::Unsigned(self.bits), q.c[axis]);
        }
        q.sweep.probe(probe);
        q.end.probe(self.bits + 4, probe);
    }
}
