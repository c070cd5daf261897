//! What a program asks of the interpolator, one thing after the other.

use onepulse_plan::centre_path::Step;
use onepulse_plan::gcode::Pause;
use onepulse_plan::{Motion, Place};
use std::time::Duration;

/// A curve to be made, or a time to stand still.
#[derive(Clone, Debug)]
pub(crate) enum Action {
    Move(Move),
    Pause(Pause),
}

/// A curve, and what holds while it is made.
#[derive(Clone, Debug)]
pub(crate) struct Move {
    pub(crate) motion: Motion,
    /// The block that asks for it.
    pub(crate) place: Place,
    /// The tool that was chosen last (T).
    pub(crate) tool: Option<u32>,
    /// The spindle's speed that was programmed last (S), in turns a minute.
    pub(crate) spindle: Option<f64>,
}

impl Action {
    /// What a step of the cutter's path asks for: of a motion that ends where it starts, nothing.
    pub(crate) fn of(step: Step) -> impl Iterator<Item = Self> {
        let (step, pause) = match step {
            Step::Move(step) => (Some(step), None),
            Step::Pause(pause) => (None, Some(pause)),
        };
        let moves = step.into_iter().flat_map(|step| {
            let motions = step.motions();
            motions.map(move |motion| {
                let (place, tool, spindle) = (step.place.clone(), step.tool, step.spindle);
                Self::Move(Move { motion, place, tool, spindle })
            })
        });
        moves.chain(pause.map(Self::Pause))
    }
}

/// How long the machine stands still; none for a program stop, and for a dwell of 0 s.
pub(crate) fn standstill(pause: &Pause) -> Option<Duration> {
    pause.dwell.filter(|dwell| !dwell.is_zero())
}
