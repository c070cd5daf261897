//! Acceleration and deceleration after interpolation (后加减速): each axis by itself, on its increments.
//!
//! The interpolator runs at the programmed feed and knows nothing of ramps. What it gives an axis in each
//! sample period goes through a filter, which starts and stops the axis gently and loses nothing: the
//! increments that come out add up to those that went in. All axes here have the same filter. On a line
//! their increments then keep their proportion, and the axes their path. What is left are the contour
//! errors (轮廓误差) of curves and corners:
//!
//! | speed v, ramp time τ, much longer than a period | circle of radius R | corner of 90° |
//! |---|---|---|
//! | [`Exponential`] (指数加减速) | τ²v²/(2R) | v·τ/e = 0.368·v·τ |
//! | [`Linear`] (直线加减速) | τ²v²/(24R) | v·τ/8 |
//!
//! The exact figures, period by period, are those of the methods `circle_error` and `corner_error`. (Those
//! of the circle are FANUC's, with v²/(2R·K_v²) more for the servo loop: [`crate::servo`].)
//!
//! An axis with a time constant of its own has a ramp of its own, `[f64; 1]`, and lines leave their path.

mod exponential;
mod linear;

use std::fmt;

pub use exponential::Exponential;
pub use linear::Linear;

/// The way from each point to the next, the first from `start`.
pub fn increments<const AXES: usize>(
    start: [f64; AXES],
    points: impl IntoIterator<Item = [f64; AXES]>,
) -> impl Iterator<Item = [f64; AXES]> {
    let mut at = start;
    points.into_iter().map(move |point| {
        let before = std::mem::replace(&mut at, point);
        std::array::from_fn(|axis| point[axis] - before[axis])
    })
}

/// The points that increments lead to from `start`, which is not one of them.
pub fn points<const AXES: usize>(
    start: [f64; AXES],
    increments: impl IntoIterator<Item = [f64; AXES]>,
) -> impl Iterator<Item = [f64; AXES]> {
    let mut at = start;
    increments.into_iter().map(move |increment| {
        at = std::array::from_fn(|axis| at[axis] + increment[axis]);
        at
    })
}

/// Why there is no such ramp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RampError {
    /// A sample period that is not a positive time.
    NoPeriod,
    /// A ramp over no period at all.
    NoRamp,
    /// A time constant under a period, or over 2⁵² of them.
    TimeConstant,
    /// A threshold that is not a positive length.
    NoThreshold,
}

impl fmt::Display for RampError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NoPeriod => "the sample period is not a positive time",
            Self::NoRamp => "a ramp takes one sample period or more",
            Self::TimeConstant => "the time constant is less than a sample period, or endless",
            Self::NoThreshold => "the threshold that ends a ramp is not a positive length",
        })
    }
}

impl std::error::Error for RampError {}

