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

mod axis;
mod drive;
mod gain;

use std::fmt;

pub use axis::{Axis, State, line_error};
pub use gain::{aperiodic_gain, stable_gain};

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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    pub(super) const PERIOD: f64 = 0.001;

    /// A drive from ideal to slow, in periods.
    pub(super) fn drives() -> impl Strategy<Value = f64> {
        prop_oneof![Just(0.0), 0.01..1.0, 1.0..20.0]
    }

    pub(super) fn settings(drive_time_constant: f64, gain: f64) -> Settings {
        Settings { gain, drive_time_constant, period: PERIOD }
    }

    /// A loop with a share of the stable gain.
    pub(super) fn axis(drive: f64, share: f64) -> Axis {
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
}
