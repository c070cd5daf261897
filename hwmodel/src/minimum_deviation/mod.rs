//! Minimum deviation: straight and diagonal steps, in one clock on lines and in two on arcs.

mod arc;
mod line;

pub use arc::Arc;
pub use line::Line;
