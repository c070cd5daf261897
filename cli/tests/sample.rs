//! `onepulse sample`: points in millimetres.
#![allow(clippy::unwrap_used)]

use assert_cmd::cargo::cargo_bin_cmd;
use std::process::Output;

fn sample(arguments: &str) -> Output {
    cargo_bin_cmd!("onepulse").arg("sample").args(arguments.split_whitespace()).output().unwrap()
}

/// The header and the rows, and what was said beside.
fn table(arguments: &str) -> (String, Vec<Vec<f64>>, String) {
    let output = sample(arguments);
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments}: {said}");
    let text = String::from_utf8(output.stdout).unwrap();
    let (header, rows) = text.split_once('\n').unwrap();
    let row = |line: &str| line.split(',').map(|number| number.parse().unwrap()).collect();
    (header.to_owned(), rows.lines().map(row).collect(), said)
}

#[test]
fn a_line_has_the_steps_of_the_seeds_formula() {
    // f = 2v/15 µm: 40 µm at 300 mm/min, along (3, 4).
    let (header, rows, said) = table("line --to 300,400 --feed 300 --period 8 --pulse-mm 0.001");
    assert_eq!((header.as_str(), said.as_str()), ("k,x,y", ""));
    assert_eq!(rows.len(), 13); // 500 µm: twelve steps and a half
    for (k, row) in (1..=12).zip(&rows) {
        let way = f64::from(k) * 0.04;
        assert!((row[1] - 0.6 * way).abs() < 1e-12 && (row[2] - 0.8 * way).abs() < 1e-12);
    }
    assert_eq!(rows.last().unwrap()[..], [13.0, 0.3, 0.4]);
}

#[test]
fn a_line_in_space_has_its_steps_too() {
    // 7 mm in steps of 0.4: along (2, 3, 6).
    let (header, rows, _) = table("line --to 2000,-3000,6000 --feed 3000");
    assert_eq!(header, "k,x,y,z");
    assert_eq!(rows.len(), 18);
    assert!((rows[0][3] - 0.4 * 6.0 / 7.0).abs() < 1e-12 && rows[0][2] < 0.0);
    assert_eq!(rows[17][..], [18.0, 2.0, -3.0, 6.0]);
    assert_eq!(table("line --to 1,2,3,4").0, "k,x,y,z,a");
}

#[test]
fn an_arc_ends_on_its_end_point() {
    for method in ["7m", "7360", "direct-function", "second-order"] {
        let (_, rows, _) =
            table(&format!("arc --from 3000,4000 --to -5000,0 --cw --feed 900 --method {method}"));
        assert_eq!(rows.last().unwrap()[1..], [-5.0, 0.0], "{method}");
        for row in &rows[..rows.len() - 1] {
            let off = row[1].hypot(row[2]) / 5.0 - 1.0;
            assert!(off.abs() < 1e-9 || method == "7360" && off < 1e-5, "{method}: {off}");
        }
    }
}

#[test]
fn the_tolerance_reduces_the_feed() {
    let arc = "arc --from 5000,0 --to 0,5000 --ccw --feed 3000 --errors";
    let (header, rows, _) = table(arc);
    assert_eq!(header, "k,x,y,chord_error,textbook_chord_error,radius_error");
    assert!(rows[0][3] > 1e-3 && rows[0][4] < rows[0][3]);
    let (_, rows, said) = table(&format!("{arc} --tolerance 0.0001"));
    // 2·√(2re − e²)/T: 63.2 µm in 8 ms.
    assert!(said.contains("474.3"), "{said}");
    assert!(rows.iter().all(|row| row[3] <= 1e-4));
}

#[test]
fn what_cannot_be_sampled_is_a_wrong_command_line() {
    for arguments in [
        "parabola --p 2 --to 4,4",
        "arc --from 50,0 --to 0,50 --ccw --feed 30000",
        "arc --from 0,0 --to 0,50 --ccw",
        "line --to 5,3 --feed 0",
        "line --to 5,3 --period x",
        "line --to 5,3 --pulse-mm -1",
        "arc --from 50,0 --to 0,50 --ccw --tolerance 0",
    ] {
        let output = sample(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments}");
        assert!(output.stdout.is_empty(), "{arguments}");
    }
}
