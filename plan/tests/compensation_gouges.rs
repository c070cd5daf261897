//! Contours that a tool of radius 1 cannot machine, each with the room that it lacks as a number: refused
//! with less than that room and accepted with more, wherever and however the contour lies.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use onepulse_core::Direction;
use onepulse_plan::compensation::{
    Block, Corners, Cut, Element, Overcut, OvercutKind, Section, Side, c_type,
};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// Where a contour lies: turned, then moved, mirrored or not, larger by the tool's radius.
#[derive(Clone, Copy, Debug)]
struct Place {
    angle: f64,
    moved: [f64; 2],
    is_mirrored: bool,
    radius: f64,
}

fn places() -> impl Strategy<Value = Place> {
    (0.0..TAU, [-100.0..100.0_f64, -100.0..100.0_f64], any::<bool>(), 0.1..20.0_f64)
        .prop_map(|(angle, moved, is_mirrored, radius)| Place { angle, moved, is_mirrored, radius })
}

impl Place {
    fn point(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.angle.sin_cos();
        let y = if self.is_mirrored { -y } else { y };
        let [x, y] = [self.radius * x, self.radius * y];
        [self.moved[0] + x * cos - y * sin, self.moved[1] + x * sin + y * cos]
    }
}

/// How the contour goes on.
#[derive(Clone, Copy, Debug)]
enum Step {
    Line {
        to: [f64; 2],
    },
    /// Counter-clockwise.
    Arc {
        to: [f64; 2],
        centre: [f64; 2],
    },
}

/// What the tool, on the left of the contour, makes of it. It comes along the tangent of the first step, which
/// is a line, and leaves along that of the last, which is one as well.
fn machined(
    start: [f64; 2],
    steps: &[Step],
    place: Place,
    corners: Corners,
) -> Result<Vec<Cut>, Vec<Overcut>> {
    let mut at = start;
    let mut points = vec![start];
    let mut contour = Vec::new();
    for (step, k) in steps.iter().zip(1..) {
        let from = place.point(at);
        let (Step::Line { to } | Step::Arc { to, .. }) = *step;
        let element = match *step {
            Step::Line { to } => Element::Line { from, to: place.point(to) },
            Step::Arc { to, centre } => Element::Arc {
                from,
                to: place.point(to),
                centre: place.point(centre),
                direction: if place.is_mirrored { Direction::Cw } else { Direction::Ccw },
            },
        };
        contour.push(Block { element, line: k, is_machined: true });
        points.push(to);
        at = to;
    }
    let beyond = |from: [f64; 2], to: [f64; 2]| [0, 1].map(|axis| 2.0 * to[axis] - from[axis]);
    let line = |from, to, line| Block {
        element: Element::Line { from: place.point(from), to: place.point(to) },
        line,
        is_machined: true,
    };
    let (count, first) = (points.len(), beyond(points[1], points[0]));
    let last = beyond(points[count - 2], points[count - 1]);
    let section =
        Section { approach: line(first, start, 0), contour, leave: line(at, last, count as u32) };
    let side = if place.is_mirrored { Side::Right } else { Side::Left };
    c_type(&section, side, place.radius, corners)
}

/// Both kinds of corners: accepted or refused alike.
fn check(
    is_wide: bool,
    start: [f64; 2],
    steps: &[Step],
    place: Place,
    is_at_fault: impl Fn(&OvercutKind) -> bool,
) -> Result<(), TestCaseError> {
    for corners in [Corners::Straight, Corners::Arcs] {
        match machined(start, steps, place, corners) {
            Ok(cuts) => prop_assert!(is_wide, "{corners:?}: {cuts:?}"),
            Err(overcuts) => {
                prop_assert!(!is_wide, "{corners:?}: {overcuts:?}");
                let is_named = overcuts.iter().any(|overcut| is_at_fault(&overcut.kind));
                prop_assert!(is_named, "{corners:?}: {overcuts:?}");
            }
        }
    }
    Ok(())
}

