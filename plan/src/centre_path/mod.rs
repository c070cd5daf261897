//! The path of the cutter's centre: a program's steps with its contours compensated.
//!
//! ```
//! use onepulse_plan::centre_path::{CentrePath, Compensation, Role, Step};
//! use onepulse_plan::{Machine, Tools, gcode::Program};
//!
//! // A square from its lower left corner, with a cutter of 2 mm on its left.
//! let text = "G00 X0 Y-10.\nG41 G01 Y0 F300\nY20.\nX20.\nY0\nX0\nG40 X-10.\nM02\n";
//! let machine = Machine::with_pulse("0.01".parse()?);
//! let program = Program::new(text.as_bytes(), &machine, &Tools::Radius(2.0));
//! let mut ends = Vec::new();
//! for step in CentrePath::new(program, &machine, Compensation::default()) {
//!     if let Step::Move(step) = step? {
//!         ends.push((step.role, step.to.map(|c| c.round()), step.place.line));
//!     }
//! }
//! assert_eq!(ends[1], (Role::Establish, [-2.0, 0.0, 0.0], 2));
//! assert_eq!(ends[2], (Role::Offset, [-2.0, 22.0, 0.0], 3));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod gouge;
mod overcut;
mod section;
mod step;

pub use gouge::{Gouge, PathError};
pub use step::{CentreMove, Role, Step};

use crate::compensation::Corners;
use crate::gcode::{self, Cutter, MOST_ERRORS, Phase, ProgramError};
use crate::{Diagnostic, Machine, Motion};
use section::Gathered;
use std::collections::VecDeque;

/// How contours are compensated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compensation {
    /// Block by block (B刀补): arcs about outside corners, and no inside corners.
    B,
    /// With the next block in view (C刀补).
    C(Corners),
}

impl Default for Compensation {
    /// The C type with straight corners, as the textbooks have it.
    fn default() -> Self {
        Self::C(Corners::Straight)
    }
}

/// The steps of a program with its contours compensated. Of the program, a contour is kept at a time.
///
/// The iterator ends after the first error: all that is wrong with the program and all its contours.
#[derive(Debug)]
pub struct CentrePath<I> {
    steps: I,
    machine: Machine,
    compensation: Compensation,
    ready: VecDeque<Step>,
    gathered: Gathered,
    wrong: Vec<Diagnostic>,
    gouges: Vec<Gouge>,
    is_over: bool,
}

impl<I: Iterator<Item = Result<gcode::Step, ProgramError>>> CentrePath<I> {
    /// The path of these steps.
    pub fn new(steps: I, machine: &Machine, compensation: Compensation) -> Self {
        Self {
            steps,
            machine: *machine,
            compensation,
            ready: VecDeque::new(),
            gathered: Gathered::default(),
            wrong: Vec::new(),
            gouges: Vec::new(),
            is_over: false,
        }
    }

    /// All motions in pulses, one after the other, whatever pauses are between them.
    pub fn motions(self) -> impl Iterator<Item = Result<Motion, PathError>> {
        self.flat_map(|step| {
            let (motions, error) = match step {
                Ok(Step::Move(step)) => (step.motions, None),
                Ok(Step::Pause(_)) => ([None; 2], None),
                Err(error) => ([None; 2], Some(Err(error))),
            };
            motions.into_iter().flatten().map(Ok).chain(error)
        })
    }

    fn advance(&mut self) -> Result<Option<Step>, PathError> {
        loop {
            if self.wrong.is_empty() {
                if let Some(step) = self.ready.pop_front() {
                    return Ok(Some(step));
                }
            }
            self.ready.clear();
            if self.wrong.len() >= MOST_ERRORS {
                return Err(self.end());
            }
            match self.steps.next() {
                Some(Ok(step)) => self.take(step),
                Some(Err(ProgramError::Input(error))) => return Err(PathError::Input(error)),
                Some(Err(ProgramError::Program(wrong))) => {
                    self.wrong.extend(wrong);
                    return Err(self.end());
                }
                None if self.wrong.is_empty() => return Ok(None),
                None => return Err(self.end()),
            }
        }
    }

    fn take(&mut self, step: gcode::Step) {
        let phase = match &step {
            gcode::Step::Move(step) => match step.cutter {
                Cutter::Off => None,
                Cutter::On { phase, .. } => Some(phase),
            },
            gcode::Step::Pause(_) => None,
        };
        if phase.is_none() && self.gathered.is_empty() {
            self.ready.push_back(step::as_programmed(step));
            return;
        }
        self.gathered.push(step);
        if phase == Some(Phase::Cancel) {
            let gathered = std::mem::take(&mut self.gathered);
            match gathered.compensate(self.compensation, self.machine.pulse) {
                Ok(steps) => self.ready.extend(steps),
                Err((wrong, gouge)) => {
                    self.wrong.extend(wrong);
                    self.gouges.extend(gouge);
                }
            }
        }
    }

    fn end(&mut self) -> PathError {
        let mut wrong = std::mem::take(&mut self.wrong);
        wrong.sort_by_key(|diagnostic| diagnostic.place.line);
        wrong.truncate(MOST_ERRORS);
        PathError::Program { wrong, gouges: std::mem::take(&mut self.gouges) }
    }
}

impl<I: Iterator<Item = Result<gcode::Step, ProgramError>>> Iterator for CentrePath<I> {
    type Item = Result<Step, PathError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.is_over {
            return None;
        }
        let next = self.advance().transpose();
        self.is_over = !matches!(next, Some(Ok(_)));
        next
    }
}
