//! `onepulse wave`: the hardware model's wave of one curve.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use assert_cmd::cargo::cargo_bin_cmd;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Output;
use tempfile::TempDir;

/// `onepulse wave` in a folder, with these arguments separated by blanks.
fn wave(folder: &Path, arguments: &str) -> Output {
    let mut command = cargo_bin_cmd!("onepulse");
    command.current_dir(folder).arg("wave").args(arguments.split_whitespace()).output().unwrap()
}

fn check_written(folder: &Path, arguments: &str) {
    let output = wave(folder, arguments);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments}: {errors}");
}

/// Fails with this exit status and these words, and leaves nothing behind in the folder.
fn check_refused(arguments: &str, status: i32, words: &str) {
    let folder = TempDir::new().unwrap();
    let output = wave(folder.path(), arguments);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(status), "{arguments}: {errors}");
    assert_eq!(output.stdout, b"", "{arguments}");
    assert!(errors.contains(words), "{arguments}: '{words}' is missing in: {errors}");
    assert_eq!(names(folder.path()), [""; 0], "{arguments}");
}

/// What lies in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<_> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Every signal's changes by its full name: (time, value as text).
type Changes = BTreeMap<String, Vec<(u64, String)>>;

fn read(path: &Path) -> Changes {
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
    signals.into_iter().map(|(name, signal)| (name, changes(signal))).collect()
}

fn value_at<'a>(changes: &'a Changes, name: &str, time: u64) -> &'a str {
    let so_far = changes[name].iter().take_while(|(at, _)| *at <= time);
    &so_far.last().unwrap_or_else(|| panic!("{name} has no value at {time}")).1
}

/// The clock periods in which an axis has a pulse: each rising edge of the clock begins one.
fn pulses(changes: &Changes, axis: char) -> usize {
    let rises = changes["onepulse.clk"].iter().filter(|(_, value)| value == "1");
    let pulse = format!("onepulse.pulse_{axis}");
    rises.filter(|(at, _)| value_at(changes, &pulse, *at) == "1").count()
}

/// The position counter of an axis at the end.
fn position(changes: &Changes, axis: char) -> i64 {
    let name = format!("onepulse.position_{axis}");
    let (_, value) = changes[&name].last().unwrap();
    let number = i64::from_str_radix(value, 2).unwrap();
    let is_negative = value.len() == 34 && value.starts_with('1');
    if is_negative { number - (1 << 34) } else { number }
}

/// A curve, the circuit that makes it, its pulses in x and in y, and where it ends.
type Case = (&'static str, &'static str, [usize; 2], [i64; 2]);

const CASES: [Case; 16] = [
    ("line --to 5,3", "ppc_line", [5, 3], [5, 3]),
    ("line --to -50,31", "ppc_line", [50, 31], [-50, 31]),
    ("line --to 3,3 --end-rule larger", "ppc_line", [3, 2], [3, 2]),
    ("arc --from 5,0 --to 0,5 --ccw", "ppc_arc", [5, 5], [0, 5]),
    ("arc --from 5,0 --to 5,0 --cw", "ppc_arc", [20, 20], [5, 0]),
    ("line --to 4,-6 --method dda --bits 3", "dda_line", [4, 6], [4, -6]),
    ("line --to 100,255 --method dda --normalize --bits 12", "dda_line", [100, 255], [100, 255]),
    ("arc --from 5,0 --to 0,5 --ccw --method dda", "dda_centred_arc", [5, 5], [0, 5]),
    ("arc --from 5,0 --to 0,5 --ccw --method dda --update simultaneous", "dda_arc", [5, 5], [0, 5]),
    ("line --to -10,-6 --method brm --bits 4", "brm_line", [10, 6], [-10, -6]),
    ("line --to 5,-3 --method min-deviation", "minimum_deviation_line", [5, 3], [5, -3]),
    (
        "arc --from 5,0 --to 0,5 --ccw --method min-deviation",
        "minimum_deviation_arc",
        [5, 5],
        [0, 5],
    ),
    ("line --to 3,-1 --method compare-integral", "comparison_line", [3, 1], [3, -1]),
    ("arc --from 5,0 --to 5,0 --cw --method compare-integral", "comparison_arc", [20, 20], [5, 0]),
    ("parabola --p 2 --to 4,4", "parabola_ppc", [4, 4], [4, 4]),
    ("parabola --axis y --p -3 --to 7,-9 --bits 6", "parabola_ppc", [7, 9], [7, -9]),
];