/// A share of the room needed: a hair or much more or less than all of it.
fn rooms() -> impl Strategy<Value = f64> {
    (-5.5..-0.05_f64, any::<bool>()).prop_map(|(digits, is_wide)| {
        let share = 10_f64.powf(digits);
        if is_wide { 1.0 + share } else { 1.0 - share }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(500) })]

    /// A quarter circle between tangent lines.
    #[test]
    fn the_tool_runs_in_no_arc_smaller_than_itself(room in rooms(), place in places()) {
        let steps = [
            Step::Line { to: [0.0, 0.0] },
            Step::Arc { to: [room, room], centre: [0.0, room] },
            Step::Line { to: [room, room + 5.0] },
        ];
        let is_small = |kind: &OvercutKind| matches!(kind, OvercutKind::SmallArc { .. });
        check(room > 1.0, [-5.0, 0.0], &steps, place, is_small)?;
    }

    /// A line between inside corners, of which the tool takes tan(θ/2) at each end: beyond that the block
    /// vanishes, and then reverses.
    #[test]
    fn no_block_is_shorter_than_its_corners_take(
        room in rooms(),
        turns in [5.0..85.0_f64, 5.0..85.0_f64],
        place in places(),
    ) {
        let [first, second] = turns.map(f64::to_radians);
        let length = room * ((first / 2.0).tan() + (second / 2.0).tan());
        let end = [length * first.cos(), length * first.sin()];
        let heading = first + second;
        let steps = [
            Step::Line { to: [0.0, 0.0] },
            Step::Line { to: end },
            Step::Line { to: [end[0] + 9.0 * heading.cos(), end[1] + 9.0 * heading.sin()] },
        ];
        let is_short = |kind: &OvercutKind| matches!(kind, OvercutKind::ShortBlock { .. });
        check(room > 1.0, [-9.0, 0.0], &steps, place, is_short)?;
    }

    /// A slot between parallel lines, closed by an arc that turns back from one to the other: it is
    /// tangent to the one only. In a narrow slot the offsets of arc and line do not meet.
    #[test]
    fn the_tool_runs_in_no_slot_narrower_than_itself(
        room in rooms(),
        turn in 20.0..120.0_f64,
        place in places(),
    ) {
        let turn = turn.to_radians();
        let radius = 2.0 * room / (1.0 + turn.cos());
        let centre = [-radius * turn.sin(), radius * turn.cos()];
        let top = [centre[0], 2.0 * room];
        let steps = [
            Step::Line { to: [0.0, 0.0] },
            Step::Arc { to: top, centre },
            Step::Line { to: [top[0] - 20.0, top[1]] },
        ];
        check(room > 1.0, [-20.0, 0.0], &steps, place, |kind| matches!(
            kind,
            OvercutKind::NoMeeting { .. } | OvercutKind::SmallArc { .. }
                | OvercutKind::ShortBlock { .. } | OvercutKind::Interference { .. }
        ))?;
    }

    /// Two lines far from each other in the program make a neck before a chamber.
    #[test]
    fn the_tool_passes_no_neck_narrower_than_itself(
        room in rooms(),
        length in 0.5..9.0_f64,
        place in places(),
    ) {
        let corners = [
            [room, 0.0],
            [room, length],
            [30.0, length],
            [30.0, length + 30.0],
            [-30.0, length + 30.0],
            [-30.0, length],
            [-room, length],
            [-room, 0.0],
            [-30.0, 0.0],
        ];
        let steps = corners.map(|to| Step::Line { to });
        let is_far = |kind: &OvercutKind| matches!(kind, OvercutKind::Interference { .. });
        check(room > 1.0, [30.0, 0.0], &steps, place, is_far)?;
    }

    /// An edge that points at a wall: the way round it reaches the further from its tip the sharper it is,
    /// other than an arc, and needs the radius between itself and the wall.
    #[test]
    fn no_corner_cuts_a_wall_further_on(
        room in rooms(),
        opening in 5.0..175.0_f64,
        is_arc in any::<bool>(),
        place in places(),
    ) {
        let half = (opening / 2.0).to_radians();
        let corners = if is_arc { Corners::Arcs } else { Corners::Straight };
        let reach = match corners {
            Corners::Arcs => 1.0,
            Corners::Straight if opening < 90.0 => half.cos() + half.sin(),
            Corners::Straight => 1.0 / half.sin(),
        };
        let wall = room * (reach + 1.0);
        let flank = [-60.0 * half.cos(), 60.0 * half.sin()];
        let steps = [
            [0.0, 0.0],
            [flank[0], -flank[1]],
            [flank[0] - 20.0, -90.0],
            [wall, -90.0],
            [wall, 60.0],
        ].map(|to| Step::Line { to });
        match machined(flank, &steps, place, corners) {
            Ok(cuts) => prop_assert!(room > 1.0, "{cuts:?}"),
            Err(overcuts) => {
                prop_assert!(room < 1.0, "{overcuts:?}");
                let is_corner = |overcut: &Overcut| {
                    matches!(overcut.kind, OvercutKind::Interference { .. })
                        && overcut.other_line.is_some_and(|other| [overcut.line.min(other), overcut.line.max(other)] == [1, 5])
                };
                prop_assert!(overcuts.iter().any(is_corner), "{overcuts:?}");
            }
        }
    }
}
