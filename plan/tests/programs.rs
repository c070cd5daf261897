//! What programs ask for, and how wrong ones are refused.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod promises;

use onepulse_core::Direction;
use onepulse_plan::centre_path::{CentrePath, Compensation, PathError, Step};
use onepulse_plan::gcode::{Program, ProgramError};
use onepulse_plan::{Curve, Diagnostic, Integers, Length, Machine, Motion, Place, Rate, Tools};
use proptest::prelude::*;

/// A hundredth of a millimetre a pulse; integers count pulses.
fn machine() -> Machine {
    Machine::with_pulse("0.01".parse().unwrap())
}

fn fine_machine() -> Machine {
    Machine::with_pulse("0.001".parse().unwrap())
}

fn machine_in_units() -> Machine {
    Machine { integers: Integers::Units, ..machine() }
}

/// The steps of a program whose cutters have a radius of a millimetre.
fn steps<'a>(
    program: &'a (impl AsRef<[u8]> + ?Sized),
    machine: &Machine,
) -> CentrePath<Program<&'a [u8]>> {
    let program = Program::new(program.as_ref(), machine, &Tools::Radius(1.0));
    CentrePath::new(program, machine, Compensation::default())
}

/// The motions of a step.
fn motions_of(step: Step) -> Vec<Motion> {
    match step {
        Step::Move(step) => step.motions().collect(),
        Step::Pause(_) => Vec::new(),
    }
}

fn motions(program: impl AsRef<[u8]>, machine: &Machine) -> Vec<Motion> {
    let steps: Vec<_> = steps(&program, machine).collect::<Result<_, _>>().unwrap();
    steps.into_iter().flat_map(motions_of).collect()
}

/// The errors of a program, which has some.
fn refusals(program: impl AsRef<[u8]>, machine: &Machine) -> Vec<Diagnostic> {
    let mut steps = steps(&program, machine);
    let error = steps.by_ref().find_map(Result::err).expect("the program is refused");
    assert!(steps.next().is_none(), "nothing comes after an error");
    match error {
        PathError::Program { wrong, .. } => wrong,
        PathError::Input(error) => panic!("{error}"),
    }
}

/// The error of a program, which has one.
fn refusal(program: impl AsRef<[u8]>, machine: &Machine) -> Diagnostic {
    let mut wrong = refusals(program, machine);
    assert_eq!(wrong.len(), 1, "{wrong:?}");
    wrong.remove(0)
}

/// A motion in one line of text: `2 ccw 5,0 0,5 about 0,0 F150`.
fn shown(motion: &Motion) -> String {
    let Motion { line, from: [x0, y0, z0], to: [x1, y1, z1], curve, rate } = motion;
    let ends = match (z0, z1) {
        (0, 0) => format!("{x0},{y0} {x1},{y1}"),
        _ => format!("{x0},{y0},{z0} {x1},{y1},{z1}"),
    };
    let curve = match curve {
        Curve::Line => format!("line {ends}"),
        Curve::Arc { centre: [x, y], direction: Direction::Cw, .. } => {
            format!("cw {ends} about {x},{y}")
        }
        Curve::Arc { centre: [x, y], direction: Direction::Ccw, .. } => {
            format!("ccw {ends} about {x},{y}")
        }
    };
    match rate {
        Rate::Rapid => format!("{line} {curve} rapid"),
        Rate::Feed(feed) => format!("{line} {curve} F{}", feed.millimetres()),
    }
}

/// Each program's motions are those listed under it.
fn check(machine: &Machine, cases: &[(&str, &[&str])]) {
    for (program, expected) in cases {
        let found: Vec<_> = motions(program, machine).iter().map(shown).collect();
        assert_eq!(found, *expected, "{program}");
    }
}

/// Each program is refused at a line and a column, with this text underlined and these words.
fn check_refused(machine: &Machine, cases: &[(&str, u32, usize, &str, &str)]) {
    for &(program, line, column, underlined, words) in cases {
        let diagnostic = refusal(program, machine);
        let place = (diagnostic.place.line, diagnostic.place.column());
        assert_eq!(place, (line, column), "{program}: {diagnostic}");
        assert_eq!(&diagnostic.place.text[diagnostic.place.span.clone()], underlined, "{program}");
        assert!(diagnostic.message.contains(words), "{program}: {diagnostic}");
        assert!(!diagnostic.help.is_empty(), "{program}");
        let source = program.lines().nth(line as usize - 1).unwrap();
        assert_eq!(&*diagnostic.place.text, source, "{program}");
    }
}

#[test]
fn textbook_blocks_have_no_blanks_and_count_pulses() {
    check(
        &machine(),
        &[
            (
                "N1G00X5Y0\nN2G03X0Y5I-5J0F150\nN3G01X-45000Y-75000F150\nN4M02\n",
                &[
                    "1 line 0,0 5,0 rapid",
                    "2 ccw 5,0 0,5 about 0,0 F150",
                    "3 line 0,5 -45000,-75000 F150",
                ],
            ),
            ("N3G01X-45000Y-75000F150", &["1 line 0,0 -45000,-75000 F150"]),
        ],
    );
}

#[test]
fn decimals_are_millimetres() {
    check(
        &machine(),
        &[
            ("G01 X10.5 Y-2.25 F300", &["1 line 0,0 1050,-225 F300"]),
            ("G01 X.5 Y+10. F.5", &["1 line 0,0 50,1000 F0.5"]),
            ("G01 X 1.5 Y -2. F 100", &["1 line 0,0 150,-200 F100"]),
            ("G01 X1.004 Y-1.004 F1", &["1 line 0,0 100,-100 F1"]),
            ("G01 X1.005 Y-1.005 F1", &["1 line 0,0 101,-101 F1"]),
            ("G1X5Y0.05F1", &["1 line 0,0 5,5 F1"]),
            ("G01 X1.00000000000000000 F1", &["1 line 0,0 100,0 F1"]),
        ],
    );
}

