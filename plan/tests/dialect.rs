//! The dialect beyond lines and arcs of the XY plane: planes, dwells, tools, compensation, block delete.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use onepulse_core::{Direction, Plane};
use onepulse_plan::centre_path::{CentreMove, CentrePath, Compensation, PathError, Role, Step};
use onepulse_plan::compensation::Corners;
use onepulse_plan::gcode::Program;
use onepulse_plan::{Curve, Diagnostic, Machine, Motion, ToolTable, Tools};
use std::time::Duration;

/// A hundredth of a millimetre a pulse; integers count pulses.
fn machine() -> Machine {
    Machine::with_pulse("0.01".parse().unwrap())
}

fn table() -> Tools {
    Tools::Table(ToolTable::read("T1 P1 D4.0\nT2 P2 D10.0 ; large\nT7 P3\n").unwrap())
}

fn path<'a>(program: &'a str, tools: &Tools) -> CentrePath<Program<&'a [u8]>> {
    let program = Program::new(program.as_bytes(), &machine(), tools);
    CentrePath::new(program, &machine(), Compensation::default())
}

fn steps(program: &str, tools: &Tools) -> Vec<Step> {
    path(program, tools).collect::<Result<_, _>>().unwrap()
}

/// The moves of a program that go anywhere.
fn moves(program: &str, tools: &Tools) -> Vec<CentreMove> {
    let step = |step| match step {
        Step::Move(step) => Some(step),
        Step::Pause(_) => None,
    };
    let moves = steps(program, tools).into_iter().filter_map(step);
    moves.filter(|step| step.from != step.to || step.arc.is_some()).collect()
}

fn motions(program: &str) -> Vec<Motion> {
    path(program, &Tools::Unknown).motions().collect::<Result<_, _>>().unwrap()
}

fn refusals(program: &str, tools: &Tools) -> Vec<Diagnostic> {
    let error = path(program, tools).find_map(Result::err).expect("the program is refused");
    match error {
        PathError::Program { wrong, .. } => wrong,
        PathError::Input(error) => panic!("{error}"),
    }
}

/// Each program is refused once, at a line and a column, with this text underlined and these words.
fn check_refused(tools: &Tools, cases: &[(&str, u32, usize, &str, &str)]) {
    for &(program, line, column, underlined, words) in cases {
        let wrong = refusals(program, tools);
        assert_eq!(wrong.len(), 1, "{program}: {wrong:?}");
        let Diagnostic { place, message, help, .. } = &wrong[0];
        assert_eq!((place.line, place.column()), (line, column), "{program}: {message}");
        assert_eq!(&place.text[place.span.clone()], underlined, "{program}");
        assert!(message.contains(words), "{program}: {message}");
        assert!(!help.is_empty(), "{program}");
    }
}

#[test]
fn z_moves_with_the_others_or_alone() {
    let motions = motions("G01 X5 Y3 Z-2 F100\nZ4\nG91 Z-1.\nG90 X0 Z0");
    let ends: Vec<_> = motions.iter().map(|motion| motion.to).collect();
    assert_eq!(ends, [[5, 3, -2], [5, 3, 4], [5, 3, -96], [0, 3, 0]]);
}

/// Quarter circles of radius 5 from the first axis of each plane to its second, counter-clockwise seen from
/// the positive end of the axis across it.
#[test]
fn arcs_turn_in_their_plane() {
    let arc = |program: &str| *motions(program).last().unwrap();
    let expected = |plane, from, to| {
        let curve = Curve::Arc { plane, centre: [0, 0], direction: Direction::Ccw };
        (from, to, curve)
    };
    for (program, (from, to, curve)) in [
        ("G00 X5\nG17 G03 X0 Y5 I-5 F1", expected(Plane::Xy, [5, 0, 0], [0, 5, 0])),
        ("G00 Z5\nG18 G03 Z0 X5 K-5 F1", expected(Plane::Zx, [0, 0, 5], [5, 0, 0])),
        ("G00 Y5\nG19 G03 Y0 Z5 J-5 F1", expected(Plane::Yz, [0, 5, 0], [0, 0, 5])),
        ("G00 Z5\nG18 G03 Z0 X5 R5 F1", expected(Plane::Zx, [0, 0, 5], [5, 0, 0])),
        ("G00 Y5\nG19 G03 Y0 Z5 R5 F1", expected(Plane::Yz, [0, 5, 0], [0, 0, 5])),
    ] {
        let found = arc(program);
        assert_eq!((found.from, found.to, found.curve), (from, to, curve), "{program}");
    }
    // G02 the other way round: three quarters.
    let Curve::Arc { direction, .. } = arc("G00 Z5\nG18 G02 Z0 X5 K-5 F1").curve else { panic!() };
    assert_eq!(direction, Direction::Cw);
    // What lies across stays where it is.
    let raised = arc("G00 Z5 Y9\nG18 G03 Z0 X5 K-5 F1");
    assert_eq!((raised.from, raised.to), ([0, 9, 5], [5, 9, 0]));
}

