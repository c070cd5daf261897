//! Cutter radius compensation (刀具半径补偿): the path of the tool's centre, the radius away from the contour.

mod b_type;
mod c_type;
mod corner;
mod course;
mod curve;
mod distance;
mod element;
mod faults;
mod interference;
mod intersection;
mod overcut;
mod path;
#[cfg(test)]
mod tests;
mod vector;

pub use b_type::b_type;
pub use c_type::c_type;
pub use element::{Block, Corners, Cut, Element, Role, Section, Side};
pub use overcut::{Overcut, OvercutKind};