#[test]
fn units_switch_between_inches_and_millimetres() {
    check(
        &machine(),
        &[
            (
                "G20 G01 X1. F10\nG21 X25.4\nX30. F20\nG20 Y1.",
                &[
                    "1 line 0,0 2540,0 F254",
                    "3 line 2540,0 3000,0 F20",
                    "4 line 3000,0 3000,2540 F20",
                ],
            ),
            ("G20\nG01 X100 F1.", &["2 line 0,0 100,0 F25.4"]),
            // The unit of a block holds for all of it, wherever it stands.
            ("G01 X1. F1. G20", &["1 line 0,0 2540,0 F25.4"]),
        ],
    );
}

#[test]
fn distances_switch_between_absolute_and_incremental() {
    check(
        &machine(),
        &[(
            "G91 G01 F100\nX10 Y5\nX-3\nG90 X0 Y0\nX4\nG91 Y4\nG90 Y4",
            &[
                "2 line 0,0 10,5 F100",
                "3 line 10,5 7,5 F100",
                "4 line 7,5 0,0 F100",
                "5 line 0,0 4,0 F100",
                "6 line 4,0 4,4 F100",
            ],
        )],
    );
    // I and J count from the start in both modes.
    check(
        &machine(),
        &[(
            "G00 X10 Y10\nG91 G03 X-5 Y5 I-5 J0 F100",
            &["1 line 0,0 10,10 rapid", "2 ccw 10,10 5,15 about 5,10 F100"],
        )],
    );
}

#[test]
fn contours_may_begin_and_end_where_the_cutter_is_to_be() {
    // Established from the very point that is the radius away from the contour, and cancelled to one.
    check(
        &machine(),
        &[(
            "G00 X-1.\nG41 G01 X0 F100\nY10.\nG40 X-1.\nX0",
            &[
                "1 line 0,0 -100,0 rapid",
                "3 line -100,0 -100,1000 F100",
                "5 line -100,1000 0,1000 F100",
            ],
        )],
    );
    // The contour's end, r/√2 = 0.7071067811… mm to the left and up, is less than a picometre from that of G40,
    // but in another pulse.
    check(
        &Machine::with_pulse(Length::from_picometres(1)),
        &[(
            "G00 X-0.3 Y-0.3\nG41 G01 X0 Y0 F100\nX0.3 Y0.3\nG40 X-0.407106782 Y1.007106781\nG00 X0",
            &[
                "1 line 0,0 -300000000,-300000000 rapid",
                "2 line -300000000,-300000000 -707106781,707106781 F100",
                "3 line -707106781,707106781 -407106781,1007106781 F100",
                "4 line -407106781,1007106781 -407106782,1007106781 F100",
                "5 line -407106782,1007106781 0,1007106781 rapid",
            ],
        )],
    );
}

#[test]
fn increments_of_a_part_of_a_pulse_add_up_without_error() {
    for (step, count, end) in [
        ("X0.003", 1000, [300, 0]),
        ("X-0.003Y0.0049", 1000, [-300, 490]),
        ("X0.0033", 3000, [990, 0]),
        ("Y-0.000000001", 10_000, [0, 0]),
    ] {
        let program = format!("G91 G01 F100\n{}", format!("{step}\n").repeat(count));
        let motions = motions(&program, &machine());
        let last = motions.last().map_or([0; 3], |motion| motion.to);
        assert_eq!(last, [end[0], end[1], 0], "{step}");
        for pair in motions.windows(2) {
            assert_eq!(pair[0].to, pair[1].from, "{step}");
        }
    }
}

#[test]
fn increments_of_a_part_of_an_inch_add_up_without_error() {
    // 1250 times 0.0001 inch are 3.175 mm: 317.5 pulses.
    let program = format!("G20 G91 G01 F1.\n{}", "X0.0001\n".repeat(1250));
    assert_eq!(motions(&program, &machine()).last().unwrap().to, [318, 0, 0]);
}

#[test]
fn integers_can_count_units() {
    check(
        &machine_in_units(),
        &[
            ("G01 X5 Y-2 F100", &["1 line 0,0 500,-200 F100"]),
            ("G20 G01 X1 F1", &["1 line 0,0 2540,0 F25.4"]),
            ("G02 X10 Y10 I10 J0 F1", &["1 cw 0,0 1000,1000 about 1000,0 F1"]),
            ("G02 X10 Y10 R10 F1", &["1 cw 0,0 1000,1000 about 1000,0 F1"]),
        ],
    );
}

#[test]
fn feeds_are_in_units_whatever_integers_count() {
    check(&machine(), &[("G01 X5 F100", &["1 line 0,0 5,0 F100"])]);
    check(&machine_in_units(), &[("G01 X5 F100", &["1 line 0,0 500,0 F100"])]);
}

#[test]
fn lower_case_is_as_good() {
    check(
        &machine(),
        &[(
            "n1g91g21g01x5y3f100\ng03x-5y5i-5j0\nm30",
            &["1 line 0,0 5,3 F100", "2 ccw 5,3 0,8 about 0,3 F100"],
        )],
    );
}

#[test]
fn comments_tape_marks_and_empty_lines_are_passed_over() {
    check(
        &machine(),
        &[
            ("%\nG01 X5 F100\n%\n", &["2 line 0,0 5,0 F100"]),
            (" % \n\n \t\nG01 X5 F100", &["4 line 0,0 5,0 F100"]),
            ("(first)(second)\n;Q9\nG01 X5 F100", &["3 line 0,0 5,0 F100"]),
            ("G01 (to Q9) X5(;)Y3 F100 ; X9 (", &["1 line 0,0 5,3 F100"]),
            ("G01 X5 (直线) Y3 F100 ; 完", &["1 line 0,0 5,3 F100"]),
        ],
    );
}

