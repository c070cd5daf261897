//! Programs of motions made by hand, through all that a run does with them.

use super::*;
use crate::args::{Arguments, Command};
use clap::Parser;
use onepulse_core::{Direction, Plane};
use onepulse_plan::{Length, Motion, Place, Rate};
use proptest::prelude::*;
use std::fs;
use std::path::Path;

/// What a run wrote: the rows of `pulses.csv` and the report.
struct Written {
    header: String,
    rows: Vec<Vec<i64>>,
    report: serde_json::Value,
}

/// Runs motions, which stand in as many lines.
fn run_motions(motions: &[Motion], options: &str) -> Result<Written, Failure> {
    let folder = tempfile::tempdir().unwrap();
    run_in(folder.path(), motions, options)
}

fn run_in(folder: &Path, motions: &[Motion], options: &str) -> Result<Written, Failure> {
    let out = folder.join("out");
    let line = ["onepulse", "run", "by hand", "--out", out.to_str().unwrap()];
    let line = line.into_iter().chain(options.split_whitespace());
    let Command::Run(arguments) = Arguments::try_parse_from(line).unwrap().command else {
        panic!("another command");
    };
    let config = Config::load(&arguments)?;
    let method = Method::from_options(&config.options).map_err(Failure::Usage)?;
    let checker = Checker { config: &config, method: &method, name: "by hand" };
    let mut survey = Survey::new(config.machine.pulse);
    let place = Place { line: 1, text: "a block".into(), span: 0..7 };
    motions.iter().for_each(|motion| survey.add(motion));
    let step = |&motion| Move { motion, place: place.clone(), tool: None, spindle: None };
    let steps: Vec<_> = motions.iter().map(step).collect();
    let actions: Vec<_> = steps.iter().cloned().map(Action::Move).collect();
    let plan = config.motion.map(|settings| Plan::new(&actions, &config, settings).unwrap());
    let block = |part| match part {
        Part::Move(_, planned) => Some(planned),
        Part::Pause(..) => None,
    };
    let planned: Vec<_> = match &plan {
        None => vec![None; motions.len()],
        Some(plan) => plan.parts(&actions, &config).map(block).collect(),
    };
    for (motion, planned) in motions.iter().zip(&planned) {
        let refused = |wrong| checker.failure(vec![wrong]);
        checker.check(motion, &place, planned.as_ref()).map_err(refused)?;
    }
    let outputs = Outputs::create(&arguments, &config, &method, &survey)?;
    let summary = Summary::new(survey.axes());
    let mut run = Run { checker, axes: survey.axes(), outputs, summary, short: [0; 3] };
    for (step, planned) in steps.iter().zip(&planned) {
        run.block(step, planned.as_ref())?;
    }
    run.outputs.finish(&run.summary, &config)?;
    let pulses = fs::read_to_string(out.join("pulses.csv")).unwrap();
    let mut lines = pulses.lines();
    let header = lines.next().unwrap().to_owned();
    let row = |line: &str| line.split(',').map(|number| number.parse().unwrap()).collect();
    let rows = lines.map(row).collect();
    let report = fs::read_to_string(out.join("report.json")).unwrap();
    Ok(Written { header, rows, report: serde_json::from_str(&report).unwrap() })
}

fn feed() -> Rate {
    Rate::Feed(Length::from_picometres(600 * Length::MILLIMETRE.picometres()))
}

/// A program of these curves, one after the other, from the origin.
fn chained(curves: &[([i32; 3], Curve)]) -> Vec<Motion> {
    let mut from = [0; 3];
    let motions = (1..).zip(curves).map(|(line, &(to, curve))| {
        let motion = Motion { line, from, to, curve, rate: feed() };
        from = to;
        motion
    });
    motions.collect()
}

type Curve = onepulse_plan::Curve;

/// Down into a pocket, a contour in XY with a full circle, an arc in ZX and one in YZ, lines in both planes.
fn pocket() -> Vec<Motion> {
    let arc = |plane, centre, direction| Curve::Arc { plane, centre, direction };
    chained(&[
        ([0, 0, 50], Curve::Line),
        ([40, 30, 50], Curve::Line),
        ([40, 30, -10], Curve::Line),
        ([80, 30, -10], Curve::Line),
        ([80, 70, -10], arc(Plane::Xy, [80, 50], Direction::Ccw)),
        ([80, 70, -10], arc(Plane::Xy, [60, 70], Direction::Cw)),
        // About z = 10, x = 80: three quarters of a turn.
        ([60, 70, 10], arc(Plane::Zx, [10, 80], Direction::Cw)),
        // About y = 70, z = −10: a quarter.
        ([60, 90, -10], arc(Plane::Yz, [70, -10], Direction::Cw)),
        ([30, 90, -33], Curve::Line),
        ([30, 0, 0], Curve::Line),
    ])
}

