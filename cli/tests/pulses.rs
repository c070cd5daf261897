//! `onepulse pulses`: the pulses of one curve as CSV.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use assert_cmd::cargo::{cargo_bin, cargo_bin_cmd};
use std::f64::consts::TAU;
use std::io::{BufRead, BufReader, Read};
use std::process::{Output, Stdio};

/// `onepulse pulses` with these arguments, separated by blanks.
fn pulses(arguments: &str) -> Output {
    cargo_bin_cmd!("onepulse").arg("pulses").args(arguments.split_whitespace()).output().unwrap()
}

fn csv(arguments: &str) -> String {
    let output = pulses(arguments);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments}: {errors}");
    assert_eq!(errors, "", "{arguments}");
    String::from_utf8(output.stdout).unwrap()
}

/// The lines of a CSV of two axes, without the header.
fn rows(arguments: &str) -> Vec<[i64; 5]> {
    let text = csv(arguments);
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("cycle,dx,dy,x,y"), "{arguments}");
    let row = |line: &str| {
        let numbers: Vec<_> = line.split(',').map(|number| number.parse().unwrap()).collect();
        numbers.try_into().unwrap()
    };
    lines.map(row).collect()
}

/// The rows of a curve, checked for what holds of all: cycles from 1 upwards, no row without a
/// pulse, and each position the last one and the pulse.
fn checked_rows(arguments: &str, start: [i64; 2]) -> Vec<[i64; 5]> {
    let rows = rows(arguments);
    let (mut last_cycle, mut position) = (0, start);
    for &[cycle, dx, dy, x, y] in &rows {
        assert!(cycle > last_cycle, "{arguments}: cycle {cycle}");
        assert!([dx, dy] != [0, 0] && dx.abs() <= 1 && dy.abs() <= 1, "{arguments}: {cycle}");
        assert_eq!([x, y], [position[0] + dx, position[1] + dy], "{arguments}: cycle {cycle}");
        (last_cycle, position) = (cycle, [x, y]);
    }
    rows
}

fn end(arguments: &str, start: [i64; 2]) -> [i64; 2] {
    checked_rows(arguments, start).last().map_or(start, |&[_, _, _, x, y]| [x, y])
}

/// Refused as a wrong command line: nothing on standard output, and these words on the other.
fn check_refused(arguments: &str, words: &[&str]) {
    let output = pulses(arguments);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments}: {errors}");
    assert_eq!(output.stdout, b"", "{arguments}");
    for word in words {
        assert!(errors.contains(word), "{arguments}: '{word}' is missing in: {errors}");
    }
    assert!(!errors.contains("panicked"), "{arguments}: {errors}");
}

/// The points of the circle of radius 5: 8 that mirror (3,4) and 4 on the axes.
const CIRCLE: [[i64; 2]; 12] = [
    [3, 4],
    [4, 3],
    [-3, 4],
    [-4, 3],
    [3, -4],
    [4, -3],
    [-3, -4],
    [-4, -3],
    [5, 0],
    [0, 5],
    [-5, 0],
    [0, -5],
];

/// Everything that serves arcs.
const ARC_METHODS: [&str; 6] = [
    "",
    "--method dda",
    "--method dda --update simultaneous",
    "--method min-deviation",
    "--method vector",
    "--method compare-integral",
];

fn arc([x0, y0]: [i64; 2], [x1, y1]: [i64; 2], is_ccw: bool) -> String {
    format!("arc --from {x0},{y0} --to {x1},{y1} --{}", if is_ccw { "ccw" } else { "cw" })
}

/// The angle from a point to another about the origin, positive counter-clockwise.
fn angle([x0, y0]: [i64; 2], [x1, y1]: [i64; 2]) -> f64 {
    ((x0 * y1 - y0 * x1) as f64).atan2((x0 * x1 + y0 * y1) as f64)
}

/// Every arc between two points of the circle ends on its end point, and goes the right way.
fn check_arcs(options: &str) {
    for start in CIRCLE {
        for end in CIRCLE {
            for is_ccw in [true, false] {
                let arguments = format!("{} {options}", arc(start, end, is_ccw));
                let rows = checked_rows(&arguments, start);
                let sense = if is_ccw { 1.0 } else { -1.0 };
                let mut position = start;
                let mut turned = 0.0;
                for [_, _, _, x, y] in rows {
                    turned += sense * angle(position, [x, y]);
                    position = [x, y];
                }
                assert_eq!(position, end, "{arguments}");
                let due = match sense * angle(start, end) {
                    due if due > 0.0 => due,
                    due => due + TAU,
                };
                assert!((turned - due).abs() < 1e-9, "{arguments}: {turned} for {due}");
            }
        }
    }
}

