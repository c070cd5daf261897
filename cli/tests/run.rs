//! `onepulse run`: a G-code program through software and hardware model.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use assert_cmd::cargo::cargo_bin_cmd;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;
use tempfile::TempDir;

const FILES: [&str; 6] =
    ["path.svg", "pulses.csv", "report.json", "waves.gtkw", "waves.sucl", "waves.vcd"];

/// A program of the repository.
fn program(name: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../programs").join(name);
    path.to_str().unwrap().to_owned()
}

/// A folder to run in, with files of its own.
fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

/// `onepulse run` in a folder, with these arguments separated by blanks.
fn run(folder: &Path, arguments: &str) -> Output {
    let mut command = cargo_bin_cmd!("onepulse");
    command.current_dir(folder).arg("run").args(arguments.split_whitespace()).output().unwrap()
}

/// Runs, well, into `out`; the report.
fn report(folder: &Path, arguments: &str) -> Value {
    let output = run(folder, &format!("{arguments} --out out"));
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments}: {errors}");
    assert_eq!(errors, "", "{arguments}");
    serde_json::from_str(&fs::read_to_string(folder.join("out/report.json")).unwrap()).unwrap()
}

/// The report of a program given as text.
fn report_of(text: &str, arguments: &str) -> Value {
    let folder = folder(&[("program.nc", text)]);
    report(folder.path(), &format!("program.nc --no-waves {arguments}"))
}

/// Fails with an exit status; what it says.
fn failure(folder: &Path, arguments: &str, status: i32) -> String {
    let output = run(folder, arguments);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(status), "{arguments}: {errors}");
    assert_eq!(output.stdout, b"", "{arguments}");
    assert!(!errors.contains("panicked"), "{errors}");
    errors
}

/// What lies in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<_> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn methods_without_a_circuit_are_refused_before_anything_is_written() {
    let program = program("bracket.ngc");
    let words = "has no circuit for this: it has them for --method ppc";
    let folder = folder(&[("m.toml", "method = \"vector\"")]);
    let said = failure(folder.path(), &format!("{program} --method vector"), 2);
    assert!(said.contains(words), "{said}");
    let said = failure(folder.path(), &format!("{program} --config m.toml"), 1);
    assert!(said.contains(words) && said.contains("m.toml: method"), "{said}");
    let said = failure(folder.path(), &format!("{program} --method brm --smooth 2"), 2);
    assert!(said.contains(words), "{said}");
    assert_eq!(names(folder.path()), ["m.toml"]);
}

#[test]
fn the_bracket_is_made_by_the_methods_that_step_both_axes() {
    for (method, circuits, most) in [
        ("min-deviation", ["minimum_deviation_line", "minimum_deviation_arc"], 0.51),
        ("compare-integral", ["comparison_line", "comparison_arc"], 0.71),
    ] {
        let report = check_bracket(&format!("--method {method}"), circuits);
        let blocks = blocks(&report).iter().map(|block| &block["largest_deviation"]);
        let worst = blocks.map(|worst| worst.as_f64().unwrap()).fold(0.0, f64::max);
        assert!(worst > 0.4 && worst < most, "{method}: {worst}");
    }
}

fn pair(value: &Value) -> [i64; 2] {
    [value["x"].as_i64().unwrap(), value["y"].as_i64().unwrap()]
}

fn blocks(report: &Value) -> &[Value] {
    report["blocks"].as_array().unwrap()
}

fn lines(report: &Value) -> Vec<u64> {
    blocks(report).iter().map(|block| block["line"].as_u64().unwrap()).collect()
}

/// The rows of `pulses.csv`, without the header.
fn rows(path: &Path) -> Vec<[i64; 6]> {
    let text = fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("line,cycle,dx,dy,x,y"));
    let row = |line: &str| {
        let numbers: Vec<_> = line.split(',').map(|number| number.parse().unwrap()).collect();
        numbers.try_into().unwrap()
    };
    lines.map(row).collect()
}

/// What the report says of every block holds, and its totals are the sum of them.
fn check_report(report: &Value) {
    let mut pulses = [0, 0];
    let (mut cycles, mut seconds, mut deviation) = (0, 0.0, 0.0_f64);
    for block in blocks(report) {
        assert_eq!(block["endpoint_exact"], true, "{block}");
        assert_eq!(pair(&block["residual"]), [0, 0], "{block}");
        assert_eq!(block["hardware_agrees"], true, "{block}");
        assert!(block["largest_deviation"].as_f64().unwrap() <= 1.0, "{block}");
        assert!(block["duration_s"].as_f64().unwrap() > 0.0, "{block}");
        assert!(!block["method"].as_str().unwrap().is_empty());
        let [x, y] = pair(&block["pulses"]);
        pulses = [pulses[0] + x, pulses[1] + y];
        cycles += block["cycles"].as_u64().unwrap();
        seconds += block["duration_s"].as_f64().unwrap();
        deviation = deviation.max(block["largest_deviation"].as_f64().unwrap());
    }
    let totals = &report["totals"];
    assert_eq!(totals["blocks"], blocks(report).len());
    assert_eq!(pair(&totals["pulses"]), pulses);
    assert_eq!(totals["cycles"], cycles);
    assert_eq!(totals["endpoints_exact"], true);
    assert!((totals["duration_s"].as_f64().unwrap() - seconds).abs() < 1e-6);
    assert!((totals["largest_deviation"].as_f64().unwrap() - deviation).abs() < 1e-12);
    assert_eq!(report["hardware_agrees"], true);
}

