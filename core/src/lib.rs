//! The classical pulse interpolation methods of numerical control as integer state machines.
//!
//! Everything is counted in *pulse equivalents*: the smallest motion of an axis. A machine is
//! built for one curve, and each call of `step` is one interpolation cycle of the method (one
//! four-beat step of point-by-point comparison, one accumulation of a digital integrator, one
//! source clock of the rate multiplier). It answers with the pulses that the cycle sends to the
//! axes, or `None` once the curve is done. Every machine is an [`Iterator`] too.
//!
//! | module | method | curves |
//! |---|---|---|
//! | [`ppc`] | point-by-point comparison (逐点比较法) | line, line of more axes, arc |
//! | [`dda`] | digital integration (数字积分法) | line of any number of axes, arc |
//! | [`brm`] | binary rate multiplier (数字脉冲乘法器), smoothed or not | line of any number of axes |
//! | [`minimum_deviation`] | minimum deviation (最小偏差法) | line of any number of axes, arc |
//! | [`vector`] | vector discrimination (矢量判别法) | line, arc |
//! | [`comparison`] | comparison integration (比较积分法) | line, arc |
//! | [`Helix`] | comparison in a plane, digital integration across it | helix |
//! | [`ramp`] | acceleration of an open loop: trapezoid, S-curve | one axis |
//! | [`parabola`] | point-by-point comparison, minimum deviation, digital integration | parabola |
//!
//! ```
//! use onepulse_core::{EndRule, Pulse, ppc};
//!
//! let mut line = ppc::Line::new([5, 3], EndRule::Total)?;
//! assert_eq!(line.step(), Some(Pulse([1, 0])));
//! assert_eq!(line.step(), Some(Pulse([0, 1])));
//! assert_eq!(line.count(), 6); // eight steps in all: 5 + 3
//! # Ok::<(), onepulse_core::Error>(())
//! ```
//!
//! There is no floating point here, no allocation, no file and no clock, and every coordinate
//! that fits an `i32` is served without overflow. What cannot work is refused with an [`Error`]
//! when the machine is built; a machine that exists always ends.
#![no_std]

pub mod brm;
pub mod circle;
pub mod comparison;
pub mod dda;
mod end_rule;
mod error;
mod helix;
pub mod minimum_deviation;
pub mod parabola;
pub mod ppc;
mod pulse;
mod quadrant;
pub mod ramp;
mod sweep;
pub mod vector;
mod walk;

pub use end_rule::EndRule;
pub use error::Error;
pub use helix::{Distributor, Helix, Plane, Screw};
pub use pulse::{Axis, Pulse};
pub use quadrant::{Direction, Feed, Feeds, Quadrant};
pub use sweep::Sweep;
pub use walk::Walk;