#[test]
fn arcs_have_the_words_of_their_plane() {
    check_refused(
        &Tools::Unknown,
        &[
            ("G02 X5 Y5 I5 K1 F1", 1, 14, "K1", "no coordinate of the plane XY"),
            ("G18 G02 X5 Z5 J5 F1", 1, 15, "J5", "no coordinate of the plane ZX"),
            ("G19 G02 Y5 Z5 I5 F1", 1, 15, "I5", "no coordinate of the plane YZ"),
            ("G02 X5 Y5 Z1 I5 F1", 1, 11, "Z1", "does not move Z"),
            ("G18 G02 X5 Z5 Y1 I5 F1", 1, 15, "Y1", "does not move Y"),
            ("G01 X1 K2 F1", 1, 8, "K2", "belong to arcs"),
        ],
    );
    // Where the word says that it stays there, it stays there.
    assert_eq!(motions("G00 Z1\nG02 X10 Z1 I5 F1").len(), 2);
}

#[test]
fn pauses_come_in_their_place() {
    let program = "G04 P0.5\nG00 X5 M00\nG04 X2.\nG04 P0.000000001\nG91 G04 P3\nG01 X1 F1\nM00";
    let shown: Vec<_> = steps(program, &Tools::Unknown)
        .into_iter()
        .map(|step| match step {
            Step::Move(step) => (step.place.line, None),
            Step::Pause(pause) => (pause.place.line, Some(pause.dwell)),
        })
        .collect();
    let dwell = |nanoseconds| Some(Some(Duration::from_nanos(nanoseconds)));
    assert_eq!(
        shown,
        [
            (1, dwell(500_000_000)),
            (2, None),
            (2, Some(None)),
            (3, dwell(2_000_000_000)),
            (4, dwell(1)),
            (5, dwell(3_000_000_000)),
            (6, None),
            (7, Some(None)),
        ]
    );
    // As long as any.
    let longest = &steps("G04 P1000000", &Tools::Unknown)[0];
    assert!(
        matches!(longest, Step::Pause(pause) if pause.dwell == Some(Duration::from_secs(1_000_000)))
    );
    // The X of a dwell is no coordinate; the modes of its block hold.
    assert_eq!(moves(program, &Tools::Unknown)[1].to, [0.06, 0.0, 0.0]);
}

#[test]
fn dwells_have_one_time_and_no_motion() {
    check_refused(
        &Tools::Unknown,
        &[
            ("G04", 1, 1, "G04", "without a time"),
            ("G04 P1 X1", 1, 8, "X1", "two times"),
            ("G04 P-1", 1, 5, "P-1", "no time"),
            ("G04 P1000001", 1, 5, "P1000001", "no time"),
            ("G04 P0.0000000001", 1, 5, "P0.0000000001", "no time"),
            ("G04 P1 Y1", 1, 8, "Y1", "moves nothing"),
            ("G04 P1 Z1", 1, 8, "Z1", "moves nothing"),
            ("G04 P1 I1", 1, 8, "I1", "moves nothing"),
            ("G04 G01 P1 F1", 1, 5, "G01", "a dwell and a motion"),
            ("G00 X1 P1", 1, 8, "P1", "P without a dwell"),
        ],
    );
}

