//! The control of an arc's sweep: quadrant, crossings and the two end counters.

use crate::trace::{Kind, Probe};
use crate::word::wrap;
use onepulse_core::{self as software, Direction, Error, Feeds, Pulse, Quadrant};

/// The sweep control registers that every arc circuit contains.
///
/// The end counters JEx and JEy hold the signed distance to the end point and count with every
/// pulse; the crossing counter tells when they may stop their axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sweep {
    quadrant: Quadrant,
    /// Coordinate axes still to be crossed, 3 bits.
    crossings: u8,
    /// End counters, n + 2 bits, signed.
    je: [i64; 2],
    direction: Direction,
    bits: u32,
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
        Ok(Self {
            quadrant: sweep.quadrant(),
            crossings: sweep.crossings_left(),
            je: [wrap(distance(0), bits + 2), wrap(distance(1), bits + 2)],
            direction,
            bits,
        })
    }

    /// The sense flip-flop.
    pub(crate) const fn direction(&self) -> Direction {
        self.direction
    }

    /// The decoder from quadrant and sense to the axes' motions.
    pub(crate) const fn feeds(&self) -> Feeds {
        self.quadrant.feeds(self.direction)
    }

    /// Each axis' stop wire: in the last quadrant, its end counter is zero or has run through.
    pub(crate) fn stands(&self) -> [bool; 2] {
        let Feeds { towards, away } = self.feeds();
        let mut stands = [false; 2];
        for feed in [towards, away] {
            let to_go = self.je[feed.axis.index()] * i64::from(feed.sign);
            stands[feed.axis.index()] = self.crossings == 0 && to_go <= 0;
        }
        stands
    }

    /// The wire that ends integration, from the stop wires and each coordinate's zero detector.
    pub(crate) const fn is_stepping_out(stands: [bool; 2], is_zero: [bool; 2]) -> bool {
        match stands {
            [true, true] => true,
            [true, false] => is_zero[0],
            [false, true] => is_zero[1],
            [false, false] => false,
        }
    }

    /// A pulse on every axis whose end counter is not zero.
    pub(crate) const fn step_out(&self) -> Pulse {
        Pulse([self.je[0].signum() as i8, self.je[1].signum() as i8])
    }

    /// The done wire.
    pub(crate) const fn done(&self) -> bool {
        self.crossings == 0 && self.je[0] == 0 && self.je[1] == 0
    }

    /// The next contents after `pulse`, when the coordinates' zero detectors then show `is_zero`.
    pub(crate) fn next(&self, pulse: Pulse, is_zero: [bool; 2]) -> Self {
        let Feeds { towards, away } = self.feeds();
        let crosses =
            self.crossings > 0 && is_zero[towards.axis.index()] && !is_zero[away.axis.index()];
        let count = |axis: usize| wrap(self.je[axis] - i64::from(pulse.0[axis]), self.bits + 2);
        Self {
            quadrant: if crosses { self.quadrant.next(self.direction) } else { self.quadrant },
            crossings: self.crossings - u8::from(crosses),
            je: [count(0), count(1)],
            ..*self
        }
    }

    pub(crate) fn probe(&self, probe: &mut impl Probe) {
        const WORDS: &[&str] = &["I", "II", "III", "IV"];
        probe.signal("quadrant", Kind::Word(WORDS), self.quadrant as u64);
        probe.signal("crossings", Kind::Unsigned(3), u64::from(self.crossings));
        for axis in 0..2 {
            probe.axis_signal("je", axis, Kind::Signed(self.bits + 2), self.je[axis] as u64);
        }
    }
}
