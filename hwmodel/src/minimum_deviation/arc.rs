//! The circuit of an arc by minimum deviation.

use crate::Circuit;
use crate::probe::Probe;
use crate::walk::{Place, Walk};
use onepulse_core::{Direction, Error, Pulse};

/// The registers F, |x|, |y| and the sweep, and two adders that judge. Two clocks a step:
///
/// ```text
///  judge   the sweep looks where the arc is; t is fed towards zero, a away from it
///          DUE(t) ← F − t + 2a + 1 ≥ 0, DUE(a) ← F − 2t + a + 1 < 0    both when the diagonal is nearest
///  move    pulses; F ← F − 2t + 1, t ← t − 1  and  F ← F + 2a + 1, a ← a + 1; the counters count
/// ```
///
/// The candidates are T = F − 2t + 1, B = F − 2t + 2a + 2 (both) and A = F + 2a + 1, and as T < B < A, sums of
/// neighbours say which is nearest to 0: A goes first only if |A| < |B|, which is A + B < 0, and T only if
/// |T| < |B|, which is T + B > 0. Half of A + B is F − t + 2a + 3/2, half of T + B is F − 2t + a + 3/2; no
/// magnitude is compared.
///
/// In the last quadrant an axis that stands is not fed, the other one is; when both stand, what an end
/// point off the circle still lacks is stepped out, x first. The sweep's zero detectors need the counters
/// as the pulses left them: that is why a step takes two clocks.
///
/// |x| and |y| have n bits: while F decides, the larger one, c, has c² ≤ R² + c at most, and is R rounded up or
/// less. |F| ≤ max(|x|, |y|) < 2ⁿ would do with n + 1 bits; it has the n + 2 of the other method, and may wrap
/// once an axis stands, for then it decides nothing any more. The sums are between −3·2ⁿ and 3·2ⁿ: n + 3 bits.
/// The end counters have n + 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arc {
    walk: Walk,
}

impl Arc {
    /// The circuit, loaded with the arc from `start` to `end`, in registers of `bits` bits.
    ///
    /// # Errors
    /// As [`onepulse_core::minimum_deviation::Arc::new`]; a width of 0 or over 32 bits, or less than
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
        [f - towards + 2 * away + 1 >= 0, f - 2 * towards + away + 1 < 0]
    }
}

impl Circuit for Arc {
    const CLOCKS_PER_CYCLE: u64 = 2;
    const NAME: &'static str = "minimum_deviation_arc";

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
