//! What an axis may do.

use crate::Error;

/// What an axis may do, in units of 2⁻ⁿ pulses a clock.
///
/// A frequency of f pulses a second is f·2ⁿ/f_clock units; an acceleration of so many pulses a second,
/// each second, is that times 2ⁿ/f_clock² units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// n, 1 to 31.
    pub bits: u32,
    /// The speed that the axis starts with and stops from at once: at least 1.
    pub start: u32,
    /// By how much the speed changes from one clock to the next at most: at least 1, and not more than
    /// the largest speed.
    pub acceleration: u32,
    /// The speed that it never exceeds: below 2ⁿ, a pulse on every clock, and not below the start's.
    pub largest: u32,
}

impl Limits {
    /// The limits, if they are within their ranges.
    pub(super) const fn checked(self) -> Result<Self, Error> {
        let Self { bits, start, acceleration, largest } = self;
        if bits < 1 || bits > 31 {
            return Err(Error::RegisterWidth { digits: bits, widest: 31 });
        }
        let is_some = 1 <= start && 1 <= acceleration;
        let is_within = start <= largest && acceleration <= largest && largest >> bits == 0;
        if is_some && is_within { Ok(self) } else { Err(Error::RampLimits) }
    }
}
