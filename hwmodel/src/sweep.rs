//! The control of an arc's sweep: quadrant, crossings and the two end counters.

use crate::probe::{Kind, Probe};
#[cfg(feature = "proofs")]
use crate::word::same;
use crate::word::{signed, wrap};
use onepulse_core::{self as software, Axis, Direction, Error, Feeds, Quadrant};

/// The sweep control registers that every arc circuit contains.
///
/// The end counters JEx and JEy hold the signed distance to the end point and count with every
/// pulse. Once a cycle the circuit *looks* where the arc is: a quadrant that has been run through
/// is left, and what the cycle needs to know of counters, coordinates and quadrant goes into
/// flip-flops, so that zero detectors and adders have a clock each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sweep {
    quadrant: Quadrant,
    /// Coordinate axes still to be crossed, 3 bits.
    crossings: u8,
    /// End counters, n + 2 bits, signed.
    je: [i64; 2],
    /// Whether the axis fed towards zero is y; x is fed away from it then.
    towards_is_y: bool,
    /// Whether the quadrant feeds each axis in its negative direction.
    feeds_negative: [bool; 2],
    looked: Looked,
    direction: Direction,
    bits: u32,
}

/// What the last look saw, an axis each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Looked {
    /// The end counter was zero.
    at_end: [bool; 2],
    /// In the last quadrant, the end counter was zero or had run through: the axis stands.
    stands: [bool; 2],
    /// What is left is stepped out.
    stepping_out: bool,
    /// The direction of this cycle's pulse, if there is one.
    negative: [bool; 2],
    /// Whether that pulse makes the magnitude of its coordinate smaller.
    shrinks: [bool; 2],
}

impl Looked {
    /// Whether all agree, but for the end counters' zeros.
    #[cfg(feature = "proofs")]
    fn agrees_but_for_ends(&self, other: &Self) -> bool {
        same(self.stands, other.stands)
            && self.stepping_out == other.stepping_out
            && same(self.negative, other.negative)
            && same(self.shrinks, other.shrinks)
    }
}

impl Sweep {
    /// The registers, loaded with the sweep from `start` to `end`, beside coordinates of `bits`
    /// bits.
    pub(crate) fn new(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        bits: u32,
    ) -> Result<Self, Error> {
        let sweep = software::Sweep::new(start, end, direction)?;
        let distance = |axis: usize| i64::from(end[axis]) - i64::from(start[axis]);
        let je = [distance(0), distance(1)];
        Ok(Self::loaded(sweep.quadrant(), sweep.crossings_left(), je, direction, bits))
    }

    /// The registers after a load of these contents.
    pub(crate) fn loaded(
        quadrant: Quadrant,
        crossings: u8,
        je: [i64; 2],
        direction: Direction,
        bits: u32,
    ) -> Self {
        let Feeds { towards, away } = quadrant.feeds(direction);
        let towards_is_y = towards.axis == Axis::Y;
        let (x, y) = if towards_is_y { (away, towards) } else { (towards, away) };
        let mut sweep = Self {
            quadrant,
            crossings,
            je: je.map(|je| wrap(je, bits + 2)),
            towards_is_y,
            feeds_negative: [x.sign < 0, y.sign < 0],
            looked: Looked {
                at_end: [true; 2],
                stands: [true; 2],
                stepping_out: true,
                negative: [false; 2],
                shrinks: [false; 2],
            },
            direction,
            bits,
        };
        sweep.looked = sweep.see([false; 2]);
        sweep
    }

