//! What a program cannot know: the machine it runs on.

use crate::Length;

/// What a coordinate without a decimal point counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Integers {
    /// Pulses, as on the controls of the textbooks.
    #[default]
    Pulses,
    /// The program's unit, millimetres or inches.
    Units,
}

/// The machine's side of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Machine {
    /// The pulse equivalent δ: the smallest motion of an axis. Positive.
    pub pulse: Length,
    /// The speed of rapid motions (G00), as the way of one minute. Positive.
    pub rapid: Length,
    /// What a coordinate without a decimal point counts.
    pub integers: Integers,
    /// Whether blocks that begin with a slash are left out.
    pub block_delete: bool,
}

impl Machine {
    /// A machine with this pulse equivalent; rapid motions at 3 m/min, integers count pulses,
    /// no block is left out.
    #[must_use]
    pub const fn with_pulse(pulse: Length) -> Self {
        let rapid = Length::from_picometres(3000 * Length::MILLIMETRE.picometres());
        Self { pulse, rapid, integers: Integers::Pulses, block_delete: false }
    }
}