#[test]
fn line_numbers_may_have_any_order() {
    check(
        &machine(),
        &[(
            "N10 G01 X5 F100\nN5 X6\nN5 X7\nN0\nN0010X8",
            &[
                "1 line 0,0 5,0 F100",
                "2 line 5,0 6,0 F100",
                "3 line 6,0 7,0 F100",
                "5 line 7,0 8,0 F100",
            ],
        )],
    );
}

#[test]
fn motion_mode_and_feed_stay() {
    check(
        &machine(),
        &[
            (
                "G01 X5 F100\nY3\nG00\nX0 Y0\nG01\nX1\nF200\nX2",
                &[
                    "1 line 0,0 5,0 F100",
                    "2 line 5,0 5,3 F100",
                    "4 line 5,3 0,0 rapid",
                    "6 line 0,0 1,0 F100",
                    "8 line 1,0 2,0 F200",
                ],
            ),
            (
                "G00 X5\nG03 X0 Y5 I-5 F100\nX-5 Y0 J-5\nI5",
                &[
                    "1 line 0,0 5,0 rapid",
                    "2 ccw 5,0 0,5 about 0,0 F100",
                    "3 ccw 0,5 -5,0 about 0,0 F100",
                    "4 ccw -5,0 -5,0 about 0,0 F100",
                ],
            ),
            ("F100\nX5 G01", &["2 line 0,0 5,0 F100"]),
        ],
    );
}

#[test]
fn rapid_motions_need_no_feed_and_keep_it() {
    check(&machine(), &[("G00 X5 F50\nG01 X6", &["1 line 0,0 5,0 rapid", "2 line 5,0 6,0 F50"])]);
}

#[test]
fn arcs_whose_ends_are_equal_are_full_circles() {
    check(
        &machine(),
        &[
            ("G00 X5\nG02 I-5 F100", &["1 line 0,0 5,0 rapid", "2 cw 5,0 5,0 about 0,0 F100"]),
            (
                "G00 X5\nG03 X5 Y0 I-5 J0 F100",
                &["1 line 0,0 5,0 rapid", "2 ccw 5,0 5,0 about 0,0 F100"],
            ),
            ("G03 J-3. F100", &["1 ccw 0,0 0,0 about 0,-300 F100"]),
            ("G91 G02 X0 Y0 I3 J4 F100", &["1 cw 0,0 0,0 about 3,4 F100"]),
        ],
    );
}

#[test]
fn arcs_by_radius_have_the_centre_that_their_sign_asks_for() {
    // The circles of radius 5 through (0,0) and (8,0) are about (4,3) and (4,-3). A short
    // counter-clockwise arc keeps its centre on the left.
    check(
        &machine(),
        &[
            ("G03 X8 Y0 R5 F1", &["1 ccw 0,0 8,0 about 4,3 F1"]),
            ("G03 X8 Y0 R-5 F1", &["1 ccw 0,0 8,0 about 4,-3 F1"]),
            ("G02 X8 Y0 R5 F1", &["1 cw 0,0 8,0 about 4,-3 F1"]),
            ("G02 X8 Y0 R-5 F1", &["1 cw 0,0 8,0 about 4,3 F1"]),
            ("G03 X-8 Y0 R5 F1", &["1 ccw 0,0 -8,0 about -4,-3 F1"]),
            ("G02 X0 Y8 R5 F1", &["1 cw 0,0 0,8 about 3,4 F1"]),
        ],
    );
    // Quarter and three-quarter circles of radius 5 from (5,0) to (0,5).
    for (arc, centre) in [
        ("G03 X0 Y5 R5", "ccw 5,0 0,5 about 0,0"),
        ("G03 X0 Y5 R-5", "ccw 5,0 0,5 about 5,5"),
        ("G02 X0 Y5 R5", "cw 5,0 0,5 about 5,5"),
        ("G02 X0 Y5 R-5", "cw 5,0 0,5 about 0,0"),
    ] {
        let program = format!("G00 X5\n{arc} F1");
        let expected = format!("2 {centre} F1");
        check(&machine(), &[(&program, &["1 line 0,0 5,0 rapid", &expected])]);
    }
    // Half circles, either way and with either sign; the centre of radius 7 over a chord of 10
    // lies √24 = 4.9 away from it; in millimetres, 4.899 away.
    check(
        &machine(),
        &[
            ("G03 X10 Y0 R5 F1", &["1 ccw 0,0 10,0 about 5,0 F1"]),
            ("G02 X10 Y0 R-5 F1", &["1 cw 0,0 10,0 about 5,0 F1"]),
            ("G03 X10 Y0 R7 F1", &["1 ccw 0,0 10,0 about 5,5 F1"]),
            ("G03 X10. Y0. R7. F1", &["1 ccw 0,0 1000,0 about 500,490 F1"]),
        ],
    );
}

#[test]
fn a_radius_a_little_short_of_half_the_chord_makes_half_a_circle() {
    check(&machine(), &[("G03 X10. Y0. R4.995 F1", &["1 ccw 0,0 1000,0 about 500,0 F1"])]);
}

#[test]
fn arcs_that_end_a_little_off_their_circle_are_accepted() {
    check(
        &machine(),
        &[
            (
                "G00 X5. Y0.\nG03 X0. Y5.015 I-5. J0. F100",
                &["1 line 0,0 500,0 rapid", "2 ccw 500,0 0,502 about 0,0 F100"],
            ),
            (
                "G00 X5. Y0.\nG02 X0. Y-4.985 I-5. J0. F100",
                &["1 line 0,0 500,0 rapid", "2 cw 500,0 0,-499 about 0,0 F100"],
            ),
        ],
    );
    check(
        &fine_machine(),
        &[(
            "G00 X5. Y0.\nG03 X0. Y5.004 I-5. J0. F100",
            &["1 line 0,0 5000,0 rapid", "2 ccw 5000,0 0,5004 about 0,0 F100"],
        )],
    );
}

