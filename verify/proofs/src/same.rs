//! Equality of arrays, element by element.

/// Whether two arrays are equal. (`==` compares their bytes in memory, a loop that solvers are slow
/// to see through.)
#[inline(always)]
pub(crate) fn same<T: Copy + PartialEq, const N: usize>(left: [T; N], right: [T; N]) -> bool {
    let mut same = true;
    for index in 0..N {
        same &= left[index] == right[index];
    }
    same
}
