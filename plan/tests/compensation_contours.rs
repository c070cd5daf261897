//! Cutter radius compensation along closed contours, against the offsets of an independent geometry library,
//! `cavalier_contours`. It removes from an offset what comes nearer than it should and joins what is left:
//! a contour can be machined as programmed exactly where it had to remove nothing.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod closed_contours;
mod curves;
mod random;
mod whole_offset;

use cavalier_contours::core::math::Vector2;
use cavalier_contours::polyline::{
    PlineSource, PlineSourceMut, PlineVertex, Polyline, seg_arc_radius_and_center,
};
use closed_contours::contours;
use curves::{SAME, clearance, points, polyline_of, vector};
use onepulse_core::Direction;
use onepulse_plan::compensation::{
    Block, Corners, Cut, Element, Overcut, OvercutKind, Role, Section, Side, b_type, c_type,
};
use proptest::prelude::*;
use random::{Counts, run};
use std::collections::BTreeSet;
use whole_offset::{Judgement, judge, tangents, tangents_before};

const CASES: u32 = 4000;
/// Roundings of coordinates of some 100 mm.
const ROUNDING: f64 = 1e-9;

/// A contour and a tool to the left of it for positive radii, to the right for negative ones.
#[derive(Clone, Debug)]
struct Case {
    contour: Polyline,
    offset: f64,
    /// Whether the tool comes and goes along the contour's first and last tangents, else at right angles.
    is_tangent: bool,
}

fn cases() -> impl Strategy<Value = Case> {
    (contours(), -0.5..1.5_f64, any::<bool>(), any::<bool>()).prop_map(
        |(contour, digits, is_left, is_tangent)| {
            let radius = 10_f64.powf(digits);
            Case { contour, offset: if is_left { radius } else { -radius }, is_tangent }
        },
    )
}

impl Case {
    fn radius(&self) -> f64 {
        self.offset.abs()
    }

    fn side(&self) -> Side {
        if self.offset > 0.0 { Side::Left } else { Side::Right }
    }

    /// The contour as a program has it, block k in line 10·k.
    fn section(&self) -> Section {
        let elements = elements(&self.contour);
        let start = self.contour.at(0).pos();
        let (first, last) = (tangents(&self.contour, 0)[0], tangents_before(&self.contour, 0)[1]);
        let reach = self.radius() + 20.0;
        // From the side of the tool, or from behind.
        let away = |tangent: Vector2, sign: f64| {
            let way = if self.is_tangent {
                tangent
            } else {
                tangent.perp().scale(self.offset.signum() * sign)
            };
            start + way.scale(reach * sign)
        };
        let (from, to) = (away(first, -1.0), away(last, 1.0));
        let block = |element, line| Block { element, line, is_machined: true };
        let count = elements.len() as u32;
        Section {
            approach: block(Element::Line { from: array(from), to: array(start) }, 0),
            contour: elements
                .into_iter()
                .zip(1..)
                .map(|(element, k)| block(element, 10 * k))
                .collect(),
            leave: block(Element::Line { from: array(start), to: array(to) }, 10 * (count + 1)),
        }
    }
}

fn array(point: Vector2) -> [f64; 2] {
    [point.x, point.y]
}

/// The segments as elements of a program: what belongs to one circle is one arc, also over 180°.
fn elements(contour: &Polyline) -> Vec<Element> {
    let mut elements: Vec<Element> = Vec::new();
    for (start, end) in contour.iter_segments() {
        let (from, to) = (array(start.pos()), array(end.pos()));
        if start.bulge == 0.0 {
            elements.push(Element::Line { from, to });
            continue;
        }
        let direction = if start.bulge > 0.0 { Direction::Ccw } else { Direction::Cw };
        let centre = seg_arc_radius_and_center(start, end).1;
        if let Some(Element::Arc { to: end, centre: before, direction: same, .. }) =
            elements.last_mut()
        {
            if *same == direction && (vector(*before) - centre).length() < ROUNDING {
                *end = to;
                continue;
            }
        }
        elements.push(Element::Arc { from, to, centre: array(centre), direction });
    }
    elements
}

/// How far the tips of the radius vectors before and after a corner lie apart: positive at an inside corner,
/// negative at an outside one.
fn step(case: &Case, corner: usize) -> f64 {
    let [before, after] =
        [tangents_before(&case.contour, corner)[1], tangents(&case.contour, corner)[0]];
    before.perp_dot(after) * case.offset
}

/// Whether all corners are tangent but for rounding, or clearly not.
fn is_clear(case: &Case) -> bool {
    (0..case.contour.vertex_count()).all(|k| !(1e-10..1e-6).contains(&step(case, k).abs()))
}

fn judged(case: &Case) -> Judgement {
    if is_clear(case) { judge(&case.contour, case.offset) } else { Judgement::Undecided }
}

