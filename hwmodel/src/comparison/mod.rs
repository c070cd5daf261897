//! Comparison integration: one axis or both a step, in one clock on lines and in two on arcs.

mod arc;
mod line;

pub use arc::Arc;
pub use line::Line;
