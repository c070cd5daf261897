//! The B type (B刀补): block by block, with arcs round the corners.

use super::corner::Corner;
use super::course::Course;
use super::interference::check;
use super::path::path;
use super::{Corners, Cut, Overcut, OvercutKind, Section, Side};

/// The path of the tool's centre, the radius (0 to 10⁷ mm) away from the contour, with an arc about
/// each outside corner.
///
/// Inside corners are unknown to it: the program must have an arc there of at least the tool's
/// radius. That goes for the corners with the approach and the leave, too: the path is established
/// at the tip of the approach's radius vector and cancelled from the tip of the leave's. As in the
/// C type, a section without a contour is left as it is.
///
/// # Errors
/// All inside corners and all places found at which the tool would cut into the contour, or what is
/// no section at all.
pub fn b_type(section: &Section, side: Side, radius: f64) -> Result<Vec<Cut>, Vec<Overcut>> {
    let course = Course::new(section, side, radius)?;
    let mut faults = course.small_arcs();
    if !course.contour().is_empty() {
        for (place, corner) in course.corners.iter().enumerate() {
            if *corner == Corner::Shorten {
                let pair = &course.curves[place..place + 2];
                faults.corner(OvercutKind::InsideCorner { radius }, pair);
            }
        }
    }
    let meetings = vec![None; course.corners.len()];
    check(&course, path(&course, &meetings, Corners::Arcs), faults)
}
