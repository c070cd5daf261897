//! `onepulse table`: the step table of one curve.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use assert_cmd::cargo::{cargo_bin, cargo_bin_cmd};
use std::io::{BufRead, BufReader, Read};
use std::process::{Command, Output, Stdio};

fn run(arguments: &str) -> Output {
    cargo_bin_cmd!("onepulse").arg("table").args(arguments.split_whitespace()).output().unwrap()
}

fn table(arguments: &str) -> String {
    let output = run(arguments);
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments}: {errors}");
    String::from_utf8(output.stdout).unwrap()
}

/// The cells of a table in CSV, headings first.
fn cells(arguments: &str) -> Vec<Vec<String>> {
    let text = table(&format!("{arguments} --format csv"));
    text.lines().map(csv_cells).collect()
}

fn csv_cells(line: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut is_quoted = false;
    for c in line.chars() {
        match c {
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => cells.push(String::new()),
            _ => cells.last_mut().unwrap().push(c),
        }
    }
    cells
}

/// The column under a heading.
fn column(cells: &[Vec<String>], heading: &str) -> Vec<String> {
    let place = cells[0].iter().position(|cell| cell == heading);
    let place = place.unwrap_or_else(|| panic!("no column {heading} in {:?}", cells[0]));
    cells[1..].iter().map(|row| row[place].clone()).collect()
}

/// The values of F in the update column: what stands behind the last sign of equality there.
fn deviation_functions(cells: &[Vec<String>]) -> Vec<i64> {
    let value = |cell: String| {
        let formula = cell.split(',').next().unwrap().to_owned();
        formula.rsplit("= ").next().unwrap().parse().unwrap()
    };
    column(cells, "update").into_iter().map(value).collect()
}

const FORMATS: [&str; 3] = ["text", "md", "csv"];

/// A curve of every kind of table, and words of its headings in both languages.
const CURVES: [(&str, [&str; 2]); 17] = [
    ("line --to 5,3", ["judge", "偏差判别"]),
    ("arc --from 5,0 --to 0,5 --ccw", ["feed", "坐标进给"]),
    ("line --to 4,6,-5,1 --method dda", ["remainder", "余数"]),
    ("arc --from 5,0 --to 0,5 --cw --method dda", ["integrand", "被积函数"]),
    (
        "arc --from 5,0 --to 0,5 --cw --method dda --update simultaneous",
        ["end counter", "终点计数器"],
    ),
    ("line --to 10,6 --method brm", ["stage of weight", "通过级的权"]),
    ("line --to 5,-3,2", ["judge", "偏差判别"]),
    ("line --to 5,3 --method min-deviation", ["judge", "偏差判别"]),
    ("line --to 5,3,-2,1 --method min-deviation", ["feed", "坐标进给"]),
    ("line --to -5,3 --method vector", ["update", "偏差计算"]),
    ("line --to 3,-5 --method compare-integral", ["end counter", "终点计数器"]),
    ("arc --from 5,0 --to -4,3 --ccw --method min-deviation", ["judge", "偏差判别"]),
    ("arc --from 5,0 --to 0,5 --cw --method vector", ["judge", "偏差判别"]),
    ("arc --from 5,0 --to 5,0 --cw --method compare-integral", ["judge", "偏差判别"]),
    ("parabola --p 2 --to 4,4", ["judge", "偏差判别"]),
    ("parabola --p -2 --to 4,-4 --axis y --method min-deviation", ["judge", "偏差判别"]),
    ("parabola --p 2 --to 4,-4 --method dda", ["integrand", "被积函数"]),
];

#[test]
fn the_four_beats_of_a_line_as_text() {
    assert_eq!(
        table("line --to 2,-1"),
        "\
step   judge        feed  update                        compare
-----  -----------  ----  ----------------------------  -------------
start                     F0 = 0                        E = 3
1      F0 = 0       +Δx   F1 = F0 - |y_e| = 0 - 1 = -1  E = 3 - 1 = 2
2      F1 = -1 < 0  -Δy   F2 = F1 + |x_e| = -1 + 2 = 1  E = 2 - 1 = 1
3      F2 = 1 > 0   +Δx   F3 = F2 - |y_e| = 1 - 1 = 0   E = 1 - 1 = 0
"
    );
}

