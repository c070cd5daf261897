//! A program line by line.

use super::block::Block;
use super::modes::Modes;
use super::word::Fault;
use crate::{Diagnostic, Machine, Motion};
use std::collections::VecDeque;
use std::fmt;
use std::io::{self, BufRead, Read};

/// The motions of a program, read line by line: memory does not grow with its length.
///
/// Positions are kept exactly and rounded to the nearest pulse one by one, so no error adds up.
/// The iterator ends after M02, M30, the last line, or the first error.
#[derive(Debug)]
pub struct Program<R> {
    input: R,
    line: u32,
    text: String,
    modes: Modes,
    ready: VecDeque<Motion>,
    is_over: bool,
}

/// Why a program cannot be run.
#[derive(Debug)]
pub enum ProgramError {
    /// It cannot be read.
    Input(io::Error),
    /// It has an error.
    Program(Box<Diagnostic>),
}

/// The longest line that is read, in bytes.
const LONGEST_LINE: u64 = 4096;

impl<R: BufRead> Program<R> {
    /// The program in `input`, for a machine. It starts in (0,0) with G17, G21 and G90.
    pub fn new(input: R, machine: &Machine) -> Self {
        let modes = Modes::new(*machine);
        Self { input, line: 0, text: String::new(), modes, ready: VecDeque::new(), is_over: false }
    }

    /// The text of the line that was read last: the one that the last motion stands in.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Reads lines until there is a motion, or nothing more.
    fn advance(&mut self) -> Result<Option<Motion>, ProgramError> {
        loop {
            if let Some(motion) = self.ready.pop_front() {
                return Ok(Some(motion));
            }
            if self.is_over {
                return Ok(None);
            }
            let mut bytes = Vec::new();
            let mut limited = (&mut self.input).take(LONGEST_LINE + 1);
            limited.read_until(b'\n', &mut bytes).map_err(ProgramError::Input)?;
            if bytes.is_empty() {
                return Ok(None);
            }
            self.line += 1;
            self.text.clear();
            self.text.push_str(String::from_utf8_lossy(&bytes).trim_end_matches(['\n', '\r']));
            let run = if bytes.len() as u64 > LONGEST_LINE && !bytes.ends_with(b"\n") {
                Err(Fault::new(
                    0..0,
                    format!("a line of over {LONGEST_LINE} bytes"),
                    "write one block a line",
                ))
            } else {
                self.run()
            };
            run.map_err(|Fault { span, message, help }| {
                let (line, source) = (self.line, self.text.clone());
                ProgramError::Program(Box::new(Diagnostic { line, source, span, message, help }))
            })?;
        }
    }

    fn run(&mut self) -> Result<(), Fault> {
        let block = Block::read(&self.text)?;
        self.modes.run(&block, self.line, &mut self.ready)?;
        self.is_over = block.is_end;
        Ok(())
    }
}

impl<R: BufRead> Iterator for Program<R> {
    type Item = Result<Motion, ProgramError>;

    fn next(&mut self) -> Option<Self::Item> {
        let next = self.advance().transpose();
        if matches!(next, Some(Err(_))) {
            self.is_over = true;
            self.ready.clear();
        }
        next
    }
}

impl fmt::Display for ProgramError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(error) => error.fmt(f),
            Self::Program(diagnostic) => diagnostic.fmt(f),
        }
    }
}

impl std::error::Error for ProgramError {}
