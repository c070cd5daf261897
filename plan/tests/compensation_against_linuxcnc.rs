//! Cutter radius compensation against LinuxCNC's interpreter, on random programs.
//!
//! It goes round outside corners on arcs, and to the exact intersection at inside ones. Its first move
//! goes to the corner that the path would have there between two blocks, its last one starts at the end of the
//! last block's offset: between them, its path is to be ours. It looks no further than to the next block.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod curves;
mod linuxcnc;
mod random;

use cavalier_contours::polyline::Polyline;
use curves::{clearance, polyline_of};
use linuxcnc::{Move, compensated};
use onepulse_core::Direction;
use onepulse_plan::compensation::{
    Block, Corners, Cut, Element, Overcut, OvercutKind, Role, Section, Side, c_type,
};
use proptest::prelude::*;
use random::{Counts, run};
use std::fmt::Write as _;

/// Half a unit of the last decimal printed, and a rounding of our own.
const PRINTED: f64 = 0.5e-4 + 1e-9;

#[derive(Clone, Debug)]
struct Case {
    section: Section,
    side: Side,
    radius: f64,
    /// Whether an arc doubles back: the interpreter knows the tangents there, which do not tell an inside
    /// corner from an outside one.
    has_cusp: bool,
}

/// How the way goes on: by how much it turns first, then a line, or an arc with its radius and sweep.
/// Angles are in degrees, so that right ones are exact.
#[derive(Clone, Copy, Debug)]
struct Step {
    turn: f64,
    length: f64,
    sweep: f64,
}

/// The interpreter passes over corners of less than 2.87°: they are tangent or of 4° and more.
fn turns() -> impl Strategy<Value = f64> {
    prop_oneof![1 => Just(0.0), 2 => 4.0..175.0, 2 => -175.0..-4.0]
}

fn steps() -> impl Strategy<Value = Step> {
    let circle = prop::sample::select(&[-360.0, 360.0]);
    let sweep = prop_oneof![8 => Just(0.0), 4 => 10.0..270.0, 4 => -270.0..-10.0, 1 => circle];
    (turns(), 0.3..1.8_f64, sweep).prop_map(|(turn, digits, sweep)| Step {
        turn,
        length: 10_f64.powf(digits),
        sweep,
    })
}

/// Lines and arcs of a grid: right angles, half and full circles, lines that double back on themselves.
fn steps_on_grid() -> impl Strategy<Value = Step> {
    let sweep = prop::sample::select(&[-360.0, -180.0, -90.0, 0.0, 0.0, 0.0, 90.0, 180.0, 360.0]);
    (prop::sample::select(&[-90.0, 0.0, 90.0, 180.0]), 1..10_u8, sweep)
        .prop_map(|(turn, length, sweep)| Step { turn, length: f64::from(length), sweep })
}

fn cases() -> impl Strategy<Value = Case> {
    let free = (
        (0.0..170.0, 0.0..170.0),
        prop::collection::vec(steps(), 1..6),
        (-0.5..1.0_f64).prop_map(|digits| 10_f64.powf(digits)),
    );
    // No sum of lengths and no radius is one of these, nor twice one.
    let right = prop::sample::select(&[0.0, 90.0]);
    let on_grid = (
        (right.clone(), right),
        prop::collection::vec(steps_on_grid(), 1..8),
        prop::sample::select(&[0.3, 0.7, 1.2, 2.3]),
    );
    (prop_oneof![3 => free, 1 => on_grid], any::<bool>()).prop_map(
        |(((first, last), mut steps, radius), is_left)| {
            // The first corner is tangent or an outside one, the last one tangent or an inside one: there the
            // interpreter's first and last moves and ours agree.
            let turn = |angle: f64| if angle < 4.0 { 0.0 } else { angle };
            let sign = if is_left { 1.0 } else { -1.0 };
            steps[0].turn = -sign * turn(first);
            let side = if is_left { Side::Left } else { Side::Right };
            let has_cusp = steps
                .windows(2)
                .any(|pair| pair[1].turn == 180.0 && pair.iter().any(|step| step.sweep != 0.0));
            Case { section: section(&steps, sign * turn(last)), side, radius, has_cusp }
        },
    )
}

/// The unit vector in a direction.
fn unit(degrees: f64) -> [f64; 2] {
    let quarters = degrees.rem_euclid(360.0) / 90.0;
    if quarters.fract() == 0.0 {
        [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][quarters as usize % 4]
    } else {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [cos, sin]
    }
}

