//! Global interference: whether the path comes nearer than the radius to any part of the contour.

use super::course::Course;
use super::curve::Curve;
use super::distance::{Shape, gap};
use super::faults::Faults;
use super::lead::{is_closed, protected};
use super::vector::{Vector, distance};
use super::{Cut, Element, Overcut, OvercutKind, Role};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree, RTreeObject, SelectionFunction};
use std::collections::HashMap;

/// How much nearer than the radius is let pass, in millimetres.
const TOLERANCE: f64 = 1e-8;

/// The same where a closed contour ends on its beginning, and on the way in and out: there blocks meet that do
/// not follow each other, and in three decimals they are not quite tangent.
const TOLERANCE_OF_SEAM: f64 = 1e-5;

/// How many pairs of lines are reported.
const MOST: usize = 20;

/// A curve of the contour in its upright rectangle.
type Boxed = GeomWithData<Rectangle<Vector>, usize>;

/// The path, if it keeps the radius from all that is machined and there are no faults.
///
/// Nothing is protected of what [leads in and out](super::lead). Establishing and cancelling are not looked
/// at, nor rapids, nor the path where an overcut found before
/// has spoilt it. A corner is looked at if one of its blocks is machined.
pub(super) fn check(
    course: &Course,
    cuts: Vec<Cut>,
    faults: Faults,
) -> Result<Vec<Cut>, Vec<Overcut>> {
    let Faults { mut overcuts, is_spoilt } = faults;
    overcuts.extend(interferences(course, &cuts, &is_spoilt));
    if overcuts.is_empty() { Ok(cuts) } else { Err(overcuts) }
}

fn interferences(course: &Course, cuts: &[Cut], is_spoilt: &[bool]) -> Vec<Overcut> {
    let protected = &course.curves[protected(course)];
    let [first, last] =
        [protected.first(), protected.last()].map(|end| end.map_or(0, |end| end.index));
    let is_closed = is_closed(protected);
    let machined: Vec<(&Curve, Shape)> = protected
        .iter()
        .filter(|curve| curve.block.is_machined)
        .map(|curve| (curve, Shape::of(&curve.block.element)))
        .collect();
    let boxed = machined.iter().enumerate().map(|(place, (_, shape))| {
        let [least, most] = shape.bounds();
        Boxed::new(Rectangle::from_corners(least, most), place)
    });
    let tree = RTree::bulk_load(boxed.collect());

    let mut found: Vec<Overcut> = vec![];
    let mut places = HashMap::new();
    let mut curves = course.curves.iter().zip(&course.curves[1..]).peekable();
    for cut in cuts {
        while curves.peek().is_some_and(|(curve, _)| curve.index < cut.block) {
            curves.next();
        }
        let Some((curve, next)) = curves.peek() else { break };
        let is_machined = match cut.role {
            Role::Establish | Role::Cancel => false,
            Role::Offset => curve.block.is_machined,
            Role::Corner => curve.block.is_machined || next.block.is_machined,
        };
        if !is_machined || is_spoilt[cut.block] {
            continue;
        }
        // Round the corner after the approach no contour is led to.
        let leads = cut.block > 0 && !(first..=last).contains(&cut.block);
        let shape = Shape::of(&cut.element);
        let [least, most] = shape.bounds();
        let near = Near { envelope: AABB::from_corners(least, most), reach: course.radius };
        for boxed in tree.locate_with_selection_function(near) {
            let (other, contour) = &machined[boxed.data];
            let (distance, at) = gap(&shape, contour);
            let ends = [cut.block.min(other.index), cut.block.max(other.index)];
            let is_seam =
                is_closed && cut.role == Role::Offset && first < last && ends == [first, last];
            let spare = if leads || is_seam { TOLERANCE_OF_SEAM } else { TOLERANCE };
            if distance >= course.radius - spare - rounding(&cut.element, &other.block.element) {
                continue;
            }
            let kind = OvercutKind::Interference { distance, radius: course.radius };
            let (line, other_line) = (curve.block.line, other.block.line);
            let overcut = Overcut { kind, line, other_line: Some(other_line), at };
            let pair = [line.min(other_line), line.max(other_line)];
            let place = *places.entry(pair).or_insert(found.len());
            if place == MOST {
                return found;
            }
            match found.get_mut(place) {
                Some(known) if depth(known) < depth(&overcut) => *known = overcut,
                Some(_) => {}
                None => found.push(overcut),
            }
        }
    }
    found
}

/// How far the tool cuts into the contour.
fn depth(overcut: &Overcut) -> f64 {
    match overcut.kind {
        OvercutKind::Interference { distance, radius } => radius - distance,
        _ => 0.0,
    }
}

/// How exactly the distance of two curves is known: an arc whose end is off its circle is known to
/// no more than that, and coordinates are rounded.
fn rounding(cut: &Element, contour: &Element) -> f64 {
    let slack = |element: &Element| match *element {
        Element::Line { .. } => 0.0,
        Element::Arc { from, to, centre, .. } => {
            (distance(centre, from) - distance(centre, to)).abs()
        }
    };
    let largest = |element: &Element| {
        let centre = match *element {
            Element::Line { .. } => [0.0; 2],
            Element::Arc { centre, .. } => centre,
        };
        let [from, to] = element.ends();
        [from, to, centre].iter().flatten().fold(0.0, |most: f64, c| most.max(c.abs()))
    };
    let size = largest(cut).max(largest(contour));
    slack(cut) + slack(contour) + 16.0 * f64::EPSILON * size
}

/// Picks what comes nearer to a rectangle than the reach.
struct Near {
    envelope: AABB<Vector>,
    reach: f64,
}

impl Near {
    fn reaches(&self, other: &AABB<Vector>) -> bool {
        let apart = [0, 1].map(|axis| {
            let below = other.lower()[axis] - self.envelope.upper()[axis];
            let above = self.envelope.lower()[axis] - other.upper()[axis];
            below.max(above).max(0.0)
        });
        apart[0].hypot(apart[1]) < self.reach
    }
}

impl SelectionFunction<Boxed> for Near {
    fn should_unpack_parent(&self, envelope: &AABB<Vector>) -> bool {
        self.reaches(envelope)
    }

    fn should_unpack_leaf(&self, leaf: &Boxed) -> bool {
        self.reaches(&leaf.envelope())
    }
}
