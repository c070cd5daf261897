//! The circuit of an arc by point-by-point comparison.

use super::{Beat, end::EndCounter};
use crate::trace::{Kind, Probe};
use crate::word::{mask, wrap};
use crate::{Circuit, Sweep};
use onepulse_core::dda::{Radix, Register};
use onepulse_core::{self as software, Axis, Direction, EndRule, Error, Feed, Feeds, Pulse};

/// One adder, the deviation register F, and the magnitudes of the moving point.
///
/// ```text
///  judge     due ← towards the axis if F ≥ 0, else away from it; a stopped axis is never due
///  feed      pulse on the due axis
///  update    F ← F − 2c + 1, c ← c − 1 (towards)  or  F + 2c + 1, c + 1 (away)
///  compare   the end counters count the pulse; the quadrant is left when c has reached 0
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arc {
    registers: Registers,
    bits: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Registers {
    beat: Beat,
    /// Which axis is due, and in which direction.
    due: Feed,
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
        let registers = Registers {
            beat: Beat::Judge,
            due: software.sweep().feeds().towards,
            f: 0,
            c: start.map(|c| u64::from(c.unsigned_abs())),
            sweep: Sweep::new(start, end, direction, bits)?,
            end: EndCounter::new(rule, software.pulses_to_go()),
        };
        Ok(Self { registers, bits })
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
    fn judge(&self) -> Feed {
        let q = &self.registers;
        let Feeds { towards, away } = q.sweep.feeds();
        let stands = q.sweep.stands();
        match (stands[towards.axis.index()], stands[away.axis.index()]) {
            (false, false) if q.f >= 0 => towards,
            (false, true) => towards,
            (_, false) => away,
            (true, true) => {
                let Pulse([x, y]) = q.sweep.step_out();
                if x != 0 {
                    Feed { axis: Axis::X, sign: x }
                } else {
                    Feed { axis: Axis::Y, sign: y }
                }
            }
        }
    }

    /// Whether the due pulse takes its coordinate away from zero.
    fn is_outwards(&self) -> bool {
        let Registers { sweep, due, .. } = &self.registers;
        let Feeds { towards, away } = sweep.feeds();
        if due.axis == away.axis { due.sign == away.sign } else { due.sign != towards.sign }
    }

    fn next(&self) -> Registers {
        let q = &self.registers;
        let mut next = *q;
        if self.done() {
            return next;
        }
        next.beat = q.beat.next();
        let due = q.due.axis.index();
        match q.beat {
            Beat::Judge => next.due = self.judge(),
            Beat::Feed => {}
            Beat::Update => {
                let sign = if self.is_outwards() { 1 } else { -1 };
                let change = 2 * sign * q.c[due] as i64 + 1;
                next.f = wrap(q.f + change, self.bits + 2);
                next.c[due] = q.c[due].wrapping_add_signed(sign) & mask(self.bits);
            }
            Beat::Compare => {
                let pulse = Pulse::on(q.due.axis, q.due.sign);
                next.sweep = q.sweep.next(pulse, q.c.map(|c| c == 0));
                next.end = q.end.next(q.due.axis);
            }
        }
        next
    }
}

impl Circuit for Arc {
    const CLOCKS_PER_CYCLE: u64 = 4;
    const NAME: &'static str = "ppc_arc";

    fn pulses(&self) -> Pulse {
        match self.registers {
            Registers { beat: Beat::Feed, due, .. } => Pulse::on(due.axis, due.sign),
            _ => Pulse::NONE,
        }
    }

    fn done(&self) -> bool {
        let q = &self.registers;
        q.beat == Beat::Judge && q.end.done(q.sweep.done())
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
        probe.signal("fx", Kind::Bit, u64::from(q.due.axis == Axis::X));
        probe.signal("f", Kind::Signed(self.bits + 2), q.f as u64);
        for axis in 0..2 {
            probe.axis_signal("c", axis, Kind::Unsigned(self.bits), q.c[axis]);
        }
        q.sweep.probe(probe);
        probe.signal("e", Kind::Unsigned(self.bits + 4), q.end.e);
    }
}
