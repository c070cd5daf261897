//! The path of digital integration along an arc, as an integral over the path itself.

use onepulse_core::Direction;

/// Checks that a path (its points cycle by cycle, the start first) is that of the textbook's
/// circuit within one quadrant: as long as neither axis stands at its end, after every cycle x has
/// moved ⌊(preset + Σ|y|·2^Q)/2ⁿ⌋ and y ⌊(preset + Σ|x|·2^Q)/2ⁿ⌋, the sums over the points before.
///
/// # Errors
/// The first cycle that breaks the rule.
pub fn check_textbook(
    path: &[[i64; 2]],
    end: [i64; 2],
    preset: u64,
    bits: u32,
    shift: u32,
) -> Result<(), usize> {
    let mut sums = [u128::from(preset); 2];
    for (cycle, pair) in path.windows(2).enumerate() {
        if pair[0][0] == end[0] || pair[0][1] == end[1] {
            return Ok(());
        }
        for axis in 0..2 {
            sums[axis] += u128::from(pair[0][1 - axis].unsigned_abs()) << shift;
            let moved = u128::from((pair[1][axis] - path[0][axis]).unsigned_abs());
            if moved != sums[axis] >> bits {
                return Err(cycle + 1);
            }
        }
    }
    Ok(())
}

/// Checks that a path is that of the centred staggered circuit: as long as neither axis may stand
/// (`may_stand` says so of a point), x − x₀ = ⌊(preset_x ∓ Σy·2^Q)/2ⁿ⌋ with the sum over the
/// points before, and y − y₀ = ⌊(2^(n−1) ± Σx·2^Q)/2ⁿ⌋ with the sum over the points after each
/// cycle (staggered), preset_x = 2^(n−1) ± y₀·2^Q/2; the upper signs for ccw.
///
/// # Errors
/// The first cycle that breaks the rule.
pub fn check_centred(
    path: &[[i64; 2]],
    direction: Direction,
    bits: u32,
    shift: u32,
    may_stand: impl Fn([i64; 2]) -> bool,
) -> Result<(), usize> {
    let turn = if direction == Direction::Ccw { 1 } else { -1 };
    let half = 1_i128 << (bits - 1);
    let scaled = |c: i64| i128::from(c) << shift;
    let mut sums = [half + turn * scaled(path[0][1]) / 2, half];
    for (cycle, pair) in path.windows(2).enumerate() {
        if may_stand(pair[0]) {
            return Ok(());
        }
        sums[0] -= turn * scaled(pair[0][1]);
        sums[1] += turn * scaled(pair[1][0]);
        for axis in 0..2 {
            if i128::from(pair[1][axis] - path[0][axis]) != sums[axis] >> bits {
                return Err(cycle + 1);
            }
        }
    }
    Ok(())
}
