//! Closed contours with a block that leads in and one that leads out.

use super::{arc, line, section};
use crate::compensation::course::Course;
use crate::compensation::lead::protected;
use crate::compensation::{Corners, Element, Overcut, OvercutKind, Section, Side, c_type};
use onepulse_core::Direction::{Ccw, Cw};

/// Round a square of 40 mm from the middle of its lower side, clockwise: the tool is outside, on the left.
fn square() -> [Element; 5] {
    let corners = [[0.0, 0.0], [-20.0, 0.0], [-20.0, 40.0], [20.0, 40.0], [20.0, 0.0], [0.0, 0.0]];
    [0, 1, 2, 3, 4].map(|place| line(corners[place], corners[place + 1]))
}

fn between(before: &[Element], contour: &[Element], after: &[Element]) -> Section {
    section(&[before, contour, after].concat())
}

fn assert_passes(section: &Section, side: Side, radius: f64) {
    for corners in [Corners::Straight, Corners::Arcs] {
        let path = c_type(section, side, radius, corners);
        assert!(path.is_ok(), "{radius}: {path:?}");
    }
}

/// The pairs of lines at fault, each of which interferes.
fn interfering(section: &Section, side: Side, radius: f64) -> Vec<(u32, Option<u32>)> {
    let overcuts = c_type(section, side, radius, Corners::Straight).unwrap_err();
    let pair = |found: &Overcut| {
        assert!(matches!(found.kind, OvercutKind::Interference { .. }), "{found:?}");
        (found.line, found.other_line)
    };
    overcuts.iter().map(pair).collect()
}

#[test]
fn quarter_circles_lead_in_and_out() {
    // From below, tangent to the side along which the tool then goes to the left; and away likewise.
    let before = [line([8.0, -30.0], [8.0, -8.0]), arc([8.0, -8.0], [0.0, 0.0], [0.0, -8.0], Ccw)];
    let after =
        [arc([0.0, 0.0], [-8.0, -8.0], [0.0, -8.0], Ccw), line([-8.0, -8.0], [-8.0, -30.0])];
    for radius in [1.0, 5.0, 8.0] {
        assert_passes(&between(&before, &square(), &after), Side::Left, radius);
    }
    // In a few decimals the arc is not quite tangent.
    let near =
        [line([8.0, -30.0], [8.0, -7.99]), arc([8.0, -7.99], [0.0, 0.0], [0.01, -7.99], Ccw)];
    assert_passes(&between(&near, &square(), &after), Side::Left, 5.0);
    // A line, or an arc that bends away from the tool, may be an edge.
    let edge = [line([20.0, -30.0], [20.0, -8.0]), line([20.0, -8.0], [0.0, 0.0])];
    assert!(!interfering(&between(&edge, &square(), &after), Side::Left, 5.0).is_empty());
}

#[test]
fn a_circle_is_led_to_from_within() {
    // A bore of 10 mm, counter-clockwise with the tool on the left: arcs of 6 mm from the middle's side.
    let circle = [arc([10.0, 0.0], [10.0, 0.0], [0.0, 0.0], Ccw)];
    let before = [line([0.0, 0.0], [4.0, -6.0]), arc([4.0, -6.0], [10.0, 0.0], [4.0, 0.0], Ccw)];
    let after = [arc([10.0, 0.0], [4.0, 6.0], [4.0, 0.0], Ccw), line([4.0, 6.0], [0.0, 0.0])];
    for radius in [0.5, 3.0, 5.5] {
        assert_passes(&between(&before, &circle, &after), Side::Left, radius);
    }
}

#[test]
fn the_way_in_may_not_cut_the_closed_contour() {
    // Straight down onto the lower side, through the square.
    let before = [line([0.0, 60.0], [0.0, 50.0]), line([0.0, 50.0], [0.0, 0.0])];
    let after = [line([0.0, 0.0], [0.0, -30.0])];
    let found = interfering(&between(&before, &square(), &after), Side::Left, 3.0);
    // The way through the upper side, line 50, and through the lower one.
    assert!(found.contains(&(20, Some(50))), "{found:?}");
}

