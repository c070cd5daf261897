//! `onepulse run --two-level --accelerate`: speeds planned through the whole program, made by two levels.
#![allow(clippy::unwrap_used)]

mod common;

use common::{onepulse, report, said};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A folder with a program and a machine.
fn folder(program: &str, machine: &str) -> TempDir {
    common::folder(&[("p.nc", program), ("m.toml", machine)])
}

const ACCELERATE: &str = "run p.nc --out out --two-level --accelerate";

/// The report of an accelerated run, in which all holds that holds of every one, and the summary.
fn accelerated(folder: &Path, arguments: &str) -> (Value, String) {
    let summary = said(folder, &format!("{ACCELERATE} {arguments}"));
    let report = report(folder);
    check(&report);
    (report, summary)
}

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("no number {name} in {value}"))
}

fn blocks(report: &Value) -> &[Value] {
    report["blocks"].as_array().unwrap()
}

/// What holds of every accelerated run.
fn check(report: &Value) {
    assert_eq!(report["hardware_agrees"], true);
    let mut seconds = 0.0;
    for block in blocks(report) {
        assert_eq!(block["method"], "two levels", "{block}");
        assert_eq!(block["endpoint_exact"], true, "{block}");
        assert_eq!(block["hardware_agrees"], true, "{block}");
        let sampling = &block["sampling"];
        assert_eq!(sampling["method"], "planned");
        let samples = sampling["samples"].as_u64().unwrap();
        assert_eq!(block["cycles"], samples << sampling["bits"].as_u64().unwrap(), "{block}");
        // Whole periods, and at most a part before and one after them.
        let duration = number(block, "duration_s");
        let periods = duration / (number(sampling, "period_ms") / 1000.0);
        assert!((periods - 1e-3..periods + 2.0).contains(&(samples as f64)), "{block}");
        seconds += duration;
        let parts = ["chord_error", "radius_error", "rounding", "fine"];
        let bound: f64 = parts.iter().map(|part| number(sampling, part)).sum();
        assert!(number(block, "largest_deviation") <= bound + 1e-9, "{block}");
        // A point is rounded by half a pulse an axis, and a DDA line with half load keeps ½√2.
        assert!(number(sampling, "rounding") <= 0.5_f64.sqrt() + 1e-9, "{block}");
        assert!(number(sampling, "fine") <= 0.5_f64.sqrt() + 1e-9, "{block}");
        let speeds = &sampling["speeds_mm_per_s"];
        let [entry, peak, exit, steady] =
            ["entry", "peak", "exit", "steady"].map(|name| number(speeds, name));
        assert!(entry <= peak && exit <= peak && peak <= steady, "{block}");
    }
    let motion = &report["motion"];
    for total in [number(&report["totals"], "duration_s"), number(motion, "duration_s")] {
        assert!((total - seconds).abs() <= 1e-9 * (1.0 + seconds), "{total} s for {seconds}");
    }
    // Each block goes on with the speed of the one before, from rest to rest.
    let speed = |block: &Value, name| number(&block["sampling"]["speeds_mm_per_s"], name);
    for pair in blocks(report).windows(2) {
        assert_eq!(speed(&pair[0], "exit"), speed(&pair[1], "entry"));
    }
    assert_eq!(speed(&blocks(report)[0], "entry"), 0.0);
    assert_eq!(speed(blocks(report).last().unwrap(), "exit"), 0.0);
}

/// A record of `onepulse profile`, or where the pulses of a run stand.
#[derive(Clone, Copy, Debug)]
struct Record {
    time: f64,
    line: i64,
    point: [f64; 2],
    speed: f64,
}

/// What `onepulse profile` says of `p.nc`, of records in which a speed is commanded.
fn profile(folder: &Path, options: &str) -> Vec<Record> {
    let text = said(folder, &format!("profile p.nc {options}"));
    let record = |line: &str| {
        let mut cells = line.split(',').map(|cell| cell.parse::<f64>().unwrap());
        let mut next = || cells.next().unwrap();
        let (time, line) = (next(), next() as i64);
        let point = [next(), next()];
        Record { time, line, point, speed: next() }
    };
    text.lines().skip(1).map(record).collect()
}

