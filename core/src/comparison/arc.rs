//! Circular arc by comparison integration.

use crate::walk::{Due, Walk};
use crate::{Direction, Error, Pulse, Sweep};

/// An arc about the origin, any sweep up to a full turn.
///
/// x dx = −y dy: a pulse of an axis takes an interval that is as long as its own coordinate, so that
/// the intervals are arithmetic series. From t to t − 1 it is t − ½, the mean; from a to a + 1 it is
/// a + ½. Each pulse stands in the middle of its interval. The sums of the past intervals of the two
/// sides differ by −F/2, F = x² + y² − R², and half of the present ones by (t − a − 1)/2: so F > t − a − 1
/// feeds the axis that is fed towards zero (its pulse is due first), F < t − a − 1 the one that is fed away
/// from it, and both together when they are level. Always |F| ≤ |x| + |y|, so that the path is
/// ½√2 pulse inside its circle at most, and ½√2 + 1/(4R) outside.
///
/// The path runs through every lattice point of its circle within the sweep. An end point off
/// the circle (a program rounded to pulses) is reached too: see [`Sweep`].
///
/// ```
/// use onepulse_core::{Direction, comparison::Arc};
/// let arc = Arc::new([5, 0], [0, 5], Direction::Ccw)?;
/// assert_eq!(arc.count(), 9); // (4,3) is level: both axes go on to (3,4) together
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arc {
    walk: Walk,
}

impl Arc {
    /// The arc from `start` to `end`; equal ends mean a full circle.
    ///
    /// # Errors
    /// As [`Sweep::new`].
    pub fn new(start: [i32; 2], end: [i32; 2], direction: Direction) -> Result<Self, Error> {
        Ok(Self { walk: Walk::new(Sweep::new(start, end, direction)?, start) })
    }

    /// The arc from `start` along a sweep that begins there: [`Arc::new`] without its roots.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn along_given(sweep: Sweep, start: [i32; 2]) -> Self {
        Self { walk: Walk::new(sweep, start) }
    }

    /// The arc at this place, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(walk: Walk) -> Self {
        Self { walk }
    }

    /// One step; `None` at the end point.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        if self.is_done() {
            return None;
        }
        let pulse = self.walk.step(judge);
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// The F at which the next pulses of both axes are due together: t − a − 1.
    #[must_use]
    pub const fn level(&self) -> i64 {
        level(self.walk.magnitudes())
    }

    /// The place on the circle.
    #[must_use]
    pub const fn walk(&self) -> &Walk {
        &self.walk
    }

    /// Whether the end point is reached.
    #[inline]
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.walk.is_at_end()
    }

    /// What always holds: while F decides, |F| ≤ |x| + |y|, and the coordinate that is fed towards
    /// zero has not come there yet; where a pulse takes it there from the other axis (R² ≤ 2), the
    /// circle lies outside.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let [towards, away] = self.walk.magnitudes();
        let f = self.walk.deviation_function();
        self.walk.invariant()
            && (!self.walk.is_free()
                || (-(towards + away) <= f && f <= towards + away)
                    && towards > 0
                    && (towards > 1 || away > 0 || f <= 0))
    }
}

/// The axis whose pulse is due first.
#[inline]
const fn judge(f: i64, [towards, away]: [i64; 2]) -> Due {
    let lead = f - level([towards, away]);
    if lead > 0 {
        Due::Towards
    } else if lead < 0 {
        Due::Away
    } else {
        Due::Both
    }
}

#[inline]
const fn level([towards, away]: [i64; 2]) -> i64 {
    towards - away - 1
}

impl Iterator for Arc {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