#[test]
fn edges_of_the_part_do_not_lead_in() {
    // A wall up to a bore of 10 mm from outside; the tool within the bore would cut through it.
    let circle = [arc([10.0, 0.0], [10.0, 0.0], [0.0, 0.0], Ccw)];
    let wall = [line([40.0, -9.0], [30.0, 0.0]), line([30.0, 0.0], [10.0, 0.0])];
    let away = [line([10.0, 0.0], [4.0, 0.0])];
    let section = between(&wall, &circle, &away);
    assert_eq!(interfering(&section, Side::Left, 2.0), [(20, Some(30))]);
    let protects = |side| protected(&Course::new(&section, side, 2.0).unwrap());
    assert_eq!(protects(Side::Left), 1..3);
    assert_eq!(protects(Side::Right), 1..3);
    // So may an arc on the other side than the tool: the upper half of the ring's wall.
    let rib =
        [line([30.0, -20.0], [20.0, -10.0]), arc([20.0, -10.0], [10.0, 0.0], [20.0, 0.0], Cw)];
    let section = between(&rib, &circle, &away);
    let protects = |side| protected(&Course::new(&section, side, 2.0).unwrap());
    assert_eq!(protects(Side::Left), 1..3);
    assert_eq!(protects(Side::Right), 2..3);
}

#[test]
fn an_arc_along_the_contour_does_not_lead_in() {
    // A quarter of a turn about nearly the same centre, outside and inside.
    for side in [Side::Left, Side::Right] {
        let quarter = arc([15.0, 5.0], [5.0, 5.0], [10.0, 10.0], Cw);
        let circle = arc([5.0, 5.0], [5.0, 5.0], [10.05, 10.0], Cw);
        let section = section(&[
            line([15.0, -30.0], [15.0, 5.0]),
            quarter,
            circle,
            line([5.0, 5.0], [5.0, -30.0]),
        ]);
        assert_eq!(protected(&Course::new(&section, side, 1.0).unwrap()), 1..3);
    }
}

#[test]
fn two_blocks_lead_in_and_no_more() {
    let arc = arc([8.0, -8.0], [0.0, 0.0], [0.0, -8.0], Ccw);
    let after = [line([0.0, 0.0], [-30.0, 0.0])];
    let two = [line([8.0, -30.0], [8.0, -20.0]), line([8.0, -20.0], [8.0, -8.0]), arc];
    assert_passes(&between(&two, &square(), &after), Side::Left, 5.0);
    let three = [
        line([8.0, -30.0], [8.0, -20.0]),
        line([8.0, -20.0], [8.0, -12.0]),
        line([8.0, -12.0], [8.0, -8.0]),
        arc,
    ];
    assert!(!interfering(&between(&three, &square(), &after), Side::Left, 5.0).is_empty());
}

#[test]
fn a_seam_in_three_decimals_is_none() {
    // Begun and ended in the middle of a side, which is not quite on the line between its ends.
    let seam = |y: f64| {
        let points = [[0.0, y], [-20.0, 0.0], [-20.0, 40.0], [20.0, 40.0], [20.0, 0.0], [0.0, y]];
        let contour = [0, 1, 2, 3, 4].map(|place| line(points[place], points[place + 1]));
        let ends = [line([0.0, -30.0], points[0]), line(points[0], [0.0, -30.0])];
        between(&ends[..1], &contour, &ends[1..])
    };
    for y in [-0.005, 0.0, 0.005] {
        assert_passes(&seam(y), Side::Left, 5.0);
    }
    // An inside corner of 0.01 mm is one.
    assert!(!interfering(&seam(0.1), Side::Left, 5.0).is_empty());
}
