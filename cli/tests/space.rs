//! `onepulse run` and `onepulse profile` of programs that move X, Y and Z.
#![allow(clippy::unwrap_used)]

mod common;

use common::{onepulse, report, said};
use serde_json::Value;
use std::collections::{BTreeMap, HashMap};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A pocket at a depth of 1 mm, a groove along an arc in ZX, one along an arc in YZ, and a ramp.
const POCKET: &str = "G21 G90 G17
G00 Z5.
G00 X4. Y3.
G01 Z-1. F300
G01 X8.
G03 X8. Y7. J2.
G01 X4.
G03 X4. Y3. J-2.
G18 G03 X8. Z-1. I2. K0.
G19 G03 Y7. Z-1. J2. K0.
G17 G01 X3. Z-2.
G00 Z5.
G00 X0. Y0.
G00 Z0.
M02
";

/// Where each block of it ends, in pulses of 0.01 mm, by its line.
const ENDS: [(i64, [i64; 3]); 13] = [
    (2, [0, 0, 500]),
    (3, [400, 300, 500]),
    (4, [400, 300, -100]),
    (5, [800, 300, -100]),
    (6, [800, 700, -100]),
    (7, [400, 700, -100]),
    (8, [400, 300, -100]),
    (9, [800, 300, -100]),
    (10, [800, 700, -100]),
    (11, [300, 700, -200]),
    (12, [300, 700, 500]),
    (13, [0, 0, 500]),
    (14, [0, 0, 0]),
];

/// A line of all three axes.
const RAMP: &str = "G01 X3. Y5. Z-2. F300\nG00 X0. Y0. Z0.\n";

fn folder(program: &str) -> TempDir {
    common::folder(&[("p.nc", program)])
}

/// Runs into `out`; the report and the summary.
fn run(folder: &Path, options: &str) -> (Value, String) {
    let summary = said(folder, &format!("run p.nc --out out {options}"));
    (report(folder), summary)
}

fn of_axes(value: &Value) -> [i64; 3] {
    ["x", "y", "z"].map(|axis| value[axis].as_i64().unwrap())
}

/// The rows of `pulses.csv`: line, cycle, dx, dy, dz, x, y, z.
fn rows(folder: &Path) -> Vec<[i64; 8]> {
    let text = fs::read_to_string(folder.join("out/pulses.csv")).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("line,cycle,dx,dy,dz,x,y,z"));
    let row = |line: &str| {
        let numbers: Vec<_> = line.split(',').map(|number| number.parse().unwrap()).collect();
        numbers.try_into().unwrap()
    };
    lines.map(row).collect()
}

/// The pulses of each axis add up to the positions beside them, and to those of the report.
fn check(folder: &Path, report: &Value) -> BTreeMap<i64, [i64; 3]> {
    assert_eq!(report["hardware_agrees"], true);
    let (mut position, mut ends) = ([0; 3], BTreeMap::new());
    let mut counts: BTreeMap<i64, [i64; 3]> = BTreeMap::new();
    for [line, cycle, dx, dy, dz, x, y, z] in rows(folder) {
        let pulse = [dx, dy, dz];
        assert!(pulse != [0; 3] && pulse.iter().all(|c| c.abs() <= 1), "{line}, {cycle}");
        let count = counts.entry(line).or_default();
        for axis in 0..3 {
            position[axis] += pulse[axis];
            count[axis] += pulse[axis].abs();
        }
        assert_eq!(position, [x, y, z], "line {line}, cycle {cycle}");
        ends.insert(line, position);
    }
    assert_eq!(of_axes(&report["final_position"]), position);
    let (mut total, mut of_blocks) = ([0; 3], BTreeMap::new());
    for block in report["blocks"].as_array().unwrap() {
        assert_eq!(block["endpoint_exact"], true, "{block}");
        assert_eq!(block["hardware_agrees"], true, "{block}");
        assert_eq!(of_axes(&block["residual"]), [0; 3], "{block}");
        let pulses = of_axes(&block["pulses"]);
        of_blocks.insert(block["line"].as_i64().unwrap(), pulses);
        total = [0, 1, 2].map(|axis| total[axis] + pulses[axis]);
    }
    assert_eq!(counts, of_blocks);
    assert_eq!(of_axes(&report["totals"]["pulses"]), total);
    ends
}

/// The changes of the signals of the wave, by their full names: times and values as text.
fn wave(folder: &Path) -> HashMap<String, Vec<(u64, String)>> {
    let mut wave = wellen::simple::read(folder.join("out/waves.vcd")).unwrap();
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
    signals.into_iter().map(|(name, signal)| (name, changes(signal))).collect()
}

