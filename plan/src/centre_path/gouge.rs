//! Why a path cannot be made, and where in the plane.

use crate::Diagnostic;
use crate::compensation::{Element, Overcut};
use onepulse_core::Plane;
use std::fmt;
use std::io;

/// Why the path of the cutter's centre cannot be made.
#[derive(Debug)]
pub enum PathError {
    /// The program cannot be read.
    Input(io::Error),
    /// It has errors, at least one and the first [`MOST_ERRORS`](crate::gcode::MOST_ERRORS), in the
    /// order of its lines.
    Program {
        /// What is wrong.
        wrong: Vec<Diagnostic>,
        /// The contours that the cutter would cut into, for a picture.
        gouges: Vec<Gouge>,
    },
}

/// A contour that the cutter would cut into, in millimetres of its plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Gouge {
    /// The plane.
    pub plane: Plane,
    /// The contour as programmed, with the lines to it and from it.
    pub contour: Vec<Element>,
    /// The cutter's radius.
    pub radius: f64,
    /// Where, at least once and not more often than errors are told.
    pub overcuts: Vec<Overcut>,
}

impl fmt::Display for PathError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(error) => error.fmt(f),
            Self::Program { wrong, .. } => {
                for (place, diagnostic) in wrong.iter().enumerate() {
                    let separator = if place == 0 { "" } else { "\n" };
                    write!(f, "{separator}{diagnostic}")?;
                }
                Ok(())
            }
        }
    }
}

impl std::error::Error for PathError {}
