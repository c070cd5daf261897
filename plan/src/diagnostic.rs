//! What is wrong with a program, and where.

use std::fmt;
use std::ops::Range;

/// An error in a program: the place, what is wrong there, and what to do about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The program's line, from 1.
    pub line: u32,
    /// The text of that line, without its end.
    pub source: String,
    /// The offending bytes of it; may be empty, at the end of the line.
    pub span: Range<usize>,
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub help: String,
}

impl Diagnostic {
    /// The offending text's column: characters from the line's start, from 1.
    #[must_use]
    pub fn column(&self) -> usize {
        self.source[..self.span.start].chars().count() + 1
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}: {}", self.line, self.column(), self.message)
    }
}

impl std::error::Error for Diagnostic {}