#[test]
fn a_pocket_with_grooves_in_all_planes() {
    for options in [
        "--method ppc",
        "--method dda",
        "--method min-deviation",
        "--method compare-integral",
        "--two-level",
        "--two-level --accelerate --jerk 20000 --servo-gain 30",
    ] {
        let folder = folder(POCKET);
        let (report, summary) = run(folder.path(), options);
        assert_eq!(check(folder.path(), &report), BTreeMap::from(ENDS), "{options}");
        assert!(summary.contains("x pulses  y pulses  z pulses"), "{summary}");
        assert!(summary.contains("final position 0,0,0"), "{summary}");
        // Counter-clockwise seen from +y, z to the right and x up: over the top, 1 mm above z = 0. Seen from
        // +x, y to the right and z up: below, 3 mm under it.
        let of_line = |line: i64| rows(folder.path()).into_iter().filter(move |row| row[0] == line);
        assert_eq!(of_line(9).map(|row| row[7]).max(), Some(100), "{options}");
        assert_eq!(of_line(10).map(|row| row[7]).min(), Some(-300), "{options}");
        assert!(of_line(9).all(|row| row[3] == 0) && of_line(10).all(|row| row[2] == 0));
        let following = &report["motion"]["servo"]["largest_following_error_mm"];
        assert_eq!(following.get("z").is_some(), options.contains("servo"));
        assert_eq!(summary.contains("mm in y, "), options.contains("servo"));
    }
}

/// The wave counts to the same end, says which plane runs, and moves a circuit's registers there.
#[test]
fn the_wave_has_the_third_axis() {
    let folder = folder(POCKET);
    run(folder.path(), "");
    let changes = wave(folder.path());
    let planes: Vec<_> = changes["onepulse.plane"].iter().map(|(_, plane)| &plane[..]).collect();
    // The plunge and the retract are lines along the first axis of ZX.
    assert_eq!(planes, ["zx", "xy", "zx", "xy", "zx", "yz", "zx", "xy", "zx"]);
    for axis in ["x", "y", "z"] {
        let (_, last) = changes[&format!("onepulse.position_{axis}")].last().unwrap();
        assert_eq!(i64::from_str_radix(last, 2).unwrap(), 0, "{axis}");
        assert!(changes[&format!("onepulse.pulse_{axis}")].len() > 1000);
    }
    assert!(!changes.keys().any(|name| name.contains("_xyz")));
}

#[test]
fn a_line_of_three_axes_by_the_methods_that_have_its_circuit() {
    for (options, circuit) in [
        ("--method dda", "dda_line_xyz"),
        ("--method brm", "brm_line_xyz"),
        ("--method min-deviation", "minimum_deviation_line_xyz"),
        ("--two-level", "dda_line_xyz"),
        ("--two-level --accelerate", "dda_line_xyz"),
    ] {
        let folder = folder(RAMP);
        let (report, _) = run(folder.path(), options);
        let ends = check(folder.path(), &report);
        assert_eq!(ends, BTreeMap::from([(1, [300, 500, -200]), (2, [0, 0, 0])]), "{options}");
        let changes = wave(folder.path());
        let planes: Vec<_> = changes["onepulse.plane"].iter().map(|(_, plane)| plane).collect();
        assert_eq!(planes, ["xyz"], "{options}");
        // Its registers work, and those of the plane's circuit are never loaded.
        let busiest = |circuit: &str| {
            let scope = format!("onepulse.{circuit}.");
            let signals = changes.iter().filter(|(name, _)| name.starts_with(&scope));
            signals.map(|(_, changes)| changes.len()).max()
        };
        assert!(busiest(circuit) > Some(100), "{options}");
        assert!(busiest(circuit.trim_end_matches("_xyz")) <= Some(1), "{options}");
    }
}

/// The circuit of three axes is there also if the last line does not need it.
#[test]
fn a_line_of_three_axes_may_come_before_one_of_two() {
    let folder = folder("G01 X3. Y5. Z-2. F300\nX4. Y2.\n");
    let (report, _) = run(folder.path(), "--method dda");
    let ends = check(folder.path(), &report);
    assert_eq!(ends, BTreeMap::from([(1, [300, 500, -200]), (2, [400, 200, -200])]));
    assert!(wave(folder.path()).keys().any(|name| name.starts_with("onepulse.dda_line_xyz.")));
}

