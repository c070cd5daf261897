//! What has to be known of a program before it is run.

use crate::backdrop::Backdrop;
use onepulse_core::Plane;
use onepulse_plan::centre_path::Step;
use onepulse_plan::{Length, Motion};

/// Which axes a program moves, and the contours that it cuts.
#[derive(Clone, Debug)]
pub(super) struct Survey {
    moves_z: bool,
    /// Whether it has lines that move all three axes.
    pub(super) has_lines_in_space: bool,
    /// The contours of which the cutter is compensated.
    pub(super) backdrop: Backdrop,
}

impl Survey {
    /// Of a program of which nothing is known yet.
    pub(super) fn new(pulse: Length) -> Self {
        let backdrop = Backdrop::new(Plane::Xy, 1.0 / pulse.millimetres());
        Self { moves_z: false, has_lines_in_space: false, backdrop }
    }

    /// Takes what a step draws into account.
    pub(super) fn draw(&mut self, step: &Step) {
        if let Step::Move(step) = step {
            self.backdrop.add(step);
        }
    }

    /// Takes a motion into account.
    pub(super) fn add(&mut self, motion: &Motion) {
        self.moves_z |= motion.moves_z();
        self.has_lines_in_space |= motion.plane().is_none();
    }

    /// The axes of all files: x and y, and z if it ever moves.
    pub(super) const fn axes(&self) -> usize {
        if self.moves_z { 3 } else { 2 }
    }
}