#[test]
fn waves_show_the_circuit_and_every_pulse() {
    for (arguments, circuit, [x, y], end) in CASES {
        for extension in ["vcd", "fst"] {
            let folder = TempDir::new().unwrap();
            let file = format!("curve.{extension}");
            check_written(folder.path(), &format!("{arguments} -o {file}"));
            assert_eq!(
                names(folder.path()),
                sorted(["curve.gtkw", "curve.sucl", &file]),
                "{arguments}"
            );

            let changes = read(&folder.path().join(&file));
            let scope = format!("onepulse.{circuit}.");
            let inside = changes.keys().filter(|name| name.starts_with(&scope)).count();
            assert!(inside > 0, "{arguments} {extension}: nothing in {scope}");
            let outside = changes.keys().filter(|name| name.matches('.').count() == 2);
            assert_eq!(outside.count(), inside, "{arguments} {extension}");
            assert_eq!([pulses(&changes, 'x'), pulses(&changes, 'y')], [x, y], "{arguments}");
            let position = [position(&changes, 'x'), position(&changes, 'y')];
            assert_eq!(position, end, "{arguments} {extension}");
        }
    }
}

fn sorted<const N: usize>(names: [&str; N]) -> [&str; N] {
    let mut names = names;
    names.sort_unstable();
    names
}

#[test]
fn vcd_and_fst_say_the_same() {
    let folder = TempDir::new().unwrap();
    for (arguments, ..) in CASES {
        check_written(folder.path(), &format!("{arguments} -o a.vcd"));
        check_written(folder.path(), &format!("{arguments} -o b.fst"));
        let [vcd, fst] = ["a.vcd", "b.fst"].map(|name| read(&folder.path().join(name)));
        assert_eq!(vcd.keys().collect::<Vec<_>>(), fst.keys().collect::<Vec<_>>(), "{arguments}");
        for signal in ["clk", "pulse_x", "pulse_y", "negative_y", "position_x", "position_y"] {
            let signal = format!("onepulse.{signal}");
            assert_eq!(vcd[&signal], fst[&signal], "{arguments} {signal}");
        }
    }
}

#[test]
fn the_layout_names_the_wave_and_its_signals() {
    for (arguments, circuit, ..) in CASES {
        for file in ["curve.vcd", "curve.fst"] {
            let folder = TempDir::new().unwrap();
            check_written(folder.path(), &format!("{arguments} -o {file}"));
            let changes = read(&folder.path().join(file));
            let layout = fs::read_to_string(folder.path().join("curve.gtkw")).unwrap();
            assert!(layout.contains(&format!("[dumpfile] \"{file}\"\n")), "{layout}");
            assert!(layout.contains(&format!("\n-{circuit}\n")), "{layout}");
            let shown: Vec<_> = layout
                .lines()
                .filter(|line| line.starts_with("onepulse."))
                .map(|line| line.split('[').next().unwrap())
                .collect();
            assert_eq!(shown.len(), changes.len(), "{arguments}: every signal is laid out");
            for name in shown {
                assert!(changes.contains_key(name), "{arguments}: {name} is not in {file}");
            }
        }
    }
}

