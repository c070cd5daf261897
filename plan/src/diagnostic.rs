//! What is wrong with a program, and where.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// Where something stands in a program or another file of lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The line, from 1.
    pub line: u32,
    /// The text of that line, without its end.
    pub text: Arc<str>,
    /// The bytes of it that are meant; may be empty, at the end of the line.
    pub span: Range<usize>,
}

impl Place {
    /// The column: characters from the line's start, from 1.
    #[must_use]
    pub fn column(&self) -> usize {
        self.text[..self.span.start].chars().count() + 1
    }

    /// All words of the same line, without the blanks around them.
    #[must_use]
    pub fn of_line(line: u32, text: Arc<str>) -> Self {
        let start = text.len() - text.trim_start().len();
        let end = text.trim_end().len().max(start);
        Self { line, text, span: start..end }
    }
}

/// An error in a program: the place, what is wrong there, and what to do about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The place at fault.
    pub place: Place,
    /// Other places that have a part in it.
    pub also: Vec<Place>,
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub help: String,
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { place, message, .. } = self;
        write!(f, "line {}, column {}: {message}", place.line, place.column())
    }
}

impl std::error::Error for Diagnostic {}
