//! A step of the cutter's centre.

use crate::compensation::Element;
use crate::gcode::{self, Cutter, Move, Pause};
use crate::{Length, Motion, Place, Rate};
use onepulse_core::{Direction, Plane};

/// A step of the path.
#[allow(clippy::large_enum_variant, reason = "nearly all steps are moves")]
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// A motion, or none where it ends where it starts.
    Move(CentreMove),
    /// The machine stands still.
    Pause(Pause),
}

/// What a motion of the cutter's centre is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// A rapid as programmed.
    Rapid,
    /// A feed motion as programmed.
    Feed,
    /// The line on which compensation is established.
    Establish,
    /// Along a block of the contour, the cutter's radius away from it.
    Offset,
    /// Round an outside corner.
    Corner,
    /// The line on which compensation is cancelled.
    Cancel,
}

/// A motion of the cutter's centre: a line, or an arc in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct CentreMove {
    /// The block it belongs to; what goes round a corner belongs to the block before it.
    pub place: Place,
    /// What it is for.
    pub role: Role,
    /// The plane of arcs and of compensation.
    pub plane: Plane,
    /// X, Y and Z of the start, in millimetres.
    pub from: [f64; 3],
    /// Those of the end.
    pub to: [f64; 3],
    /// The centre of an arc, in the plane's own coordinates, and its sense.
    pub arc: Option<([f64; 2], Direction)>,
    /// How fast.
    pub rate: Rate,
    /// The tool that was chosen last (T).
    pub tool: Option<u32>,
    /// The spindle's speed that was programmed last (S), in turns a minute.
    pub spindle: Option<f64>,
    /// What the cutter's radius is and where it is, where it is compensated.
    pub cutter: Cutter,
    /// The block of a contour as programmed, in the plane's own coordinates: once, with the first of
    /// what is made of it.
    pub contour: Option<Element>,
    pub(super) motions: [Option<Motion>; 2],
}

impl CentreMove {
    /// A part of the path that a block asks for.
    pub(super) fn new(
        block: &Move,
        role: Role,
        [from, to]: [[f64; 3]; 2],
        arc: Option<([f64; 2], Direction)>,
        motions: [Option<Motion>; 2],
    ) -> Self {
        let Move { plane, rate, tool, spindle, cutter, .. } = *block;
        let place = block.place.clone();
        Self {
            place,
            role,
            plane,
            from,
            to,
            arc,
            rate,
            tool,
            spindle,
            cutter,
            contour: None,
            motions,
        }
    }

    /// The motion in pulses: none, a curve, or an arc and a line that ends it.
    pub fn motions(&self) -> impl Iterator<Item = Motion> + use<> {
        self.motions.into_iter().flatten()
    }
}

/// A step without compensation.
pub(super) fn as_programmed(step: gcode::Step) -> Step {
    match step {
        gcode::Step::Pause(pause) => Step::Pause(pause),
        gcode::Step::Move(step) => {
            let [first, second, _] = step.plane.axes();
            let from = [step.from[first], step.from[second]];
            let arc = step.arc.map(|(arc, direction)| (arc.centre(from, direction), direction));
            let ends = [step.from, step.to].map(|point| point.map(Length::millimetres));
            let motions = step.motions;
            Step::Move(CentreMove::new(&step, role(step.rate), ends, arc, motions))
        }
    }
}

/// The role of a motion that is not compensated.
pub(super) const fn role(rate: Rate) -> Role {
    match rate {
        Rate::Rapid => Role::Rapid,
        Rate::Feed(_) => Role::Feed,
    }
}
