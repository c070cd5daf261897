//! A line of text into words: a letter and a number each.

use std::ops::Range;

/// A word of a block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Word {
    /// The letter, in upper case.
    pub(crate) letter: char,
    pub(crate) number: Number,
    /// Its bytes in the line.
    pub(crate) span: Range<usize>,
}

/// A decimal number as it is written: `digits`·10^−`decimals`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Number {
    pub(crate) digits: i64,
    pub(crate) decimals: u32,
    /// Whether a decimal point is written.
    pub(crate) has_point: bool,
}

impl Number {
    /// The number, if it is whole.
    pub(crate) fn as_integer(self) -> Option<i64> {
        let scale = 10_i64.checked_pow(self.decimals)?;
        (self.digits % scale == 0).then_some(self.digits / scale)
    }
}

/// What is wrong with a line's text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Fault {
    pub(crate) span: Range<usize>,
    pub(crate) message: String,
    pub(crate) help: String,
}

impl Fault {
    pub(crate) fn new(
        span: Range<usize>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        Self { span, message: message.into(), help: help.into() }
    }
}

/// A line's text taken apart.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Words {
    pub(crate) words: Vec<Word>,
    /// Everything that is no word, from left to right; what follows it is read all the same.
    pub(crate) faults: Vec<Fault>,
    /// Whether it begins with the slash of a block that may be left out.
    pub(crate) is_deletable: bool,
    /// Whether it is a tape mark, `%`, and nothing else.
    pub(crate) is_tape_mark: bool,
}

impl Words {
    /// Reads a line; blanks and comments are left out.
    pub(crate) fn read(line: &str) -> Self {
        let mut read = Self::default();
        let mut rest = Cursor { line, at: 0 };
        loop {
            rest.skip_blanks();
            let start = rest.at;
            let is_first = read.words.is_empty() && read.faults.is_empty() && !read.is_deletable;
            let fault = match rest.peek() {
                None | Some(';') => return read,
                Some('%') if is_first && line[start + 1..].trim().is_empty() => {
                    read.is_tape_mark = true;
                    return read;
                }
                Some('/') if is_first => {
                    read.is_deletable = true;
                    rest.at += 1;
                    None
                }
                Some('(') => match rest.skip_comment() {
                    Ok(()) => None,
                    // Where it ends is not known.
                    Err(fault) => {
                        read.faults.push(fault);
                        return read;
                    }
                },
                Some(letter) if letter.is_ascii_alphabetic() => {
                    rest.at += 1;
                    match rest.number(start) {
                        Ok(number) => {
                            let letter = letter.to_ascii_uppercase();
                            read.words.push(Word { letter, number, span: start..rest.at });
                            None
                        }
                        Err(fault) => Some(fault),
                    }
                }
                Some(other) => {
                    rest.at += other.len_utf8();
                    Some(Fault::new(
                        start..rest.at,
                        format!("'{}' does not begin a word", other.escape_default()),
                        "a block is words such as G01 X10.5, comments in ( ) or after ;",
                    ))
                }
            };
            if let Some(fault) = fault {
                // One complaint about what belongs together.
                let rests = line[fault.span.end..].find(|c| !begins_no_word(c));
                rest.at = rests.map_or(line.len(), |rests| fault.span.end + rests);
                read.faults.push(fault);
            }
        }
    }
}

struct Cursor<'a> {
    line: &'a str,
    at: usize,
}