#[test]
fn arcs_that_end_off_their_circle_are_refused() {
    let words = "radius is 5.030000 mm, the start's 5.000000 mm";
    check_refused(
        &machine(),
        &[(
            "G00 X5. Y0.\n G03 X0. Y5.03 I-5. J0. F100 (arc)",
            2,
            2,
            "G03 X0. Y5.03 I-5. J0. F100",
            words,
        )],
    );
    // The tolerance is exact, outward and inward: two pulses.
    for (within, beyond) in [("5.02", "5.020000001"), ("4.98", "4.979999999")] {
        let program = |y: &str| format!("G00 X5. Y0.\nG03 X0. Y{y} I-5. J0. F100");
        assert_eq!(motions(program(within), &machine()).len(), 2);
        assert!(refusal(program(beyond), &machine()).message.contains("off the circle"));
    }
    let text = "G03 X0. Y5.006 I-5. J0. F100";
    let program = format!("G00 X5. Y0.\n{text}");
    check_refused(&fine_machine(), &[(&program, 2, 1, text, "off the circle")]);
}

#[test]
fn arcs_that_rounding_would_turn_into_a_full_circle_are_lines() {
    check(
        &machine(),
        &[
            // Less than half a pulse: nothing.
            ("G00 X10.\nG03 Y0.004 I-10. F1", &["1 line 0,0 1000,0 rapid"]),
            ("G00 X10.\nG02 Y-0.004 I-10. F1", &["1 line 0,0 1000,0 rapid"]),
            ("G00 X10.\nG03 Y0.004 R10. F1", &["1 line 0,0 1000,0 rapid"]),
            // Both ends come to lie on the x axis, a pulse apart.
            (
                "G00 X10.\nG03 X10.006 Y0.004 I-10. F1",
                &["1 line 0,0 1000,0 rapid", "2 line 1000,0 1001,0 F1"],
            ),
            // The end comes to lie behind the start.
            (
                "G00 X10. Y0.1\nG03 X10.015 Y0.104 I-10. J-0.1 F1",
                &["1 line 0,0 1000,10 rapid", "2 line 1000,10 1002,10 F1"],
            ),
        ],
    );
}

#[test]
fn arcs_of_nearly_a_full_circle_keep_their_turn() {
    check(
        &machine(),
        &[
            (
                "G00 X10.\nG03 Y-0.004 I-10. F1",
                &["1 line 0,0 1000,0 rapid", "2 ccw 1000,0 1000,0 about 0,0 F1"],
            ),
            (
                "G00 X10.\nG02 Y0.004 I-10. F1",
                &["1 line 0,0 1000,0 rapid", "2 cw 1000,0 1000,0 about 0,0 F1"],
            ),
            (
                "G00 X10.\nG03 Y0.004 R-10. F1",
                &["1 line 0,0 1000,0 rapid", "2 ccw 1000,0 1000,0 about 2000,0 F1"],
            ),
            (
                "G00 X10.\nG03 Y-0.02 I-10. F1",
                &["1 line 0,0 1000,0 rapid", "2 ccw 1000,0 1000,-2 about 0,0 F1"],
            ),
            // The end comes to lie ahead of the start: a turn, and a line for what is missing.
            (
                "G00 X10.015 Y0.104\nG03 X10. Y0.1 I-10.015 J-0.104 F1",
                &[
                    "1 line 0,0 1002,10 rapid",
                    "2 ccw 1002,10 1002,10 about 0,0 F1",
                    "2 line 1002,10 1000,10 F1",
                ],
            ),
        ],
    );
}

#[test]
fn circles_smaller_than_a_pulse_are_lines_at_most() {
    check(
        &machine(),
        &[
            ("G02 I0.001 F1\nG01 X5", &["2 line 0,0 5,0 F1"]),
            ("G03 X0.01 I0.005 F1", &["1 line 0,0 1,0 F1"]),
            // Half a turn, of which rounding makes less.
            ("G03 X0.03 Y0.01 I0.015 J0.005 F1", &["1 ccw 0,0 3,1 about 2,1 F1"]),
        ],
    );
}

#[test]
fn motions_that_round_to_nothing_are_left_out() {
    check(
        &machine(),
        &[
            ("G01 X0.004 F100", &[]),
            ("G01 X0.004 F100\nX0.005", &["2 line 0,0 1,0 F100"]),
            ("G01 X0 Y0 F100\nG00 X0", &[]),
            ("", &[]),
            ("G90 G21 G17\nF100\nG01", &[]),
        ],
    );
}

#[test]
fn a_program_ends_with_m02_or_m30_whatever_follows() {
    for end in ["M02", "M2", "M30", "m30", "N9 M02 (end)"] {
        let program = format!("G01 X5 F100\n{end}\nX6\nQ?!(\n");
        check(&machine(), &[(&program, &["1 line 0,0 5,0 F100"])]);
    }
    check(
        &machine(),
        &[
            ("G01 X5 F100 M30\nX6", &["1 line 0,0 5,0 F100"]),
            ("M02 G01 X5 F100\n#", &["1 line 0,0 5,0 F100"]),
        ],
    );
    let garbage = b"G01 X5 F100\nM02\n\xff\xfe\x00".as_slice();
    assert_eq!(motions(garbage, &machine()).len(), 1);
}

#[test]
fn a_program_may_end_without_m02_and_without_a_line_end() {
    check(
        &machine(),
        &[
            ("G01 X5 F100\nX6", &["1 line 0,0 5,0 F100", "2 line 5,0 6,0 F100"]),
            ("G01 X5 F100\nX6\n", &["1 line 0,0 5,0 F100", "2 line 5,0 6,0 F100"]),
        ],
    );
}