#[test]
fn the_textbook_lines_by_point_by_point_comparison() {
    assert_eq!(
        csv("line --to 5,3"),
        "cycle,dx,dy,x,y\n1,1,0,1,0\n2,0,1,1,1\n3,1,0,2,1\n4,0,1,2,2\n5,1,0,3,2\n\
         6,1,0,4,2\n7,0,1,4,3\n8,1,0,5,3\n"
    );
    assert_eq!(
        csv("line --to 3,5 --method ppc --end-rule total"),
        "cycle,dx,dy,x,y\n1,1,0,1,0\n2,0,1,1,1\n3,0,1,1,2\n4,1,0,2,2\n5,0,1,2,3\n\
         6,0,1,2,4\n7,1,0,3,4\n8,0,1,3,5\n"
    );
}

#[test]
fn the_textbook_arc_by_point_by_point_comparison() {
    assert_eq!(
        csv("arc --from 5,0 --to 0,5 --ccw"),
        "cycle,dx,dy,x,y\n1,-1,0,4,0\n2,0,1,4,1\n3,0,1,4,2\n4,0,1,4,3\n5,-1,0,3,3\n\
         6,0,1,3,4\n7,-1,0,2,4\n8,0,1,2,5\n9,-1,0,1,5\n10,-1,0,0,5\n"
    );
}

#[test]
fn the_textbook_lines_by_digital_integration() {
    assert_eq!(
        csv("line --to 8,6 --method dda --radix 10 --bits 1"),
        "cycle,dx,dy,x,y\n2,1,1,1,1\n3,1,0,2,1\n4,1,1,3,2\n5,1,1,4,3\n7,1,1,5,4\n\
         8,1,0,6,4\n9,1,1,7,5\n10,1,1,8,6\n"
    );
    assert_eq!(
        csv("line --to 4,6 --method dda --bits 3"),
        "cycle,dx,dy,x,y\n2,1,1,1,1\n3,0,1,1,2\n4,1,1,2,3\n6,1,1,3,4\n7,0,1,3,5\n8,1,1,4,6\n"
    );
}

#[test]
fn the_textbook_arc_by_digital_integration() {
    assert_eq!(
        csv("arc --from 5,0 --to 0,5 --ccw --method dda --bits 3 --preset zero \
             --update simultaneous"),
        "cycle,dx,dy,x,y\n2,0,1,5,1\n4,0,1,5,2\n5,0,1,5,3\n7,-1,1,4,4\n9,-1,1,3,5\n\
         11,-1,0,2,5\n12,-1,0,1,5\n14,-1,0,0,5\n"
    );
}

#[test]
fn the_textbook_line_by_the_rate_multiplier() {
    assert_eq!(
        csv("line --to 10,6 --method brm --bits 4"),
        "cycle,dx,dy,x,y\n1,1,0,1,0\n2,0,1,1,1\n3,1,0,2,1\n4,1,1,3,2\n5,1,0,4,2\n\
         6,0,1,4,3\n7,1,0,5,3\n9,1,0,6,3\n10,0,1,6,4\n11,1,0,7,4\n12,1,1,8,5\n\
         13,1,0,9,5\n14,0,1,9,6\n15,1,0,10,6\n"
    );
}

/// The methods that move both axes at once, or judge otherwise: worked by hand.
#[test]
fn a_line_by_minimum_deviation_by_vectors_and_by_intervals() {
    // y = 0.6 x, rounded to the nearest.
    let nearest = "cycle,dx,dy,x,y\n1,1,1,1,1\n2,1,0,2,1\n3,1,1,3,2\n4,1,0,4,2\n5,1,1,5,3\n";
    assert_eq!(csv("line --to 5,3 --method min-deviation"), nearest);
    // V: 0, 2, -1, 1, -2, 0.
    assert_eq!(csv("line --to 5,3 --method vector"), nearest);
    // D: -2, 4, -6, 0, -4, 2, -8.
    assert_eq!(
        csv("line --to 5,3 --method compare-integral"),
        "cycle,dx,dy,x,y\n1,1,0,1,0\n2,0,1,1,1\n3,1,0,2,1\n4,1,1,3,2\n5,1,0,4,2\n6,0,1,4,3\n\
         7,1,0,5,3\n"
    );
    // Where they differ: y = x/3.
    let y = |method: &str| {
        let rows = rows(&format!("line --to 3,-1 --method {method}"));
        rows.iter().map(|row| row[4]).collect::<Vec<_>>()
    };
    assert_eq!(y("min-deviation"), [0, -1, -1]);
    assert_eq!(y("vector"), [-1, -1, -1]);
    assert_eq!(y("compare-integral"), [0, -1, -1]);
}