/// Where the pulses stand at the end of each microsegment: (program line, position).
fn ends_of_microsegments(folder: &Path, report: &Value) -> Vec<(i64, [i64; 2])> {
    let text = fs::read_to_string(folder.join("out/pulses.csv")).unwrap();
    let mut rows = text
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect::<Vec<i64>>())
        .peekable();
    let (mut ends, mut position) = (vec![], [0, 0]);
    for block in blocks(report) {
        let line = block["line"].as_i64().unwrap();
        let bits = block["sampling"]["bits"].as_u64().unwrap();
        for sample in 1..=block["sampling"]["samples"].as_i64().unwrap() {
            while let Some(row) = rows.next_if(|row| row[0] == line && row[1] <= sample << bits) {
                position = [position[0] + row[2], position[1] + row[3]];
                assert_eq!(position, row[4..], "line {line}");
            }
            ends.push((line, position));
        }
    }
    assert_eq!(rows.next(), None);
    ends
}

/// The bracket of the repository, as a program text.
fn bracket() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../programs/bracket.ngc");
    fs::read_to_string(path).unwrap()
}

#[test]
fn the_bracket_moves_as_its_profile_says() {
    for options in
        ["", "--jerk 20000 --corner 3", "--period 5.3 --acceleration 300 --pulse-mm 0.001"]
    {
        let folder = folder(&bracket(), "");
        let (report, summary) = accelerated(folder.path(), &format!("--no-waves {options}"));
        assert_eq!(blocks(&report).len(), 17);
        assert_eq!(report["final_position"]["x"], 0);
        assert_eq!(report["final_position"]["y"], 0);
        let pulse = number(&report["machine"], "pulse_mm");
        let records = profile(folder.path(), options);
        let ends = ends_of_microsegments(folder.path(), &report);
        assert_eq!(ends.len(), records.len(), "{options}");
        for ((line, position), record) in ends.iter().zip(&records) {
            assert_eq!(*line, record.line);
            for axis in 0..2 {
                let off = position[axis] as f64 * pulse - record.point[axis];
                assert!(off.abs() <= pulse / 2.0 + 1e-6, "{record:?} for {position:?}");
            }
        }
        // Blocks end when they do there; the csv has nine digits after the point.
        let mut time = 0.0;
        for block in blocks(&report) {
            time += number(block, "duration_s");
            let line = block["line"].as_i64().unwrap();
            let last = records.iter().rfind(|record| record.line == line).unwrap();
            assert!((time - last.time).abs() <= 1e-9, "line {line}: {time} s for {last:?}");
        }
        let plot = said(folder.path(), &format!("profile p.nc --format svg {options}"));
        assert!(plot == fs::read_to_string(folder.path().join("out/profile.svg")).unwrap());
        let samples: u64 =
            blocks(&report).iter().map(|b| b["sampling"]["samples"].as_u64().unwrap()).sum();
        assert!(summary.contains(&format!("{samples} samples, at periods of")), "{summary}");
    }
}

/// From the pulses alone: the whole way of a line's records by their times.
#[test]
fn pulses_of_a_line_keep_the_acceleration() {
    let (period, pulse, limit) = (0.008, 0.001, 250.0);
    for jerk in ["", "--jerk 3000"] {
        let folder = folder("G01 X30. Y40. F3000\n", "");
        let options = format!("--pulse-mm {pulse} --acceleration {limit} {jerk}");
        let (report, _) = accelerated(folder.path(), &format!("--no-waves {options}"));
        let ends = ends_of_microsegments(folder.path(), &report);
        // All but the last record are on the grid. Each way along the line is rounded by half a pulse an
        // axis, so by half of 3/5 + 4/5 of a pulse.
        let mut ways: Vec<_> =
            ends.iter().map(|(_, [x, y])| (0.6 * *x as f64 + 0.8 * *y as f64) * pulse).collect();
        ways.pop();
        ways.insert(0, 0.0);
        let mean = |pair: &[f64]| (pair[1] - pair[0]) / period;
        let speeds: Vec<_> = ways.windows(2).map(mean).collect();
        let fastest = speeds.iter().fold(0.0_f64, |most, v| most.max(*v));
        assert!((fastest - 50.0).abs() <= 1.4 * pulse / period, "{fastest}");
        // A second difference of ways has four roundings.
        let noise = 4.0 * 0.7 * pulse / (period * period);
        let accelerations: Vec<_> = speeds.windows(2).map(mean).collect();
        let most = accelerations.iter().fold(0.0_f64, |most, a| most.max(a.abs()));
        assert!(most <= limit + noise, "{most} of {limit} and {noise}");
        // And what is allowed is used.
        assert!(most >= limit - noise, "{most} of {limit}");
        let said = number(&report["motion"], "largest_acceleration_mm_per_s2");
        assert!((said - limit).abs() <= 1e-9 * limit, "{said}");
        let said = report["motion"]["largest_jerk_mm_per_s3"].as_f64();
        assert_eq!(said.is_some(), !jerk.is_empty());
        assert!(said.is_none_or(|said| (said / 3000.0 - 1.0).abs() < 1e-6), "{said:?}");
        assert!((number(&report["motion"], "largest_speed_mm_per_s") - 50.0).abs() < 1e-12);
    }
}