/// The pulses are those of the report: by block, in sum, and where they lead.
fn check_pulses(rows: &[[i64; 6]], report: &Value) {
    let mut position = [0, 0];
    let mut place = (0, 0);
    let mut counts: BTreeMap<i64, [i64; 2]> = BTreeMap::new();
    for &[line, cycle, dx, dy, x, y] in rows {
        assert!((line, cycle) > place, "line {line}, cycle {cycle}");
        assert!([dx, dy] != [0, 0] && dx.abs() <= 1 && dy.abs() <= 1, "{line}, {cycle}");
        assert_eq!([x, y], [position[0] + dx, position[1] + dy], "line {line}, cycle {cycle}");
        (place, position) = ((line, cycle), [x, y]);
        let count = counts.entry(line).or_default();
        *count = [count[0] + dx.abs(), count[1] + dy.abs()];
    }
    assert_eq!(position, pair(&report["final_position"]));
    let of_blocks: BTreeMap<_, _> = blocks(report)
        .iter()
        .map(|block| (block["line"].as_i64().unwrap(), pair(&block["pulses"])))
        .collect();
    assert_eq!(counts, of_blocks);
}

/// Every signal's changes by its full name: (time, value as text); and the last time.
type Changes = BTreeMap<String, Vec<(u64, String)>>;

