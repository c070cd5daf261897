//! Minimum deviation: straight and diagonal steps, a clock each for lines.

mod line;

pub use line::Line;
