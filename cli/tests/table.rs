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
const CURVES: [(&str, [&str; 2]); 6] = [
    ("line --to 5,3", ["judge", "偏差判别"]),
    ("arc --from 5,0 --to 0,5 --ccw", ["feed", "坐标进给"]),
    ("line --to 4,6,-5,1 --method dda", ["remainder", "余数"]),
    ("arc --from 5,0 --to 0,5 --cw --method dda", ["integrand", "被积函数"]),
    (
        "arc --from 5,0 --to 0,5 --cw --method dda --update simultaneous",
        ["end counter", "终点计数器"],
    ),
    ("line --to 10,6 --method brm", ["stage of weight", "通过级的权"]),
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
        ("line --to 5,3,1", "--method"),
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