#[test]
fn line_ends_may_be_those_of_windows() {
    check(
        &machine(),
        &[(
            "%\r\nG01 X5 F100 (a)\r\n\r\nX6 ; b\r\nM02\r\nQ\r\n",
            &["2 line 0,0 5,0 F100", "4 line 5,0 6,0 F100"],
        )],
    );
    check_refused(&machine(), &[("G01 X5 F100\r\nX\r\n", 2, 1, "X", "not followed by a number")]);
}

#[test]
fn long_lines_are_read_and_endless_ones_refused() {
    let comment = format!("G01 X5 F100 ({})", "x".repeat(4000));
    check(&machine(), &[(&comment, &["1 line 0,0 5,0 F100"])]);
    // The longest there is, with a line end and without.
    let longest = format!("G01 X5 F100{}", " ".repeat(4096 - 11));
    for program in [longest.clone(), format!("{longest}\nM02")] {
        check(&machine(), &[(&program, &["1 line 0,0 5,0 F100"])]);
    }
    assert!(refusal(longest + " ", &machine()).message.contains("4096 bytes"));
    for filler in [" ", "x", "圆", "X5"] {
        let program = format!("G01 X5 F100\n{}\nX6", filler.repeat(100_000));
        let diagnostic = refusal(&program, &machine());
        assert_eq!((diagnostic.place.line, diagnostic.place.column()), (2, 1));
        assert!(diagnostic.message.contains("4096 bytes"), "{diagnostic}");
        assert!(diagnostic.place.text.len() < 20_000, "an endless line is not kept whole");
    }
}

#[test]
fn bytes_that_are_no_text_are_refused_outside_comments() {
    let comment = b"(\xff\xfe) G01 X5 F100 ; \xff".as_slice();
    assert_eq!(motions(comment, &machine()).len(), 1);
    let diagnostic = refusal(b"G00 X1\nG01 X5 \xff F100".as_slice(), &machine());
    assert_eq!((diagnostic.place.line, diagnostic.place.column()), (2, 8));
    assert_eq!(&diagnostic.place.text[diagnostic.place.span.clone()], "\u{fffd}");
    assert!(diagnostic.message.contains("does not begin a word"), "{}", diagnostic.message);
}

#[test]
fn words_that_are_not_supported_are_named() {
    for (block, column, word) in [
        ("G01 X5 Q5 F100", 8, "Q5"),
        ("O1000", 1, "O1000"),
        ("G01 A5 F100", 5, "A5"),
        ("G01 X5 w -5 F100", 8, "w -5"),
        ("H3", 1, "H3"),
        ("M06", 1, "M06"),
        ("M03", 1, "M03"),
        ("M01", 1, "M01"),
        ("M2.5", 1, "M2.5"),
        ("G43", 1, "G43"),
        ("G54", 1, "G54"),
        ("G81", 1, "G81"),
        ("G1.5", 1, "G1.5"),
        ("G41.1", 1, "G41.1"),
        ("G-1", 1, "G-1"),
        ("G99999999999", 1, "G99999999999"),
        ("F1E3", 3, "E3"),
    ] {
        let program = format!("G00 X1\n{block}\n");
        let words = format!("{} is not supported", word.replace(' ', "").to_uppercase());
        check_refused(&machine(), &[(&program, 2, column, word, &words)]);
    }
}

#[test]
fn a_second_word_of_a_kind_is_refused() {
    check_refused(
        &machine(),
        &[
            ("G01 X5 X6 F100", 1, 8, "X6", "a second X in one block"),
            ("G01 X5 Y1 y1 F100", 1, 11, "y1", "a second Y in one block"),
            ("G02 I5 I5 F100", 1, 8, "I5", "a second I in one block"),
            ("G02 J5 J5 F100", 1, 8, "J5", "a second J in one block"),
            ("G02 X5 R5 R6 F100", 1, 11, "R6", "a second R in one block"),
            ("F100 F100", 1, 6, "F100", "a second F in one block"),
            ("G00 G01 X5", 1, 5, "G01", "a second motion mode"),
            ("G01 X5 G01 F100", 1, 8, "G01", "a second motion mode"),
            ("G90 G91", 1, 5, "G91", "a second distance mode"),
            ("G20 G21", 1, 5, "G21", "a second unit"),
            ("G17 G17", 1, 5, "G17", "a second plane"),
            ("G17 G18", 1, 5, "G18", "a second plane"),
            ("G40 G41", 1, 5, "G41", "a second cutter radius compensation"),
            ("G04 G04 P1", 1, 5, "G04", "a second dwell"),
            ("Z1 Z1 G00", 1, 4, "Z1", "a second Z in one block"),
            ("S1 S2", 1, 4, "S2", "a second S in one block"),
            ("M00 M30", 1, 5, "M30", "a second stop or end of program"),
            ("M02 M30", 1, 5, "M30", "a second stop or end of program"),
        ],
    );
}

#[test]
fn line_numbers_are_whole_and_come_first() {
    check_refused(
        &machine(),
        &[
            ("G01 N5 X1 F100", 1, 5, "N5", "middle of a block"),
            ("N5 N6", 1, 4, "N6", "middle of a block"),
            ("N10.5 G00 X5", 1, 1, "N10.5", "whole number"),
            ("N10. G00 X5", 1, 1, "N10.", "whole number"),
            ("N-10 G00 X5", 1, 1, "N-10", "whole number"),
        ],
    );
}