#[test]
fn the_four_beats_of_a_line_in_markdown() {
    assert_eq!(
        table("line --to 1,1 --format md --lang zh"),
        "\
| 序号 | 偏差判别 | 坐标进给 | 偏差计算 | 终点比较 |
|---|---|---|---|---|
| 起点 |  |  | F0 = 0 | E = 2 |
| 1 | F0 = 0 | +Δx | F1 = F0 - \\|y_e\\| = 0 - 1 = -1 | E = 2 - 1 = 1 |
| 2 | F1 = -1 < 0 | +Δy | F2 = F1 + \\|x_e\\| = -1 + 1 = 0 | E = 1 - 1 = 0 |
"
    );
}

#[test]
fn the_textbook_lines_by_point_by_point_comparison() {
    let cells = cells("line --to 5,3");
    assert_eq!(deviation_functions(&cells), [0, -3, 2, -1, 4, 1, -2, 3, 0]);
    assert_eq!(
        column(&cells, "feed"),
        ["", "+Δx", "+Δy", "+Δx", "+Δy", "+Δx", "+Δx", "+Δy", "+Δx"]
    );
    assert_eq!(column(&cells, "compare").last().unwrap(), "E = 1 - 1 = 0");
}

#[test]
fn the_textbook_line_above_the_diagonal() {
    let cells = cells("line --to 3,5");
    assert_eq!(deviation_functions(&cells), [0, -5, -2, 1, -4, -1, 2, -3, 0]);
}

#[test]
fn the_textbook_arc_by_point_by_point_comparison() {
    let cells = cells("arc --from 5,0 --to 0,5 --ccw");
    assert_eq!(deviation_functions(&cells), [0, -9, -8, -5, 0, -7, 0, -5, 4, 1, 0]);
    let feeds = ["", "-Δx", "+Δy", "+Δy", "+Δy", "-Δx", "+Δy", "-Δx", "+Δy", "-Δx", "-Δx"];
    assert_eq!(column(&cells, "feed"), feeds);
    assert!(column(&cells, "update").last().unwrap().ends_with("x = 0, y = 5"));
}

#[test]
fn a_full_circle_passes_every_quadrant() {
    let cells = cells("arc --from 5,0 --to 5,0 --cw");
    assert_eq!(cells.len(), 1 + 1 + 40);
    assert_eq!(*deviation_functions(&cells).last().unwrap(), 0);
    for feed in ["+Δx", "-Δx", "+Δy", "-Δy"] {
        let count = column(&cells, "feed").iter().filter(|cell| *cell == feed).count();
        assert_eq!(count, 10, "{feed}");
    }
}

#[test]
fn a_line_along_y_says_why_f_does_not_decide() {
    let cells = cells("line --to 0,2");
    assert_eq!(column(&cells, "feed"), ["", "+Δy", "+Δy"]);
    assert_eq!(column(&cells, "judge"), ["", "F0 = 0, x stands", "F1 = 0, x stands"]);
}

#[test]
fn the_textbook_line_in_decimal_registers() {
    let cells = cells("line --to 8,6 --method dda --radix 10");
    let x = ["0", "8", "6", "4", "2", "0", "8", "6", "4", "2", "0"];
    let y = ["0", "6", "2", "8", "4", "0", "6", "2", "8", "4", "0"];
    assert_eq!(column(&cells, "remainder JRx"), x);
    assert_eq!(column(&cells, "remainder JRy"), y);
    assert_eq!(
        column(&cells, "overflow Δy"),
        ["", "", "+Δy", "", "+Δy", "+Δy", "", "+Δy", "", "+Δy", "+Δy"]
    );
    assert!(column(&cells, "integrand JVx").iter().all(|cell| cell == "8"));
    let counter = ["10", "9", "8", "7", "6", "5", "4", "3", "2", "1", "0"];
    assert_eq!(column(&cells, "end counter JE"), counter);
}

#[test]
fn the_textbook_line_in_binary_registers() {
    let cells = cells("line --to 4,6 --method dda --bits 3");
    assert_eq!(column(&cells, "remainder JRx"), ["0", "4", "0", "4", "0", "4", "0", "4", "0"]);
    assert_eq!(column(&cells, "remainder JRy"), ["0", "6", "4", "2", "0", "6", "4", "2", "0"]);
}

