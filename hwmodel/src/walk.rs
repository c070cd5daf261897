//! The way round a circle, step by step: the registers that all arcs share in which F decides.

use crate::Sweep;
use crate::probe::{Kind, Probe};
use crate::word::{mask, signed, wrap};
use onepulse_core::dda::{Radix, Register};
use onepulse_core::{self as software, Axis, Direction, Error, Pulse};

/// The place on the circle: F, the magnitudes of the moving point, and the sweep. Two clocks a step:
///
/// ```text
///  judge   the sweep looks where the arc is; DUEx, DUEy ← what the method asks for there
///  move    pulses; F ← F − 2c + 1, c ← c − 1 (towards zero)  or  F + 2c + 1, c ← c + 1 (away), of one axis
///          or of both; the end counters count them
/// ```
///
/// In the last quadrant an axis that stands is not fed, the other one is; when both stand, what an end
/// point off the circle still lacks is stepped out, x first.
///
/// Neither method leaves the circle by a whole pulse outwards, so that R rounded up, or the end point, is the
/// largest coordinate: n bits. |F| ≤ |x| + |y| < 2ⁿ⁺¹: n + 2 bits. F may wrap once an axis stands, for then it
/// decides nothing any more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Walk {
    beat: Beat,
    /// The axes that are due as far as F decides.
    due: [bool; 2],
    /// The deviation function, n + 2 bits, signed.
    f: i64,
    /// |x| and |y|, n bits.
    c: [u64; 2],
    sweep: Sweep,
    bits: u32,
}

/// What this clock does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Beat {
    Judge,
    Move,
}

/// What a method judges by: F, and the magnitudes of the coordinate that is fed towards zero and of the one
/// that is fed away from it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub(crate) f: i64,
    pub(crate) towards: i64,
    pub(crate) away: i64,
}

impl Walk {
    /// The registers, loaded with the arc from `start` to `end`, in a width of `bits` bits.
    pub(crate) fn new(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        bits: u32,
    ) -> Result<Self, Error> {
        Register::new(Radix::Binary, bits)?;
        let needed = Self::bits(start, end, direction)?;
        if bits < needed {
            return Err(Error::RegisterTooNarrow { digits: bits, needed });
        }
        let c = start.map(|c| u64::from(c.unsigned_abs()));
        let sweep = Sweep::new(start, end, direction, bits)?;
        Ok(Self { beat: Beat::Judge, due: [false; 2], f: 0, c, sweep, bits })
    }

    /// The narrowest registers that serve the arc, in bits.
    pub(crate) fn bits(start: [i32; 2], end: [i32; 2], direction: Direction) -> Result<u32, Error> {
        let sweep = software::Sweep::new(start, end, direction)?;
        Ok(sweep.largest_coordinate().ilog2() + 1)
    }

    /// Whether each axis is sent a pulse, if this is the clock in which they move.
    #[inline(always)]
    const fn moves(&self) -> [bool; 2] {
        let ([x_stands, y_stands], [x_at_end, _]) = (self.sweep.stands(), self.sweep.at_end());
        if x_stands & y_stands {
            [!x_at_end, x_at_end]
        } else {
            [!x_stands & (y_stands | self.due[0]), !y_stands & (x_stands | self.due[1])]
        }
    }

    /// The pulse wires during this clock.
    #[inline(always)]
    pub(crate) fn pulses(&self) -> Pulse {
        match self.beat {
            Beat::Judge => Pulse::NONE,
            Beat::Move => {
                let [x, y] = self.moves().map(i64::from);
                let [nx, ny] = [0, 1].map(|axis| self.sweep.is_negative(axis));
                Pulse([signed(x, nx) as i8, signed(y, ny) as i8])
            }
        }
    }

    /// The done wire.
    #[inline(always)]
    pub(crate) fn done(&self) -> bool {
        self.beat == Beat::Judge && self.sweep.done()
    }

    #[inline(always)]
    pub(crate) fn is_mid_cycle(&self) -> bool {
        self.beat == Beat::Move
    }

    /// The clock edge; `judge` says whether the motion towards zero is due, and whether the one away from it.
    #[inline(always)]
    pub(crate) fn edge(&mut self, judge: impl Fn(Place) -> [bool; 2]) {
        if self.done() {
            return;
        }
        match self.beat {
            Beat::Judge => {
                self.beat = Beat::Move;
                self.sweep.look([self.c[0] == 0, self.c[1] == 0]);
                // A quadrant that is entered by this look is judged already.
                let towards_is_y = self.sweep.towards() == Axis::Y;
                let [x, y] = self.c.map(|c| c as i64);
                let (towards, away) = if towards_is_y { (y, x) } else { (x, y) };
                let [feeds_towards, feeds_away] = judge(Place { f: self.f, towards, away });
                self.due = if towards_is_y {
                    [feeds_away, feeds_towards]
                } else {
                    [feeds_towards, feeds_away]
                };
            }
            Beat::Move => {
                let moves = self.moves();
                for axis in 0..2 {
                    let (moves, shrinks) = (moves[axis], self.sweep.shrinks(axis));
                    let change = signed(2 * self.c[axis] as i64, shrinks) + 1;
                    self.f = wrap(self.f + change * i64::from(moves), self.bits + 2);
                    let step = signed(i64::from(moves), shrinks);
                    self.c[axis] = self.c[axis].wrapping_add_signed(step) & mask(self.bits);
                    self.sweep.count(axis, moves, self.sweep.is_negative(axis));
                }
                self.beat = Beat::Judge;
            }
        }
    }

    pub(crate) fn probe(&self, probe: &mut impl Probe) {
        const WORDS: &[&str] = &["JUDGE", "MOVE"];
        probe.signal("beat", Kind::Word(WORDS), self.beat as u64);
        for axis in 0..2 {
            probe.axis_signal("due_", axis, Kind::Bit, u64::from(self.due[axis]));
        }
        probe.signal("f", Kind::Signed(self.bits + 2), self.f as u64);
        for axis in 0..2 {
            probe.axis_signal("c", axis, Kind::Unsigned(self.bits), self.c[axis]);
        }
        self.sweep.probe(probe);
    }
}
