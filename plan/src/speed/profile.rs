//! The speed over one block.

use super::limits::largest;
use super::ramp::Ramp;
use super::{Limits, Quantity, SpeedError};
use std::time::Duration;

/// Where a block is on its way at some time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// The way so far, in millimetres from the block's start.
    pub way: f64,
    /// The instantaneous speed (瞬时速度), mm/s.
    pub speed: f64,
    /// The acceleration along the path, mm/s²; negative while braking. Where it jumps within the
    /// block, that before.
    pub acceleration: f64,
}

/// The speed over one block: from the entry speed up to the block's steady speed (稳定速度), or as near to it
/// as the length allows, on at that, and from the deceleration point (减速点) down to the exit speed. The
/// ramps are linear, or S-curves with no acceleration at the block's ends.
///
/// ```
/// use onepulse_plan::speed::{Limits, Profile};
/// let limits = Limits::new(1000.0, None, 10.0, 1000.0)?;
/// let profile = Profile::new(20.0, 0.0, 50.0, 100.0, &limits)?;
/// // 0.1 s and 5 mm up, (100² − 50²)/2000 = 3.75 mm and 0.05 s down, 11.25 mm between.
/// assert!((profile.duration() - (0.1 + 0.1125 + 0.05)).abs() < 1e-12);
/// assert_eq!(profile.at(profile.duration()).way, 20.0);
/// # Ok::<(), onepulse_plan::speed::SpeedError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Profile {
    length: f64,
    entry: f64,
    exit: f64,
    peak: f64,
    rise: Ramp,
    fall: Ramp,
    duration: f64,
}

impl Profile {
    /// The profile over `length` millimetres between two speeds, never over `steady`; all in mm/s.
    ///
    /// # Errors
    /// A length or a steady speed that is not between 10⁻¹² and 10¹²; an entry or exit speed that is
    /// not between 0 and the steady speed; a length under [`Limits::way`] between the two.
    pub fn new(
        length: f64,
        entry: f64,
        exit: f64,
        steady: f64,
        limits: &Limits,
    ) -> Result<Self, SpeedError> {
        let length = SpeedError::in_range(Quantity::Length, length)?;
        let steady = SpeedError::in_range(Quantity::SteadySpeed, steady)?;
        for speed in [entry, exit] {
            if !(0.0..=steady).contains(&speed) {
                return Err(SpeedError::NotBelowSteady { speed, steady });
            }
        }
        let needed = limits.way(entry, exit);
        if needed > length {
            return Err(SpeedError::TooShort { length, needed });
        }
        Ok(Self::joined(length, entry, exit, steady, limits))
    }

    /// That of a dwell: so long at rest.
    ///
    /// ```
    /// use onepulse_plan::speed::Profile;
    /// let dwell = Profile::standing(std::time::Duration::from_millis(250));
    /// assert_eq!(dwell.duration(), 0.25);
    /// assert_eq!((dwell.at(0.1).way, dwell.at(0.1).speed), (0.0, 0.0));
    /// ```
    #[must_use]
    pub fn standing(duration: Duration) -> Self {
        let (rise, fall) = (Ramp::none(), Ramp::none());
        let duration = duration.as_secs_f64();
        Self { length: 0.0, entry: 0.0, exit: 0.0, peak: 0.0, rise, fall, duration }
    }

    /// The profile between two speeds that are known to be joined within the length.
    pub(super) fn joined(length: f64, entry: f64, exit: f64, steady: f64, limits: &Limits) -> Self {
        debug_assert!(entry.max(exit) <= steady && limits.way(entry, exit) <= length);
        let fits = |peak: f64| limits.way(entry, peak) + limits.way(peak, exit) <= length;
        let peak = if fits(steady) {
            steady
        } else if limits.jerk().is_none() {
            // Half of what the length and both ends give: (2·f² − f_a² − f_e²)/(2a) is the length.
            let squares = entry * entry + exit * exit;
            let peak = (limits.acceleration() * length + squares / 2.0).sqrt();
            largest(peak.min(steady), entry.max(exit), fits)
        } else {
            bisected(entry.max(exit), steady, fits)
        };
        let (rise, fall) = (Ramp::new(entry, peak, limits), Ramp::new(exit, peak, limits));
        // Of a lower peak than the steady speed, what rounding left.
        let even = (length - rise.way() - fall.way()).max(0.0) / peak;
        let duration = rise.time() + even + fall.time();
        Self { length, entry, exit, peak, rise, fall, duration }
    }