#[test]
fn an_arc_counts_both_axes_down() {
    let arc = "arc --from 5,0 --to 0,5 --ccw --method dda";
    for options in ["--update simultaneous", "--update staggered"] {
        let cells = cells(&format!("{arc} {options}"));
        for counter in ["end counter JEx", "end counter JEy"] {
            let column = column(&cells, counter);
            assert_eq!((column[0].as_str(), column.last().unwrap().as_str()), ("5", "0"));
        }
        let count = |heading: &str, pulse: &str| {
            column(&cells, heading).iter().filter(|cell| *cell == pulse).count()
        };
        assert_eq!([count("overflow Δx", "-Δx"), count("overflow Δy", "+Δy")], [5, 5]);
    }
}

#[test]
fn the_gated_stages_of_the_rate_multiplier() {
    let cells = cells("line --to 10,6 --method brm --bits 4");
    assert_eq!(
        column(&cells, "stage of weight"),
        ["8", "4", "8", "2", "8", "4", "8", "1", "8", "4", "8", "2", "8", "4", "8", "overflow"]
    );
    let clocks = |heading: &str| -> Vec<usize> {
        let column = column(&cells, heading);
        (1..=column.len()).filter(|clock| !column[clock - 1].is_empty()).collect()
    };
    assert_eq!(clocks("Δx"), [1, 3, 4, 5, 7, 9, 11, 12, 13, 15]);
    assert_eq!(clocks("Δy"), [2, 4, 6, 10, 12, 14]);
}

/// The trains are those of 20 and 12 in five stages, 20 = 16 + 4 and 12 = 8 + 4; of each the pulses that
/// find a 1 in the divider pass.
#[test]
fn the_dividers_behind_the_trains() {
    let rows = cells("line --to 10,6 --method brm --bits 4 --smooth 1");
    assert_eq!(
        rows[0][2..],
        ["train x (20)", "divider x", "Δx", "train y (12)", "divider y", "Δy"]
    );
    assert_eq!(rows[1], ["1", "16", "1", "0", "+Δx", "0", "1", ""]);
    assert_eq!(rows[2], ["2", "8", "0", "0", "", "1", "0", "+Δy"]);
    assert_eq!(rows[3], ["3", "16", "1", "1", "", "0", "0", ""]);
    assert_eq!(rows[4], ["4", "4", "1", "0", "+Δx", "1", "1", ""]);
    assert_eq!(rows.len(), 1 + 32);
    assert_eq!(rows[32][1], "overflow");
}

/// A quarter of ten steps, of which z takes three: the remainder runs modulo 10, from 5, by 3.
#[test]
fn a_helix_by_cycles() {
    let rows = cells("helix --from 5,0 --to 0,5 --ccw --rise 3");
    assert_eq!(column(&rows, "distributor's remainder JR").join(" "), "5 8 1 4 7 0 3 6 9 2 5");
    let f =
        [[5, 0], [4, 0], [4, 1], [4, 2], [4, 3], [3, 3], [3, 4], [2, 4], [2, 5], [1, 5], [0, 5]]
            .map(|[x, y]: [i32; 2]| (x * x + y * y - 25).to_string());
    assert_eq!(column(&rows, "deviation function F"), f);
    assert_eq!(column(&rows, "z").join(" "), "0 0 1 1 1 2 2 2 2 3 3");
    assert_eq!(rows[3], ["2", "1", "-8", "", "+Δy", "+Δz", "4", "1", "1", "8"]);
    let chinese = table("helix --from 5,0 --to 0,5 --ccw --rise 3 --lang zh");
    assert!(chinese.starts_with("序号  分配余数 JR  偏差 F  Δx"), "{chinese}");
}

#[test]
fn a_line_by_minimum_deviation_as_text() {
    assert_eq!(
        table("line --to 3,-2 --method min-deviation"),
        "\
step   judge                         feed     update           x  y   end counter Ex  end counter Ey
-----  ----------------------------  -------  ---------------  -  --  --------------  --------------
start                                         dy = 0           0  0   3               2
1      dy + 2|y_e| = 0 + 4 = 4 > 3   +Δx -Δy  dy = 4 - 6 = -2  1  -1  2               1
2      dy + 2|y_e| = -2 + 4 = 2 ≤ 3  +Δx      dy = 2           2  -1  1               1
3      dy + 2|y_e| = 2 + 4 = 6 > 3   +Δx -Δy  dy = 6 - 6 = 0   3  -2  0               0
"
    );
}

