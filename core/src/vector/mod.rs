//! Vector discrimination (矢量判别法).
//!
//! The vector to the moving point is held against the curve's by the sign of a cross product, and that
//! sign decides between the two steps on both sides of the curve's own direction: straight along the
//! nearer axis, or diagonal. Point-by-point comparison judges in the same way, but here both axes may
//! move in one step, so that there are as many steps as the longer axis has pulses.
//!
//! Sources name the method and its principle, but not one recurrence that all agree on. This is the
//! plain form: the sign of the present deviation decides, without a look at the candidates (which
//! would be [minimum deviation](crate::minimum_deviation)).

mod arc;
mod line;

pub use arc::{Arc, Octant};
pub use line::Line;
