//! Every form of transition between lines and arcs of both senses, on both sides, in the run, when
//! establishing and when cancelling.

use super::{Point, arc, assert_path, distance, line, section};
use crate::compensation::{Corners, Element, OvercutKind, Role, Side, b_type, c_type};
use Role::{Cancel, Corner, Establish, Offset};
use onepulse_core::Direction::{Ccw, Cw};

const RADIUS: f64 = 4.0;
const ARC: f64 = 30.0;
/// Short enough that no two of the arcs meet again.
const LENGTH: f64 = 25.0;
/// Turns towards the tool, in degrees: shortened, extended twice, with a link inserted twice.
const TURNS: [f64; 5] = [60.0, -45.0, -89.9, -90.1, -120.0];
/// A line, an arc to the left, an arc to the right.
const BENDS: [f64; 3] = [0.0, 1.0, -1.0];
const CORNER: Point = [7.0, -3.0];

/// A straight or bent way through the corner, with the tool on one side.
#[derive(Clone, Copy)]
struct Way {
    heading: f64,
    /// 0, or 1 if it bends to the left, −1 to the right.
    bend: f64,
    /// 1 if the tool is on the left.
    side: f64,
}

impl Way {
    fn tangent(self) -> Point {
        [self.heading.cos(), self.heading.sin()]
    }

    /// So far along the way from the corner, and so far away from it towards the tool.
    fn at(self, way: f64, away: f64) -> Point {
        let [x, y] = self.tangent();
        let [left, ahead] = if self.bend == 0.0 {
            [self.side * away, way]
        } else {
            let radius = ARC - self.bend * self.side * away;
            let angle = way / ARC;
            [self.bend * (ARC - radius * angle.cos()), radius * angle.sin()]
        };
        [CORNER[0] + ahead * x - left * y, CORNER[1] + ahead * y + left * x]
    }

    /// How far a point is from the whole way, positive on the tool's side.
    fn away(self, point: Point) -> f64 {
        let [x, y] = self.tangent();
        if self.bend == 0.0 {
            self.side * (x * (point[1] - CORNER[1]) - y * (point[0] - CORNER[0]))
        } else {
            self.bend * self.side * (ARC - distance(point, self.centre()))
        }
    }

    fn centre(self) -> Point {
        let [x, y] = self.tangent();
        [CORNER[0] - self.bend * ARC * y, CORNER[1] + self.bend * ARC * x]
    }

    fn element(self, from: f64, to: f64) -> Element {
        let [from, to] = [from, to].map(|way| self.at(way, 0.0));
        if self.bend == 0.0 {
            line(from, to)
        } else {
            arc(from, to, self.centre(), if self.bend > 0.0 { Ccw } else { Cw })
        }
    }

    /// The tangent at the place this far along, to or from there.
    fn straight_on(self, from: f64, by: f64) -> Element {
        let start = self.at(from, 0.0);
        let turned = Way { heading: self.heading + self.bend * from / ARC, ..self };
        let [x, y] = turned.tangent();
        if by > 0.0 {
            line(start, [start[0] + by * x, start[1] + by * y])
        } else {
            line([start[0] + by * x, start[1] + by * y], start)
        }
    }
}

/// All pairs of ways that turn at the corner by this much towards the tool.
fn pairs(turn: f64) -> Vec<(Way, Way, Side)> {
    let mut pairs = vec![];
    for (side, sign) in [(Side::Left, 1.0), (Side::Right, -1.0)] {
        for first in BENDS {
            for second in BENDS {
                let before = Way { heading: 0.3, bend: first, side: sign };
                let heading = 0.3 + sign * turn.to_radians();
                pairs.push((before, Way { heading, bend: second, side: sign }, side));
            }
        }
    }
    pairs
}