/// Each row of pulses leads to the next, each block to the end of its motion, with no more pulses than
/// its curve has.
fn assert_made(motions: &[Motion], written: &Written) {
    let Written { header, rows, report } = written;
    assert_eq!(header, "line,cycle,dx,dy,dz,x,y,z");
    assert_eq!(report["hardware_agrees"], true);
    let mut rows = rows.iter().peekable();
    let mut position = [0; 3];
    let blocks = report["blocks"].as_array().unwrap();
    assert_eq!(blocks.len(), motions.len());
    for (motion, block) in motions.iter().zip(blocks) {
        assert_eq!(position.map(|c| c as i32), motion.from);
        assert_eq!(block["endpoint_exact"], true, "{block}");
        let mut counts = [0; 3];
        while let Some(row) = rows.next_if(|row| row[0] == i64::from(motion.line)) {
            for axis in 0..3 {
                position[axis] += row[2 + axis];
                counts[axis] += row[2 + axis].abs();
                assert!(row[2 + axis].abs() <= 1);
            }
            assert_eq!(row[5..], position, "{row:?}");
        }
        assert_eq!(position.map(|c| c as i32), motion.to, "{motion:?}");
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            assert_eq!(block["pulses"][name], counts[axis], "{block}");
            assert_eq!(block["residual"][name], 0, "{block}");
        }
        // Of two levels the parts bound the whole, but for rounding in floats.
        if let Some(sampling) = block.get("sampling") {
            let parts = ["chord_error", "radius_error", "rounding", "fine"];
            let bound: f64 = parts.iter().map(|part| sampling[part].as_f64().unwrap()).sum();
            let found = block["largest_deviation"].as_f64().unwrap();
            assert!(found <= bound + 1e-9, "{block}");
        }
        if let Some(plane) = motion.plane() {
            let [_, _, across] = plane.axes();
            assert_eq!(counts[across], 0, "nothing moves across the plane: {motion:?}");
        }
    }
    assert_eq!(rows.next(), None);
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        assert_eq!(report["final_position"][name], position[axis]);
    }
}

const METHODS: [&str; 8] = [
    "--method ppc",
    "--method ppc --end-rule per-axis",
    "--method dda",
    "--method dda --update simultaneous --preset half",
    "--method min-deviation",
    "--method compare-integral",
    "--two-level",
    "--two-level --accelerate --jerk 20000 --servo-gain 30",
];

#[test]
fn a_pocket_is_made_in_all_planes_by_every_method() {
    for options in METHODS {
        let written = run_motions(&pocket(), options).unwrap();
        assert_made(&pocket(), &written);
        // Within a pulse, or of two levels within what their parts allow.
        let worst = written.report["totals"]["largest_deviation"].as_f64().unwrap();
        assert!(worst > 0.4 && worst < 1.5, "{options}: {worst}");
        // The three quarters of a turn pass through the highest x and then the highest z.
        let arc: Vec<_> = written.rows.iter().filter(|row| row[0] == 7).collect();
        for (axis, due) in [(5, 80 + 20), (7, 10 + 20)] {
            let highest = arc.iter().map(|row| row[axis]).max().unwrap();
            assert!((highest - due).abs() <= 1, "{options}: {highest} for {due}");
        }
        let place = |axis: usize| arc.iter().max_by_key(|row| row[axis]).unwrap()[1];
        assert!(place(5) < place(7), "{options}");
    }
}