#[test]
fn a_right_angle_is_passed_at_the_speed_of_the_corner() {
    let program = "G91 G01 F3000\nX20.\nY20.\nX5. Y5.\n";
    let folder = folder(program, "");
    let (report, _) = accelerated(folder.path(), "--no-waves --corner 7 --acceleration 500");
    let speeds = &blocks(&report)[0]["sampling"]["speeds_mm_per_s"];
    // The velocity jumps by v·√2 at 90 degrees and by 2·v·sin 22.5° at 45.
    assert!((number(speeds, "exit") * 2_f64.sqrt() - 7.0).abs() < 1e-9, "{speeds}");
    let speeds = &blocks(&report)[1]["sampling"]["speeds_mm_per_s"];
    let half = std::f64::consts::FRAC_PI_8.sin();
    assert!((number(speeds, "exit") * 2.0 * half - 7.0).abs() < 1e-9, "{speeds}");
    // Up at 500 mm/s², on at 50 mm/s, and down to the speed of the corner.
    let (v, exit) = (50.0_f64, 7.0 / 2_f64.sqrt());
    let rise = v / 500.0;
    let fall = (v - exit) / 500.0;
    let even = (20.0 - v * rise / 2.0 - (v + exit) * fall / 2.0) / v;
    let duration = number(&blocks(&report)[0], "duration_s");
    assert!((duration - (rise + even + fall)).abs() < 1e-9, "{duration}");
}

/// The changes of a signal of the wave as (picoseconds, bits).
type Changes = BTreeMap<String, Vec<(u64, String)>>;

/// All signals of the top scope, and the wave's end.
fn wave(path: &Path) -> (Changes, u64) {
    let mut wave = wellen::simple::read(path).unwrap();
    let hierarchy = wave.hierarchy();
    let signals: Vec<_> = hierarchy
        .all_vars()
        .map(|var| (hierarchy[var].full_name(hierarchy), hierarchy[var].signal_ref()))
        .filter_map(|(name, signal)| Some((name.strip_prefix("onepulse.")?.to_owned(), signal)))
        .filter(|(name, _)| !name.contains('.'))
        .collect();
    wave.load_signals(&signals.iter().map(|(_, signal)| *signal).collect::<Vec<_>>());
    let times = wave.time_table().to_vec();
    let changes = |signal| {
        let changes = wave.get_signal(signal).unwrap().iter_changes();
        changes.map(|(at, value)| (times[at as usize], value.to_string())).collect()
    };
    let changes = signals.into_iter().map(|(name, signal)| (name, changes(signal))).collect();
    (changes, *times.last().unwrap())
}

fn unsigned(bits: &str) -> u64 {
    u64::from_str_radix(bits, 2).unwrap()
}

fn signed(bits: &str) -> i64 {
    let value = unsigned(bits) as i64;
    if bits.starts_with('1') { value - (1 << bits.len()) } else { value }
}

/// The value of a signal at a time.
fn at(changes: &[(u64, String)], time: u64) -> &str {
    &changes[changes.partition_point(|(since, _)| *since <= time) - 1].1
}

