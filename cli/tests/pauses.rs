//! Dwells and program stops, tools and spindle speeds, in `onepulse run` and `onepulse profile`.
#![allow(clippy::unwrap_used)]

mod common;

use common::{onepulse, report, said};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A dwell at the start, between two blocks and at the end; a stop; and a block that goes straight on.
const PROGRAM: &str = "G04 P0.1
T3 S1200
G01 X5. F1200
G04 P0.25
Y3.
M00
X0. S800.5
X-4.
G04 X0.5
M02
";

/// The same blocks in the same lines, without a pause.
fn without_pauses() -> String {
    let is_pause = |line: &&str| line.starts_with("G04") || line.starts_with("M00");
    PROGRAM
        .lines()
        .map(|line| if is_pause(&line) { "\n".into() } else { format!("{line}\n") })
        .collect()
}

fn folder(program: &str) -> TempDir {
    common::folder(&[("p.nc", program)])
}

/// What a run of a program wrote.
struct Run {
    folder: TempDir,
    summary: String,
    report: Value,
}

impl Run {
    fn of(program: &str, options: &str) -> Self {
        let folder = folder(program);
        let summary = said(folder.path(), &format!("run p.nc {options}"));
        let report = report(folder.path());
        assert_eq!(report["hardware_agrees"], true);
        Self { folder, summary, report }
    }

    fn file(&self, name: &str) -> String {
        fs::read_to_string(self.folder.path().join("out").join(name)).unwrap()
    }

    fn seconds(&self) -> f64 {
        self.report["totals"]["duration_s"].as_f64().unwrap()
    }

    /// The lines of the blocks with their durations.
    fn blocks(&self) -> Vec<(u64, f64)> {
        let blocks = self.report["blocks"].as_array().unwrap().iter();
        blocks
            .map(|block| (block["line"].as_u64().unwrap(), block["duration_s"].as_f64().unwrap()))
            .collect()
    }

    fn wave(&self) -> Wave {
        Wave::read(&self.folder.path().join("out/waves.vcd"))
    }
}

/// The signals of the top scope as changes, (picoseconds, bits).
struct Wave {
    signals: BTreeMap<String, Vec<(u64, String)>>,
    end: u64,
}

impl Wave {
    fn read(path: &Path) -> Self {
        let mut wave = wellen::simple::read(path).unwrap();
        let hierarchy = wave.hierarchy();
        let vars: Vec<_> = hierarchy
            .all_vars()
            .map(|var| (hierarchy[var].full_name(hierarchy), hierarchy[var].signal_ref()))
            .filter_map(|(name, signal)| Some((name.strip_prefix("onepulse.")?.to_owned(), signal)))
            .filter(|(name, _)| !name.contains('.'))
            .collect();
        wave.load_signals(&vars.iter().map(|(_, signal)| *signal).collect::<Vec<_>>());
        let times = wave.time_table().to_vec();
        assert!(times.windows(2).all(|pair| pair[0] < pair[1]));
        let changes = |signal| {
            let changes = wave.get_signal(signal).unwrap().iter_changes();
            changes.map(|(at, value)| (times[at as usize], value.to_string())).collect()
        };
        let signals = vars.into_iter().map(|(name, signal)| (name, changes(signal))).collect();
        Self { signals, end: *times.last().unwrap() }
    }

    /// When a bit rises.
    fn rises(&self, signal: &str) -> Vec<u64> {
        let changes = self.signals[signal].iter();
        changes.filter(|(_, bits)| bits == "1").map(|(time, _)| *time).collect()
    }

    /// The numbers that a signal becomes, and when.
    fn numbers(&self, signal: &str) -> Vec<(u64, i64)> {
        let number = |bits: &str| {
            let value = u64::from_str_radix(bits, 2).unwrap() as i64;
            let is_negative = bits.len() > 32 && bits.starts_with('1');
            if is_negative { value - (1 << bits.len()) } else { value }
        };
        self.signals[signal].iter().map(|(time, bits)| (*time, number(bits))).collect()
    }

    /// The number that it is at a time in seconds.
    fn at(&self, signal: &str, seconds: f64) -> i64 {
        let numbers = self.numbers(signal);
        let time = (seconds * 1e12) as u64;
        numbers[numbers.partition_point(|(since, _)| *since <= time) - 1].1
    }
}

fn assert_near(found: f64, due: f64) {
    assert!((found - due).abs() < 1e-9, "{found} is not {due}");
}

/// When each line begins, of these blocks and the dwells of the program.
fn begins(blocks: &[(u64, f64)]) -> Vec<(u64, f64)> {
    let mut parts = blocks.to_vec();
    parts.extend([(1, 0.1), (4, 0.25), (9, 0.5)]);
    parts.sort_by_key(|(line, _)| *line);
    let mut time = 0.0;
    let begin = |(line, seconds)| {
        let since = time;
        time += seconds;
        (line, since)
    };
    parts.into_iter().map(begin).collect()
}

