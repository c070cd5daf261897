//! Circular arc by vector discrimination.

use crate::walk::{Due, Walk};
use crate::{Direction, Error, Pulse, Sweep};

/// An arc about the origin, any sweep up to a full turn.
///
/// F = x² + y² − R² and the octant decide. The axis that the tangent is nearer to, the one whose own
/// coordinate is the smaller, gets a pulse on every step (on the diagonal the one that is fed towards
/// zero). Where that leads out of the circle, F ≥ 0 feeds the other axis as well; where it leads in,
/// F < 0 does. Always −2m ≤ F < 2m, m = max(|x|, |y|), so that the path is within one pulse of the
/// circle.
///
/// The path runs through every lattice point of its circle within the sweep. An end point off
/// the circle (a program rounded to pulses) is reached too: see [`Sweep`].
///
/// ```
/// use onepulse_core::{Direction, vector::Arc};
/// let arc = Arc::new([5, 0], [0, 5], Direction::Ccw)?;
/// assert_eq!(arc.count(), 7); // (4,1) (4,2) (4,3) (3,4) (2,4) (1,5) (0,5)
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

    /// What always holds: while F decides, −2m ≤ F < 2m, m = max(|x|, |y|), and the coordinate that is
    /// fed towards zero has not come there yet.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let [towards, away] = self.walk.magnitudes();
        let largest = towards.max(away);
        let f = self.walk.deviation_function();
        self.walk.invariant()
            && (!self.walk.is_free() || (-2 * largest <= f && f < 2 * largest) && towards > 0)
    }
}

/// What the octant and the sign of F ask for.
#[inline]
const fn judge(f: i64, [towards, away]: [i64; 2]) -> Due {
    let is_inside = f < 0;
    match (towards > away, is_inside) {
        (true, true) => Due::Away,
        (false, false) => Due::Towards,
        (true, false) | (false, true) => Due::Both,
    }
}

impl Iterator for Arc {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
