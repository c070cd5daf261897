//! The sampled position loop of an axis (位置伺服): what a drive makes of the commands.
//!
//! Each sample period T the following error (跟随误差) e = x_c − x, command less measured position, gives
//! the velocity command u = K_v·e, held for the period. The drive follows it as a first-order lag,
//! dv/dt = (u − v)/τ_d, or at once where τ_d = 0, and the position is the integral of v. Both are solved
//! exactly over the period, so that nothing here depends on a step of integration. With s = T/τ_d,
//! a = exp(−s), w = 1 − (1 − a)/s and y = (1 − a)/s − a:
//!
//! ```text
//! x' = x + T·(v + w·(u − v))
//! v' = u + a·(v − u)
//! ```
//!
//! From commands to positions at the same instants that is, with κ = K_v·T, N(z) = κ·(w·z + y) and
//! D(z) = (z − 1)·(z − a) + N(z), the transfer function G(z) = N(z)/D(z). The ideal drive has a = y = 0 and
//! w = 1: G(z) = κ/(z − 1 + κ).
//!
//! A circle through the whole chain: interpolated, ramped and followed.
//!
//! ```
//! use onepulse_core::Direction;
//! use onepulse_plan::after_interpolation::{Linear, increments, points};
//! use onepulse_plan::sampling::{Arc, ArcMethod};
//! use onepulse_plan::servo::{Axis, Settings};
//!
//! // Once round a radius of 20 mm at 100 mm/s, with a gain of 50/s.
//! let (start, speed, period) = ([20.0, 0.0], 100.0, 0.001);
//! let arc = Arc::new(start, start, Direction::Ccw, ArcMethod::SecondOrder, speed * period)?;
//! let ramp = Linear::new(32, period)?;
//! let mut axis = Axis::new(Settings { gain: 50.0, drive_time_constant: 0.0, period })?;
//! let mut axes = [axis, axis];
//!
//! // The axes count their way from the start.
//! let commands = points([0.0; 2], ramp.ramp(increments(start, arc)));
//! let path: Vec<_> = commands
//!     .map(|command| [0, 1].map(|i| axes[i].step(command[i]).position))
//!     .map(|[x, y]| (start[0] + x).hypot(y))
//!     .collect();
//!
//! // Half round, where the start is long forgotten: FANUC's v²/R·(τ²/24 + 1/(2·K_v²)), but for the period.
//! let ramped = 20.0 - ramp.circle_error(20.0, speed);
//! let followed = ramped - axis.radius_loss(ramped, speed / 20.0 * ramped);
//! assert!((path[path.len() / 2] - followed).abs() < 1e-6);
//! let rule: f64 = 100.0 * 100.0 / 20.0 * (0.032 * 0.032 / 24.0 + 1.0 / (2.0 * 50.0 * 50.0));
//! assert!((rule / (20.0 - followed) - 1.0).abs() < 0.06);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::fmt;

/// What makes a position loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The position loop's gain K_v in 1/s: velocity commanded for each millimetre of following error.
    pub gain: f64,
    /// The drive's time constant τ_d in seconds; 0 is an ideal drive.
    pub drive_time_constant: f64,
    /// The sample period T in seconds.
    pub period: f64,
}

/// Why there is no such loop.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ServoError {
    /// A gain that is not a positive number.
    NoGain,
    /// A time constant that is negative or not finite.
    NoDrive,
    /// A sample period that is not a positive time.
    NoPeriod,
    /// A gain with which the loop would not come to rest.
    Unstable {
        /// The gain in 1/s.
        gain: f64,
        /// What it has to be below, in 1/s.
        limit: f64,
    },
}

impl fmt::Display for ServoError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoGain => f.write_str("the gain is not a positive number"),
            Self::NoDrive => f.write_str("the drive's time constant is negative or not finite"),
            Self::NoPeriod => f.write_str("the sample period is not a positive time"),
            Self::Unstable { gain, limit } => write!(
                f,
                "with a gain of {gain}/s the axis would not come to rest: take less than {limit}/s or a \
                 shorter period"
            ),
        }
    }
}

impl std::error::Error for ServoError {}

/// An axis after a sample period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// At the end of the period, in millimetres.
    pub position: f64,
    /// At the end of the period, in mm/s.
    pub speed: f64,
    /// At its start: the command less the position measured then, in millimetres.
    pub following_error: f64,
    /// From its start to its end, in mm/s.
    pub velocity_command: f64,
}