/// What the file for Surfer adds, in the order of its rows, each with the commands that change it.
///
/// The commands, their parameters and how a row is named are those of Surfer's `command_parser.rs`
/// and `util.rs`; a new row is put below the one that has the focus.
fn surfer_rows(text: &str) -> Vec<(String, Vec<String>)> {
    let mut rows: Vec<(String, Vec<String>)> = Vec::new();
    let mut focus = None;
    for line in text.lines() {
        assert!(!line.contains(['#', ';']), "a comment or two commands: {line}");
        match *line.split(' ').collect::<Vec<_>>() {
            [command @ ("divider_add" | "variable_add"), name] => {
                let is_word = name.chars().all(|c| c.is_alphanumeric() || c == '_');
                assert!(command == "variable_add" || is_word, "{line}");
                let row = focus.map_or(rows.len(), |focus| focus + 1);
                rows.insert(row, (name.to_owned(), vec![]));
            }
            ["item_focus", row] => {
                let digit = |c: char| (c as usize).checked_sub('a' as usize).filter(|d| *d < 16);
                let number = row.chars().try_fold(0, |n, c| Some(16 * n + digit(c)?)).unwrap();
                assert!(number < rows.len(), "{line}");
                focus = Some(number);
            }
            ["item_set_format", "Unsigned" | "Signed" | "String" | "ASCII"]
            | ["item_set_analog", "step"] => rows[focus.unwrap()].1.push(line.to_owned()),
            ["item_set_height", height] => {
                assert!(height.parse::<f32>().unwrap() > 0.0);
                rows[focus.unwrap()].1.push(line.to_owned());
            }
            ["item_unfocus"] => focus = None,
            ["zoom_fit"] => {}
            _ => panic!("not a command of Surfer: {line}"),
        }
    }
    rows
}

#[test]
fn the_commands_for_surfer_lay_out_the_same() {
    for (arguments, circuit, ..) in CASES {
        for file in ["curve.vcd", "curve.fst"] {
            let folder = TempDir::new().unwrap();
            check_written(folder.path(), &format!("{arguments} -o {file}"));
            let changes = read(&folder.path().join(file));
            let read = |name| fs::read_to_string(folder.path().join(name)).unwrap();
            let rows = surfer_rows(&read("curve.sucl"));

            // Headings and signals, in the order of the layout for GTKWave.
            let layout = read("curve.gtkw");
            let shown: Vec<_> = layout
                .lines()
                .filter_map(|line| match line.strip_prefix('-') {
                    Some(heading) => Some(heading).filter(|heading| !heading.is_empty()),
                    None => line.starts_with("onepulse.").then(|| line.split('[').next().unwrap()),
                })
                .collect();
            let names: Vec<_> = rows.iter().map(|(name, _)| name.as_str()).collect();
            assert_eq!(names, shown, "{arguments} {file}");
            assert_eq!(names[..2], ["onepulse", "onepulse.clk"]);
            assert!(names.contains(&circuit));

            for (name, commands) in &rows {
                let is_word = [".beat", ".rule", ".quadrant"].iter().any(|end| name.ends_with(end));
                let is_number = changes.get(name).is_some_and(|c| c[0].1.len() > 1);
                match commands.as_slice() {
                    [] => assert!(!is_word && !is_number, "{arguments} {name}"),
                    [format] => {
                        let words = if file.ends_with("fst") { "ASCII" } else { "String" };
                        assert_eq!(
                            *format == format!("item_set_format {words}"),
                            is_word,
                            "{name}"
                        );
                        let is_signed = format == "item_set_format Signed";
                        assert!(is_signed || !name.contains(".position_"), "{name}");
                    }
                    [_, height, analog] => {
                        assert_eq!([height, analog], ["item_set_height 3", "item_set_analog step"]);
                        assert!(name.contains(".jr"), "{arguments} {name}");
                    }
                    _ => panic!("{arguments} {name}: {commands:?}"),
                }
            }
        }
    }
}

#[test]
fn lines_of_four_axes_show_them_all() {
    let folder = TempDir::new().unwrap();
    for method in ["dda", "brm"] {
        check_written(folder.path(), &format!("line --to 5,-3,7,-1 --method {method} -o a.fst"));
        let changes = read(&folder.path().join("a.fst"));
        for (axis, end) in [('x', 5), ('y', -3), ('z', 7), ('a', -1)] {
            assert_eq!(pulses(&changes, axis), i64::unsigned_abs(end) as usize, "{method} {axis}");
            assert_eq!(position(&changes, axis), end, "{method} {axis}");
        }
    }
}

#[test]
fn arcs_start_where_they_start() {
    let folder = TempDir::new().unwrap();
    check_written(folder.path(), "arc --from -4,3 --to -4,3 --cw --method dda -o a.vcd");
    let changes = read(&folder.path().join("a.vcd"));
    let first = |name: &str| i64::from_str_radix(value_at(&changes, name, 0), 2).unwrap();
    assert_eq!(first("onepulse.position_x"), (1 << 34) - 4);
    assert_eq!(first("onepulse.position_y"), 3);
    assert_eq!([position(&changes, 'x'), position(&changes, 'y')], [-4, 3]);
}

