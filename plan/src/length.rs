//! Exact lengths: decimals from the program text without a float in between.

use std::fmt;
use std::str::FromStr;

/// A length in whole picometres (10⁻⁹ mm), up to 9 million metres: a program in millimetres with
/// nine decimals, or in inches with eight, loses nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Length(i64);

/// Why a decimal is no [`Length`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LengthError {
    /// Not a decimal number.
    NotDecimal,
    /// More decimals than picometres can hold.
    TooFine,
    /// More than a length can hold.
    TooLong,
}

impl Length {
    /// No length.
    pub const ZERO: Self = Self(0);
    /// One millimetre.
    pub const MILLIMETRE: Self = Self(1_000_000_000);
    /// One inch, 25.4 mm.
    pub const INCH: Self = Self(25_400_000_000);

    /// The length of this many picometres.
    #[must_use]
    pub const fn from_picometres(picometres: i64) -> Self {
        Self(picometres)
    }

    /// In picometres.
    #[must_use]
    pub const fn picometres(self) -> i64 {
        self.0
    }

    /// In millimetres, for showing.
    #[must_use]
    pub fn millimetres(self) -> f64 {
        self.0 as f64 / Self::MILLIMETRE.0 as f64
    }

    /// The whole number of picometres nearest to so many millimetres; the longest length if it is longer.
    #[must_use]
    pub fn nearest(millimetres: f64) -> Self {
        Self((millimetres * Self::MILLIMETRE.0 as f64).round() as i64)
    }

    /// `digits`·10^−`decimals` times `unit`.
    ///
    /// # Errors
    /// A result that is not a whole number of picometres, or too long.
    pub fn of(digits: i64, decimals: u32, unit: Self) -> Result<Self, LengthError> {
        let product = i128::from(digits) * i128::from(unit.0);
        let divisor = 10_i128.checked_pow(decimals).ok_or(LengthError::TooFine)?;
        if product % divisor != 0 {
            return Err(LengthError::TooFine);
        }
        i64::try_from(product / divisor).map(Self).map_err(|_| LengthError::TooLong)
    }

    /// The sum, if it is not too long.
    #[must_use]
    pub const fn checked_add(self, other: Self) -> Option<Self> {
        match self.0.checked_add(other.0) {
            Some(sum) => Some(Self(sum)),
            None => None,
        }
    }

    /// The difference, if it is not too long.
    #[must_use]
    pub const fn checked_sub(self, other: Self) -> Option<Self> {
        match self.0.checked_sub(other.0) {
            Some(difference) => Some(Self(difference)),
            None => None,
        }
    }

    /// The nearest whole number of `pulse`s (which is positive); the one further from zero when
    /// two are as near.
    #[must_use]
    pub const fn in_pulses(self, pulse: Self) -> i64 {
        let (whole, rest) = (self.0 / pulse.0, self.0 % pulse.0);
        let rounds_up = rest.unsigned_abs() >= pulse.0.unsigned_abs().div_ceil(2);
        if rounds_up { whole + self.0.signum() } else { whole }
    }
}

impl FromStr for Length {
    type Err = LengthError;

    /// A decimal number of millimetres.
    fn from_str(text: &str) -> Result<Self, LengthError> {
        let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
        let digits = format!("{whole}{fraction}");
        let is_decimal = !digits.trim_start_matches('-').is_empty()
            && fraction.bytes().all(|byte| byte.is_ascii_digit());
        if !is_decimal {
            return Err(LengthError::NotDecimal);
        }
        let digits = digits.parse().map_err(|_| LengthError::NotDecimal)?;
        Self::of(digits, fraction.len() as u32, Self::MILLIMETRE)
    }
}

impl fmt::Display for LengthError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotDecimal => "not a decimal number",
            Self::TooFine => {
                "finer than a picometre: at most 9 decimals of a millimetre, 8 of an inch"
            }
            Self::TooLong => "longer than 9 million metres",
        })
    }
}

impl std::error::Error for LengthError {}

#[cfg(test)]
mod tests {
    use super::*;

    fn mm(text: &str) -> Length {
        text.parse().unwrap()
    }

    #[test]
    fn decimals_are_exact() {
        assert_eq!(mm("0.1").picometres() * 3, mm("0.3").picometres());
        assert_eq!(mm("-12.000000001").picometres(), -12_000_000_001);
        assert_eq!(Length::of(100_000_001, 8, Length::INCH).unwrap(), mm("25.400000254"));
        assert_eq!("0.0000000001".parse::<Length>(), Err(LengthError::TooFine));
        assert_eq!("9999999999999".parse::<Length>(), Err(LengthError::TooLong));
        for bad in ["", "-", "1e3", "1.-2", "x", "1.2.3"] {
            assert_eq!(bad.parse::<Length>(), Err(LengthError::NotDecimal), "{bad}");
        }
    }

    #[test]
    fn pulses_are_the_nearest() {
        let pulses = |text: &str| mm(text).in_pulses(mm("0.01"));
        assert_eq!(pulses("1.004999999"), 100);
        assert_eq!(pulses("1.005"), 101);
        assert_eq!(pulses("-1.005"), -101);
        assert_eq!(pulses("-1.004"), -100);
        let third = Length::from_picometres(3);
        assert_eq!(Length::from_picometres(1).in_pulses(third), 0);
        assert_eq!(Length::from_picometres(2).in_pulses(third), 1);
    }
}
