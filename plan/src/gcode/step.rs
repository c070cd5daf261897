//! What a program asks for, step by step, exactly as programmed.

use super::arc::ProgrammedArc;
use crate::compensation::Side;
use crate::{Length, Motion, Place, Rate};
use onepulse_core::{Direction, Plane};
use std::time::Duration;

/// A step of a program.
#[allow(clippy::large_enum_variant, reason = "nearly all steps are moves")]
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// A motion, or none where a block ends where it starts.
    Move(Move),
    /// The machine stands still.
    Pause(Pause),
}

/// A motion as it is programmed: along the contour where the cutter is compensated.
#[derive(Clone, Debug, PartialEq)]
pub struct Move {
    /// The block.
    pub place: Place,
    /// Where the path starts: X, Y and Z from the program's origin.
    pub from: [Length; 3],
    /// Where it ends.
    pub to: [Length; 3],
    /// The plane of arcs and of compensation.
    pub plane: Plane,
    /// How fast.
    pub rate: Rate,
    /// The tool that was chosen last (T).
    pub tool: Option<u32>,
    /// The spindle's speed that was programmed last (S), in turns a minute.
    pub spindle: Option<f64>,
    /// What compensation makes of it.
    pub cutter: Cutter,
    /// The arc, or a line.
    pub(crate) arc: Option<(ProgrammedArc, Direction)>,
    /// The path in pulses, where it is that of the cutter's centre: nothing, a curve, or an arc and a line.
    pub(crate) motions: [Option<Motion>; 2],
}

/// What cutter radius compensation makes of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cutter {
    /// Its centre moves as programmed.
    Off,
    /// It is compensated.
    On {
        /// Where the centre is, seen in the direction of motion.
        side: Side,
        /// The cutter's radius in millimetres.
        radius: f64,
        /// What the motion does.
        phase: Phase,
    },
}

/// What a compensated motion does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// The line on which compensation is established.
    Establish,
    /// The contour.
    Contour,
    /// Nothing in the plane: it moves across, or not at all.
    Across,
    /// The line on which compensation is cancelled.
    Cancel,
}

/// A stop of the motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pause {
    /// The block.
    pub place: Place,
    /// How long (G04); none for a stop until the operator goes on (M00).
    pub dwell: Option<Duration>,
}
