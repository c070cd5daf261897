//! What the machine bears, and the way and time that a change of speed takes with it.

use super::{Quantity, SpeedError};

/// What the machine bears.
///
/// Each limit holds by itself. The acceleration and the jerk are those along the path; across it there
/// are the corner's limit, where the direction jumps, and the centripetal one, on arcs. Where a line and an
/// arc meet with one tangent there is no corner, though the centripetal acceleration jumps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    acceleration: f64,
    jerk: Option<f64>,
    corner: f64,
    centripetal: f64,
}

impl Limits {
    /// The limits of the acceleration in mm/s², of the jerk in mm/s³ (without one, speed changes linearly,
    /// and the acceleration jumps; with one, along an S-curve), of the jump of the velocity in a corner
    /// in mm/s, and of the centripetal acceleration in mm/s².
    ///
    /// # Errors
    /// A number that is not between 10⁻¹² and 10¹².
    pub fn new(
        acceleration: f64,
        jerk: Option<f64>,
        corner: f64,
        centripetal: f64,
    ) -> Result<Self, SpeedError> {
        Ok(Self {
            acceleration: SpeedError::in_range(Quantity::Acceleration, acceleration)?,
            jerk: jerk.map(|jerk| SpeedError::in_range(Quantity::Jerk, jerk)).transpose()?,
            corner: SpeedError::in_range(Quantity::Corner, corner)?,
            centripetal: SpeedError::in_range(Quantity::Centripetal, centripetal)?,
        })
    }

    /// The largest acceleration along the path, mm/s².
    #[must_use]
    pub const fn acceleration(&self) -> f64 {
        self.acceleration
    }

    /// The largest jerk along the path, mm/s³.
    #[must_use]
    pub const fn jerk(&self) -> Option<f64> {
        self.jerk
    }

    /// The highest speed in a corner between two directions, unit vectors: that with which the velocity
    /// jumps by no more than the limit, |v·(u_out − u_in)|. Infinite where there is no corner.
    #[must_use]
    pub fn corner_speed(&self, incoming: [f64; 3], outgoing: [f64; 3]) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|axis| outgoing[axis] - incoming[axis]);
        self.corner / x.hypot(y).hypot(z)
    }

    /// The highest speed on a circle: v²/R is the centripetal acceleration.
    #[must_use]
    pub fn arc_speed(&self, radius: f64) -> f64 {
        (self.centripetal * radius).sqrt()
    }

    /// The time that a change between two speeds takes, in seconds: Δv/a if linear. An S-curve takes a/j
    /// more, as the acceleration rises and falls; or, when it does not reach its limit in that,
    /// 2·√(Δv/j).
    #[must_use]
    pub fn time(&self, from: f64, to: f64) -> f64 {
        let change = (to - from).abs();
        let Some(jerk) = self.jerk else { return change / self.acceleration };
        let rounded = 2.0 * (change / jerk).sqrt();
        if change * jerk < self.acceleration * self.acceleration {
            rounded
        } else {
            // Never less than the other formula, but for rounding: a larger change takes no less time.
            rounded.max(change / self.acceleration + self.acceleration / jerk)
        }
    }

    /// The way that a change between two speeds takes, in millimetres: their mean times the time, as every
    /// change is symmetrical about its middle. For linear changes that is (f_i² − f_e²)/(2a). The
    /// deceleration point (减速点) is this far from where the second speed has to be reached.
    #[must_use]
    pub fn way(&self, from: f64, to: f64) -> f64 {
        (from + to) / 2.0 * self.time(from, to)
    }

    /// The longest way of a change between `high` and any speed from `low` to it.
    ///
    /// With linear changes that is the way between the two. An S-curve can be longer to a speed that
    /// differs less: from 1 to 0 it is 1/√j, from 1 to ⅓ it is 1.09/√j. The way is longest to ⅓ of
    /// `high`, or to a²/(2j) where the acceleration reaches its limit.
    pub(super) fn longest_way(&self, low: f64, high: f64) -> f64 {
        let Some(jerk) = self.jerk else { return self.way(low, high) };
        let longest = (high / 3.0).min(self.half_rounding(jerk));
        // The first as well, for roundings next to the maximum.
        self.way(low, high).max(self.way(low.max(longest), high))
    }

    /// The highest speed from which `low`, and any speed between, is reached within `way`, and the
    /// other way round. The larger `low` is, the higher: that is what the look-ahead builds on, and why
    /// it takes the longest way.
    pub(super) fn reach(&self, low: f64, way: f64) -> f64 {
        let doubled = 2.0 * self.acceleration * way;
        let high = match self.jerk {
            None => (low * low + doubled).sqrt(),
            Some(jerk) => {
                let half = self.half_rounding(jerk);
                // (high + half)² − (low − half)² = 2·a·way, with the `low` of the longest way.
                let long = (doubled + (low - half).max(0.0).powi(2)).sqrt() - half;
                if (long - low.max(half)) * jerk >= self.acceleration * self.acceleration {
                    long
                } else {
                    // The way from a third: (4/3)·high·√(2·high/(3j)).
                    let from_third = 1.5 * (jerk * way * way / 4.0).cbrt();
                    if from_third > 3.0 * low { from_third } else { low + rounding(low, way, jerk) }
                }
            }
        };
        largest(high, low, |high| self.longest_way(low, high) <= way)
    }

    /// Half the change of speed in which the acceleration just reaches its limit: a²/(2j).
    fn half_rounding(&self, jerk: f64) -> f64 {
        self.acceleration * self.acceleration / (2.0 * jerk)
    }
}