const EVEN: [&str; 4] = ["", "--method dda", "--method min-deviation", "--two-level"];

#[test]
fn dwells_take_their_time_and_change_nothing_else() {
    for options in EVEN {
        let [with, without] = [PROGRAM, &without_pauses()].map(|text| Run::of(text, options));
        assert_near(with.seconds(), without.seconds() + 0.85);
        assert_eq!(with.report["blocks"], without.report["blocks"]);
        assert_eq!(with.report["final_position"], without.report["final_position"]);
        for name in ["pulses.csv", "path.svg"] {
            assert_eq!(with.file(name), without.file(name), "{options}: {name}");
        }
        let pauses = json!([
            { "line": 1, "dwell_s": 0.1 },
            { "line": 4, "dwell_s": 0.25 },
            { "line": 6, "dwell_s": null },
            { "line": 9, "dwell_s": 0.5 },
        ]);
        assert_eq!(with.report["pauses"], pauses);
        assert_eq!(without.report.get("pauses"), None);

        let shown: Vec<Vec<_>> =
            with.summary.lines().map(|line| line.split_whitespace().collect()).collect();
        for line in
            [&["1", "dwell", "0.100", "s"][..], &["4", "dwell", "0.250", "s"], &["6", "stop"]]
        {
            assert!(shown.iter().any(|shown| shown == line), "{line:?}: {}", with.summary);
        }
        let count = "dwells: 3, 0.850 s in all; program stops: 1";
        assert!(with.summary.contains(count), "{}", with.summary);
        let total = format!(" {:.3} s; final position -400,300", with.seconds());
        assert!(with.summary.contains(&total), "{}", with.summary);
        for word in ["dwell", "stop"] {
            assert!(!without.summary.contains(word), "{}", without.summary);
        }
    }
}

#[test]
fn nothing_is_clocked_while_the_time_of_a_dwell_passes() {
    for options in EVEN {
        let [with, without] = [PROGRAM, &without_pauses()].map(|text| Run::of(text, options));
        let (wave, even) = (with.wave(), without.wave());
        assert!((wave.end as f64 / 1e12 - with.seconds()).abs() < 1e-9, "{options}");
        // Each dwell shows its line for its time, and the stop takes none.
        let lines = wave.numbers("program_line");
        let due = begins(&with.blocks());
        assert_eq!(lines.len(), due.len(), "{options}: {lines:?}");
        for ((time, line), (due, since)) in lines.iter().zip(due) {
            assert_eq!(*line as u64, due, "{options}");
            assert!((*time as f64 / 1e12 - since).abs() < 1e-9, "{options}: line {due}");
        }
        // Where each line ends, the clock rises once more, which here is no other's first edge.
        let shift = |time: u64| 1e11 + if time as f64 > 1.001e11 + 2.6e11 { 2.5e11 } else { 0.0 };
        assert_eq!(wave.rises("clk").len(), even.rises("clk").len() + 1, "{options}");
        for signal in ["pulse_x", "pulse_y"] {
            let (found, due) = (wave.rises(signal), even.rises(signal));
            assert_eq!(found.len(), due.len(), "{options}: {signal}");
            for (found, due) in found.into_iter().zip(due) {
                let unshifted = found as f64 - shift(found);
                assert!((unshifted - due as f64).abs() < 10.0, "{options}: {found} for {due}");
            }
        }
        let (_, dwell) = begins(&with.blocks())[2];
        let within = |time: &&u64| {
            let time = **time as f64 / 1e12;
            time > dwell + 1e-9 && time < dwell + 0.25 - 1e-9
        };
        assert_eq!(wave.rises("clk").iter().filter(within).count(), 0, "{options}");
        for seconds in [dwell + 0.01, dwell + 0.24] {
            assert_eq!(wave.at("position_x", seconds), 500, "{options}");
            for bit in ["clk", "pulse_x", "pulse_y"] {
                assert_eq!(wave.at(bit, seconds), 0, "{options}: {bit}");
            }
        }
        assert_eq!((wave.at("clk", 0.05), wave.at("position_x", 0.05)), (0, 0), "{options}");
    }
}