#[test]
fn blocks_with_a_slash_are_left_out_if_asked() {
    let program = "G00 X5\n/ X6\n/N3 G00 X7\nX8\n/ Q%\n";
    let lines = |block_delete| {
        let machine = Machine { block_delete, ..machine() };
        let program = Program::new(program.as_bytes(), &machine, &Tools::Unknown);
        let path = CentrePath::new(program, &machine, Compensation::default());
        let motions: Result<Vec<_>, _> = path.motions().collect();
        motions.map(|motions| motions.iter().map(|motion| motion.line).collect::<Vec<_>>())
    };
    assert_eq!(lines(true).unwrap(), [1, 4]);
    // Else they are blocks as any other, and read as such.
    let PathError::Program { wrong, .. } = lines(false).unwrap_err() else { panic!() };
    assert_eq!(wrong.len(), 1, "{wrong:?}");
    assert_eq!(wrong[0].place.line, 5);
}

#[test]
fn nothing_comes_after_the_second_tape_mark() {
    assert_eq!(motions("(part)\n%\nG00 X5\n%\nQ X6").len(), 1);
    assert_eq!(motions("G00 X5\n%\nX6").len(), 1);
}

#[test]
fn tools_and_spindle_speeds_stay() {
    let program = "G00 X1\nT2 S1200.5\nX2\nX3 T1\nS0 X4";
    let found: Vec<_> =
        moves(program, &table()).iter().map(|step| (step.tool, step.spindle)).collect();
    assert_eq!(
        found,
        [(None, None), (Some(2), Some(1200.5)), (Some(1), Some(1200.5)), (Some(1), Some(0.0))]
    );
    check_refused(
        &table(),
        &[
            ("S-1", 1, 1, "S-1", "not negative"),
            ("T-1", 1, 1, "T-1", "a whole number"),
            ("T1.5", 1, 1, "T1.5", "a whole number"),
            ("D1.", 1, 1, "D1.", "a whole number"),
            ("D99999999999", 1, 1, "D99999999999", "a whole number"),
        ],
    );
}

/// The square of the doc example, once round from the middle of its left side, with words in the block that
/// establishes the compensation and before it.
fn square(before: &str, words: &str) -> String {
    format!(
        "G00 X-30. Y10. {before}\nG01 {words} X0. F600\nY20.\nX20.\nY0.\nX0.\nY10.\nG40 X-30.\nM02\n"
    )
}

/// How far the path is from the square's left side.
fn radius(program: &str, tools: &Tools) -> f64 {
    let moves = moves(program, tools);
    let offset = moves.iter().find(|step| step.role == Role::Offset).unwrap();
    -offset.from[0]
}

#[test]
fn radii_come_from_the_table_by_d_or_else_by_t() {
    assert_eq!(radius(&square("", "G41 D1"), &table()), 2.0);
    assert_eq!(radius(&square("", "G41 D2"), &table()), 5.0);
    assert_eq!(radius(&square("T2", "G41"), &table()), 5.0);
    assert_eq!(radius(&square("T2 D1", "G41"), &table()), 2.0);
    assert_eq!(radius(&square("", "G41 T1"), &table()), 2.0);
    // No diameter in the table, and no offset at all.
    assert_eq!(radius(&square("", "G41 D7"), &table()), 0.0);
    assert_eq!(radius(&square("", "G41 D0"), &table()), 0.0);
    assert_eq!(radius(&square("", "G41"), &Tools::Radius(3.0)), 3.0);
    assert_eq!(radius(&square("", "G41 D2"), &Tools::Radius(3.0)), 3.0);
    check_refused(
        &table(),
        &[
            ("G00 X1\nG41 D3 X2", 2, 5, "D3", "tool 3 is not in the tool table"),
            ("G00 X1\nG41 X2", 2, 1, "G41", "without a tool"),
        ],
    );
    check_refused(
        &Tools::Unknown,
        &[("G00 X1\nG41 D3 X2", 2, 5, "D3", "the cutter's radius is not known")],
    );
}

#[test]
fn side_and_radius_change_between_cancelling_and_establishing() {
    // From outside on its left, and then from inside on its right.
    let inside = "G00 X10.\nG42 D2 G01 X0.\nY20.\nX20.\nY0.\nX0.\nY10.\nG40 X10.\nM02\n";
    let twice = square("", "G41 D1").replace("M02\n", inside);
    let moves = moves(&twice, &table());
    let establish: Vec<_> = moves.iter().filter(|step| step.role == Role::Establish).collect();
    assert_eq!(establish.len(), 2);
    assert_eq!(establish[0].to[0], -2.0);
    assert_eq!(establish[1].to[0], 5.0);
}

