//! Point-by-point comparison as a machine of four beats, a clock each.

mod arc;
mod beat;
mod end;
mod line;

pub use arc::Arc;
pub use beat::Beat;
pub use line::Line;