#[test]
fn lines_in_space_are_made_where_there_is_a_circuit() {
    let motions = chained(&[
        ([10, -20, 30], Curve::Line),
        ([-50, 21, 29], Curve::Line),
        ([-50, 30, 29], Curve::Line),
        ([0, 0, 0], Curve::Line),
    ]);
    for (options, most) in [
        // √3/2 with half load, √2 without.
        ("--method dda --preset half", 0.87),
        ("--method dda", 1.42),
        ("--method brm --bits 8", 4.0),
        ("--method min-deviation", 0.71),
        ("--two-level", 1.74),
        ("--two-level --accelerate", 1.74),
    ] {
        let written = run_motions(&motions, options).unwrap();
        assert_made(&motions, &written);
        let worst = written.report["totals"]["largest_deviation"].as_f64().unwrap();
        assert!(worst > 0.3 && worst < most, "{options}: {worst}");
        // The feed of 10 mm/s is that along the line: √(10² + 20² + 30²) pulses of 0.01 mm.
        let seconds = written.report["blocks"][0]["duration_s"].as_f64().unwrap();
        let due = 1400_f64.sqrt() / 1000.0;
        let is_exact = !options.contains("min-deviation") && !options.contains("two-level");
        assert!(!is_exact || (seconds / due - 1.0).abs() < 1e-9, "{options}: {seconds}");
    }
    for options in ["--method ppc", "--method compare-integral"] {
        let Err(Failure::Program { wrong, .. }) = run_motions(&motions, options) else {
            panic!("{options} has no such circuit");
        };
        let diagnostic = &wrong[0];
        assert_eq!((diagnostic.place.line, diagnostic.place.span.clone()), (1, 0..7));
        assert!(diagnostic.message.contains(options), "{}", diagnostic.message);
        assert!(diagnostic.help.contains("--method dda"), "{}", diagnostic.help);
    }
}

/// Without Z there is no sign of it, with it there is in every file.
#[test]
fn z_shows_if_it_ever_moves() {
    let plane = chained(&[([5, 3, 0], Curve::Line), ([0, 0, 0], Curve::Line)]);
    let late = chained(&[([5, 3, 0], Curve::Line), ([5, 3, -4], Curve::Line)]);
    let options = "--two-level --accelerate --servo-gain 30";
    // It ends where it began.
    let direction = Direction::Ccw;
    let circle = chained(&[([0; 3], Curve::Arc { plane: Plane::Yz, centre: [9, 0], direction })]);
    let space = "line,cycle,dx,dy,dz,x,y,z";
    for (motions, header, has_z) in
        [(plane, "line,cycle,dx,dy,x,y", false), (late, space, true), (circle, space, true)]
    {
        let folder = tempfile::tempdir().unwrap();
        let written = run_in(folder.path(), &motions, options).unwrap();
        assert_eq!(written.header, header);
        let report = written.report;
        for part in [&report["totals"]["pulses"], &report["final_position"]] {
            assert_eq!(part.get("z").is_some(), has_z, "{part}");
        }
        let wave = fs::read_to_string(folder.path().join("out/waves.vcd")).unwrap();
        for signal in [" pulse_z ", " position_z ", " error_z ", " plane "] {
            assert_eq!(wave.contains(signal), has_z, "{signal}");
        }
        // No line moves all three.
        assert!(wave.contains(" dda_line ") && !wave.contains("dda_line_xyz"));
    }
}

/// Lines of any axes, and quarters and full turns in any plane, which end on their circle.
fn any_program() -> impl Strategy<Value = Vec<Motion>> {
    let step = ([-40..=40, -40..=40, -40..=40], 0..6_u8, any::<bool>());
    prop::collection::vec(step, 1..6).prop_map(|steps| {
        let mut at = [0; 3];
        let mut curves = Vec::new();
        for (way, kind, is_ccw) in steps {
            let plane = [Plane::Xy, Plane::Zx, Plane::Yz][usize::from(kind % 3)];
            let [first, second, _] = plane.axes();
            let radius: [i32; 2] = [way[first], way[second]];
            let direction = if is_ccw { Direction::Ccw } else { Direction::Cw };
            let curve = if kind < 3 || radius == [0, 0] {
                at = [0, 1, 2].map(|axis| at[axis] + way[axis]);
                Curve::Line
            } else {
                let centre = [at[first] - radius[0], at[second] - radius[1]].map(i64::from);
                // A quarter counter-clockwise from there, and clockwise three of them; or all four.
                if way[0] % 2 == 0 {
                    at[first] += -radius[1] - radius[0];
                    at[second] += radius[0] - radius[1];
                }
                Curve::Arc { plane, centre, direction }
            };
            curves.push((at, curve));
        }
        let mut motions = chained(&curves);
        motions.retain(|motion| motion.curve != Curve::Line || motion.from != motion.to);
        // Z moves at last.
        let last = motions.last().map_or([0; 3], |motion| motion.to);
        let to = [last[0], last[1], last[2] + 1];
        motions.push(Motion { line: 99, from: last, to, curve: Curve::Line, rate: feed() });
        motions
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(24) })]

    #[test]
    fn any_program_ends_where_it_should(motions in any_program()) {
        for options in [
            "--method dda", "--method min-deviation", "--two-level --accelerate", "--two-level",
        ] {
            let written = run_motions(&motions, &format!("{options} --no-waves")).unwrap();
            assert_made(&motions, &written);
        }
    }
}
