//! Numbers as ASCII digits: nearly all that a wave file is made of.
//!
//! Digits are put at the head of a room that is longer than they are, in steps of a fixed number of
//! bytes, which is faster than to count them; what stands in the room behind them means nothing.

use std::ops::RangeInclusive;

/// The digits of the longest binary number.
pub(super) const LONGEST_BINARY: usize = 64;

/// The eight digits of every byte.
static OCTETS: [[u8; 8]; 256] = {
    let mut octets = [[0; 8]; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut digit = 0;
        while digit < 8 {
            octets[byte][digit] = b'0' + (byte >> (7 - digit) & 1) as u8;
            digit += 1;
        }
        byte += 1;
    }
    octets
};

/// Puts the low `bits` binary digits (1 to 64) of a value, the highest first, in a room for
/// [`LONGEST_BINARY`].
#[inline(always)]
pub(super) fn put_binary(room: &mut [u8], value: u64, bits: u32) {
    // The highest digit first, whole octets from there on.
    let bytes = (value << (64 - bits)).to_be_bytes();
    let mut put = |at: usize| {
        room[8 * at..8 * at + 8].copy_from_slice(&OCTETS[usize::from(bytes[at])]);
    };
    // No loop: how often it ends where would be hard to foresee.
    (0..4).for_each(&mut put);
    if bits > 32 {
        (4..8).for_each(put);
    }
}

/// A decimal number that counts up, so that mostly its three low digits change, and nearly always
/// the eight low ones at most.
///
/// Its length is kept: taken from the digits, it would let all text behind the number wait for
/// these.
#[derive(Debug)]
pub(super) struct Decimal {
    number: u64,
    /// The numbers that have as many digits as this one, and the same ones but the eight lowest.
    alike: RangeInclusive<u64>,
    /// The digits that all of these begin with.
    head: [u8; Self::HEAD],
    length: usize,
    /// How many digits follow.
    low_digits: usize,
    /// The number, or an earlier one, with zeros for its three low digits.
    thousands: u64,
    /// The eight low digits of that.
    thousands_digits: u64,
}

impl Decimal {
    /// All digits of the largest `u64` but eight, and some: rounded up, they are copied faster.
    const HEAD: usize = 16;
    const EIGHT_DIGITS: u64 = 100_000_000;

    pub(super) const ZERO: Self = Self {
        number: 0,
        alike: 0..=9,
        head: [b'0'; Self::HEAD],
        length: 0,
        low_digits: 1,
        thousands: 0,
        thousands_digits: EIGHT_ZEROS,
    };

    /// Makes it another number.
    #[inline(always)]
    pub(super) fn set(&mut self, number: u64) {
        self.number = number;
        if !self.alike.contains(&number) {
            self.set_head();
        }
        if number.wrapping_sub(self.thousands) >= 1_000 {
            self.set_thousands();
        }
    }

    #[cold]
    fn set_head(&mut self) {
        let digits = self.number.to_string();
        self.low_digits = digits.len().min(8);
        self.length = digits.len() - self.low_digits;
        self.head[..self.length].copy_from_slice(&digits.as_bytes()[..self.length]);
        let unit = 10_u64.pow(self.low_digits as u32);
        let low = if digits.len() > 8 { 0 } else { unit / 10 };
        let base = self.number - self.number % Self::EIGHT_DIGITS;
        self.alike = base + low..=base.saturating_add(unit - 1);
    }

    /// Not marked as cold: in a wave with long periods, every number has its own thousands.
    #[inline(always)]
    fn set_thousands(&mut self) {
        self.thousands = self.number - self.number % 1_000;
        let low = (self.thousands % Self::EIGHT_DIGITS) as u32;
        self.thousands_digits = eight_digits(low) | EIGHT_ZEROS;
    }

    /// Puts its digits, without leading zeros, in a room for as many as the
    /// head may have and eight more; how many.
    #[inline(always)]
    pub(super) fn put(&self, room: &mut [u8]) -> usize {
        room[..Self::HEAD].copy_from_slice(&self.head);
        if let Some(room) = room[self.length..].first_chunk_mut() {
            let low = THREE_DIGITS[(self.number - self.thousands) as usize % 1_024];
            // The first digit is the lowest byte.
            let digits = self.thousands_digits | u64::from(low) << 32;
            *room = (digits >> (64 - 8 * self.low_digits)).to_le_bytes();
        }
        self.length + self.low_digits
    }
}

/// The decimal digits of all numbers of three digits, the first in the second lowest byte: the
/// lowest belongs to a digit before them. Filled up to a power of two, as no index lies outside then.
static THREE_DIGITS: [u32; 1_024] = {
    let mut digits = [0; 1_024];
    let mut number = 0;
    while number < 1_000 {
        digits[number] = (eight_digits(number as u32) >> 32) as u32;
        number += 1;
    }
    digits
};

const EIGHT_ZEROS: u64 = u64::from_le_bytes([b'0'; 8]);

/// The decimal digits of a number below 10^8 as bytes, the first digit the lowest. All divisions
/// of a step are one multiplication: by 1/100 and 1/10, rounded so that the quotients are exact.
const fn eight_digits(number: u32) -> u64 {
    let number = number as u64;
    // Two groups of four digits, four of two, eight of one.
    let fours = (number / 10_000) | ((number % 10_000) << 32);
    let hundreds = ((fours * 5_243) >> 19) & 0x0000_007f_0000_007f;
    let twos = hundreds | (fours - 100 * hundreds) << 16;
    let tens = ((twos * 103) >> 10) & 0x000f_000f_000f_000f;
    tens | (twos - 10 * tens) << 8
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn decimal(decimal: &Decimal) -> String {
        let mut room = [b'?'; Decimal::HEAD + 8];
        let length = decimal.put(&mut room);
        String::from_utf8_lossy(&room[..length]).into_owned()
    }

    #[test]
    fn every_group_of_four_digits_is_that_of_the_formatter() {
        for four in 0..10_000 {
            let number = four * 10_000 + (9_999 - four);
            let digits = (eight_digits(number) | EIGHT_ZEROS).to_le_bytes();
            assert_eq!(digits.as_slice(), format!("{number:08}").as_bytes());
        }
    }

    #[test]
    fn the_ends_of_the_digits_are_right() {
        let mut counter = Decimal::ZERO;
        for number in [0, 9, 10, 99_999_999, 100_000_000, u64::MAX, 1_000_000_007, 7] {
            counter.set(number);
            assert_eq!(decimal(&counter), number.to_string());
        }
    }

    proptest! {
        #[test]
        fn binary_digits_are_those_of_the_formatter(value: u64, bits in 1_u32..=64) {
            let mut room = [b'?'; LONGEST_BINARY];
            put_binary(&mut room, value, bits);
            let all = format!("{value:064b}");
            prop_assert_eq!(&room[..bits as usize], &all.as_bytes()[64 - bits as usize..]);
        }

        #[test]
        fn decimal_digits_are_those_of_the_formatter(numbers: [u64; 8], shift in 0_u32..64) {
            let mut counter = Decimal::ZERO;
            for number in numbers {
                counter.set(number >> shift);
                prop_assert_eq!(decimal(&counter), (number >> shift).to_string());
            }
        }
    }
}
