//! The points of lines by minimum deviation, vector discrimination and comparison integration, from
//! what the methods promise.

/// Where a line by minimum deviation is after `k` steps: on each axis the whole number nearest to the
/// line, the lower one of two.
#[must_use]
pub fn nearest<const N: usize>(end: [i32; N], k: u64) -> [i64; N] {
    along(end, |length, longest| {
        let twice = 2 * u128::from(k) * u128::from(length);
        (twice + u128::from(longest) - 1) / (2 * u128::from(longest))
    })
}

/// Where a line by vector discrimination is after `k` steps, from 1 on: the shorter axis as many pulses
/// from the origin as points of the line lie below its height before step k.
#[must_use]
pub fn by_vectors(end: [i32; 2], k: u64) -> [i64; 2] {
    along(end, |length, longest| match length {
        0 => 0,
        _ if length == longest => u128::from(k),
        _ => (u128::from(k) - 1) * u128::from(length) / u128::from(longest) + 1,
    })
}

/// The points of a line by comparison integration, from the times of its pulses: the i-th of x at
/// (2i − 1)·|y_e|/2, the j-th of y at (2j − 1)·|x_e|/2.
pub fn by_intervals(end: [i32; 2]) -> impl Iterator<Item = [i64; 2]> {
    let [xe, ye] = end.map(|c| u64::from(c.unsigned_abs()));
    let (mut i, mut j) = (0, 0);
    std::iter::from_fn(move || {
        let next = |count: u64, most: u64, interval: u64| {
            (count < most).then(|| u128::from(2 * count + 1) * u128::from(interval))
        };
        let (x, y) = (next(i, xe, ye), next(j, ye, xe));
        let first = x.into_iter().chain(y).min()?;
        i += u64::from(x == Some(first));
        j += u64::from(y == Some(first));
        let [x, y] = end.map(|c| i64::from(c.signum()));
        Some([x * i as i64, y * j as i64])
    })
}

/// A count for each axis, from its length and the longest, with the axis' sign.
fn along<const N: usize>(end: [i32; N], count: impl Fn(u64, u64) -> u128) -> [i64; N] {
    let magnitude = end.map(|c| u64::from(c.unsigned_abs()));
    let longest = magnitude.iter().fold(0, |most, c| (*c).max(most));
    std::array::from_fn(|axis| {
        i64::from(end[axis].signum()) * count(magnitude[axis], longest) as i64
    })
}
