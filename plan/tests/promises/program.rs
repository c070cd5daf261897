//! What holds of the steps of every program, and of what is said of wrong ones.

use onepulse_plan::gcode::{Program, ProgramError, Step};
use onepulse_plan::{Diagnostic, Length, Machine, Place, Tools};

/// Reads a program to its end. Panics where a promise is broken.
pub(crate) fn check(text: &[u8], machine: &Machine, tools: &Tools) {
    let lines = Lines::of(text);
    let mut program = Program::new(text, machine, tools);
    let mut position = [Length::ZERO; 3];
    let (mut line, mut count) = (0, 0);
    while let Some(step) = program.next() {
        // A block moves or dwells, and may stop besides; and an error comes last.
        count += 1;
        assert!(count <= 2 * lines.count() + 1, "it never ends");
        match step {
            Ok(step) => {
                let place = match &step {
                    Step::Move(step) => {
                        assert_eq!(step.from, position, "line {}", step.place.line);
                        position = step.to;
                        &step.place
                    }
                    Step::Pause(pause) => &pause.place,
                };
                lines.check(place);
                assert!(place.line >= line, "line {} comes after line {line}", place.line);
                line = place.line;
            }
            Err(ProgramError::Program(wrong)) => {
                lines.check_wrong(&wrong);
                assert!(program.next().is_none(), "something comes after an error");
            }
            Err(ProgramError::Input(error)) => panic!("{error}"),
        }
    }
}

/// The lines of a program.
pub(crate) struct Lines<'a>(Vec<&'a [u8]>);

impl<'a> Lines<'a> {
    pub(crate) fn of(text: &'a [u8]) -> Self {
        Self(text.split(|byte| *byte == b'\n').collect())
    }

    pub(crate) fn count(&self) -> usize {
        self.0.len()
    }

    /// The place is one of the program: its text is that of its line, and its span is a part of that.
    pub(crate) fn check(&self, place: &Place) {
        let Place { line, text, span } = place;
        assert!((1..=self.count()).contains(&(*line as usize)), "{place:?}");
        let source = String::from_utf8_lossy(self.0[*line as usize - 1]);
        // Of an endless line the beginning is kept, of the end of the program nothing or its last line.
        assert!(source.len() > 4096 || source.starts_with(&**text), "{place:?} of {source:?}");
        assert!(span.start <= span.end && span.end <= text.len(), "{place:?}");
        assert!(text.is_char_boundary(span.start) && text.is_char_boundary(span.end), "{place:?}");
        assert!(place.column() <= text.chars().count() + 1, "{place:?}");
    }

    /// The errors, in the order of their lines, have a place and words.
    pub(crate) fn check_wrong(&self, wrong: &[Diagnostic]) {
        assert!(!wrong.is_empty());
        assert!(wrong.is_sorted_by_key(|diagnostic| diagnostic.place.line), "{wrong:?}");
        for diagnostic in wrong {
            [&diagnostic.place].into_iter().chain(&diagnostic.also).for_each(|at| self.check(at));
            assert!(
                !diagnostic.message.is_empty() && !diagnostic.help.is_empty(),
                "{diagnostic:?}"
            );
        }
    }
}