/// The points at which the path turns at an outside corner, from the definitions: where the
/// tangents at the tips meet, or the tips carried on by the radius.
fn turns(before: Way, after: Way, turn: f64) -> Vec<Point> {
    let on = |way: Way, by: f64| {
        let ([x, y], tip) = (way.tangent(), way.at(0.0, RADIUS));
        [tip[0] + by * x, tip[1] + by * y]
    };
    if turn >= -90.0 {
        vec![on(before, RADIUS * (-turn / 2.0).to_radians().tan())]
    } else {
        vec![on(before, RADIUS), on(after, -RADIUS)]
    }
}

/// Where the tool, on its way along the first way's offset, comes to touch the second: by stepping
/// and halving.
fn touch(before: Way, after: Way) -> Point {
    let is_free = |way: f64| after.away(before.at(way, RADIUS)) >= RADIUS;
    // From the corner backward, where the tool is too near, to the first place where it is not.
    let mut free = (1..4000).map(|i| -0.01 * f64::from(i)).find(|way| is_free(*way)).unwrap();
    let mut touching = free + 0.01;
    for _ in 0..60 {
        let middle = (free + touching) / 2.0;
        *(if is_free(middle) { &mut free } else { &mut touching }) = middle;
    }
    before.at(free, RADIUS)
}

#[test]
fn in_the_run() {
    for turn in TURNS {
        for (before, after, side) in pairs(turn) {
            let section = section(&[
                before.straight_on(-LENGTH, -10.0),
                before.element(-LENGTH, 0.0),
                after.element(0.0, LENGTH),
                after.straight_on(LENGTH, 10.0),
            ]);
            let mut expected = vec![(Establish, 0, before.at(-LENGTH, RADIUS))];
            if turn > 0.0 {
                expected.push((Offset, 1, touch(before, after)));
            } else {
                let turns = turns(before, after, turn);
                if before.bend != 0.0 {
                    expected.push((Offset, 1, before.at(0.0, RADIUS)));
                }
                expected.extend(turns.iter().map(|turn| (Corner, 1, *turn)));
                if before.bend == 0.0 {
                    expected[1].0 = Offset;
                }
                if after.bend != 0.0 {
                    expected.push((Corner, 1, after.at(0.0, RADIUS)));
                }
            }
            expected.push((Offset, 2, after.at(LENGTH, RADIUS)));
            expected.push((Cancel, 3, section.leave.element.ends()[1]));
            let start = section.approach.element.ends()[0];
            assert_path(&c_type(&section, side, RADIUS, Corners::Straight), start, &expected);
        }
    }
}

#[test]
fn establishing() {
    for turn in TURNS {
        for (before, after, side) in pairs(turn).into_iter().filter(|pair| pair.0.bend == 0.0) {
            let section = section(&[
                before.element(-LENGTH, 0.0),
                after.element(0.0, LENGTH),
                after.straight_on(LENGTH, 10.0),
            ]);
            let mut expected = vec![];
            if turn > 0.0 {
                expected.push((Establish, 0, after.at(0.0, RADIUS)));
            } else {
                expected.push((Establish, 0, before.at(0.0, RADIUS)));
                expected.extend(turns(before, after, turn).iter().map(|turn| (Corner, 0, *turn)));
                if after.bend != 0.0 {
                    expected.push((Corner, 0, after.at(0.0, RADIUS)));
                }
            }
            expected.push((Offset, 1, after.at(LENGTH, RADIUS)));
            expected.push((Cancel, 2, section.leave.element.ends()[1]));
            let start = section.approach.element.ends()[0];
            assert_path(&c_type(&section, side, RADIUS, Corners::Straight), start, &expected);
        }
    }
}