#[test]
fn letters_without_a_number_are_refused() {
    check_refused(
        &machine(),
        &[
            ("G01 X", 1, 5, "X", "X is not followed by a number"),
            ("G01 X-", 1, 5, "X-", "X is not followed by a number"),
            ("G01 X. F100", 1, 5, "X.", "X is not followed by a number"),
            ("G01 XY5", 1, 5, "X", "X is not followed by a number"),
            ("g", 1, 1, "g", "is not followed by a number"),
            ("G01 X--5", 1, 5, "X-", "X is not followed by a number"),
            ("G01 X(five)", 1, 5, "X", "X is not followed by a number"),
        ],
    );
}

#[test]
fn a_missing_number_is_underlined_without_the_blanks_behind_it() {
    check_refused(
        &machine(),
        &[
            ("G X5", 1, 1, "G", "G is not followed by a number"),
            ("N G01", 1, 1, "N", "N is not followed by a number"),
            ("G01 X  Y5 F100", 1, 5, "X", "X is not followed by a number"),
        ],
    );
}

#[test]
fn characters_that_begin_no_word_are_refused() {
    check_refused(
        &machine(),
        &[
            ("#100=5", 1, 1, "#", "'#' does not begin a word"),
            ("#1;Q5", 1, 1, "#", "'#' does not begin a word"),
            ("#1(Q5)", 1, 1, "#", "'#' does not begin a word"),
            ("G01 5", 1, 5, "5", "'5' does not begin a word"),
            ("G01 X1.2.3", 1, 9, ".", "'.' does not begin a word"),
            ("G01 X5) F100", 1, 7, ")", "')' does not begin a word"),
            ("G01 % X5", 1, 5, "%", "'%' does not begin a word"),
            ("% X5", 1, 1, "%", "'%' does not begin a word"),
            ("G00 /X5", 1, 5, "/", "'/' does not begin a word"),
            ("(圆弧) G01 é5", 1, 10, "é", "does not begin a word"),
            ("X5 Ｘ6", 1, 4, "Ｘ", "does not begin a word"),
        ],
    );
}

#[test]
fn columns_count_characters() {
    check_refused(&machine(), &[("G00 X1\n(圆弧) G01 Q5", 2, 10, "Q5", "Q5 is not supported")]);
}

#[test]
fn comments_close_on_their_line_and_do_not_nest() {
    check_refused(
        &machine(),
        &[
            ("F1 G01 (open\nX5", 1, 8, "(open", "this comment is not closed"),
            ("G01 (", 1, 5, "(", "this comment is not closed"),
            ("(outer (inner))", 1, 8, "(", "a comment inside a comment"),
        ],
    );
}

#[test]
fn motions_need_a_mode_and_a_feed() {
    check_refused(
        &machine(),
        &[
            ("X5", 1, 1, "X5", "before any motion mode"),
            ("G90 G21\nF100 Y5 (far)", 2, 1, "F100 Y5", "before any motion mode"),
            ("X5\nX6", 1, 1, "X5", "before any motion mode"),
            ("G01 X5\nX6", 1, 1, "G01 X5", "before any feed rate"),
            ("I5", 1, 1, "I5", "before any motion mode"),
            ("G01 X5", 1, 1, "G01 X5", "before any feed rate"),
            ("G00 X5\n  G02 X5 Y5 J5", 2, 3, "G02 X5 Y5 J5", "before any feed rate"),
        ],
    );
}

#[test]
fn feeds_are_more_than_zero() {
    check_refused(
        &machine(),
        &[
            ("G01 X5 F0", 1, 8, "F0", "a feed rate is more than zero"),
            ("F-100", 1, 1, "F-100", "a feed rate is more than zero"),
            ("G00 X5 F0.0", 1, 8, "F0.0", "a feed rate is more than zero"),
        ],
    );
}

#[test]
fn centres_and_radii_belong_to_arcs_and_do_not_mix() {
    check_refused(
        &machine(),
        &[
            ("G02 X5 Y5 I5 R5 F1", 1, 11, "I5", "both a radius and a centre"),
            ("G03 X5 Y5 R5 J5 F1", 1, 14, "J5", "both a radius and a centre"),
            ("G01 X5 I5 F1", 1, 8, "I5", "belong to arcs"),
            ("G00 X5 J5", 1, 8, "J5", "belong to arcs"),
            ("G01 X5 R5 F1", 1, 8, "R5", "belong to arcs"),
            ("G01 R5 F1", 1, 5, "R5", "belong to arcs"),
            ("G01 X5 R5 I5 F1", 1, 8, "R5", "belong to arcs"),
            ("F1 G02 X5 Y5", 1, 1, "F1 G02 X5 Y5", "an arc without a centre"),
            ("G00 X5 F1\nG02", 2, 1, "G02", "an arc without end point and centre"),
        ],
    );
}

#[test]
fn radii_must_lead_to_one_circle() {
    check_refused(
        &machine(),
        &[
            ("G02 X0 Y0 R5 F1", 1, 11, "R5", "ends where it starts"),
            ("G02 R5 F1", 1, 5, "R5", "ends where it starts"),
            ("G02 X20. Y0 R5. F1", 1, 13, "R5.", "further away than this radius reaches"),
            ("G03 X0 Y-20. R-5. F1", 1, 14, "R-5.", "further away than this radius reaches"),
            ("G03 X10. R0 F1", 1, 10, "R0", "further away than this radius reaches"),
        ],
    );
}

#[test]
fn numbers_have_limits() {
    check_refused(
        &machine(),
        &[
            ("G01 X12345678901234567890 F1", 1, 5, "X12345678901234567890", "too many digits"),
            ("G01 X-1.2345678901234567891 F1", 1, 5, "X-1.2345678901234567891", "too many"),
            ("G01 X0.0000000001 F1", 1, 5, "X0.0000000001", "finer than a picometre"),
            ("G01 X99999999999999. F1", 1, 5, "X99999999999999.", "longer than 9 million metres"),
            ("G01 X5 F99999999999999", 1, 8, "F99999999999999", "longer than 9 million metres"),
        ],
    );
}

