//! The registers of a digital integrator.

use crate::Error;

/// The radix of a register.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Radix {
    /// Bits, 32 at most.
    #[default]
    Binary,
    /// Decimal digits, 10 at most.
    Decimal,
}

/// A register of some digits in some radix; it holds 0 … radix^digits − 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Register {
    radix: Radix,
    digits: u32,
    modulus: u64,
}

impl Register {
    /// A register of `digits` digits.
    ///
    /// # Errors
    /// Fewer than 1 digit, more than 32 binary or more than 10 decimal digits.
    pub const fn new(radix: Radix, digits: u32) -> Result<Self, Error> {
        let (base, widest) = match radix {
            Radix::Binary => (2_u64, 32),
            Radix::Decimal => (10, 10),
        };
        if digits < 1 || digits > widest {
            return Err(Error::RegisterWidth { digits, widest });
        }
        Ok(Self { radix, digits, modulus: base.pow(digits) })
    }

    /// The narrowest register that holds `largest`, up to the widest there is.
    #[must_use]
    pub const fn holding(radix: Radix, largest: u32) -> Self {
        let digits = match radix {
            Radix::Binary => largest.checked_ilog2(),
            Radix::Decimal => largest.checked_ilog10(),
        };
        let digits = match digits {
            Some(below) => below + 1,
            None => 1,
        };
        let base: u64 = match radix {
            Radix::Binary => 2,
            Radix::Decimal => 10,
        };
        Self { radix, digits, modulus: base.pow(digits) }
    }

    /// The radix.
    #[must_use]
    pub const fn radix(self) -> Radix {
        self.radix
    }

    /// The number of digits, n.
    #[must_use]
    pub const fn digits(self) -> u32 {
        self.digits
    }

    /// radix^digits: what a carry out of the register is worth, and the number of accumulations
    /// of a line.
    #[must_use]
    pub const fn modulus(self) -> u64 {
        self.modulus
    }

    /// How often a sum has overflowed the register: ⌊sum/radix^digits⌋.
    pub(super) const fn overflows(self, sum: u64) -> u64 {
        match self.radix {
            Radix::Binary => sum >> self.digits,
            Radix::Decimal => sum / self.modulus,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_narrowest_register_holds_the_value_and_no_narrower_one_does() {
        for radix in [Radix::Binary, Radix::Decimal] {
            for largest in (0..3000).chain([i32::MAX as u32, 1 << 31, 999_999_999, u32::MAX]) {
                let register = Register::holding(radix, largest);
                assert!(u64::from(largest) < register.modulus());
                assert_eq!(Register::new(radix, register.digits()), Ok(register));
                if register.digits() > 1 {
                    let narrower = Register::new(radix, register.digits() - 1).unwrap();
                    assert!(u64::from(largest) >= narrower.modulus());
                }
            }
        }
    }

    #[test]
    fn widths_that_are_not_offered_are_refused() {
        let refused = |digits, widest| Err(Error::RegisterWidth { digits, widest });
        assert_eq!(Register::new(Radix::Binary, 0), refused(0, 32));
        assert_eq!(Register::new(Radix::Binary, 33), refused(33, 32));
        assert_eq!(Register::new(Radix::Decimal, 11), refused(11, 10));
    }
}
