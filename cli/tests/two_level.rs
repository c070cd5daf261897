//! `onepulse run --two-level`: blocks sampled in coarse steps, and DDA lines from sample to sample.
#![allow(clippy::unwrap_used)]

use assert_cmd::cargo::cargo_bin_cmd;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Output;
use tempfile::TempDir;

/// A folder with a program and a machine.
fn folder(program: &str, machine: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("p.nc"), program).unwrap();
    fs::write(folder.path().join("m.toml"), machine).unwrap();
    folder
}

fn run(folder: &Path, arguments: &str) -> Output {
    let mut command = cargo_bin_cmd!("onepulse");
    command.current_dir(folder).arg("run").args(arguments.split_whitespace()).output().unwrap()
}

/// Runs, well; the report and the summary.
fn report(folder: &Path, arguments: &str) -> (Value, String) {
    let output = run(folder, &format!("{arguments} --out out"));
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments}: {errors}");
    let text = fs::read_to_string(folder.join("out/report.json")).unwrap();
    (serde_json::from_str(&text).unwrap(), String::from_utf8(output.stdout).unwrap())
}

/// The blocks of a program given as text.
fn blocks_of(program: &str, arguments: &str) -> Vec<Value> {
    let folder = folder(program, "");
    let (report, _) = report(folder.path(), &format!("p.nc --two-level --no-waves {arguments}"));
    check(&report);
    report["blocks"].as_array().unwrap().clone()
}

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("no number {name} in {value}"))
}

/// The rows of `pulses.csv`: line, cycle, dx, dy, x, y.
fn rows(folder: &Path) -> Vec<[i64; 6]> {
    let text = fs::read_to_string(folder.join("out/pulses.csv")).unwrap();
    let row = |line: &str| {
        let numbers: Vec<_> = line.split(',').map(|number| number.parse().unwrap()).collect();
        numbers.try_into().unwrap()
    };
    text.lines().skip(1).map(row).collect()
}

/// What holds of every run of two levels.
fn check(report: &Value) {
    assert_eq!(report["hardware_agrees"], true);
    let mut seconds = 0.0;
    for block in report["blocks"].as_array().unwrap() {
        assert_eq!(block["method"], "two levels", "{block}");
        assert_eq!(block["endpoint_exact"], true, "{block}");
        assert_eq!(block["hardware_agrees"], true, "{block}");
        let sampling = &block["sampling"];
        // A sample takes 2^n clocks, and a period.
        let samples = sampling["samples"].as_u64().unwrap();
        assert_eq!(block["cycles"], samples << sampling["bits"].as_u64().unwrap(), "{block}");
        let due = samples as f64 * number(sampling, "period_ms") / 1000.0;
        assert!((number(block, "duration_s") / due - 1.0).abs() < 1e-12, "{block}");
        seconds += due;
        // The four parts bound the whole, but for rounding in floats.
        let parts = ["chord_error", "radius_error", "rounding", "fine"];
        let bound: f64 = parts.iter().map(|part| number(sampling, part)).sum();
        assert!(number(block, "largest_deviation") <= bound + 1e-9, "{block}");
        assert!(parts.iter().all(|part| number(sampling, part) >= 0.0), "{block}");
        // A point is rounded by half a pulse an axis, and a DDA line with half load keeps ½√2.
        assert!(number(sampling, "rounding") <= 0.5_f64.sqrt() + 1e-9, "{block}");
        assert!(number(sampling, "fine") <= 0.5_f64.sqrt() + 1e-9, "{block}");
    }
    let total = number(&report["totals"], "duration_s");
    assert!((total - seconds).abs() < 1e-9 * (1.0 + seconds), "{total} s for {seconds}");
}

/// A full circle of 20 mm at 3 m/min, in steps of 0.4 mm: 2000 pulses in steps of 40.
const CIRCLE: &str = "G00 X20. Y0.\nG03 I-20. J0. F3000\n";

/// What the pulses of the circle say by themselves: the largest distance from the circle, from a
/// microsegment's chord, and the chord errors of the points after each period.
struct Measured {
    deviation: f64,
    fine: f64,
    /// Largest of the chords between the points that were reached, e_r = r − √(r² − (f/2)²), with
    /// what their own rounding adds to it.
    chord_error: f64,
    /// Largest |radius − R| of these points.
    off_circle: f64,
}