#[test]
fn an_arc_by_vectors_in_markdown() {
    assert_eq!(
        table("arc --from 2,0 --to 0,2 --ccw --method vector --format md --lang zh"),
        "\
| 序号 | 偏差判别 | 坐标进给 | 偏差计算 | x | y | 终点计数器 Ex | 终点计数器 Ey |
|---|---|---|---|---|---|---|---|
| 起点 |  |  | F0 = 0 | 2 | 0 | 2 | 2 |
| 1 | F0 = 0, \\|x\\| > \\|y\\| | -Δx +Δy | F1 = F0 - 2\\|x\\| + 1 + 2\\|y\\| + 1 = 0 - 4 + 1 + 0 + 1 = -2 | 1 | 1 | 1 | 1 |
| 2 | F1 = -2 < 0, \\|x\\| = \\|y\\| | -Δx +Δy | F2 = F1 - 2\\|x\\| + 1 + 2\\|y\\| + 1 = -2 - 2 + 1 + 2 + 1 = 0 | 0 | 2 | 0 | 0 |
"
    );
}

/// The deviations of the textbooks' line and arc by the other methods, worked by hand.
#[test]
fn the_deviations_of_the_methods_that_move_both_axes() {
    let found = |arguments: &str| {
        let cells = cells(arguments);
        let value = |cell: &String| cell.rsplit("= ").next().unwrap().parse::<i64>().unwrap();
        column(&cells, "update").iter().map(value).collect::<Vec<_>>()
    };
    assert_eq!(found("line --to 5,3 --method min-deviation"), [0, -4, 2, -2, 4, 0]);
    assert_eq!(found("line --to 5,3 --method vector"), [0, 2, -1, 1, -2, 0]);
    assert_eq!(found("line --to 5,3 --method compare-integral"), [-2, 4, -6, 0, -4, 2, -8, -2]);
    let arc = "arc --from 5,0 --to 0,5 --ccw --method";
    assert_eq!(found(&format!("{arc} min-deviation")), [0, 1, 4, 0, 0, 4, 1, 0]);
    assert_eq!(found(&format!("{arc} vector")), [0, -8, -5, 0, 0, -5, 1, 0]);
    assert_eq!(found(&format!("{arc} compare-integral")), [0, 1, 4, -5, 0, 0, -5, 4, 1, 0]);
    assert_eq!(found("parabola --p 2 --to 4,4"), [0, -4, -3, 0, -4, 1, -3, 4, 0]);
    let nearest = "parabola --p 1 --to 8,4 --method min-deviation";
    assert_eq!(found(nearest), [0, 1, -1, 0, -2, 1, -1, -3, 2, 0]);
}

#[test]
fn the_judgements_name_what_decides() {
    let judged = |arguments: &str| column(&cells(arguments), "judge");
    let arc = "arc --from 5,0 --to 0,5 --ccw --method";
    assert_eq!(
        judged(&format!("{arc} min-deviation"))[1],
        "-Δx: F = -9, +Δy: F = 1, -Δx +Δy: F = -8"
    );
    assert_eq!(judged(&format!("{arc} compare-integral"))[4], "F3 = -5 < |x| - |y| - 1 = 1");
    assert_eq!(judged(&format!("{arc} compare-integral"))[5], "F4 = 0 = |x| - |y| - 1 = 0");
    // From (2,4) on x leads down to the end, and then y stands at 5.
    assert_eq!(judged(&format!("{arc} vector"))[7], "F6 = 1, y stands");
    assert_eq!(judged("parabola --p 2 --to 4,4").last().unwrap(), "F7 = 4 > 0, y stands");
    assert_eq!(judged("line --to 0,-2 --method vector")[1], "V0 = 0, x stands");
    assert_eq!(
        judged("line --to 1,-3,2"),
        [
            "",
            "Fx0 = 0, Fz0 = 0",
            "Fx1 = -1, Fz1 = -2",
            "Fx2 = -1, Fz2 = 1",
            "Fx3 = 2, Fz3 = 1",
            "Fx4 = 1, Fz4 = -1",
            "Fx5 = 1, Fz5 = 2"
        ]
    );
}

#[test]
fn a_parabola_in_registers() {
    let cells = cells("parabola --p 2 --to 4,4 --method dda");
    assert_eq!(cells.len(), 1 + 1 + 18);
    let jr = column(&cells, "remainder JRx");
    assert_eq!(jr[..12], ["0", "0", "0", "0", "0", "1", "2", "3", "4", "6", "0", "2"]);
    assert!(column(&cells, "integrand JVy").iter().all(|cell| cell == "2"));
    assert_eq!(column(&cells, "integrand JVx").last().unwrap(), "4");
    assert_eq!(column(&cells, "end counter JEx").last().unwrap(), "0");
}