/// An axis with its position loop.
///
/// ```
/// use onepulse_plan::servo::{Axis, Settings};
/// let mut axis = Axis::new(Settings { gain: 100.0, drive_time_constant: 0.0, period: 0.002 })?;
/// let positions = [1.0, 1.0, 1.0].map(|command| axis.step(command).position);
/// assert_eq!(positions, [0.2, 0.36, 0.488]); // K_v·T = 1/5 of what is left each time
/// # Ok::<(), onepulse_plan::servo::ServoError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    settings: Settings,
    drive: Drive,
    position: f64,
    speed: f64,
}

impl Axis {
    /// An axis at rest in position 0.
    ///
    /// The gain has to be less than that of [`stable_gain`].
    ///
    /// # Errors
    /// A gain or a period that is not positive, a time constant that is negative; any that is not finite;
    /// a gain with which the loop is not stable.
    pub fn new(settings: Settings) -> Result<Self, ServoError> {
        let Settings { gain, drive_time_constant, period } = settings;
        if !gain.is_finite() || gain <= 0.0 {
            return Err(ServoError::NoGain);
        }
        if !drive_time_constant.is_finite() || drive_time_constant < 0.0 {
            return Err(ServoError::NoDrive);
        }
        if !period.is_finite() || period <= 0.0 {
            return Err(ServoError::NoPeriod);
        }
        let limit = stable_gain(drive_time_constant, period);
        if gain >= limit {
            return Err(ServoError::Unstable { gain, limit });
        }
        Ok(Self::at_rest(settings))
    }

    fn at_rest(settings: Settings) -> Self {
        let drive = Drive::new(settings.drive_time_constant, settings.period);
        Self { settings, drive, position: 0.0, speed: 0.0 }
    }

    /// The next sample period, with the position commanded at its start, in millimetres.
    pub fn step(&mut self, command: f64) -> State {
        let Settings { gain, period, .. } = self.settings;
        let following_error = command - self.position;
        let velocity_command = gain * following_error;
        let behind = velocity_command - self.speed;
        self.position += period * (self.speed + self.drive.way * behind);
        self.speed += self.drive.rise * behind;
        State { position: self.position, speed: self.speed, following_error, velocity_command }
    }

    /// The following error at a steady speed in mm/s: v/K_v, in millimetres.
    ///
    /// Exactly that, whatever the period and the drive, where it is taken as the loop takes it, command and
    /// position at the same instant: nothing changes then but the positions, so u = v. At the end of the
    /// period, with the axis v·T further and the next command not there yet, it is v/K_v − v·T; over the
    /// whole period v/K_v − v·T/2 on average.
    #[must_use]
    pub const fn steady_error(&self, speed: f64) -> f64 {
        speed / self.settings.gain
    }

    /// What a circle's radius loses, in millimetres, to a speed in mm/s, after the start has died away: two
    /// such axes make a circle of the radius R·|G(exp(jθ))| of it, with θ = v·T/R, the angle of a period.
    /// Less than nothing where the loop's resonance makes it larger.
    ///
    /// Where θ and v/(R·K_v) are small, v²/(2R)·(1/K_v² − (T + 2·τ_d)/K_v): without a period and with an
    /// ideal drive the textbooks' v²/(2R·K_v²).
    #[must_use]
    pub fn radius_loss(&self, radius: f64, speed: f64) -> f64 {
        let Settings { gain, period, .. } = self.settings;
        let Drive { rise, way, after, .. } = self.drive;
        let sine = (speed / radius * period / 2.0).sin();
        let h = 2.0 * sine * sine;
        let (p, q) = (gain * period * way, gain * period * after);
        // With h = 1 − cos θ, |N|² = (p + q)² − 2pqh, and |D|² − |N|² = |D − N|² + 2·Re((D − N)·N*) with
        // what would cancel in it left out; a = 1 − rise.
        let fall = 1.0 - rise;
        let squares = rise * rise + 2.0 * fall * h;
        let lag = 2.0 * h * (squares - p * (1.0 + fall) - q * (2.0 + rise - 2.0 * h));
        let n_squared = (p + q) * (p + q) - 2.0 * p * q * h;
        let (n, d) = (n_squared.sqrt(), (n_squared + lag).sqrt());
        radius * lag / (d * (d + n))
    }
}

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
/// Up to here both roots of D(z) are real and positive, so that the pulse response of 1/D(z) has no
/// negative term, nor has G(z) with it; beyond, they are complex and the axis swings. The discriminant
/// (1 + a − κ·w)² − 4·(a + κ·y) is zero at κ = (1 − a)²/(b + √(b² − w²·(1 − a)²)), b = w·(1 + a) + 2y. For
/// the ideal drive that is κ = 1. For short periods it is the textbooks' 4·K_v·τ_d = 1; of a sampled loop
/// that asks a little too much: 4·K_v·(τ_d + T/4) ≤ 1 or so is needed.
#[must_use]
pub fn aperiodic_gain(drive_time_constant: f64, period: f64) -> f64 {
    let Drive { rise, way, after } = Drive::new(drive_time_constant, period);
    let b = way * (2.0 - rise) + 2.0 * after;
    // b² − w²(1 − a)² without the difference.
    let root = (2.0 * (way * (1.0 - rise) + after) * (b + way * rise)).sqrt();
    rise * rise / (b + root) / period
}

