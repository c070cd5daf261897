//! Minimum deviation (最小偏差法).
//!
//! Of the steps that come into question, straight and diagonal, the one is taken that leads nearest to
//! the curve: Bresenham's choice (for lines IBM Systems Journal 4, 1965; for circles Communications of
//! the ACM 20, 1977), whose path is half a pulse from the curve at most.

mod arc;
mod line;

pub use arc::{Arc, Nearest};
pub use line::Line;
