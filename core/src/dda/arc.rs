//! Circular arc by digital integration, as the textbooks have it.

use super::{Preset, Radix, Register};
use crate::{Direction, Error, Feeds, Pulse, Sweep};

/// An arc about the origin with the textbook's circuit: both integrators add in the same clock.
///
/// The integrands are the coordinates of the moving point, crossed: JV_x holds |y| and JV_y
/// holds |x|. Every clock adds both with the coordinates as they stood before it; then each
/// pulse corrects the integrand that follows its axis by ±1 (±2^Q when normalized). Quadrants
/// are crossed by changing the signs only, the remainders stay.
///
/// **This circuit does not keep within one pulse of the circle**: the worst radial deviation
/// of a quarter circle is 1.79 pulses with the zero preset and 1.26 with half load (n = 10), and
/// over a full circle the radius grows by more than 4. [`CentredArc`](super::CentredArc) does better;
/// this one stands here as the reference of what is taught.
///
/// Two end counters hold the distance to the end point; in the last quadrant an axis whose
/// counter is spent stops iterating.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arc {
    position: [i64; 2],
    jr: [u64; 2],
    sweep: Sweep,
    shift: u32,
    register: Register,
}

impl Arc {
    /// The arc from `start` to `end` in registers like `register`; equal ends mean a full circle.
    ///
    /// # Errors
    /// As [`Sweep::new`]; a decimal register; a register narrower than [`Arc::bits`].
    pub fn new(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        register: Register,
        preset: Preset,
        normalize: bool,
    ) -> Result<Self, Error> {
        Self::along(Sweep::new(start, end, direction)?, start, register, preset, normalize)
    }

    /// The arc from `start` along a sweep that begins there.
    fn along(
        sweep: Sweep,
        start: [i32; 2],
        register: Register,
        preset: Preset,
        normalize: bool,
    ) -> Result<Self, Error> {
        if register.radix() != Radix::Binary {
            return Err(Error::ArcNeedsBinary);
        }
        let needed = Self::bits_along(&sweep);
        if register.digits() < needed {
            return Err(Error::RegisterTooNarrow { digits: register.digits(), needed });
        }
        let shift = if normalize {
            let largest = start[0].unsigned_abs().max(start[1].unsigned_abs());
            let second_bit = register.digits().saturating_sub(2);
            second_bit.saturating_sub(largest.ilog2()).min(register.digits() - needed)
        } else {
            0
        };
        Ok(Self {
            position: start.map(i64::from),
            jr: [preset.value(register); 2],
            sweep,
            shift,
            register,
        })
    }

    /// The arc from `start` along a sweep that begins there: [`Arc::new`] without its roots.
    #[cfg(feature = "proofs")]
    pub fn along_given(
        sweep: Sweep,
        start: [i32; 2],
        register: Register,
        preset: Preset,
        normalize: bool,
    ) -> Result<Self, Error> {
        Self::along(sweep, start, register, preset, normalize)
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

    /// The narrowest register that serves the arc, in bits: it holds every coordinate on the way.
    ///
    /// Within one quadrant none exceeds R. Beyond it this circuit's circle grows, and R + 5 is asked
    /// for: in an exhaustive sweep of n = 3…8, no arc with R + 4 ≤ 2ⁿ − 1 grew out of the register
    /// (R rounded up), and few with R + 3. That is measured, not proved for wider registers.
    ///
    /// # Errors
    /// As [`Sweep::new`].
    pub fn bits(start: [i32; 2], end: [i32; 2], direction: Direction) -> Result<u32, Error> {
        Ok(Self::bits_along(&Sweep::new(start, end, direction)?))
    }

    fn bits_along(sweep: &Sweep) -> u32 {
        const GROWTH: u64 = 5;
        let crosses = sweep.crossings_left() > 0;
        let growth = if crosses { GROWTH } else { 0 };
        (sweep.largest_coordinate() + growth).ilog2() + 1
    }

    /// One accumulation of both integrators; `None` once the end point is reached.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        if self.is_done() {
            return None;
        }
        let pulse = if self.sweep.is_stepping_out(self.position) {
            self.sweep.step_out(self.position)
        } else {
            self.accumulate()
        };
        for axis in 0..2 {
            self.position[axis] += i64::from(pulse.0[axis]);
        }
        self.sweep.arrive(self.position);
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// Adds the integrands to the remainders of the axes that do not stand.
    #[inline]
    fn accumulate(&mut self) -> Pulse {
        let modulus = self.register.modulus();
        let jv = self.integrands();
        let stands = self.sweep.stands(self.position);
        let Feeds { towards, away } = self.sweep.feeds();
        let mut pulse = Pulse::NONE;
        for axis in 0..2 {
            if stands[axis] {
                continue;
            }
            let feed = if towards.axis.index() == axis { towards } else { away };
            let sum = self.jr[axis] + jv[axis];
            let carry = sum >= modulus;
            self.jr[axis] = if carry { sum - modulus } else { sum };
            pulse.0[axis] = if carry { feed.sign } else { 0 };
        }
        pulse
    }

    /// The integrand registers: JV_x follows |y|, JV_y follows |x|, both shifted left by Q.
    #[inline]
    #[must_use]
    pub fn integrands(&self) -> [u64; 2] {
        let [x, y] = self.position;
        [y.unsigned_abs() << self.shift, x.unsigned_abs() << self.shift]
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

    /// What always holds: every register is within its width, until an end point off the circle
    /// is stepped out to.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let modulus = self.register.modulus();
        let is_held = |content: &u64| *content < modulus;
        self.sweep.invariant()
            && self.jr.iter().all(is_held)
            && (self.sweep.stands(self.position) != [false; 2]
                || self.integrands().iter().all(is_held))
    }
}

impl Iterator for Arc {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
