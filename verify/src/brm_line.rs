//! The path of the rate multiplier, in closed form.

/// Pulses that an axis of this value has had after `k` clocks of an n-stage divider (n = `bits`).
///
/// The stage of weight 2^(n−1−t) passes the clocks 2^t, 3·2^t, 5·2^t, …
#[must_use]
pub fn pulses(value: u64, bits: u32, k: u64) -> u64 {
    let gated = (0..bits).filter(|t| value >> (bits - 1 - t) & 1 == 1);
    gated.map(|t| (k + (1 << t)) / (2 << t)).sum()
}
