//! `onepulse feed-rate`: the ratios of the textbooks' formulas.
#![allow(clippy::unwrap_used)]

use assert_cmd::cargo::cargo_bin_cmd;
use std::f64::consts::SQRT_2;

fn stdout(arguments: &[&str]) -> String {
    let output = cargo_bin_cmd!("onepulse").arg("feed-rate").args(arguments).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The header and the rows.
fn table(arguments: &[&str]) -> (String, Vec<Vec<f64>>) {
    let text = stdout(arguments);
    let (header, rows) = text.split_once('\n').unwrap();
    let row = |line: &str| line.split(',').map(|number| number.parse().unwrap()).collect();
    (header.to_owned(), rows.lines().map(row).collect())
}

#[test]
fn the_direction_decides_how_fast_a_line_is() {
    let (header, rows) = table(&["direction"]);
    assert_eq!(header, "degrees,ppc,compare-integral,min-deviation,vector");
    assert_eq!(rows.len(), 91);
    for row in rows {
        let (sin, cos) = row[0].to_radians().sin_cos();
        let one_axis = 1.0 / (sin + cos);
        let longer_axis = 1.0 / (sin.max(cos) * SQRT_2);
        // The pulses of the two axes are level a few times on the line, but on the diagonal always.
        let level = if row[0] == 45.0 { 1.0 } else { one_axis / SQRT_2 };
        for (ratio, expected) in row[1..].iter().zip([one_axis, level, longer_axis, longer_axis]) {
            assert!((ratio - expected).abs() < 5e-4, "{row:?}: {expected}");
        }
    }
}

#[test]
fn the_length_decides_how_fast_a_line_by_integration_is() {
    let (header, rows) = table(&["length", "--bits", "5"]);
    assert_eq!(header, "length,dda,dda-normalized");
    assert_eq!(rows.len(), 31);
    for row in rows {
        let length = row[0];
        // L/2ⁿ, and the same with the power of two next above L.
        let power = 2_f64.powf((length + 0.5).log2().ceil());
        assert!((row[1] - length / 32.0).abs() < 1e-4, "{row:?}");
        assert!((row[2] - length / power).abs() < 1e-4, "{row:?}");
    }
}

#[test]
fn the_plot_has_a_line_for_each_method() {
    let plot = stdout(&["length", "--format", "svg"]);
    assert!(plot.starts_with("<svg"));
    for name in ["dda-normalized", "v/v_max", "length"] {
        assert!(plot.contains(name), "{name}");
    }
}
