//! Whole sections. What is expected is computed from the definitions, by hand or by other means
//! than the code's.

mod corners;
mod gouging;
mod leading;
mod properties;
mod seed;

use super::{Block, Cut, Element, Overcut, Role, Section};
use onepulse_core::Direction;

type Point = [f64; 2];

fn line(from: Point, to: Point) -> Element {
    Element::Line { from, to }
}

fn arc(from: Point, to: Point, centre: Point, direction: Direction) -> Element {
    Element::Arc { from, to, centre, direction }
}

/// The elements in a row, the first the approach and the last the leave, all machined; line 10 and so on.
fn section(elements: &[Element]) -> Section {
    let blocks: Vec<Block> = elements
        .iter()
        .zip((10..).step_by(10))
        .map(|(&element, line)| Block { element, line, is_machined: true })
        .collect();
    let [approach, contour @ .., leave] = &blocks[..] else { panic!("a section has two ends") };
    Section { approach: *approach, contour: contour.to_vec(), leave: *leave }
}

/// A section of lines through these points.
fn lines(points: &[Point]) -> Section {
    let elements: Vec<Element> = points.windows(2).map(|ends| line(ends[0], ends[1])).collect();
    section(&elements)
}

/// The section made of rapids, so that nothing checks the path against the contour.
fn unchecked(mut section: Section) -> Section {
    for block in &mut section.contour {
        block.is_machined = false;
    }
    section.approach.is_machined = false;
    section.leave.is_machined = false;
    section
}

fn reversed(section: &Section) -> Section {
    let turned = |block: &Block| Block {
        element: match block.element {
            Element::Line { from, to } => line(to, from),
            Element::Arc { from, to, centre, direction } => arc(to, from, centre, other(direction)),
        },
        ..*block
    };
    Section {
        approach: turned(&section.leave),
        contour: section.contour.iter().rev().map(turned).collect(),
        leave: turned(&section.approach),
    }
}

fn other(direction: Direction) -> Direction {
    if direction == Direction::Cw { Direction::Ccw } else { Direction::Cw }
}

fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Each piece's role, block and end, after the start of the first.
fn assert_path(
    found: &Result<Vec<Cut>, Vec<Overcut>>,
    start: Point,
    expected: &[(Role, usize, Point)],
) {
    let found = found.as_ref().unwrap_or_else(|overcuts| panic!("refused: {overcuts:?}"));
    let mut at = start;
    for (place, cut) in found.iter().enumerate() {
        let [from, to] = cut.element.ends();
        assert_eq!(from, at, "piece {place} of {found:#?}");
        let (role, block, end) =
            expected.get(place).copied().unwrap_or_else(|| panic!("{found:#?}"));
        assert_eq!((cut.role, cut.block), (role, block), "piece {place} of {found:#?}");
        assert!(distance(to, end) < 1e-9, "piece {place} ends in {to:?}, not {end:?}: {found:#?}");
        at = to;
    }
    assert_eq!(found.len(), expected.len(), "{found:#?}");
}

/// Points along an element, both ends among them.
pub(super) fn sample(element: &Element, count: usize) -> Vec<Point> {
    let share = |i: usize| i as f64 / count as f64;
    match *element {
        Element::Line { from, to } => (0..=count)
            .map(|i| [0, 1].map(|axis| from[axis] + share(i) * (to[axis] - from[axis])))
            .collect(),
        Element::Arc { from, to, centre, direction } => {
            let [first, last] = [from, to].map(|[x, y]| (y - centre[1]).atan2(x - centre[0]));
            let turn = if direction == Direction::Ccw { 1.0 } else { -1.0 };
            let ahead = (turn * (last - first)).rem_euclid(std::f64::consts::TAU);
            let sweep = if from == to { std::f64::consts::TAU } else { ahead };
            let radius = distance(from, centre);
            (0..=count)
                .map(|i| first + turn * share(i) * sweep)
                .map(|angle| [centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin()])
                .collect()
        }
    }
}
