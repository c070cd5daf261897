//! The words of one line sorted into what they mean.

use super::word::{Fault, Number, Word, words};
use onepulse_core::Direction;
use std::ops::Range;

/// How coordinates move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MotionMode {
    Rapid,
    Feed,
    Arc(Direction),
}

/// A number and where it is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Value {
    pub(super) number: Number,
    pub(super) span: Range<usize>,
}

/// One line of a program: at most one word of each kind.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Block {
    pub(super) motion: Option<(MotionMode, Range<usize>)>,
    pub(super) is_absolute: Option<bool>,
    pub(super) is_metric: Option<bool>,
    pub(super) x: Option<Value>,
    pub(super) y: Option<Value>,
    pub(super) i: Option<Value>,
    pub(super) j: Option<Value>,
    pub(super) r: Option<Value>,
    pub(super) f: Option<Value>,
    pub(super) is_end: bool,
    /// The first and last byte of the words.
    pub(super) span: Range<usize>,
}

impl Block {
    /// Reads a line.
    pub(super) fn read(line: &str) -> Result<Self, Fault> {
        let words = words(line)?;
        let mut block = Self::default();
        if let (Some(first), Some(last)) = (words.first(), words.last()) {
            block.span = first.span.start..last.span.end;
        }
        let mut has_plane = false;
        for (place, word) in words.into_iter().enumerate() {
            let span = word.span.clone();
            match word.letter {
                'N' => check_line_number(place, &word)?,
                'G' => match word.number.as_integer() {
                    Some(code @ 0..=3) => {
                        let mode = [
                            MotionMode::Rapid,
                            MotionMode::Feed,
                            MotionMode::Arc(Direction::Cw),
                            MotionMode::Arc(Direction::Ccw),
                        ][code as usize];
                        set(&mut block.motion, (mode, span.clone()), &span, "motion mode")?;
                    }
                    Some(17) if !has_plane => has_plane = true,
                    Some(17) => return Err(twice(span, "plane")),
                    Some(code @ (20 | 21)) => {
                        set(&mut block.is_metric, code == 21, &span, "unit (G20, G21)")?;
                    }
                    Some(code @ (90 | 91)) => {
                        set(&mut block.is_absolute, code == 90, &span, "distance mode (G90, G91)")?;
                    }
                    _ => return Err(unsupported(line, &word)),
                },
                'M' if matches!(word.number.as_integer(), Some(2 | 30)) => {
                    if std::mem::replace(&mut block.is_end, true) {
                        return Err(twice(span, "end of program"));
                    }
                }
                'X' => set_value(&mut block.x, word)?,
                'Y' => set_value(&mut block.y, word)?,
                'I' => set_value(&mut block.i, word)?,
                'J' => set_value(&mut block.j, word)?,
                'R' => set_value(&mut block.r, word)?,
                'F' => set_value(&mut block.f, word)?,
                _ => return Err(unsupported(line, &word)),
            }
        }
        Ok(block)
    }

    /// A word that only arcs have.
    pub(super) fn arc_word(&self) -> Option<&Value> {
        self.i.as_ref().or(self.j.as_ref()).or(self.r.as_ref())
    }
}

fn set<T>(slot: &mut Option<T>, value: T, span: &Range<usize>, what: &str) -> Result<(), Fault> {
    match slot.replace(value) {
        None => Ok(()),
        Some(_) => Err(twice(span.clone(), what)),
    }
}

fn set_value(slot: &mut Option<Value>, Word { letter, number, span }: Word) -> Result<(), Fault> {
    let value = Value { number, span: span.clone() };
    set(slot, value, &span, &letter.to_string())
}

fn twice(span: Range<usize>, what: &str) -> Fault {
    Fault::new(
        span,
        format!("a second {what} in one block"),
        "leave one of them, or write two blocks",
    )
}

fn check_line_number(place: usize, word: &Word) -> Result<(), Fault> {
    let is_whole = word.number.as_integer().is_some_and(|number| number >= 0);
    if place != 0 {
        Err(Fault::new(
            word.span.clone(),
            "N in the middle of a block",
            "N comes first, or a line end is missing before it",
        ))
    } else if word.number.has_point || !is_whole {
        Err(Fault::new(
            word.span.clone(),
            "a line number is a whole number",
            "write N10, not N10.5 or N-10",
        ))
    } else {
        Ok(())
    }
}

fn unsupported(line: &str, word: &Word) -> Fault {
    let text = line[word.span.clone()].replace(char::is_whitespace, "").to_uppercase();
    let help = match (word.letter, word.number.as_integer()) {
        ('G', Some(18 | 19)) => {
            "only the XY plane (G17) is interpolated: turn the part, or remove the block"
        }
        ('G', Some(40..=42)) | ('D', _) => {
            "offset the path by the cutter radius before, and remove the word"
        }
        ('G', Some(4)) => "there is no dwell: remove the block",
        ('X' | 'Y' | 'Z' | 'A' | 'B' | 'C' | 'U' | 'V' | 'W' | 'K', _) => {
            "two axes are interpolated, X and Y: remove the word"
        }
        ('M' | 'S' | 'T', _) => {
            "spindle, tools and coolant are not part of the interpolator: remove the word"
        }
        _ => "supported are G00 G01 G02 G03 G17 G20 G21 G90 G91, M02 M30, X Y I J R F and N",
    };
    Fault::new(word.span.clone(), format!("{text} is not supported"), help)
}