/// The offset and corner cuts, which close.
fn path_of(cuts: &[Cut]) -> Polyline {
    let cuts = cuts.iter().filter(|cut| matches!(cut.role, Role::Offset | Role::Corner));
    let mut path = polyline_of(cuts.map(|cut| &cut.element));
    let (first, last) = (path.at(0), path.last().unwrap());
    assert!((first.pos() - last.pos()).length() < ROUNDING, "{path:?} is open");
    path.remove_last();
    path.set_is_closed(true);
    path
}

fn kind(overcut: &Overcut) -> &'static str {
    match overcut.kind {
        OvercutKind::SmallArc { .. } => "small arc",
        OvercutKind::ShortBlock { .. } => "short block",
        OvercutKind::NoMeeting { .. } => "no meeting",
        OvercutKind::Interference { .. } => "interference",
        _ => "of another kind",
    }
}

fn ends(element: &Element) -> [Vector2; 2] {
    let (Element::Line { from, to } | Element::Arc { from, to, .. }) = *element;
    [vector(from), vector(to)]
}

/// The path hangs together, and the offset of each block is at the radius from it.
fn check_cuts(case: &Case, section: &Section, cuts: &[Cut]) -> Result<(), TestCaseError> {
    let mut at = ends(&section.approach.element)[0];
    for cut in cuts {
        let [from, to] = ends(&cut.element);
        prop_assert!((from - at).length() < ROUNDING, "{cut:?} does not begin at {at:?}");
        at = to;
        if cut.role != Role::Offset {
            continue;
        }
        let programmed = polyline_of([&section.contour[cut.block - 1].element]);
        let offset = polyline_of([&cut.element]);
        for (start, end) in offset.iter_segments() {
            for point in points(start, end, &programmed) {
                let distance = programmed.closest_point(point, SAME).unwrap().distance;
                prop_assert!((distance - case.radius()).abs() < ROUNDING, "{cut:?}: {distance}");
            }
        }
    }
    let end = ends(&section.leave.element)[1];
    prop_assert!((end - at).length() < ROUNDING, "{at:?} is not the end");
    Ok(())
}

fn are_close(one: f64, other: f64) -> bool {
    (one - other).abs() < 1e-6 * (1.0 + other.abs())
}

#[test]
fn a_contour_is_machined_exactly_where_its_offset_is_whole() {
    let counts = Counts::default();
    run(CASES, &cases(), |case| {
        let section = case.section();
        let found = c_type(&section, case.side(), case.radius(), Corners::Arcs);
        match (judged(&case), found) {
            (Judgement::Undecided, _) => counts.add("undecided", 1),
            (Judgement::Whole(whole), Ok(cuts)) => {
                counts.add("accepted", 1);
                check_cuts(&case, &section, &cuts)?;
                let path = path_of(&cuts);
                let (least, at) = clearance(&path, &case.contour);
                prop_assert!(least > case.radius() - 1e-7, "{least} at {at:?}");
                prop_assert!(are_close(path.path_length(), whole.path_length()));
                prop_assert!(are_close(path.area(), whole.area()));
            }
            (Judgement::Lacking, Err(overcuts)) => {
                let kinds: BTreeSet<_> = overcuts.iter().map(kind).collect();
                prop_assert!(!kinds.is_empty());
                counts.add("refused", 1);
                kinds.into_iter().for_each(|kind| counts.add(kind, 1));
                match case.contour.parallel_offset(case.offset).len() {
                    0 => counts.add("no loop", 1),
                    1 => (),
                    _ => counts.add("several loops", 1),
                }
            }
            (Judgement::Whole(whole), Err(overcuts)) => {
                return Err(TestCaseError::fail(format!("{overcuts:?} although {whole:?}")));
            }
            (Judgement::Lacking, Ok(cuts)) => {
                let (least, at) = clearance(&path_of(&cuts), &case.contour);
                return Err(TestCaseError::fail(format!("{least} at {at:?}: {cuts:?}")));
            }
        }
        Ok(())
    });
    counts.check(&[
        ("accepted", CASES / 2),
        ("refused", CASES / 10),
        ("small arc", CASES / 20),
        ("short block", CASES / 20),
        ("no meeting", CASES / 200),
        ("interference", CASES / 20),
        ("no loop", CASES / 50),
        ("several loops", CASES / 400),
    ]);
}

