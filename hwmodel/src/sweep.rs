//! The control of an arc's sweep: quadrant, crossings and the two end counters.

use crate::trace::{Kind, Probe};
use crate::word::wrap;
use onepulse_core::{self as software, Axis, Direction, Error, Feeds, Pulse, Quadrant};

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

    /// The decoder's outputs by axis: the sign of its pulses in this quadrant.
    #[inline]
    pub(crate) const fn signs(&self) -> [i8; 2] {
        let Feeds { towards, away } = self.feeds();
        match towards.axis {
            Axis::X => [towards.sign, away.sign],
            Axis::Y => [away.sign, towards.sign],
        }
    }

    /// By how much a pulse changes the magnitude of its axis' coordinate: a pulse towards zero
    /// makes it smaller, one away from it larger; stepping out may go against the quadrant's
    /// direction.
    #[inline]
    pub(crate) const fn growth(&self, Pulse([x, y]): Pulse) -> [i64; 2] {
        let [sx, sy] = self.signs();
        let (gx, gy) = match self.feeds().towards.axis {
            Axis::X => (-1, 1),
            Axis::Y => (1, -1),
        };
        [(x * sx) as i64 * gx, (y * sy) as i64 * gy]
    }

    /// Each axis' stop wire: in the last quadrant, its end counter is zero or has run through.
    #[inline]
    pub(crate) const fn stands(&self) -> [bool; 2] {
        let [sx, sy] = self.signs();
        let [x, y] = self.je;
        let is_last = self.crossings == 0;
        [is_last && x * sx as i64 <= 0, is_last && y * sy as i64 <= 0]
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
        let [towards_is_zero, away_is_zero] = match self.feeds().towards.axis {
            Axis::X => is_zero,
            Axis::Y => [is_zero[1], is_zero[0]],
        };
        let crosses = self.crossings > 0 && towards_is_zero && !away_is_zero;
        let Pulse([px, py]) = pulse;
        let [jex, jey] = self.je;
        let count = |je: i64, pulse: i8| wrap(je - i64::from(pulse), self.bits + 2);
        Self {
            quadrant: if crosses { self.quadrant.next(self.direction) } else { self.quadrant },
            crossings: self.crossings - u8::from(crosses),
            je: [count(jex, px), count(jey, py)],
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
