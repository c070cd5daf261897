//! Acceleration of an open loop: pulses of one axis whose intervals shrink and grow (升降速控制).
//!
//! A clock of constant frequency; every clock the axis moves by its speed, a fraction of a pulse in
//! units of 2⁻ⁿ pulses, and the carry out of the n-bit phase register is the pulse. Speed changes by no
//! more than the acceleration from one clock to the next, and how far it takes to stop is known at
//! any time: so the axis never has to stop faster than it may, and never travels too far. The
//! [`Trapezoid`] changes its acceleration at once; the [`SCurve`] averages a trapezoid's speeds over some
//! clocks, so that its acceleration rises and falls gradually.

mod limits;
mod phase;
mod s_curve;
mod speeds;
mod trapezoid;

pub use limits::Limits;
pub use s_curve::SCurve;
pub use trapezoid::Trapezoid;