/// The change Δv within `way` from `low` that does not reach the acceleration's limit. With s = √Δv the way
/// is (2·low + s²)·s/√j, a cubic in s with one real root, which Cardano's formula gives as a
/// difference; here with positive terms alone, so that no digits cancel.
fn rounding(low: f64, way: f64, jerk: f64) -> f64 {
    let (p, q) = (2.0 * low, way * jerk.sqrt());
    let u = (q / 2.0 + (q * q / 4.0 + p * p * p / 27.0).sqrt()).cbrt();
    let w = p / (3.0 * u);
    let s = q / (u * u + p / 3.0 + w * w);
    s * s
}

/// The largest speed for which `fits` holds, as it does up to some speed, from a guess that is only
/// rounded; not below `floor`, which is known to fit.
pub(super) fn largest(guess: f64, floor: f64, fits: impl Fn(f64) -> bool) -> f64 {
    let (mut speed, mut roundings) = (guess, 1_u64);
    while speed > floor && !fits(speed) {
        speed = f64::from_bits(speed.to_bits().saturating_sub(roundings));
        roundings = roundings.saturating_mul(2);
    }
    speed.max(floor)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn limits(acceleration: f64, jerk: Option<f64>) -> Limits {
        Limits::new(acceleration, jerk, 10.0, 500.0).unwrap()
    }

    fn assert_near(found: f64, expected: f64) {
        assert!((found - expected).abs() <= 1e-12 * expected, "{found} is not {expected}");
    }

    #[test]
    fn what_is_no_limit_is_refused() {
        for value in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-13, 1e13] {
            let refused = |limits: Result<Limits, SpeedError>, named: Quantity| match limits {
                Err(SpeedError::OutOfRange { quantity, .. }) => assert_eq!(quantity, named),
                other => panic!("{value}: {other:?}"),
            };
            refused(Limits::new(value, None, 1.0, 1.0), Quantity::Acceleration);
            refused(Limits::new(1.0, Some(value), 1.0, 1.0), Quantity::Jerk);
            refused(Limits::new(1.0, None, value, 1.0), Quantity::Corner);
            refused(Limits::new(1.0, None, 1.0, value), Quantity::Centripetal);
        }
    }

    #[test]
    fn the_deceleration_point_of_the_textbook() {
        // (100² − 20²)/(2·500), and from rest the same as to it.
        assert_near(limits(500.0, None).way(100.0, 20.0), 9.6);
        assert_near(limits(500.0, None).way(0.0, 100.0), 10.0);
        assert_near(limits(500.0, None).time(100.0, 20.0), 0.16);
    }

    #[test]
    fn s_curves_with_and_without_the_acceleration_s_limit() {
        let limits = limits(1000.0, Some(1e4));
        // 0.1 s of jerk, 0.05 s of acceleration, 0.1 s of jerk: 50 + 50 + 50 mm/s.
        assert_near(limits.time(50.0, 200.0), 0.25);
        assert_near(limits.way(50.0, 200.0), 125.0 * 0.25);
        // 0.05 s of jerk to 500 mm/s², and as much back: 12.5 mm/s each.
        assert_near(limits.time(25.0, 0.0), 0.1);
        assert_near(limits.way(25.0, 0.0), 1.25);
        // Over a short block j·L²/(4v²) more, which is j·L/(4v) a second.
        let gained = limits.reach(100.0, 0.01) - 100.0;
        assert!((gained / (1e4 * 1e-4 / 4e4) - 1.0).abs() < 1e-6, "{gained}");
    }

    #[test]
    fn corners_and_circles() {
        let limits = limits(1000.0, None);
        assert_near(limits.corner_speed([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]), 5.0);
        assert_near(limits.corner_speed([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), 10.0 / 2_f64.sqrt());
        // From a plunge into the plane, and with an angle of 60 degrees in space.
        assert_near(limits.corner_speed([0.0, 0.0, -1.0], [0.6, 0.8, 0.0]), 10.0 / 2_f64.sqrt());
        let half = 0.5_f64.sqrt();
        assert_near(limits.corner_speed([half, half, 0.0], [0.0, half, half]), 10.0);
        assert_eq!(limits.corner_speed([0.6, 0.0, 0.8], [0.6, 0.0, 0.8]), f64::INFINITY);
        assert_near(limits.arc_speed(5.0), 50.0);
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1000) })]

        /// Of the ways from all speeds between, tried one by one.
        #[test]
        fn the_longest_way_is_the_longest(
            low in 0.0..1.0_f64,
            high in -1.0..3.0_f64,
            acceleration in 1.0..5.0_f64,
            jerk in prop::option::of(2.0..8.0_f64),
        ) {
            let power = |digits: f64| 10_f64.powf(digits);
            let limits = limits(power(acceleration), jerk.map(power));
            let (low, high) = (low * power(high), power(high));
            let longest = limits.longest_way(low, high);
            let tried = (0..=1000).map(|k| {
                limits.way(low + (high - low) * f64::from(k) / 1000.0, high)
            }).fold(0.0, f64::max);
            prop_assert!(tried <= longest * (1.0 + 1e-12), "{} {}", tried, longest);
            prop_assert!(tried >= longest * (1.0 - 1e-3), "{} {}", tried, longest);
            // To the last digit, also where all ways are nearly the same.
            for k in 0..100 {
                let low = high / 3.0 * (1.0 - f64::from(k) * 1e-9);
                prop_assert!(limits.way(low, high) <= limits.longest_way(low, high), "{}", k);
            }
        }

        #[test]
        fn what_is_reached_is_the_most(
            low in prop_oneof![Just(0.0), 0.0..1000.0_f64],
            way in -9.0..3.0_f64,
            acceleration in 1.0..5.0_f64,
            jerk in prop::option::of(2.0..8.0_f64),
        ) {
            let power = |digits: f64| 10_f64.powf(digits);
            let limits = limits(power(acceleration), jerk.map(power));
            let way = power(way);
            let high = limits.reach(low, way);
            prop_assert!(high >= low);
            prop_assert!(limits.longest_way(low, high) <= way);
            prop_assert!(limits.longest_way(low, high * (1.0 + 1e-12) + 1e-14) > way, "{}", high);
            // More from more.
            prop_assert!(limits.reach(low * 1.001, way) >= high * (1.0 - 1e-14));
        }
    }
}
