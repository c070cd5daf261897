//! What has to be known of a program before it is run.

use onepulse_plan::Motion;

/// Which axes a program moves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Survey {
    moves_z: bool,
    /// Whether it has lines that move all three axes.
    pub(super) has_lines_in_space: bool,
}

impl Survey {
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