#[test]
fn speed_and_following_errors_are_in_the_wave() {
    let folder = folder("G91 G01 X-60. Y80. F3000\nX3. F600\n", "");
    let options = "--servo-gain 40 --servo-drive 2 --pulse-mm 0.05 --period 4";
    let (report, summary) = accelerated(folder.path(), options);
    let out = folder.path().join("out");
    let (changes, end) = wave(&out.join("waves.vcd"));
    let picoseconds = |seconds: f64| (seconds * 1e12).round() as u64;
    let duration = number(&report["totals"], "duration_s");
    assert!(end.abs_diff(picoseconds(duration)) <= 2, "{end} ps for {duration} s");

    let speed = &changes["speed"];
    assert_eq!(speed.iter().map(|(_, bits)| unsigned(bits)).max(), Some(50_000));
    assert_eq!((speed[0].0, unsigned(&speed[0].1)), (0, 0));
    assert_eq!(unsigned(&speed.last().unwrap().1), 0);
    // Each record as the profile has it, from its time on.
    let clocks: Vec<u64> =
        changes["sample"].iter().filter(|(_, bits)| bits == "1").map(|(time, _)| *time).collect();
    let records: Vec<_> = profile(folder.path(), options)
        .into_iter()
        .filter(|record| record.time <= duration + 1e-9)
        .collect();
    assert_eq!(clocks.len(), records.len());
    assert_eq!(clocks[0], 0);
    for (record, clock) in records.iter().zip(clocks[1..].iter().chain([&end])) {
        assert!(clock.abs_diff(picoseconds(record.time)) <= 1002, "{record:?}: {clock}");
        let micrometres = unsigned(at(speed, *clock)) as f64;
        assert!((micrometres - record.speed * 1e3).abs() <= 0.51, "{record:?}: {micrometres}");
    }
    // v/K_v where the speed is even: 30 and 40 mm/s by 40.
    let late = picoseconds(1.5);
    assert_eq!(at(speed, late).len(), 32);
    for (name, nanometres) in [("error_x", -750_000), ("error_y", 1_000_000)] {
        let found = signed(at(&changes[name], late));
        assert!((found - nanometres).abs() <= 1, "{name}: {found}");
        assert_eq!(signed(&changes[name][0].1), 0);
    }
    let largest = &report["motion"]["servo"]["largest_following_error_mm"];
    assert!((number(largest, "x") - 0.75).abs() < 0.01, "{largest}");
    assert!((number(largest, "y") - 1.0).abs() < 0.01, "{largest}");
    assert_eq!(number(&report["motion"]["servo"], "gain_per_s"), 40.0);
    assert!(summary.contains("K_v is 40/s"), "{summary}");

    // As curves in both layouts: GTKWave's flags are analog and decimal, or signed.
    let layout = fs::read_to_string(out.join("waves.gtkw")).unwrap();
    assert!(layout.contains("@8024\nonepulse.speed[31:0]\n"), "{layout}");
    for name in ["error_x", "error_y"] {
        assert!(layout.contains(&format!("@8420\nonepulse.{name}[39:0]\n")), "{layout}");
    }
    let layout = fs::read_to_string(out.join("waves.sucl")).unwrap();
    for (name, format) in [("speed", "Unsigned"), ("error_x", "Signed"), ("error_y", "Signed")] {
        let part = layout.split(&format!("variable_add onepulse.{name}\n")).nth(1).unwrap();
        let commands: Vec<_> = part.lines().skip(1).take(3).collect();
        assert_eq!(commands[0], format!("item_set_format {format}"));
        assert_eq!(commands[2], "item_set_analog step");
    }

    // Without position loops there are no errors; and a run at constant feed has neither.
    let (report, _) = accelerated(folder.path(), "--pulse-mm 0.05");
    assert_eq!(report["motion"]["servo"], Value::Null);
    let (changes, _) = wave(&out.join("waves.vcd"));
    assert!(changes.contains_key("speed") && !changes.contains_key("error_x"));
    said(folder.path(), "run p.nc --out even --two-level --pulse-mm 0.05");
    let (changes, _) = wave(&folder.path().join("even/waves.vcd"));
    assert!(!changes.contains_key("speed"));
    assert!(!folder.path().join("even/profile.svg").exists());
}

