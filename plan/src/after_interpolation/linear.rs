//! The linear ramp.

use super::{RampError, is_time};
use std::collections::VecDeque;

/// Linear acceleration and deceleration after interpolation (直线加减速): each increment is the mean of
/// the last K that came in, for each axis.
///
/// From standstill to a steady speed, and back, the speed runs along a straight line in the ramp time
/// τ = K·T, T the sample period, whatever the speed. An increment that comes in goes out in K equal parts:
/// the last of them K − 1 periods after it, which is when the whole way has gone out.
///
/// A steady speed v is followed at a distance of v·(τ − T)/2.
///
/// ```
/// use onepulse_plan::after_interpolation::Linear;
/// let ramp = Linear::new(4, 0.008)?;
/// let speeds: Vec<_> = ramp.ramp([[4.0]; 5]).map(|[x]| x).collect();
/// assert_eq!(speeds, [1.0, 2.0, 3.0, 4.0, 4.0, 3.0, 2.0, 1.0]);
/// # Ok::<(), onepulse_plan::after_interpolation::RampError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    periods: u32,
    period: f64,
}

impl Linear {
    /// A ramp over so many periods of so many seconds.
    ///
    /// # Errors
    /// No period to ramp over, or one that is not a positive time.
    pub fn new(periods: u32, period: f64) -> Result<Self, RampError> {
        if !is_time(period) {
            return Err(RampError::NoPeriod);
        }
        if periods == 0 {
            return Err(RampError::NoRamp);
        }
        Ok(Self { periods, period })
    }

    /// The increments after the ramp, K − 1 more than went in: K additions a period and axis.
    pub fn ramp<const AXES: usize>(
        self,
        increments: impl IntoIterator<Item = [f64; AXES]>,
    ) -> impl Iterator<Item = [f64; AXES]> {
        let mut increments = increments.into_iter().fuse();
        let mut window = VecDeque::new();
        let mut made = 0;
        std::iter::from_fn(move || {
            if made == self.periods {
                window.pop_front();
            } else {
                made += 1;
            }
            window.extend(increments.next());
            if window.is_empty() {
                return None;
            }
            // Added afresh each time, so that rounding leaves nothing behind.
            let sum = |axis: usize| window.iter().map(|w: &[f64; AXES]| w[axis]).sum::<f64>();
            Some(std::array::from_fn(|axis| sum(axis) / f64::from(self.periods)))
        })
    }

    /// The contour error of a circle: what its radius loses, in millimetres, to a speed in mm/s, after the
    /// start has died away.
    ///
    /// With the angle of a period θ = v·T/R, the ramp takes the points of the circle to one about the same
    /// centre, of the radius R·|sin(K·θ/2)/(K·sin(θ/2))|. For short periods that is the continuous mean's
    /// R·(1 − sin(ωτ/2)/(ωτ/2)), ω = v/R, and where that is small, τ²v²/(24R): a twelfth of what the
    /// exponential ramp of the same τ takes.
    #[must_use]
    pub fn circle_error(&self, radius: f64, speed: f64) -> f64 {
        // The mean of cos(m·θ/2), m = K − 1, K − 3, … 1 − K, which is that quotient; what each of them
        // lacks to 1 is added, as a difference would cancel.
        let half = speed / radius * self.period / 2.0;
        let last = f64::from(self.periods) - 1.0;
        let lack = |j: u32| 2.0 * ((last - 2.0 * f64::from(j)) * half / 2.0).sin().powi(2);
        let loss = (0..self.periods).map(lack).sum::<f64>() / f64::from(self.periods);
        // Past 1 the circle is there again, half a turn behind.
        radius * loss.min(2.0 - loss)
    }

    /// The contour error of a corner of 90° between two lines: the largest distance from their path, in
    /// millimetres, gone round at a steady speed in mm/s, with a point in the corner itself.
    ///
    /// Of the j-th period after the corner, the first axis has v·T·(K − j)·(K − j − 1)/(2K) left, and the
    /// other one is v·T·j·(j + 1)/(2K) along its line. The less of the two is the distance, most where they
    /// are level, at j = (K − 1)/2: v·τ/8, and with an odd K, which has a sample there, 1 − 1/K² of that.
    #[must_use]
    pub fn corner_error(&self, speed: f64) -> f64 {
        let periods = f64::from(self.periods);
        let whole = speed * self.period / 8.0;
        if self.periods % 2 == 0 { whole * periods } else { whole * (periods - periods.recip()) }
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

        /// Also where the mean is over more than half a turn, or several.
        #[test]
        fn a_circle_loses_what_the_formula_says(
            radius in 1.0..500.0,
            angle in 0.01..0.5,
            periods in 2..80_u32,
        ) {
            let ramp = Linear::new(periods, PERIOD).unwrap();
            let loss = radius - radius_after(radius, angle, 200, |way| ramp.ramp(way));
            let found = ramp.circle_error(radius, radius * angle / PERIOD);
            prop_assert!((loss / found - 1.0).abs() < 1e-6, "{} {}", loss, found);
            let x = angle / 2.0;
            let closed = radius * (1.0 - ((f64::from(periods) * x).sin() / (f64::from(periods) * x.sin())).abs());
            prop_assert!((closed / found - 1.0).abs() < 1e-9, "{} {}", closed, found);
        }

        #[test]
        fn a_corner_is_cut_as_the_formula_says(step in 0.01..10.0, periods in 2..100_u32) {
            let ramp = Linear::new(periods, PERIOD).unwrap();
            // Even ones are level in the middle between two samples.
            let distance = corner_distance(step, 200, 2, |way| ramp.ramp(way));
            let expected = ramp.corner_error(step / PERIOD);
            prop_assert!((distance / expected - 1.0).abs() < 1e-9, "{} {}", distance, expected);
            let fine = corner_distance(step, 200, 100, |way| ramp.ramp(way));
            prop_assert!((fine / expected - 1.0).abs() < 1e-9, "{} {}", fine, expected);
        }
    }

    #[test]
    fn a_way_shorter_than_the_ramp_goes_out_all_the_same() {
        let ramp = Linear::new(4, PERIOD).unwrap();
        let out: Vec<_> = ramp.ramp([[4.0, -8.0], [4.0, 0.0]]).collect();
        assert_eq!(out, [[1.0, -2.0], [2.0, -2.0], [2.0, -2.0], [2.0, -2.0], [1.0, 0.0]]);
    }

    #[test]
    fn short_periods_come_near_the_textbook() {
        let (radius, speed, time): (f64, f64, f64) = (50.0, 100.0, 0.05);
        for (periods, within) in [(10, 1.1e-2), (50, 1e-3), (500, 1e-5)] {
            let ramp = Linear::new(periods, time / f64::from(periods)).unwrap();
            let half = speed / radius * time / 2.0;
            let continuous = radius * (1.0 - half.sin() / half);
            let textbook = (time * speed).powi(2) / (24.0 * radius);
            let circle = ramp.circle_error(radius, speed);
            assert!((circle / continuous - 1.0).abs() < within, "{}", circle / continuous);
            assert!((circle / textbook - 1.0).abs() < within + 1e-3, "{}", circle / textbook);
            assert!((ramp.corner_error(speed) / (speed * time / 8.0) - 1.0).abs() < 1e-12);
        }
        // One period is no ramp.
        let none = Linear::new(1, PERIOD).unwrap();
        assert_eq!((none.circle_error(radius, speed), none.corner_error(speed)), (0.0, 0.0));
    }
}
