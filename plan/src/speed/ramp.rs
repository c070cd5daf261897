//! One change of speed, upwards. Downwards it runs backwards in time.

use super::{Limits, State};

/// The rise from one speed to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ramp {
    low: f64,
    high: f64,
    /// The acceleration of its middle; none if the speeds are equal.
    acceleration: f64,
    /// The time in which the acceleration rises, and in which it falls; none if linear.
    rounding: f64,
    jerk: f64,
    time: f64,
    way: f64,
}

impl Ramp {
    /// The rise from `low` to `high`, which is not below it.
    pub(super) fn new(low: f64, high: f64, limits: &Limits) -> Self {
        let (time, way) = (limits.time(low, high), limits.way(low, high));
        let (acceleration, rounding, jerk) = match limits.jerk() {
            _ if time <= 0.0 => (0.0, 0.0, 0.0),
            None => (limits.acceleration(), 0.0, 0.0),
            Some(jerk) => {
                let rounding = (limits.acceleration() / jerk).min(time / 2.0);
                (jerk * rounding, rounding, jerk)
            }
        };
        Self { low, high, acceleration, rounding, jerk, time, way }
    }

    /// None at all, at rest.
    pub(super) const fn none() -> Self {
        Self {
            low: 0.0,
            high: 0.0,
            acceleration: 0.0,
            rounding: 0.0,
            jerk: 0.0,
            time: 0.0,
            way: 0.0,
        }
    }

    /// How long it takes, in seconds.
    pub(super) const fn time(&self) -> f64 {
        self.time
    }

    /// How far it takes, in millimetres.
    pub(super) const fn way(&self) -> f64 {
        self.way
    }

    /// The state after `time`, which is between 0 and [`Ramp::time`].
    pub(super) fn at(&self, time: f64) -> State {
        let Self { low, high, acceleration, rounding, jerk, .. } = *self;
        let left = self.time - time;
        if left < rounding {
            // Counted from the end, to end exactly there.
            return State {
                way: self.way - left * (high - jerk * left * left / 6.0),
                speed: high - jerk * left * left / 2.0,
                acceleration: jerk * left,
            };
        }
        if time < rounding {
            return State {
                way: time * (low + jerk * time * time / 6.0),
                speed: low + jerk * time * time / 2.0,
                acceleration: jerk * time,
            };
        }
        let even = time - rounding;
        let gained = acceleration * rounding / 2.0;
        let speed = low + gained + acceleration * even;
        // Rounding may not pass the end.
        let way = low * time + gained * (rounding / 3.0 + even) + acceleration * even * even / 2.0;
        State { way: way.min(self.way), speed: speed.min(high), acceleration }
    }
}