#[test]
fn changes_while_compensated_are_refused() {
    let with =
        |block: &str| square("", "G41 D1").replace("X20.\nY0", &format!("X20.\n{block}\nY0"));
    for (block, underlined, words) in [
        ("G42", "G42", "the side changes"),
        ("D2", "D2", "radius changes"),
        ("G41 D2", "D2", "radius changes"),
        ("G18", "G18", "the plane changes"),
        ("G40 G02 X30. Y10. R10.", "G40 G02 X30. Y10. R10.", "cancelled on a line"),
    ] {
        let program = with(block);
        let wrong = refusals(&program, &table());
        let Diagnostic { place, message, .. } = &wrong[0];
        assert_eq!((place.line, &place.text[place.span.clone()]), (5, underlined), "{wrong:?}");
        assert!(message.contains(words), "{message}");
        // G02 stays, and what follows is no arc.
        assert_eq!(wrong.len(), if block.contains("G02") { 5 } else { 1 }, "{wrong:?}");
    }
    // The same again changes nothing.
    let again = moves(&with("G41 D1 G17"), &table());
    assert_eq!(again.len(), moves(&square("", "G41 D1"), &table()).len());
    check_refused(
        &table(),
        &[
            (
                "G00 X1\nG41 D1 G02 X5 Y0 I2 F1\nG40 G00 X9",
                2,
                1,
                "G41 D1 G02 X5 Y0 I2 F1",
                "established on a line",
            ),
            ("G00 X1\nG41 D1 X2\nX5.\nM30", 4, 1, "M30", "while the cutter is compensated"),
            ("G00 X1\nG41 D1 X2\nX5.", 3, 4, "", "while the cutter is compensated"),
            ("G00 X1\nG41 D1 X2\nX5.\nG40\n%\n", 5, 1, "", "while the cutter is compensated"),
            ("G00 X1\nG41 D1 X2\nX5.\nG40\nG42 X9\nM02", 5, 1, "G42", "not cancelled yet"),
        ],
    );
}

/// What does not move in the plane, and what does not move, changes nothing of the contour.
#[test]
fn plunges_and_pauses_come_where_they_stand() {
    let plain = moves(&square("", "G41 D1"), &table());
    let program = square("", "G41 D1").replace("X20.\nY0", "G04 P1\nZ-5.\nX20.\nX20.\nZ3. M00\nY0");
    let steps = steps(&program, &table());
    let mut flat = Vec::new();
    let mut heights = Vec::new();
    let mut pauses = Vec::new();
    for step in &steps {
        match step {
            Step::Move(step) if step.from[..2] == step.to[..2] => {
                heights.push((step.from, step.to));
            }
            Step::Move(step) => flat.push((step.from[..2].to_vec(), step.to[..2].to_vec())),
            Step::Pause(_) => pauses.push(flat.len()),
        }
    }
    let due: Vec<_> =
        plain.iter().map(|step| (step.from[..2].to_vec(), step.to[..2].to_vec())).collect();
    assert_eq!(flat, due);
    // The upper left and the upper right corner, extended.
    assert_eq!(heights[0], ([-2.0, 22.0, 0.0], [-2.0, 22.0, -5.0]));
    assert_eq!(heights[1], ([22.0, 22.0, -5.0], [22.0, 22.0, 3.0]));
    assert_eq!(pauses, [3, 4]);
}

/// The same contour in the three planes: the coordinates change their names.
#[test]
fn contours_are_compensated_in_their_plane() {
    let program = "G00 X-30. Y10.\nG41 D1 G01 X0. F600\nY20.\nG02 X20. Y0. I0. J-20.\nG01 X0.\nY10.\nG40 X-30.\n";
    let renamed = |from: [&str; 4], to: [&str; 4]| {
        let mut text = program.to_owned();
        for (at, name) in from.iter().enumerate() {
            text = text.replace(name, &format!("<{at}>"));
        }
        for (at, name) in to.iter().enumerate() {
            text = text.replace(&format!("<{at}>"), name);
        }
        text
    };
    let names = ["X", "Y", "I", "J"];
    let xy = moves(program, &table());
    assert_eq!(xy.iter().filter(|step| step.role == Role::Offset).count(), 4);
    for (g, plane, to) in
        [("G18", Plane::Zx, ["Z", "X", "K", "I"]), ("G19", Plane::Yz, ["Y", "Z", "J", "K"])]
    {
        let other = moves(&format!("{g}\n{}", renamed(names, to)), &table());
        assert_eq!(other.len(), xy.len());
        for (one, other) in xy.iter().zip(&other) {
            assert_eq!(plane.place(one.from), other.from);
            assert_eq!(plane.place(one.to), other.to);
            assert_eq!(one.arc, other.arc);
            assert_eq!((one.role, other.plane), (other.role, plane));
        }
    }
}

