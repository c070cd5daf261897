//! The words of one line sorted into what they mean.

use super::word::{Fault, Number, Word, Words};
use crate::compensation::Side;
use onepulse_core::{Direction, Plane};
use std::ops::Range;

/// How coordinates move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MotionMode {
    Rapid,
    Feed,
    Arc(Direction),
}

/// What ends or stops a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    /// M00: until the operator goes on.
    Program,
    /// M02, M30.
    End,
}

/// A number and where it is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Value {
    pub(super) number: Number,
    pub(super) span: Range<usize>,
}

/// Something that a word chooses, and where that is written.
type Choice<T> = Option<(T, Range<usize>)>;

/// One line of a program: at most one word of each modal group and of each letter.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Block {
    pub(super) motion: Choice<MotionMode>,
    pub(super) plane: Choice<Plane>,
    pub(super) is_metric: Choice<bool>,
    pub(super) is_absolute: Choice<bool>,
    /// G40 to G42: the side of the cutter, none for the path itself.
    pub(super) side: Choice<Option<Side>>,
    pub(super) dwell: Choice<()>,
    pub(super) stop: Choice<Stop>,
    /// X, Y, Z.
    pub(super) coordinates: [Option<Value>; 3],
    /// I, J, K.
    pub(super) offsets: [Option<Value>; 3],
    pub(super) r: Option<Value>,
    pub(super) p: Option<Value>,
    pub(super) f: Option<Value>,
    pub(super) s: Option<Value>,
    pub(super) t: Option<Value>,
    pub(super) d: Option<Value>,
    /// The first and last byte of the words.
    pub(super) span: Range<usize>,
    pub(super) is_deletable: bool,
    pub(super) is_tape_mark: bool,
    /// Whether some of it could not be read: any word may have stood there.
    pub(super) is_garbled: bool,
}

impl Block {
    /// Reads a line: what it says, and everything that is wrong with it.
    pub(super) fn read(line: &str) -> (Self, Vec<Fault>) {
        let Words { words, mut faults, is_deletable, is_tape_mark } = Words::read(line);
        let is_garbled = !faults.is_empty();
        let mut block = Self { is_deletable, is_tape_mark, is_garbled, ..Self::default() };
        if let (Some(first), Some(last)) = (words.first(), words.last()) {
            block.span = first.span.start..last.span.end;
        }
        for (place, word) in words.into_iter().enumerate() {
            faults.extend(block.take(place, word, line).err());
        }
        (block, faults)
    }

    fn take(&mut self, place: usize, word: Word, line: &str) -> Result<(), Fault> {
        let span = word.span.clone();
        match (word.letter, word.number.as_integer()) {
            ('N', _) => check_line_number(place, &word),
            ('G', Some(code @ 0..=3)) => {
                let mode = [
                    MotionMode::Rapid,
                    MotionMode::Feed,
                    MotionMode::Arc(Direction::Cw),
                    MotionMode::Arc(Direction::Ccw),
                ][code as usize];
                choose(&mut self.motion, mode, span, "motion mode (G00 to G03)")
            }
            ('G', Some(4)) => choose(&mut self.dwell, (), span, "dwell (G04)"),
            ('G', Some(code @ 17..=19)) => {
                let plane = [Plane::Xy, Plane::Zx, Plane::Yz][(code - 17) as usize];
                choose(&mut self.plane, plane, span, "plane (G17 to G19)")
            }
            ('G', Some(code @ (20 | 21))) => {
                choose(&mut self.is_metric, code == 21, span, "unit (G20, G21)")
            }
            ('G', Some(code @ 40..=42)) => {
                let side = [None, Some(Side::Left), Some(Side::Right)][(code - 40) as usize];
                choose(&mut self.side, side, span, "cutter radius compensation (G40 to G42)")
            }
            ('G', Some(code @ (90 | 91))) => {
                choose(&mut self.is_absolute, code == 90, span, "distance mode (G90, G91)")
            }
            ('M', Some(0)) => choose(&mut self.stop, Stop::Program, span, STOP),
            ('M', Some(2 | 30)) => choose(&mut self.stop, Stop::End, span, STOP),
            ('X', _) => set(&mut self.coordinates[0], word),
            ('Y', _) => set(&mut self.coordinates[1], word),
            ('Z', _) => set(&mut self.coordinates[2], word),
            ('I', _) => set(&mut self.offsets[0], word),
            ('J', _) => set(&mut self.offsets[1], word),
            ('K', _) => set(&mut self.offsets[2], word),
            ('R', _) => set(&mut self.r, word),
            ('P', _) => set(&mut self.p, word),
            ('F', _) => set(&mut self.f, word),
            ('S', _) => set(&mut self.s, word),
            ('T', _) => set(&mut self.t, word),
            ('D', _) => set(&mut self.d, word),
            _ => Err(unsupported(line, &word)),
        }
    }

    /// A word that only arcs have.
    pub(super) fn arc_word(&self) -> Option<&Value> {
        self.offsets.iter().flatten().chain(&self.r).min_by_key(|value| value.span.start)
    }
}

const STOP: &str = "stop or end of program (M00, M02, M30)";

fn choose<T>(
    slot: &mut Choice<T>,
    choice: T,
    span: Range<usize>,
    group: &str,
) -> Result<(), Fault> {
    if slot.is_some() {
        return Err(twice(span, group));
    }
    *slot = Some((choice, span));
    Ok(())
}

fn set(slot: &mut Option<Value>, Word { letter, number, span }: Word) -> Result<(), Fault> {
    if slot.is_some() {
        return Err(twice(span, &letter.to_string()));
    }
    *slot = Some(Value { number, span });
    Ok(())
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
        ('A' | 'B' | 'C' | 'U' | 'V' | 'W', _) => {
            "three axes are interpolated, X, Y and Z: remove the word"
        }
        ('M', _) => {
            "coolant, tool change and the spindle's start are not part of the interpolator: remove \
             the word; M00, M02 and M30 are supported"
        }
        ('H', _) | ('G', Some(43 | 44 | 49)) => {
            "there is no tool length offset: remove the word, and write Z as it is to be"
        }
        ('G', Some(80..=89)) => "there are no cycles: write their motions as G00 and G01",
        _ => {
            "supported are G00 to G04, G17 to G21, G40 to G42, G90 G91, M00 M02 M30, X Y Z I J K R P F \
             S T D and N"
        }
    };
    Fault::new(word.span.clone(), format!("{text} is not supported"), help)
}
