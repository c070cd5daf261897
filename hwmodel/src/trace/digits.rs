//! Numbers as ASCII digits: nearly all that a wave file is made of.

/// Appends the low `bits` binary digits (1 to 64) of a value, the highest first.
pub(super) fn push_binary(text: &mut Vec<u8>, value: u64, bits: u32) {
    let end = text.len() + bits as usize;
    // Whole octets from the highest digit on; what the last one has too much is cut off.
    let mut rest = value << (64 - bits);
    for _ in 0..bits.div_ceil(8) {
        text.extend_from_slice(&octet(rest >> 56));
        rest <<= 8;
    }
    text.truncate(end);
}

/// The eight digits of a byte, without a loop over them.
const fn octet(byte: u64) -> [u8; 8] {
    const EACH: u64 = 0x0101_0101_0101_0101;
    // A copy of the byte for every digit, and of each copy that digit's bit.
    let bit = (byte * EACH) & 0x8040_2010_0804_0201;
    // Whichever bit it is, it carries into the copy's highest, and no further.
    let digit = (bit + 0x7f * EACH) >> 7 & EACH;
    (digit | (b'0' as u64 * EACH)).to_be_bytes()
}

/// A decimal number that is counted on, which is faster than to convert each of its values.
#[derive(Debug)]
pub(super) struct Decimal {
    /// The digits, the lowest at [`Self::LOWEST`], and nothing behind them.
    digits: [u8; Self::LOWEST + Self::LONGEST],
    /// Where the number begins.
    first: usize,
}

impl Decimal {
    /// The digits of the largest `u64`.
    const LONGEST: usize = 20;
    const LOWEST: usize = Self::LONGEST - 1;

    pub(super) const ZERO: Self =
        Self { digits: [b'0'; Self::LOWEST + Self::LONGEST], first: Self::LOWEST };

    /// Adds to the number, which must stay an `u64`.
    pub(super) fn add(&mut self, increment: u64) {
        let mut carry = increment;
        let mut place = Self::LOWEST + 1;
        while carry > 0 {
            place -= 1;
            let sum = carry + u64::from(self.digits[place] - b'0');
            self.digits[place] = b'0' + (sum % 10) as u8;
            carry = sum / 10;
        }
        self.first = self.first.min(place);
    }

    /// Appends its digits, without leading zeros.
    pub(super) fn push(&self, text: &mut Vec<u8>) {
        let end = text.len() + Self::LOWEST + 1 - self.first;
        // A fixed number of bytes is faster to copy than the exact one.
        if let Some(digits) = self.digits[self.first..].first_chunk::<{ Self::LONGEST }>() {
            text.extend_from_slice(digits);
        }
        text.truncate(end);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn every_octet_is_that_of_the_formatter() {
        for byte in 0..=255 {
            assert_eq!(octet(byte).as_slice(), format!("{byte:08b}").as_bytes());
        }
    }

    proptest! {
        #[test]
        fn binary_digits_are_those_of_the_formatter(value: u64, bits in 1_u32..=64) {
            let mut text = b"b".to_vec();
            push_binary(&mut text, value, bits);
            let all = format!("{value:064b}");
            prop_assert_eq!(&text[1..], &all.as_bytes()[64 - bits as usize..]);
        }

        #[test]
        fn counting_is_adding(increments in prop::collection::vec(0_u64..u64::MAX / 32, 1..32)) {
            let (mut decimal, mut sum) = (Decimal::ZERO, 0);
            for increment in increments {
                decimal.add(increment);
                sum += increment;
                let mut text = b"#".to_vec();
                decimal.push(&mut text);
                prop_assert_eq!(text, format!("#{sum}").into_bytes());
            }
        }
    }
}
