//! What holds for all sections.

use super::{Point, arc, distance, line, other, reversed, sample, section, unchecked};
use crate::compensation::{Block, Corners, Cut, Element, Role, Section, Side, b_type, c_type};
use onepulse_core::Direction;
use proptest::prelude::*;

/// A block to come: the turn before it in degrees, its bend (0 a line, else the arc's sense and radius in
/// millimetres), its length.
type Step = (f64, f64, f64);

/// A section of steps from the origin, after an approach of 20 mm in a direction of its own.
fn steps(approach: f64, steps: &[Step], leave: f64) -> Section {
    let mut heading = approach.to_radians();
    let mut at = [heading.cos() * 20.0, heading.sin() * 20.0];
    let mut elements = vec![line([0.0, 0.0], at)];
    for &(turn, bend, length) in steps {
        heading += turn.to_radians();
        let [x, y] = [heading.cos(), heading.sin()];
        let element = if bend == 0.0 {
            line(at, [at[0] + length * x, at[1] + length * y])
        } else {
            let centre = [at[0] - bend * y, at[1] + bend * x];
            heading += length / bend;
            let to = [centre[0] + bend * heading.sin(), centre[1] - bend * heading.cos()];
            arc(at, to, centre, if bend > 0.0 { Direction::Ccw } else { Direction::Cw })
        };
        at = element.ends()[1];
        elements.push(element);
    }
    heading += leave.to_radians();
    elements.push(line(at, [at[0] + 20.0 * heading.cos(), at[1] + 20.0 * heading.sin()]));
    section(&elements)
}

fn turn() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -150.0..150.0,
        1 => (-4_i32..=4).prop_map(|eighths| 45.0 * f64::from(eighths)),
        1 => -1e-3..1e-3,
        1 => Just(0.0),
    ]
}

fn step() -> impl Strategy<Value = Step> {
    let bend = prop_oneof![Just(0.0), 20.0..60.0, -60.0..-20.0];
    (turn(), bend, 30.0..60.0)
}

fn any_section() -> impl Strategy<Value = Section> {
    (turn(), proptest::collection::vec(step(), 1..8), turn())
        .prop_map(|(approach, blocks, leave)| steps(approach, &blocks, leave))
}

fn any_side() -> impl Strategy<Value = Side> {
    prop_oneof![Just(Side::Left), Just(Side::Right)]
}

fn opposite(side: Side) -> Side {
    if side == Side::Left { Side::Right } else { Side::Left }
}

/// How far a point is from the whole line or circle of an element.
fn off(element: &Element, point: Point) -> f64 {
    match *element {
        Element::Line { from, to } => {
            let across =
                (to[0] - from[0]) * (point[1] - from[1]) - (to[1] - from[1]) * (point[0] - from[0]);
            (across / distance(from, to)).abs()
        }
        Element::Arc { from, centre, .. } => {
            (distance(centre, point) - distance(centre, from)).abs()
        }
    }
}

/// How far a point is from an element.
fn away(element: &Element, point: Point) -> f64 {
    let [from, to] = element.ends();
    let ends = distance(from, point).min(distance(to, point));
    let is_beside = match *element {
        Element::Line { from, to } => {
            let along = |p: Point| {
                (to[0] - from[0]) * (p[0] - from[0]) + (to[1] - from[1]) * (p[1] - from[1])
            };
            along(point) >= 0.0 && along(point) <= along(to)
        }
        Element::Arc { from, to, centre, direction } => {
            let angle = |[x, y]: Point| (y - centre[1]).atan2(x - centre[0]);
            let sense = if direction == Direction::Ccw { 1.0 } else { -1.0 };
            let from_start =
                |p: Point| (sense * (angle(p) - angle(from))).rem_euclid(std::f64::consts::TAU);
            from == to || from_start(point) <= from_start(to)
        }
    };
    if is_beside { ends.min(off(element, point)) } else { ends }
}

/// Whether the tool along the first of two blocks is free of the second up to one place and not
/// from there on, on the way back along the second is free of the first up to one place, and both
/// places are one.
fn is_clear_but_for_the_corner(first: &Element, second: &Element, side: Side, radius: f64) -> bool {
    let back = match *second {
        Element::Line { from, to } => line(to, from),
        Element::Arc { from, to, centre, direction } => arc(to, from, centre, other(direction)),
    };
    let stops =
        [(*first, side, second), (back, opposite(side), first)].map(|(element, side, other)| {
            let centres: Vec<Point> = sample(&element, 4000)
                .windows(2)
                .map(|pair| {
                    let step = distance(pair[0], pair[1]);
                    let by = if side == Side::Left { radius / step } else { -radius / step };
                    let [x, y] = [0, 1].map(|axis| (pair[1][axis] - pair[0][axis]) * by);
                    [pair[0][0] - y, pair[0][1] + x]
                })
                .collect();
            let is_free = |centre: &&Point| away(other, **centre) >= radius;
            let last = centres.iter().take_while(is_free).last();
            last.filter(|_| centres.iter().rev().skip_while(|c| !is_free(c)).all(|c| is_free(&c)))
                .copied()
        });
    matches!(stops, [Some(there), Some(back)] if distance(there, back) < 0.1)
}

