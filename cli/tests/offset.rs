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

/// Two rooms of 20 mm and a neck of 3 mm between them: a cutter of 2 mm cuts into both its sides.
const NECK: &str = "G00 X10. Y10.\nG41 D1 G01 X0. F600\nY0.\nX20.\nY8.5\nX30.\nY0.\nX50.\nY20.\nX30.\nY11.5\nX20.\nY20.\nX0.\nY10.\nG40 X10.\n";

#[test]
fn interference_shows_both_blocks() {
    let folder = folder(&[("neck.nc", NECK)]);
    let wrong = failure(folder.path(), "offset neck.nc --radius 2", 1);
    let shown = wrong.split("Error: ").find(|part| part.contains("line 12,")).unwrap();
    for words in ["neck.nc:6:1", "6 │ X30.", "line 6, column 1", "12 │ X20.", "line 12, column 1"]
    {
        assert!(shown.contains(words), "{words}: {wrong}");
    }
    // The picture has room for the contour, and a margin of 4 %; text stands upright in it.
    let output = onepulse(folder.path(), "offset neck.nc --radius 2 --format svg");
    let picture = String::from_utf8(output.stdout).unwrap();
    for words in [
        "viewBox=\"-2000.0 -22000.0 54000.0 24000.0\"",
        "cx=\"30000.0000\" cy=\"11500.0000\" r=\"2000.0000\"",
        "<text x=\"30000.0000\" y=\"-11500.0000\">lines 6, 11, 12</text>",
    ] {
        assert!(picture.contains(words), "{words}: {picture}");
    }
}

#[test]
fn what_is_said_fits_the_errors() {
    let twenty = "G54\n".repeat(20);
    let nineteen = "G54\n".repeat(19);
    let folder = folder(&[
        ("twenty.nc", &twenty),
        ("nineteen.nc", &nineteen),
        ("wide.nc", "G00 X1\n(圆弧) G01 Q5\n"),
    ]);
    let there_may_be_more = "These are the first 20";
    assert!(failure(folder.path(), "offset twenty.nc", 1).contains(there_may_be_more));
    let wrong = failure(folder.path(), "offset nineteen.nc", 1);
    assert!(!wrong.contains(there_may_be_more) && !wrong.contains("A picture"), "{wrong}");
    // What stands before is counted in characters, and the label is there all the same.
    let wrong = failure(folder.path(), "offset wide.nc", 1);
    for words in ["wide.nc:2:10", "2 │ (圆弧) G01 Q5", "line 2, column 10"] {
        assert!(wrong.contains(words), "{words}: {wrong}");
    }
}

/// The radius of nothing, and the B type with the only corners that it has.
#[test]
fn options_that_change_nothing_are_taken() {
    let outside = SQUARE.replace("G00 X-10.", "G00 X10.").replace("X-10. Y-10.", "X-10. Y10.");
    let folder = folder(&[("square.nc", &outside)]);
    let b = said(folder.path(), "offset square.nc --radius 2 --type b");
    assert_eq!(said(folder.path(), "offset square.nc --radius 2 --type b --corners arcs"), b);
    let along = said(folder.path(), "offset square.nc --radius 0");
    let row = "line,0.000000,0.000000,0.000000,20.000000,,,3,offset";
    assert!(along.lines().any(|line| line == row), "{along}");
}

/// Turns, arcs and lines in two planes, stops, tools and speeds.
const ALL: &str = "G00 X-0.5 T1 S1200.5\nG04 P0.05\nG01 X1. F100\nX2. F200\nM00\nX3.\nG02 I5.\nG18 G03 X5. Z2. I2.\nG17 G01 Y1. T2 S0\n";

#[test]
fn a_program_of_the_path_has_all_words() {
    let folder = folder(&[("all.nc", ALL)]);
    let due = "%\nG21 G90 G17 G40\nG00 X-0.5 S1200.5 T1\nG04 P0.05\nG01 X1. F100.\nG01 X2. F200.\nM00\n\
               G01 X3.\nG02 I5. J0.\nG18 G03 X5. Z2. K0. I2.\nG17 G01 Y1. S0 T2\nM30\n%\n";
    assert_eq!(said(folder.path(), "offset all.nc --format ngc"), due);
    // An arc whose ends meet in whole picometres does not become a whole turn.
    let tiny = "G00 X-10. Y10.\nG41 G01 X0. Y0. F600\nG03 X0.000000001 Y0.000000001 I-20. J20.\nG40 G01 X-9.\n";
    fs::write(folder.path().join("tiny.nc"), tiny).unwrap();
    let ngc = said(folder.path(), "offset tiny.nc --radius 3.59 --format ngc");
    assert!(!ngc.contains("G03"), "{ngc}");
}

