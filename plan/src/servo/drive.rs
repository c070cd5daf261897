//! The drive, solved over a period.

/// What the drive does in a period, for T = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Drive {
    /// Of a step of the velocity command, what the speed has made of it at the end: 1 − a.
    pub(super) rise: f64,
    /// And what of the way: w.
    pub(super) way: f64,
    /// Of a command of one period, the way in the next one less a times that in its own: y.
    pub(super) after: f64,
}

impl Drive {
    pub(super) fn new(time_constant: f64, period: f64) -> Self {
        // Not zero, so that the slowest drive moves.
        let s = (period / time_constant).max(f64::MIN_POSITIVE);
        if !s.is_finite() {
            return Self { rise: 1.0, way: 1.0, after: 0.0 };
        }
        let rise = -(-s).exp_m1();
        if s > 0.5 {
            let mean = rise / s;
            return Self { rise, way: 1.0 - mean, after: mean - (-s).exp() };
        }
        // s·Σ(−s)^n/(n + 2)! and s·Σ(−s)^n·(n + 1)/(n + 2)!, as the differences would cancel.
        let (mut term, mut way, mut after) = (s / 2.0, 0.0, 0.0);
        for n in 0..15_u32 {
            way += term;
            after += term * (f64::from(n) + 1.0);
            term *= -s / (f64::from(n) + 3.0);
        }
        Self { rise, way, after }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slow_drives_keep_their_digits() {
        // Both sides of where the series ends, and the leading terms.
        let [below, above] = [0.5, 0.5 + 1e-12].map(|s| Drive::new(1.0, s));
        assert!((below.way / above.way - 1.0).abs() < 1e-11);
        assert!((below.after / above.after - 1.0).abs() < 1e-11);
        let slow = Drive::new(1.0, 1e-9);
        assert!((slow.way / 5e-10 - 1.0 + 1e-9 / 3.0).abs() < 1e-15);
        assert!((slow.after / 5e-10 - 1.0 + 2e-9 / 3.0).abs() < 1e-15);
    }
}