fn measured(rows: &[[i64; 6]], clocks: i64, radius: f64) -> Measured {
    let mut ends = vec![[radius as i64, 0]];
    let mut samples: Vec<Vec<[i64; 2]>> = vec![];
    let mut position = ends[0];
    for &[_, cycle, dx, dy, x, y] in rows {
        position = [position[0] + dx, position[1] + dy];
        assert_eq!(position, [x, y], "cycle {cycle}");
        let sample = ((cycle - 1) / clocks) as usize;
        samples.resize(samples.len().max(sample + 1), vec![]);
        samples[sample].push(position);
    }
    for sample in &samples {
        ends.push(*sample.last().unwrap_or(ends.last().unwrap()));
    }
    let hypot = |x: i64, y: i64| (x as f64).hypot(y as f64);
    let off = |[x, y]: [i64; 2]| (hypot(x, y) - radius).abs();
    let mut found = Measured { deviation: 0.0, fine: 0.0, chord_error: 0.0, off_circle: 0.0 };
    for (sample, ends) in samples.iter().zip(ends.windows(2)) {
        let [from, to] = [ends[0], ends[1]];
        let way = [to[0] - from[0], to[1] - from[1]];
        let length = hypot(way[0], way[1]);
        for point in sample {
            let across = way[0] * (point[1] - from[1]) - way[1] * (point[0] - from[0]);
            found.fine = found.fine.max(across.abs() as f64 / length);
            found.deviation = found.deviation.max(off(*point));
        }
        found.off_circle = found.off_circle.max(off(to));
        let to_chord = (radius * radius - length * length / 4.0).sqrt();
        found.chord_error = found.chord_error.max(radius - to_chord);
    }
    found
}

#[test]
fn a_circle_strays_by_no_more_than_its_parts() {
    // e_r of the steps of 0.4 mm, in pulses of 0.01 mm.
    let (radius, step) = (20.0_f64, 0.4_f64);
    let chord_error = (radius - (radius * radius - step * step / 4.0).sqrt()) / 0.01;
    assert!((chord_error - 0.1).abs() < 1e-4);
    for (method, stretch) in [
        ("second-order", -1e-6..1e-6),
        // Steps a little longer where 45° is a bad guess, or the circle falls from the tangent.
        ("7m", -1e-6..0.02),
        ("direct-function", -1e-6..0.035),
        // A chord that leads outward comes nearest to the centre before its middle: λ²/4 less.
        ("7360", -1.01e-4..1e-6),
    ] {
        let folder = folder(CIRCLE, "");
        let arguments = format!("p.nc --two-level --sampling {method}");
        let (report, summary) = report(folder.path(), &arguments);
        check(&report);
        let block = &report["blocks"][1];
        let sampling = &block["sampling"];
        assert_eq!(sampling["method"], method);
        assert_eq!(number(sampling, "period_ms"), 8.0);
        assert!((number(sampling, "step_mm") - step).abs() < 1e-12);
        assert_eq!(number(sampling, "feed_mm_per_min"), 3000.0);
        assert_eq!(sampling["feed_reduced_for"], Value::Null);
        let found = number(sampling, "chord_error") / chord_error - 1.0;
        assert!(stretch.contains(&found), "{method}: {found}");
        // Only the 7360 leaves the circle, and by π/4·λ³·R a turn.
        let radius_error = number(sampling, "radius_error");
        let growth = std::f64::consts::FRAC_PI_4 * 0.02_f64.powi(3) * 2000.0;
        let due = if method == "7360" { growth } else { 0.0 };
        assert!((radius_error - due).abs() < 0.01 * growth, "{method}: {radius_error}");
        // 2π/0.02 steps are 314.2; fewer where they are longer.
        let samples = sampling["samples"].as_u64().unwrap();
        assert!((310..=315).contains(&samples), "{method}: {samples}");
        // 40 pulses in a step take registers of 6 bits.
        assert_eq!(sampling["bits"], 6);

        // And the pulses themselves.
        let rows: Vec<_> =
            rows(folder.path()).into_iter().filter(|[line, ..]| *line == 2).collect();
        assert_eq!(rows.last().unwrap()[4..], [2000, 0], "{method}");
        let measured = measured(&rows, 64, 2000.0);
        let near = |name: &str, found: f64, by: f64| {
            let said = number(sampling, name);
            assert!((found - said).abs() <= by, "{method} {name}: {found} for {said}");
        };
        assert!((measured.deviation - number(block, "largest_deviation")).abs() < 1e-9);
        near("fine", measured.fine, 1e-9);
        // The rounded points make these chords a pulse longer or shorter, of 40.
        near("chord_error", measured.chord_error, 0.1 * (41.5_f64.powi(2) / 1600.0 - 1.0));
        // They are as far off the circle as rounding and radius error let them be.
        assert!(measured.off_circle <= number(sampling, "rounding") + radius_error + 1e-9);
        assert!(measured.off_circle >= 0.5);
        let bound = summary.lines().find(|line| line.starts_with("largest deviation")).unwrap();
        for words in ["<=", "chord error", "radius error", "rounding", "fine deviation"] {
            assert!(bound.contains(words), "{bound}");
        }
    }
}