/// The way that the steps describe, from and to 60 mm away from it.
fn section(steps: &[Step], last_turn: f64) -> Section {
    let mut at = [0.0, 0.0];
    let mut heading = 0.0;
    let mut contour = Vec::new();
    for (step, line) in steps.iter().zip(2..) {
        heading += step.turn;
        let from = at;
        let element = if step.sweep == 0.0 {
            let [x, y] = unit(heading);
            at = [at[0] + step.length * x, at[1] + step.length * y];
            Element::Line { from, to: at }
        } else {
            let quarter = 90_f64.copysign(step.sweep);
            let [x, y] = unit(heading + quarter);
            let centre = [at[0] + step.length * x, at[1] + step.length * y];
            heading += step.sweep;
            if step.sweep.abs() < 360.0 {
                let [x, y] = unit(heading - quarter);
                at = [centre[0] + step.length * x, centre[1] + step.length * y];
            }
            let direction = if step.sweep > 0.0 { Direction::Ccw } else { Direction::Cw };
            Element::Arc { from, to: at, centre, direction }
        };
        contour.push(Block { element, line, is_machined: true });
    }
    let [x, y] = unit(heading + last_turn);
    let away = [at[0] + 60.0 * x, at[1] + 60.0 * y];
    let line =
        |from, to, line| Block { element: Element::Line { from, to }, line, is_machined: true };
    let leave = line(at, away, contour.len() as u32 + 2);
    Section { approach: line([-60.0, 0.0], [0.0, 0.0], 1), contour, leave }
}

/// The program, with the tool's diameter in it.
fn program(case: &Case) -> String {
    let Element::Line { from: [x, y], .. } = case.section.approach.element else { unreachable!() };
    let mut text = format!("G21 G17 G90 G40 G64\nG0 X{x:.12} Y{y:.12}\nF100\n");
    let on = if case.side == Side::Left { "G41.1" } else { "G42.1" };
    writeln!(text, "{on} D{:.12}", 2.0 * case.radius).unwrap();
    let blocks = [&case.section.approach].into_iter().chain(&case.section.contour);
    for (block, is_last) in blocks.map(|block| (block, false)).chain([(&case.section.leave, true)])
    {
        if is_last {
            text += "G40\n";
        }
        match block.element {
            Element::Line { to: [x, y], .. } => writeln!(text, "G1 X{x:.12} Y{y:.12}").unwrap(),
            Element::Arc { from, to: [x, y], centre, direction } => {
                let code = if direction == Direction::Cw { "G2" } else { "G3" };
                let [i, j] = [0, 1].map(|axis| centre[axis] - from[axis]);
                writeln!(text, "{code} X{x:.12} Y{y:.12} I{i:.12} J{j:.12}").unwrap();
            }
        }
    }
    text + "M2\n"
}

fn ends(element: &Element) -> [[f64; 2]; 2] {
    match *element {
        Element::Line { from, to } | Element::Arc { from, to, .. } => [from, to],
    }
}

fn are_close(one: [f64; 2], other: [f64; 2]) -> bool {
    (0..2).all(|axis| (one[axis] - other[axis]).abs() <= PRINTED)
}

/// Whether a cut ends where the move does, on the same curve.
fn agrees(cut: &Cut, printed: &Move) -> bool {
    let is_same_curve = match (cut.element, printed.arc) {
        (Element::Line { .. }, None) => true,
        (Element::Arc { centre, direction, .. }, Some((about, sense))) => {
            are_close(centre, about) && direction == sense
        }
        _ => false,
    };
    is_same_curve && are_close(ends(&cut.element)[1], printed.to)
}

/// The path from the end of the first move to the end of the last block's offset.
fn compared(case: &Case, cuts: &[Cut]) -> Vec<Cut> {
    let last = case.section.contour.len();
    let is_compared = |cut: &&Cut| match cut.role {
        Role::Establish | Role::Cancel => false,
        Role::Offset => true,
        Role::Corner => cut.block < last,
    };
    cuts.iter().filter(is_compared).copied().collect()
}

/// The moves as curves.
fn path_of(moves: &[Move]) -> Polyline {
    let elements = moves.windows(2).map(|pair| match pair[1].arc {
        None => Element::Line { from: pair[0].to, to: pair[1].to },
        Some((centre, direction)) => {
            Element::Arc { from: pair[0].to, to: pair[1].to, centre, direction }
        }
    });
    polyline_of(&elements.collect::<Vec<_>>())
}

/// What the interpreter says of a tool that does not fit. Anything else is a fault of the program's text.
const REFUSALS: [&str; 4] = [
    "in concave corner cannot be reached by the tool without gouging",
    "Tool radius not less than arc radius with comp",
    "Arc to arc motion makes a corner the compensated tool can't fit in",
    "Arc to straight motion makes a corner the compensated tool can't fit in",
];

