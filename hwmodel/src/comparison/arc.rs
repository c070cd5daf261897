//! The circuit of an arc by comparison integration.

use crate::Circuit;
use crate::probe::Probe;
use crate::walk::{Place, Walk};
use onepulse_core::{Direction, Error, Pulse};

/// The registers F, |x|, |y| and the sweep, and two adders that judge. Two clocks a step:
///
/// ```text
///  judge   the sweep looks where the arc is; t is fed towards zero, a away from it
///          DUE(t) ← F − t + a + 1 ≥ 0, DUE(a) ← F − t + a < 0    both when level
///  move    pulses; F ← F − 2t + 1, t ← t − 1  and  F ← F + 2a + 1, a ← a + 1; the counters count
/// ```
///
/// In the last quadrant an axis that stands is not fed, the other one is; when both stand, what an end
/// point off the circle still lacks is stepped out, x first. The sweep's zero detectors need the counters
/// as the pulses left them: that is why a step takes two clocks.
///
/// |x| and |y| have n bits: while F decides, the larger one, c, has c² ≤ R² + c at most, and is R rounded up or
/// less. |F| ≤ |x| + |y| < 2ⁿ⁺¹: n + 2 bits; it may wrap once an axis stands, for then it decides nothing any
/// more. The sums are between −3·2ⁿ and 3·2ⁿ: n + 3 bits. The end counters have n + 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arc {
    walk: Walk,
}

impl Arc {
    /// The circuit, loaded with the arc from `start` to `end`, in registers of `bits` bits.
    ///
    /// # Errors
    /// As [`onepulse_core::comparison::Arc::new`]; a width of 0 or over 32 bits, or less than
    /// [`Arc::bits`].
    pub fn new(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        bits: u32,
    ) -> Result<Self, Error> {
        Ok(Self { walk: Walk::new(start, end, direction, bits)? })
    }

    /// The narrowest registers that serve the arc, in bits.
    ///
    /// # Errors
    /// As [`onepulse_core::Sweep::new`].
    pub fn bits(start: [i32; 2], end: [i32; 2], direction: Direction) -> Result<u32, Error> {
        Walk::bits(start, end, direction)
    }

    /// Whether the motion towards zero is due, and whether the one away from it.
    #[inline(always)]
    const fn judge(Place { f, towards, away }: Place) -> [bool; 2] {
        let level = f - towards + away;
        [level + 1 >= 0, level < 0]
    }
}

impl Circuit for Arc {
    const CLOCKS_PER_CYCLE: u64 = 2;
    const NAME: &'static str = "comparison_arc";

    #[inline]
    fn pulses(&self) -> Pulse {
        self.walk.pulses()
    }

    #[inline]
    fn done(&self) -> bool {
        self.walk.done()
    }

    #[inline]
    fn is_mid_cycle(&self) -> bool {
        self.walk.is_mid_cycle()
    }

    #[inline]
    fn clock(&mut self) -> Pulse {
        let pulses = self.pulses();
        self.walk.edge(Self::judge);
        pulses
    }

    fn probe(&self, probe: &mut impl Probe) {
        self.walk.probe(probe);
    }
}