#[test]
fn overcuts_name_their_lines_before_any_motion() {
    let program = "G00 X0. Y-20.\nG41 D2 G01 Y0. F600\nY30.\nX-30.\nG03 X-34. Y26. J-4.\nG01 Y0.\nX-60.\nG40 Y-20.\nM02\n";
    let mut steps = path(program, &table());
    let mut before = 0;
    let error = loop {
        match steps.next().unwrap() {
            Ok(_) => before += 1,
            Err(error) => break error,
        }
    };
    // Only the rapid to the start.
    assert_eq!(before, 1);
    let PathError::Program { wrong, gouges } = error else { panic!() };
    assert!(
        wrong
            .iter()
            .any(|found| found.place.line == 5 && found.message.contains("larger than the arc"))
    );
    assert_eq!(gouges.len(), 1);
    assert_eq!(gouges[0].radius, 5.0);
    assert_eq!(gouges[0].contour.len(), 7);
}

/// Errors of the program and overcuts before them come together, in the order of the lines.
#[test]
fn overcuts_and_errors_are_told_in_one_pass() {
    let program = "G00 X0. Y-20.\nG41 D2 G01 Y0. F600\nG03 X-8. R4.\nG40 G01 Y-20.\nG01 Q5\nG54\n";
    let lines: Vec<_> = refusals(program, &table()).iter().map(|wrong| wrong.place.line).collect();
    assert_eq!(lines, [3, 5, 6]);
}

#[test]
fn the_types_and_corners_differ_as_they_should() {
    let program = square("", "G41 D1");
    let count = |compensation| {
        let steps = Program::new(program.as_bytes(), &machine(), &table());
        let path = CentrePath::new(steps, &machine(), compensation);
        let steps: Vec<_> = path.collect::<Result<Vec<_>, _>>().unwrap();
        let arcs = steps.iter().filter(|step| match step {
            Step::Move(step) => step.arc.is_some(),
            Step::Pause(_) => false,
        });
        arcs.count()
    };
    assert_eq!(count(Compensation::C(Corners::Straight)), 0);
    // Four of the square; the turns at its start and end go inside.
    assert_eq!(count(Compensation::C(Corners::Arcs)), 4);
}

/// A mismatch of the radii within the tolerance: the compensated arc is on one circle, through both ends.
#[test]
fn compensated_arcs_run_through_both_their_ends() {
    let program = "G00 X30. Y0.\nG41 D1 G01 X20. F600\nG03 X0. Y20.004 I-20.\nG01 X-5.\nG40 Y40.\n";
    let moves = moves(program, &table());
    let arc = moves.iter().find(|step| step.arc.is_some()).unwrap();
    let (centre, _) = arc.arc.unwrap();
    let from = |point: [f64; 3]| (point[0] - centre[0]).hypot(point[1] - centre[1]);
    assert!((from(arc.from) - from(arc.to)).abs() < 1e-9);
    assert!((from([20.0, 0.0, 0.0]) - from([0.0, 20.004, 0.0])).abs() < 1e-9);
    assert!((from(arc.from) - (from([20.0, 0.0, 0.0]) - 2.0)).abs() < 1e-9);
    // Nowhere further than the tolerance from the circle that is programmed.
    assert!(centre[0].hypot(centre[1]) < 0.005, "{centre:?}");
    // A nearly whole turn has no such circle.
    let program =
        "G00 X30. Y0.\nG41 D1 G01 X20. F600\nG03 X20.004 Y-0.001 I-20.\nG01 Y5.\nG40 X40.\n";
    let wrong = refusals(program, &table());
    assert!(wrong[0].message.contains("nearly whole turn"), "{wrong:?}");
    assert_eq!(wrong[0].place.line, 3);
}

