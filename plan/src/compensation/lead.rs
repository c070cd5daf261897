//! Leading in and out: what of a contour is on the way to a closed part of it, and from it.
//!
//! A closed contour is often begun on an arc that joins it smoothly, and left on another. Nothing of the part is
//! along them: the path over the closed part may cross them. They bend to where the tool is, and that tells
//! them from the edges of a part.

use super::course::Course;
use super::curve::{Curve, End, TOUCH};
use super::vector::{Vector, distance, dot, scaled};
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// How many blocks may lead in, and how many out: an arc, and one on the way to it.
const MOST: usize = 2;

/// What is taken for tangent, in radians: arcs are programmed in a few decimals.
const TANGENT: f64 = 0.02;

/// The places of the contour that are to be protected: all but what leads in and out.
pub(super) fn protected(course: &Course) -> Range<usize> {
    let all = course.contour();
    let ways = (0..=MOST).flat_map(|before| (0..=MOST).map(move |after| (before, after)));
    let parts = ways
        .filter(|(before, after)| before + after < all.len())
        .map(|(before, after)| all.start + before..all.end - after)
        .filter(|part| is_led_to(course, part));
    // The largest: nothing is left out without need.
    parts.max_by_key(Range::len).unwrap_or(all)
}

/// Whether a part of the contour is closed, and what is before and after it leads in and out.
fn is_led_to(course: &Course, part: &Range<usize>) -> bool {
    let all = course.contour();
    if !is_closed(&course.curves[part.clone()]) {
        return false;
    }
    let (first, last) = (&course.curves[part.start], &course.curves[part.end - 1]);
    let leads_in = part.start == all.start || {
        let before = &course.curves[part.start - 1];
        joins(before, &before.end, &first.start)
            && is_beside(scaled(-1.0, before.end.tangent), first, last)
    };
    leads_in
        && (part.end == all.end || {
            let after = &course.curves[part.end];
            joins(after, &after.start, &last.end) && is_beside(after.start.tangent, first, last)
        })
}

/// Whether a row of curves ends where it begins.
pub(super) fn is_closed(curves: &[Curve]) -> bool {
    match curves {
        [only] => distance(only.start.point, only.end.point) <= TOUCH,
        [first, .., last] => distance(first.start.point, last.end.point) <= TOUCH,
        [] => false,
    }
}

/// Whether a block is an arc of half a turn at most that is tangent to the contour where it joins it, and bends
/// towards the tool, more than the contour by a tenth.
fn joins(block: &Curve, lead: &End, contour: &End) -> bool {
    let angle = turn(contour, lead.tangent);
    !block.is_line()
        && (angle <= TANGENT || angle >= TAU - TANGENT)
        && lead.curvature > 1.1 * contour.curvature.max(0.0)
        && block.length * lead.curvature <= PI + TANGENT
}

/// Whether a direction from the point in which a closed contour begins and ends is on the tool's side of it.
fn is_beside(direction: Vector, first: &Curve, last: &Curve) -> bool {
    let widest = turn(&first.start, scaled(-1.0, last.end.tangent));
    let angle = turn(&first.start, direction);
    angle <= widest + TANGENT || angle >= TAU - TANGENT
}

/// The angle from the way ahead towards the tool to a direction, from 0 to a full turn.
fn turn(end: &End, direction: Vector) -> f64 {
    dot(direction, end.normal).atan2(dot(direction, end.tangent)).rem_euclid(TAU)
}