fn read_wave(path: &Path) -> (Changes, u64) {
    let mut wave = wellen::simple::read(path).unwrap();
    let hierarchy = wave.hierarchy();
    let signals: Vec<_> = hierarchy
        .all_vars()
        .map(|var| (hierarchy[var].full_name(hierarchy), hierarchy[var].signal_ref()))
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

/// The clock periods in which a signal is 1: each rising edge of the clock begins one.
fn clocks_with(changes: &Changes, signal: &str) -> i64 {
    let mut signal = changes[signal].iter().peekable();
    let mut is_one = false;
    let mut count = 0;
    for (rise, _) in changes["onepulse.clk"].iter().filter(|(_, value)| value == "1") {
        while let Some((_, value)) = signal.next_if(|(at, _)| at <= rise) {
            is_one = value == "1";
        }
        count += i64::from(is_one);
    }
    count
}

/// The wave shows the run of the report: its pulses, its blocks, its time.
fn check_wave(path: &Path, report: &Value, circuits: [&str; 2]) {
    let (changes, end) = read_wave(path);
    for axis in ["x", "y"] {
        let total = report["totals"]["pulses"][axis].as_i64().unwrap();
        let found = clocks_with(&changes, &format!("onepulse.pulse_{axis}"));
        assert_eq!(found, total, "{axis}");
        let (_, last) = changes[&format!("onepulse.position_{axis}")].last().unwrap();
        let last = i64::from_str_radix(last, 2).unwrap();
        let due = report["final_position"][axis].as_i64().unwrap();
        assert_eq!((last - due) % (1 << 34), 0, "{axis}: {last} for {due}");
    }
    for circuit in circuits {
        let scope = format!("onepulse.{circuit}.");
        assert!(changes.keys().any(|name| name.starts_with(&scope)), "{scope}");
    }
    let program_lines: Vec<_> = changes["onepulse.program_line"]
        .iter()
        .map(|(_, value)| u64::from_str_radix(value, 2).unwrap())
        .collect();
    assert_eq!(program_lines, lines(report));
    // The time axis counts picoseconds.
    let seconds = report["totals"]["duration_s"].as_f64().unwrap();
    assert!((end as f64 / 1e12 - seconds).abs() < 1e-6 * seconds, "{end} ps for {seconds} s");
}

/// Runs the bracket and checks all that is written.
fn check_bracket(arguments: &str, circuits: [&str; 2]) -> Value {
    let folder = folder(&[]);
    let report = report(folder.path(), &format!("{} {arguments}", program("bracket.ngc")));
    let out = folder.path().join("out");
    assert_eq!(names(&out), FILES);
    assert_eq!(names(folder.path()), ["out"]);

    check_report(&report);
    let expected = [5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21];
    assert_eq!(lines(&report), expected);
    assert_eq!(pair(&report["final_position"]), [0, 0]);
    // Paths are monotone between the axes, so no method can need more pulses or fewer.
    let pulses: Vec<_> = blocks(&report).iter().map(|block| pair(&block["pulses"])).collect();
    assert_eq!(
        pulses[..6],
        [[1000, 0], [1500, 0], [2000, 2000], [2500, 0], [1000, 1000], [0, 2000]]
    );
    assert_eq!(pulses[6..8], [[1200, 1600], [800, 400]]);
    assert_eq!(pulses[14..16], [[4800, 4800], [3600, 3600]]);

    let rows = rows(&out.join("pulses.csv"));
    check_pulses(&rows, &report);
    let ends: BTreeMap<_, _> = rows.iter().map(|&[line, _, _, _, x, y]| (line, [x, y])).collect();
    for (line, end) in [
        (5, [1000, 0]),
        (7, [4500, 0]),
        (9, [8000, 1000]),
        (11, [6800, 4600]),
        (12, [6000, 5000]),
        (15, [0, 5000]),
        (17, [1000, 0]),
        (18, [5200, 3000]),
        (19, [5200, 3000]),
        (20, [4000, 4200]),
        (21, [0, 0]),
    ] {
        assert_eq!(ends[&line], end, "line {line}");
    }

    check_wave(&out.join("waves.vcd"), &report, circuits);
    let layout = fs::read_to_string(out.join("waves.gtkw")).unwrap();
    assert!(layout.contains("[dumpfile] \"waves.vcd\""), "{layout}");
    let commands = fs::read_to_string(out.join("waves.sucl")).unwrap();
    assert!(commands.contains("variable_add onepulse.program_line\n"), "{commands}");
    let picture = fs::read_to_string(out.join("path.svg")).unwrap();
    assert!(picture.contains("<svg") && picture.trim_end().ends_with("</svg>"));
    report
}

#[test]
fn the_bracket_by_point_by_point_comparison() {
    let report = check_bracket("", ["ppc_line", "ppc_arc"]);
    for block in blocks(&report) {
        let [x, y] = pair(&block["pulses"]);
        assert_eq!(block["cycles"], x + y, "a step is a pulse: {block}");
        assert_eq!(block["method"], "ppc");
    }
    assert_eq!(
        check_bracket("--method ppc --end-rule per-axis", ["ppc_line", "ppc_arc"])["totals"],
        report["totals"]
    );
}

#[test]
fn the_bracket_by_digital_integration() {
    let report = check_bracket("--method dda", ["dda_line", "dda_centred_arc"]);
    for block in blocks(&report) {
        let is_arc = block["curve"].as_str().unwrap().starts_with("arc");
        assert_eq!(block["method"], if is_arc { "dda staggered" } else { "dda" });
    }
}

/// Down into a pocket, round it, a groove across in ZX and one in YZ, and up again.
const POCKET: &str = "G21 G90 G17
G00 Z5.
X10. Y5.
G01 Z-2. F300
X30. F600
G03 Y25. J10.
G01 X10.
G03 Y5. J-10.
G18 G02 X18. I4. K0
G19 G03 Y13. J4. K0
G17 G00 Z5.
X0 Y0
M02
";

#[test]
fn a_pocket_with_arcs_in_every_plane() {
    // Where each line ends, and the pulses that its curve takes.
    let due = [
        (2, [0, 0, 500], [0, 0, 500]),
        (3, [1000, 500, 500], [1000, 500, 0]),
        (4, [1000, 500, -200], [0, 0, 700]),
        (5, [3000, 500, -200], [2000, 0, 0]),
        (6, [3000, 2500, -200], [2000, 2000, 0]),
        (7, [1000, 2500, -200], [2000, 0, 0]),
        (8, [1000, 500, -200], [2000, 2000, 0]),
        (9, [1800, 500, -200], [800, 0, 800]),
        (10, [1800, 1300, -200], [0, 800, 800]),
        (11, [1800, 1300, 500], [0, 0, 700]),
        (12, [0, 0, 500], [1800, 1300, 0]),
    ];
    for (method, most) in [("ppc", 1.0), ("dda", 1.0), ("min-deviation", 0.51)] {
        let folder = folder(&[("p.nc", POCKET)]);
        let report = report(folder.path(), &format!("p.nc --method {method}"));
        assert_eq!(report["hardware_agrees"], true, "{method}");
        assert_eq!(blocks(&report).len(), due.len(), "{method}");
        let text = fs::read_to_string(folder.path().join("out/pulses.csv")).unwrap();
        let mut rows = text.lines();
        assert_eq!(rows.next(), Some("line,cycle,dx,dy,dz,x,y,z"));
        let row = |row: &str| -> Vec<i64> {
            row.split(',').map(|number| number.parse().unwrap()).collect()
        };
        let rows: Vec<_> = rows.map(row).collect();
        let mut position = [0; 3];
        for ((line, end, pulses), block) in due.into_iter().zip(blocks(&report)) {
            let mut sent = [0; 3];
            for row in rows.iter().filter(|row| row[0] == line) {
                for axis in 0..3 {
                    position[axis] += row[2 + axis];
                    sent[axis] += row[2 + axis].abs();
                }
                assert_eq!(row[5..], position, "{method}: {row:?}");
            }
            assert_eq!((position, sent), (end, pulses), "{method}: line {line}");
            assert_eq!(block["line"], line);
            assert_eq!(block["endpoint_exact"], true, "{method}: {block}");
            assert_eq!(
                block["pulses"],
                serde_json::json!({
                    "x": pulses[0], "y": pulses[1], "z": pulses[2],
                })
            );
            let deviation = block["largest_deviation"].as_f64().unwrap();
            assert!(deviation <= most, "{method}: {block}");
        }
        // Both grooves are as deep as their radius, halfway across.
        for (line, along, middle) in [(9, 5, 1400), (10, 6, 900)] {
            let groove = rows.iter().filter(|row| row[0] == line);
            let deepest: Vec<_> = groove.filter(|row| row[7] <= -599).collect();
            assert!(!deepest.is_empty(), "{method}: line {line}");
            for row in deepest {
                assert!((row[along] - middle).abs() <= 40 && row[7] >= -601, "{method}: {row:?}");
            }
        }
        let (changes, _) = read_wave(&folder.path().join("out/waves.vcd"));
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let sent: i64 = due.iter().map(|(_, _, pulses)| pulses[axis]).sum();
            assert_eq!(clocks_with(&changes, &format!("onepulse.pulse_{name}")), sent, "{method}");
        }
    }
}

