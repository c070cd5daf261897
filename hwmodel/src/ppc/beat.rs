//! The four beats of a step.

/// The state of the beat counter: what this clock does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beat {
    /// Look at the sign of F and note which axis is due.
    Judge,
    /// Send the pulse.
    Feed,
    /// Compute F for the new point; an arc's end counters count the pulse.
    Update,
    /// Compare with the end point; a line's end counters count the pulse.
    Compare,
}

impl Beat {
    /// The states as words, in the order of their codes.
    pub const WORDS: &[&str] = &["JUDGE", "FEED", "UPDATE", "COMPARE"];

    /// The state after this one.
    #[must_use]
    #[inline]
    pub const fn next(self) -> Self {
        match self {
            Self::Judge => Self::Feed,
            Self::Feed => Self::Update,
            Self::Update => Self::Compare,
            Self::Compare => Self::Judge,
        }
    }
}