/// The pulses of a compensated path end where the exact path does.
#[test]
fn compensated_paths_are_rounded_point_by_point() {
    let program = square("", "G41 D1");
    let mut at = [0; 3];
    for step in steps(&program, &table()) {
        let Step::Move(step) = step else { continue };
        for motion in step.motions() {
            assert_eq!(motion.from, at);
            at = motion.to;
        }
        assert_eq!(at, step.to.map(|c| (c * 100.0).round() as i32));
    }
    assert_eq!(at, [-3000, 1000, 0]);
}

/// A hundred blocks that vanish.
#[test]
fn overcuts_are_told_up_to_a_number() {
    let teeth: String = (1..=100).map(|x| format!("X{x}. Y0.5\nX{x}.5 Y0.\n")).collect();
    let program = format!("G00 X-9. Y-9.\nG41 D2 G01 X0.5 Y0. F600\n{teeth}G40 Y-20.\n");
    let wrong = refusals(&program, &table());
    assert_eq!(wrong.len(), 20);
    let Some(Err(PathError::Program { gouges, .. })) =
        path(&program, &table()).find(Result::is_err)
    else {
        panic!()
    };
    assert_eq!(gouges[0].overcuts.len(), 20);
    assert!(wrong.is_sorted_by_key(|diagnostic| diagnostic.place.line));
    // Those of the contours and of the program together.
    let small = "G00 X0. Y-20.\nG41 D2 G01 Y0. F600\nG03 X-8. R4.\nG40 G01 Y-20.\n";
    assert_eq!(refusals(&format!("{small}{}", "G54\n".repeat(30)), &table()).len(), 20);
}

#[test]
fn overcuts_say_what_to_do() {
    let small = "G00 X0. Y-20.\nG41 D2 G01 Y0. F600\nG03 X-8. R4.\nG40 G01 Y-20.\n";
    for (tools, help) in [(table(), "larger arc"), (Tools::Radius(1e8), "tool table")] {
        let wrong = refusals(small, &tools);
        assert!(wrong[0].help.contains(help), "{wrong:?}");
    }
}

/// What is cut into and by which block.
#[test]
fn overcuts_name_both_blocks() {
    let pair = |wrong: &Diagnostic| {
        (wrong.place.line, wrong.also.iter().map(|also| also.line).collect::<Vec<_>>())
    };
    let found: Vec<_> = refusals(NECK, &table()).iter().map(pair).collect();
    // The neck's lower side and its upper one, each into the other.
    assert!(found.contains(&(6, vec![12])), "{found:?}");
    assert!(found.iter().all(|(line, also)| matches!(line, 6 | 12) && also.len() == 1));
    // Where it is not machined there is nothing to cut into.
    assert!(path(&NECK.replace("G01 Y11.5", "G00 Y11.5"), &table()).all(|step| step.is_ok()));
}

/// Two rooms of 20 mm and a neck of 3 mm between them, from inside: a cutter of 2 mm cuts into both its sides.
const NECK: &str = "G00 X10. Y10.\nG41 D1 G01 X0. F600\nY0.\nX20.\nY8.5\nX30.\nY0.\nX50.\nY20.\nX30.\nG01 Y11.5\nX20.\nY20.\nG01 X0.\nY10.\nG40 X10.\n";

/// Words that say again what is so change nothing, nor does G40 before anything was compensated.
#[test]
fn compensation_waits_for_a_line_in_the_plane() {
    let plain = moves(&square("", "G41 D1"), &table());
    let flat = |program: &str| -> Vec<_> {
        let moves = moves(program, &table());
        let moves = moves.into_iter().filter(|step| step.from[2] == step.to[2]);
        moves.map(|step| (step.role, step.from[..2].to_vec(), step.to[..2].to_vec())).collect()
    };
    let due: Vec<_> =
        plain.iter().map(|s| (s.role, s.from[..2].to_vec(), s.to[..2].to_vec())).collect();
    let square = square("", "G41 D1");
    for (from, to) in [
        ("G01 G41 D1 X0.", "G01 G41 D1\nG41 D1\nX0."),
        // Across the plane nothing is established and nothing cancelled.
        ("G01 G41 D1 X0.", "G41 D1\nZ2.\nG01 X0."),
        ("G40 X-30.", "G40\nZ9.\nX-30."),
    ] {
        assert!(square.contains(from));
        assert_eq!(flat(&square.replace(from, to)), due, "{to}");
    }
    let roles: Vec<_> =
        moves("G41 D1\nG40\nG01 X5 F1", &table()).iter().map(|step| step.role).collect();
    assert_eq!(roles, [Role::Feed]);
}