#[test]
fn the_textbook_program() {
    let folder = folder(&[]);
    let report = report(folder.path(), &program("textbook.nc"));
    let out = folder.path().join("out");
    assert_eq!(names(&out), FILES);
    check_report(&report);
    check_pulses(&rows(&out.join("pulses.csv")), &report);
    check_wave(&out.join("waves.vcd"), &report, ["ppc_line", "ppc_arc"]);
    assert_eq!(lines(&report), [1, 2, 3]);
    assert_eq!(pair(&report["final_position"]), [-45000, -75000]);
    assert_eq!(pair(&report["totals"]["pulses"]), [5 + 5 + 45000, 5 + 75005]);
}

#[test]
fn the_summary_is_on_standard_output() {
    let folder = folder(&[]);
    let output = run(folder.path(), &format!("{} --out here --no-waves", program("bracket.ngc")));
    let text = String::from_utf8(output.stdout).unwrap();
    for words in ["bracket.ngc", "17 blocks", "final position 0,0", "agree", "written to here"] {
        assert!(text.contains(words), "'{words}' is missing in: {text}");
    }
}

#[test]
fn no_waves_are_written_if_none_are_wanted() {
    let folder = folder(&[]);
    let without = report(folder.path(), &format!("{} --no-waves", program("bracket.ngc")));
    assert_eq!(names(&folder.path().join("out")), FILES[..3]);
    check_report(&without);
    assert_eq!(report(folder.path(), &program("bracket.ngc")), without);
}

#[test]
fn feeds_give_the_time() {
    // 60 mm at 600 mm/min are 6 s, along an axis by every method.
    for arguments in ["", "--method dda", "--method brm --bits 13"] {
        let report = report_of("G01 X60. F600\nG00 X0.", arguments);
        let seconds = |block: &Value| block["duration_s"].as_f64().unwrap();
        assert!((seconds(&blocks(&report)[0]) - 6.0).abs() < 0.01, "{arguments}: {report}");
        // Rapid motions make 3 m/min.
        assert!((seconds(&blocks(&report)[1]) - 1.2).abs() < 0.01, "{arguments}: {report}");
    }
}

#[test]
fn the_pulse_equivalent_scales_the_program() {
    let text = "G01 X1. Y-2. F100";
    for (arguments, end) in [
        ("", [100, -200]),
        ("--pulse-mm 0.001", [1000, -2000]),
        ("--pulse-mm 0.03", [33, -67]),
        ("--pulse-mm 1", [1, -2]),
    ] {
        let report = report_of(text, arguments);
        assert_eq!(pair(&report["final_position"]), end, "{arguments}");
    }
}

#[test]
fn a_residual_is_reported_and_carried_on() {
    let text = "G01 X3 Y3 F100\nX6 Y6\nG00 X6 Y0";
    let report = report_of(text, "--end-rule larger");
    let residuals: Vec<_> = blocks(&report).iter().map(|block| pair(&block["residual"])).collect();
    assert_eq!(residuals, [[0, 1], [0, 1], [0, 0]]);
    let exact: Vec<_> = blocks(&report).iter().map(|block| &block["endpoint_exact"]).collect();
    assert_eq!(exact, [false, false, true]);
    assert_eq!(report["totals"]["endpoints_exact"], false);
    assert_eq!(pair(&report["final_position"]), [6, -2]);
}

#[test]
fn residuals_show_in_the_pulses_too() {
    let folder = folder(&[("p.nc", "G01 X3 Y3 F100\nX6 Y6\nG00 X6 Y0")]);
    let report = report(folder.path(), "p.nc --end-rule larger");
    check_pulses(&rows(&folder.path().join("out/pulses.csv")), &report);
}

