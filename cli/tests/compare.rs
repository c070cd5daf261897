//! `onepulse compare`: all methods side by side on one curve.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use assert_cmd::cargo::cargo_bin_cmd;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::process::Output;
use tempfile::TempDir;

fn run(command: &str, arguments: &str) -> Output {
    cargo_bin_cmd!("onepulse").arg(command).args(arguments.split_whitespace()).output().unwrap()
}

fn stdout(command: &str, arguments: &str) -> String {
    let output = run(command, arguments);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments}: {errors}");
    assert_eq!(errors, "", "{arguments}");
    String::from_utf8(output.stdout).unwrap()
}

/// The methods of a comparison by their names, as in "dda half load".
fn methods(arguments: &str) -> BTreeMap<String, Value> {
    let text = stdout("compare", &format!("{arguments} --format json"));
    let comparison: Value = serde_json::from_str(&text).unwrap();
    let methods = comparison["methods"].as_array().unwrap();
    let name = |method: &Value| {
        let [name, variant] = ["method", "variant"].map(|key| method[key].as_str().unwrap());
        format!("{name} {variant}").trim_end().to_owned()
    };
    methods.iter().map(|method| (name(method), method.clone())).collect()
}

fn cycles(methods: &BTreeMap<String, Value>) -> Vec<(&str, u64)> {
    let cycles = |method: &Value| method["cycles"].as_u64().unwrap();
    methods.iter().map(|(name, method)| (name.as_str(), cycles(method))).collect()
}

fn check_close(found: &Value, expected: f64, what: &str) {
    let found = found.as_f64().unwrap_or_else(|| panic!("{what}: {found} is no number"));
    assert!((found - expected).abs() < 1e-9, "{what}: {found}: {expected} is due");
}

fn check_refused(arguments: &str, status: i32, words: &str) {
    let output = run("compare", arguments);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(status), "{arguments}: {errors}");
    assert_eq!(output.stdout, b"", "{arguments}");
    assert!(errors.contains(words), "{arguments}: '{words}' is missing in: {errors}");
    assert!(!errors.contains("panicked"), "{arguments}: {errors}");
}

/// Worked by hand: F = 5y − 3x after each step, and the distance is |F|/√34.
#[test]
fn the_textbook_line() {
    let methods = methods("line --to 5,3");
    assert_eq!(
        cycles(&methods),
        [
            ("brm", 8),
            ("brm smoothed by 8", 64),
            ("compare-integral", 7),
            ("dda half load", 8),
            ("dda normalized", 8),
            ("dda zero preset", 8),
            ("min-deviation", 5),
            ("ppc", 8),
            ("vector", 5)
        ]
    );
    let length = 34_f64.sqrt();
    for (name, [largest, mean_square], feed) in [
        // F: -3 2 -1 4 1 -2 3 0.
        ("ppc", [4.0, 44.0 / 8.0], length / 8.0),
        // F: 2 -1 1 -2 0.
        ("min-deviation", [2.0, 10.0 / 5.0], length / 5.0 / 2_f64.sqrt()),
        // F: -3 2 -1 1 -2 3 0.
        ("compare-integral", [3.0, 28.0 / 7.0], length / 7.0 / 2_f64.sqrt()),
    ] {
        let method = &methods[name];
        check_close(&method["deviation"]["largest"], largest / length, name);
        check_close(&method["deviation"]["rms"], mean_square.sqrt() / length, name);
        check_close(&method["feed"]["mean"], feed, name);
        check_close(&method["feed"]["spread"], 1.0, name);
    }
    // x in the cycles 1 3 5 6 8, y in 2 4 7.
    check_close(&methods["ppc"]["jitter"]["x"], 0.1875_f64.sqrt() / 1.75, "x");
    check_close(&methods["ppc"]["jitter"]["y"], 0.5 / 2.5, "y");
    for method in methods.values() {
        assert_eq!([&method["pulses"]["x"], &method["pulses"]["y"]], [5, 3], "{method}");
        assert_eq!(method["endpoint_exact"], true, "{method}");
    }
}