/// The whole path is the interpreter's with arcs at the corners.
fn check_arcs(case: &Case, cuts: &[Cut], moves: &[Move]) -> Result<(), TestCaseError> {
    let cuts = compared(case, cuts);
    prop_assert_eq!(cuts.len() + 1, moves.len(), "{:?} {:?}", cuts, moves);
    for (cut, printed) in cuts.iter().zip(&moves[1..]) {
        prop_assert!(agrees(cut, printed), "{cut:?} is not {printed:?}");
    }
    Ok(())
}

/// Where nothing goes round a corner on an arc, straight corners change nothing either. Returns how many
/// ends were compared.
fn check_straight(case: &Case, straight: &[Cut], arcs: &[Cut]) -> Result<u32, TestCaseError> {
    let mut ends_compared = 0;
    for block in 1..=case.section.contour.len() {
        let offset = |cuts: &[Cut]| {
            let mut found =
                cuts.iter().filter(|cut| (cut.block, cut.role) == (block, Role::Offset));
            found.next().map(|cut| ends(&cut.element))
        };
        let goes_round =
            |block| arcs.iter().any(|cut| (cut.block, cut.role) == (block, Role::Corner));
        let (Some(found), Some(expected)) = (offset(straight), offset(arcs)) else {
            return Err(TestCaseError::fail(format!("block {block} has no offset")));
        };
        for (end, corner) in [(0, block - 1), (1, block)] {
            if !goes_round(corner) {
                let is_same =
                    (0..2).all(|axis| (found[end][axis] - expected[end][axis]).abs() < 1e-9);
                prop_assert!(is_same, "block {block}: {found:?} is not {expected:?}");
                ends_compared += 1;
            }
        }
    }
    Ok(ends_compared)
}

/// Whether the tool cuts into some other block than the next.
fn is_far(overcut: &Overcut) -> bool {
    matches!(overcut.kind, OvercutKind::Interference { .. })
}

#[test]
fn random_programs_run_as_linuxcnc_runs_them() {
    let counts = Counts::default();
    let count = |what, many| counts.add(what, many);
    run(300, &cases(), |case| {
        let contour = polyline_of(case.section.contour.iter().map(|block| &block.element));
        if case.has_cusp {
            count("cusp", 1);
            if let Ok(cuts) = c_type(&case.section, case.side, case.radius, Corners::Arcs) {
                let cuts = compared(&case, &cuts);
                let (least, at) =
                    clearance(&polyline_of(cuts.iter().map(|cut| &cut.element)), &contour);
                prop_assert!(least > case.radius - 1e-7, "{least} at {at:?}");
            }
            return Ok(());
        }
        let theirs = compensated(&program(&case));
        let ours = c_type(&case.section, case.side, case.radius, Corners::Arcs);
        let moves = match theirs {
            Ok(moves) => moves,
            Err(reason) => {
                let refusal = REFUSALS.iter().find(|refusal| reason.contains(*refusal));
                prop_assert!(refusal.is_some(), "{reason}");
                prop_assert!(ours.is_err(), "{reason}: {:?}", ours);
                count(refusal.unwrap(), 1);
                return Ok(());
            }
        };
        let (least, at) = clearance(&path_of(&moves), &contour);
        match ours {
            Ok(cuts) => {
                prop_assert!(least > case.radius - 4.0 * PRINTED, "{least} at {at:?}");
                check_arcs(&case, &cuts, &moves)?;
                count("the same path", 1);
                count(
                    "corners on arcs",
                    moves.len() as u32 - 1 - case.section.contour.len() as u32,
                );
                match c_type(&case.section, case.side, case.radius, Corners::Straight) {
                    Ok(straight) => {
                        count("ends at no arc", check_straight(&case, &straight, &cuts)?);
                        count("straight as well", 1);
                    }
                    // Straight corners reach further.
                    Err(overcuts) => prop_assert!(overcuts.iter().all(is_far), "{overcuts:?}"),
                }
            }
            // The interpreter looks no further than the next block, and does not see a block reversed
            // by its first corner where the second is tangent or an outside one: the library does.
            Err(overcuts) if least < case.radius - 4.0 * PRINTED => {
                let is_all_far = overcuts.iter().all(is_far);
                count(if is_all_far { "gouged further on" } else { "gouged at the next block" }, 1);
            }
            Err(overcuts) => {
                let reason = format!("{overcuts:?}, {least} at {at:?}");
                return Err(TestCaseError::fail(reason));
            }
        }
        Ok(())
    });
    counts.check(&[("the same path", 100), ("corners on arcs", 100), ("ends at no arc", 300)]);
    counts.check(&[("straight as well", 100), ("gouged further on", 10)]);
    counts.check(&REFUSALS.map(|refusal| (refusal, 1)));
}