#[test]
fn lines_run_through_the_rate_multiplier() {
    let text = "G01 X100 Y37 F100\nX-20 Y0\nX0";
    let report = report_of(text, "--method brm --bits 8");
    assert_eq!(report["hardware_agrees"], true);
    assert_eq!(pair(&report["final_position"]), [0, 0]);
    for block in blocks(&report) {
        assert_eq!(block["cycles"], 256, "{block}");
        assert_eq!(block["endpoint_exact"], true, "{block}");
    }
}

#[test]
fn a_program_without_motions_runs() {
    let folder = folder(&[("empty.nc", "%\nG21 G90\nM02\n")]);
    for method in ["ppc", "dda", "brm"] {
        let report = report(folder.path(), &format!("empty.nc --method {method}"));
        assert_eq!(names(&folder.path().join("out")), FILES);
        assert_eq!(blocks(&report), [Value::Null; 0]);
        assert_eq!(pair(&report["final_position"]), [0, 0]);
        let out = folder.path().join("out");
        assert_eq!(rows(&out.join("pulses.csv")), [[0; 6]; 0]);
        read_wave(&out.join("waves.vcd"));
    }
}

#[test]
fn an_older_run_is_replaced() {
    let folder = folder(&[("p.nc", "G01 X5 Y3 F100\n")]);
    report(folder.path(), &program("bracket.ngc"));
    let second = report(folder.path(), "p.nc");
    let out = folder.path().join("out");
    assert_eq!(names(&out), FILES);
    check_pulses(&rows(&out.join("pulses.csv")), &second);
    check_wave(&out.join("waves.vcd"), &second, ["ppc_line", "ppc_arc"]);
}

/// The error shows a line of the program, and under it strokes from the column on.
fn check_underlined(errors: &str, line: usize, source: &str, offending: &str) {
    let shown: Vec<_> = errors.lines().collect();
    let head = format!(" {line} │ ");
    let place = shown.iter().position(|text| text.contains(&head) && text.ends_with(source));
    let place = place.unwrap_or_else(|| panic!("line {line} is not shown in: {errors}"));
    let before = shown[place].split(offending).next().unwrap().chars().count();
    let strokes: Vec<_> = shown[place + 1].chars().skip(before).take(offending.len()).collect();
    assert_eq!(strokes.len(), offending.len(), "{errors}");
    assert!(strokes.iter().all(|stroke| matches!(stroke, '─' | '┬')), "{errors}");
    let is_stroke = |stroke: char| matches!(stroke, '─' | '┬');
    let count = shown[place + 1].chars().filter(|stroke| is_stroke(*stroke)).count();
    assert_eq!(count, offending.len(), "{errors}");
}

/// A program with an error on its third line.
const BAD: &str = "G21 G90\nG01 X1.0 F100\n  G01 X1.0 Y2.0 Q50 (far)\nX5\n";

#[test]
fn an_error_in_a_program_is_shown_in_its_place() {
    let folder = folder(&[("bad.nc", BAD)]);
    let errors = failure(folder.path(), "bad.nc --out out", 1);
    assert!(errors.contains("bad.nc:3:17: Q50 is not supported"), "{errors}");
    check_underlined(&errors, 3, "  G01 X1.0 Y2.0 Q50 (far)", "Q50");
    assert_eq!(names(folder.path()), ["bad.nc"]);
}

#[test]
fn an_error_far_down_in_a_program_is_shown_in_its_place() {
    let text = format!("G01 F100\n{}G01 X5 Y6 (圆)\n X7 Q8", "X1\nX0\n".repeat(600));
    let folder = folder(&[("bad.nc", &text)]);
    let errors = failure(folder.path(), "bad.nc --out out", 1);
    assert!(errors.contains("bad.nc:1203:5: Q8 is not supported"), "{errors}");
    check_underlined(&errors, 1203, " X7 Q8", "Q8");
    assert!(errors.lines().count() < 20, "{errors}");
}

#[test]
fn an_error_behind_wide_characters_has_its_column_in_characters() {
    let folder = folder(&[("bad.nc", "G00 X1\n(圆弧) Q50\n")]);
    let errors = failure(folder.path(), "bad.nc --out out", 1);
    assert!(errors.contains("bad.nc:2:6: Q50 is not supported"), "{errors}");
}

#[test]
fn every_kind_of_error_in_a_program_is_a_message() {
    for text in [
        "X5",
        "G01 X5",
        "\n\nG02 R5 F1",
        "G01 X",
        "(",
        "\u{feff}G01 X5 F1",
        "é",
        "\tQ5",
        "X\t",
        "\u{0}",
        "G01 X5 F0",
        "圆",
        "G00 X5\r\nQ\r\n",
    ] {
        let folder = folder(&[("bad.nc", text)]);
        let errors = failure(folder.path(), "bad.nc --out out", 1);
        assert!(errors.contains("bad.nc:"), "{text}: {errors}");
        assert_eq!(names(folder.path()), ["bad.nc"], "{text}");
    }
}