#[test]
fn coordinates_have_limits() {
    let widest = i32::MAX / 2;
    check(
        &machine(),
        &[("G01 X1073741823 Y-1073741823 F1", &["1 line 0,0 1073741823,-1073741823 F1"])],
    );
    let words = format!("further than {widest} pulses away");
    check_refused(
        &machine(),
        &[
            ("G01 X1073741824 F1", 1, 1, "G01 X1073741824 F1", &words),
            ("G91 G01 Y-1073741823 F1\nY-1", 2, 1, "Y-1", &words),
            ("G00 X10737418.24", 1, 1, "G00 X10737418.24", &words),
            ("G03 X10 Y0 I3000000000 F1", 1, 1, "G03 X10 Y0 I3000000000 F1", "off the circle"),
            ("G03 I3000000000 F1", 1, 1, "G03 I3000000000 F1", &words),
            ("G03 X10 R3000000000 F1", 1, 1, "G03 X10 R3000000000 F1", &words),
        ],
    );
    let circle = "G03 I-2000000000 J-2000000000 F1";
    let program = format!("G00 X1000000000 Y1000000000\n{circle}");
    check_refused(&machine(), &[(&program, 2, 1, circle, "a radius over 2147483647 pulses")]);
}

#[test]
fn a_later_error_leaves_the_motions_before_it() {
    let mut steps = steps("G01 X5 F100\nX6\nX\nX7", &machine());
    let mut places = Vec::new();
    while let Some(Ok(Step::Move(step))) = steps.next() {
        places.push((step.place.line, step.place.text.to_string()));
    }
    assert_eq!(places, [(1, "G01 X5 F100".to_owned()), (2, "X6".to_owned())]);
    assert!(steps.next().is_none());
}

/// All errors of a program: its lines, columns and what is underlined.
fn all_refused(program: &str) -> Vec<(u32, usize, String)> {
    let shown = |diagnostic: Diagnostic| {
        let Place { line, text, span } = &diagnostic.place;
        (*line, diagnostic.place.column(), text[span.clone()].to_owned())
    };
    refusals(program, &machine()).into_iter().map(shown).collect()
}

#[test]
fn all_that_is_wrong_is_found_in_one_pass() {
    let program =
        "G01 X5 Q5 H1\nG01 Y\nX6 Y7 # F0\n\nG54\nG02 X50 I1\nG02 X6 Y8 R9\nG00 X1\nG00 G01\n";
    let found = all_refused(program);
    let expected = [
        (1, 8, "Q5"),
        (1, 11, "H1"),
        (2, 5, "Y"),
        (3, 7, "#"),
        (3, 9, "F0"),
        (5, 1, "G54"),
        (6, 1, "G02 X50 I1"),
        (7, 11, "R9"),
        (9, 5, "G01"),
    ];
    let expected: Vec<_> = expected.map(|(line, column, text)| (line, column, text.into())).into();
    assert_eq!(found, expected);
}

#[test]
fn an_error_leaves_no_false_ones_behind_it() {
    // The mode, the feed and the end point of a faulty block hold for the blocks after it.
    assert_eq!(all_refused("G01 X10 Y0 F100 Q5\nG03 X0 Y10 I-10\nG01 X5"), [(1, 17, "Q5".into())]);
    // Where a faulty block went is not known: no arc can be held against it.
    assert_eq!(all_refused("G01 X5. Y F100\nG03 X0 Y10 I-10"), [(1, 9, "Y".into())]);
    assert_eq!(all_refused("G01 X Y5. F100\nG03 X0 Y10 I-10"), [(1, 5, "X".into())]);
    // Nor after an increment from there.
    let found = all_refused("G01 X5. Y F100\nG91 Y1\nG90 G03 X0 Y10 I-10");
    assert_eq!(found, [(1, 9, "Y".into())]);
    let found = all_refused("G01 X5. Y0.0000000001 F100\nG03 X0 Y10 I-10");
    assert_eq!(found, [(1, 9, "Y0.0000000001".into())]);
    let found = all_refused("G01 X5. Y F100\nX10 Y0\nG03 X0 Y15 I-10");
    assert_eq!(found, [(1, 9, "Y".into()), (3, 1, "G03 X0 Y15 I-10".into())]);
}

#[test]
fn errors_are_told_up_to_a_number() {
    let found = all_refused(&"G54\n".repeat(1000));
    assert_eq!(found.len(), 20);
    // In one line as well, and without the path of the cutter's centre.
    let line = "Q1 ".repeat(30);
    let mut program = Program::new(line.as_bytes(), &machine(), &Tools::Unknown);
    let Some(Err(ProgramError::Program(wrong))) = program.next() else { panic!() };
    assert_eq!(wrong.len(), 20);
}

/// A wrong word of a block hides nothing of its motion, nor does the motion's first error its place.
#[test]
fn all_that_is_wrong_with_a_block_is_found() {
    let found = all_refused("G02 X50 I1 F0");
    assert_eq!(found, [(1, 12, "F0".into()), (1, 1, "G02 X50 I1 F0".into())]);
    assert_eq!(all_refused("G00 X0.0000000001 Y0.0000000001")[0], (1, 5, "X0.0000000001".into()));
}

#[test]
fn what_is_not_supported_is_explained() {
    for (block, words) in [
        ("A1", "three axes"),
        ("W1", "three axes"),
        ("M06", "coolant"),
        ("H1", "tool length"),
        ("G43", "tool length"),
        ("G81", "no cycles"),
        ("G54", "supported are G00"),
    ] {
        let help = refusal(block, &machine()).help;
        assert!(help.contains(words), "{block}: {help}");
    }
}

