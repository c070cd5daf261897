//! How point-by-point comparison knows that it has arrived.

use crate::Axis;

/// The end-point strategy (终点判别) of point-by-point comparison.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum EndRule {
    /// One down counter, loaded with the pulses of both axes together.
    #[default]
    Total,
    /// Two down counters, one an axis; each stops its own axis.
    PerAxis,
    /// One down counter for the axis that has more pulses (x when both have the same number).
    ///
    /// The other axis may be left short of its end: ask the machine for its `residual`.
    Larger,
}

impl EndRule {
    /// Whether the rule's counters stand at zero when `left` pulses of each axis are to come, of
    /// `larger` which had more of them at the start.
    #[inline]
    pub(crate) const fn is_met(self, left: [u64; 2], larger: Axis) -> bool {
        match self {
            Self::Total | Self::PerAxis => left[0] == 0 && left[1] == 0,
            Self::Larger => larger.of(left) == 0,
        }
    }

    /// What the rule's counters still hold: pulses until the end.
    pub(crate) const fn remaining(self, left: [u64; 2], larger: Axis) -> u64 {
        match self {
            Self::Total | Self::PerAxis => left[0] + left[1],
            Self::Larger => larger.of(left),
        }
    }
}