#[test]
fn cancelling() {
    for turn in TURNS {
        for (before, after, side) in pairs(turn).into_iter().filter(|pair| pair.1.bend == 0.0) {
            let section = section(&[
                before.straight_on(-LENGTH, -10.0),
                before.element(-LENGTH, 0.0),
                after.element(0.0, LENGTH),
            ]);
            let mut expected = vec![(Establish, 0, before.at(-LENGTH, RADIUS))];
            if turn > 0.0 {
                expected.push((Offset, 1, before.at(0.0, RADIUS)));
            } else {
                if before.bend != 0.0 {
                    expected.push((Offset, 1, before.at(0.0, RADIUS)));
                }
                expected.extend(turns(before, after, turn).iter().map(|turn| (Corner, 1, *turn)));
                expected[1].0 = Offset;
                expected.push((Corner, 1, after.at(0.0, RADIUS)));
            }
            expected.push((Cancel, 2, after.at(LENGTH, 0.0)));
            let start = section.approach.element.ends()[0];
            assert_path(&c_type(&section, side, RADIUS, Corners::Straight), start, &expected);
        }
    }
}

#[test]
fn arcs_about_outside_corners_in_both_types() {
    for turn in TURNS {
        for (before, after, side) in pairs(turn) {
            let section = section(&[
                before.straight_on(-LENGTH, -10.0),
                before.element(-LENGTH, 0.0),
                after.element(0.0, LENGTH),
                after.straight_on(LENGTH, 10.0),
            ]);
            let b_type = b_type(&section, side, RADIUS);
            if turn > 0.0 {
                let overcuts = b_type.unwrap_err();
                assert_eq!(overcuts[0].kind, OvercutKind::InsideCorner { radius: RADIUS });
                assert_eq!((overcuts[0].line, overcuts[0].other_line), (20, Some(30)));
                assert_eq!(overcuts[0].at, CORNER);
                continue;
            }
            let expected = [
                (Establish, 0, before.at(-LENGTH, RADIUS)),
                (Offset, 1, before.at(0.0, RADIUS)),
                (Corner, 1, after.at(0.0, RADIUS)),
                (Offset, 2, after.at(LENGTH, RADIUS)),
                (Cancel, 3, section.leave.element.ends()[1]),
            ];
            let start = section.approach.element.ends()[0];
            let c_type = c_type(&section, side, RADIUS, Corners::Arcs);
            assert_path(&c_type, start, &expected);
            assert_eq!(c_type, b_type);
            // The way round is less than half a turn, so that its middle is beyond the corner.
            let round = b_type.unwrap()[2].element;
            assert!(
                matches!(round, Element::Arc { centre, .. } if distance(centre, CORNER) < 1e-12)
            );
            let middle = super::sample(&round, 2)[1];
            assert!(before.away(middle) > 0.0 && after.away(middle) > 0.0, "{round:?}");
            assert!((distance(middle, CORNER) - RADIUS).abs() < 1e-9);
        }
    }
}

#[test]
fn full_circles_inside_and_outside() {
    // Along the tangent x = 10, counter-clockwise about the origin.
    let start = [10.0, -20.0];
    let circle = section(&[
        line(start, [10.0, 0.0]),
        arc([10.0, 0.0], [10.0, 0.0], [0.0, 0.0], Ccw),
        line([10.0, 0.0], [10.0, 20.0]),
    ]);
    for (side, radius, x) in
        [(Side::Left, 3.0, 7.0), (Side::Right, 3.0, 13.0), (Side::Right, 25.0, 35.0)]
    {
        let expected = [(Establish, 0, [x, 0.0]), (Offset, 1, [x, 0.0]), (Cancel, 2, [10.0, 20.0])];
        for path in
            [c_type(&circle, side, radius, Corners::Straight), b_type(&circle, side, radius)]
        {
            assert_path(&path, start, &expected);
            let [from, to] = path.unwrap()[1].element.ends();
            assert_eq!(from, to, "a full circle");
        }
    }
    // The tool as large as the circle stands in its centre.
    let expected = [(Establish, 0, [0.0, 0.0]), (Cancel, 2, [10.0, 20.0])];
    assert_path(&c_type(&circle, Side::Left, 10.0, Corners::Straight), start, &expected);
}

