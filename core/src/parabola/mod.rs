//! Parabolas y² = 2px from their vertex, by three of the methods.
//!
//! With u the distance from the vertex along the axis of symmetry and v the distance across it,
//! both in absolute values, every orientation and both branches are one curve,
//!
//! ```text
//!    F = v² − 2|p|·u        F > 0   v |        . ·           along +x or −x, along +y or −y;
//!    u takes 2|p| from F              |    . ·    F < 0      a branch to either side
//!    v adds 2v + 1 to it              | ·
//!                                     +------------- u
//! ```
//!
//! and no machine needs a table: neither coordinate ever turns back.
//!
//! The end point need not be on the parabola, as in a program rounded to pulses. The rule is the
//! one of the arcs' last quadrant: an axis that has come to its end coordinate stands, the other
//! goes on, and the curve ends when both stand. So the end is always exact. On the way to an end
//! point *on* the parabola what is said of the deviation holds from vertex to end: where F decides, no
//! axis ever stands before its time (F has the right sign there), and where it does not, the way
//! from there leads straight to the parabola. To another end point it holds until an axis stands, and
//! from there on the way to the end point is straight.
//!
//! | machine | method | farthest from the parabola |
//! |---|---|---|
//! | [`Ppc`] | point-by-point comparison | 1 pulse |
//! | [`MinimumDeviation`] | straight and diagonal steps, the nearest of three | ½ pulse |
//! | [`Dda`] | digital integration | 1 pulse with half load and one headroom bit |

mod dda;
mod minimum_deviation;
mod ppc;
mod shape;
mod way;

pub use dda::Dda;
pub use minimum_deviation::MinimumDeviation;
pub use ppc::Ppc;
pub use shape::Shape;
