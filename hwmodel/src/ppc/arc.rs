//! The circuit of an arc by point-by-point comparison.

use super::{Beat, end::EndCounter};
use crate::probe::{Kind, Probe};
#[cfg(feature = "proofs")]
use crate::word::same;
use crate::word::{mask, signed, wrap};
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

    /// The circuit in this state, reachable or not, at the start of a beat.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(
        beat: Beat,
        due: Axis,
        f: i64,
        c: [u64; 2],
        sweep: Sweep,
        (rule, larger, e): (EndRule, Axis, u64),
        bits: u32,
    ) -> Self {
        let end = EndCounter::in_state(rule, larger, e);
        Self { registers: Registers { beat, due, f, c, sweep, end }, bits }
    }

    /// Whether every register agrees with that of another circuit, but before a look for what it will
    /// see.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn agrees_with(&self, other: &Self) -> bool {
        let (q, r) = (&self.registers, &other.registers);
        let sweeps_agree = match q.beat {
            Beat::Compare => q.sweep.agrees_before_look(&r.sweep),
            Beat::Judge | Beat::Feed | Beat::Update => q.sweep.agrees_with(&r.sweep),
        };
        q.beat == r.beat
            && q.due == r.due
            && q.f == r.f
            && same(q.c, r.c)
            && sweeps_agree
            && q.end == r.end
            && self.bits == other.bits
    }

    /// The register F.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn deviation_function(&self) -> i64 {
        self.registers.f
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
    #[inline(always)]
    fn judge(&self) -> Axis {
        let q = &self.registers;
        let ([x_stands, y_stands], [x_at_end, _]) = (q.sweep.stands(), q.sweep.at_end());
        let towards_is_y = q.sweep.towards() == Axis::Y;
        let (towards_stands, away_stands) =
            if towards_is_y { (y_stands, x_stands) } else { (x_stands, y_stands) };
        let feeds_towards = (q.f >= 0) & !towards_stands | away_stands;
        let due_is_x = if x_stands & y_stands { !x_at_end } else { feeds_towards != towards_is_y };
        if due_is_x { Axis::X } else { Axis::Y }
    }

    /// The clock edge. No beat writes what another of its registers is made of, except that an
    /// update's change of F needs the coordinate as it was.
    #[inline(always)]
    fn edge(&mut self) {
        if self.done() {
            return;
        }
        let judged = self.judge();
        let q = &mut self.registers;
        let is_due = [q.due == Axis::X, q.due == Axis::Y];
        let shrinks = [q.sweep.shrinks(0), q.sweep.shrinks(1)];
        match q.beat {
            Beat::Judge => q.due = judged,
            Beat::Feed => {
                for axis in 0..2 {
                    let falls = u64::from(is_due[axis] & shrinks[axis]);
                    q.c[axis] = q.c[axis].wrapping_sub(falls) & mask(self.bits);
                }
            }
            Beat::Update => {
                let change = signed(2 * q.due.of(q.c) as i64 + 1, q.due.of(shrinks));
                q.f = wrap(q.f + change, self.bits + 2);
                for axis in 0..2 {
                    let rises = u64::from(is_due[axis] & !shrinks[axis]);
                    q.c[axis] = (q.c[axis] + rises) & mask(self.bits);
                    q.sweep.count(axis, is_due[axis], q.sweep.is_negative(axis));
                }
                q.end.count(q.due);
            }
            Beat::Compare => q.sweep.look([q.c[0] == 0, q.c[1] == 0]),
        }
        q.beat = q.beat.next();
    }
}

impl Circuit for Arc {
    const CLOCKS_PER_CYCLE: u64 = 4;
    const NAME: &'static str = "ppc_arc";

    #[inline]
    fn pulses(&self) -> Pulse {
        let q = &self.registers;
        match q.beat {
            Beat::Feed => {
                let negative = q.due.of([q.sweep.is_negative(0), q.sweep.is_negative(1)]);
                Pulse::on(q.due, signed(1, negative) as i8)
            }
            Beat::Judge | Beat::Update | Beat::Compare => Pulse::NONE,
        }
    }

    #[inline]
    fn done(&self) -> bool {
        let q = &self.registers;
        q.beat == Beat::Judge && q.end.done(q.sweep.done())
    }

    #[inline]
    fn is_mid_cycle(&self) -> bool {
        self.registers.beat != Beat::Judge
    }

    // So that a loop of clocks keeps in the processor's registers what it can.
    #[inline(always)]
    fn clock(&mut self) -> Pulse {
        let pulses = self.pulses();
        self.edge();
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
