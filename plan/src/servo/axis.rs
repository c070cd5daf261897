//! An axis with its position loop.

use super::drive::Drive;
use super::{ServoError, Settings, stable_gain};

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

    /// What makes it.
    #[must_use]
    pub const fn settings(&self) -> Settings {
        self.settings
    }

    pub(super) fn at_rest(settings: Settings) -> Self {
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

    /// The present position, in millimetres from where it began.
    #[must_use]
    pub const fn position(&self) -> f64 {
        self.position
    }

    /// The present speed, in mm/s.
    #[must_use]
    pub const fn speed(&self) -> f64 {
        self.speed
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

    /// The contour error of a circle: what its radius loses, in millimetres, to a speed in mm/s, after the
    /// start has died away.
    ///
    /// Two such axes make a circle of the radius R·|G(exp(jθ))| of it, with θ = v·T/R, the angle of a
    /// period. The loss is negative where the loop's resonance makes the circle larger.
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

/// The contour error of a line, in millimetres, at a steady speed in mm/s, where the gains of the two axes,
/// in 1/s, differ: v·sin(2α)/2·(1/K₁ − 1/K₂), with the angle α of the line from the first axis in radians.
/// To the left of the motion if positive.
///
/// Each axis is behind by its own v/K_v; equal gains leave the point on the line.
#[must_use]
pub fn line_error(speed: f64, angle: f64, gains: [f64; 2]) -> f64 {
    speed * (2.0 * angle).sin() / 2.0 * (gains[0].recip() - gains[1].recip())
}

#[cfg(test)]
mod tests {
    use super::super::tests::{PERIOD, axis, drives};
    use super::*;
    use proptest::prelude::*;

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
                state = axis.step(way * f64::from(k));
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
                let (sin, cos) = f64::sin_cos(angle * f64::from(k));
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
                    let way = speed * PERIOD * f64::from(k);
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
    }

    #[test]
    fn unequal_gains_make_an_ellipse_of_a_circle() {
        let mut axes = [axis(0.0, 0.1), axis(0.0, 0.2)];
        let (radius, speed) = (50.0, 2000.0);
        // An axis follows a cosine with the amplitude and the lag of its own transfer function.
        let reach = axes.map(|axis| radius - axis.radius_loss(radius, speed));
        let mut most = [0.0_f64; 2];
        for k in 0..100_000 {
            let (sin, cos) = (speed / radius * PERIOD * f64::from(k)).sin_cos();
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
}