fn block_of<'a>(section: &'a Section, cut: &Cut) -> &'a Block {
    &section.contour[cut.block - 1]
}

fn assert_same(found: &[Cut], expected: &[Element]) -> Result<(), TestCaseError> {
    prop_assert_eq!(found.len(), expected.len(), "{:#?} {:#?}", found, expected);
    for (cut, element) in found.iter().zip(expected) {
        for (a, b) in sample(&cut.element, 8).into_iter().zip(sample(element, 8)) {
            prop_assert!(distance(a, b) < 1e-8, "{:?} is not {:?}", cut.element, element);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(4000) })]

    #[test]
    fn the_path_hangs_together_the_radius_away(section in any_section(), side in any_side(), radius in 0.0..3.0) {
        let section = unchecked(section);
        for corners in [Corners::Straight, Corners::Arcs] {
            let Ok(path) = c_type(&section, side, radius, corners) else { continue };
            prop_assert_eq!(path[0].element.ends()[0], section.approach.element.ends()[0]);
            prop_assert_eq!(path[path.len() - 1].element.ends()[1], section.leave.element.ends()[1]);
            prop_assert!(path.windows(2).all(|pair| pair[0].element.ends()[1] == pair[1].element.ends()[0]));
            prop_assert!(path.windows(2).all(|pair| pair[0].block <= pair[1].block));
            for cut in path.iter().filter(|cut| cut.role == Role::Offset) {
                let block = &block_of(&section, cut).element;
                for point in sample(&cut.element, 20) {
                    prop_assert!((off(block, point) - radius).abs() < 1e-9, "{:?} along {:?}", cut, block);
                }
            }
        }
    }

    #[test]
    fn a_mirror_turns_left_into_right(section in any_section(), side in any_side(), radius in 0.0..3.0) {
        let mirrored = |element: &Element| match *element {
            Element::Line { from: [x, y], to: [u, v] } => line([x, -y], [u, -v]),
            Element::Arc { from: [x, y], to: [u, v], centre: [a, b], direction } => {
                arc([x, -y], [u, -v], [a, -b], other(direction))
            }
        };
        let block = |block: &Block| Block { element: mirrored(&block.element), ..*block };
        let glass = Section {
            approach: block(&section.approach),
            contour: section.contour.iter().map(block).collect(),
            leave: block(&section.leave),
        };
        for corners in [Corners::Straight, Corners::Arcs] {
            let path = c_type(&section, side, radius, corners);
            let seen = c_type(&glass, opposite(side), radius, corners);
            prop_assert_eq!(path.is_ok(), seen.is_ok());
            if let (Ok(path), Ok(seen)) = (path, seen) {
                let expected: Vec<Element> = path.iter().map(|cut| mirrored(&cut.element)).collect();
                assert_same(&seen, &expected)?;
            }
        }
    }

    #[test]
    fn the_way_back_is_the_same(section in any_section(), side in any_side(), radius in 0.0..3.0) {
        let back = reversed(&section);
        for corners in [Corners::Straight, Corners::Arcs] {
            let path = c_type(&section, side, radius, corners);
            let returning = c_type(&back, opposite(side), radius, corners);
            prop_assert_eq!(path.is_ok(), returning.is_ok(), "{:?} {:?}", path, returning);
            if let (Ok(path), Ok(returning)) = (path, returning) {
                let expected: Vec<Element> = path.iter().rev().map(|cut| match cut.element {
                    Element::Line { from, to } => line(to, from),
                    Element::Arc { from, to, centre, direction } => arc(to, from, centre, other(direction)),
                }).collect();
                assert_same(&returning, &expected)?;
            }
        }
    }

    /// Of two blocks with an inside corner, against samples: at the turn of the path the tool
    /// touches both, and before and after it comes no nearer to either. A wrong one of two
    /// intersections fails this.
    #[test]
    fn an_inside_corner_is_cleared_and_touched(
        first in step(),
        second in step(),
        turn in 0.01..150.0,
        side in any_side(),
        radius in 0.01..3.0,
    ) {
        let turn: f64 = if side == Side::Left { turn } else { -turn };
        let section = steps(0.0, &[(0.0, first.1, first.2), (turn, second.1, second.2)], 0.0);
        let path = c_type(&section, side, radius, Corners::Straight);
        let [a, b] = [0, 1].map(|place| section.contour[place].element);
        let Ok(path) = path else {
            prop_assert!(!is_clear_but_for_the_corner(&a, &b, side, radius), "{:?}", path);
            return Ok(());
        };
        prop_assert_eq!(path.len(), 4);
        let meeting = path[1].element.ends()[1];
        for block in [&a, &b] {
            prop_assert!((away(block, meeting) - radius).abs() < 1e-9);
            for point in path[1..3].iter().flat_map(|cut| sample(&cut.element, 200)) {
                prop_assert!(away(block, point) > radius - 1e-8, "{:?}", point);
            }
        }
    }

    /// Whatever passes keeps the radius from all of the contour, in the C type and the B type.
    #[test]
    fn what_passes_gouges_nothing(section in any_section(), side in any_side(), radius in 0.0..12.0) {
        for path in [
            c_type(&section, side, radius, Corners::Straight),
            c_type(&section, side, radius, Corners::Arcs),
            b_type(&section, side, radius),
        ] {
            let cuts = path.unwrap_or_default();
            for cut in cuts.iter().filter(|cut| matches!(cut.role, Role::Offset | Role::Corner)) {
                for point in sample(&cut.element, 30) {
                    for block in &section.contour {
                        prop_assert!(away(&block.element, point) > radius - 1e-7, "{:?} {:?}", cut, block);
                    }
                }
            }
        }
    }

    /// Smooth blocks, written with three decimals: their corners are inside or outside by chance,
    /// and an arc's end is off its circle.
    #[test]
    fn rounded_programs_pass(
        lengths in [5.0..40.0, 5.0..40.0, 5.0..40.0],
        bends in [10.0..100.0, 10.0..100.0],
        heading in 0.0..360.0,
        senses: [bool; 2],
        side in any_side(),
        radius in 0.1..8.0,
    ) {
        let bends: [f64; 2] = bends;
        let bent = |place: usize| if senses[place] { bends[place] } else { -bends[place] };
        let smooth = steps(heading, &[
            (0.0, 0.0, lengths[0]),
            (0.0, bent(0), lengths[1].min(bends[0])),
            (0.0, bent(1), lengths[2].min(bends[1])),
            (0.0, 0.0, 10.0),
        ], 0.0);
        let rounded = |c: f64| (c * 1000.0).round() / 1000.0;
        let round = |block: &Block| Block {
            element: match block.element {
                Element::Line { from, to } => line(from.map(rounded), to.map(rounded)),
                Element::Arc { from, to, centre, direction } => {
                    arc(from.map(rounded), to.map(rounded), centre.map(rounded), direction)
                }
            },
            ..*block
        };
        let program = Section {
            approach: round(&smooth.approach),
            contour: smooth.contour.iter().map(round).collect(),
            leave: round(&smooth.leave),
        };
        let path = c_type(&program, side, radius, Corners::Straight);
        prop_assert!(path.is_ok(), "{:?}", path);
    }
}