#[test]
fn the_textbook_arc_by_minimum_deviation_by_vectors_and_by_intervals() {
    let path = |method: &str| {
        let arguments = format!("arc --from 5,0 --to 0,5 --ccw --method {method}");
        let rows = checked_rows(&arguments, [5, 0]);
        rows.iter().map(|row| [row[3], row[4]]).collect::<Vec<_>>()
    };
    assert_eq!(path("min-deviation"), [[5, 1], [5, 2], [4, 3], [3, 4], [2, 5], [1, 5], [0, 5]]);
    assert_eq!(path("vector"), [[4, 1], [4, 2], [4, 3], [3, 4], [2, 4], [1, 5], [0, 5]]);
    let by_intervals = [[5, 1], [5, 2], [4, 2], [4, 3], [3, 4], [2, 4], [2, 5], [1, 5], [0, 5]];
    assert_eq!(path("compare-integral"), by_intervals);
}

#[test]
fn a_line_of_three_axes_by_minimum_deviation() {
    // y = x/2 and z = 3/4 x; what is half a pulse behind waits.
    assert_eq!(
        csv("line --to 4,2,-3 --method min-deviation"),
        "cycle,dx,dy,dz,x,y,z\n1,1,0,-1,1,0,-1\n2,1,1,0,2,1,-1\n3,1,0,-1,3,1,-2\n4,1,1,-1,4,2,-3\n"
    );
}

/// y² = 4x, worked by hand.
#[test]
fn a_parabola_by_point_by_point_comparison() {
    // F: 0, -4, -3, 0, -4, 1, -3, 4, 0; at 4 y stands.
    assert_eq!(
        csv("parabola --p 2 --to 4,4"),
        "cycle,dx,dy,x,y\n1,1,0,1,0\n2,0,1,1,1\n3,0,1,1,2\n4,1,0,2,2\n5,0,1,2,3\n6,1,0,3,3\n\
         7,0,1,3,4\n8,1,0,4,4\n"
    );
    assert_eq!(
        csv("parabola --p -1 --to 2,-2 --axis y"),
        "cycle,dx,dy,x,y\n1,0,-1,0,-1\n2,1,0,1,-1\n3,1,0,2,-1\n4,0,-1,2,-2\n"
    );
}

#[test]
fn a_parabola_by_digital_integration() {
    // Of three bits: JVx = y, JVy = 2, both added in every cycle, modulo 8.
    assert_eq!(
        csv("parabola --p 2 --to 4,4 --method dda"),
        "cycle,dx,dy,x,y\n4,0,1,0,1\n8,0,1,0,2\n10,1,0,1,2\n12,0,1,1,3\n14,1,0,2,3\n16,1,1,3,4\n\
         18,1,0,4,4\n"
    );
}

#[test]
fn a_parabola_by_minimum_deviation() {
    let rows = checked_rows("parabola --p 1 --to 8,4 --method min-deviation", [0, 0]);
    let path: Vec<_> = rows.iter().map(|row| [row[3], row[4]]).collect();
    let nearest = [[0, 1], [1, 1], [2, 2], [3, 2], [4, 3], [5, 3], [6, 3], [7, 4], [8, 4]];
    assert_eq!(path, nearest);
}

#[test]
fn parabolas_end_on_their_end_point_in_every_direction() {
    for method in ["ppc", "dda", "dda --preset half --bits 9", "min-deviation"] {
        for [p, x, y] in [[3, 6, 6], [-3, -6, 6], [3, 7, -5], [-3, 0, -4], [3, 9, 0], [1, 0, 0]] {
            for (axis, target) in [("x", [x, y]), ("y", [y, x])] {
                let [to_x, to_y] = target;
                let arguments =
                    format!("parabola --p {p} --to {to_x},{to_y} --axis {axis} --method {method}");
                assert_eq!(end(&arguments, [0, 0]), target, "{arguments}");
            }
        }
    }
}

