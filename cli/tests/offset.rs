//! `onepulse offset`, and `onepulse run` on programs that are compensated.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use common::{failure, folder, onepulse, program, said};
use std::fs;

/// The lower left corner of a square of 20 mm, once round, with a cutter of 2 mm on the left: outside.
const SQUARE: &str = "G00 X-10. Y-10.\nG41 D1 G01 X0. Y0. F300\nY20.\nX20.\nG02 X40. Y0. J-20.\nG01 X0.\nG40 X-10. Y-10.\nM02\n";

const TABLE: &str = "T1 P1 D4.0\nT2 P2 D6.0 ; another\n";

/// Columns, kinds, roles and lines as the square has them; the corners by hand.
#[test]
fn rows_of_a_contour() {
    let folder = folder(&[("square.nc", SQUARE), ("tool.tbl", TABLE)]);
    let text = said(folder.path(), "offset square.nc --tool-table tool.tbl");
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("kind,x0,y0,x1,y1,cx,cy,line,role"));
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let due = [
        ("line", [0.0, 0.0, -10.0, -10.0], "", "1", "rapid"),
        // The radius vector of the line to the corner lies on its left: (-√½, √½)·2. Up from there
        // the contour turns to the left by 45 degrees, towards the cutter: it goes to the next block's.
        ("line", [-10.0, -10.0, -2.0, 0.0], "", "2", "establish"),
        ("line", [-2.0, 0.0, -2.0, 22.0], "", "3", "offset"),
        ("line", [-2.0, 22.0, 20.0, 22.0], "", "4", "offset"),
        ("cw", [20.0, 22.0, 42.0, 0.0], "20.000000", "5", "offset"),
        // The arc's end is lengthened along its tangent.
        ("line", [42.0, 0.0, 42.0, -2.0], "", "5", "corner"),
        ("line", [42.0, -2.0, 0.0, -2.0], "", "6", "offset"),
        ("line", [0.0, -2.0, -10.0, -10.0], "", "7", "cancel"),
    ];
    assert_eq!(rows.len(), due.len(), "{text}");
    for (row, (kind, ends, centre, line, role)) in rows.iter().zip(due) {
        assert_eq!((row[0], row[5], row[7], row[8]), (kind, centre, line, role), "{row:?}");
        for (found, due) in row[1..5].iter().zip(ends) {
            assert!((found.parse::<f64>().unwrap() - due).abs() < 1e-9, "{row:?}");
            assert!(found.split_once('.').unwrap().1.len() >= 6, "{row:?}");
        }
    }
}

#[test]
fn the_radius_may_be_given_for_all_tools() {
    let folder = folder(&[("square.nc", SQUARE), ("tool.tbl", TABLE)]);
    let by_table = said(folder.path(), "offset square.nc --tool-table tool.tbl");
    assert_eq!(said(folder.path(), "offset square.nc --radius 2"), by_table);
    assert_ne!(said(folder.path(), "offset square.nc --radius 2.5"), by_table);
}

#[test]
fn outside_corners_by_type() {
    let folder = folder(&[("square.nc", SQUARE)]);
    let kinds = |options: &str| -> Vec<String> {
        let text = said(folder.path(), &format!("offset square.nc --radius 2 {options}"));
        let corners = text.lines().filter(|line| line.ends_with(",corner"));
        corners.map(|line| line.split(',').next().unwrap().to_owned()).collect()
    };
    assert_eq!(kinds(""), ["line"]);
    assert_eq!(kinds("--type c --corners straight"), ["line"]);
    assert_eq!(kinds("--corners arcs"), ["cw", "cw"]);
    // The lines to and from the square turn inside.
    let wrong = failure(folder.path(), "offset square.nc --radius 2 --type b", 1);
    assert!(wrong.contains("inside corner"), "{wrong}");
    let outside = SQUARE.replace("G00 X-10.", "G00 X10.").replace("X-10. Y-10.", "X-10. Y10.");
    fs::write(folder.path().join("square.nc"), outside).unwrap();
    assert_eq!(kinds("--corners arcs"), ["cw"; 4]);
    assert_eq!(kinds("--type b"), ["cw"; 4]);
}