    /// The block's length, mm.
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// The speed at the block's start, mm/s.
    #[must_use]
    pub const fn entry(&self) -> f64 {
        self.entry
    }

    /// The speed at the block's end, mm/s.
    #[must_use]
    pub const fn exit(&self) -> f64 {
        self.exit
    }

    /// The highest speed, mm/s: the steady speed unless the block is too short for that.
    #[must_use]
    pub const fn peak(&self) -> f64 {
        self.peak
    }

    /// How long the block takes, in seconds.
    #[must_use]
    pub const fn duration(&self) -> f64 {
        self.duration
    }

    /// The state `time` seconds after the block's start; before it that of the start, and after the
    /// block's end that of the end.
    #[must_use]
    pub fn at(&self, time: f64) -> State {
        let time = time.clamp(0.0, self.duration);
        let left = self.duration - time;
        let state = if time <= self.rise.time() {
            self.rise.at(time)
        } else if left >= self.fall.time() {
            // From the end back, so that the fall follows without a jump.
            let way = self.length - self.fall.way() - self.peak * (left - self.fall.time());
            State { way: way.max(self.rise.way()), speed: self.peak, acceleration: 0.0 }
        } else {
            let State { way, speed, acceleration } = self.fall.at(left);
            State { way: self.length - way, speed, acceleration: -acceleration }
        };
        if left > 0.0 { state } else { State { way: self.length, speed: self.exit, ..state } }
    }
}

