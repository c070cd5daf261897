//! The motion, sample period by sample period.

use super::{Profile, Quantity, SpeedError, State};

/// The motion at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The time since the program's start, in seconds.
    pub time: f64,
    /// The block, from 0; a dwell counts as one.
    pub block: usize,
    /// The way in it so far, in millimetres.
    pub way: f64,
    /// The instantaneous speed (瞬时速度), mm/s: not a mean of the period.
    pub speed: f64,
    /// The acceleration along the path, mm/s²; negative while braking. Where it jumps, that before the
    /// time.
    pub acceleration: f64,
    /// Whether the time is a whole number of sample periods.
    pub is_on_grid: bool,
    /// Whether the block ends here: its way is the block's length, its speed the exit speed.
    pub is_block_end: bool,
}

/// The motion through all blocks at each whole sample period, from the first period's end on, and at
/// each block's end.
///
/// The periods run on through the blocks: the first sample of a block is what is left of a period after
/// the end before, so there is no short last step, and with no corner the speed does not dip. The end
/// points are records of their own, at their own times; nothing cuts a corner. A short block may have no
/// other record. A period that ends within a millionth of itself of a block's end is taken to end there.
/// A dwell is a block in which nothing moves ([`Profile::standing`]): the periods run on through it too.
#[derive(Clone, Debug)]
pub struct Samples<I> {
    profiles: I,
    period: f64,
    /// The block under way.
    profile: Option<Profile>,
    block: usize,
    /// The time of its start.
    start: f64,
    /// Whole periods until the next sample on the grid.
    periods: u64,
}

impl<I: Iterator<Item = Profile>> Samples<I> {
    /// The samples of these blocks' profiles, with a period in seconds.
    ///
    /// # Errors
    /// A period that is not between 10⁻¹² and 10¹².
    pub fn new(
        profiles: impl IntoIterator<Item = Profile, IntoIter = I>,
        period: f64,
    ) -> Result<Self, SpeedError> {
        let period = SpeedError::in_range(Quantity::Period, period)?;
        let mut profiles = profiles.into_iter();
        let profile = profiles.next();
        Ok(Self { profiles, period, profile, block: 0, start: 0.0, periods: 1 })
    }
}

impl<I: Iterator<Item = Profile>> Iterator for Samples<I> {
    type Item = Sample;

    fn next(&mut self) -> Option<Sample> {
        let profile = self.profile?;
        let due = self.periods as f64 * self.period;
        let left = profile.duration() - (due - self.start);
        let nearly = self.period * 1e-6;
        // The block-end test (终点判别).
        let is_block_end = left <= nearly;
        let is_on_grid = left >= -nearly;
        let (block, start) = (self.block, self.start);
        if is_on_grid {
            self.periods += 1;
        }
        let within = if is_block_end {
            self.profile = self.profiles.next();
            self.block += 1;
            self.start += profile.duration();
            profile.duration()
        } else {
            due - start
        };
        let State { way, speed, acceleration } = profile.at(within);
        let time = if is_block_end { self.start } else { due };
        Some(Sample { time, block, way, speed, acceleration, is_on_grid, is_block_end })
    }
}
