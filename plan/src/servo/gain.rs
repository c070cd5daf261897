//! How much gain a loop bears.

use super::drive::Drive;

/// The gain in 1/s that a stable loop has to stay below, for a drive's time constant and a sample period
/// in seconds.
///
/// By Jury's test both roots of D(z) = z² − (1 + a − κ·w)·z + a + κ·y lie inside the unit circle exactly if
/// D(1) > 0, which is κ > 0, D(0) < 1 and D(−1) > 0: with s = T/τ_d,
///
/// ```text
/// κ = K_v·T < (1 − a)/y                 = s/(1 − s/(exp(s) − 1))
/// κ = K_v·T < 2(1 + a)/(2w − (1 − a))   = 2/(1 − tanh(s/2)/(s/2))
/// ```
///
/// The first one counts for slow drives (s < 3.7 or so), the second one for fast ones. Both are 2 or more:
/// K_v·T < 2 is always enough, and needed by the ideal drive and in the limit by very slow ones.
#[must_use]
pub fn stable_gain(drive_time_constant: f64, period: f64) -> f64 {
    let Drive { rise, way, after } = Drive::new(drive_time_constant, period);
    let swinging = rise / after;
    // Nothing for slow drives, where rounding may make it less.
    let hunting = 2.0 * (2.0 - rise) / (2.0 * way - rise).max(0.0);
    swinging.min(hunting) / period
}

/// The largest gain in 1/s with which an axis comes to a commanded position without passing it, for a
/// drive's time constant and a sample period in seconds.
///
/// Up to here both roots of D(z) are real and not negative, so that the pulse response of 1/D(z) has no
/// negative term, nor has that of G(z); beyond, they are complex or negative, and the axis swings.
///
/// The discriminant (1 + a − κ·w)² − 4·(a + κ·y) is zero at κ = (1 − a)²/(b + √(b² − w²·(1 − a)²)), with
/// b = w·(1 + a) + 2y. For the ideal drive that is κ = 1. For short periods it is the continuous loop's
/// 4·K_v·τ_d = 1; a sampled loop does not bear quite that: 4·K_v·(τ_d + T/4) ≤ 1, to the next power of T.
#[must_use]
pub fn aperiodic_gain(drive_time_constant: f64, period: f64) -> f64 {
    let Drive { rise, way, after } = Drive::new(drive_time_constant, period);
    let b = way * (2.0 - rise) + 2.0 * after;
    // b² − w²(1 − a)² without the difference.
    let root = (2.0 * (way * (1.0 - rise) + after) * (b + way * rise)).sqrt();
    rise * rise / (b + root) / period
}

#[cfg(test)]
mod tests {
    use super::super::tests::{PERIOD, drives, settings};
    use super::*;
    use crate::servo::Axis;
    use proptest::prelude::*;

    #[test]
    fn a_lone_drive_of_one_period_has_known_figures() {
        // s = 1: a = w = 1/e, y = 1 − 2/e. Limits 1/(1 − 1/(e − 1)) and 2/(1 − 2·tanh ½).
        let e = std::f64::consts::E;
        let limit = stable_gain(PERIOD, PERIOD) * PERIOD;
        assert!((limit - (e - 1.0) / (e - 2.0)).abs() < 1e-12, "{limit}");
        // A fast one, s = 10, with the other limit.
        let limit = stable_gain(PERIOD / 10.0, PERIOD) * PERIOD;
        assert!((limit - 2.0 / (1.0 - 5.0_f64.tanh() / 5.0)).abs() < 1e-12, "{limit}");
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(100) })]

        /// A command of 1, and 2 % from the limit to either side.
        #[test]
        fn the_limit_parts_what_settles_from_what_grows(drive in drives()) {
            let limit = stable_gain(drive * PERIOD, PERIOD);
            let mut settling = Axis::at_rest(settings(drive * PERIOD, 0.98 * limit));
            let mut growing = Axis::at_rest(settings(drive * PERIOD, 1.02 * limit));
            let settled = (0..40_000).map(|_| settling.step(1.0).following_error);
            // Over a swing or more.
            prop_assert!(settled.skip(39_900).all(|error| error.abs() < 1e-6));
            prop_assert!((0..40_000).any(|_| growing.step(1.0).following_error.abs() > 1e6));
            prop_assert!(limit * PERIOD >= 2.0 * (1.0 - 1e-12));
            prop_assert!(Axis::new(settings(drive * PERIOD, 0.98 * limit)).is_ok());
            prop_assert!(Axis::new(settings(drive * PERIOD, 1.02 * limit)).is_err());
        }

        /// Up to the limit never past the command; above it some way past.
        #[test]
        fn an_axis_passes_its_command_only_above_the_aperiodic_gain(drive in drives(), share in 0.2..1.0) {
            let limit = aperiodic_gain(drive * PERIOD, PERIOD);
            let furthest = |gain: f64| {
                let mut axis = Axis::new(settings(drive * PERIOD, gain)).unwrap();
                (0..20_000).map(|_| axis.step(1.0).position).fold(0.0, f64::max)
            };
            let settled = furthest(share * limit);
            prop_assert!(settled <= 1.0 + 1e-12, "{}", settled);
            prop_assert!(settled > 1.0 - 1e-9, "{}", settled);
            prop_assert!(furthest(limit) <= 1.0 + 1e-12);
            prop_assert!(furthest(1.5 * limit) > 1.0 + 1e-4);
        }
    }

    #[test]
    fn a_sampled_loop_does_not_bear_the_continuous_ones_gain() {
        // 4·K_v·τ_d = 1 with a drive of one period: past the command by half a per cent of the way.
        let gain = 1.0 / (4.0 * PERIOD);
        assert!(gain > aperiodic_gain(PERIOD, PERIOD));
        let mut axis = Axis::new(settings(PERIOD, gain)).unwrap();
        let furthest = (0..1000).map(|_| axis.step(1.0).position).fold(0.0, f64::max);
        assert!((1.005..1.006).contains(&furthest), "{furthest}");
        for drive in [100.0, 1000.0, 10_000.0] {
            let limit = aperiodic_gain(drive * PERIOD, PERIOD) * 4.0 * PERIOD * (drive + 0.25);
            assert!((limit - 1.0).abs() < 0.03 / (drive * drive) + 1e-12, "{limit}");
        }
        assert_eq!(aperiodic_gain(0.0, PERIOD), 1.0 / PERIOD);
    }
}
