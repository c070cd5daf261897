//! The path of digital integration along a line, in closed form.

/// How often an axis with `integrand` has overflowed after `k` accumulations in a register that
/// began with `preset` and overflows at `modulus`.
#[must_use]
pub fn overflows(integrand: u64, preset: u64, modulus: u64, k: u64) -> u64 {
    let sum = u128::from(preset) + u128::from(integrand) * u128::from(k);
    (sum / u128::from(modulus)) as u64
}
