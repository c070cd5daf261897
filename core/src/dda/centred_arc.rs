//! Circular arc by digital integration, staggered and centred: the circuit that keeps one pulse.

use super::{Radix, Register};
use crate::{Direction, Error, Pulse, Sweep};

/// An arc about the origin with the centred staggered circuit.
///
/// The integrands are the signed coordinates, crossed; the remainder registers run up and down.
/// A clock of a counter-clockwise arc (clockwise: both signs turned) is
///
/// 1. JR_x ← JR_x − y: a carry out is a +x pulse, a borrow a −x pulse, and x takes it at once;
/// 2. JR_y ← JR_y + x with the x just *updated* (staggered): carry +y, borrow −y.
///
/// The quadrants need no table: the signs of x and y do it. Staggering alone closes the circle
/// on itself but draws a slight ellipse; the preset centres it (leap-frog): JR_y starts at half
/// load 2^(n−1) and JR_x at 2^(n−1) + y₀/2, half a step ahead (− for cw; rounded towards zero
/// where y₀ is odd and nothing is shifted).
///
/// With one headroom bit, R ≤ 2^(n−1) − 1, the path stays within one pulse of the circle and ends on
/// the end point. Only half load works: with full load, x = 0 would feed y nothing for ever.
///
/// Normalization shifts the integrands left as far as the headroom bit allows. The textbook's
/// rule (the second highest bit of a coordinate) would give that bit away for a start near 45°.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CentredArc {
    position: [i64; 2],
    jr: [u64; 2],
    sweep: Sweep,
    shift: u32,
    register: Register,
}

impl CentredArc {
    /// The arc from `start` to `end` in registers like `register`; equal ends mean a full circle.
    ///
    /// # Errors
    /// As [`Sweep::new`]; a decimal register; a register narrower than
    /// [`CentredArc::bits`].
    pub fn new(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        register: Register,
        normalize: bool,
    ) -> Result<Self, Error> {
        Self::along(Sweep::new(start, end, direction)?, start, register, normalize)
    }

    /// The arc from `start` along a sweep that begins there.
    fn along(
        sweep: Sweep,
        start: [i32; 2],
        register: Register,
        normalize: bool,
    ) -> Result<Self, Error> {
        if register.radix() != Radix::Binary {
            return Err(Error::ArcNeedsBinary);
        }
        let needed = Self::bits_along(&sweep);
        if register.digits() < needed {
            return Err(Error::RegisterTooNarrow { digits: register.digits(), needed });
        }
        let shift = if normalize { register.digits() - needed } else { 0 };
        let position = start.map(i64::from);
        let half = (register.modulus() / 2) as i64;
        let scaled = position[1] << shift;
        let ahead = match sweep.direction() {
            Direction::Ccw => scaled / 2,
            Direction::Cw => -scaled / 2,
        };
        Ok(Self { position, jr: [(half + ahead) as u64, half as u64], sweep, shift, register })
    }

    /// The arc from `start` along a sweep that begins there: [`CentredArc::new`] without its roots.
    #[cfg(feature = "proofs")]
    pub fn along_given(
        sweep: Sweep,
        start: [i32; 2],
        register: Register,
        normalize: bool,
    ) -> Result<Self, Error> {
        Self::along(sweep, start, register, normalize)
    }