/// The bracket of the repository.
fn bracket() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../programs/bracket.ngc");
    path.to_str().unwrap().to_owned()
}

#[test]
fn every_block_of_the_bracket_ends_exactly() {
    let folder = folder("", "");
    let (report, summary) = report(folder.path(), &format!("{} --two-level", bracket()));
    check(&report);
    let blocks = report["blocks"].as_array().unwrap();
    assert_eq!(blocks.len(), 17);
    assert_eq!(report["final_position"]["x"], 0);
    assert_eq!(report["final_position"]["y"], 0);
    // 15 mm at 600 mm/min: 1.5 s are 187.5 periods of 8 ms. The last half one takes a whole one.
    assert_eq!(blocks[1]["sampling"]["samples"], 188);
    // 10 mm at 3 m/min are 25 steps of 0.4 mm.
    assert_eq!(blocks[0]["sampling"]["samples"], 25);
    let samples: u64 = blocks.iter().map(|b| b["sampling"]["samples"].as_u64().unwrap()).sum();
    let due = samples as f64 * 0.008;
    assert!((number(&report["totals"], "duration_s") - due).abs() < 1e-9);
    assert!(summary.contains(&format!("{samples} samples of 8 ms")), "{summary}");
    // Cycles go on from sample to sample, and no pulse is later than the block's last clock.
    let mut last = [0; 2];
    for [line, cycle, ..] in rows(folder.path()) {
        assert!([line, cycle] > last);
        last = [line, cycle];
        let block = blocks.iter().find(|block| block["line"] == line).unwrap();
        assert!(cycle <= block["cycles"].as_i64().unwrap());
    }
}

#[test]
fn a_tolerance_reduces_the_feed() {
    let loose = blocks_of(CIRCLE, "");
    let strict = blocks_of(CIRCLE, "--tolerance 0.0001");
    let sampling = &strict[1]["sampling"];
    assert_eq!(sampling["feed_reduced_for"], "tolerance");
    assert!(number(sampling, "chord_error") <= 0.01 * (1.0 + 1e-9));
    // F = 2·√(2re − e²)/T, a minute having 7500 periods.
    let feed = 2.0 * (2.0_f64 * 20.0 * 1e-4 - 1e-8).sqrt() * 7500.0;
    assert!((number(sampling, "feed_mm_per_min") / feed - 1.0).abs() < 1e-6, "{sampling}");
    // What the program asks for is still there, and lines are as they were.
    assert_eq!(number(&strict[1], "feed_mm_per_min"), 3000.0);
    assert_eq!(strict[0], loose[0]);
    let ratio = number(&strict[1], "duration_s") / number(&loose[1], "duration_s");
    assert!((ratio / (3000.0 / feed) - 1.0).abs() < 0.01, "{ratio}");

    let folder = folder(CIRCLE, "");
    let (_, summary) = report(folder.path(), "p.nc --two-level --no-waves --tolerance 0.0001");
    let note = summary.lines().find(|line| line.starts_with("note: line 2")).unwrap();
    assert!(note.contains("from 3000 to 948.68"), "{note}");
}

