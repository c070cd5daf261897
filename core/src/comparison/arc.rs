//! Circular arc by comparison integration.

use crate::circle::{self, Due, Judgement};
use core::cmp::Ordering;

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
/// the circle (a program rounded to pulses) is reached too: see [`Sweep`](crate::Sweep).
///
/// ```
/// use onepulse_core::{Direction, comparison::Arc};
/// let arc = Arc::new([5, 0], [0, 5], Direction::Ccw)?;
/// assert_eq!(arc.count(), 9); // (4,3) is level: both axes go on to (3,4) together
/// # Ok::<(), onepulse_core::Error>(())
/// ```
pub type Arc = circle::Arc<Interval>;

/// The axis is due of which the pulse is due first; |F| ≤ |x| + |y|.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interval;

impl Interval {
    /// The F at which the next pulses of both axes are due together, t − a − 1, from the magnitudes of
    /// the coordinate that is fed towards zero and of the one that is fed away from it.
    #[inline]
    #[must_use]
    pub const fn level([towards, away]: [i64; 2]) -> i64 {
        towards - away - 1
    }
}

impl Judgement for Interval {
    #[inline]
    fn due(f: i64, [towards, away]: [i64; 2]) -> Due {
        match f.cmp(&Self::level([towards, away])) {
            Ordering::Greater => Due::Towards,
            Ordering::Less => Due::Away,
            Ordering::Equal => Due::Both,
        }
    }

    fn is_within(f: i64, [towards, away]: [i64; 2]) -> bool {
        f.abs() <= towards + away
    }
}
