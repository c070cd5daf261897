//! Digital integrators: integrand register, adder, remainder register; the carry is the pulse.

mod arc;
mod centred_arc;
mod line;

pub use arc::Arc;
pub use centred_arc::{Beat as CentredBeat, CentredArc};
pub use line::Line;