#[test]
fn small_arcs_are_made_in_quarters_of_the_radius() {
    // A radius of 1 mm takes steps of 0.25 mm; of 1 pulse, of a quarter of it.
    for (radius, feed) in [("1.", 0.25 * 7500.0), ("1", 0.0025 * 7500.0)] {
        for sampling in ["7m", "7360", "direct-function", "second-order"] {
            let program = format!("G02 I-{radius} F3000\nG03 I{radius}\n");
            let arguments = format!("--sampling {sampling}");
            for block in blocks_of(&program, &arguments) {
                let sampling = &block["sampling"];
                assert_eq!(sampling["feed_reduced_for"], "radius");
                let found = number(sampling, "feed_mm_per_min");
                assert!((found / feed - 1.0).abs() < 1e-9, "{block}");
                assert!(sampling["samples"].as_u64().unwrap() >= 20, "{block}");
            }
        }
    }
}

#[test]
fn ends_off_the_circle_are_reached() {
    // Three pulses too far out, after each number of quarter turns counter-clockwise; four of them
    // is in the start's own direction, so a full turn. (In millimetres, rounded, 0.1·0.303 is not 0.3·0.101.)
    for (quarters, [x, y]) in
        [(4, [100, 300]), (3, [-300, 100]), (2, [-100, -300]), (1, [300, -100])]
    {
        let radius = 100_f64.hypot(300.0);
        for (sense, quarters) in [("G03", quarters % 4), ("G02", (4 - quarters) % 4)] {
            let turns = if quarters == 0 { 1.0 } else { f64::from(quarters) / 4.0 };
            let centre = format!("I{} J{}", -x, -y);
            let program = format!("G00 X{x} Y{y}\n{sense} X101 Y303 {centre} F300\n");
            let blocks = blocks_of(&program, "--pulse-mm 0.001");
            // Steps of 40 pulses, some a little longer.
            let steps = turns * std::f64::consts::TAU * radius / 40.0;
            let samples = number(&blocks[1]["sampling"], "samples");
            assert!((steps * 0.97..steps + 1.0).contains(&samples), "{program}: {samples}");
        }
    }
}

#[test]
fn registers_that_are_given_serve_all_blocks_or_refuse() {
    let program = "G01 X40 Y-9 F600\nX0 Y0 F3000\n";
    for block in blocks_of(program, "--bits 9") {
        assert_eq!(block["sampling"]["bits"], 9);
    }
    // 40 pulses in 8 ms do not fit 5 bits; the first block's 8 fit 4.
    let folder = folder(program, "");
    let output = run(folder.path(), "p.nc --two-level --bits 5 --out out");
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{errors}");
    assert!(errors.contains("p.nc:2:1: ") && errors.contains("needs 6"), "{errors}");
    assert!(!folder.path().join("out").exists());
}

#[test]
fn the_sample_clock_is_in_the_wave() {
    let folder = folder("G00 X100 Y0\nG03 X0 Y100 I-100 F600\n", "");
    let (report, _) = report(folder.path(), "p.nc --two-level");
    let out = folder.path().join("out");
    for layout in ["waves.gtkw", "waves.sucl"] {
        let text = fs::read_to_string(out.join(layout)).unwrap();
        assert!(text.contains("onepulse.sample\n"), "{layout}: {text}");
    }
    let mut wave = wellen::simple::read(out.join("waves.vcd")).unwrap();
    let hierarchy = wave.hierarchy();
    let find = |name: &str| {
        let mut vars = hierarchy.all_vars();
        let var = vars.find(|var| hierarchy[*var].full_name(hierarchy) == name).unwrap();
        hierarchy[var].signal_ref()
    };
    let [sample, clk] = ["onepulse.sample", "onepulse.clk"].map(find);
    wave.load_signals(&[sample, clk]);
    let times = wave.time_table().to_vec();
    let rises = |signal| -> Vec<u64> {
        let changes = wave.get_signal(signal).unwrap().iter_changes();
        let ones = changes.filter(|(_, value)| value.to_string() == "1");
        ones.map(|(at, _)| times[at as usize]).collect()
    };
    let (samples, clocks) = (rises(sample), rises(clk));
    // One every 8 ms, in picoseconds, in the first clock of 2^n.
    let mut due = vec![];
    let mut clock = 0;
    for block in report["blocks"].as_array().unwrap() {
        for _ in 0..block["sampling"]["samples"].as_u64().unwrap() {
            due.push(8_000_000_000 * due.len() as u64);
            assert_eq!(Some(&clocks[clock]), due.last());
            clock += 1 << block["sampling"]["bits"].as_u64().unwrap();
        }
    }
    assert_eq!(samples, due);
}

