//! The path of the tool's centre, put together piece by piece.

use super::corner::Corner;
use super::course::Course;
use super::curve::{TOUCH, sweep};
use super::intersection::Meeting;
use super::vector::{Vector, distance};
use super::{Corners, Cut, Element, Role, Side};
use onepulse_core::Direction;
use std::f64::consts::TAU;

/// The path through the course. `meetings` says for each corner where the offsets of the contour
/// meet, if it is an inside one.
pub(super) fn path(course: &Course, meetings: &[Option<Meeting>], corners: Corners) -> Vec<Cut> {
    let [approach, leave] = [0, course.curves.len() - 1].map(|place| &course.curves[place]);
    let mut path = Path { at: approach.start.point, cuts: vec![] };
    if course.contour().is_empty() {
        path.line(approach.end.point, Role::Establish, approach.index);
    } else {
        let tip = match course.corners[0] {
            Corner::Shorten => &course.curves[1].start,
            Corner::Tangent | Corner::Extend | Corner::Insert => &approach.end,
        };
        path.line(tip.tip(course.radius), Role::Establish, approach.index);
        path.corner(course, 0, corners);
        for place in course.contour() {
            path.offset(course, place, meetings, corners);
            path.corner(course, place, corners);
        }
    }
    path.line(leave.end.point, Role::Cancel, leave.index);
    path.cuts
}

struct Path {
    at: Vector,
    cuts: Vec<Cut>,
}

impl Path {
    /// Along a curve of the contour. The offset of a line just becomes longer towards an outside corner.
    fn offset(
        &mut self,
        course: &Course,
        place: usize,
        meetings: &[Option<Meeting>],
        corners: Corners,
    ) {
        let curve = &course.curves[place];
        let Element::Arc { from, to, centre, direction } = curve.block.element else {
            let turn = turns(course, place, corners).first().copied();
            let meeting = meetings[place].map(|meeting| meeting.point);
            let tip = || curve.end.tip(course.radius);
            return self.line(meeting.or(turn).unwrap_or_else(tip), Role::Offset, curve.index);
        };
        let radius = curve.end.offset_radius(course.radius);
        let taken = taken(meetings, place);
        let turn = sweep(from, to, centre, direction) * (1.0 - taken / curve.length);
        if turn * radius <= TOUCH {
            return;
        }
        // The ends of a full circle are equal to the last bit: they say what its sweep is.
        let to = if (TAU - turn) * radius <= TOUCH {
            self.at
        } else {
            meetings[place].map_or_else(|| curve.end.tip(course.radius), |meeting| meeting.point)
        };
        let element = Element::Arc { from: self.at, to, centre, direction };
        self.push(element, Role::Offset, curve.index);
    }

    /// Round the corner after a curve, if it is an outside one. A line after it, if it is of the contour,
    /// starts where the path turns into it; all else starts at the tip.
    fn corner(&mut self, course: &Course, place: usize, corners: Corners) {
        let (curve, next) = (&course.curves[place], &course.curves[place + 1]);
        if !course.corners[place].is_outside() {
            return;
        }
        for turn in turns(course, place, corners) {
            self.line(turn, Role::Corner, curve.index);
        }
        let to = next.start.tip(course.radius);
        if corners == Corners::Arcs {
            let direction = if course.side == Side::Left { Direction::Cw } else { Direction::Ccw };
            let element = Element::Arc { from: self.at, to, centre: curve.end.point, direction };
            self.push(element, Role::Corner, curve.index);
        } else if !next.is_line() || !course.contour().contains(&(place + 1)) {
            self.line(to, Role::Corner, curve.index);
        }
    }

    /// A line, if there is any way to go.
    fn line(&mut self, to: Vector, role: Role, block: usize) {
        if distance(self.at, to) > TOUCH {
            self.push(Element::Line { from: self.at, to }, role, block);
        }
    }

    fn push(&mut self, element: Element, role: Role, block: usize) {
        self.cuts.push(Cut { element, role, block });
        self.at = element.ends()[1];
    }
}

/// Where the path turns round the corner after a curve.
fn turns(course: &Course, place: usize, corners: Corners) -> Vec<Vector> {
    let (curve, next) = (&course.curves[place], &course.curves[place + 1]);
    match corners {
        Corners::Straight => course.corners[place].turns(&curve.end, &next.start, course.radius),
        Corners::Arcs => vec![],
    }
}

/// How much of a curve of the contour the inside corners at both its ends leave untouched, in millimetres.
pub(super) fn taken(meetings: &[Option<Meeting>], place: usize) -> f64 {
    let after = meetings[place - 1].map_or(0.0, |meeting| meeting.after);
    after + meetings[place].map_or(0.0, |meeting| meeting.before)
}