#[test]
fn changes_are_refused_before_and_after_the_contour_too() {
    let cancelled = "G00 X1\nG41 D1 X2\nX5.\nG40\nD2\nX9.";
    check_refused(
        &table(),
        &[
            ("G41 D1\nD2\nG40", 2, 1, "D2", "radius changes"),
            ("G41 D1\nG42\nG40", 2, 1, "G42", "the side changes"),
            (cancelled, 5, 1, "D2", "radius changes"),
            ("G00 X1\nG41 D1\nM02", 3, 1, "M02", "while the cutter is compensated"),
        ],
    );
}

/// A block with an error establishes and cancels as if it had none.
#[test]
fn an_error_while_compensated_leaves_no_false_ones_behind_it() {
    check_refused(
        &table(),
        &[
            ("G00 X-30.\nG41 D1 G01 X0. F1 Q1\nG02 X2. Y2. I2.\nG40 G01 X9.", 2, 19, "Q1", "Q1"),
            ("G00 X-30.\nG41 D1 G01 X0. F1\nX2.\nG40 X9. Q1\nM02", 4, 9, "Q1", "Q1"),
        ],
    );
}

/// The plunge of a contour is a rapid or a feed motion as it is programmed.
#[test]
fn plunges_keep_their_role() {
    let program = square("", "G41 D1").replace("X20.\nY0", "Z-5.\nX20.\nG00 Z3.\nG01 Y0");
    let moves = moves(&program, &table());
    let plunges: Vec<_> = moves
        .iter()
        .filter(|step| step.from[2] != step.to[2])
        .map(|step| (step.role, step.to))
        .collect();
    assert_eq!(plunges, [(Role::Feed, [-2.0, 22.0, -5.0]), (Role::Rapid, [22.0, 22.0, 3.0])]);
    // The rest belongs to its blocks, as without them.
    let contour: Vec<_> = moves
        .iter()
        .filter(|step| step.contour.is_some() || step.role == Role::Cancel)
        .map(|step| step.place.line)
        .collect();
    assert_eq!(contour, [3, 5, 7, 8, 9, 10]);
}

/// A cutter of 2 mm inside a circle of 20 mm about the origin, once round from (20,0) with this block.
fn bore(block: &str) -> String {
    format!("G00 X10.\nG41 D1 G01 X20. F600\n{block}\nG40 G01 X10. Y0.\n")
}

/// Whole turns, and arcs shorter than what a point is exact to.
#[test]
fn whole_turns_are_compensated_and_vanishing_arcs_do_not_become_some() {
    let whole = |program: &str| -> Vec<_> {
        let motions: Vec<_> = path(program, &table()).motions().collect::<Result<_, _>>().unwrap();
        let arcs = motions.into_iter().filter(|motion| motion.curve != Curve::Line);
        arcs.filter(|motion| motion.from == motion.to).map(|motion| motion.to).collect()
    };
    assert_eq!(whole(&bore("G03 I-20.")), [[1800, 0, 0]]);
    let moves = moves(&bore("G03 I-20."), &table());
    let round = &moves[2];
    assert_eq!((round.role, round.arc), (Role::Offset, Some(([0.0; 2], Direction::Ccw))));
    assert_eq!((round.from, round.to), ([18.0, 0.0, 0.0], [18.0, 0.0, 0.0]));
    // A picometre less than a turn is one, and a picometre is none.
    let arcs = |block: &str| -> usize {
        let (program, tools) = (bore(block), Tools::Radius(19.5));
        let motions = path(&program, &tools).motions().collect::<Result<Vec<_>, _>>().unwrap();
        motions.iter().filter(|motion| motion.curve != Curve::Line).count()
    };
    assert_eq!(arcs("G03 Y-0.000000001 I-20."), 1);
    assert_eq!(arcs("G03 Y0.000000001 I-20."), 0);
}

