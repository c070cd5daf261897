//! Cutter radius compensation (刀具半径补偿): from a contour to the path of the tool's centre, a radius away.
//!
//! A [`Section`] is what the program has between switching the compensation on (G41, G42) and off (G40), in
//! one plane and in millimetres. It has three phases: on the approach the compensation is established,
//! along the contour it runs, and on the leave it is cancelled. [`c_type`] looks ahead to the next
//! block and makes corners sharp; [`b_type`] goes block by block and round the corners on arcs.
//!
//! Both foresee overcuts (过切预报). What a look at two neighbours shows is an arc smaller than the
//! tool, offsets that do not meet, or a block so short that its offset would run backward. Besides,
//! the whole path is held against the whole contour, so that a neck narrower than the tool is
//! found, too. Lengths that differ by 10⁻⁹ mm are equal; coming nearer than the radius by 10⁻⁸ mm
//! is no overcut, nor by as much as an arc's end is off its circle or as coordinates are rounded.
//!
//! ```
//! use onepulse_plan::compensation::{Block, Corners, Element, Section, Side, c_type};
//!
//! // Two sides of a square, the tool outside it, on the left.
//! let block = |line, from, to| Block { element: Element::Line { from, to }, line, is_machined: true };
//! let section = Section {
//!     approach: block(1, [0.0, -20.0], [0.0, 0.0]),
//!     contour: vec![block(2, [0.0, 0.0], [0.0, 30.0]), block(3, [0.0, 30.0], [30.0, 30.0])],
//!     leave: block(4, [30.0, 30.0], [50.0, 30.0]),
//! };
//! let path = c_type(&section, Side::Left, 5.0, Corners::Straight).map_err(|overcuts| overcuts[0])?;
//! let ends: Vec<_> = path.iter().map(|cut| cut.element.ends()[1]).collect();
//! assert_eq!(ends, [[-5.0, 0.0], [-5.0, 35.0], [30.0, 35.0], [50.0, 30.0]]);
//! # Ok::<(), onepulse_plan::compensation::Overcut>(())
//! ```

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
mod lead;
mod overcut;
mod path;
#[cfg(test)]
mod tests;
mod vector;

pub use b_type::b_type;
pub use c_type::c_type;
pub use element::{Block, Corners, Cut, Element, Role, Section, Side};
pub use overcut::{Overcut, OvercutKind};