/// Every table of steps ends where the pulses end, with its counters at zero.
#[test]
fn the_counters_come_to_zero() {
    for (curve, _) in CURVES {
        let cells = cells(curve);
        for counter in ["end counter Ex", "end counter Ey", "end counter Ez", "end counter Ea"] {
            if cells[0].iter().any(|heading| heading == counter) {
                assert_eq!(column(&cells, counter).last().unwrap(), "0", "{curve} {counter}");
            }
        }
    }
}

#[test]
fn every_curve_has_its_table_in_every_format_and_language() {
    for (curve, [english, chinese]) in CURVES {
        for (language, heading) in [("en", english), ("zh", chinese)] {
            let csv = table(&format!("{curve} --format csv --lang {language}"));
            let rows = csv.lines().count() - 1;
            for (format, lines) in FORMATS.into_iter().zip([rows + 2, rows + 2, rows + 1]) {
                let text = table(&format!("{curve} --format {format} --lang {language}"));
                assert!(text.lines().next().unwrap().contains(heading), "{curve} {format}: {text}");
                assert_eq!(text.lines().count(), lines, "{curve} {format} {language}");
                assert!(text.ends_with('\n'), "{curve} {format}");
                assert!(!text.lines().any(|line| line.ends_with(' ')), "{curve} {format}");
            }
        }
    }
}

#[test]
fn every_row_has_as_many_cells_as_there_are_headings() {
    for (curve, _) in CURVES {
        for language in ["en", "zh"] {
            let cells = cells(&format!("{curve} --lang {language}"));
            assert!(cells.iter().all(|row| row.len() == cells[0].len()), "{curve} {language}");
            let markdown = table(&format!("{curve} --lang {language} --format md"));
            for line in markdown.lines() {
                let bars = line.replace("\\|", "").matches('|').count();
                assert_eq!(bars, cells[0].len() + 1, "{curve} {language}: {line}");
            }
        }
    }
}

#[test]
fn english_text_is_the_default() {
    for (curve, _) in CURVES {
        assert_eq!(table(curve), table(&format!("{curve} --format text --lang en")), "{curve}");
    }
}

#[test]
fn the_longest_tables_stream_until_nobody_reads() {
    let arguments = "table line --to 2147483647,-2147483648 --format csv";
    let mut child = Command::new(cargo_bin!("onepulse"))
        .args(arguments.split_whitespace())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let stdout = BufReader::new(child.stdout.take().unwrap());
    let lines: Vec<_> = stdout.lines().take(3).map(Result::unwrap).collect();
    let mut errors = String::new();
    child.stderr.take().unwrap().read_to_string(&mut errors).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(0), "{errors}");
    assert_eq!(errors, "");
    assert_eq!(lines[1], "start,,,F0 = 0,E = 4294967295");
    let update = "F1 = F0 - |y_e| = 0 - 2147483648 = -2147483648";
    assert_eq!(lines[2], format!("1,F0 = 0,+Δx,{update},E = 4294967295 - 1 = 4294967294"));
}

#[test]
fn wrong_command_lines_are_refused() {
    for (arguments, words) in [
        ("line --to 5,3 --format html", "--format"),
        ("line --to 5,3 --lang de", "--lang"),
        ("line --to 5,3 --normalize", "--normalize"),
        ("line --to 5,3 --bits 2", "needs 3"),
        ("line --to 5,3,1 --method vector", "--method"),
        ("helix --from 5,0 --to 0,5 --rise 3 --cw --method dda", "--method ppc only"),
        ("line --to 5,3 --method brm --smooth 30", "--smooth"),
        ("parabola --p 2 --to 4,4 --method vector", "--method"),
        ("parabola --p 2 --to 4,4 --method dda --bits 2", "needs 3"),
        ("arc --from 5,0 --to 0,5 --ccw --method brm", "--method"),
        ("arc --from 5,0 --to 0,5 --ccw --method dda --preset full", "--preset"),
        ("arc --from 5,0 --to 0,5 --ccw --method dda --radix 10", "radix 2"),
        ("arc --from 0,0 --to 0,5 --ccw", "starts in its centre"),
    ] {
        let output = run(arguments);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {errors}");
        assert_eq!(output.stdout, b"", "{arguments}");
        assert!(errors.contains(words), "{arguments}: '{words}' is missing in: {errors}");
    }
}