#[test]
fn the_pulse_source_sets_the_time_axis() {
    // Eight accumulations at 1 kHz are 8 ms.
    let folder = TempDir::new().unwrap();
    check_written(folder.path(), "line --to 4,6 --method dda --source-hz 1000 -o a.vcd");
    let wave = wellen::simple::read(folder.path().join("a.vcd")).unwrap();
    let scale = wave.hierarchy().timescale().unwrap();
    let exponent = i32::from(scale.unit.to_exponent().unwrap());
    let unit = f64::from(scale.factor) * 10_f64.powi(exponent);
    let changes = read(&folder.path().join("a.vcd"));
    let (last, _) = changes["onepulse.dda_line.je"].last().unwrap();
    assert!((*last as f64 * unit - 8e-3).abs() < 1e-9, "{last} of {unit} s");
}

#[test]
fn an_older_wave_is_replaced() {
    let folder = TempDir::new().unwrap();
    check_written(folder.path(), "line --to 50,30 -o a.vcd");
    check_written(folder.path(), "line --to 5,3 -o a.vcd");
    assert_eq!(pulses(&read(&folder.path().join("a.vcd")), 'x'), 5);
    assert_eq!(names(folder.path()), ["a.gtkw", "a.sucl", "a.vcd"]);
}

#[test]
fn methods_without_a_circuit_are_refused_and_told_which_have_one() {
    for curve in ["line --to 5,3", "arc --from 5,0 --to 0,5 --ccw"] {
        for whole in ["", "--interpolator"] {
            let what = if whole.is_empty() { "circuit" } else { "engine" };
            let words = format!("has no {what} for this: it has them for --method ppc");
            check_refused(&format!("{curve} --method vector {whole} -o w.vcd"), 2, &words);
        }
        for method in ["min-deviation", "compare-integral"] {
            let arguments = format!("{curve} --method {method} --interpolator -o w.vcd");
            check_refused(&arguments, 2, "has no engine for this");
        }
    }
}

#[test]
fn curves_without_a_circuit_are_refused() {
    for curve in [
        "line --to 5,3,2",
        "line --to 5,3 --method brm --smooth 1",
        "parabola --p 2 --to 4,4 --method dda",
        "parabola --p 2 --to 4,4 --method min-deviation",
        "helix --from 5,0 --to 0,5 --rise 3 --cw",
    ] {
        check_refused(&format!("{curve} -o w.vcd"), 2, "has no circuit for this");
    }
}

#[test]
fn other_endings_are_refused() {
    for file in ["a.txt", "a", "a.gtkw", "a.VCD", "vcd", ".vcd", "a.vcd.gz"] {
        check_refused(&format!("line --to 5,3 -o {file}"), 2, ".vcd or .fst");
    }
    check_refused("line --to 5,3", 2, "-o FILE");
}

#[test]
fn a_folder_that_cannot_be_written_is_at_fault() {
    check_refused("line --to 5,3 -o missing/a.vcd", 1, "missing/a.vcd");
    check_refused("line --to 5,3 -o /dev/null/a.fst", 1, "/dev/null/a.fst");
}

#[test]
fn nothing_is_written_where_a_folder_is_in_the_way() {
    for in_the_way in ["a.vcd", "a.gtkw", "a.sucl"] {
        let folder = TempDir::new().unwrap();
        fs::create_dir(folder.path().join(in_the_way)).unwrap();
        let output = wave(folder.path(), "line --to 5,3 -o a.vcd");
        assert_eq!(output.status.code(), Some(1), "{in_the_way}");
        assert!(String::from_utf8(output.stderr).unwrap().contains(in_the_way));
        assert_eq!(names(folder.path()), [in_the_way]);
    }
}