/// Whether a time is one that can pass.
fn is_time(seconds: f64) -> bool {
    seconds.is_finite() && seconds > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The radius of the last point of a circle run through a ramp for so many periods.
    pub(super) fn radius_after<I: Iterator<Item = [f64; 2]>>(
        radius: f64,
        angle: f64,
        periods: u32,
        ramp: impl FnOnce(Vec<[f64; 2]>) -> I,
    ) -> f64 {
        let on =
            |k: u32| [radius * (angle * f64::from(k)).cos(), radius * (angle * f64::from(k)).sin()];
        let way = increments(on(0), (1..=periods).map(on)).collect();
        let end = points(on(0), ramp(way)).nth(periods as usize - 1).unwrap();
        end[0].hypot(end[1])
    }

    /// The largest distance from a corner's path of a ramp that goes round it, as found at `cuts` points of
    /// each increment: along x to the origin, and then along y, at a steady `step`.
    pub(super) fn corner_distance<I: Iterator<Item = [f64; 2]>>(
        step: f64,
        leg: u32,
        cuts: u32,
        ramp: impl FnOnce(Vec<[f64; 2]>) -> I,
    ) -> f64 {
        let legs = [[step, 0.0], [0.0, step]];
        let way = legs.into_iter().flat_map(|way| (0..leg).map(move |_| way)).collect();
        let length = step * f64::from(leg);
        let distance = |[x, y]: [f64; 2]| {
            let first = (x - x.clamp(-length, 0.0)).hypot(y);
            let second = x.hypot(y - y.clamp(0.0, length));
            first.min(second)
        };
        let mut at = [-length, 0.0];
        let mut most = 0.0_f64;
        for [dx, dy] in ramp(way) {
            for cut in (1..=cuts).map(|cut| f64::from(cut) / f64::from(cuts)) {
                most = most.max(distance([at[0] + dx * cut, at[1] + dy * cut]));
            }
            at = [at[0] + dx, at[1] + dy];
        }
        most
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(500) })]

        #[test]
        fn nothing_is_lost_and_nothing_added(
            way in prop::collection::vec([-10.0..10.0, -10.0..10.0, 0.0..1e-3], 0..300),
            ratio in 1.0..60.0,
            periods in 1..60_u32,
        ) {
            let end = |ways: Vec<[f64; 3]>| points([0.0; 3], ways).last().unwrap_or_default();
            let asked = end(way.clone());
            let exponential = Exponential::new(0.008 * ratio, 0.008, 0.0005).unwrap();
            let linear = Linear::new(periods, 0.008).unwrap();
            for out in [
                end(exponential.ramp(way.clone()).collect()),
                end(linear.ramp(way.clone()).collect()),
            ] {
                for axis in 0..3 {
                    let whole: f64 = way.iter().map(|w| w[axis].abs()).sum();
                    prop_assert!((out[axis] - asked[axis]).abs() <= 1e-12 * whole);
                }
            }
            let count = linear.ramp(way.clone()).count();
            prop_assert_eq!(count, if way.is_empty() { 0 } else { way.len() + periods as usize - 1 });
        }

        #[test]
        fn a_line_stays_straight(
            end in [-500.0..500.0, -500.0..500.0],
            step in 0.5..20.0,
            ratio in 1.0..60.0,
            periods in 1..60_u32,
        ) {
            let line = crate::sampling::Line::new(end, step).unwrap();
            let exponential = Exponential::new(0.008 * ratio, 0.008, 0.0005).unwrap();
            let linear = Linear::new(periods, 0.008).unwrap();
            let length = end[0].hypot(end[1]);
            let mut ways: [Vec<_>; 2] = [
                exponential.ramp(increments([0.0; 2], line)).collect(),
                linear.ramp(increments([0.0; 2], line)).collect(),
            ];
            for way in &mut ways {
                let mut at = [0.0; 2];
                for point in points([0.0; 2], way.drain(..)) {
                    let across = end[0] * point[1] - end[1] * point[0];
                    prop_assert!(across.abs() <= 1e-11 * length * length);
                    // And never back.
                    let along = end[0] * (point[0] - at[0]) + end[1] * (point[1] - at[1]);
                    prop_assert!(along >= -1e-12 * length * length);
                    at = point;
                }
                prop_assert!((at[0] - end[0]).hypot(at[1] - end[1]) <= 1e-11 * length);
            }
        }
    }

    #[test]
    fn no_number_makes_a_ramp_endless_or_panics() {
        let exponential = Exponential::new(0.08, 0.008, 0.0005).unwrap();
        let linear = Linear::new(u32::MAX, 0.008).unwrap();
        for odd in [f64::NAN, f64::INFINITY, f64::MAX, -0.0] {
            assert!(exponential.ramp([[odd, 1.0], [odd, 1.0]]).count() < 10_000, "{odd}");
            assert_eq!(linear.ramp([[odd, 1.0], [odd, 1.0]]).take(1000).count(), 1000, "{odd}");
        }
    }

    #[test]
    fn what_is_no_ramp_is_refused() {
        let exponential = |time_constant, period, threshold| {
            Exponential::new(time_constant, period, threshold).map(|_| ())
        };
        assert_eq!(exponential(0.008, 0.008, 0.0005), Ok(()));
        for period in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(exponential(0.08, period, 0.0005), Err(RampError::NoPeriod), "{period}");
            assert_eq!(Linear::new(5, period), Err(RampError::NoPeriod), "{period}");
        }
        for time in [0.007, 0.0, -1.0, f64::NAN, f64::INFINITY, 1e14] {
            assert_eq!(exponential(time, 0.008, 0.0005), Err(RampError::TimeConstant), "{time}");
        }
        for threshold in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-310] {
            let refused = Err(RampError::NoThreshold);
            assert_eq!(exponential(0.08, 0.008, threshold), refused, "{threshold}");
        }
        assert_eq!(Linear::new(0, 0.008), Err(RampError::NoRamp));
    }
}