    /// The arc in this state, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(
        sweep: Sweep,
        register: Register,
        shift: u32,
        jr: [u64; 2],
        position: [i64; 2],
    ) -> Self {
        Self { position, jr, sweep, shift, register }
    }

    /// The narrowest register that serves the arc, in bits: as a signed register it holds the
    /// whole circle, R ≤ 2^(n−1) − 1, which is the headroom bit.
    ///
    /// A radius between 2^(n−1) − 1 and 2^(n−1) is too much: the full circle from (11, −30) with
    /// n = 6 leaves it by 1.06 pulses.
    ///
    /// # Errors
    /// As [`Sweep::new`].
    pub fn bits(start: [i32; 2], end: [i32; 2], direction: Direction) -> Result<u32, Error> {
        Ok(Self::bits_along(&Sweep::new(start, end, direction)?))
    }

    fn bits_along(sweep: &Sweep) -> u32 {
        sweep.largest_coordinate().ilog2() + 2
    }

    /// One clock: x, then y; `None` once the end point is reached.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        if self.is_done() {
            return None;
        }
        let pulse = if self.sweep.is_stepping_out(self.position) {
            let pulse = self.sweep.step_out(self.position);
            self.position[0] += i64::from(pulse.0[0]);
            self.position[1] += i64::from(pulse.0[1]);
            pulse
        } else {
            self.accumulate()
        };
        self.sweep.arrive(self.position);
        debug_assert!(self.invariant());
        Some(pulse)
    }

    #[inline]
    fn accumulate(&mut self) -> Pulse {
        let [x_stands, y_stands] = self.sweep.stands(self.position);
        let mut pulse = Pulse::NONE;
        if !x_stands {
            pulse.0[0] = self.add(0, self.integrands()[0]);
            self.position[0] += i64::from(pulse.0[0]);
        }
        if !y_stands {
            pulse.0[1] = self.add(1, self.integrands()[1]);
            self.position[1] += i64::from(pulse.0[1]);
        }
        pulse
    }

    /// Adds to a remainder register; +1 for a carry out, −1 for a borrow.
    #[inline]
    fn add(&mut self, axis: usize, integrand: i64) -> i8 {
        let modulus = self.register.modulus() as i64;
        let sum = self.jr[axis] as i64 + integrand;
        let (rest, pulse) = match sum {
            _ if sum >= modulus => (sum - modulus, 1),
            _ if sum < 0 => (sum + modulus, -1),
            _ => (sum, 0),
        };
        self.jr[axis] = rest as u64;
        pulse
    }

    /// What the next clock adds to each remainder, were the other axis to stay: −y and x (ccw),
    /// y and −x (cw), shifted left by Q.
    #[inline]
    #[must_use]
    pub fn integrands(&self) -> [i64; 2] {
        let [x, y] = self.position;
        match self.sweep.direction() {
            Direction::Ccw => [-y << self.shift, x << self.shift],
            Direction::Cw => [y << self.shift, -x << self.shift],
        }
    }

    /// The remainder registers.
    #[must_use]
    pub const fn remainders(&self) -> [u64; 2] {
        self.jr
    }

    /// The width of the registers.
    #[must_use]
    pub const fn register(&self) -> Register {
        self.register
    }

    /// Q, the number of left shifts that normalization made.
    #[must_use]
    pub const fn shift(&self) -> u32 {
        self.shift
    }

    /// Where the arc is on its way round.
    #[must_use]
    pub const fn sweep(&self) -> &Sweep {
        &self.sweep
    }

    /// Whether the end point is reached.
    #[inline]
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.sweep.crossings_left() == 0 && self.residual() == [0; 2]
    }

    /// Pulses to the end point as [`Sweep::pulses_to_go`] counts them: exact in the last
    /// quadrant, where they are the sum of the two end counters.
    #[must_use]
    pub fn remaining(&self) -> u64 {
        let [x, y] = self.sweep.pulses_to_go(self.position);
        x + y
    }

    /// The present point.
    #[must_use]
    pub const fn position(&self) -> [i64; 2] {
        self.position
    }

    /// What is missing to the end point: zero when done.
    #[inline]
    #[must_use]
    pub fn residual(&self) -> [i64; 2] {
        let end = self.sweep.end();
        [end[0] - self.position[0], end[1] - self.position[1]]
    }

    /// What always holds: remainders and coordinates are within their registers, until an end
    /// point off the circle is stepped out to.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let modulus = self.register.modulus();
        self.sweep.invariant()
            && self.jr.iter().all(|remainder| *remainder < modulus)
            && (self.sweep.stands(self.position) != [false; 2]
                || self.position.iter().all(|c| c.unsigned_abs() << self.shift <= modulus / 2))
    }
}

impl Iterator for CentredArc {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
