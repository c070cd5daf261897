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

/// The square of a coordinate.
///
/// To a solver any number with these properties (lemmas `square_…` in
/// `verify/lemmas/product.smt2`): those of a product, and that the squares beside it are squares
/// too, so that (c − 1)² ≥ 0 and, below 2³¹, (c + 1)² ≤ 2⁶².
#[cfg(any(kani, target_arch = "wasm32"))]
#[inline(always)]
pub(crate) fn square(coordinate: u32) -> i64 {
    let square = product(coordinate, coordinate) as i64;
    let c = i64::from(coordinate);
    kani::assume(square >= 2 * c - 1 && (coordinate == 1 << 31 || square + 2 * c + 1 <= 1 << 62));
    square
}

/// The square of a coordinate. A counterexample's own number when one is run again.
#[cfg(not(any(kani, target_arch = "wasm32")))]
pub(crate) fn square(coordinate: u32) -> i64 {
    product(coordinate, coordinate) as i64
}
