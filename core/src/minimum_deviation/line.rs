//! Straight line by minimum deviation.

use crate::pulse::signed;
use crate::{Error, Pulse};

/// A line from the origin, any number of axes.
///
/// The axis with the longest way, |e_M|, gets a pulse on every step. Every other one gets a pulse too
/// when it would be more than half a pulse behind without: d_i = 2·(k·|e_i| − |e_M|·p_i) after k steps
/// and p_i pulses grows by 2·|e_i|, and a pulse takes 2·|e_M| from it as soon as it exceeds |e_M|. So
/// −|e_M| < d_i ≤ |e_M|: no axis is ever more than ½ from the line, and as d_i would be a multiple of
/// 2·|e_M| after |e_M| steps, it is zero then. The deviation of the path is ½·√(AXES − 1) at most; (2,1)
/// is half a pulse off its line after one step, measured along y.
///
/// ```
/// use onepulse_core::{Pulse, minimum_deviation::Line};
/// let line = Line::new([5, 3])?;
/// let y = line.map(|Pulse([_, y])| y);
/// assert!(y.eq([1, 0, 1, 0, 1]));
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line<const AXES: usize = 2> {
    /// d_i; of the longest axis, 0.
    deviation: [i64; AXES],
    /// Absolute end coordinates.
    end: [u32; AXES],
    sign: [i8; AXES],
    /// Pulses still to come, an axis each.
    left: [u32; AXES],
    longest: u32,
    /// Steps still to come.
    steps: u32,
}

impl<const AXES: usize> Line<AXES> {
    /// The line to `end`: any `i32` coordinates.
    ///
    /// # Errors
    /// None: every end point is served. (All machines of this crate are built alike.)
    pub fn new(end: [i32; AXES]) -> Result<Self, Error> {
        let magnitude = end.map(i32::unsigned_abs);
        let longest = magnitude.iter().fold(0, |most, c| (*c).max(most));
        Ok(Self {
            deviation: [0; AXES],
            end: magnitude,
            sign: end.map(|c| c.signum() as i8),
            left: magnitude,
            longest,
            steps: longest,
        })
    }

    /// The line to `end` in this state, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn in_state(
        end: [i32; AXES],
        longest: u32,
        deviation: [i64; AXES],
        left: [u32; AXES],
        steps: u32,
    ) -> Self {
        let (end, sign) = (end.map(i32::unsigned_abs), end.map(|c| c.signum() as i8));
        Self { deviation, end, sign, left, longest, steps }
    }

    /// A pulse on the longest axis, and on every axis that would be left behind; `None` once the
    /// end is reached.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse<AXES>> {
        if self.steps == 0 {
            return None;
        }
        let longest = i64::from(self.longest);
        let mut pulse = Pulse::NONE;
        for axis in 0..AXES {
            // Of the longest axis this is 2·|e_M|, and so a pulse on every step.
            let due = self.deviation[axis] + 2 * i64::from(self.end[axis]);
            let feeds = due > longest;
            self.deviation[axis] = if feeds { due - 2 * longest } else { due };
            self.left[axis] -= u32::from(feeds);
            pulse.0[axis] = if feeds { self.sign[axis] } else { 0 };
        }
        self.steps -= 1;
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// What each axis is behind the line (above 0) or ahead of it: d_i, 2·|e_M| to the pulse.
    #[must_use]
    pub const fn deviations(&self) -> [i64; AXES] {
        self.deviation
    }

    /// The way of the longest axis, |e_M|.
    #[must_use]
    pub const fn longest(&self) -> u32 {
        self.longest
    }

    /// Whether the end is reached.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.steps == 0
    }

    /// Steps still to come.
    #[must_use]
    pub const fn remaining(&self) -> u64 {
        self.steps as u64
    }

    /// Pulses of each axis between here and the end point.
    #[must_use]
    pub fn pulses_to_go(&self) -> [u64; AXES] {
        self.left.map(u64::from)
    }

    /// The present point, counted from the line's start.
    #[must_use]
    pub fn position(&self) -> [i64; AXES] {
        core::array::from_fn(|axis| {
            signed(self.sign[axis], i64::from(self.end[axis]) - i64::from(self.left[axis]))
        })
    }

    /// What is missing to the end point: zero when done.
    #[must_use]
    pub fn residual(&self) -> [i64; AXES] {
        core::array::from_fn(|axis| signed(self.sign[axis], i64::from(self.left[axis])))
    }

    /// What always holds: −|e_M| < d_i ≤ |e_M|, and no more is to go than at the start.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let longest = i64::from(self.longest);
        self.steps <= self.longest
            && (0..AXES).all(|axis| {
                let d = self.deviation[axis];
                (-longest < d || longest == 0 && d == 0)
                    && d <= longest
                    && self.end[axis] <= self.longest
                    && self.left[axis] <= self.end[axis]
            })
    }
}

impl<const AXES: usize> Iterator for Line<AXES> {
    type Item = Pulse<AXES>;

    #[inline]
    fn next(&mut self) -> Option<Pulse<AXES>> {
        self.step()
    }
}
