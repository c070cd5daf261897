//! A product as a number of which only the lemmas are known.

/// `factor · count`, in full.
///
/// To a solver it is *any* number with these properties, all of them true of the product (lemma
/// `product` in `verify/lemmas/product.smt2`), so that what is proved of all such numbers is proved
/// of the product: it is 0 when the count is, the factor when the count is 1, and at least
/// twice the factor above that; and it is 2⁶² at most, since neither exceeds 2³¹.
#[cfg(any(kani, target_arch = "wasm32"))]
#[inline(always)]
pub(crate) fn product(factor: u32, count: u32) -> u64 {
    let product: u64 = kani::any();
    kani::assume(factor <= 1 << 31 && count <= 1 << 31 && product <= 1 << 62);
    let factor = u64::from(factor);
    kani::assume(match count {
        0 => product == 0,
        1 => product == factor,
        _ => product >= 2 * factor,
    });
    product
}

/// `factor · count`, in full. A counterexample's own number when one is run again.
#[cfg(not(any(kani, target_arch = "wasm32")))]
pub(crate) fn product(factor: u32, count: u32) -> u64 {
    kani::assume(factor <= 1 << 31 && count <= 1 << 31);
    kani::native::given(u64::from(factor) * u64::from(count))
}
