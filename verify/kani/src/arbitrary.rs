//! Any value of a type.

use crate::engine;

/// A type with an arbitrary value.
pub trait Arbitrary: Sized {
    /// Any value of the type.
    fn any() -> Self;
}

/// Any value of a type.
#[inline(always)]
#[must_use]
pub fn any<T: Arbitrary>() -> T {
    T::any()
}

/// Any value of a type that satisfies a condition.
#[inline(always)]
#[must_use]
pub fn any_where<T: Arbitrary>(condition: impl FnOnce(&T) -> bool) -> T {
    let value = T::any();
    engine::assume(condition(&value));
    value
}

macro_rules! integers {
    ($($integer:ty),*) => {$(
        impl Arbitrary for $integer {
            #[inline(always)]
            fn any() -> Self {
                engine::any(Self::BITS, Self::MIN != 0) as Self
            }
        }
    )*};
}

integers!(u8, i8, u16, i16, u32, i32, u64, i64);

impl Arbitrary for bool {
    #[inline(always)]
    fn any() -> Self {
        engine::any(1, false) & 1 == 1
    }
}

impl<T: Arbitrary, const N: usize> Arbitrary for [T; N] {
    #[inline(always)]
    fn any() -> Self {
        core::array::from_fn(|_| T::any())
    }
}
