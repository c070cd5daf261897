//! `onepulse profile`: the motion of a program over time.
#![allow(clippy::unwrap_used)]

use assert_cmd::cargo::cargo_bin_cmd;
use std::collections::HashMap;
use std::fs;
use std::process::Output;

fn run(program: &str, options: &str) -> Output {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("part.ngc"), program).unwrap();
    fs::write(folder.path().join("machine.toml"), MACHINE).unwrap();
    cargo_bin_cmd!("onepulse")
        .current_dir(folder.path())
        .args(["profile", "part.ngc"])
        .args(options.split_whitespace())
        .output()
        .unwrap()
}

const MACHINE: &str = "pulse_mm = 0.001
period_ms = 2
acceleration_mm_per_s2 = 500
jerk_mm_per_s3 = 10000
corner_mm_per_s = 5
centripetal_mm_per_s2 = 200
servo_gain_per_s = 40
servo_drive_ms = 3
";

/// The columns by their names; NaN where a cell is empty.
fn columns(program: &str, options: &str) -> HashMap<String, Vec<f64>> {
    let output = run(program, options);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{errors}");
    let text = String::from_utf8(output.stdout).unwrap();
    let mut lines = text.lines();
    let names: Vec<_> = lines.next().unwrap().split(',').collect();
    let mut columns: HashMap<_, Vec<_>> =
        names.iter().map(|name| ((*name).to_owned(), Vec::new())).collect();
    for line in lines {
        let cells: Vec<_> = line.split(',').collect();
        assert_eq!(cells.len(), names.len(), "{line}");
        for (name, cell) in names.iter().zip(cells) {
            let number = if cell.is_empty() { f64::NAN } else { cell.parse().unwrap() };
            columns.get_mut(*name).unwrap().push(number);
        }
    }
    columns
}

/// A line, a corner of 90 degrees, a tangent arc, a full circle.
const PART: &str = "G91 G01 F3000
X20.
Y20.
G03 X-5. Y5. I-5.
G01 X-10.
G03 I0. J-8.
M02
";

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

#[test]
fn limits_of_the_command_line_are_kept() {
    let limits =
        "--pulse-mm 0.001 --period 1 --acceleration 400 --jerk 8000 --corner 3 --centripetal 100";
    let rows = columns(PART, limits);
    assert!((largest(&rows["speed"]) - 50.0).abs() < 1e-6, "F3000");
    assert!(largest(&rows["acceleration"]) <= 400.0 + 1e-3);
    assert!((largest(&rows["acceleration"]) - 400.0).abs() < 10.0, "what is allowed is used");
    assert!(largest(&rows["jerk"]) <= 8000.0 * (1.0 + 1e-3));
    // In a corner of 90 degrees the velocity jumps by v·√2.
    let corner = rows["line"].iter().position(|line| *line == 3.0).unwrap() - 1;
    assert!((rows["speed"][corner] * 2_f64.sqrt() - 3.0).abs() < 1e-5);
    // v²/R on the circle of radius 8.
    let on_circle = rows["line"].iter().zip(&rows["speed"]).filter(|(line, _)| **line == 6.0);
    let fastest = on_circle.fold(0.0_f64, |most, (_, speed)| most.max(*speed));
    assert!((fastest - 800_f64.sqrt()).abs() < 1e-5, "{fastest}");
    let end = rows["x"].len() - 1;
    assert_eq!((rows["x"][end], rows["y"][end]), (5.0, 25.0));
    assert_eq!(rows["speed"][end], 0.0);
}

