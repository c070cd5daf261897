//! Parabolas from their vertex, one step a clock.

mod ppc;

pub use ppc::Ppc;