/// How far two axes are off a line, in millimetres, at a steady speed in mm/s, if their gains in 1/s differ:
/// v·sin(2α)/2·(1/K₁ − 1/K₂), with the angle α of the line from the first axis in radians. To the left of
/// the motion, if positive.
///
/// Each axis is behind by its own v/K_v; equal gains leave the point on the line.
#[must_use]
pub fn line_error(speed: f64, angle: f64, gains: [f64; 2]) -> f64 {
    speed * (2.0 * angle).sin() / 2.0 * (gains[0].recip() - gains[1].recip())
}

/// What the drive does in a period, for T = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Drive {
    /// Of a step of the velocity command, what the speed has made of it at the end: 1 − a.
    rise: f64,
    /// And what of the way: w.
    way: f64,
    /// What of the way a command of one period adds to the next, over what it would without the lag: y.
    after: f64,
}

impl Drive {
    fn new(time_constant: f64, period: f64) -> Self {
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
            after += term * (n as f64 + 1.0);
            term *= -s / (n as f64 + 3.0);
        }
        Self { rise, way, after }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const PERIOD: f64 = 0.001;

    /// A drive from ideal to slow, in periods.
    fn drives() -> impl Strategy<Value = f64> {
        prop_oneof![Just(0.0), 0.01..1.0, 1.0..20.0]
    }

    fn settings(drive_time_constant: f64, gain: f64) -> Settings {
        Settings { gain, drive_time_constant, period: PERIOD }
    }

    /// A loop with a share of the stable gain.
    fn axis(drive: f64, share: f64) -> Axis {
        let time_constant = drive * PERIOD;
        Axis::new(settings(time_constant, share * stable_gain(time_constant, PERIOD))).unwrap()
    }

    #[test]
    fn what_is_no_loop_is_refused() {
        let new = |gain, drive_time_constant, period| {
            Axis::new(Settings { gain, drive_time_constant, period }).map(|_| ())
        };
        assert_eq!(new(30.0, 0.01, 0.001), Ok(()));
        for odd in [-1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(new(odd, 0.01, 0.001), Err(ServoError::NoGain), "{odd}");
            assert_eq!(new(30.0, odd, 0.001), Err(ServoError::NoDrive), "{odd}");
            assert_eq!(new(30.0, 0.01, odd), Err(ServoError::NoPeriod), "{odd}");
        }
        assert_eq!(new(0.0, 0.01, 0.001), Err(ServoError::NoGain));
        assert_eq!(new(30.0, 0.01, 0.0), Err(ServoError::NoPeriod));
        // The ideal drive's K_v·T < 2.
        let unstable = ServoError::Unstable { gain: 500.0, limit: 500.0 };
        assert_eq!(new(500.0, 0.0, 0.004), Err(unstable));
        assert_eq!(new(499.0, 0.0, 0.004), Ok(()));
        for time in [f64::MIN_POSITIVE, 5e-324, 1e300, f64::MAX] {
            let limit = stable_gain(time, 0.004);
            assert!((limit / 500.0 - 1.0).abs() < 1e-12, "{time}: {limit}");
        }
    }

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

        /// The drive's equation, integrated by small steps of fourth order.
        #[test]
        fn a_period_is_the_drive_solved(
            drive in 0.05..20.0,
            command in -10.0..10.0,
            speed in -1000.0..1000.0,
        ) {
            let mut found = axis(drive, 0.3);
            found.speed = speed;
            let state = found.step(command);
            let u = found.settings.gain * command;
            prop_assert_eq!((state.following_error, state.velocity_command), (command, u));
            let (mut x, mut v, step) = (0.0, speed, PERIOD / 4000.0);
            for _ in 0..4000 {
                let slope = |v: f64| (u - v) / (drive * PERIOD);
                let v2 = v + step / 2.0 * slope(v);
                let v3 = v + step / 2.0 * slope(v2);
                let v4 = v + step * slope(v3);
                x += step / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
                v += step / 6.0 * (slope(v) + 2.0 * slope(v2) + 2.0 * slope(v3) + slope(v4));
            }
            let most = u.abs().max(speed.abs());
            prop_assert!((state.position - x).abs() < 1e-9 * most * PERIOD, "{} {}", state.position, x);
            prop_assert!((state.speed - v).abs() < 1e-9 * most, "{} {}", state.speed, v);
        }

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