/// The arc is the textbook's; z has its three pulses of ten cycles when 5 + 3c passes a ten.
#[test]
fn a_helix_in_every_plane() {
    let helix = "helix --from 5,0 --to 0,5 --ccw --rise 3";
    assert_eq!(
        csv(helix),
        "cycle,dx,dy,dz,x,y,z\n1,-1,0,0,4,0,0\n2,0,1,1,4,1,1\n3,0,1,0,4,2,1\n4,0,1,0,4,3,1\n\
         5,-1,0,1,3,3,2\n6,0,1,0,3,4,2\n7,-1,0,0,2,4,2\n8,0,1,0,2,5,2\n9,-1,0,1,1,5,3\n\
         10,-1,0,0,0,5,3\n"
    );
    assert_eq!(csv(helix), csv(&format!("{helix} --plane xy --method ppc")));
    // In zx the arc turns z to x and y rises; in yz it turns y to z and x rises.
    let zx = csv(&format!("{helix} --plane zx"));
    assert!(zx.starts_with("cycle,dx,dy,dz,x,y,z\n1,0,0,-1,0,0,4\n2,1,1,0,1,1,4\n"), "{zx}");
    assert!(zx.ends_with("\n10,0,0,-1,5,3,0\n"), "{zx}");
    let yz = csv("helix --from 5,0 --to 0,5 --ccw --rise -3 --plane yz");
    assert!(yz.starts_with("cycle,dx,dy,dz,x,y,z\n1,0,-1,0,0,4,0\n2,-1,0,1,-1,4,1\n"), "{yz}");
    assert!(yz.ends_with("\n10,0,-1,0,-3,0,5\n"), "{yz}");
}

#[test]
fn lines_in_space_by_point_by_point_comparison() {
    // F of x and of z: 0 0, -1 -2, -1 1, 2 1, 1 -1, 1 2, 0 0.
    assert_eq!(
        csv("line --to 1,-3,2"),
        "cycle,dx,dy,dz,x,y,z\n1,0,-1,0,0,-1,0\n2,0,0,1,0,-1,1\n3,1,0,0,1,-1,1\n\
         4,0,-1,0,1,-2,1\n5,0,0,1,1,-2,2\n6,0,-1,0,1,-3,2\n"
    );
    assert_eq!(csv("line --to 1,-3,2 --end-rule per-axis"), csv("line --to 1,-3,2"));
    let text = csv("line --to -7,100,3,-50");
    assert!(text.ends_with("\n160,0,1,0,0,-7,100,3,-50\n"), "{text}");
}

/// The trains are those of 20 and 12 in five stages; of each every second pulse passes, from the
/// first.
#[test]
fn a_smoothed_rate_multiplier_passes_every_second_pulse() {
    let rows = rows("line --to 10,6 --method brm --bits 4 --smooth 1");
    let clocks = |axis: usize| -> Vec<_> {
        rows.iter().filter(|row| row[axis] == 1).map(|row| row[0]).collect()
    };
    assert_eq!(clocks(1), [1, 4, 7, 11, 13, 17, 20, 23, 27, 29]);
    assert_eq!(clocks(2), [2, 6, 12, 18, 22, 28]);
    let plain = "line --to 10,6 --method brm --bits 4";
    assert_eq!(csv(&format!("{plain} --smooth 0")), csv(plain));
}

#[test]
fn what_parabolas_and_helices_do_not_have_is_refused() {
    let parabola = "parabola --p 2 --to 4,4";
    for method in ["brm", "vector", "compare-integral"] {
        check_refused(&format!("{parabola} --method {method}"), &["ppc, dda and min-deviation"]);
    }
    check_refused(&format!("{parabola} --method dda --radix 10"), &["radix 2"]);
    check_refused(&format!("{parabola} --method dda --normalize"), &["--normalize"]);
    check_refused(&format!("{parabola} --method dda --bits 2"), &["--bits", "needs 3"]);
    check_refused(&format!("{parabola} --bits 2"), &["--bits", "needs 3"]);
    check_refused(&format!("{parabola} --end-rule larger"), &["--end-rule larger"]);
    check_refused("parabola --p 0 --to 4,4", &["--p", "parameter 0"]);
    check_refused("parabola --p 2 --to -4,4", &["--to", "behind the vertex"]);
    check_refused("parabola --p x --to 4,4", &["--p", "'x' is not a whole number"]);
    check_refused("parabola --p 2 --to 4,4 --axis z", &["--axis", "'z'"]);
    let helix = "helix --from 5,0 --to 0,5 --cw --rise 3";
    for method in ["dda", "brm", "min-deviation", "vector", "compare-integral"] {
        check_refused(&format!("{helix} --method {method}"), &["--method ppc only"]);
    }
    check_refused(&format!("{helix} --end-rule larger"), &["--end-rule larger"]);
    check_refused(&format!("{helix} --plane yx"), &["--plane", "'yx'"]);
    check_refused(&format!("{helix} --bits 2"), &["--bits", "needs 3"]);
    check_refused("helix --from 5,0 --to 0,5 --rise 3", &["--cw", "--ccw"]);
    check_refused("helix --from 0,0 --to 0,5 --cw --rise 3", &["--from", "centre"]);
    check_refused("line --to 5,3,2 --end-rule larger", &["--end-rule larger"]);
    check_refused("line --to 5,3 --smooth 1", &["--smooth belongs to --method brm"]);
    check_refused("line --to 5,3 --method brm --smooth 30", &["--smooth", "32 stages"]);
    check_refused("line --to 5,3 --method brm --smooth 32", &["--smooth", "32"]);
    check_refused("line --to 5,3 --method brm --smooth=-1", &["--smooth", "'-1'"]);
}