/// From the positions alone, not from the columns that say so.
#[test]
fn the_points_move_as_the_columns_say() {
    let rows = columns(PART, "--pulse-mm 0.001 --period 1 --acceleration 400 --jerk 8000");
    let (mut last, mut at) = (0.0, [0.0, 0.0]);
    let mut pulses = [0.0; 2];
    for row in 0..rows["time"].len() {
        let [time, x, y] = ["time", "x", "y"].map(|name| rows[name][row]);
        let way = (x - at[0]).hypot(y - at[1]);
        let passed = time - last;
        assert!(passed > 0.0 && passed < 0.001 + 1e-8);
        // The speed before or after is within a·T of the mean.
        let mean = way / passed;
        assert!((mean - rows["speed"][row]).abs() < 0.4 + 1e-6 / passed, "row {row}: {mean}");
        for (axis, name) in ["interval_x", "interval_y"].iter().enumerate() {
            let interval = rows[*name][row];
            if !interval.is_nan() {
                pulses[axis] += passed / interval;
            }
        }
        (last, at) = (time, [x, y]);
    }
    // 20, then 20 back and forth on the arc of 5, 10, and four times 8 round the circle; in pulses.
    assert!((pulses[0] - (20e3 + 5e3 + 10e3 + 32e3)).abs() < 1.0, "{pulses:?}");
    assert!((pulses[1] - (20e3 + 5e3 + 32e3)).abs() < 1.0, "{pulses:?}");
}

#[test]
fn axes_follow_by_v_over_the_gain_and_come_to_rest() {
    let rows = columns("G91 G01 X100. F1200\n", "--period 1 --servo-gain 50 --servo-drive 2");
    let errors = &rows["error_x"];
    // 20 mm/s over 50 1/s.
    assert!((errors[2000] - 0.4).abs() < 1e-9, "{}", errors[2000]);
    // The last row has begun with what still was to correct: half a pulse of 0.01 mm is near by then.
    assert!(errors.last().unwrap().abs() < 0.01);
    assert!(errors[errors.len() - 10].abs() > 0.005);
    let planned = columns("G91 G01 X100. F1200\n", "--period 1");
    assert!(planned["time"].len() + 20 < rows["time"].len());
    assert!(!planned.contains_key("error_x"));
}

#[test]
fn a_machine_file_and_the_options_over_it() {
    let all = "--pulse-mm 0.001 --period 2 --acceleration 500 --jerk 10000 --corner 5 --centripetal 200 \
               --servo-gain 40 --servo-drive 3";
    let by_file = run(PART, "--config machine.toml").stdout;
    assert_eq!(by_file, run(PART, all).stdout);
    let other = run(PART, "--config machine.toml --corner 9").stdout;
    assert_eq!(other, run(PART, &all.replace("--corner 5", "--corner 9")).stdout);
    assert_ne!(other, by_file);
}

#[test]
fn a_plot_has_all_quantities() {
    let text = String::from_utf8(run(PART, "--format svg --servo-gain 30").stdout).unwrap();
    assert!(text.starts_with("<svg"));
    for quantity in ["speed", "acceleration", "jerk", "pulse interval", "following error"] {
        assert!(text.contains(quantity), "{quantity}");
    }
    let text = String::from_utf8(run(PART, "--format svg").stdout).unwrap();
    assert!(!text.contains("following error"));
    // A program that does not move.
    assert!(run("G90\n", "--format svg").status.success());
}

#[test]
fn what_is_wrong_is_refused() {
    for (options, words, status) in [
        ("--acceleration 0", "acceleration", 2),
        ("--jerk -1", "jerk", 2),
        ("--corner nan", "corner", 2),
        ("--period 0", "--period", 2),
        ("--servo-gain 400", "gain", 2), // K_v·T = 3.2
        ("--servo-drive 2", "--servo-gain", 2),
        ("--format png", "--format", 2),
        ("--config nothing.toml", "nothing.toml", 1),
    ] {
        let output = run(PART, options);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(status), "{options}: {errors}");
        assert!(errors.contains(words), "{options}: {errors}");
        assert!(output.stdout.is_empty(), "{options}");
    }
    let output = run("G91 G01 X1. F300\nX1. Q\n", "");
    assert_eq!(output.status.code(), Some(1));
    assert!(output.stdout.is_empty());
    assert!(String::from_utf8(output.stderr).unwrap().contains("part.ngc:2:"));
}