#[test]
fn a_full_circle_stays_one_whatever_the_rounding() {
    for i in 0..1000 {
        let heading = 0.1 + f64::from(i);
        let ([x, y], start) = ([heading.cos(), heading.sin()], [0.1 * f64::from(i), 0.7]);
        let touch = [start[0] + 20.3 * x, start[1] + 20.3 * y];
        let centre = [touch[0] - 9.1 * y, touch[1] + 9.1 * x];
        let leave = [touch[0] + 20.3 * x, touch[1] + 20.3 * y];
        let circle = arc(touch, touch, centre, Ccw);
        let section = section(&[line(start, touch), circle, line(touch, leave)]);
        for side in [Side::Left, Side::Right] {
            let path = c_type(&section, side, 3.3, Corners::Straight).unwrap();
            let [from, to] = path[1].element.ends();
            assert_eq!(from, to);
        }
    }
}

#[test]
fn a_full_circle_cut_short_at_both_ends() {
    // Along a wall to a round pillar, clockwise round it, and back along the wall, which has no thickness.
    let circle = arc([-10.0, 0.0], [-10.0, 0.0], [0.0, 0.0], Cw);
    let start = [-40.0, 0.0];
    let walls = super::unchecked(section(&[
        line(start, [-30.0, 0.0]),
        line([-30.0, 0.0], [-10.0, 0.0]),
        circle,
        line([-10.0, 0.0], [-30.0, 0.0]),
        line([-30.0, 0.0], [-40.0, 0.0]),
    ]));
    // The pillar's offset has the radius 15 and meets y = ±5.
    let path = c_type(&walls, Side::Left, 5.0, Corners::Straight);
    let x = -f64::sqrt(15.0 * 15.0 - 5.0 * 5.0);
    let expected = [
        (Establish, 0, [-30.0, 5.0]),
        (Offset, 1, [x, 5.0]),
        (Offset, 2, [x, -5.0]),
        (Offset, 3, [-30.0, -5.0]),
        (Cancel, 4, [-40.0, 0.0]),
    ];
    assert_path(&path, start, &expected);
    // Round the far side.
    let middle = super::sample(&path.unwrap()[2].element, 2)[1];
    assert!(distance(middle, [15.0, 0.0]) < 1e-9);
}

#[test]
fn no_radius_leaves_the_program_as_it_is() {
    for turn in TURNS {
        for (before, after, side) in pairs(turn) {
            let elements = [
                before.straight_on(-LENGTH, -10.0),
                before.element(-LENGTH, 0.0),
                after.element(0.0, LENGTH),
                after.straight_on(LENGTH, 10.0),
            ];
            let paths = [
                c_type(&section(&elements), side, 0.0, Corners::Straight),
                b_type(&section(&elements), side, 0.0),
            ];
            for path in paths {
                let expected: Vec<_> = elements
                    .iter()
                    .zip([Establish, Offset, Offset, Cancel])
                    .enumerate()
                    .map(|(block, (element, role))| (role, block, element.ends()[1]))
                    .collect();
                assert_path(&path, elements[0].ends()[0], &expected);
            }
        }
    }
}

#[test]
fn round_the_tip_of_a_line_that_doubles_back() {
    let points = [[0.0, 0.0], [10.0, 0.0], [30.0, 0.0], [10.0, 0.0], [0.0, 0.0]];
    for (side, y) in [(Side::Left, 2.0), (Side::Right, -2.0)] {
        let expected = [
            (Establish, 0, [10.0, y]),
            (Offset, 1, [32.0, y]),
            (Corner, 1, [32.0, -y]),
            (Offset, 2, [10.0, -y]),
            (Cancel, 3, [0.0, 0.0]),
        ];
        let path = c_type(&super::lines(&points), side, 2.0, Corners::Straight);
        assert_path(&path, [0.0, 0.0], &expected);
    }
}

