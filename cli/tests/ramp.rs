//! `onepulse ramp`: the pulses of one axis.
#![allow(clippy::unwrap_used)]

use assert_cmd::cargo::cargo_bin_cmd;
use std::process::Output;

fn run(options: &str) -> Output {
    cargo_bin_cmd!("onepulse").arg("ramp").args(options.split_whitespace()).output().unwrap()
}

/// The times of the pulses, the speeds at them, and what is said of the registers.
fn pulses(options: &str) -> (Vec<f64>, Vec<f64>, String) {
    let output = run(options);
    let note = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{note}");
    let text = String::from_utf8(output.stdout).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("pulse,clock,time,interval,speed"));
    let (mut times, mut speeds) = (Vec::new(), Vec::new());
    for (number, line) in (1..).zip(lines) {
        let cells: Vec<_> = line.split(',').collect();
        assert_eq!(cells[0], number.to_string());
        let time: f64 = cells[2].parse().unwrap();
        if let Some(last) = times.last() {
            let interval: f64 = cells[3].parse().unwrap();
            assert!((time - last - interval).abs() < 1e-8);
        }
        times.push(time);
        speeds.push(cells[4].parse().unwrap());
    }
    (times, speeds, note)
}

#[test]
fn a_trapezoid_takes_as_long_as_its_formula_says() {
    // 0.2 s up to 20 000/s over 2000 pulses, 46 000 at that, 2000 down.
    let (times, speeds, note) =
        pulses("--pulses 50000 --largest 20000 --acceleration 100000 --clock 1000000");
    assert_eq!(times.len(), 50_000);
    assert!((times[49_999] - (0.2 + 2.3 + 0.2)).abs() < 1e-3, "{}", times[49_999]);
    // A clock changes the speed by 0.1/s: the last of these steps may not fit.
    assert!((19_999.9..=20_000.0).contains(&speeds[25_000]), "{}", speeds[25_000]);
    let fastest = times.windows(2).map(|pair| pair[1] - pair[0]).fold(1.0, f64::min);
    assert!((49e-6..=50e-6).contains(&fastest), "{fastest}");
    assert!(note.contains("31 bits"), "{note}");
}

#[test]
fn a_start_frequency_is_there_at_once() {
    let (times, speeds, _) = pulses("--pulses 100 --start 500 --acceleration 1000 --largest 600");
    assert!((times[0] - 0.002).abs() < 2e-5, "{}", times[0]);
    assert!((500.0..502.1).contains(&speeds[0]), "{}", speeds[0]);
    assert!(speeds.iter().all(|speed| *speed <= 600.0));
}

#[test]
fn an_s_curve_is_later_by_its_window() {
    let limits = "--pulses 2000 --largest 20000 --acceleration 100000 --clock 100000";
    let (times, _, note) = pulses(&format!("{limits} --jerk 10000000"));
    // 2·10⁵·10⁵/10⁷ clocks, the next power of two; in 20 bits of that clock the unit of an acceleration is
    // 10¹⁰/2²⁰.
    assert!(note.contains("20 bits") && note.contains("the mean of 2048 clocks"), "{note}");
    let acceleration = (1e5_f64 / (1e10 / 2_f64.powi(20))).floor() * (1e10 / 2_f64.powi(20));
    let peak = 2.0 * (2000.0 / acceleration).sqrt();
    let end = times.last().unwrap();
    assert!((end - (peak + 0.02048)).abs() < 1e-3, "{end} {peak}");
    assert_eq!(times.len(), 2000);
}

#[test]
fn every_number_of_pulses_is_made() {
    for count in [0, 1, 2, 3, 10, 1000] {
        for shape in ["", "--jerk 100000000", "--jerk 2500000", "--start 300"] {
            assert_eq!(pulses(&format!("--pulses {count} {shape}")).0.len(), count, "{shape}");
        }
    }
}

#[test]
fn a_plot_is_drawn() {
    let text = String::from_utf8(run("--pulses 500 --format svg").stdout).unwrap();
    assert!(text.starts_with("<svg") && text.contains("pulse interval"), "{text}");
    assert!(run("--pulses 0 --format svg").status.success());
}

#[test]
fn what_the_registers_do_not_hold_is_refused() {
    for (options, words) in [
        ("--pulses 5 --largest 0", "--largest"),
        ("--pulses 5 --largest 200000", "faster --clock"),
        ("--pulses 5 --acceleration nan", "--acceleration"),
        ("--pulses 5 --acceleration 0.5 --clock 1e6", "slower --clock"),
        ("--pulses 5 --start 30000", "--start"),
        ("--pulses 5 --start 3 --jerk 1000000", "--jerk"),
        ("--pulses 5 --jerk 1000", "8192 clocks"),
        ("--pulses -5", "--pulses"),
    ] {
        let output = run(options);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{options}: {errors}");
        assert!(errors.contains(words), "{options}: {errors}");
        assert!(output.stdout.is_empty(), "{options}");
    }
}