/// Numbers of all kinds, such that they often repeat.
fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => (-3_i32..=3).prop_map(f64::from),
        2 => -10.0..10.0,
        1 => prop_oneof![Just(1e7), Just(-1e7), Just(1e-12), Just(1e-308), Just(0.1 + 0.2), Just(0.3)],
        1 => prop::num::f64::ANY,
    ]
}

fn any_block() -> impl Strategy<Value = ([f64; 6], u8, bool)> {
    (std::array::from_fn::<_, 6, _>(|_| any_number()), 0..4_u8, any::<bool>())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(20_000) })]

    #[test]
    fn nothing_panics_and_nothing_is_no_number(
        blocks in proptest::collection::vec(any_block(), 2..7),
        radius in any_number(),
        side in any_side(),
    ) {
        let mut at = [0.0, 0.0];
        let last = blocks.len() - 1;
        let elements: Vec<Element> = blocks
            .iter()
            .enumerate()
            .map(|(place, &([x, y, a, b, ..], kind, is_left))| {
                let from = at;
                let direction = if is_left { Direction::Ccw } else { Direction::Cw };
                at = [x, y];
                if kind < 2 || place == 0 || place == last {
                    return line(from, at);
                }
                if kind == 3 {
                    at = from;
                }
                // Mostly a centre on the bisector of start and end, so that it is an arc.
                let centre = [
                    (from[0] + at[0]) / 2.0 - a.round() * (at[1] - from[1]) + if kind == 3 { b } else { 0.0 },
                    (from[1] + at[1]) / 2.0 + a.round() * (at[0] - from[0]),
                ];
                arc(from, at, centre, direction)
            })
            .collect();
        let section = section(&elements);
        for path in [
            c_type(&section, side, radius, Corners::Straight),
            c_type(&section, side, radius, Corners::Arcs),
            b_type(&section, side, radius),
            c_type(&unchecked(section.clone()), side, radius, Corners::Straight),
        ] {
            match path {
                Ok(path) => {
                    for cut in path {
                        prop_assert!(cut.element.ends().iter().flatten().all(|c| c.is_finite()), "{:?}", cut);
                    }
                }
                Err(overcuts) => {
                    prop_assert!(!overcuts.is_empty());
                    prop_assert!(overcuts.iter().all(|o| o.at.iter().all(|c| c.is_finite())), "{:?}", overcuts);
                }
            }
        }
    }
}