impl Cursor<'_> {
    fn peek(&self) -> Option<char> {
        self.line[self.at..].chars().next()
    }

    fn skip_blanks(&mut self) {
        while matches!(self.peek(), Some(' ' | '\t')) {
            self.at += 1;
        }
    }

    fn skip_comment(&mut self) -> Result<(), Fault> {
        let start = self.at;
        let inside = start + 1;
        match self.line[inside..].find(['(', ')']) {
            Some(found) if self.line[inside + found..].starts_with(')') => {
                self.at = inside + found + 1;
                Ok(())
            }
            Some(found) => Err(Fault::new(
                inside + found..inside + found + 1,
                "a comment inside a comment",
                "close the first comment with ) before opening another",
            )),
            None => Err(Fault::new(
                start..self.line.len(),
                "this comment is not closed",
                "close it with ) on the same line, or begin it with ;",
            )),
        }
    }

    /// The number of the word that starts at `start`.
    fn number(&mut self, start: usize) -> Result<Number, Fault> {
        self.skip_blanks();
        let bytes = self.line.as_bytes();
        let first = self.at;
        let is_negative = bytes.get(first) == Some(&b'-');
        if matches!(bytes.get(self.at), Some(b'+' | b'-')) {
            self.at += 1;
        }
        let (mut digits, mut decimals, mut count) = (0_i64, 0, 0);
        let mut has_point = false;
        while let Some(&byte) = bytes.get(self.at) {
            match byte {
                b'0'..=b'9' => {
                    let digit = i64::from(byte - b'0');
                    let next = digits.checked_mul(10).and_then(|d| d.checked_add(digit));
                    digits = next.ok_or_else(|| {
                        let end = first
                            + self.line[first..]
                                .find(is_no_digit)
                                .unwrap_or(self.line.len() - first);
                        Fault::new(
                            start..end.max(self.at + 1),
                            "this number has too many digits",
                            "18 significant digits are the most",
                        )
                    })?;
                    count += 1;
                    decimals += u32::from(has_point);
                }
                b'.' if !has_point => has_point = true,
                _ => break,
            }
            self.at += 1;
        }
        if count == 0 {
            let letter = &self.line[start..=start];
            return Err(Fault::new(
                start..if self.at > first { self.at } else { start + 1 },
                format!("{letter} is not followed by a number"),
                format!("write the number right after the letter, as in {letter}10"),
            ));
        }
        // Trailing zeros carry nothing; without them more decimals fit.
        while decimals > 0 && digits % 10 == 0 {
            digits /= 10;
            decimals -= 1;
        }
        let digits = if is_negative { -digits } else { digits };
        Ok(Number { digits, decimals, has_point })
    }
}

fn is_no_digit(c: char) -> bool {
    !c.is_ascii_digit() && !matches!(c, '.' | '+' | '-')
}

/// What is passed over after a fault.
fn begins_no_word(c: char) -> bool {
    !c.is_ascii_alphabetic() && !matches!(c, ' ' | '\t' | '(' | ';')
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init, reason = "a list of one span is meant")]
mod tests {
    use super::*;

    fn texts(line: &str) -> Vec<(char, i64, u32, bool)> {
        let tuple = |w: Word| (w.letter, w.number.digits, w.number.decimals, w.number.has_point);
        let read = Words::read(line);
        assert_eq!(read.faults, [], "{line}");
        read.words.into_iter().map(tuple).collect()
    }

    #[test]
    fn the_textbook_block_without_blanks() {
        let expected = [
            ('N', 3, 0, false),
            ('G', 1, 0, false),
            ('X', -45000, 0, false),
            ('Y', -75000, 0, false),
            ('F', 150, 0, false),
        ];
        assert_eq!(texts("N3G01X-45000Y-75000F150"), expected);
    }

    #[test]
    fn blanks_comments_and_points() {
        assert_eq!(
            texts(" g1 (feed) x +.50\ty10. ; to the corner"),
            [('G', 1, 0, false), ('X', 5, 1, true), ('Y', 10, 0, true)]
        );
        assert_eq!(texts("X0.000000000000000000000"), [('X', 0, 0, true)]);
        assert_eq!(texts(""), []);
    }

    #[test]
    fn a_slash_and_a_tape_mark() {
        assert!(Words::read(" % ").is_tape_mark);
        assert_eq!(texts("%"), []);
        assert!(Words::read("/N5 G00").is_deletable);
        assert_eq!(texts(" / X1"), [('X', 1, 0, false)]);
        assert_eq!(spans("X1 /Y2"), [3..4]);
        assert_eq!(spans("//"), [1..2]);
        assert_eq!(spans("X1 %"), [3..4]);
    }

    fn spans(line: &str) -> Vec<Range<usize>> {
        Words::read(line).faults.into_iter().map(|fault| fault.span).collect()
    }

    #[test]
    fn what_is_no_word_is_pointed_at() {
        assert_eq!(spans("G01 X"), [4..5]);
        assert_eq!(spans("G01 X-"), [4..6]);
        assert_eq!(spans("G01 #5"), [4..5]);
        assert_eq!(spans("X1 (open"), [3..8]);
        assert_eq!(spans("X1 (a(b)"), [5..6]);
        assert_eq!(spans("\u{e9}"), [0..2]);
        assert_eq!(spans("X1.2.3"), [4..5]);
        assert_eq!(spans("X99999999999999999999"), [0..21]);
    }

    #[test]
    fn all_faults_of_a_line_are_found_and_its_other_words_read() {
        assert_eq!(spans("G01 X Y- #5 Z1 &&"), [4..5, 6..8, 9..10, 15..16]);
        let letters: String =
            Words::read("G01 X Y- #5 Z1 &&").words.iter().map(|w| w.letter).collect();
        assert_eq!(letters, "GZ");
    }
}
