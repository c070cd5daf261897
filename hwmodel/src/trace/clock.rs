//! Clock edges on the time axis of a wave.

/// A clock of some frequency on the coarsest time axis that shows its edges exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Clock {
    hertz: u64,
    /// The unit of the time axis is 10^−digits seconds.
    digits: u32,
    /// Half a period in these units, if that is a whole number.
    half_period: Option<u64>,
}

impl Clock {
    /// The finest time axis: 1 ps.
    const FINEST: u32 = 12;

    /// The fastest clock whose edges stay apart on the finest axis, in hertz.
    pub const FASTEST: u64 = 100_000_000_000;

    /// A clock of `hertz` (1 to [`Clock::FASTEST`]); `None` outside that range.
    ///
    /// The time axis counts whole half periods where some unit down to 1 ps does; otherwise it
    /// counts picoseconds, and each edge is rounded down by itself, so no error adds up.
    #[must_use]
    pub fn new(hertz: u64) -> Option<Self> {
        if !(1..=Self::FASTEST).contains(&hertz) {
            return None;
        }
        let exact = |digits| (10_u64.pow(digits) % (2 * hertz) == 0).then_some(digits);
        let exact = (0..=Self::FINEST).find_map(exact);
        Some(Self {
            hertz,
            digits: exact.unwrap_or(Self::FINEST),
            half_period: exact.map(|digits| 10_u64.pow(digits) / (2 * hertz)),
        })
    }

    /// The unit of the time axis as a power of ten of a second: −6 for 1 µs.
    #[must_use]
    pub const fn exponent(self) -> i8 {
        -(self.digits as i8)
    }

    /// A clock period as GTKWave counts it: in the next of s, ms, µs, ns, ps that is not coarser
    /// than the unit of the time axis.
    #[must_use]
    pub fn viewer_period(self) -> f64 {
        10_f64.powi(self.digits.div_ceil(3) as i32 * 3) / self.hertz as f64
    }

    /// When the clock rises for the `k`-th time, from 0.
    #[must_use]
    pub fn rise(self, k: u64) -> u64 {
        self.half_periods(2 * u128::from(k))
    }

    /// When the clock falls after its `k`-th rise.
    #[must_use]
    pub fn fall(self, k: u64) -> u64 {
        self.half_periods(2 * u128::from(k) + 1)
    }

    fn half_periods(self, count: u128) -> u64 {
        if let Some(units) = self.half_period {
            return (count * u128::from(units)) as u64;
        }
        (count * 10_u128.pow(self.digits) / (2 * u128::from(self.hertz))) as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axis_is_as_coarse_as_the_edges_allow() {
        let axis = |hertz| Clock::new(hertz).map(Clock::exponent);
        assert_eq!(axis(1), Some(-1));
        assert_eq!(axis(1_000_000), Some(-7));
        assert_eq!(axis(4_000_000), Some(-9));
        assert_eq!(axis(3), Some(-12));
        assert_eq!(axis(0), None);
    }

    #[test]
    fn edges_do_not_drift() {
        let clock = Clock::new(3).unwrap();
        assert_eq!(clock.rise(3_000_000), 1_000_000 * 1_000_000_000_000);
        assert_eq!(clock.fall(1), 500_000_000_000);
    }
}