#[test]
fn tools_and_spindle_speeds_are_reported_once_they_are_said() {
    let words = |program: &str| -> Vec<Value> {
        let report = Run::of(program, "--no-waves").report;
        let blocks = report["blocks"].as_array().unwrap().iter();
        blocks.map(|block| json!([block.get("tool"), block.get("spindle_rpm")])).collect()
    };
    let each = [json!([3, 1200.0]), json!([3, 1200.0]), json!([3, 800.5]), json!([3, 800.5])];
    assert_eq!(words(PROGRAM), each);
    let late = words("G01 X1. F600\nT2\nX2.\nS0\nX3. T0\n");
    assert_eq!(late, [json!([null, null]), json!([2, null]), json!([0, 0.0])]);
    // Not as null: not at all.
    let text = Run::of("G01 X1. F600\n", "--no-waves").file("report.json");
    assert!(!text.contains("tool") && !text.contains("spindle"), "{text}");
}

/// The rows of `onepulse profile`: time, line, x, y, speed, and the following errors of x and y.
fn profile(folder: &Path, options: &str) -> Vec<[f64; 7]> {
    let text = said(folder, &format!("profile p.nc --servo-gain 30 {options}"));
    let row = |line: &str| {
        let cells: Vec<_> =
            line.split(',').map(|cell| cell.parse::<f64>().unwrap_or(f64::NAN)).collect();
        [cells[0], cells[1], cells[2], cells[3], cells[4], cells[9], cells[10]]
    };
    text.lines().skip(1).map(row).collect()
}

/// The rows of a line.
fn of_line(rows: &[[f64; 7]], line: f64) -> Vec<[f64; 7]> {
    rows.iter().filter(|row| row[1] == line).copied().collect()
}

/// With 20 mm/s and 1000 mm/s² a line from rest to rest takes 20 ms more than at the full speed: 0.27,
/// 0.17 and, for two that go straight on, 0.47 s.
const ENDS: [(f64, f64); 6] =
    [(1.0, 0.1), (3.0, 0.37), (4.0, 0.62), (5.0, 0.79), (8.0, 1.26), (9.0, 1.76)];

#[test]
fn a_planned_motion_is_at_rest_in_every_pause() {
    for jerk in ["", "--jerk 20000"] {
        let rows = profile(folder(PROGRAM).path(), jerk);
        let through = profile(folder(&without_pauses()).path(), jerk);
        let exit = |rows: &[[f64; 7]], line| of_line(rows, line).last().unwrap()[4];
        for line in [3.0, 5.0] {
            assert_eq!(exit(&rows, line), 0.0, "line {line}");
            // Corners of a right angle are passed at 10 mm/s by √2.
            assert!((exit(&through, line) - 50_f64.sqrt()).abs() < 1e-6, "line {line}");
        }
        for rows in [&rows, &through] {
            assert_eq!(exit(rows, 7.0), 20.0, "straight on");
        }
        assert_eq!(of_line(&rows, 6.0), [[0.0; 7]; 0]);
        for (line, point) in [(1.0, [0.0, 0.0]), (4.0, [5.0, 0.0]), (9.0, [-4.0, 3.0])] {
            let rows = of_line(&rows, line);
            assert!(rows.len() >= 13, "line {line}");
            assert!(rows.iter().all(|row| row[2..5] == [point[0], point[1], 0.0]), "line {line}");
            assert_eq!(of_line(&through, line), [[0.0; 7]; 0]);
        }
        // The periods run on: no two rows are further apart.
        let passed = rows.windows(2).map(|pair| pair[1][0] - pair[0][0]);
        assert!(passed.into_iter().all(|passed| passed > 0.0 && passed < 0.008 + 2e-9));
    }
    let rows = profile(folder(PROGRAM).path(), "");
    for (line, end) in ENDS {
        let rows = of_line(&rows, line);
        // After the last dwell, the axes have come to rest long since.
        assert_near(rows.last().unwrap()[0], end);
    }
}

#[test]
fn the_following_errors_decay_in_a_dwell() {
    let rows = profile(folder(PROGRAM).path(), "");
    for (line, axis, first) in [(4.0, 5, 0.3), (9.0, 5, -0.3)] {
        let errors = of_line(&rows, line).into_iter().map(|row| row[axis]);
        let errors: Vec<_> = errors.filter(|error| !error.is_nan()).collect();
        assert!(errors[0] / first > 1.0, "{errors:?}");
        // Each period takes K_v·T of it: 30/s by 8 ms.
        for pair in errors.windows(2) {
            assert!((pair[1] - 0.76 * pair[0]).abs() < 2e-9, "{pair:?}");
        }
        assert!(errors.last().unwrap().abs() < 1e-3);
    }
    // A stop takes no time: the next block begins with what is left.
    let [before, after] = [5.0, 7.0].map(|line| of_line(&rows, line));
    assert!(before.iter().rev().find(|row| !row[6].is_nan()).unwrap()[6] > 0.3);
    assert!(after.iter().find(|row| !row[6].is_nan()).unwrap()[6] > 0.2);
}