/// 1 mm at 10 mm/s and 1000 mm/s² take 110 ms. Ten periods of 10.9999985 ms are 15 ns less: so the first
/// block's last record is 15 ns long, which is less than a picosecond for each of 2^14 clocks.
#[test]
fn a_record_that_is_over_at_once_does_not_break_the_time_axis() {
    let folder = folder("G01 X1. F600\nX0.34\n", "");
    let options = "--period 10.9999985 --corner 1e-9 --bits 14";
    let (report, _) = accelerated(folder.path(), options);
    let records = profile(folder.path(), "--period 10.9999985 --corner 1e-9");
    let shortest = records.windows(2).map(|pair| pair[1].time - pair[0].time).fold(1.0, f64::min);
    assert!((shortest - 15e-9).abs() < 2e-9, "{shortest}");
    assert_eq!(blocks(&report)[0]["sampling"]["samples"], 11);

    let (changes, end) = wave(&folder.path().join("out/waves.vcd"));
    let clk = &changes["clk"];
    assert!(clk.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 != pair[1].1));
    // All clocks are there, and the run is over in time.
    let rises = clk.iter().filter(|(_, bits)| bits == "1").count() as u64;
    assert!(rises.abs_diff(report["totals"]["cycles"].as_u64().unwrap()) <= 1, "{rises}");
    let due = number(&report["totals"], "duration_s") * 1e12;
    assert!((end as f64 - due).abs() <= 2.0, "{end} ps for {due}");
    // The short one takes a tick for each half clock, 2^15 of them; the next is on time again.
    let samples: Vec<u64> =
        changes["sample"].iter().filter(|(_, bits)| bits == "1").map(|(time, _)| *time).collect();
    let short = records.iter().position(|record| (record.time - 0.11).abs() < 1e-9).unwrap();
    let late = samples[short + 1] - samples[short];
    assert_eq!(late, 1 << 15);
    let next = (records[short + 1].time * 1e12) as u64;
    assert!(samples[short + 2].abs_diff(next) <= 1001, "{} for {next}", samples[short + 2]);
}

#[test]
fn a_full_circle_at_three_metres_a_minute() {
    let program = "G00 X20. Y0.\nG03 I-20. J0. F3000\n";
    let folder = folder(program, "");
    let (report, _) = accelerated(folder.path(), "--no-waves");
    let circle = &blocks(&report)[1];
    let sampling = &circle["sampling"];
    // Chords of 0.4 mm: f²/(8R) is 0.001 mm, a tenth of a pulse. `check` has held the bound.
    assert!((number(sampling, "chord_error") - 0.1).abs() < 1e-3, "{sampling}");
    assert!(number(sampling, "radius_error") < 1e-9, "{sampling}");
    assert!((0.5..1.6).contains(&number(circle, "largest_deviation")), "{circle}");
    assert_eq!(sampling["feed_reduced_for"], Value::Null);
    assert_eq!([&circle["pulses"]["x"], &circle["pulses"]["y"]], [8000, 8000]);

    // What limits it: the tolerance, a quarter of the radius a period, the centripetal acceleration.
    for (program, options, why, speed) in [
        // 2·√(2Re − e²) a period of 8 ms.
        (
            program,
            "--tolerance 0.0001",
            "tolerance",
            2.0 * (2.0_f64 * 20.0 * 1e-4 - 1e-8).sqrt() / 0.008,
        ),
        (program, "--centripetal 20", "centripetal", 20.0),
        ("G00 X1. Y0.\nG03 I-1. J0. F3000\n", "--centripetal 5000", "radius", 0.25 / 0.008),
    ] {
        fs::write(folder.path().join("p.nc"), program).unwrap();
        let (report, summary) = accelerated(folder.path(), &format!("--no-waves {options}"));
        let sampling = &blocks(&report)[1]["sampling"];
        assert_eq!(sampling["feed_reduced_for"], why);
        let found = number(&sampling["speeds_mm_per_s"], "peak");
        assert!((found / speed - 1.0).abs() < 1e-9, "{why}: {found} for {speed}");
        assert!((number(sampling, "feed_mm_per_min") / 60.0 / speed - 1.0).abs() < 1e-9);
        assert!(summary.contains("note: line 2: feed reduced from 3000 to"), "{summary}");
        if why == "tolerance" {
            assert!(number(sampling, "chord_error") <= 0.01 * (1.0 + 1e-9), "{sampling}");
        }
    }
}

