//! Cutter radius compensation (刀具半径补偿): the path of the tool's centre, the radius away from the contour.

mod element;
mod overcut;

pub use element::{Block, Corners, Cut, Element, Role, Section, Side};
pub use overcut::{Overcut, OvercutKind};

/// The path of the C type (C刀补).
///
/// # Errors
/// All places where the tool would cut into the contour.
pub fn c_type(
    section: &Section,
    _side: Side,
    _radius: f64,
    _corners: Corners,
) -> Result<Vec<Cut>, Vec<Overcut>> {
    let at = [0.0; 2];
    Err(vec![Overcut {
        kind: OvercutKind::Slit,
        line: section.approach.line,
        other_line: None,
        at,
    }])
}

/// The path of the B type (B刀补).
///
/// # Errors
/// All places where the tool would cut into the contour, and all inside corners.
pub fn b_type(section: &Section, side: Side, radius: f64) -> Result<Vec<Cut>, Vec<Overcut>> {
    c_type(section, side, radius, Corners::Arcs)
}