/// The offset with the C type's corners in place of its arcs: the tangents meet up to a turn of 90°, beyond
/// that they are the radius long and their ends are joined.
fn with_straight_corners(case: &Case, whole: &Polyline) -> Polyline {
    let (contour, radius) = (&case.contour, case.radius());
    let corner_of = |start: PlineVertex, end: PlineVertex| {
        let (about, centre) = seg_arc_radius_and_center(start, end);
        let is_there = |k: &usize| (contour.at(*k).pos() - centre).length() < 1e-6;
        (0..contour.vertex_count()).find(is_there).filter(|_| (about - radius).abs() < 1e-6)
    };
    let mut path = Polyline::new_closed();
    for (start, end) in whole.iter_segments() {
        let corner = if start.bulge == 0.0 { None } else { corner_of(start, end) };
        let Some(corner) = corner else {
            path.add_vertex(start);
            continue;
        };
        let at = contour.at(corner).pos();
        let (before, after) = (tangents_before(contour, corner)[1], tangents(contour, corner)[0]);
        let tip = |tangent: Vector2| at + tangent.perp().scale(case.offset);
        path.add(start.x, start.y, 0.0);
        if before.dot(after) >= 0.0 {
            let half = (before.dot(after) + 1.0) / 2.0;
            let middle = (tip(before) + tip(after)).scale(0.5) - at;
            let met = at + middle.scale(1.0 / half);
            path.add(met.x, met.y, 0.0);
        } else {
            let ends = [tip(before) + before.scale(radius), tip(after) - after.scale(radius)];
            for end in ends {
                path.add(end.x, end.y, 0.0);
            }
        }
    }
    path
}

#[test]
fn straight_corners_are_machined_exactly_where_they_keep_clear_of_the_contour() {
    let counts = Counts::default();
    run(CASES, &cases(), |case| {
        let found = c_type(&case.section(), case.side(), case.radius(), Corners::Straight);
        let ours = found.as_ref().map(|cuts| path_of(cuts));
        if let Ok(path) = &ours {
            let (least, at) = clearance(path, &case.contour);
            prop_assert!(least > case.radius() - 1e-7, "{least} at {at:?}");
        }
        let whole = match judged(&case) {
            Judgement::Undecided => {
                counts.add("undecided", 1);
                return Ok(());
            }
            Judgement::Lacking => {
                counts.add(if ours.is_ok() { "clear without arcs" } else { "refused as well" }, 1);
                return Ok(());
            }
            Judgement::Whole(whole) => whole,
        };
        let path = with_straight_corners(&case, &whole);
        let (least, at) = clearance(&path, &case.contour);
        match ours {
            _ if (1e-7..1e-5).contains(&(case.radius() - least)) => counts.add("undecided", 1),
            Ok(ours) => {
                counts.add("accepted", 1);
                prop_assert!(least > case.radius() - 1e-7, "{least} at {at:?}");
                prop_assert!(are_close(ours.path_length(), path.path_length()));
                prop_assert!(are_close(ours.area(), path.area()));
            }
            Err(overcuts) => {
                counts.add("refused for its corners", 1);
                prop_assert!(least < case.radius() - 1e-7, "{overcuts:?}, {least} at {at:?}");
            }
        }
        Ok(())
    });
    counts.check(&[("accepted", CASES / 2), ("refused as well", CASES / 10)]);
}

/// The lines after which the tool comes into an inside corner.
fn inside_corners(case: &Case, section: &Section) -> Vec<u32> {
    let contour = &case.contour;
    let starts = |k: &usize| step(case, *k) > 1e-9;
    let corners = (1..contour.vertex_count()).filter(starts).map(|k| array(contour.at(k).pos()));
    corners.map(|at| line_to(section, at)).collect()
}

/// The line of the block that ends at a point.
fn line_to(section: &Section, at: [f64; 2]) -> u32 {
    let ends = |block: &&Block| match block.element {
        Element::Line { to, .. } | Element::Arc { to, .. } => to == at,
    };
    section.contour.iter().find(ends).unwrap().line
}

#[test]
fn the_b_type_knows_no_inside_corner_and_is_else_the_c_type_with_arcs() {
    let counts = Counts::default();
    let tangent = cases().prop_map(|case| Case { is_tangent: true, ..case });
    run(CASES, &tangent, |case| {
        let section = case.section();
        let found = b_type(&section, case.side(), case.radius());
        if !is_clear(&case) {
            counts.add("undecided", 1);
            return Ok(());
        }
        let inside = inside_corners(&case, &section);
        if inside.is_empty() {
            let c_type = c_type(&section, case.side(), case.radius(), Corners::Arcs);
            counts.add(if found.is_ok() { "accepted" } else { "refused" }, 1);
            prop_assert_eq!(found, c_type);
            return Ok(());
        }
        counts.add("inside corners", 1);
        let overcuts = found.unwrap_err();
        let is_inside =
            |overcut: &&Overcut| matches!(overcut.kind, OvercutKind::InsideCorner { .. });
        let lines: Vec<_> = overcuts.iter().filter(is_inside).map(|overcut| overcut.line).collect();
        prop_assert_eq!(lines, inside);
        Ok(())
    });
    let least = CASES / 50;
    counts.check(&[("accepted", least), ("refused", least), ("inside corners", least)]);
}
