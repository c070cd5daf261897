//! Circular arc by minimum deviation.

use crate::circle::{self, Due, Judgement};

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
/// the circle (a program rounded to pulses) is reached too: see [`Sweep`](crate::Sweep).
///
/// ```
/// use onepulse_core::{Direction, minimum_deviation::Arc};
/// let arc = Arc::new([5, 0], [0, 5], Direction::Ccw)?;
/// assert_eq!(arc.count(), 7); // (5,1) (5,2) (4,3) (3,4) (2,5) (1,5) (0,5)
/// # Ok::<(), onepulse_core::Error>(())
/// ```
pub type Arc = circle::Arc<Nearest>;

/// The smallest |F| is due, which is max(|x|, |y|) at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Nearest;

impl Judgement for Nearest {
    #[inline]
    fn due(f: i64, [towards, away]: [i64; 2]) -> Due {
        let (in_towards, in_away) = (f - 2 * towards + 1, f + 2 * away + 1);
        let (nearer, due) = if in_towards.abs() <= in_away.abs() {
            (in_towards.abs(), Due::Towards)
        } else {
            (in_away.abs(), Due::Away)
        };
        let in_both = in_towards + 2 * away + 1;
        if in_both.abs() <= nearer { Due::Both } else { due }
    }

    fn is_within(f: i64, [towards, away]: [i64; 2]) -> bool {
        f.abs() <= towards.max(away)
    }
}