#[test]
fn the_textbook_arc() {
    let methods = methods("arc --from 5,0 --to 0,5 --ccw");
    assert_eq!(
        cycles(&methods),
        [
            ("compare-integral", 9),
            ("dda staggered", 24),
            ("dda textbook, half", 12),
            ("dda textbook, zero", 14),
            ("min-deviation", 7),
            ("ppc", 10),
            ("vector", 7)
        ]
    );
    // Farthest: (4,0); (4,1), √17 from the centre; (5,2) and (2,5), √29; (2,5) too.
    check_close(&methods["ppc"]["deviation"]["largest"], 1.0, "ppc");
    check_close(&methods["vector"]["deviation"]["largest"], 5.0 - 17_f64.sqrt(), "vector");
    let nearest = &methods["min-deviation"]["deviation"]["largest"];
    check_close(nearest, 29_f64.sqrt() - 5.0, "min-deviation");
    let quarter = 2.5 * std::f64::consts::PI;
    check_close(&methods["ppc"]["feed"]["mean"], quarter / 10.0, "ppc");
}

#[test]
fn a_parabola_by_its_three_methods() {
    let methods = methods("parabola --p 2 --to 4,4");
    let cycles = cycles(&methods);
    let names: Vec<_> = cycles.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ["dda half load", "dda zero preset", "min-deviation", "ppc"]);
    assert_eq!([cycles[1].1, cycles[3].1], [18, 8]);
    check_close(&methods["ppc"]["deviation"]["largest"], 1.0, "(1,0)");
    assert!(methods["min-deviation"]["deviation"]["largest"].as_f64().unwrap() <= 0.5);
}

#[test]
fn lines_in_space_leave_out_the_methods_of_the_plane() {
    let methods = methods("line --to 1,1,7,0");
    let names: Vec<_> = methods.keys().map(String::as_str).collect();
    assert!(!names.contains(&"vector") && !names.contains(&"compare-integral"), "{names:?}");
    // By comparison the farthest is (1,1,1,0): its distance squared is 3 − 9²/51.
    check_close(&methods["ppc"]["deviation"]["largest"], (72.0_f64 / 51.0).sqrt(), "ppc");
    assert_eq!(methods["ppc"]["pulses"], serde_json::json!({"x": 1, "y": 1, "z": 7, "a": 0}));
    assert_eq!(methods["ppc"]["jitter"]["a"], Value::Null);
}

/// Point-by-point comparison feeds 1/√2 of its speed at 45°; a digital integrator's speed does
/// not depend on the direction, and is R/2ⁿ pulses a cycle.
#[test]
fn the_feed_on_a_large_circle() {
    let methods = methods("arc --from 1000,0 --to 1000,0 --cw --bits 12");
    let spread = |name: &str| methods[name]["feed"]["spread"].as_f64().unwrap();
    assert!((spread("ppc") - 2_f64.sqrt()).abs() < 0.03, "{}", spread("ppc"));
    assert!(spread("dda staggered") < 1.06, "{}", spread("dda staggered"));
    let mean = methods["dda staggered"]["feed"]["mean"].as_f64().unwrap();
    assert!((mean - 1000.0 / 4096.0 / 2_f64.sqrt()).abs() < 1e-4, "{mean}");
}

#[test]
fn normalization_makes_a_short_line_fast() {
    let methods = methods("line --to 5,3 --bits 8");
    let cycles = |name: &str| methods[name]["cycles"].as_u64().unwrap();
    assert_eq!(["dda half load", "dda normalized", "brm"].map(cycles), [256, 8, 256]);
}