/// Programs that look like programs, and so get further than arbitrary bytes do.
fn nearly_programs() -> impl Strategy<Value = String> {
    let number = prop_oneof![
        "-?[0-9]{1,4}",
        "-?[0-9]{0,3}\\.[0-9]{1,4}",
        Just("99999999999".to_owned()),
        Just(String::new()),
    ];
    let word = prop_oneof![
        3 => Just("G00".to_owned()),
        3 => Just("G01".to_owned()),
        3 => Just("G02".to_owned()),
        3 => Just("G03".to_owned()),
        1 => "(G41|G42|G40|G18|G19|G04|M00|D1|/|G20|G21|G90|G91|G17|M02|F100|N5|%|\\(圆\\)|;é|\r)".prop_map(|text| text),
        8 => ("[XYZIJKRP]", number).prop_map(|(letter, number)| letter + &number),
    ];
    let block = prop::collection::vec(word, 0..6).prop_map(|words| words.join(" "));
    prop::collection::vec(block, 0..8).prop_map(|blocks| format!("F1\n{}", blocks.join("\n")))
}

/// An arc in thousandths of a millimetre, whose start and end nearly meet.
#[derive(Clone, Copy, Debug)]
struct TinyArc {
    direction: Direction,
    centre: [i32; 2],
    end: [i32; 2],
}

fn tiny_arcs() -> impl Strategy<Value = TinyArc> {
    let thousandths = |limit: i32| [-limit..=limit, -limit..=limit];
    (any::<bool>(), thousandths(20_000), thousandths(60)).prop_map(|(is_ccw, centre, end)| {
        let direction = if is_ccw { Direction::Ccw } else { Direction::Cw };
        TinyArc { direction, centre, end }
    })
}

impl TinyArc {
    fn program(self) -> String {
        let g = if self.direction == Direction::Ccw { "G03" } else { "G02" };
        let [i, j, x, y] = [self.centre[0], self.centre[1], self.end[0], self.end[1]]
            .map(|thousandths| f64::from(thousandths) / 1000.0);
        format!("G91 F1\n{g} X{x:.3} Y{y:.3} I{i:.3} J{j:.3}")
    }
}

/// The angle from a point to another about the origin, more than 0 and at most a turn.
fn turn([x0, y0]: [i64; 2], [x1, y1]: [i64; 2], direction: Direction) -> f64 {
    let cross = (x0 * y1 - y0 * x1) * if direction == Direction::Ccw { 1 } else { -1 };
    let dot = x0 * x1 + y0 * y1;
    match (cross as f64).atan2(dot as f64) {
        angle if angle > 0.0 => angle,
        angle => angle + std::f64::consts::TAU,
    }
}

/// Runs a program to its end and checks what holds of every one.
fn check_any(text: &[u8], machine: &Machine) {
    let tools = Tools::Radius(1.0);
    promises::program::check(text, machine, &tools);
    promises::path::check(text, machine, &tools, Compensation::default());
}

fn any_machine() -> impl Strategy<Value = Machine> {
    let pulse = prop_oneof![Just(1), Just(7), Just(1000), Just(10_000_000), Just(i64::MAX)];
    (pulse, any::<bool>()).prop_map(|(pulse, is_units)| Machine {
        integers: if is_units { Integers::Units } else { Integers::Pulses },
        ..Machine::with_pulse(Length::from_picometres(pulse))
    })
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 2000,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn arbitrary_bytes_never_panic_and_always_end(
        program in prop::collection::vec(any::<u8>(), 0..300),
        machine in any_machine(),
    ) {
        check_any(&program, &machine);
    }

    #[test]
    fn arbitrary_words_never_panic_and_always_end(
        program in nearly_programs(),
        machine in any_machine(),
    ) {
        check_any(program.as_bytes(), &machine);
    }

    #[test]
    fn arbitrary_arcs_never_panic_and_always_end(
        arcs in prop::collection::vec(tiny_arcs(), 1..20),
        machine in any_machine(),
    ) {
        let program: Vec<_> = arcs.into_iter().map(TinyArc::program).collect();
        check_any(program.join("\n").as_bytes(), &machine);
    }

    /// No turn is lost and none is added, wherever rounding puts the ends.
    #[test]
    fn arcs_whose_ends_nearly_meet_turn_as_far_as_programmed(arc in tiny_arcs()) {
        let TinyArc { direction, centre, end } = arc;
        prop_assume!(centre.iter().any(|c| c.abs() > 1000));
        let machine = machine();
        let program = arc.program();
        let steps: Result<Vec<_>, _> = steps(&program, &machine).collect();
        let Ok(steps) = steps else {
            // An end further off the circle than is tolerated.
            return Ok(());
        };
        let motions: Vec<_> = steps.into_iter().flat_map(motions_of).collect();
        let seen = |point: [i32; 2], centre: [i64; 2]| {
            [0, 1].map(|axis| i64::from(point[axis]) - centre[axis])
        };
        let exact_centre = centre.map(i64::from);
        let programmed = turn(seen([0, 0], exact_centre), seen(end, exact_centre), direction);
        let turned: f64 = motions
            .iter()
            .map(|motion| match motion.curve {
                Curve::Line => 0.0,
                Curve::Arc { plane, centre, direction } => {
                    let [from, to] = motion.ends_in(plane);
                    turn(seen(from, centre), seen(to, centre), direction)
                }
            })
            .sum();
        prop_assert!((turned - programmed).abs() < 0.3, "{turned} for {programmed}");
    }

    #[test]
    fn arbitrary_characters_of_programs_never_panic_and_always_end(
        program in "[/GXYZIJKRPFSTDMN0-9.+ ()%;\r\n\t圆é-]{0,120}",
        machine in any_machine(),
    ) {
        check_any(program.as_bytes(), &machine);
    }
}