        #[test]
        fn a_ramp_is_followed_at_the_steady_error(
            drive in drives(),
            share in 0.05..0.8,
            speed in -500.0..500.0,
        ) {
            let mut axis = axis(drive, share);
            let way = speed * PERIOD;
            let mut state = axis.step(0.0);
            for k in 1..=20_000 {
                state = axis.step(way * k as f64);
            }
            let error = axis.steady_error(speed);
            let within = 1e-9 * error.abs() + 1e-15 * (way * 20_000.0).abs();
            prop_assert!((state.following_error - error).abs() < within);
            // At the end of the period, before the next command.
            let end = way * 20_000.0 - state.position;
            prop_assert!((end - (error - way)).abs() < within + 1e-9 * way.abs());
            prop_assert!((state.speed - speed).abs() < 1e-9 * speed.abs());
        }

        #[test]
        fn a_circle_loses_what_the_formula_says(
            drive in drives(),
            share in 0.05..0.8,
            radius in 1.0..500.0,
            angle in 0.001..1.0,
        ) {
            let mut axes = [axis(drive, share); 2];
            let loss = axes[0].radius_loss(radius, radius * angle / PERIOD);
            for k in 0..20_000 {
                let (sin, cos) = f64::sin_cos(angle * k as f64);
                let [x, y] = [radius * cos, radius * sin];
                let at = [axes[0].step(x).position, axes[1].step(y).position];
                if k >= 19_990 {
                    let found = at[0].hypot(at[1]);
                    prop_assert!((found - (radius - loss)).abs() < 1e-9 * radius, "{} {}", found, loss);
                }
            }
        }

        /// Small angles against the leading term, and what the textbooks leave out of it.
        #[test]
        fn slow_circles_come_near_the_textbook(drive in drives(), share in 0.05..0.8) {
            let axis = axis(drive, share);
            let Settings { gain, drive_time_constant, .. } = axis.settings;
            let (radius, speed) = (100.0, 100.0 * gain * 1e-4);
            let scale = speed * speed / (2.0 * radius * gain * gain);
            let expected = scale * (1.0 - gain * (PERIOD + 2.0 * drive_time_constant));
            let loss = axis.radius_loss(radius, speed);
            // The next term has v/(R·K_v) = 10⁻⁴ squared, and powers of K_v·τ_d.
            let powers = (1.0 + gain * (PERIOD + drive_time_constant)).powi(4);
            prop_assert!((loss - expected).abs() < 1e-8 * scale * powers, "{} {}", loss, expected);
        }

        #[test]
        fn unequal_gains_leave_a_line_and_equal_ones_do_not(
            drive in drives(),
            shares in [0.05..0.8, 0.05..0.8],
            angle in 0.0..std::f64::consts::TAU,
            speed in 1.0..500.0,
        ) {
            let off = |shares: [f64; 2]| {
                let mut axes = shares.map(|share| axis(drive, share));
                let (sin, cos) = angle.sin_cos();
                let mut at = [0.0; 2];
                for k in 0..20_000 {
                    let way = speed * PERIOD * k as f64;
                    at = [axes[0].step(way * cos).position, axes[1].step(way * sin).position];
                }
                (cos * at[1] - sin * at[0], line_error(speed, angle, axes.map(|a| a.settings.gain)))
            };
            let (found, expected) = off(shares);
            prop_assert!((found - expected).abs() < 1e-11 * speed, "{} {}", found, expected);
            let (found, expected) = off([shares[0]; 2]);
            prop_assert_eq!(expected, 0.0);
            prop_assert!(found.abs() < 1e-11 * speed, "{}", found);
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
    fn unequal_gains_make_an_ellipse_of_a_circle() {
        let mut axes = [axis(0.0, 0.1), axis(0.0, 0.2)];
        let (radius, speed) = (50.0, 2000.0);
        // An axis follows a cosine with the amplitude and the lag of its own transfer function.
        let reach = axes.map(|axis| radius - axis.radius_loss(radius, speed));
        let mut most = [0.0_f64; 2];
        for k in 0..100_000 {
            let (sin, cos) = (speed / radius * PERIOD * k as f64).sin_cos();
            let at = [axes[0].step(radius * cos).position, axes[1].step(radius * sin).position];
            if k > 1000 {
                most = [most[0].max(at[0]), most[1].max(at[1])];
            }
        }
        // The nearest of so many samples to the top misses it by little.
        for i in 0..2 {
            assert!((most[i] / reach[i] - 1.0).abs() < 1e-6, "{most:?} {reach:?}");
        }
        assert!(reach[1] - reach[0] > 0.5, "{reach:?}");
    }

    #[test]
    fn the_textbooks_aperiodic_gain_asks_too_much_of_a_sampled_loop() {
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