/// The measures again, from the pulses that `onepulse pulses` prints.
#[test]
fn the_measures_are_those_of_the_pulses() {
    let line = |[x, y]: [f64; 2]| (31.0 * y + 77.0 * x).abs() / 77_f64.hypot(31.0);
    let arc = |[x, y]: [f64; 2]| (x.hypot(y) - 50.0).abs();
    type Distance = fn([f64; 2]) -> f64;
    let cases: [(&str, &str, &str, Distance); 8] = [
        ("line --to -31,77", "--method ppc", "ppc", line),
        ("line --to -31,77", "--method dda --preset half", "dda half load", line),
        ("line --to -31,77", "--method brm --smooth 3", "brm smoothed by 8", line),
        ("line --to -31,77", "--method vector", "vector", line),
        ("arc --from 30,-40 --to 0,50 --cw", "", "ppc", arc),
        ("arc --from 30,-40 --to 0,50 --cw", "--method dda", "dda staggered", arc),
        ("arc --from 30,-40 --to 0,50 --cw", "--method min-deviation", "min-deviation", arc),
        ("arc --from 30,-40 --to 0,50 --cw", "--method compare-integral", "compare-integral", arc),
    ];
    for (curve, options, name, distance) in cases {
        let text = stdout("pulses", &format!("{curve} {options}"));
        let row =
            |line: &str| -> Vec<f64> { line.split(',').map(|c| c.parse().unwrap()).collect() };
        let rows: Vec<_> = text.lines().skip(1).map(row).collect();
        let distances: Vec<_> = rows.iter().map(|row| distance([row[3], row[4]])).collect();
        let method = &methods(curve)[name];
        let largest = distances.iter().fold(0.0, |most, d| f64::max(most, *d));
        check_close(&method["deviation"]["largest"], largest, name);
        let squares: f64 = distances.iter().map(|d| d * d).sum();
        let rms = (squares / rows.len() as f64).sqrt();
        check_close(&method["deviation"]["rms"], rms, name);
        for (axis, letter) in ["x", "y"].into_iter().enumerate() {
            let clocks: Vec<_> =
                rows.iter().filter(|row| row[1 + axis] != 0.0).map(|row| row[0]).collect();
            assert_eq!(method["pulses"][letter], clocks.len(), "{name}");
            let waits: Vec<_> = clocks.windows(2).map(|pair| pair[1] - pair[0]).collect();
            let mean = waits.iter().sum::<f64>() / waits.len() as f64;
            let square = |wait: &f64| (wait - mean).powi(2);
            let deviation = (waits.iter().map(square).sum::<f64>() / waits.len() as f64).sqrt();
            check_close(&method["jitter"][letter], deviation / mean, name);
        }
    }
}

#[test]
fn text_and_csv_have_the_same_rows() {
    for curve in ["line --to 5,3", "arc --from 5,0 --to 0,5 --ccw", "line --to 3,2,1"] {
        let text = stdout("compare", curve);
        let csv = stdout("compare", &format!("{curve} --format csv"));
        let mut lines = text.lines();
        assert!(lines.next().unwrap().starts_with(&format!("{curve}: ")), "{text}");
        assert_eq!(lines.next(), Some(""));
        assert!(lines.next().unwrap().starts_with("method "), "{text}");
        let rows: Vec<_> = lines.skip(1).collect();
        let mut csv = csv.lines();
        let headings = csv.next().unwrap();
        assert!(headings.starts_with("method,variant,cycles,pulses_x,pulses_y"), "{headings}");
        let csv: Vec<_> = csv.collect();
        assert_eq!(rows.len(), csv.len());
        for (row, csv) in rows.into_iter().zip(csv) {
            assert_eq!(row.split(' ').next(), csv.split(',').next());
            assert!(row.ends_with("exact") && csv.ends_with(",exact"), "{row} {csv}");
        }
    }
}

#[test]
fn a_line_without_length_has_no_feed() {
    let methods = methods("line --to 0,0");
    assert_eq!(methods["ppc"]["feed"], Value::Null);
    assert_eq!(methods["ppc"]["cycles"], 0);
    check_close(&methods["dda half load"]["deviation"]["rms"], 0.0, "dda");
}

