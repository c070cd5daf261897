//! Circular arc by minimum deviation.

use crate::walk::{Due, Walk};
use crate::{Direction, Error, Pulse, Sweep};

/// An arc about the origin, any sweep up to a full turn.
///
/// F = x² + y² − R². In a quadrant three steps lead on: the one towards an axis, the one away from the
/// other axis, and both together. The one that leaves the smallest |F| is taken. (It is one alone:
/// the diagonal step's F differs from the others' by odd numbers, and where those two are alike, the
/// diagonal one is smaller. Textbooks name two candidates octant by octant; the third is the nearest
/// next to the diagonal at most.) Always |F| ≤ max(|x|, |y|), so that the path is ½ pulse inside its circle at
/// most, and ½ + 1/(8R) outside.
///
/// The path runs through every lattice point of its circle within the sweep. An end point off
/// the circle (a program rounded to pulses) is reached too: see [`Sweep`].
///
/// ```
/// use onepulse_core::{Direction, minimum_deviation::Arc};
/// let arc = Arc::new([5, 0], [0, 5], Direction::Ccw)?;
/// assert_eq!(arc.count(), 7); // (5,1) (5,2) (4,3) (3,4) (2,5) (1,5) (0,5)
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

    /// What always holds: while F decides, |F| ≤ max(|x|, |y|), and the coordinate that is fed towards
    /// zero has not come there yet; where a pulse takes it there from the other axis (R² ≤ 2), the
    /// circle lies outside.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let [towards, away] = self.walk.magnitudes();
        let largest = towards.max(away);
        let f = self.walk.deviation_function();
        self.walk.invariant()
            && (!self.walk.is_free()
                || (-largest <= f && f <= largest)
                    && towards > 0
                    && (towards > 1 || away > 0 || f <= 0))
    }
}

/// What the smallest deviation asks for.
#[inline]
const fn judge(f: i64, [towards, away]: [i64; 2]) -> Due {
    let (in_towards, in_away) = (f - 2 * towards + 1, f + 2 * away + 1);
    let (nearer, due) = if in_towards.abs() <= in_away.abs() {
        (in_towards.abs(), Due::Towards)
    } else {
        (in_away.abs(), Due::Away)
    };
    let in_both = in_towards + 2 * away + 1;
    if in_both.abs() <= nearer { Due::Both } else { due }
}

impl Iterator for Arc {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