#[test]
fn wrong_command_lines_are_refused_and_write_nothing() {
    for (arguments, words) in [
        ("line --to 5,3 -o a.vcd --normalize", "--normalize"),
        ("line --to 5,3 -o a.vcd --bits 2", "needs 3"),
        ("line --to 8,6 -o a.vcd --method dda --radix 10", "--radix"),
        ("arc --from 5,0 --to 0,5 --ccw --method brm -o a.vcd", "--method"),
        ("arc --from 5,0 --to 0,5 --ccw --method dda --preset zero -o a.vcd", "--preset"),
        ("arc --from 0,0 --to 0,5 --ccw -o a.vcd", "starts in its centre"),
        ("line --to 5,3 -o a.vcd --source-hz 0", "--source-hz"),
        ("line --to 5,3 -o a.vcd --source-hz 99999999999999", "--source-hz"),
        ("line --to 5,3 -o a.vcd --source-hz x", "--source-hz"),
        ("line --to 5,y -o a.vcd", "--to"),
    ] {
        check_refused(arguments, 2, words);
    }
}

#[test]
fn a_window_shows_the_same_clocks_as_the_whole() {
    let folder = TempDir::new().unwrap();
    let curve = "arc --from 13,0 --to 13,0 --ccw --method dda";
    check_written(folder.path(), &format!("{curve} -o whole.vcd"));
    check_written(folder.path(), &format!("{curve} --from-clock 40 --clocks 25 -o part.vcd"));
    let whole = read(&folder.path().join("whole.vcd"));
    let part = read(&folder.path().join("part.vcd"));
    let rises: Vec<_> =
        part["onepulse.clk"].iter().filter(|(_, value)| value == "1").map(|(at, _)| *at).collect();
    // Four clocks a cycle of 1 MHz, on an axis of 1 ns; the edge that ends the last clock is shown too.
    assert_eq!(rises, (40..=65).map(|clock| 250 * clock).collect::<Vec<_>>());
    for name in whole.keys() {
        for rise in &rises {
            assert_eq!(value_at(&part, name, *rise), value_at(&whole, name, *rise), "{name}");
        }
    }
}

/// The pulses of a curve by the software: for each axis their directions, in their order.
fn software(curve: &str) -> Vec<Vec<i64>> {
    let mut command = cargo_bin_cmd!("onepulse");
    let output = command.arg("pulses").args(curve.split_whitespace()).output().unwrap();
    assert!(output.status.success(), "{curve}");
    let text = String::from_utf8(output.stdout).unwrap();
    let axes = (text.lines().next().unwrap().split(',').count() - 1) / 2;
    let mut pulses = vec![vec![]; axes];
    for line in text.lines().skip(1) {
        let fields = line.split(',').skip(1).take(axes).map(|field| field.parse::<i64>().unwrap());
        for (axis, pulse) in fields.enumerate().filter(|(_, pulse)| *pulse != 0) {
            pulses[axis].push(pulse);
        }
    }
    pulses
}

/// When the clock rises.
fn rises(changes: &Changes) -> Vec<u64> {
    let rises = changes["onepulse.clk"].iter().filter(|(_, value)| value == "1");
    rises.map(|(at, _)| *at).collect()
}

/// The directions of an axis' steps, as a drive takes them at each rise.
fn steps(changes: &Changes, axis: char) -> Vec<i64> {
    let [step, dir] = ["step", "dir"].map(|name| format!("onepulse.{name}_{axis}"));
    let rises = changes[&step].iter().filter(|(_, value)| value == "1");
    rises.map(|(at, _)| if value_at(changes, &dir, *at) == "1" { -1 } else { 1 }).collect()
}

/// Curves, and their engines in the whole interpolator.
const WHOLE: [(&str, &str); 10] = [
    ("line --to 5,-3", "ppc_line"),
    ("line --to 0,0", "ppc_line"),
    ("line --to 100,37 --method dda --preset half --normalize", "dda_line"),
    ("line --to 5,-3,7 --method dda --bits 5", "dda_line"),
    ("line --to 5,-3,7,-1 --method brm", "brm_line"),
    ("arc --from 5,0 --to 5,0 --cw --end-rule per-axis", "ppc_arc"),
    ("arc --from 1,0 --to 0,1 --ccw --method dda", "dda_centred_arc"),
    ("arc --from -24,7 --to -7,-24 --ccw --method dda --normalize", "dda_centred_arc"),
    ("arc --from 5,0 --to 0,5 --ccw --method dda --update simultaneous", "dda_arc"),
    ("arc --from 3,4 --to 3,4 --cw --method dda --update simultaneous --preset full", "dda_arc"),
];