#[test]
fn the_smallest_registers_that_serve_are_the_default() {
    for (curve, options) in [
        ("line --to 8,6 --method dda --radix 10", "--bits 1"),
        ("line --to 4,6 --method dda", "--bits 3"),
        ("line --to 10,6 --method brm", "--bits 4"),
        ("arc --from 5,0 --to 0,5 --ccw --method dda --update simultaneous", "--bits 3"),
        ("arc --from 5,0 --to 0,5 --ccw --method dda", "--bits 4"),
    ] {
        assert_eq!(csv(curve), csv(&format!("{curve} {options}")), "{curve}");
    }
}

#[test]
fn options_may_stand_before_the_curve() {
    let expected = csv("line --to 4,6 --method dda --bits 5");
    assert_eq!(csv("--method dda --bits 5 line --to 4,6"), expected);
    assert_eq!(csv("--bits=5 line --to=4,6 --method=dda"), expected);
}

#[test]
fn negative_ends_mirror_the_pulses() {
    for options in [
        "",
        "--method dda",
        "--method brm",
        "--method min-deviation",
        "--method vector",
        "--method compare-integral",
    ] {
        let mirrored = rows(&format!("line --to 5,3 {options}"));
        for [sx, sy] in [[-1, 1], [1, -1], [-1, -1]] {
            let found = rows(&format!("line --to {},{} {options}", 5 * sx, 3 * sy));
            let expected: Vec<_> = mirrored
                .iter()
                .map(|[cycle, dx, dy, x, y]| [*cycle, sx * dx, sy * dy, sx * x, sy * y])
                .collect();
            assert_eq!(found, expected, "{sx},{sy} {options}");
        }
    }
    assert_eq!(csv("line --to -2,0"), "cycle,dx,dy,x,y\n1,-1,0,-1,0\n2,-1,0,-2,0\n");
}

#[test]
fn lines_of_three_and_four_axes_have_their_columns() {
    assert_eq!(
        csv("line --to 4,6,-5 --method dda"),
        "cycle,dx,dy,dz,x,y,z\n2,1,1,-1,1,1,-1\n3,0,1,0,1,2,-1\n4,1,1,-1,2,3,-2\n\
         5,0,0,-1,2,3,-3\n6,1,1,0,3,4,-3\n7,0,1,-1,3,5,-4\n8,1,1,-1,4,6,-5\n"
    );
    assert_eq!(
        csv("line --to 1,-2,3,0 --method brm --bits 2"),
        "cycle,dx,dy,dz,da,x,y,z,a\n1,0,-1,1,0,0,-1,1,0\n2,1,0,1,0,1,-1,2,0\n\
         3,0,-1,1,0,1,-2,3,0\n"
    );
    let text = csv("line --to -7,100,3,-50 --method dda --normalize --bits 20");
    assert!(text.starts_with("cycle,dx,dy,dz,da,x,y,z,a\n"));
    assert!(text.ends_with(",-7,100,3,-50\n"), "{text}");
}

#[test]
fn a_line_without_length_has_no_rows() {
    for options in [
        "",
        "--method dda",
        "--method brm",
        "--end-rule larger",
        "--method min-deviation",
        "--method vector",
        "--method compare-integral",
    ] {
        assert_eq!(csv(&format!("line --to 0,0 {options}")), "cycle,dx,dy,x,y\n");
    }
}

#[test]
fn lines_end_on_their_end_point_by_every_method() {
    for options in [
        "--end-rule total",
        "--end-rule per-axis",
        "--method dda",
        "--method dda --preset half --normalize --bits 12",
        "--method dda --preset full",
        "--method dda --radix 10",
        "--method dda --radix 10 --bits 3 --preset full",
        "--method brm",
        "--method brm --bits 9",
        "--method min-deviation",
        "--method vector",
        "--method compare-integral",
    ] {
        for [x, y] in [[7, 0], [0, 7], [-7, 0], [0, -7], [1, 100], [100, -1], [-33, 77], [-5, -5]] {
            assert_eq!(end(&format!("line --to {x},{y} {options}"), [0, 0]), [x, y], "{options}");
        }
    }
}

