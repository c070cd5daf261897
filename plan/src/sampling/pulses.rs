//! From points in millimetres to pulses.

/// Rounds the points of a block to pulses: of each sample those between the whole ways so far, each
/// rounded by itself, so that what is rounded away is carried forward and nothing is lost.
///
/// ```
/// use onepulse_plan::sampling::Pulses;
/// let mut pulses = Pulses::new(0.01, [0.0]);
/// let each: Vec<_> = [0.004, 0.008, 0.012].map(|x| pulses.to([x])[0]).into();
/// assert_eq!(each, [0, 1, 0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulses<const AXES: usize = 2> {
    pulse: f64,
    at: [i64; AXES],
}

impl<const AXES: usize> Pulses<AXES> {
    /// From `start`, in pulses of so many millimetres.
    #[must_use]
    pub fn new(pulse: f64, start: [f64; AXES]) -> Self {
        Self { pulse, at: start.map(|c| Self::rounded(c, pulse)) }
    }

    /// The pulses of the sample that leads to `point`.
    pub fn to(&mut self, point: [f64; AXES]) -> [i64; AXES] {
        let at = point.map(|c| Self::rounded(c, self.pulse));
        let pulses = std::array::from_fn(|axis| at[axis] - self.at[axis]);
        self.at = at;
        pulses
    }

    /// The present point in pulses.
    #[must_use]
    pub const fn position(&self) -> [i64; AXES] {
        self.at
    }

    fn rounded(c: f64, pulse: f64) -> i64 {
        (c / pulse).round() as i64
    }
}
