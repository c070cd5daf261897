//! The exponential ramp.

use super::{RampError, is_time};

/// Exponential acceleration and deceleration after interpolation (指数加减速): a first-order lag of each
/// axis, period by period.
///
/// What came in and has not gone out yet is kept, and each period gives the share α = T/τ of it, with the
/// period T and the time constant τ. That is the textbooks' V ← V + (V_c − V)·T/τ, V_c the speed asked for.
/// After k periods of a steady V_c it is V_c·(1 − (1 − α)^k): the samples of a lag of which the time
/// constant is not τ but −T/ln(1 − T/τ), or τ − T/2 − T²/(12τ) − …. (The exact samples of the lag with τ
/// itself would take α = 1 − exp(−T/τ).)
///
/// A steady speed v is followed at a distance of v·(τ − T).
///
/// ```
/// use onepulse_plan::after_interpolation::Exponential;
/// // A time constant of two periods, and half a pulse of 0.5 mm.
/// let ramp = Exponential::new(0.016, 0.008, 0.25)?;
/// let speeds: Vec<_> = ramp.ramp([[4.0], [4.0], [4.0]]).map(|[x]| x).collect();
/// assert_eq!(speeds, [2.0, 3.0, 3.5, 1.75, 0.875, 0.4375, 0.21875, 0.21875]);
/// # Ok::<(), onepulse_plan::after_interpolation::RampError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponential {
    time_constant: f64,
    period: f64,
    threshold: f64,
}

impl Exponential {
    /// A ramp with a time constant and a sample period in seconds, which ends in one step when every axis
    /// has less than `threshold` left, in millimetres: half a pulse, as it is in the textbooks.
    ///
    /// # Errors
    /// A period that is not a positive time, a time constant under a period or over 2⁵² of them, a
    /// threshold that is not a positive length.
    pub fn new(time_constant: f64, period: f64, threshold: f64) -> Result<Self, RampError> {
        if !is_time(period) {
            return Err(RampError::NoPeriod);
        }
        // Also where one of them is no number. A smaller share would change nothing.
        if !(1.0..=2_f64.powi(52)).contains(&(time_constant / period)) {
            return Err(RampError::TimeConstant);
        }
        // Nor would any share of a length that is not normal.
        if !threshold.is_normal() || threshold < 0.0 {
            return Err(RampError::NoThreshold);
        }
        Ok(Self { time_constant, period, threshold })
    }

    /// The increments after the ramp, from standstill to standstill.
    ///
    /// Those that come after the last one that went in fall by 1 − T/τ from period to period, until the
    /// rest is less than the threshold and goes in one step. All of them add up to those that went in.
    pub fn ramp<const AXES: usize>(
        self,
        increments: impl IntoIterator<Item = [f64; AXES]>,
    ) -> impl Iterator<Item = [f64; AXES]> {
        let mut increments = increments.into_iter().fuse();
        let share = self.share();
        let mut left = [0.0; AXES];
        std::iter::from_fn(move || {
            let increment = increments.next();
            if let Some(increment) = increment {
                left = std::array::from_fn(|axis| left[axis] + increment[axis]);
            } else if left == [0.0; AXES] {
                return None;
            } else if !left.iter().any(|l| l.abs() >= self.threshold) {
                return Some(std::mem::replace(&mut left, [0.0; AXES]));
            }
            let out = left.map(|l| l * share);
            left = std::array::from_fn(|axis| left[axis] - out[axis]);
            Some(out)
        })
    }

    /// The contour error of a circle: what its radius loses, in millimetres, to a speed in mm/s, after the
    /// start has died away.
    ///
    /// With the angle of a period θ = v·T/R, the ramp takes the points of the circle to one about the same
    /// centre, of the radius R/√(1 + q), q = 4·(τ/T)·(τ/T − 1)·sin²(θ/2). For short periods that is the
    /// continuous lag's R·(1 − 1/√(1 + (ωτ)²)), ω = v/R, and where that is small, τ²v²/(2R).
    #[must_use]
    pub fn circle_error(&self, radius: f64, speed: f64) -> f64 {
        let ratio = self.time_constant / self.period;
        let sine = (speed / radius * self.period / 2.0).sin();
        let q = 4.0 * ratio * (ratio - 1.0) * sine * sine;
        // 1 − 1/√(1 + q) without the difference.
        let root = (1.0 + q).sqrt();
        radius * q / (root * (1.0 + root))
    }

    /// The contour error of a corner of 90° between two lines: the largest distance from their path, in
    /// millimetres, gone round at a steady speed in mm/s, with a point in the corner itself.
    ///
    /// The first axis has D = v·(τ − T) left at the corner and j periods later D·(1 − α)^j; the other one is
    /// then v·j·T − D·(1 − (1 − α)^j) along its line. The less of the two is the distance, most where they
    /// are level: at j·T = τ − T, where it is D·(1 − T/τ)^(τ/T − 1), or between the two samples about that.
    /// For short periods that is v·τ/e.
    #[must_use]
    pub fn corner_error(&self, speed: f64) -> f64 {
        let periods = self.time_constant / self.period - 1.0;
        let share = self.share();
        // From the sample before, straight to the one after.
        let kept = (1.0 - share).powf(periods.floor()) * (1.0 - periods.fract() * share);
        speed * periods * self.period * kept
    }

