//! `onepulse contour-error`: what ramps and position loops take from a path.
#![allow(clippy::unwrap_used)]

use assert_cmd::cargo::cargo_bin_cmd;
use std::process::Output;

fn run(options: &str) -> Output {
    cargo_bin_cmd!("onepulse")
        .arg("contour-error")
        .args(options.split_whitespace())
        .output()
        .unwrap()
}

/// By the formula, exactly and measured, of each error.
fn errors(options: &str) -> Vec<[f64; 3]> {
    let output = run(&format!("{options} --format csv"));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{options}: {said}");
    let text = String::from_utf8(output.stdout).unwrap();
    let rows: Vec<_> = text.lines().skip(1).collect();
    let numbers = |row: &&str| {
        let cells: Vec<f64> = row.rsplit(',').take(3).map(|cell| cell.parse().unwrap()).collect();
        [cells[2], cells[1], cells[0]]
    };
    assert_eq!(rows.len(), 6);
    rows.iter().map(numbers).collect()
}

#[test]
fn what_is_measured_is_what_was_foretold() {
    for options in [
        "",
        "--radius 5 --feed 1000 --period 1 --ramp-time 20 --servo-gain 50 --servo-drive 4",
        "--radius 100 --feed 6000 --period 2.5 --ramp-time 33 --servo-gain 80 --servo-drive 1",
        "--radius 3 --feed 500 --period 10.24 --ramp-time 11 --servo-gain 20",
    ] {
        for (row, [_, exact, measured]) in errors(options).into_iter().enumerate() {
            // Corners are looked at in 64 points of each increment.
            let nearly = if row == 3 || row == 5 { 0.02 } else { 2e-6 };
            assert!((exact - measured).abs() < nearly, "{options}, row {row}: {exact} {measured}");
            assert!(measured <= exact + 2e-6, "{options}, row {row}: {exact} {measured}");
        }
    }
}

/// R = 20 mm at 50 mm/s, τ = 50 ms, K_v = 25/s: worked by hand.
#[test]
fn the_formulas_are_the_textbooks() {
    let rows = errors("--radius 20 --feed 3000 --period 0.1 --ramp-time 50 --servo-gain 25");
    let by_hand = [2.0, 0.1, 0.15625, 50.0 * 0.05 / std::f64::consts::E, 0.013_020_8, 0.3125];
    for ([formula, exact, _], by_hand) in rows.into_iter().zip(by_hand) {
        assert!((formula - by_hand).abs() < 1e-6, "{formula} {by_hand}");
        // With so short a period they are right, to the next power of the error.
        assert!((exact / formula - 1.0).abs() < 0.02, "{exact} {formula}");
    }
}

#[test]
fn the_table_is_in_both_languages() {
    let chinese = String::from_utf8(run("--lang zh").stdout).unwrap();
    assert!(chinese.starts_with("误差, mm"), "{chinese}");
    assert!(chinese.contains("指数加减速") && chinese.contains("τ²v²/(24R)"), "{chinese}");
}

#[test]
fn what_cannot_be_run_is_refused() {
    for (options, words) in [
        ("--servo-gain 300", "gain"),
        ("--servo-gain nan", "gain"),
        ("--servo-drive -1", "time constant"),
        ("--ramp-time 3", "--ramp-time"),
        ("--ramp-time 9000", "1000 sample periods"),
        ("--period 0", "--period"),
        ("--feed 100000", "radius"),
        ("--radius 100000", "radius"),
    ] {
        let output = run(options);
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{options}: {said}");
        assert!(said.contains(words), "{options}: {said}");
        assert!(output.stdout.is_empty(), "{options}");
    }
}