#[test]
fn a_program_that_is_no_text_is_refused() {
    let folder = folder(&[]);
    fs::write(folder.path().join("bad.nc"), b"G00 X5\n\xff\xfe\x00\n").unwrap();
    let errors = failure(folder.path(), "bad.nc --out out", 1);
    assert!(errors.contains("bad.nc:2:1: "), "{errors}");
    fs::write(folder.path().join("bad.nc"), [b'x'; 100_000]).unwrap();
    let errors = failure(folder.path(), "bad.nc --out out", 1);
    assert!(errors.contains("bad.nc:1:1: "), "{errors}");
    assert_eq!(names(folder.path()), ["bad.nc"]);
}

#[test]
fn a_failed_run_leaves_an_older_one_alone() {
    let folder = folder(&[("bad.nc", BAD), ("good.nc", "G01 X5 F100"), ("arc.nc", "G03 I5 F1")]);
    let out = folder.path().join("out");
    report(folder.path(), "good.nc");
    let read = || FILES.map(|name| fs::read(out.join(name)).unwrap());
    let before = read();
    for (arguments, status) in [
        ("bad.nc", 1),
        ("missing.nc", 1),
        ("arc.nc --method brm --bits 8", 1),
        ("good.nc --bits 2", 1),
        ("good.nc --config missing.toml", 1),
        ("good.nc --normalize", 2),
    ] {
        failure(folder.path(), &format!("{arguments} --out out"), status);
        assert_eq!(names(&out), FILES, "{arguments}");
        assert!(read() == before, "{arguments} touched an older file");
    }
}

#[test]
fn a_failed_run_leaves_other_files_alone() {
    let folder = folder(&[("bad.nc", BAD)]);
    let out = folder.path().join("out");
    fs::create_dir(&out).unwrap();
    fs::write(out.join("report.json"), "old").unwrap();
    fs::write(out.join("notes.txt"), "mine").unwrap();
    failure(folder.path(), "bad.nc --out out", 1);
    assert_eq!(names(&out), ["notes.txt", "report.json"]);
    assert_eq!(fs::read_to_string(out.join("report.json")).unwrap(), "old");
}

#[test]
fn a_failed_run_leaves_no_folder_behind() {
    let folder = folder(&[("bad.nc", BAD)]);
    failure(folder.path(), "bad.nc --out deep/er/out", 1);
    assert_eq!(names(folder.path()), ["bad.nc"]);
}

#[test]
fn an_empty_folder_that_was_there_stays() {
    let folder = folder(&[("bad.nc", BAD)]);
    fs::create_dir(folder.path().join("out")).unwrap();
    failure(folder.path(), "bad.nc --out out", 1);
    assert_eq!(names(folder.path()), ["bad.nc", "out"]);
}

/// A program is read twice, which a pipe does not allow.
#[test]
#[cfg(unix)]
fn a_program_may_come_through_a_pipe() {
    let folder = folder(&[]);
    let text = fs::read_to_string(program("textbook.nc")).unwrap();
    let mut command = cargo_bin_cmd!("onepulse");
    let arguments = ["run", "/dev/stdin", "--no-waves", "--out", "piped"];
    command.current_dir(folder.path()).args(arguments).write_stdin(text).assert().success();
    report(folder.path(), &format!("{} --no-waves", program("textbook.nc")));
    let pulses =
        |out: &str| fs::read_to_string(folder.path().join(out).join("pulses.csv")).unwrap();
    assert_eq!(pulses("piped"), pulses("out"));
}

#[test]
fn files_that_cannot_be_read_are_at_fault() {
    let folder = folder(&[("p.nc", "G01 X5 F100")]);
    fs::create_dir(folder.path().join("folder")).unwrap();
    for (arguments, name) in [
        ("missing.nc", "missing.nc"),
        ("folder", "folder"),
        ("p.nc --config missing.toml", "missing.toml"),
        ("p.nc --config folder", "folder"),
    ] {
        let errors = failure(folder.path(), &format!("{arguments} --out out"), 1);
        assert!(errors.contains(name), "{arguments}: {errors}");
        assert_eq!(names(folder.path()), ["folder", "p.nc"], "{arguments}");
    }
}

#[test]
fn folders_that_cannot_be_written_are_at_fault() {
    let folder = folder(&[("p.nc", "G01 X5 F100")]);
    for out in ["p.nc", "p.nc/out", "/dev/null/out"] {
        let errors = failure(folder.path(), &format!("p.nc --out {out}"), 1);
        assert!(errors.contains(out), "{out}: {errors}");
        assert_eq!(fs::read_to_string(folder.path().join("p.nc")).unwrap(), "G01 X5 F100");
    }
    for name in FILES {
        let in_the_way = folder.path().join("out").join(name);
        fs::create_dir_all(&in_the_way).unwrap();
        let errors = failure(folder.path(), "p.nc --out out", 1);
        assert!(errors.contains(name), "{name}: {errors}");
        assert_eq!(names(&folder.path().join("out")), [name]);
        fs::remove_dir(in_the_way).unwrap();
    }
}

