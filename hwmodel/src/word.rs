//! Fixed-width words: what a register of `bits` bits keeps of a number.

/// The low `bits` bits of a register's content (1 to 63).
#[inline(always)]
pub(crate) const fn mask(bits: u32) -> u64 {
    (1 << bits) - 1
}

/// What a register of `bits` bits makes of a signed number: two's complement, wrapped.
#[inline(always)]
pub(crate) const fn wrap(value: i64, bits: u32) -> i64 {
    let unused = 64 - bits;
    (value << unused) >> unused
}

/// A magnitude with a sign.
#[inline(always)]
pub(crate) const fn signed(magnitude: i64, is_negative: bool) -> i64 {
    if is_negative { -magnitude } else { magnitude }
}

/// Whether two arrays are equal, element by element: solvers are slow to see through `==`, a loop over
/// memory.
#[cfg(feature = "proofs")]
#[inline(always)]
pub(crate) fn same<T: Copy + PartialEq, const N: usize>(left: [T; N], right: [T; N]) -> bool {
    let mut same = true;
    for index in 0..N {
        same &= left[index] == right[index];
    }
    same
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapping_is_twos_complement() {
        assert_eq!(wrap(7, 4), 7);
        assert_eq!(wrap(8, 4), -8);
        assert_eq!(wrap(-9, 4), 7);
        assert_eq!(wrap(-1, 34), -1);
        assert_eq!(mask(3), 0b111);
    }
}