    fn share(&self) -> f64 {
        self.period / self.time_constant
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{corner_distance, radius_after};
    use super::*;
    use proptest::prelude::*;

    const PERIOD: f64 = 0.008;

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

        #[test]
        fn a_circle_loses_what_the_formula_says(
            radius in 1.0..500.0,
            angle in 0.01..0.5,
            ratio in 1.1..50.0,
        ) {
            let ramp = Exponential::new(ratio * PERIOD, PERIOD, 0.0005).unwrap();
            // (1 − 1/50)^2000 < 10⁻¹⁷.
            let loss = radius - radius_after(radius, angle, 2000, |way| ramp.ramp(way));
            let expected = ramp.circle_error(radius, radius * angle / PERIOD);
            prop_assert!((loss / expected - 1.0).abs() < 1e-6, "{} {}", loss, expected);
        }

        #[test]
        fn a_corner_is_cut_as_the_formula_says(step in 0.01..10.0, ratio in 1.1..20.0) {
            let ramp = Exponential::new(ratio * PERIOD, PERIOD, 0.0005).unwrap();
            // (1 − 1/20)^600 < 10⁻¹³.
            let distance = corner_distance(step, 600, 100, |way| ramp.ramp(way));
            let expected = ramp.corner_error(step / PERIOD);
            // What may lie between the points looked at.
            prop_assert!(distance <= expected * (1.0 + 1e-9) && distance > expected - step / 100.0);
        }

        /// The k-th speed of a steady command, and the last ones.
        #[test]
        fn speeds_rise_and_fall_exponentially(ratio in 1.0..50.0, count in 1..100_u32) {
            let ramp = Exponential::new(ratio * PERIOD, PERIOD, 0.0005).unwrap();
            let out: Vec<_> = ramp.ramp((0..count).map(|_| [1.0])).map(|[x]| x).collect();
            let keep = |k: f64| f64::powf(1.0 - 1.0 / ratio, k);
            for k in 0..count {
                prop_assert!((out[k as usize] - (1.0 - keep(f64::from(k) + 1.0))).abs() < 1e-12);
            }
            let top = out[count as usize - 1];
            for (k, speed) in out[count as usize..out.len().max(count as usize + 1) - 1].iter().enumerate() {
                prop_assert!((speed - top * keep(k as f64 + 1.0)).abs() < 1e-12);
                // The rest before it was no end yet: the share of it is what came out.
                prop_assert!(speed * ratio >= 0.0005 * (1.0 - 1e-9));
            }
            prop_assert!(out.len() == count as usize || out[out.len() - 1] < 0.0005);
        }
    }

    #[test]
    fn corners_with_a_whole_number_of_periods_are_exact() {
        for ratio in [2.0, 3.0, 10.0, 50.0] {
            let ramp = Exponential::new(ratio * PERIOD, PERIOD, 0.0005).unwrap();
            let distance = corner_distance(1.0, 2000, 1, |way| ramp.ramp(way));
            assert!((distance / ramp.corner_error(1.0 / PERIOD) - 1.0).abs() < 1e-9, "{ratio}");
        }
    }

    #[test]
    fn short_periods_come_near_the_textbook() {
        let (radius, speed, time_constant): (f64, f64, f64) = (50.0, 100.0, 0.05);
        for period in [0.001, 0.0001] {
            let ramp = Exponential::new(time_constant, period, 0.0005).unwrap();
            let omega_tau = speed / radius * time_constant;
            let continuous = radius * (1.0 - 1.0 / (1.0 + omega_tau * omega_tau).sqrt());
            let textbook = (time_constant * speed).powi(2) / (2.0 * radius);
            // Less by T/τ: 2 % and 0.2 %.
            let short = 1.0 - period / time_constant;
            let circle = ramp.circle_error(radius, speed);
            assert!((circle / continuous - short).abs() < 1e-3 * short, "{}", circle / continuous);
            assert!((circle / textbook - short).abs() < 1e-2, "{}", circle / textbook);
            // Less by T/(2τ).
            let corner = ramp.corner_error(speed) / (speed * time_constant / std::f64::consts::E);
            assert!((corner - 1.0 + period / time_constant / 2.0).abs() < 1e-3, "{corner}");
        }
        // No lag where the time constant is the period.
        let none = Exponential::new(0.008, 0.008, 0.0005).unwrap();
        assert_eq!((none.circle_error(radius, speed), none.corner_error(speed)), (0.0, 0.0));
    }
}