#[test]
fn long_curves_are_measured_too() {
    let methods = methods("line --to 600000,400000");
    for method in methods.values() {
        assert_eq!([&method["pulses"]["x"], &method["pulses"]["y"]], [600_000, 400_000]);
    }
}

#[test]
fn end_points_beside_their_curve_are_measured_too() {
    for curve in [
        "arc --from 5,0 --to 1,40 --ccw",
        "arc --from 1,0 --to 1,0 --cw",
        "parabola --p 1 --to 60,1",
        "parabola --p -700 --to 0,-90 --axis x",
        "parabola --p 1 --to 0,0",
    ] {
        for method in methods(curve).values() {
            assert_eq!(method["endpoint_exact"], true, "{curve}");
            assert!(method["deviation"]["rms"].is_number(), "{curve}: {method}");
        }
    }
}

#[test]
fn the_picture_shows_every_path() {
    let folder = TempDir::new().unwrap();
    for (curve, paths, first) in [
        ("line --to 5,3", 9, "0,0 1,0 1,1 2,1 2,2 3,2 4,2 4,3 5,3"),
        ("arc --from 5,0 --to 0,5 --ccw", 7, "5,0 4,0 4,1 4,2 4,3 3,3 3,4 2,4 2,5 1,5 0,5"),
        ("parabola --p 2 --to 4,4", 4, "0,0 1,0 1,1 1,2 2,2 2,3 3,3 3,4 4,4"),
    ] {
        let file = folder.path().join("paths.svg");
        let table = stdout("compare", curve);
        let options = format!("{curve} --picture {}", file.to_str().unwrap());
        assert_eq!(stdout("compare", &options), table);
        let svg = fs::read_to_string(&file).unwrap();
        assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"), "{svg}");
        assert_eq!(svg.matches("<polyline ").count(), paths, "{curve}");
        assert_eq!(svg.matches("<text ").count(), paths + 1, "{curve}");
        assert!(svg.contains(&format!("points=\"{first}\"")), "{curve}: {svg}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}

#[test]
fn pictures_that_cannot_be_drawn_are_refused_and_leave_nothing() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("paths.svg");
    let picture = format!("--picture {}", file.to_str().unwrap());
    for (curve, words) in [
        ("line --to 100,0", "is 100 pulses long"),
        ("arc --from 1000,0 --to 1000,0 --cw", "is 6283 pulses long"),
        ("arc --from 5,0 --to 0,2000000000 --ccw", "pulses long"),
        ("parabola --p 1 --to 0,2000000000", "pulses long"),
        ("line --to 5,3,1", "2 axes"),
        ("arc --from 0,0 --to 5,0 --ccw", "centre"),
    ] {
        check_refused(&format!("{curve} {picture}"), 2, words);
    }
    let nowhere = folder.path().join("none/paths.svg");
    let nowhere = format!("line --to 5,3 --picture {}", nowhere.to_str().unwrap());
    check_refused(&nowhere, 1, "there is no folder");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn wrong_command_lines_are_refused() {
    for (arguments, words) in [
        ("line --to 5,3 --method ppc", "--method"),
        ("line --to 5,3 --format html", "--format"),
        ("line --to 5,3 --bits 2", "(for ppc)"),
        ("line --to 5,3 --bits 33", "--bits"),
        ("arc --from 8,0 --to 0,8 --ccw --bits 4", "needs 5 (for dda staggered)"),
        ("arc --from 0,0 --to 0,8 --ccw", "--from: the arc starts in its centre"),
        ("arc --from 5,0 --to 0,0 --ccw", "--to"),
        ("parabola --p 0 --to 4,4", "--p"),
        ("parabola --p 2 --to -4,4", "--to"),
        ("helix --from 5,0 --to 0,5 --rise 3 --cw", "nothing to compare"),
        ("line", "--to"),
    ] {
        check_refused(arguments, 2, words);
    }
}
