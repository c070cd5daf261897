//! Tables as text, Markdown or CSV.

use super::{Format, Language, Table};
use std::io::{self, BufWriter, Write};
use unicode_width::UnicodeWidthStr;

/// Writes a table. Aligned text goes through the rows twice, so that none is kept.
pub(crate) fn write(
    out: impl Write,
    table: &impl Table,
    format: Format,
    language: Language,
) -> io::Result<()> {
    let mut out = BufWriter::new(out);
    let headings = table.headings(language);
    let rows = table.rows(language);
    match format {
        Format::Csv => {
            for row in std::iter::once(headings).chain(rows) {
                let cells: Vec<_> = row.iter().map(|cell| quoted(cell)).collect();
                writeln!(out, "{}", cells.join(","))?;
            }
        }
        Format::Md => {
            writeln!(out, "| {} |", headings.join(" | "))?;
            writeln!(out, "|{}", "---|".repeat(headings.len()))?;
            for row in rows {
                let cells: Vec<_> = row.iter().map(|cell| cell.replace('|', "\\|")).collect();
                writeln!(out, "| {} |", cells.join(" | "))?;
            }
        }
        Format::Text => {
            let mut widths: Vec<_> = headings.iter().map(|heading| heading.width()).collect();
            for row in rows {
                for (width, cell) in widths.iter_mut().zip(&row) {
                    *width = cell.width().max(*width);
                }
            }
            write_aligned(&mut out, &headings, &widths)?;
            let rule: Vec<_> = widths.iter().map(|width| "-".repeat(*width)).collect();
            write_aligned(&mut out, &rule, &widths)?;
            for row in table.rows(language) {
                write_aligned(&mut out, &row, &widths)?;
            }
        }
    }
    out.flush()
}

fn write_aligned(out: &mut impl Write, row: &[String], widths: &[usize]) -> io::Result<()> {
    let mut line = String::new();
    for (cell, width) in row.iter().zip(widths) {
        line.push_str(cell);
        line.push_str(&" ".repeat(width - cell.width() + 2));
    }
    writeln!(out, "{}", line.trim_end())
}

fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}
