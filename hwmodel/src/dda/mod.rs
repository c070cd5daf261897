//! Digital integrators: integrand register, adder, remainder register; the carry is the pulse.

mod arc;
mod centred_arc;
mod line;

pub use arc::Arc;
#[cfg(feature = "proofs")]
pub use centred_arc::Beat as CentredBeat;
pub use centred_arc::CentredArc;
pub use line::Line;
