//! Straight line in space by point-by-point comparison.

use crate::pulse::signed;
use crate::{Error, Pulse};

/// A line from the origin, any number of axes, one pulse a step.
///
/// The longest axis M leads (the earliest of the longest). Each other axis i is compared with it
/// in absolute coordinates: F_i = |e_M|·p_i − |e_i|·p_M, negative where it is behind. If any is, the
/// one furthest behind is fed, the smallest F_i (the earliest of the smallest), and |e_M| added to
/// it; if none is, M is fed, and every F_i loses its |e_i|.
///
/// Always −|e_i| ≤ F_i < |e_M|: M is fed when all F_i ≥ 0, and i when F_i < 0. So in the projection on
/// each plane (i, M) the point is within |F_i|/|e_M| ≤ 1 of the line along i, as on a plane
/// [`Line`](super::Line), and in space less than √(AXES − 1) pulses from it. With three axes that
/// bound, √2, is approached and not reached: (1, 1, 7) has 1.188 at (1, 1, 1), and (1, 1, n) comes
/// as near to √2 as one likes.
///
/// No axis is fed past its end: F_i ≥ 0 for an axis that has none of its pulses left, and when M
/// has none left, F_i ≥ 0 for all means that they have none either. So the line ends exactly, after
/// as many steps as all axes have pulses.
///
/// ```
/// use onepulse_core::{Pulse, ppc};
/// let mut line = ppc::SpaceLine::new([1, -3, 2])?;
/// assert_eq!(line.step(), Some(Pulse([0, -1, 0]))); // all are level, y leads
/// assert_eq!(line.step(), Some(Pulse([0, 0, 1]))); // z is behind by 2, x by 1
/// assert_eq!(line.by_ref().count(), 4);
/// assert_eq!(line.position(), [1, -3, 2]);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SpaceLine<const AXES: usize = 3> {
    /// F of each axis; 0 for the one that leads.
    f: [i64; AXES],
    /// Absolute end coordinates.
    end: [u32; AXES],
    sign: [i8; AXES],
    /// Pulses still to come, an axis each.
    left: [u32; AXES],
    leader: usize,
    /// |e_M|.
    longest: u32,
}

impl<const AXES: usize> SpaceLine<AXES> {
    /// The line to `end`: any `i32` coordinates, those on an axis and the origin itself too.
    ///
    /// # Errors
    /// None: every end point is served. (All machines of this crate are built alike.)
    pub fn new(end: [i32; AXES]) -> Result<Self, Error> {
        let (mut leader, mut longest) = (0, 0);
        for (axis, c) in end.iter().enumerate() {
            if c.unsigned_abs() > longest {
                (leader, longest) = (axis, c.unsigned_abs());
            }
        }
        let magnitude = end.map(i32::unsigned_abs);
        Ok(Self {
            f: [0; AXES],
            end: magnitude,
            sign: end.map(|c| c.signum() as i8),
            left: magnitude,
            leader,
            longest,
        })
    }

    /// The line to `end` in this state, reachable or not.
    #[cfg(feature = "proofs")]
    pub fn in_state(end: [i32; AXES], f: [i64; AXES], left: [u32; AXES]) -> Result<Self, Error> {
        Ok(Self { f, left, ..Self::new(end)? })
    }

    /// One step of four beats; `None` once the end point is reached.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse<AXES>> {
        if self.is_done() {
            return None;
        }
        let fed = self.judge();
        let leads = fed == self.leader;
        let mut pulse = Pulse::NONE;
        for axis in 0..AXES {
            let is_fed = axis == fed;
            // The two cancel on the axis that leads.
            let ahead = if is_fed { i64::from(self.longest) } else { 0 };
            let behind = if leads { i64::from(self.end[axis]) } else { 0 };
            self.f[axis] += ahead - behind;
            self.left[axis] -= u32::from(is_fed);
            pulse.0[axis] = if is_fed { self.sign[axis] } else { 0 };
        }
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// The axis that the next step feeds.
    #[inline]
    #[must_use]
    pub fn judge(&self) -> usize {
        let (mut fed, mut least) = (self.leader, 0);
        for axis in 0..AXES {
            if self.f[axis] < least {
                (fed, least) = (axis, self.f[axis]);
            }
        }
        fed
    }

    /// The deviation functions F_i at the present point, an axis each; 0 for the one that leads.
    #[must_use]
    pub const fn deviation_functions(&self) -> [i64; AXES] {
        self.f
    }

    /// The axis that leads, M: the longest, the earliest of several.
    #[must_use]
    pub const fn leader(&self) -> usize {
        self.leader
    }

    /// Whether the end point is reached.
    #[inline]
    #[must_use]
    pub fn is_done(&self) -> bool {
        let mut some_left = 0;
        for axis in 0..AXES {
            some_left |= self.left[axis];
        }
        some_left == 0
    }

    /// Steps still to come: the pulses of all axes together.
    #[must_use]
    pub fn remaining(&self) -> u64 {
        self.left.iter().map(|left| u64::from(*left)).sum()
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
            signed(self.sign[axis], i64::from(self.end[axis] - self.left[axis]))
        })
    }

    /// What is missing to the end point: zero when done.
    #[must_use]
    pub fn residual(&self) -> [i64; AXES] {
        core::array::from_fn(|axis| signed(self.sign[axis], i64::from(self.left[axis])))
    }

    /// What always holds: each F_i is that of the point, and −|e_i| ≤ F_i < |e_M| (0 on a line
    /// without length); no axis has more pulses to go than it began with.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let leading = (0..AXES).map(|axis| if axis == self.leader { self.left[axis] } else { 0 });
        // One of them; a sum, for the index is not known to be one.
        let leading = i64::from(leading.sum::<u32>());
        self.bounds_hold()
            && (0..AXES).all(|axis| {
                let [end, left] = [self.end[axis], self.left[axis]].map(i64::from);
                // Counted from the end point, whose F is 0 too.
                self.f[axis] == end * leading - i64::from(self.longest) * left
            })
    }

    /// The invariant but for the formulas of F_i, whose products a proof may know otherwise than by
    /// multiplying.
    #[must_use]
    pub fn bounds_hold(&self) -> bool {
        let above = i64::from(self.longest).max(1);
        (0..AXES).all(|axis| {
            self.left[axis] <= self.end[axis]
                && -i64::from(self.end[axis]) <= self.f[axis]
                && self.f[axis] < above
                && (axis != self.leader || self.f[axis] == 0)
        })
    }
}

impl<const AXES: usize> Iterator for SpaceLine<AXES> {
    type Item = Pulse<AXES>;

    #[inline]
    fn next(&mut self) -> Option<Pulse<AXES>> {
        self.step()
    }
}
