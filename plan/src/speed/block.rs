//! A block as its speed sees it.

use super::{Limits, Path, Quantity, SpeedError};
use crate::{Machine, Motion, Rate};

/// A block as its speed sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    length: f64,
    steady: f64,
    start_direction: [f64; 3],
    end_direction: [f64; 3],
    is_stopping: bool,
}

impl Block {
    /// A block of this length in millimetres with a steady speed (稳定速度) in mm/s, that starts and ends in
    /// these directions, unit vectors.
    ///
    /// # Errors
    /// A length or a speed that is not between 10⁻¹² and 10¹²; a direction whose length is not 1 to nine
    /// digits.
    pub fn new(
        length: f64,
        steady: f64,
        start_direction: [f64; 3],
        end_direction: [f64; 3],
    ) -> Result<Self, SpeedError> {
        let length = SpeedError::in_range(Quantity::Length, length)?;
        let steady = SpeedError::in_range(Quantity::SteadySpeed, steady)?;
        let is_unit = |[x, y, z]: [f64; 3]| (x.hypot(y).hypot(z) - 1.0).abs() <= 1e-9;
        if !is_unit(start_direction) || !is_unit(end_direction) {
            return Err(SpeedError::NoDirection);
        }
        Ok(Self { length, steady, start_direction, end_direction, is_stopping: false })
    }

    /// The block of a motion. Its steady speed is the commanded one, or less on an arc, where the
    /// centripetal acceleration limits it: v ≤ √(a·R).
    ///
    /// # Errors
    /// As [`Path::of`] and [`Block::new`].
    pub fn of(motion: &Motion, machine: &Machine, limits: &Limits) -> Result<Self, SpeedError> {
        let path = Path::of(motion, machine.pulse)?;
        let feed = match motion.rate {
            Rate::Rapid => machine.rapid,
            Rate::Feed(feed) => feed,
        };
        let commanded = feed.millimetres() / 60.0;
        let steady = match path.radius() {
            None => commanded,
            Some(radius) => commanded.min(limits.arc_speed(radius)),
        };
        let [start, end] = path.directions();
        Self::new(path.length(), steady, start, end)
    }

    /// The same block with the machine at rest at its end, wherever the next one goes: before a dwell or
    /// a program stop.
    #[must_use]
    pub const fn stopping(self) -> Self {
        Self { is_stopping: true, ..self }
    }

    /// Its length in millimetres.
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// Its steady speed in mm/s.
    #[must_use]
    pub const fn steady(&self) -> f64 {
        self.steady
    }

    /// The highest speed in the corner between this block and the next one.
    pub(super) fn corner_speed(&self, next: &Self, limits: &Limits) -> f64 {
        if self.is_stopping {
            return 0.0;
        }
        let corner = limits.corner_speed(self.end_direction, next.start_direction);
        corner.min(self.steady).min(next.steady)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Curve;
    use onepulse_core::{Direction, Plane};

    #[test]
    fn the_steady_speed_is_the_feed_or_what_the_circle_allows() {
        let machine = Machine::with_pulse("0.01".parse().unwrap());
        let limits = Limits::new(1000.0, None, 1.0, 500.0).unwrap();
        let steady = |curve, rate| {
            let motion = Motion { line: 1, from: [500, 0, 0], to: [0, 500, 0], curve, rate };
            Block::of(&motion, &machine, &limits).unwrap().steady()
        };
        let feed = |text: &str| Rate::Feed(text.parse().unwrap());
        let arc = Curve::Arc { plane: Plane::Xy, centre: [0, 0], direction: Direction::Ccw };
        assert_eq!(steady(Curve::Line, feed("1500")), 25.0);
        assert_eq!(steady(Curve::Line, Rate::Rapid), 50.0);
        assert_eq!(steady(arc, feed("1500")), 25.0);
        // v²/R = 50²/5 is the limit.
        assert_eq!(steady(arc, feed("6000")), 50.0);
    }

    #[test]
    fn what_is_no_block_is_refused() {
        let along = [1.0, 0.0, 0.0];
        let refused = |quantity, value| Err(SpeedError::OutOfRange { quantity, value });
        assert_eq!(Block::new(0.0, 1.0, along, along), refused(Quantity::Length, 0.0));
        assert_eq!(Block::new(1.0, -1.0, along, along), refused(Quantity::SteadySpeed, -1.0));
        assert!(Block::new(f64::NAN, 1.0, along, along).is_err());
        assert!(Block::new(1.0, f64::INFINITY, along, along).is_err());
        for wrong in [
            [0.0; 3],
            [1.0, 0.0, 0.1],
            [1.0, 0.1, 0.0],
            [0.0, f64::NAN, 0.0],
            [0.0, 0.0, f64::INFINITY],
        ] {
            assert_eq!(Block::new(1.0, 1.0, wrong, along), Err(SpeedError::NoDirection));
            assert_eq!(Block::new(1.0, 1.0, along, wrong), Err(SpeedError::NoDirection));
        }
        // A line that is none.
        let machine = Machine::with_pulse("0.01".parse().unwrap());
        let limits = Limits::new(1000.0, None, 1.0, 500.0).unwrap();
        let (curve, rate) = (Curve::Line, Rate::Rapid);
        let motion = Motion { line: 1, from: [5, 0, 0], to: [5, 0, 0], curve, rate };
        assert_eq!(Block::of(&motion, &machine, &limits), refused(Quantity::Length, 0.0));
    }
}