#[test]
fn an_accelerated_run_stands_still_as_its_profile_does() {
    let options = "--two-level --accelerate --servo-gain 30";
    let run = Run::of(PROGRAM, options);
    assert_near(run.seconds(), 1.76);
    assert_near(run.report["motion"]["duration_s"].as_f64().unwrap(), 1.76);
    let due = [(3, 0.27), (5, 0.17), (7, 0.26), (8, 0.21)];
    for ((line, seconds), due) in run.blocks().into_iter().zip(due) {
        assert_eq!(line, due.0);
        assert_near(seconds, due.1);
    }
    let plot = said(run.folder.path(), "profile p.nc --servo-gain 30 --format svg");
    assert_eq!(run.file("profile.svg"), plot);

    let wave = run.wave();
    assert!((wave.end as f64 / 1e12 - 1.76).abs() < 1e-9);
    let lines = wave.numbers("program_line");
    let due = begins(&run.blocks());
    assert_eq!(lines.len(), due.len());
    for ((time, line), (due, since)) in lines.iter().zip(due) {
        assert_eq!(*line as u64, due);
        assert!((*time as f64 / 1e12 - since).abs() < 2e-9, "line {line}");
    }
    // The errors of each period, in nanometres, from its end on; and no sample is made.
    let dwell = of_line(&profile(run.folder.path(), ""), 4.0);
    for row in dwell.iter().filter(|row| !row[5].is_nan()) {
        let found = wave.at("error_x", row[0] + 1e-6);
        assert!((found as f64 - row[5] * 1e6).abs() <= 1.0, "{row:?}: {found}");
    }
    for seconds in [0.05, 0.371, 0.5, 0.619, 1.5] {
        for signal in ["speed", "clk", "sample"] {
            assert_eq!(wave.at(signal, seconds), 0, "{signal} at {seconds} s");
        }
    }
    assert_eq!(wave.at("speed", 0.2), 20_000);
    let samples: u64 = run.report["blocks"]
        .as_array()
        .unwrap()
        .iter()
        .map(|block| block["sampling"]["samples"].as_u64().unwrap())
        .sum();
    assert_eq!(wave.rises("sample").len() as u64, samples);
}

#[test]
fn a_program_may_stand_still_and_nothing_else() {
    for options in ["", "--two-level", "--two-level --accelerate --servo-gain 30"] {
        let run = Run::of("M00\nG04 P0.5\nG04 P0\n", options);
        assert_eq!(run.report["totals"]["duration_s"], 0.5);
        assert_eq!(run.report["totals"]["blocks"], 0);
        assert_eq!(run.report["pauses"][2], json!({ "line": 3, "dwell_s": 0.0 }));
        assert!(run.wave().end.abs_diff(500_000_000_000) <= 2, "{options}");
    }
    let rows = profile(folder("M00\nG04 P0.5\nG04 P0\n").path(), "");
    assert_eq!(rows.len(), 63);
    assert!(rows.iter().all(|row| row[1] == 2.0 && row[2..5] == [0.0; 3]));
    assert_near(rows[62][0], 0.5);
}

/// A nanosecond is less than half a clock: the edges stay in order.
#[test]
fn the_shortest_dwell_has_a_place_on_the_time_axis() {
    let text = "G01 X0.1 F600\nG04 P0.000000001\nX0.2\n";
    for options in ["", "--two-level", "--two-level --accelerate"] {
        let run = Run::of(text, options);
        let wave = run.wave();
        let clk = &wave.signals["clk"];
        assert!(clk.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 != pair[1].1));
        let lines: Vec<_> = wave.numbers("program_line").iter().map(|(_, line)| *line).collect();
        assert_eq!(lines, [1, 2, 3], "{options}");
        assert!((wave.end as f64 / 1e12 - run.seconds()).abs() < 1e-9, "{options}");
    }
}

#[test]
fn a_dwell_outside_the_window_is_not_traced() {
    // Ten pulses of four clocks, the dwell, and ten more, at 10 mm/s.
    let text = "G01 X0.1 F600\nG04 P1\nX0.2\n";
    let seconds = |options: &str| Run::of(text, options).wave().end as f64 / 1e12;
    assert_near(seconds(""), 1.02);
    assert!(seconds("--clocks 40") < 0.011);
    assert_near(seconds("--clocks 41"), 1.010_125);
}

#[test]
fn a_planned_dwell_of_days_is_refused() {
    let folder = folder("G01 X1. F600\nG04 P1000000\n");
    let output = onepulse(folder.path(), "run p.nc --two-level --accelerate");
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{errors}");
    assert!(errors.contains("over 5000000 sample periods"), "{errors}");
    assert!(!folder.path().join("out").exists());
}