#[test]
fn the_machine_is_that_of_the_file() {
    let machine = "pulse_mm = 0.02\nmethod = \"dda\"\nbits = 16\nintegers = \"units\"\n\
                   rapid_mm_per_min = 600\nend_rule = \"larger\"\n";
    let folder = folder(&[("machine.toml", machine), ("p.nc", "G00 X5\nG03 X0 Y5 I-5 F100")]);
    let of_file = report(folder.path(), "p.nc --config machine.toml");
    check_report(&of_file);
    assert_eq!(of_file["machine"]["pulse_mm"], 0.02);
    assert_eq!(of_file["machine"]["bits"], 16);
    assert_eq!(of_file["machine"]["method"], "dda");
    assert_eq!(pair(&of_file["final_position"]), [0, 250]);
    let rapid = &blocks(&of_file)[0];
    assert!((rapid["duration_s"].as_f64().unwrap() - 0.5).abs() < 0.01, "{rapid}");

    let options = "--method ppc --bits 12 --pulse-mm 0.05 --end-rule total";
    let overruled = report(folder.path(), &format!("p.nc --config machine.toml {options}"));
    assert_eq!(overruled["machine"]["pulse_mm"], 0.05);
    assert_eq!(overruled["machine"]["bits"], 12);
    assert_eq!(overruled["machine"]["method"], "ppc");
    assert_eq!(pair(&overruled["final_position"]), [0, 100]);
}

#[test]
fn errors_in_the_machine_name_their_line() {
    for (text, words) in [
        ("pulse_mm = 0.01\nspeed = 3\n", ["line 2", "speed"]),
        ("\n\nmethod = \"euler\"\n", ["line 3", "euler"]),
        ("bits = \"many\"\n", ["line 1", "many"]),
        ("bits = -1\n", ["line 1", "-1"]),
        ("pulse_mm = \n", ["line 1", "pulse_mm"]),
        ("pulse_mm = 0.01\npulse_mm = 0.02\n", ["line 2", "duplicate"]),
    ] {
        let folder = folder(&[("machine.toml", text), ("p.nc", "G01 X5 F100")]);
        let errors = failure(folder.path(), "p.nc --config machine.toml --out out", 1);
        assert!(errors.contains("machine.toml"), "{text}: {errors}");
        for word in words {
            assert!(errors.contains(word), "{text}: '{word}' is missing in: {errors}");
        }
        assert_eq!(names(folder.path()), ["machine.toml", "p.nc"], "{text}");
    }
}

#[test]
fn values_that_no_machine_has_name_their_key() {
    for (text, key) in [
        ("pulse_mm = 0.0", "pulse_mm"),
        ("pulse_mm = -0.01", "pulse_mm"),
        ("pulse_mm = nan", "pulse_mm"),
        ("pulse_mm = inf", "pulse_mm"),
        ("pulse_mm = 1e-12", "pulse_mm"),
        ("pulse_mm = 1e300", "pulse_mm"),
        ("rapid_mm_per_min = 0", "rapid_mm_per_min"),
    ] {
        let folder = folder(&[("machine.toml", text), ("p.nc", "G01 X5 F100")]);
        let errors = failure(folder.path(), "p.nc --config machine.toml --out out", 1);
        assert!(errors.contains("machine.toml"), "{text}: {errors}");
        assert!(errors.contains(key), "{text}: {errors}");
        assert_eq!(names(folder.path()), ["machine.toml", "p.nc"], "{text}");
    }
}

#[test]
fn a_width_in_the_machine_that_is_not_offered_is_the_fault_of_the_file() {
    let folder = folder(&[("p.nc", "G01 X5 F100")]);
    for bits in ["0", "99"] {
        for waves in ["", "--no-waves"] {
            fs::write(folder.path().join("machine.toml"), format!("bits = {bits}")).unwrap();
            let arguments = format!("p.nc --config machine.toml {waves} --out out");
            let errors = failure(folder.path(), &arguments, 1);
            assert!(errors.contains("machine.toml"), "{bits} {waves}: {errors}");
            assert!(errors.contains("bits"), "{bits} {waves}: {errors}");
        }
    }
}

#[test]
fn an_arc_by_the_rate_multiplier_is_refused_in_its_line() {
    let text = "G00 X5\nG01 X10 Y3 F100\n  N30 G03 X5 Y8 I-5 J0 ; round\n";
    let folder = folder(&[("p.nc", text)]);
    let errors = failure(folder.path(), "p.nc --method brm --bits 8 --out out", 1);
    assert!(errors.contains("p.nc:3:3: the rate multiplier serves lines only"), "{errors}");
    assert_eq!(names(folder.path()), ["p.nc"]);
}

#[test]
fn the_bracket_by_the_rate_multiplier_is_refused_in_its_first_arc() {
    let folder = folder(&[]);
    let arguments = format!("{} --method brm --bits 12 --out out", program("bracket.ngc"));
    let errors = failure(folder.path(), &arguments, 1);
    assert!(errors.contains("bracket.ngc:7:1: the rate multiplier serves lines only"), "{errors}");
    assert_eq!(names(folder.path()), [""; 0]);
}