#[test]
fn the_whole_interpolator_makes_every_step() {
    for (arguments, engine) in WHOLE {
        let folder = TempDir::new().unwrap();
        let has_rule = !engine.starts_with("ppc") || arguments.contains("--end-rule");
        let rule = if has_rule { "" } else { "--end-rule per-axis" };
        let pulses = software(&format!("{arguments} {rule}"));
        for file in ["curve.vcd", "curve.fst"] {
            check_written(folder.path(), &format!("{arguments} --interpolator -o {file}"));
            let changes = read(&folder.path().join(file));
            for (pulses, axis) in pulses.iter().zip(['x', 'y', 'z', 'a']) {
                assert_eq!(steps(&changes, axis), *pulses, "{arguments} {axis}");
                let [port, inside] = ["", "interpolator."]
                    .map(|scope| &changes[&format!("onepulse.{scope}step_{axis}")]);
                assert_eq!(port, inside, "{arguments} {axis}");
            }
            // It goes on for some clocks of 1/8 µs when all is done.
            let (at, done) = changes["onepulse.interpolator.done"].last().unwrap();
            assert!(done == "1" && at + 8 * 125 <= *rises(&changes).last().unwrap());
        }
        assert_eq!(names(folder.path()), ["curve.fst", "curve.gtkw", "curve.sucl", "curve.vcd"]);
    }
}

#[test]
fn the_layouts_show_the_engine_that_runs() {
    for (arguments, engine) in WHOLE {
        let folder = TempDir::new().unwrap();
        check_written(folder.path(), &format!("{arguments} --interpolator -o curve.vcd"));
        let changes = read(&folder.path().join("curve.vcd"));
        let read = |name| fs::read_to_string(folder.path().join(name)).unwrap();
        let rows: Vec<_> = surfer_rows(&read("curve.sucl")).into_iter().map(|row| row.0).collect();
        let (signals, scopes): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row.contains('.'));
        let parts = ["onepulse", "interpolator", "decoder", engine, "interpolator", "decoder"];
        assert_eq!(scopes, parts, "{arguments}");
        // All of these scopes, each signal once.
        let is_shown = |name: &&String| {
            !WHOLE.iter().any(|(_, other)| *other != engine && name.contains(&format!(".{other}.")))
        };
        let mut once = signals.clone();
        once.sort_unstable();
        assert_eq!(once, changes.keys().filter(is_shown).collect::<Vec<_>>(), "{arguments}");
        let layout = read("curve.gtkw");
        for name in signals {
            assert!(changes.contains_key(name), "{arguments}: {name} is not in the wave");
            assert!(layout.contains(&format!("\n{name}")), "{arguments}: {name} is not shown");
        }
        for standing in WHOLE.map(|(_, engine)| engine) {
            let scope = format!("onepulse.{standing}.");
            assert!(changes.keys().any(|name| name.starts_with(&scope)), "{scope}");
            assert_eq!(layout.contains(&scope), standing == engine, "{arguments}: {scope}");
        }
    }
}

#[test]
fn the_period_and_the_times_of_the_drives_are_kept() {
    let folder = TempDir::new().unwrap();
    let line = "line --to 7,-7 --method dda --bits 3 --interpolator";
    let times = "--source-hz 1000 --period 50 --step-clocks 10,7,4,3";
    check_written(folder.path(), &format!("{line} {times} -o a.vcd"));
    let changes = read(&folder.path().join("a.vcd"));
    // A cycle is 1 ms, a clock 20 µs on an axis of 10 µs.
    assert!(rises(&changes).windows(2).all(|pair| pair[1] - pair[0] == 2));
    for axis in ['x', 'y'] {
        let edges = &changes[&format!("onepulse.step_{axis}")][1..];
        let steps: Vec<_> = edges.chunks(2).map(|edges| [edges[0].0, edges[1].0]).collect();
        assert_eq!(steps.len(), 7);
        assert!(steps.iter().all(|[rise, fall]| fall - rise == 2 * 10), "length: {steps:?}");
        // The first one waits for its direction.
        let mut periods = steps[1..].windows(2).map(|pair| pair[1][0] - pair[0][0]);
        assert!(periods.all(|period| period == 2 * 50), "period: {steps:?}");
    }
    let (turned, _) = changes["onepulse.dir_y"][1];
    let (stepped, _) = changes["onepulse.step_y"][1];
    assert_eq!(stepped - turned, 2 * 4, "setup");

    // The command comes, is taken, and decoded.
    let values =
        |name: &str| -> Vec<_> { changes[name].iter().map(|(_, value)| value.as_str()).collect() };
    assert_eq!(values("onepulse.valid"), ["0", "1", "0"]);
    let states = ["IDLE", "MAGNITUDE", "CHECK", "SHIFT", "FINISH", "PUT", "IDLE"];
    assert_eq!(values("onepulse.decoder.state"), states);

    // Slow drives make the source wait: nothing is lost.
    check_written(folder.path(), &format!("{line} --step-clocks 100,100,9,9 -o b.fst"));
    let changes = read(&folder.path().join("b.fst"));
    assert_eq!([steps(&changes, 'x'), steps(&changes, 'y')], [vec![1; 7], vec![-1; 7]]);
}

