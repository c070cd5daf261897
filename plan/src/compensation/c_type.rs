//! The C type (C刀补): corners by straight lines, with a look at the next block.

use super::corner::Corner;
use super::course::Course;
use super::curve::TOUCH;
use super::faults::Faults;
use super::interference::check;
use super::intersection::{Meeting, meeting};
use super::path::{path, taken};
use super::{Corners, Cut, Overcut, OvercutKind, Section, Side};

/// The path of the tool's centre, the radius (0 to 10⁷ mm) away from the contour.
///
/// | α, on the side where the tool is not | straight corners |
/// |---|---|
/// | at least 180° | shorten: to where both offsets meet |
/// | 90° to 180° | extend: to where the tangents at the ends of both offsets meet |
/// | below 90° | insert: both offsets lengthened by the radius, and a link between their ends |
///
/// A section without a contour, or whose blocks all have no length, has nothing to be compensated:
/// the path is the approach and the leave as programmed.
///
/// # Errors
/// All places found at which the tool would cut into the contour, or what is no section at all.
pub fn c_type(
    section: &Section,
    side: Side,
    radius: f64,
    corners: Corners,
) -> Result<Vec<Cut>, Vec<Overcut>> {
    let course = Course::new(section, side, radius)?;
    let mut faults = course.small_arcs();
    let meetings = meetings(&course, &mut faults);
    for place in course.contour() {
        let (length, taken) = (course.curves[place].length, taken(&meetings, place));
        if taken > length + TOUCH {
            let at = course.curves[place].start.point;
            let kind = OvercutKind::ShortBlock { length, taken };
            faults.block(kind, &course.curves[place - 1..=place + 1], at);
        }
    }
    check(&course, path(&course, &meetings, corners), faults)
}

/// Where the offsets meet at each inside corner of the contour.
fn meetings(course: &Course, faults: &mut Faults) -> Vec<Option<Meeting>> {
    let radius = course.radius;
    let inner = course.contour();
    let corners = course.corners.iter().enumerate().map(|(place, corner)| {
        if !(inner.contains(&place) && inner.contains(&(place + 1))) {
            return None;
        }
        let pair = &course.curves[place..place + 2];
        // What is wrong with an arc of these has been said.
        let is_small = pair.iter().any(|curve| curve.arc_within(radius).is_some());
        match corner {
            Corner::Shorten if !is_small => {
                let meeting = meeting(&pair[0].end, &pair[1].start, radius);
                if meeting.is_none() {
                    faults.corner(OvercutKind::NoMeeting { radius }, pair);
                }
                meeting
            }
            _ => None,
        }
    });
    corners.collect()
}
