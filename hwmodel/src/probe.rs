//! What a circuit shows of itself.

/// What a signal's value means and how wide it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One bit.
    Bit,
    /// An unsigned number of so many bits.
    Unsigned(u32),
    /// An unsigned number of so many bits that runs up and down its range: a remainder register,
    /// which a viewer shows as a curve.
    Ramp(u32),
    /// A two's complement number of so many bits.
    Signed(u32),
    /// One that a viewer shows as a curve: an error about zero.
    SignedRamp(u32),
    /// A state, shown as a word: the value is the place in this list.
    Word(&'static [&'static str]),
}

/// What a circuit shows its signals to.
pub trait Probe {
    /// A signal named for one axis: `stem` followed by the axis' letter.
    fn axis_signal(&mut self, stem: &'static str, axis: usize, kind: Kind, value: u64);

    /// The signals that follow belong to a part of this name.
    fn scope(&mut self, _: &'static str) {}

    /// A signal and its present value.
    fn signal(&mut self, name: &'static str, kind: Kind, value: u64);
}

impl Kind {
    /// The number of bits; 1 for a word.
    #[must_use]
    pub const fn bits(self) -> u32 {
        match self {
            Self::Bit | Self::Word(_) => 1,
            Self::Unsigned(bits)
            | Self::Ramp(bits)
            | Self::Signed(bits)
            | Self::SignedRamp(bits) => bits,
        }
    }
}