#[test]
fn the_rule_of_the_larger_axis_leaves_a_residual() {
    // On a tie x counts: the third x pulse ends the line, y is one short, and that is said.
    for (end, rows, short) in [
        ("3,3", "1,1,0,1,0\n2,0,1,1,1\n3,1,0,2,1\n4,0,1,2,2\n5,1,0,3,2\n", "0,1"),
        ("-1,-1", "1,-1,0,-1,0\n", "0,-1"),
    ] {
        let output = pulses(&format!("line --to {end} --end-rule larger"));
        assert!(output.status.success());
        assert_eq!(output.stdout, format!("cycle,dx,dy,x,y\n{rows}").into_bytes());
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(said, format!("note: not exact: the end point is {short} pulses further\n"));
    }
    assert_eq!(end("line --to 3,5 --end-rule larger", [0, 0]), [3, 5]);
    assert_eq!(end("line --to 0,5 --end-rule larger", [0, 0]), [0, 5]);
}

#[test]
fn arcs_end_on_their_end_point_by_point_by_point_comparison() {
    check_arcs("--method ppc");
    check_arcs("--method ppc --end-rule per-axis");
}

#[test]
fn arcs_end_on_their_end_point_by_the_staggered_circuit() {
    check_arcs("--method dda");
}

#[test]
fn arcs_end_on_their_end_point_by_the_normalized_staggered_circuit() {
    check_arcs("--method dda --update staggered --preset half --bits 11 --normalize");
}

#[test]
fn arcs_end_on_their_end_point_by_minimum_deviation() {
    check_arcs("--method min-deviation");
}

#[test]
fn arcs_end_on_their_end_point_by_vector_discrimination() {
    check_arcs("--method vector");
}

#[test]
fn arcs_end_on_their_end_point_by_comparison_integration() {
    check_arcs("--method compare-integral");
}

#[test]
fn arcs_end_on_their_end_point_by_the_textbook_circuit() {
    for start in CIRCLE {
        for target in CIRCLE {
            for is_ccw in [true, false] {
                let arguments =
                    format!("{} --method dda --update simultaneous", arc(start, target, is_ccw));
                assert_eq!(end(&arguments, start), target, "{arguments}");
            }
        }
    }
}

#[test]
fn large_circles_close_and_stay_within_a_pulse() {
    for options in [
        "",
        "--method dda",
        "--method dda --bits 16 --normalize",
        "--method min-deviation",
        "--method vector",
        "--method compare-integral",
    ] {
        for sense in ["--cw", "--ccw"] {
            let arguments = format!("arc --from 300,-400 --to 300,-400 {sense} {options}");
            let rows = checked_rows(&arguments, [300, -400]);
            assert_eq!(&rows.last().unwrap()[3..], [300, -400], "{arguments}");
            for [cycle, _, _, x, y] in rows {
                let deviation = (x as f64).hypot(y as f64) - 500.0;
                assert!(deviation.abs() <= 1.0, "{arguments}: {deviation} in cycle {cycle}");
            }
        }
    }
}

#[test]
fn an_end_point_off_the_circle_is_reached() {
    for options in ARC_METHODS {
        for target in [[0, 6], [1, 5], [-3, 5], [-2, -4], [6, -1]] {
            for is_ccw in [true, false] {
                let arguments = format!("{} {options}", arc([5, 0], target, is_ccw));
                assert_eq!(end(&arguments, [5, 0]), target, "{arguments}");
            }
        }
    }
}

#[test]
fn the_circle_of_radius_one_ends() {
    for options in ARC_METHODS {
        for sense in ["--cw", "--ccw"] {
            let arguments = format!("arc --from 1,0 --to 1,0 {sense} {options}");
            assert_eq!(end(&arguments, [1, 0]), [1, 0], "{arguments}");
        }
    }
}

/// Reads the first lines of a curve's pulses, closes the pipe, and sees that nothing is amiss.
fn check_streaming(arguments: &str) -> Vec<String> {
    let mut child = std::process::Command::new(cargo_bin!("onepulse"))
        .arg("pulses")
        .args(arguments.split_whitespace())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let stdout = BufReader::new(child.stdout.take().unwrap());
    let lines = stdout.lines().take(4).map(Result::unwrap).collect();
    let mut errors = String::new();
    child.stderr.take().unwrap().read_to_string(&mut errors).unwrap();
    let status = child.wait().unwrap();
    assert_eq!(errors, "", "{arguments}");
    assert_eq!(status.code(), Some(0), "{arguments}");
    lines
}