/// Where `fits` ends to hold between `low`, for which it does, and `high`, for which it does not: the last
/// number before.
fn bisected(mut low: f64, mut high: f64, fits: impl Fn(f64) -> bool) -> f64 {
    loop {
        let middle = low + (high - low) / 2.0;
        if middle <= low || middle >= high {
            return low;
        }
        if fits(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn limits_of(acceleration: f64, jerk: Option<f64>) -> Limits {
        Limits::new(acceleration, jerk, 1.0, 1.0).unwrap()
    }

    fn assert_near(found: f64, expected: f64) {
        assert!((found - expected).abs() <= 1e-9 * expected.abs(), "{found} is not {expected}");
    }

    #[test]
    fn a_trapezoid_brakes_at_the_deceleration_point() {
        // s = (100² − 20²)/(2·500) = 9.6 mm before the end; 0.12 s and 9.6 mm up as well.
        let profile = Profile::new(50.0, 20.0, 20.0, 100.0, &limits_of(500.0, None)).unwrap();
        assert_eq!(profile.peak(), 100.0);
        assert_near(profile.duration(), 0.16 + (50.0 - 19.2) / 100.0 + 0.16);
        let point = profile.at(profile.duration() - 0.16 - 1e-12);
        assert_near(point.way, 50.0 - 9.6);
        assert_eq!((point.speed, point.acceleration), (100.0, 0.0));
        let braking = profile.at(profile.duration() - 0.08);
        assert_near(braking.speed, 60.0);
        assert_eq!(braking.acceleration, -500.0);
        assert_near(profile.at(0.1).speed, 70.0);
        assert_near(profile.at(0.1).way, 20.0 * 0.1 + 500.0 * 0.01 / 2.0);
    }

    #[test]
    fn a_short_trapezoid_is_a_triangle() {
        // 2f² = 2aL + f_a² + f_e².
        let profile = Profile::new(5.0, 30.0, 10.0, 100.0, &limits_of(500.0, None)).unwrap();
        let peak = ((2.0 * 500.0 * 5.0 + 900.0 + 100.0) / 2.0_f64).sqrt();
        assert_near(profile.peak(), peak);
        assert_near(profile.duration(), (2.0 * peak - 40.0) / 500.0);
        let top = profile.at((peak - 30.0) / 500.0);
        assert_near(top.speed, peak);
        assert_near(top.way, (peak * peak - 900.0) / 1000.0);
    }

    #[test]
    fn an_s_curve_has_seven_phases() {
        // Up: 0.1 s of jerk, 0.1 s of acceleration, 0.1 s of jerk: 200 mm/s after 0.3 s and 30 mm.
        let profile = Profile::new(100.0, 0.0, 0.0, 200.0, &limits_of(1000.0, Some(1e4))).unwrap();
        assert_eq!(profile.peak(), 200.0);
        assert_near(profile.duration(), 0.3 + 40.0 / 200.0 + 0.3);
        let expected = [
            (0.05, 1e4 * 0.05_f64.powi(3) / 6.0, 12.5, 500.0),
            (0.1, 10.0 / 6.0, 50.0, 1000.0),
            (0.15, 10.0 / 6.0 + 50.0 * 0.05 + 1.25, 100.0, 1000.0),
            (0.25, 30.0 - 200.0 * 0.05 + 1e4 * 0.05_f64.powi(3) / 6.0, 187.5, 500.0),
            (0.4, 50.0, 200.0, 0.0),
            (0.55, 70.0 + 200.0 * 0.05 - 1e4 * 0.05_f64.powi(3) / 6.0, 187.5, -500.0),
            (0.65, 100.0 - 10.0 / 6.0 - 50.0 * 0.05 - 1.25, 100.0, -1000.0),
            (0.75, 100.0 - 1e4 * 0.05_f64.powi(3) / 6.0, 12.5, -500.0),
        ];
        for (time, way, speed, acceleration) in expected {
            let state = profile.at(time);
            assert_near(state.way, way);
            assert_near(state.speed, speed);
            assert!((state.acceleration - acceleration).abs() < 1e-6, "{time}: {state:?}");
        }
    }

    /// From rest to rest there are closed forms.
    #[test]
    fn short_s_curves_have_the_peak_of_the_closed_form() {
        let limits = limits_of(1000.0, Some(1e4));
        // Without the limit of the acceleration: L = 2·v·√(v/j).
        for length in [1e-9, 1e-3, 0.1, 1.0, 19.9] {
            let profile = Profile::new(length, 0.0, 0.0, 1e3, &limits).unwrap();
            let peak = (length * 100.0 / 2.0).powf(2.0 / 3.0);
            assert_near(profile.peak(), peak);
            assert_near(profile.duration(), 4.0 * (peak / 1e4).sqrt());
        }
        // With it: L = v·(v/a + a/j).
        for length in [20.1, 100.0, 1000.0] {
            let profile = Profile::new(length, 0.0, 0.0, 1e3, &limits).unwrap();
            let peak = -50.0 + (2500.0 + 1000.0 * length).sqrt();
            assert_near(profile.peak(), peak);
            assert_near(profile.duration(), 2.0 * (peak / 1000.0 + 0.1));
        }
    }

    #[test]
    fn what_cannot_be_joined_is_refused() {
        let linear = limits_of(1000.0, None);
        let new = |length, entry, exit| Profile::new(length, entry, exit, 100.0, &linear);
        // 100²/2000 = 5 mm.
        assert!(new(5.0, 100.0, 0.0).is_ok());
        let too_short = SpeedError::TooShort { length: 4.999, needed: 5.0 };
        assert_eq!(new(4.999, 100.0, 0.0), Err(too_short));
        assert_eq!(new(4.999, 0.0, 100.0), Err(too_short));
        for speed in [-1.0, 100.1, f64::INFINITY] {
            let refused = SpeedError::NotBelowSteady { speed, steady: 100.0 };
            assert_eq!(new(50.0, speed, 0.0), Err(refused));
            assert_eq!(new(50.0, 0.0, speed), Err(refused));
        }
        assert!(new(50.0, f64::NAN, 0.0).is_err());
        for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(new(length, 0.0, 0.0).is_err());
        }
        assert!(Profile::new(1.0, 0.0, 0.0, 0.0, &linear).is_err());
    }

    /// Lengths and speeds over many magnitudes; the ends joined, some with nothing to spare.
    fn any_profile() -> impl Strategy<Value = (Profile, f64, Limits)> {
        let limits = (1.0..5.0_f64, prop::option::of(2.0..8.0_f64));
        let shares = (0.0..1.0_f64, prop_oneof![Just(0.0), 0.0..1.0_f64, Just(1.0)]);
        (limits, -7.0..3.0_f64, -1.0..3.0_f64, shares, any::<bool>()).prop_map(
            |((acceleration, jerk), length, steady, (low, between), is_braking)| {
                let power = |digits: f64| 10_f64.powf(digits);
                let limits = limits_of(power(acceleration), jerk.map(power));
                let (length, steady) = (power(length), power(steady));
                let low = low * steady;
                let most = limits.reach(low, length).min(steady);
                let high = (low + between * (most - low)).min(most);
                let (entry, exit) = if is_braking { (high, low) } else { (low, high) };
                let profile = Profile::new(length, entry, exit, steady, &limits).unwrap();
                (profile, steady, limits)
            },
        )
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1000) })]

        #[test]
        fn differences_keep_the_limits((profile, steady, limits) in any_profile()) {
            const PIECES: u32 = 500;
            let duration = profile.duration();
            let start = profile.at(0.0);
            prop_assert_eq!((start.way, start.speed), (0.0, profile.entry()));
            let end = profile.at(duration);
            prop_assert_eq!((end.way, end.speed), (profile.length(), profile.exit()));
            let dt = duration / f64::from(PIECES);
            let acceleration = limits.acceleration();
            // What a few roundings of the speed, the way and the time come to.
            let noise = 8.0 * f64::EPSILON * steady;
            let far = 8.0 * f64::EPSILON * (profile.length() + steady * duration);
            let mut last = start;
            for k in 1..=PIECES {
                let state = profile.at(duration * f64::from(k) / f64::from(PIECES));
                prop_assert!(0.0 <= state.speed && state.speed <= steady);
                prop_assert!(state.acceleration.abs() <= acceleration * (1.0 + 1e-12));
                let gained = state.speed - last.speed;
                prop_assert!(gained.abs() <= acceleration * dt * (1.0 + 1e-9) + noise, "{}", gained);
                let way = state.way - last.way;
                prop_assert!(way >= -far);
                // The mean of both speeds, but for what an acceleration that turns round between adds.
                let mean = (state.speed + last.speed) / 2.0 * dt;
                prop_assert!((way - mean).abs() <= acceleration * dt * dt / 4.0 * (1.0 + 1e-9) + far);
                if let Some(jerk) = limits.jerk() {
                    let change = state.acceleration - last.acceleration;
                    let noise_of_change = 8.0 * f64::EPSILON * (acceleration + jerk * duration);
                    prop_assert!(change.abs() <= jerk * dt * (1.0 + 1e-9) + noise_of_change);
                    let mean = (state.acceleration + last.acceleration) / 2.0 * dt;
                    prop_assert!((gained - mean).abs() <= jerk * dt * dt / 4.0 * (1.0 + 1e-9) + noise);
                }
                last = state;
            }
            if limits.jerk().is_some() {
                prop_assert_eq!((start.acceleration, end.acceleration), (0.0, 0.0));
            }
        }

        /// No higher peak fits: by the way of the rise and the fall as numbers of the textbook.
        #[test]
        fn the_peak_is_the_highest((profile, steady, limits) in any_profile()) {
            let way = |change: f64, sum: f64| match limits.jerk() {
                None => sum * change / (2.0 * limits.acceleration()),
                Some(jerk) => {
                    let rounding = (limits.acceleration() / jerk).min((change / jerk).sqrt());
                    sum / 2.0 * (rounding + change / (jerk * rounding))
                }
            };
            let needed = |peak: f64| -> f64 {
                [profile.entry(), profile.exit()].map(|v| if peak > v { way(peak - v, peak + v) } else { 0.0 })
                    .iter().sum()
            };
            prop_assert!(needed(profile.peak()) <= profile.length() * (1.0 + 1e-12));
            prop_assert!(
                profile.peak() == steady
                    || needed(profile.peak() * (1.0 + 1e-9)) > profile.length()
            );
        }

        #[test]
        fn a_high_jerk_comes_near_the_trapezoid((profile, steady, limits) in any_profile(), share in 0.0..1.0) {
            // Its rounding takes a/j of time, at each of four places.
            let (a, jerk) = (limits.acceleration(), 1e12);
            let trapezoid = limits_of(a, None);
            let s_curve = limits_of(a, Some(jerk));
            // From rest to rest, which any length allows.
            let linear = Profile::new(profile.length(), 0.0, 0.0, steady, &trapezoid).unwrap();
            let smooth = Profile::new(profile.length(), 0.0, 0.0, steady, &s_curve).unwrap();
            let later = smooth.duration() - linear.duration();
            prop_assert!((-1e-12 * linear.duration()..=4.0 * a / jerk + 1e-9 * linear.duration()).contains(&later));
            let time = share * linear.duration();
            let (one, other) = (linear.at(time), smooth.at(time));
            prop_assert!((one.speed - other.speed).abs() <= 4.0 * a * a / jerk + 1e-9 * steady);
        }
    }
}
