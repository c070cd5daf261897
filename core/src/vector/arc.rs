//! Circular arc by vector discrimination.

use crate::circle::{self, Due, Judgement};

/// An arc about the origin, any sweep up to a full turn.
///
/// F = x² + y² − R² and the octant decide. The axis that the tangent is nearer to, the one whose own
/// coordinate is the smaller, gets a pulse on every step (on the diagonal the one that is fed towards
/// zero). Where that leads out of the circle, F ≥ 0 feeds the other axis as well; where it leads in,
/// F < 0 does. Always −2m ≤ F < 2m, m = max(|x|, |y|), so that the path is within one pulse of the
/// circle.
///
/// The path runs through every lattice point of its circle within the sweep. An end point off
/// the circle (a program rounded to pulses) is reached too: see [`Sweep`](crate::Sweep).
///
/// ```
/// use onepulse_core::{Direction, vector::Arc};
/// let arc = Arc::new([5, 0], [0, 5], Direction::Ccw)?;
/// assert_eq!(arc.count(), 7); // (4,1) (4,2) (4,3) (3,4) (2,4) (1,5) (0,5)
/// # Ok::<(), onepulse_core::Error>(())
/// ```
pub type Arc = circle::Arc<Octant>;

/// The octant and the sign of F decide; −2m ≤ F < 2m, m = max(|x|, |y|).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Octant;

impl Judgement for Octant {
    #[inline]
    fn due(f: i64, [towards, away]: [i64; 2]) -> Due {
        let is_inside = f < 0;
        match (towards > away, is_inside) {
            (true, true) => Due::Away,
            (false, false) => Due::Towards,
            (true, false) | (false, true) => Due::Both,
        }
    }

    fn is_within(f: i64, [towards, away]: [i64; 2]) -> bool {
        let largest = towards.max(away);
        -2 * largest <= f && f < 2 * largest
    }
}
