//! Digital integration (数字积分法): a digital differential analyser (DDA).
//!
//! Each axis has an *integrand* register JV and a *remainder* register JR. Every clock adds the
//! one to the other, and the carry out of the adder is the axis' pulse: over 2ⁿ clocks of an
//! n-bit register an axis with integrand J gets J pulses, spread evenly.

mod arc;
mod centred_arc;
mod line;
mod preset;
mod register;

pub use arc::Arc;
pub use centred_arc::CentredArc;
pub use line::Line;
pub use preset::Preset;
pub use register::{Radix, Register};