#[test]
fn the_machine_may_accelerate() {
    let machine = "two_level = true\naccelerate = true\nperiod_ms = 4\nsampling = \"7360\"\n\
                   acceleration_mm_per_s2 = 400\njerk_mm_per_s3 = 9000\ncorner_mm_per_s = 4\n\
                   centripetal_mm_per_s2 = 300\nservo_gain_per_s = 25\nservo_drive_ms = 3\n";
    let folder = folder(&bracket(), machine);
    said(folder.path(), "run p.nc --config m.toml --no-waves --out file");
    let of_file = fs::read_to_string(folder.path().join("file/report.json")).unwrap();
    let options = "--period 4 --acceleration 400 --jerk 9000 --corner 4 --centripetal 300 \
                   --servo-gain 25 --servo-drive 3";
    accelerated(folder.path(), &format!("--no-waves {options}"));
    assert_eq!(of_file, fs::read_to_string(folder.path().join("out/report.json")).unwrap());

    // The limits of a file wait for a run that plans by them, and so does the key itself.
    let waiting = machine.replace("accelerate = true\n", "");
    for (machine, options) in [(waiting.as_str(), ""), (machine, "--method ppc")] {
        fs::write(folder.path().join("m.toml"), machine).unwrap();
        let arguments = format!("run p.nc --config m.toml --no-waves --out even {options}");
        said(folder.path(), &arguments);
        let text = fs::read_to_string(folder.path().join("even/report.json")).unwrap();
        let report: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(report["motion"], Value::Null, "{arguments}");
    }
}

#[test]
fn what_does_not_go_together_is_refused() {
    for (arguments, words) in [
        ("--accelerate", "--accelerate belongs to --two-level"),
        ("--accelerate --method ppc", "--accelerate belongs to --two-level"),
        ("--two-level --accelerate --sampling 7m", "--sampling is not for --accelerate"),
        ("--two-level --acceleration 500", "--acceleration belongs to --accelerate"),
        ("--two-level --jerk 500", "--jerk belongs to --accelerate"),
        ("--corner 5", "--corner belongs to --accelerate"),
        ("--method dda --centripetal 5", "--centripetal belongs to --accelerate"),
        ("--two-level --servo-gain 30", "--servo-gain belongs to --accelerate"),
        ("--two-level --servo-drive 1", "--servo-drive belongs to --accelerate"),
        ("--two-level --accelerate --servo-drive 1", "--servo-drive belongs to --servo-gain"),
        ("--two-level --accelerate --servo-gain 300", "gain"),
        ("--two-level --accelerate --acceleration 0", "acceleration"),
        ("--two-level --accelerate --period 0", "--period"),
    ] {
        let folder = folder("G01 X5. F600\n", "");
        let output = onepulse(folder.path(), &format!("run p.nc --out out {arguments}"));
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {errors}");
        assert!(errors.contains(words), "{arguments}: '{words}' is missing in: {errors}");
        assert!(!folder.path().join("out").exists(), "{arguments}");
    }
    // What is wrong in a file or a program is theirs.
    for (program, machine, options, words) in [
        ("G01 X5. F600\n", "servo_gain_per_s = 300\n", "", "m.toml"),
        ("G01 X5. F600\nX9. Q\n", "", "", "p.nc:2:5"),
        ("G01 X100. F0.001\n", "", "", "over 5000000 sample periods"),
        // 40 pulses a period, with the second block.
        ("G01 X0.5 F60\n  X90. F3000\n", "", "--bits 5", "p.nc:2:3"),
    ] {
        let folder = folder(program, machine);
        let arguments = format!("{ACCELERATE} --config m.toml {options}");
        let output = onepulse(folder.path(), &arguments);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments}: {errors}");
        assert!(errors.contains(words), "{arguments}: '{words}' is missing in: {errors}");
        assert!(!folder.path().join("out").exists(), "{arguments}");
    }
    // A program that does not move.
    let folder = folder("G90\n", "");
    let summary = said(folder.path(), ACCELERATE);
    assert!(summary.contains("0 blocks"), "{summary}");
}