#[test]
fn a_line_of_three_axes_is_refused_where_there_is_no_circuit() {
    for method in ["ppc", "compare-integral"] {
        let folder = folder(&POCKET.replace("M02", "G01 X1. Y1. Z1.\nM02"));
        let output = onepulse(folder.path(), &format!("run p.nc --out out --method {method}"));
        assert_eq!(output.status.code(), Some(1));
        let errors = String::from_utf8(output.stderr).unwrap();
        for words in ["p.nc:15:1: X, Y and Z move at once", method, "──┬──", "take --method dda"]
        {
            assert!(errors.contains(words), "{words}: {errors}");
        }
        // Before anything is made.
        assert!(!folder.path().join("out").exists());
    }
}

#[test]
fn the_picture_is_as_seen_along_z() {
    let folder = folder(POCKET);
    run(folder.path(), "--no-waves");
    let picture = fs::read_to_string(folder.path().join("out/path.svg")).unwrap();
    let curves: Vec<_> = picture.lines().filter(|line| line.contains("class=\"f\"")).collect();
    assert_eq!(curves.len(), 8);
    assert!(curves[1].contains("M400 300L800 300\""), "{}", curves[1]);
    assert!(curves[2].contains("M800 300A200.000 200.000 0 0 1 800 700\""), "{}", curves[2]);
    // Steps along z are none in the picture.
    assert!(!picture.contains("h0") && !picture.contains("v0") && !picture.contains("l0"));
    // Half a turn from the side.
    assert!(curves[5].contains("M400 300") && curves[5].contains("L800 300\""), "{}", curves[5]);
    assert!(curves[6].contains("M800 300") && curves[6].contains("L800 700\""), "{}", curves[6]);
}

#[test]
fn the_motion_over_time_has_the_third_axis() {
    let folder = folder(POCKET);
    let text = said(folder.path(), "profile p.nc --servo-gain 30");
    let mut lines = text.lines();
    let header = "time,line,x,y,z,speed,acceleration,jerk,interval_x,interval_y,interval_z,\
                  error_x,error_y,error_z";
    assert_eq!(lines.next(), Some(header));
    let number = |cell: &str| cell.parse::<f64>().unwrap_or(0.0);
    let rows: Vec<Vec<f64>> = lines.map(|line| line.split(',').map(number).collect()).collect();
    let columns = header.split(',').count();
    assert!(rows.iter().all(|row| row.len() == columns));
    let (mut time, mut pulses) = (0.0, 0.0);
    for row in &rows {
        // One over the mean interval is the frequency.
        if row[10] > 0.0 {
            pulses += (row[0] - time) / row[10];
        }
        time = row[0];
    }
    // Up 5 mm, down 6, the arc up and down 2, the other down and up 2, down 1, up 7, down 5.
    assert!((pulses - 100.0 * (5.0 + 6.0 + 4.0 + 4.0 + 1.0 + 7.0 + 5.0)).abs() < 1.0, "{pulses}");
    assert!(rows.iter().any(|row| row[13].abs() > 0.1), "z follows");
    // The last of it comes to rest too: within half a pulse, which its last row still corrects.
    fs::write(folder.path().join("p.nc"), "G00 Z-20.\n").unwrap();
    let plunge = said(folder.path(), "profile p.nc --servo-gain 30");
    let error_z = plunge.rsplit(',').next().unwrap().trim();
    assert!(number(error_z).abs() < 0.01 && number(error_z) != 0.0, "{error_z}");
    fs::write(folder.path().join("p.nc"), POCKET).unwrap();
    let plot = said(folder.path(), "profile p.nc --format svg");
    assert!(plot.matches("\nz\n").count() == 1, "a legend with z");
    // Without Z nothing of it.
    fs::write(folder.path().join("p.nc"), "G00 X5. Y3.\n").unwrap();
    let text = said(folder.path(), "profile p.nc --servo-gain 30");
    assert!(!text.lines().next().unwrap().contains('z'));
    assert!(!said(folder.path(), "profile p.nc --format svg").contains("\nz\n"));
}

/// A corner between two planes is passed at the speed that its angle in space allows.
#[test]
fn a_corner_between_planes_is_as_slow_as_one_in_a_plane() {
    let folder = folder("G91 G01 F3000\nZ-20.\nX20.\nY20. Z20.\n");
    let text = said(folder.path(), "profile p.nc --corner 10");
    let speed_at_end_of = |line: &str| {
        let mut rows = text.lines().map(|row| row.split(',').collect::<Vec<_>>());
        let last = rows.rfind(|row| row[1] == line).unwrap();
        last[5].parse::<f64>().unwrap()
    };
    // The velocity jumps by √2 of the speed in a right angle: from -z to x, and from x to (y, z).
    assert!((speed_at_end_of("2") - 10.0 / 2_f64.sqrt()).abs() < 1e-5);
    assert!((speed_at_end_of("3") - 10.0 / 2_f64.sqrt()).abs() < 1e-5);
}
