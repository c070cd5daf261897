//! Tables: aligned text, which is Markdown too.

use super::tally::Tally;
use std::fmt;
use std::ops::RangeInclusive;

/// A table of figures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// What it shows.
    pub title: String,
    /// The columns' names.
    pub header: Vec<String>,
    /// The rows, as long as the header.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    pub(crate) fn new(title: &str, header: &[&str]) -> Self {
        let header = header.iter().map(|&name| name.to_owned()).collect();
        Self { title: title.to_owned(), header, rows: Vec::new() }
    }

    /// Adds a row.
    pub(crate) fn row<const COLUMNS: usize>(&mut self, row: [String; COLUMNS]) {
        self.rows.push(row.into());
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut widths = vec![1; self.header.len()];
        for row in self.rows.iter().chain([&self.header]) {
            for (width, cell) in widths.iter_mut().zip(row) {
                *width = cell.chars().count().max(*width);
            }
        }
        let line = |f: &mut fmt::Formatter<'_>, row: &[String]| {
            for (cell, &width) in row.iter().zip(&widths) {
                write!(f, "| {cell:<width$} ")?;
            }
            writeln!(f, "|")
        };
        writeln!(f, "{}\n", self.title)?;
        line(f, &self.header)?;
        for &width in &widths {
            write!(f, "|{}", "-".repeat(width + 2))?;
        }
        writeln!(f, "|")?;
        self.rows.iter().try_for_each(|row| line(f, row))
    }
}

/// A deviation, with three digits.
pub(crate) fn pulses(deviation: f64) -> String {
    format!("{deviation:.3}")
}

/// The largest deviation, if one was taken.
pub(crate) fn worst(tally: &Tally) -> String {
    tally.worst.map_or("–".to_owned(), |case| pulses(case.deviation()))
}

/// Where the largest deviation is.
pub(crate) fn place(tally: &Tally) -> String {
    tally.worst.map_or("–".to_owned(), |case| case.to_string())
}

/// A range of widths.
pub(crate) fn widths(bits: &RangeInclusive<u32>) -> String {
    if bits.start() == bits.end() {
        bits.start().to_string()
    } else {
        format!("{} … {}", bits.start(), bits.end())
    }
}

/// A large number, its digits in groups of three.
pub(crate) fn count(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place) % 3 == 0 {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_aligned() {
        let mut table = Table::new("Title", &["n", "worst"]);
        table.row(["10".to_owned(), pulses(1.25)]);
        let text = "Title\n\n| n  | worst |\n|----|-------|\n| 10 | 1.250 |\n";
        assert_eq!(table.to_string(), text);
        assert_eq!(
            [7, 1234, 567_890, 1_000_000].map(count),
            ["7", "1 234", "567 890", "1 000 000"]
        );
    }
}