#[test]
fn the_machine_may_have_two_levels() {
    let machine =
        "two_level = true\nperiod_ms = 4\nsampling = \"7360\"\ntolerance_mm = 0.0005\nbits = 8\n";
    let folder = folder(CIRCLE, machine);
    let (of_file, _) = report(folder.path(), "p.nc --config m.toml --no-waves");
    check(&of_file);
    let given = "--two-level --period 4 --sampling 7360 --tolerance 0.0005 --bits 8";
    let (of_options, _) = report(folder.path(), &format!("p.nc {given} --no-waves"));
    assert_eq!(of_file, of_options);
    assert_eq!(of_file["machine"]["two_level"]["period_ms"], 4.0);
    assert_eq!(of_file["machine"]["bits"], 8);
    assert_eq!(of_file["blocks"][1]["sampling"]["bits"], 8);

    // The command line overrules the file: another period, and another method altogether.
    let (other, _) = report(folder.path(), "p.nc --config m.toml --no-waves --period 2");
    assert_eq!(other["blocks"][1]["sampling"]["period_ms"], 2.0);
    let (one_level, _) =
        report(folder.path(), "p.nc --config m.toml --no-waves --method ppc --bits 16");
    assert_eq!(one_level["blocks"][1]["method"], "ppc");
    assert_eq!(one_level["blocks"][1]["sampling"], Value::Null);
    assert_eq!(one_level["machine"]["two_level"], Value::Null);

    // A machine of one level keeps its width to itself.
    let levels =
        "method = \"ppc\"\nbits = 24\nend_rule = \"total\"\npreset = \"zero\"\nperiod_ms = 4\n";
    fs::write(folder.path().join("m.toml"), levels).unwrap();
    let (both, _) = report(folder.path(), "p.nc --config m.toml --two-level --no-waves");
    check(&both);
    assert_eq!(both["blocks"][1]["sampling"]["bits"], 5);
    assert_eq!(both["machine"]["bits"], Value::Null);
}

#[test]
fn settings_that_do_not_go_together_are_refused() {
    for (arguments, words) in [
        ("--two-level --method ppc", "--two-level belongs to --method dda"),
        ("--two-level --method brm", "--two-level belongs to --method dda"),
        ("--period 4", "--period belongs to --two-level"),
        ("--method dda --sampling 7360", "--sampling belongs to --two-level"),
        ("--tolerance 0.01", "--tolerance belongs to --two-level"),
        ("--two-level --preset zero", "--preset is not for two levels"),
        ("--two-level --normalize", "--normalize is not for two levels"),
        ("--two-level --update staggered", "--update is not for two levels"),
        ("--two-level --end-rule total", "--end-rule belongs to --method ppc"),
        ("--two-level --radix 10", "--radix 10"),
        ("--two-level --period 0", "--period = 0: more than zero"),
        ("--two-level --period -8", "--period = -8"),
        ("--two-level --period x", "--period = x"),
        ("--two-level --tolerance 0", "--tolerance = 0"),
        ("--two-level --sampling euler", "--sampling"),
        ("--two-level --bits 99", "--bits"),
    ] {
        let folder = folder(CIRCLE, "");
        let output = run(folder.path(), &format!("p.nc {arguments} --out out"));
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {errors}");
        assert!(errors.contains(words), "{arguments}: '{words}' is missing in: {errors}");
        assert!(!folder.path().join("out").exists(), "{arguments}");
    }
    for (machine, words) in [
        ("two_level = true\nmethod = \"ppc\"", "two_level"),
        ("two_level = true\nperiod_ms = 0", "period_ms"),
        ("two_level = true\ntolerance_mm = -1", "tolerance_mm"),
        ("two_level = true\nsampling = \"euler\"", "line 2"),
        ("two_level = true\nbits = 99", "bits"),
    ] {
        let folder = folder(CIRCLE, machine);
        let output = run(folder.path(), "p.nc --config m.toml --out out");
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{machine}: {errors}");
        assert!(errors.contains("m.toml") && errors.contains(words), "{machine}: {errors}");
        assert!(!folder.path().join("out").exists(), "{machine}");
    }
}
