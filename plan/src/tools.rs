//! Where the radius of a cutter comes from: a tool table, or the command line.

use crate::gcode::{Fault, Number, Words};
use crate::{Diagnostic, Length, Place};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// The radii of the cutters, in millimetres.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Tools {
    /// None is known: compensation is refused.
    #[default]
    Unknown,
    /// The same for every tool.
    Radius(f64),
    /// By the tool's number.
    Table(ToolTable),
}

/// A tool table in LinuxCNC's format: a line for each tool, `T1 P1 D8.0 Z+12.5 ; remark`. Of it the
/// number T and the diameter D in millimetres matter here; a tool without D has none.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ToolTable {
    diameters: BTreeMap<u32, Length>,
}

/// What a table may say of a tool: number, pocket, offsets, diameter, angles and orientation.
const LETTERS: &str = "TPXYZABCUVWDIJQ";

impl ToolTable {
    /// Reads a table.
    ///
    /// # Errors
    /// Lines that are wrong, each with its place: what is no word of a tool, no tool number or one
    /// that was there before, a negative diameter or one that is no [`Length`].
    pub fn read(text: &str) -> Result<Self, Vec<Diagnostic>> {
        let mut table = Self::default();
        let mut wrong = Vec::new();
        for (line, text) in (1..).zip(text.lines()) {
            for Fault { span, message, help } in table.take(text) {
                let place = Place { line, text: text.into(), span };
                wrong.push(Diagnostic { place, also: Vec::new(), message, help });
            }
        }
        if wrong.is_empty() { Ok(table) } else { Err(wrong) }
    }

    /// The diameter of a tool.
    #[must_use]
    pub fn diameter(&self, tool: u32) -> Option<Length> {
        self.diameters.get(&tool).copied()
    }

    fn take(&mut self, line: &str) -> Vec<Fault> {
        let Words { words, mut faults, .. } = Words::read(line);
        let Some(last) = words.last() else { return faults };
        let end = last.span.end;
        let (mut tool, mut diameter) = (None, Length::ZERO);
        for (place, word) in words.iter().enumerate() {
            let span = word.span.clone();
            let mut wrong = |message: &str, help: &str| {
                faults.push(Fault::new(span.clone(), message, help));
            };
            if !LETTERS.contains(word.letter) {
                wrong("this is no word of a tool table", "a tool is a line such as T1 P1 D8.0");
            } else if words[..place].iter().any(|before| before.letter == word.letter) {
                wrong("a second word of this letter in one line", "leave one of them");
            } else if word.letter == 'T' {
                match word.number.as_integer().and_then(|number| u32::try_from(number).ok()) {
                    Some(number) => tool = Some((number, span)),
                    None => wrong("a tool's number is a whole number", "write T1, not T-1 or T1.5"),
                }
            } else if word.letter == 'D' {
                let Number { digits, decimals, .. } = word.number;
                match Length::of(digits, decimals, Length::MILLIMETRE) {
                    Ok(length) if length >= Length::ZERO => diameter = length,
                    Ok(_) => wrong(
                        "a diameter is not negative",
                        "write it without the sign, and the other of G41 and G42 in the program",
                    ),
                    Err(why) => wrong(&format!("this diameter is {why}"), "write it shorter"),
                }
            }
        }
        match tool {
            Some((tool, span)) => match self.diameters.entry(tool) {
                Entry::Vacant(entry) => {
                    entry.insert(diameter);
                }
                Entry::Occupied(_) => faults.push(Fault::new(
                    span,
                    "this tool was there before",
                    "leave one line for each tool",
                )),
            },
            None if faults.is_empty() => faults.push(Fault::new(
                end..end,
                "a tool without a number",
                "add T and the tool's number",
            )),
            None => {}
        }
        faults
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn faults(text: &str) -> Vec<(u32, std::ops::Range<usize>)> {
        let wrong = ToolTable::read(text).unwrap_err();
        wrong.into_iter().map(|fault| (fault.place.line, fault.place.span)).collect()
    }

    #[test]
    fn a_table_as_linuxcnc_writes_it() {
        let table = ToolTable::read(
            "; mill\nT1 P1 D8.0 Z+12.5 ;roughing\n\nT99999 P22 X0 Z-1.5 D6.35 I0 J0 Q0\nt3 p2\n",
        )
        .unwrap();
        assert_eq!(table.diameter(1), Some("8".parse().unwrap()));
        assert_eq!(table.diameter(99999), Some("6.35".parse().unwrap()));
        assert_eq!(table.diameter(3), Some(Length::ZERO));
        assert_eq!(table.diameter(2), None);
    }

    #[test]
    fn wrong_lines_are_all_named() {
        assert_eq!(
            faults("T1 P1 D1\nT1 P2 D2\nP3 D4\nT4 P4 D-2\nT5 R1\nT6 D1 D2\nT7 D\nT1.5\n"),
            [(2, 0..2), (3, 5..5), (4, 6..9), (5, 3..5), (6, 6..8), (7, 3..4), (8, 0..4)]
        );
    }
}