#[test]
fn a_block_that_the_registers_do_not_hold_is_refused_in_its_line() {
    let folder = folder(&[("p.nc", "G01 X15 F100\nX100 Y0\n")]);
    for arguments in ["", "--method dda", "--method brm"] {
        let errors = failure(folder.path(), &format!("p.nc {arguments} --bits 4 --out out"), 1);
        assert!(errors.contains("p.nc:2:1: "), "{arguments}: {errors}");
        assert!(errors.contains("needs 7"), "{arguments}: {errors}");
        check_underlined(&errors, 2, "X100 Y0", "X100 Y0");
        assert_eq!(names(folder.path()), ["p.nc"]);
    }
}

#[test]
fn wrong_command_lines_are_refused_and_write_nothing() {
    let folder = folder(&[("p.nc", "G01 X5 F100")]);
    for (arguments, words) in [
        ("", "<PROGRAM>"),
        ("p.nc --method euler", "--method"),
        ("p.nc --normalize", "--normalize"),
        ("p.nc --preset half", "--preset"),
        ("p.nc --method dda --end-rule total", "--end-rule"),
        ("p.nc --method brm --normalize", "--normalize"),
        ("p.nc --method dda --radix 10", "--radix"),
        ("p.nc --pulse-mm x", "--pulse-mm"),
        ("p.nc --pulse-mm 0", "--pulse-mm"),
        ("p.nc --pulse-mm=-0.01", "--pulse-mm"),
        ("p.nc --pulse-mm 0.0000000001", "--pulse-mm"),
        ("p.nc --bits x", "--bits"),
        ("p.nc --bits 99", "--bits"),
        ("p.nc --bits 0 --method dda", "--bits"),
        ("p.nc --colour", "--colour"),
        ("p.nc q.nc", "q.nc"),
    ] {
        let errors = failure(folder.path(), &format!("{arguments} --out out"), 2);
        assert!(errors.contains(words), "{arguments}: '{words}' is missing in: {errors}");
        assert_eq!(names(folder.path()), ["p.nc"], "{arguments}");
    }
}

#[test]
fn a_width_that_is_not_offered_is_a_wrong_command_line_without_waves_too() {
    let folder = folder(&[("p.nc", "G01 X5 F100")]);
    for method in ["ppc", "dda", "brm"] {
        let arguments = format!("p.nc --method {method} --bits 99 --no-waves --out out");
        let errors = failure(folder.path(), &arguments, 2);
        assert!(errors.contains("--bits"), "{method}: {errors}");
    }
}

#[test]
fn a_window_of_a_run_shows_the_same_clocks_as_the_whole() {
    let folder = folder(&[("p.nc", "G00X5Y0\nG03X0Y5I-5J0F150\nG01X-9Y2\n")]);
    for arguments in ["p.nc --out whole", "p.nc --out part --from 30 --clocks 40"] {
        assert!(run(folder.path(), arguments).status.success());
    }
    let (whole, _) = read_wave(&folder.path().join("whole/waves.vcd"));
    let (part, end) = read_wave(&folder.path().join("part/waves.vcd"));
    let rises = |changes: &Changes| -> Vec<u64> {
        changes["onepulse.clk"].iter().filter(|(_, v)| v == "1").map(|(at, _)| *at).collect()
    };
    assert_eq!(rises(&part), rises(&whole)[30..70]);
    assert!(end < rises(&whole)[71]);
    // Half of the arc's last step is the first thing seen of the line: from there on all agree.
    for (name, changes) in &part {
        for (at, value) in changes {
            let last = whole[name].iter().rev().find(|(time, _)| time <= at).unwrap();
            assert_eq!(*value, last.1, "{name} at {at}");
        }
    }
}

#[test]
fn integrated_curves_take_the_time_of_their_length() {
    // A full circle of 10 mm, half a one, and lines, at 10 mm a second. In every register width
    // the feed is that of the program: normalization and width are allowed for.
    let program = "G01X10.Y0.F600\nG03I-10.J0.\nG03X-10.I-10.J0.\nG01X5.Y20.\n";
    let half_turn = 10.0 * std::f64::consts::PI;
    let due = [10.0, 2.0 * half_turn, half_turn, 25.0].map(|millimetres| millimetres / 10.0);
    for options in ["", "--bits 13", "--update simultaneous", "--update simultaneous --bits 20"] {
        let report = report_of(program, &format!("--method dda {options}"));
        assert_eq!(blocks(&report).len(), due.len());
        for (block, due) in blocks(&report).iter().zip(due) {
            let seconds = block["duration_s"].as_f64().unwrap();
            // An arc may wait a little for its last pulse.
            assert!((seconds / due - 1.0).abs() < 0.03, "{options}: {seconds} s for {due} s");
        }
    }
}