#[test]
fn arcs_that_turn_back_bend_apart_or_together() {
    // Up to (0, 0) and back down, on the right of the way up an arc that bends to the left, and the
    // other way round.
    let [left, right] = [[-20.0, 0.0], [20.0, 0.0]].map(|centre| {
        let end = [centre[0], -20.0];
        let is_left = centre[0] < 0.0;
        (end, centre, is_left)
    });
    for (side, ((first, c1, first_is_left), (second, c2, _)), is_cusp) in [
        // The tool on the right of the way up: between the curves if the second is on the right.
        (Side::Right, (left, right), true),
        (Side::Left, (left, right), false),
        (Side::Right, (right, left), false),
        (Side::Left, (right, left), true),
    ] {
        let sense = if first_is_left { Ccw } else { Cw };
        let (start, end) = ([first[0], -20.0], [second[0], -20.0]);
        let out = |point: Point| [point[0] * 2.0, -20.0];
        let section = section(&[
            line(out(start), start),
            arc(start, [0.0, 0.0], c1, sense),
            arc([0.0, 0.0], end, c2, sense),
            line(end, out(end)),
        ]);
        let path = c_type(&section, side, 2.0, Corners::Straight);
        if is_cusp {
            // As far from both circles of 20 as their radius and the tool's.
            let meeting = [0.0, -(22.0_f64.powi(2) - 20.0_f64.powi(2)).sqrt()];
            let [begin, last] = [start, end].map(|end| [end[0], -22.0]);
            let expected = [
                (Establish, 0, begin),
                (Offset, 1, meeting),
                (Offset, 2, last),
                (Cancel, 3, out(end)),
            ];
            assert_path(&path, out(start), &expected);
        } else {
            let [x, last] = [start, end].map(|end| [end[0], -18.0]);
            let sign = if first_is_left { 1.0 } else { -1.0 };
            let expected = [
                (Establish, 0, x),
                (Offset, 1, [-2.0 * sign, 0.0]),
                (Corner, 1, [-2.0 * sign, 2.0]),
                (Corner, 1, [2.0 * sign, 2.0]),
                (Corner, 1, [2.0 * sign, 0.0]),
                (Offset, 2, last),
                (Cancel, 3, out(end)),
            ];
            assert_path(&path, out(start), &expected);
        }
    }
}

#[test]
fn right_and_straight_angles_of_decimals_are_those() {
    // A square about which the tool goes, off any binary fraction: at each corner one turn, not two.
    let (a, b) = (0.1, 70.3);
    let points = [[a, -9.9], [a, a], [a, 35.7], [a, b], [b, b], [b, a], [a, a], [-9.7, a]];
    let path = c_type(&super::lines(&points), Side::Left, 4.7, Corners::Straight);
    let (low, high) = (a - 4.7, b + 4.7);
    let expected = [
        (Establish, 0, [low, a]),
        (Offset, 1, [low, 35.7]),
        (Offset, 2, [low, high]),
        (Offset, 3, [high, high]),
        (Offset, 4, [high, low]),
        (Offset, 5, [a, low]),
        (Cancel, 6, [-9.7, a]),
    ];
    assert_path(&path, [a, -9.9], &expected);
}

#[test]
fn without_a_contour_nothing_is_compensated() {
    let points = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]];
    let expected = [(Establish, 0, points[1]), (Cancel, 1, points[2])];
    for side in [Side::Left, Side::Right] {
        assert_path(
            &c_type(&super::lines(&points), side, 3.0, Corners::Straight),
            points[0],
            &expected,
        );
        assert_path(&b_type(&super::lines(&points), side, 3.0), points[0], &expected);
    }
}

#[test]
fn lines_of_no_length_are_passed_over() {
    let points = [
        [0.0, 0.0],
        [10.0, 0.0],
        [10.0, 0.0],
        [30.0, 0.0],
        [30.0, 0.0],
        [30.0, 20.0],
        [30.0, 30.0],
    ];
    let path = c_type(&super::lines(&points), Side::Left, 3.0, Corners::Straight);
    let expected = [
        (Establish, 0, [10.0, 3.0]),
        (Offset, 2, [27.0, 3.0]),
        (Offset, 4, [27.0, 20.0]),
        (Cancel, 5, [30.0, 30.0]),
    ];
    assert_path(&path, points[0], &expected);
}