#[test]
fn the_longest_lines_stream_until_nobody_reads() {
    let line = "line --to 2147483647,-2147483648";
    assert_eq!(
        check_streaming(line),
        ["cycle,dx,dy,x,y", "1,1,0,1,0", "2,0,-1,1,-1", "3,0,-1,1,-2"]
    );
    let lines = check_streaming(&format!("{line} --method dda"));
    assert_eq!(lines, ["cycle,dx,dy,x,y", "2,0,-1,0,-1", "3,1,0,1,-1", "4,0,-1,1,-2"]);
    let lines = check_streaming(&format!("{line} --method brm"));
    assert_eq!(lines, ["cycle,dx,dy,x,y", "1,0,-1,0,-1", "2,1,0,1,-1", "3,0,-1,1,-2"]);
    for method in ["min-deviation", "vector", "compare-integral"] {
        assert_eq!(check_streaming(&format!("{line} --method {method}")).len(), 4, "{method}");
    }
    for curve in [
        "parabola --p -2147483648 --to -2147483648,2147483647",
        "parabola --p 1 --to 2147483647,2147483647 --method min-deviation",
        "parabola --p 2147483647 --to 5,-2147483648 --method dda --preset half",
        "helix --from 2147483647,0 --to 2147483647,0 --cw --rise -2147483648",
        "line --to 2147483647,-2147483648,2147483647,1",
        "line --to 1073741823,1 --method brm --smooth 2",
    ] {
        assert_eq!(check_streaming(curve).len(), 4, "{curve}");
    }
    let lines = check_streaming("line --to -2147483648,0,2147483647,-1 --method dda");
    assert_eq!(lines[0], "cycle,dx,dy,dz,da,x,y,z,a");
}

#[test]
fn the_largest_circles_stream_until_nobody_reads() {
    let circle = "arc --from 2147483647,0 --to 2147483647,0 --ccw";
    for options in ARC_METHODS {
        let lines = check_streaming(&format!("{circle} {options}"));
        assert_eq!(lines.len(), 4, "{options}");
    }
}

#[test]
fn options_of_another_method_are_refused_by_name() {
    for (arguments, option) in [
        ("line --to 5,3 --radix 2", "--radix"),
        ("line --to 5,3 --preset half", "--preset"),
        ("line --to 5,3 --normalize", "--normalize"),
        ("line --to 5,3 --update staggered", "--update"),
        ("line --to 5,3 --method dda --end-rule larger", "--end-rule"),
        ("line --to 5,3 --method brm --end-rule total", "--end-rule"),
        ("line --to 5,3 --method brm --radix 10", "--radix"),
        ("line --to 5,3 --method brm --preset zero", "--preset"),
        ("line --to 5,3 --method brm --normalize", "--normalize"),
        ("line --to 5,3 --method brm --update simultaneous", "--update"),
        ("arc --from 5,0 --to 0,5 --ccw --preset half", "--preset"),
        ("line --to 5,3 --method min-deviation --end-rule total", "--end-rule"),
        ("line --to 5,3 --method vector --normalize", "--normalize"),
        ("line --to 5,3 --method compare-integral --radix 2", "--radix"),
        ("arc --from 5,0 --to 0,5 --ccw --method vector --update staggered", "--update"),
    ] {
        check_refused(arguments, &[option]);
    }
}

#[test]
fn curves_that_a_method_does_not_serve_are_refused() {
    check_refused("arc --from 5,0 --to 0,5 --ccw --method brm", &["lines only", "--method"]);
    check_refused("line --to 5,3,2 --method vector", &["2 axes", "min-deviation"]);
    check_refused("line --to 5,3,2 --method compare-integral", &["2 axes", "min-deviation"]);
    let decimal = "arc --from 5,0 --to 0,5 --ccw --method dda --radix 10";
    check_refused(decimal, &["radix 2"]);
    check_refused(&format!("{decimal} --update simultaneous"), &["radix 2"]);
    check_refused("line --to 5,3 --method dda --radix 10 --normalize", &["normalization"]);
}

#[test]
fn the_staggered_circuit_takes_half_load_only() {
    for preset in ["zero", "full"] {
        let arguments = format!("arc --from 5,0 --to 0,5 --ccw --method dda --preset {preset}");
        check_refused(&arguments, &["--preset", "half load"]);
    }
}

/// Registers that are too narrow for their curve, and the width that it needs.
const NARROW: [(&str, &str); 9] = [
    ("line --to 8,3 --method vector --bits 3", "needs 4"),
    ("arc --from 8,0 --to 0,8 --ccw --method min-deviation --bits 3", "needs 4"),
    ("line --to 5,3 --bits 2", "needs 3"),
    ("line --to 8,3 --method dda --bits 3", "needs 4"),
    ("line --to 10,6 --method dda --radix 10 --bits 1", "needs 2"),
    ("line --to 10,6 --method brm --bits 3", "needs 4"),
    ("arc --from 8,0 --to 0,8 --ccw --bits 3", "needs 4"),
    ("arc --from 8,0 --to 0,8 --ccw --method dda --bits 4", "needs 5"),
    ("arc --from 8,0 --to 0,8 --ccw --method dda --update simultaneous --bits 3", "needs 4"),
];