#[test]
fn arcs_by_their_radius_are_compensated_as_those_by_their_centre() {
    for (by_centre, by_radius) in [
        ("G03 X0. Y20. I-20.", "G03 X0. Y20. R20."),
        ("G03 X0. Y-20. I-20.", "G03 X0. Y-20. R-20."),
        ("G02 X0. Y20. J20.", "G02 X0. Y20. R20."),
    ] {
        let program =
            |arc: &str| format!("G00 X15. Y1.\nG41 D1 G01 X20. Y0. F1\n{arc}\nG40 G01 X2. Y3.\n");
        let [one, other] = [by_centre, by_radius].map(|arc| moves(&program(arc), &table()));
        assert_eq!(one.len(), other.len());
        for (one, other) in one.iter().zip(&other) {
            assert_eq!(
                (one.role, one.arc.map(|arc| arc.1)),
                (other.role, other.arc.map(|arc| arc.1))
            );
            for axis in 0..3 {
                assert!((one.to[axis] - other.to[axis]).abs() < 1e-9, "{by_radius}: {other:?}");
            }
        }
    }
    check_refused(
        &table(),
        &[(&bore("G03 X0. Y20. R9."), 3, 14, "R9.", "further away than this radius reaches")],
    );
}

/// The centre that is told of an arc by its radius: of radius 5 through (0,0) and (8,0).
#[test]
fn arcs_by_their_radius_tell_their_centre() {
    for (arc, centre) in [
        ("G03 X8. R5.", [4.0, 3.0]),
        ("G03 X8. R-5.", [4.0, -3.0]),
        ("G02 X8. R5.", [4.0, -3.0]),
        ("G02 X8. R-5.", [4.0, 3.0]),
    ] {
        let moves = moves(&format!("{arc} F1"), &Tools::Unknown);
        let (found, _) = moves[0].arc.unwrap();
        assert!((0..2).all(|axis| (found[axis] - centre[axis]).abs() < 1e-12), "{arc}: {found:?}");
    }
}

/// More than half a turn with radii that differ within the tolerance.
#[test]
fn long_arcs_off_their_circle_are_compensated_too() {
    let moves = moves(&bore("G03 X0. Y-20.004 I-20.").replace("X10. Y0.", "X0. Y-10."), &table());
    let arc = moves.iter().find(|step| step.arc.is_some()).unwrap();
    let (centre, _) = arc.arc.unwrap();
    let from = |[x, y]: [f64; 2]| (x - centre[0]).hypot(y - centre[1]);
    assert!((from([20.0, 0.0]) - from([0.0, -20.004])).abs() < 1e-9, "{centre:?}");
    assert!(centre[0].hypot(centre[1]) < 0.005, "{centre:?}");
}

/// 10 km away a float counts in two picometres: the end of the line that cancels is the programmed one all
/// the same, here less than half a pulse from 999999998.
#[test]
fn cancelling_ends_at_the_very_point() {
    let program = "G00 X9999990. Y10.\nG41 G01 Y20. F1\nX9999995.\nG40 X9999999.984999999 Y15.\n";
    let motions: Vec<_> =
        path(program, &Tools::Radius(2.0)).motions().collect::<Result<_, _>>().unwrap();
    assert_eq!(motions.last().unwrap().to, [999_999_998, 1500, 0]);
}

#[test]
fn tools_may_have_no_diameter() {
    let table = ToolTable::read("T1 D0\nT2 D0.000\n").unwrap();
    assert_eq!([1, 2].map(|tool| table.diameter(tool)), [Some("0".parse().unwrap()); 2]);
}

/// Along (1,1) two points 1.2 picometres apart may be one in whole picometres: the arc between them is nothing
/// all the same, and the other way round it is a whole turn.
#[test]
fn arcs_whose_ends_meet_in_whole_picometres_keep_their_turn() {
    for step in 0..40 {
        let tools = Tools::Radius(3.5 + 0.03 * f64::from(step));
        let arcs = |end: &str| -> usize {
            let program = format!(
                "G00 X-10. Y10.\nG41 G01 X0. Y0. F600\nG03 X{end} Y{end} I-20. J20.\nG40 G01 X-9. Y10.\n"
            );
            let motions = path(&program, &tools).motions().collect::<Result<Vec<_>, _>>().unwrap();
            motions.iter().filter(|motion| motion.curve != Curve::Line).count()
        };
        assert_eq!(arcs("0.000000001"), 0, "{tools:?}");
        assert_eq!(arcs("-0.000000001"), 1, "{tools:?}");
    }
}
