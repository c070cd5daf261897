//! Comparison integration: one axis or both a step.

mod line;

pub use line::Line;
