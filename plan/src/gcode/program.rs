//! A program line by line.

use super::block::{Block, Stop};
use super::modes::Modes;
use super::step::Step;
use super::word::Fault;
use crate::{Diagnostic, Machine, Place, Tools};
use std::collections::VecDeque;
use std::fmt;
use std::io::{self, BufRead, Read};
use std::ops::Range;
use std::sync::Arc;

/// The steps of a program, read line by line: memory does not grow with its length.
///
/// Positions are kept exactly and rounded to the nearest pulse one by one, so no error adds up.
/// The iterator ends after M02, M30, the tape mark at the end or the last line. At the first error it
/// reads on for others only, and ends with all of them.
#[derive(Debug)]
pub struct Program<R> {
    input: R,
    is_deleting: bool,
    line: u32,
    text: Arc<str>,
    modes: Modes,
    ready: VecDeque<Step>,
    wrong: Vec<Diagnostic>,
    has_begun: bool,
    is_over: bool,
}

/// Why a program cannot be run.
#[derive(Debug)]
pub enum ProgramError {
    /// It cannot be read.
    Input(io::Error),
    /// It has errors, at least one and the first [`MOST_ERRORS`], in the order of its lines.
    Program(Vec<Diagnostic>),
}

/// The longest line that is read, in bytes.
const LONGEST_LINE: u64 = 4096;

/// Errors that are told in one pass, at most.
pub const MOST_ERRORS: usize = 20;

impl<R: BufRead> Program<R> {
    /// The program in `input`, for a machine and its cutters. It starts in (0,0,0) with G17, G21, G40
    /// and G90.
    pub fn new(input: R, machine: &Machine, tools: &Tools) -> Self {
        Self {
            input,
            is_deleting: machine.block_delete,
            line: 0,
            text: Arc::from(""),
            modes: Modes::new(*machine, tools.clone()),
            ready: VecDeque::new(),
            wrong: Vec::new(),
            has_begun: false,
            is_over: false,
        }
    }

    /// Reads lines until there is a step, or nothing more.
    fn advance(&mut self) -> Result<Option<Step>, ProgramError> {
        loop {
            if self.wrong.is_empty() {
                if let Some(step) = self.ready.pop_front() {
                    return Ok(Some(step));
                }
            }
            if self.is_over || self.wrong.len() >= MOST_ERRORS {
                return self.end();
            }
            let mut bytes = Vec::new();
            let mut limited = (&mut self.input).take(LONGEST_LINE + 1);
            limited.read_until(b'\n', &mut bytes).map_err(ProgramError::Input)?;
            if bytes.is_empty() {
                self.finish(self.text.len()..self.text.len());
                continue;
            }
            self.line = self.line.saturating_add(1);
            self.text = Arc::from(String::from_utf8_lossy(&bytes).trim_end_matches(['\n', '\r']));
            if bytes.len() as u64 > LONGEST_LINE && !bytes.ends_with(b"\n") {
                self.fault(Fault::new(
                    0..0,
                    format!("a line of over {LONGEST_LINE} bytes"),
                    "write one block a line",
                ));
                // What follows would be read as lines of their own.
                self.is_over = true;
            } else {
                self.block();
            }
        }
    }

    fn block(&mut self) {
        let (block, mut faults) = Block::read(&self.text);
        if block.is_tape_mark {
            // The first may stand before the program; at its end nothing comes after it.
            if self.has_begun {
                self.finish(block.span);
            }
            self.has_begun = true;
            return;
        }
        if block.is_deletable && self.is_deleting {
            return;
        }
        let place = Place { line: self.line, text: self.text.clone(), span: block.span.clone() };
        self.has_begun |= !block.span.is_empty();
        self.modes.run(&block, &place, &mut self.ready, &mut faults);
        for fault in faults {
            self.fault(fault);
        }
        if let Some((Stop::End, span)) = block.stop {
            self.finish(span);
        }
    }

    /// Nothing comes after this.
    fn finish(&mut self, span: Range<usize>) {
        self.is_over = true;
        if let Some(fault) = self.modes.end(span) {
            self.fault(fault);
        }
    }

    fn fault(&mut self, Fault { span, message, help }: Fault) {
        if self.wrong.len() >= MOST_ERRORS {
            return;
        }
        let place = Place { line: self.line, text: self.text.clone(), span };
        self.wrong.push(Diagnostic { place, also: Vec::new(), message, help });
    }

    fn end(&mut self) -> Result<Option<Step>, ProgramError> {
        self.is_over = true;
        self.ready.clear();
        match self.wrong.is_empty() {
            true => Ok(None),
            false => Err(ProgramError::Program(std::mem::take(&mut self.wrong))),
        }
    }
}

impl<R: BufRead> Iterator for Program<R> {
    type Item = Result<Step, ProgramError>;

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
            Self::Program(wrong) => {
                for (place, diagnostic) in wrong.iter().enumerate() {
                    let separator = if place == 0 { "" } else { "\n" };
                    write!(f, "{separator}{diagnostic}")?;
                }
                Ok(())
            }
        }
    }
}

impl std::error::Error for ProgramError {}