#[test]
fn rows_of_arcs_in_every_plane() {
    let folder = folder(&[
        ("all.nc", ALL),
        ("turn.nc", "G00 X10.\nG18 G02 I5. F1\n"),
        ("low.nc", "G00 X-0.3 Y-0.4\nG03 X0.3 R0.5 F1\n"),
    ]);
    let rows = |name: &str| said(folder.path(), &format!("offset {name}.nc"));
    let all = rows("all");
    for row in [
        "cw,3.000000,0.000000,3.000000,0.000000,8.000000,0.000000,7,feed,0.000000,0.000000,",
        "ccw,3.000000,0.000000,5.000000,0.000000,5.000000,,8,feed,0.000000,2.000000,0.000000",
    ] {
        assert!(all.lines().any(|line| line == row), "{row}: {all}");
    }
    // A whole turn in another plane ends at its height, and still is not flat.
    let turn = rows("turn");
    let row =
        "cw,10.000000,0.000000,10.000000,0.000000,15.000000,,2,feed,0.000000,0.000000,0.000000";
    assert_eq!(turn.lines().last(), Some(row));
    // Its centre is a rounding below the origin: no minus before a zero.
    let low = rows("low");
    let row = "ccw,-0.300000,-0.400000,0.300000,-0.400000,0.000000,0.000000,2,feed";
    assert_eq!(low.lines().last(), Some(row));
}

/// The part of a picture that draws a program without compensation.
fn drawn(picture: &str) -> Vec<&str> {
    picture.lines().filter(|line| line.starts_with("<path")).collect()
}

/// Whole, long and short turns as SVG has them, in thousandths of a millimetre: radii, whether it is the long
/// way, whether it is counter-clockwise, and the end.
#[test]
fn pictures_draw_arcs_as_they_turn() {
    let circle = "A20000.0000 20000.0000 0";
    for (block, d) in [
        ("G03 I-20.", format!("{circle} 0 1 -20000.0000 0.0000{circle} 0 1 20000.0000 0.0000")),
        ("G03 X0. Y-20. I-20.", format!("{circle} 1 1 0.0000 -20000.0000")),
        ("G02 X0. Y-20. I-20.", format!("{circle} 0 0 0.0000 -20000.0000")),
    ] {
        let folder = folder(&[("arc.nc", &format!("G00 X20.\n{block} F1\n"))]);
        let picture = said(folder.path(), "offset arc.nc --format svg");
        let due = [
            "<path class=\"r\" d=\"M0.0000 0.0000L20000.0000 0.0000\"/>".to_owned(),
            format!("<path class=\"f\" d=\"M20000.0000 0.0000{d}\"/>"),
        ];
        assert_eq!(drawn(&picture), due, "{block}");
    }
}

/// All that the cutter sweeps has room, and Y points up.
#[test]
fn pictures_have_room_for_all() {
    let folder = folder(&[("square.nc", SQUARE), ("up.nc", "G00 X10. Y20.\nG01 X30. F1\n")]);
    let view = |options: &str| {
        let picture = said(folder.path(), &format!("offset {options} --format svg"));
        let (_, rest) = picture.split_once("viewBox=\"").unwrap();
        rest.split_once('"').unwrap().0.to_owned()
    };
    // From (0,0) to (30,20) and 4 % of 30 about it.
    assert_eq!(view("up.nc"), "-1200.0 -21200.0 32400.0 22400.0");
    // The cutter of 2 mm on (-10,-10) and on the whole circle of radius 22 about (20,0): from (-12,-24) to
    // (44,24), and 4 % of 56.
    assert_eq!(view("square.nc --radius 2"), "-14240.0 -26240.0 60480.0 52480.0");
}

/// A picture is of one plane, that of the first contour.
#[test]
fn pictures_are_of_the_plane_of_the_first_contour() {
    let in_yz =
        "G19\nG00 Y-10. Z-10.\nG41 G01 Y0. Z0. F300\nZ20.\nY20.\nZ0.\nY0.\nG40 Y-10. Z-10.\n";
    let program = format!("{in_yz}G17\nG02 I5.\n{SQUARE}");
    let folder = folder(&[("two.nc", &program)]);
    let picture = said(folder.path(), "offset two.nc --radius 2 --format svg");
    let of = |class: &str| -> Vec<_> {
        let class = format!("class=\"{class}\"");
        drawn(&picture).into_iter().filter(|line| line.contains(&class)).collect()
    };
    assert_eq!((of("o").len(), of("i").len(), of("p").len()), (1, 1, 1));
    assert!(of("o")[0].contains("stroke-width=\"4000.000\""), "{:?}", of("o"));
    // What is lighter lies over what is darker.
    assert!(picture.find("class=\"o\"") < picture.find("class=\"i\""));
    // The square of 20 mm, and its side swept 2 mm away.
    assert!(of("p")[0].contains("M0.0000 0.0000L0.0000 20000.0000"), "{:?}", of("p"));
    // The turn is seen from the side, where its start and its end are one point.
    assert!(of("f").is_empty(), "{:?}", of("f"));
}
