//! Point-by-point comparison (逐点比较法): judge, feed, update, compare.
//!
//! After every single pulse the sign of a deviation function F tells on which side of the curve
//! the tool is, and the next pulse goes to the axis that leads back. Four beats make one step:
//!
//! 1. **judge** (判别): is F ≥ 0?
//! 2. **feed** (进给): one pulse to one axis;
//! 3. **update** (运算): F for the new point, by one addition;
//! 4. **compare** (比较): count the pulse, stop at the end point.
//!
//! The path never leaves the curve by more than one pulse equivalent, and it ends on the end
//! point.

mod arc;
mod line;
mod space_line;

pub use arc::Arc;
pub use line::Line;
pub use space_line::SpaceLine;