/// Z appends its columns, and nothing else changes.
#[test]
fn columns_of_z_are_appended_if_it_moves() {
    let deep = SQUARE.replace("G41", "G01 Z-1.5 F300\nG41");
    let folder = folder(&[("flat.nc", SQUARE), ("deep.nc", &deep)]);
    let flat = said(folder.path(), "offset flat.nc --radius 2");
    let deep = said(folder.path(), "offset deep.nc --radius 2");
    assert_eq!(deep.lines().next(), Some("kind,x0,y0,x1,y1,cx,cy,line,role,z0,z1,cz"));
    assert_eq!(deep.lines().count(), flat.lines().count() + 1);
    let plunge: Vec<_> = deep.lines().nth(2).unwrap().split(',').collect();
    assert_eq!((plunge[7], plunge[8]), ("2", "feed"));
    assert_eq!((plunge[9], plunge[10], plunge[11]), ("0.000000", "-1.500000", ""));
}

/// A program of the path makes the very pulses that the contour makes.
#[test]
fn the_path_as_a_program_makes_the_same_pulses() {
    let (program, table) = (program("plate.ngc"), program("tool.tbl"));
    for options in ["", "--corners arcs", "--pulse-mm 0.001"] {
        let folder = folder(&[]);
        let pulse = if options.contains("pulse") { options } else { "" };
        let ngc = format!("offset {program} --tool-table {table} --format ngc {options}");
        fs::write(folder.path().join("path.nc"), said(folder.path(), &ngc)).unwrap();
        let run = format!("run {program} --tool-table {table} --no-waves --out one {options}");
        said(folder.path(), &run);
        said(folder.path(), &format!("run path.nc --no-waves --out other {pulse}"));
        let pulses = |out: &str| -> Vec<String> {
            let text = fs::read_to_string(folder.path().join(out).join("pulses.csv")).unwrap();
            text.lines().map(|line| line.split_once(',').unwrap().1.to_owned()).collect()
        };
        assert_eq!(pulses("one"), pulses("other"), "{options}");
        assert!(pulses("one").len() > 30_000);
    }
}

/// Runs the sample program: software and hardware agree, and the picture has part, path and swept outline.
#[test]
fn a_compensated_program_runs() {
    let folder = folder(&[]);
    let (program, table) = (program("plate.ngc"), program("tool.tbl"));
    for (method, out) in [("ppc", "one"), ("dda", "two"), ("min-deviation", "three")] {
        let run =
            format!("run {program} --tool-table {table} --method {method} --no-waves --out {out}");
        said(folder.path(), &run);
        let report = fs::read_to_string(folder.path().join(out).join("report.json")).unwrap();
        let report: serde_json::Value = serde_json::from_str(&report).unwrap();
        assert_eq!(report["hardware_agrees"], true);
        let position = &report["final_position"];
        assert_eq!((&position["x"], &position["y"]), (&0.into(), &0.into()), "{report}");
        let picture = fs::read_to_string(folder.path().join(out).join("path.svg")).unwrap();
        for class in
            ["class=\"p\"", "class=\"o\" stroke-width=\"800.000\"", "class=\"i\"", "class=\"f\""]
        {
            assert!(picture.contains(class), "{class}");
        }
        // Two contours, of 8 and of 6 mm.
        assert_eq!(picture.matches("class=\"o\"").count(), 2);
        assert!(picture.contains("class=\"o\" stroke-width=\"600.000\""));
    }
    let profile = format!("profile {program} --tool-table {table}");
    assert!(said(folder.path(), &profile).lines().count() > 1000);
}

#[test]
fn the_picture_of_a_path_shows_all_of_it() {
    let folder = folder(&[("square.nc", SQUARE)]);
    let svg = said(folder.path(), "offset square.nc --radius 2 --format svg");
    for class in ["o", "i", "p", "r", "e", "s", "c"] {
        assert!(svg.contains(&format!("class=\"{class}\"")), "{class}");
    }
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
}

/// A cutter of 5 mm in an arc of 4 mm.
const GOUGE: &str = "G00 X0. Y-20.\nG41 G01 Y0. F600\nY30.\nX-30.\nG03 X-34. Y26. J-4.\nG01 Y0.\nX-60.\nG40 Y-20.\nM02\n";

