//! Comparison integration (比较积分法, also 脉冲间隔法, the pulse interval method).
//!
//! The two sides of the curve's differential equation are integrated by pulses: y_e dx = x_e dy for a
//! line, x dx = −y dy for a circle. Each pulse of an axis adds an interval to its side, and the axis
//! whose side is behind is fed: so pulses follow the source clock evenly, as in point-by-point
//! comparison, and both axes move together when the two sides are level, as in digital integration.
//!
//! The formulation here is the centred one: every pulse stands in the middle of its interval, so the
//! first is due after half of it. Sides that start level instead make the path that of point-by-point
//! comparison, but for the steps from points on the curve, which are two in one.

mod arc;
mod line;

pub use arc::{Arc, Interval};
pub use line::Line;
