//! What a path is like, in sums that do not grow with it.

use super::truth::Truth;
use super::variants::Variant;
use crate::machine::{Refusal, Visitor};
use onepulse_core::Pulse;
use onepulse_hwmodel::Circuit;

/// A path about to be measured.
pub(super) struct Measure<'a> {
    pub(super) truth: Truth,
    pub(super) end: Vec<i64>,
    pub(super) variant: &'a Variant,
    /// The points of the path, for a picture of it: few.
    pub(super) path: Option<&'a mut Vec<[i64; 2]>>,
}

/// What came of it.
#[derive(Clone, Debug)]
pub(super) struct Measured {
    pub(super) cycles: u64,
    pub(super) axes: Vec<AxisMeasured>,
    /// In pulses, over the cycles that emit one.
    pub(super) largest_deviation: f64,
    pub(super) rms_deviation: f64,
    /// None of a curve without length.
    pub(super) feed: Option<Feed>,
}

/// What came of an axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct AxisMeasured {
    pub(super) pulses: u64,
    /// What is missing to the end point.
    pub(super) residual: i64,
    /// None of fewer than two pulses.
    pub(super) jitter: Option<f64>,
}

/// v/v_max.
#[derive(Clone, Copy, Debug)]
pub(super) struct Feed {
    pub(super) mean: f64,
    pub(super) least: f64,
    pub(super) largest: f64,
}

impl Visitor for Measure<'_> {
    type Output = Measured;

    fn visit<S, C, const N: usize>(
        mut self,
        software: S,
        _: impl FnOnce() -> Result<C, Refusal>,
        start: [i64; N],
    ) -> Measured
    where
        S: Iterator<Item = Pulse<N>>,
        C: Circuit<N>,
    {
        let mut position = start;
        let mut intervals = [Intervals::default(); N];
        let mut speeds = Speeds::new(self.truth.length());
        let (mut points, mut largest, mut squares) = (0_u64, 0.0_f64, 0.0);
        let mut cycles = 0;
        for pulse in software {
            cycles += 1;
            if pulse.is_none() {
                continue;
            }
            for axis in 0..N {
                position[axis] += i64::from(pulse.0[axis]);
                if pulse.0[axis] != 0 {
                    intervals[axis].pulse(cycles);
                }
            }
            let reached = self.truth.reach(position);
            points += 1;
            largest = largest.max(reached.distance);
            squares += reached.distance.powi(2);
            speeds.reach(cycles, reached.way);
            if let Some(path) = &mut self.path {
                path.push([position[0], position[1]]);
            }
        }
        // The fastest: a pulse on every axis that a cycle may feed.
        let fastest = if self.variant.feeds_together() { (N as f64).sqrt() } else { 1.0 };
        let axis = |axis: usize| AxisMeasured {
            pulses: intervals[axis].pulses,
            residual: self.end[axis] - position[axis],
            jitter: intervals[axis].jitter(),
        };
        Measured {
            cycles,
            axes: (0..N).map(axis).collect(),
            largest_deviation: largest,
            rms_deviation: (squares / points.max(1) as f64).sqrt(),
            feed: speeds.finish(cycles, fastest),
        }
    }
}

/// The cycles between the pulses of an axis.
#[derive(Clone, Copy, Debug, Default)]
struct Intervals {
    pulses: u64,
    first: u64,
    last: u64,
    squares: u128,
}

impl Intervals {
    fn pulse(&mut self, cycle: u64) {
        if self.pulses == 0 {
            self.first = cycle;
        } else {
            self.squares += u128::from(cycle - self.last).pow(2);
        }
        self.last = cycle;
        self.pulses += 1;
    }

    /// Standard deviation by mean: √(n·Σd² − (Σd)²)/Σd.
    fn jitter(&self) -> Option<f64> {
        let count = self.pulses.checked_sub(1).filter(|count| *count > 0)?;
        let sum = u128::from(self.last - self.first);
        let variance = u128::from(count) * self.squares - sum * sum;
        Some((variance as f64).sqrt() / sum as f64)
    }
}

/// The parts of a curve in which the speed is taken: at most so many, and at least so long, for a
/// path is a pulse or two ahead or behind here and there.
const PARTS: f64 = 360.0;
const PART: f64 = 32.0;

/// The speed of a path along its curve, part by part, in pulses a cycle.
#[derive(Clone, Copy, Debug)]
struct Speeds {
    length: f64,
    parts: f64,
    /// The part that the path is in, from 1.
    part: f64,
    /// Where it began.
    start: (u64, f64),
    here: f64,
    least: f64,
    largest: f64,
}

impl Speeds {
    fn new(length: f64) -> Self {
        let parts = (length / PART).floor().clamp(1.0, PARTS);
        let (least, largest) = (f64::INFINITY, 0.0);
        Self { length, parts, part: 1.0, start: (0, 0.0), here: 0.0, least, largest }
    }

    /// Takes how far the path is.
    fn reach(&mut self, cycle: u64, way: f64) {
        self.here = way;
        if self.part < self.parts && way * self.parts >= self.length * self.part {
            self.end_part(cycle);
            self.part += 1.0;
            self.start = (cycle, way);
        }
    }

    fn end_part(&mut self, cycle: u64) {
        let (since, from) = self.start;
        if cycle > since {
            let speed = (self.here - from) / (cycle - since) as f64;
            self.least = self.least.min(speed);
            self.largest = self.largest.max(speed);
        }
    }

    /// Relative to the fastest.
    fn finish(mut self, cycles: u64, fastest: f64) -> Option<Feed> {
        if cycles == 0 || self.length <= 0.0 {
            return None;
        }
        let mean = self.length / cycles as f64;
        if self.parts > 1.0 {
            self.end_part(cycles);
        } else {
            (self.least, self.largest) = (mean, mean);
        }
        let [mean, least, largest] = [mean, self.least, self.largest].map(|v| v / fastest);
        Some(Feed { mean, least, largest })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jitter_of_known_intervals() {
        let jitter = |cycles: &[u64]| {
            let mut intervals = Intervals::default();
            cycles.iter().for_each(|cycle| intervals.pulse(*cycle));
            intervals.jitter()
        };
        assert_eq!(jitter(&[]), None);
        assert_eq!(jitter(&[7]), None);
        assert_eq!(jitter(&[7, 9]), Some(0.0));
        assert_eq!(jitter(&[1, 3, 5, 7]), Some(0.0));
        // 1 and 3: their mean is 2, their standard deviation 1.
        assert_eq!(jitter(&[1, 2, 5]), Some(0.5));
        assert_eq!(jitter(&[0, u64::from(u32::MAX) << 8]), Some(0.0));
    }

    #[test]
    fn the_speed_of_each_half() {
        // The first half at a pulse a cycle, the second at a half.
        let mut speeds = Speeds::new(64.0);
        for cycle in 1..=32 {
            speeds.reach(cycle, cycle as f64);
        }
        for step in 1..=32_u64 {
            speeds.reach(32 + 2 * step, 32.0 + step as f64);
        }
        let feed = speeds.finish(96, 2.0).unwrap();
        assert_eq!([feed.mean, feed.least, feed.largest], [1.0 / 3.0, 0.25, 0.5]);
    }
}