#[test]
fn a_window_of_the_interpolator_shows_the_same_clocks_as_the_whole() {
    let folder = TempDir::new().unwrap();
    let curve = "arc --from 13,0 --to 13,0 --ccw --method dda --interpolator";
    for extension in ["vcd", "fst"] {
        check_written(folder.path(), &format!("{curve} -o whole.{extension}"));
        let window = format!("--from-clock 90 --clocks 70 -o part.{extension}");
        check_written(folder.path(), &format!("{curve} {window}"));
        let [whole, part] =
            ["whole", "part"].map(|name| read(&folder.path().join(format!("{name}.{extension}"))));
        // The edge that ends the last clock is shown too.
        let shown = rises(&part);
        assert_eq!(shown, rises(&whole)[90..=160]);
        for name in whole.keys() {
            for rise in &shown {
                assert_eq!(value_at(&part, name, *rise), value_at(&whole, name, *rise), "{name}");
            }
        }
    }
}

#[test]
fn what_the_interpolator_does_not_do_is_refused() {
    for (arguments, words) in [
        ("line --to 5,3 --end-rule total", "--end-rule"),
        ("arc --from 5,0 --to 0,5 --ccw --end-rule larger", "--end-rule"),
        ("line --to 5,3 --method dda --radix 10", "--radix"),
        ("line --to 5,3 --preset half", "--preset"),
        ("line --to 5,3 --method brm --preset half", "--preset"),
        ("arc --from 5,0 --to 0,5 --ccw --method dda --preset full", "--preset"),
        ("arc --from 5,0 --to 0,5 --ccw --method brm", "--method"),
        ("line --to 5,3,1", "of an axis that the curve lacks"),
        ("line --to 5,3 --period 5", "at least 6 clocks"),
        ("line --to 5,3 --period 0", "--period"),
        ("line --to 5,3 --period 16777216", "--period"),
        ("line --to 5,3 --step-clocks 2,2,2", "--step-clocks"),
        ("line --to 5,3 --step-clocks 2,2,2,0", "--step-clocks"),
        ("line --to 5,3 --step-clocks 2,2,2,65536", "--step-clocks"),
        ("line --to 5,3 --bits 2", "needs 3"),
        ("line --to 1,1 --bits 1", "needs 2"),
        ("line --to 5,3 --bits 33", "1 to 32"),
        ("arc --from 5,0 --to 0,5 --ccw --method dda --bits 3", "do not hold the circle"),
        ("arc --from 0,0 --to 0,5 --ccw", "centre"),
        ("arc --from 5,0 --to 0,0 --ccw --method dda", "centre"),
        ("line --to 5,3 --source-hz 0", "--source-hz"),
        ("line --to 5,3 --source-hz 20000000000", "--source-hz"),
    ] {
        check_refused(&format!("{arguments} --interpolator -o a.vcd"), 2, words);
    }
    check_refused("line --to 5,3 --period 9 -o a.vcd", 2, "--interpolator");
    check_refused("line --to 5,3 --step-clocks 2,2,2,2 -o a.vcd", 2, "--interpolator");
    check_refused("line --to 5,3 --interpolator -o a.txt", 2, ".vcd or .fst");
    check_refused("line --to 5,3 --interpolator -o missing/a.vcd", 1, "missing/a.vcd");
}