#[test]
fn overcuts_are_refused_with_their_lines_and_a_picture() {
    let folder = folder(&[("gouge.nc", GOUGE)]);
    let output = onepulse(folder.path(), "offset gouge.nc --radius 5");
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(output.stdout, b"", "nothing is written of it");
    let wrong = String::from_utf8(output.stderr).unwrap();
    assert!(wrong.contains("gouge.nc:5:1") && wrong.contains("larger than the arc"), "{wrong}");
    assert!(wrong.contains("G03 X-34. Y26. J-4."), "{wrong}");
    assert!(wrong.contains("onepulse offset --format svg gouge.nc"), "{wrong}");
    let output = onepulse(folder.path(), "offset gouge.nc --radius 5 --format svg");
    assert_eq!(output.status.code(), Some(1));
    let picture = String::from_utf8(output.stdout).unwrap();
    assert!(picture.contains("<circle") && picture.contains(">line 5</text>"), "{picture}");
    assert!(picture.ends_with("</svg>\n"));
    // The same from a run, of which nothing is left.
    let wrong = failure(folder.path(), "run gouge.nc --radius 5 --out out", 1);
    assert!(wrong.contains("gouge.nc:5:1"), "{wrong}");
    assert!(!folder.path().join("out").exists());
    // A smaller cutter serves.
    said(folder.path(), "offset gouge.nc --radius 4");
}

/// Both lines at fault are shown.
#[test]
fn a_neck_shows_both_its_sides() {
    let neck = "G00 X-5. Y-10.\nG41 G01 Y0. F300\nY10.\nX5.\nY1.\nX30.\nY0.\nX5.\nY-9.\nX-5.\nY0.\nG40 X-20.\n";
    let slot = neck.replace("\nY1.\nX30.\nY0.\n", "\nY4.\nX-4.\nY-4.\n");
    let folder = folder(&[("slot.nc", &slot)]);
    let wrong = failure(folder.path(), "offset slot.nc --radius 4.5", 1);
    assert!(wrong.contains("slot.nc:"), "{wrong}");
    assert!(wrong.contains("cutter"), "{wrong}");
    said(folder.path(), "offset slot.nc --radius 3");
}

#[test]
fn all_errors_are_shown_in_one_pass() {
    let folder = folder(&[("wrong.nc", "G00 X5 Q1\nG54\nG01 X\n")]);
    let wrong = failure(folder.path(), "offset wrong.nc", 1);
    for place in ["wrong.nc:1:8", "wrong.nc:2:1", "wrong.nc:3:5"] {
        assert!(wrong.contains(place), "{place}: {wrong}");
    }
}

#[test]
fn a_wrong_tool_table_is_shown_too() {
    let folder = folder(&[("square.nc", SQUARE), ("tool.tbl", "T1 P1 D4.0\nT1 P2 D-1 K\n")]);
    let wrong = failure(folder.path(), "offset square.nc --tool-table tool.tbl", 1);
    for place in ["tool.tbl:2:1", "tool.tbl:2:7", "tool.tbl:2:11"] {
        assert!(wrong.contains(place), "{place}: {wrong}");
    }
    let wrong = failure(folder.path(), "run square.nc --tool-table nowhere.tbl --out out", 1);
    assert!(wrong.contains("nowhere.tbl"), "{wrong}");
    assert!(!folder.path().join("out").exists());
    let wrong = failure(folder.path(), "offset square.nc", 1);
    assert!(wrong.contains("square.nc:2:5") && wrong.contains("--tool-table"), "{wrong}");
}

#[test]
fn wrong_options_are_refused() {
    let folder = folder(&[("square.nc", SQUARE), ("tool.tbl", TABLE)]);
    for (options, words) in [
        ("--radius 2 --tool-table tool.tbl", "cannot be used with"),
        ("--radius -2", "not negative"),
        ("--radius two", "not a decimal number"),
        ("--radius 2 --type b --corners straight", "on arcs"),
        ("--radius 2 --type d", "possible values"),
    ] {
        let wrong = failure(folder.path(), &format!("offset square.nc {options}"), 2);
        assert!(wrong.contains(words), "{options}: {wrong}");
    }
}

#[test]
fn blocks_are_left_out_if_asked() {
    let folder = folder(&[("slash.nc", "G00 X1.\n/G00 X2.\nG00 X3.\n")]);
    let lines =
        |options: &str| said(folder.path(), &format!("offset slash.nc {options}")).lines().count();
    assert_eq!((lines(""), lines("--block-delete")), (4, 3));
}
