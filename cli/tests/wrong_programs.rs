//! Programs of any kind: the exit status tells, and nothing is left of a run that fails.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use assert_cmd::cargo::cargo_bin_cmd;
use proptest::prelude::*;
use std::fs;
use std::path::Path;
use std::process::Output;
use tempfile::TempDir;

/// Programs that are nearly right: of short ways, or of far too long ones.
fn programs() -> impl Strategy<Value = Vec<u8>> {
    let number = prop_oneof![
        6 => "-?[0-9]{1,2}",
        4 => "-?[0-9]{0,1}\\.[0-9]{1,2}",
        1 => Just("99999999999".to_owned()),
        1 => Just(String::new()),
    ];
    let word = prop_oneof![
        4 => prop::sample::select(&["G00", "G01", "G02", "G03", "G90", "G91"][..]).prop_map(str::to_owned),
        1 => prop::sample::select(
            &["G04P1", "G18", "G19", "G17", "G20", "G21", "G40", "G41", "G42", "D1", "T2", "M00", "M02", "M06", "(圆)", "(", "%", "/"][..],
        )
        .prop_map(str::to_owned),
        8 => ("[XYZIJKR]", number).prop_map(|(letter, number)| letter + &number),
    ];
    let block = prop::collection::vec(word, 1..5).prop_map(|words| words.join(" "));
    let blocks = prop::collection::vec(block, 1..6);
    let text = blocks.prop_map(|blocks| format!("F200 G01\n{}\n", blocks.join("\n")).into_bytes());
    prop_oneof![
        8 => text,
        1 => contours().prop_map(String::into_bytes),
        1 => prop::collection::vec(any::<u8>(), 0..100),
    ]
}

/// Round corners that some cutters do not fit.
fn contours() -> impl Strategy<Value = String> {
    let point = (-9..=9_i32, -9..=9_i32);
    prop::collection::vec(point, 3..7).prop_map(|points| {
        let points: Vec<_> = points.iter().map(|(x, y)| format!("X{x}. Y{y}.\n")).collect();
        format!("F200\nG41 G01 {}G40 X20. Y20.\nM02\n", points.concat())
    })
}

/// Runs the program in a folder; the exit status is one of those that are documented.
fn onepulse(folder: &Path, command: &str, options: &str) -> Output {
    let mut onepulse = cargo_bin_cmd!("onepulse");
    onepulse.current_dir(folder).arg(command).arg("program.nc").args(options.split_whitespace());
    let output = onepulse.output().unwrap();
    let said = String::from_utf8(output.stderr.clone()).unwrap();
    assert!(matches!(output.status.code(), Some(0..=2)), "{:?}: {said}", output.status);
    assert!(!said.contains("panicked"), "{said}");
    assert!(
        output.status.success() || !said.is_empty(),
        "{command} {options} fails without a word"
    );
    output
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 200,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn what_fails_leaves_nothing(
        program in programs(),
        cutters in prop::sample::select(&["", "--radius 1", "--radius 3", "--radius 1 --type b", "--radius -1"][..]),
        method in prop::sample::select(&["", "--method dda", "--two-level", "--method vector", "--two-level --accelerate"][..]),
        format in prop::sample::select(&["csv", "ngc", "svg"][..]),
        out in prop::sample::select(&["out", "a/b/out", "."][..]),
    ) {
        let folder = TempDir::new().unwrap();
        fs::write(folder.path().join("program.nc"), &program).unwrap();
        let left = || fs::read_dir(folder.path()).unwrap().count();

        let offset = onepulse(folder.path(), "offset", &format!("{cutters} --format {format}"));
        prop_assert_eq!(left(), 1, "the path goes to standard output");
        // Where the cutter would cut in is drawn.
        if !offset.status.success() && format != "svg" {
            prop_assert_eq!(offset.stdout, b"");
        }

        let run = onepulse(folder.path(), "run", &format!("{cutters} {method} --out {out}"));
        if run.status.success() {
            prop_assert!(offset.status.success(), "what is run has a path");
            prop_assert!(folder.path().join(out).join("report.json").is_file());
        } else {
            prop_assert_eq!(left(), 1, "{}", String::from_utf8_lossy(&run.stderr));
        }
    }
}