/// Registers of a width that is not offered.
const NOT_OFFERED: [&str; 5] = [
    "line --to 5,3 --bits 0",
    "line --to 5,3 --bits 99",
    "line --to 5,3 --method dda --bits 0",
    "line --to 5,3 --method dda --bits 4294967295",
    "arc --from 5,0 --to 0,5 --cw --method dda --bits 4294967295",
];

#[test]
fn registers_that_do_not_serve_are_refused() {
    for (arguments, needed) in NARROW {
        check_refused(arguments, &["a register of", needed]);
    }
    for arguments in NOT_OFFERED {
        check_refused(arguments, &["not offered"]);
    }
}

#[test]
fn registers_that_do_not_serve_are_refused_by_the_name_of_the_option() {
    for arguments in NARROW.map(|(arguments, _)| arguments).into_iter().chain(NOT_OFFERED) {
        check_refused(arguments, &["--bits"]);
    }
}

#[test]
fn arcs_that_touch_their_centre_are_refused() {
    for options in ARC_METHODS {
        let arc = |ends: &str| format!("arc {ends} --ccw {options}");
        check_refused(&arc("--from 0,0 --to 0,5"), &["starts in its centre"]);
        check_refused(&arc("--from 5,0 --to 0,0"), &["ends in its centre"]);
        check_refused(&arc("--from 2147483647,1 --to 0,5"), &["radius over 2147483647"]);
        check_refused(&arc("--from -2147483648,0 --to 0,5"), &["radius over 2147483647"]);
    }
}

#[test]
fn arcs_that_touch_their_centre_are_refused_by_the_name_of_the_option() {
    check_refused("arc --from 0,0 --to 0,5 --ccw", &["--from"]);
    check_refused("arc --from 5,0 --to 0,0 --ccw", &["--to"]);
}

#[test]
fn bad_numbers_and_names_are_refused_by_the_name_of_the_option() {
    for (arguments, words) in [
        ("line --to 5,x", ["--to", "'x' is not a whole number"]),
        ("line --to 5.5,3", ["--to", "'5.5' is not a whole number"]),
        ("line --to 5,", ["--to", "'' is not a whole number"]),
        ("line --to 2147483648,0", ["--to", "'2147483648' is not a whole number"]),
        ("line --to -2147483649,0", ["--to", "'-2147483649' is not a whole number"]),
        ("line --to 5", ["--to", "2 to 4 coordinates"]),
        ("line --to 1,2,3,4,5", ["--to", "2 to 4 coordinates"]),
        ("arc --from 5,0,0 --to 0,5 --ccw", ["--from", "2 coordinates"]),
        ("arc --from 5,0 --to 0 --ccw", ["--to", "2 coordinates"]),
        ("arc --from 5,0 --to 0,5", ["--cw", "--ccw"]),
        ("arc --from 5,0 --to 0,5 --cw --ccw", ["--cw", "--ccw"]),
        ("line --to 5,3 --bits x", ["--bits", "'x'"]),
        ("line --to 5,3 --bits=-1", ["--bits", "'-1'"]),
        ("line --to 5,3 --method euler", ["--method", "'euler'"]),
        ("line --to 5,3 --end-rule none", ["--end-rule", "'none'"]),
        ("line --to 5,3 --method dda --radix 3", ["--radix", "'3'"]),
        ("line --to 5,3 --method dda --preset one", ["--preset", "'one'"]),
        ("line --to 5,3 --method dda --update never", ["--update", "'never'"]),
        ("line", ["--to", "required"]),
        ("", ["Usage", "line"]),
        ("spline --to 5,3", ["'spline'", "unrecognized"]),
        ("line --to 5,3 --speed 5", ["--speed", "unexpected"]),
    ] {
        check_refused(arguments, &words);
    }
}

#[test]
fn a_short_plane_curve_is_drawn() {
    let picture = csv("arc --from 5,0 --to 0,5 --ccw --method min-deviation --format svg");
    assert!(picture.starts_with("<svg"));
    // The seven steps of this arc, and where it starts.
    assert!(picture.contains("points=\"5,0 5,1 5,2 4,3 3,4 2,5 1,5 0,5\""), "{picture}");
    for arguments in ["line --to 1,2,3 --method dda --format svg", "line --to 99,1 --format svg"] {
        assert_eq!(pulses(arguments).status.code(), Some(2), "{arguments}");
    }
}