    /// The registers in this state, reachable or not, after a look at coordinates of which `is_zero`
    /// tells whether they are zero.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn in_state(
        quadrant: Quadrant,
        crossings: u8,
        je: [i64; 2],
        direction: Direction,
        bits: u32,
        is_zero: [bool; 2],
    ) -> Self {
        let mut sweep = Self::loaded(quadrant, crossings, je, direction, bits);
        sweep.looked = sweep.see(is_zero);
        sweep
    }

    /// The same with these in the flip-flops that the next look writes in any case: those of the end
    /// counters' zeros, and in the last quadrant all of them.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn with_leftovers(
        mut self,
        at_end: [bool; 2],
        stands: [bool; 2],
        stepping_out: bool,
        negative: [bool; 2],
        shrinks: [bool; 2],
    ) -> Self {
        if self.crossings == 0 {
            self.looked = Looked { at_end, stands, stepping_out, negative, shrinks };
        }
        self.looked.at_end = at_end;
        self
    }

    /// The same with these end counters, which must fit them.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn with_counters(mut self, je: [i64; 2]) -> Self {
        self.je = je;
        self
    }

    /// The same after a look that saw this.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn with_look(
        mut self,
        at_end: [bool; 2],
        stands: [bool; 2],
        stepping_out: bool,
        negative: [bool; 2],
        shrinks: [bool; 2],
    ) -> Self {
        self.looked = Looked { at_end, stands, stepping_out, negative, shrinks };
        self
    }

    /// Whether the registers agree with those of another sweep control.
    #[cfg(feature = "proofs")]
    pub(crate) fn agrees_with(&self, other: &Self) -> bool {
        self.agrees_but_for_look(other)
            && same(self.looked.at_end, other.looked.at_end)
            && self.looked.agrees_but_for_ends(&other.looked)
    }

    /// The same, but for what the next look writes in any case.
    #[cfg(feature = "proofs")]
    pub(crate) fn agrees_before_look(&self, other: &Self) -> bool {
        self.agrees_but_for_look(other)
            && (self.crossings == 0 || self.looked.agrees_but_for_ends(&other.looked))
    }

    #[cfg(feature = "proofs")]
    fn agrees_but_for_look(&self, other: &Self) -> bool {
        self.quadrant == other.quadrant
            && self.crossings == other.crossings
            && same(self.je, other.je)
            && self.towards_is_y == other.towards_is_y
            && same(self.feeds_negative, other.feeds_negative)
            && self.direction == other.direction
            && self.bits == other.bits
    }

    /// The registers after a reset.
    pub(crate) fn reset(bits: u32) -> Self {
        Self::loaded(Quadrant::I, 0, [0; 2], Direction::Ccw, bits)
    }

    /// The sense flip-flop.
    #[inline(always)]
    pub(crate) const fn direction(&self) -> Direction {
        self.direction
    }

    /// Which axis is fed towards zero.
    #[inline(always)]
    pub(crate) const fn towards(&self) -> Axis {
        if self.towards_is_y { Axis::Y } else { Axis::X }
    }

    /// Each axis' stop wire: in the last quadrant, its end counter is zero or has run through.
    #[inline(always)]
    pub(crate) const fn stands(&self) -> [bool; 2] {
        self.looked.stands
    }

    /// Whether each end counter is zero.
    #[inline(always)]
    pub(crate) const fn at_end(&self) -> [bool; 2] {
        self.looked.at_end
    }

    /// Integration has nothing more to do: both axes stand, or one stands on a coordinate axis,
    /// where it would feed the other nothing for ever. Each axis that is not at its end is sent a
    /// pulse.
    #[inline(always)]
    pub(crate) const fn is_stepping_out(&self) -> bool {
        self.looked.stepping_out
    }

    /// Whether this cycle's pulse of an axis makes the magnitude of its coordinate smaller.
    #[inline(always)]
    pub(crate) const fn shrinks(&self, axis: usize) -> bool {
        self.looked.shrinks[axis]
    }

    /// Whether this cycle's pulse of an axis is negative, as the quadrant has it or as it is
    /// stepped out.
    #[inline(always)]
    pub(crate) const fn is_negative(&self, axis: usize) -> bool {
        self.looked.negative[axis]
    }

    /// The done wire.
    #[inline(always)]
    pub(crate) const fn done(&self) -> bool {
        self.crossings == 0 && self.je[0] == 0 && self.je[1] == 0
    }

    /// The edge of a look, when the coordinates' zero detectors show `is_zero`.
    #[inline(always)]
    pub(crate) fn look(&mut self, is_zero: [bool; 2]) {
        let [x, y] = is_zero;
        let (towards, away) = if self.towards_is_y { (y, x) } else { (x, y) };
        if self.crossings == 0 {
            self.looked = self.see(is_zero);
        // The circle of radius 1 steps through its centre: the quadrant being left is kept there.
        } else if towards && !away {
            self.cross();
            self.looked = self.see(is_zero);
        } else {
            // Until the last quadrant, the other flip-flops keep what they took with this one.
            self.looked.at_end = self.at_end_now();
            debug_assert_eq!(self.looked, self.see(is_zero));
        }
    }

    /// The next quadrant. What was fed away from zero is fed towards it now.
    ///
    /// Seldom needed, so that it is kept out of the way; but a proof has to have everything in one
    /// place.
    #[cfg_attr(not(feature = "proofs"), cold)]
    #[cfg_attr(feature = "proofs", inline(always))]
    fn cross(&mut self) {
        self.quadrant = self.quadrant.next(self.direction);
        self.crossings -= 1;
        // The axis fed towards zero goes on in its direction, the other turns round.
        let [x, y] = self.feeds_negative;
        self.feeds_negative = [x ^ self.towards_is_y, y ^ !self.towards_is_y];
        self.towards_is_y ^= true;
    }

    /// The zero detectors of the end counters.
    #[inline(always)]
    const fn at_end_now(&self) -> [bool; 2] {
        [self.je[0] == 0, self.je[1] == 0]
    }

    /// What a look sees. As gates: a choice would cost a simulation more than both its ways.
    #[inline(always)]
    const fn see(&self, is_zero: [bool; 2]) -> Looked {
        let is_last = self.crossings == 0;
        let at_end = self.at_end_now();
        let back = [self.je[0] < 0, self.je[1] < 0];
        let feeds = self.feeds_negative;
        let runs_back = [is_last & (back[0] != feeds[0]), is_last & (back[1] != feeds[1])];
        let stands = [is_last & at_end[0] | runs_back[0], is_last & at_end[1] | runs_back[1]];
        Looked {
            at_end,
            stands,
            stepping_out: stands[0] & stands[1] | stands[0] & is_zero[0] | stands[1] & is_zero[1],
            // In the last quadrant every pulse leads to the end point, stepped out or not.
            negative: [feeds[0] != runs_back[0], feeds[1] != runs_back[1]],
            shrinks: [self.towards_is_y == runs_back[0], self.towards_is_y != runs_back[1]],
        }
    }

    /// The edge of an axis' end counter, if there is a pulse of this direction.
    #[inline(always)]
    pub(crate) fn count(&mut self, axis: usize, pulse: bool, is_negative: bool) {
        let pulse = signed(i64::from(pulse), is_negative);
        self.je[axis] = wrap(self.je[axis] - pulse, self.bits + 2);
    }

    #[inline(always)]
    pub(crate) fn probe(&self, probe: &mut impl Probe) {
        const WORDS: &[&str] = &["I", "II", "III", "IV"];
        probe.signal("quadrant", Kind::Word(WORDS), self.quadrant as u64);
        probe.signal("crossings", Kind::Unsigned(3), u64::from(self.crossings));
        probe.signal("cw", Kind::Bit, u64::from(self.direction == Direction::Cw));
        for axis in 0..2 {
            probe.axis_signal("je", axis, Kind::Signed(self.bits + 2), self.je[axis] as u64);
        }
        probe.signal("last", Kind::Bit, u64::from(self.crossings == 0));
        probe.signal("towards_is_y", Kind::Bit, u64::from(self.towards_is_y));
        for (stem, flags) in [
            ("feeds_n", self.feeds_negative),
            ("at_end_", self.looked.at_end),
            ("stands_", self.looked.stands),
            ("n", self.looked.negative),
            ("shrinks_", self.looked.shrinks),
        ] {
            for axis in 0..2 {
                probe.axis_signal(stem, axis, Kind::Bit, u64::from(flags[axis]));
            }
        }
        probe.signal("stepping_out", Kind::Bit, u64::from(self.looked.stepping_out));
    }
}
