//! Circular arc by point-by-point comparison.

use crate::{Direction, EndRule, Error, Feed, Pulse, Sweep};

/// An arc about the origin, any sweep up to a full turn.
///
/// F = x² + y² − R²: F ≥ 0 (on the circle or outside) feeds the axis that leads towards a
/// coordinate axis and so into the circle; F < 0 feeds the one that leads out. A pulse of sign s
/// on coordinate c changes F by 2sc + 1, and quadrants are crossed by themselves. Always
/// (R − 1)² ≤ x² + y² ≤ (R + 1)²: one pulse at most.
///
/// The path runs through every lattice point of its circle within the sweep. An end point off
/// the circle (a program rounded to pulses) is reached too: see [`Sweep`].
///
/// ```
/// use onepulse_core::{Direction, EndRule, ppc};
/// let arc = ppc::Arc::new([5, 0], [0, 5], Direction::Ccw, EndRule::Total)?;
/// assert_eq!(arc.count(), 10);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arc {
    f: i64,
    position: [i64; 2],
    sweep: Sweep,
    /// Pulses still to come, an axis each.
    left: [u64; 2],
    larger: usize,
    rule: EndRule,
}

impl Arc {
    /// The arc from `start` to `end`; equal ends mean a full circle.
    ///
    /// # Errors
    /// As [`Sweep::new`].
    pub fn new(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        rule: EndRule,
    ) -> Result<Self, Error> {
        let sweep = Sweep::new(start, end, direction)?;
        let position = start.map(i64::from);
        let left = sweep.pulses_to_go(position);
        Ok(Self { f: 0, position, sweep, left, larger: usize::from(left[0] < left[1]), rule })
    }

    /// One step of four beats; `None` once the end rule is met.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        if self.is_done() {
            return None;
        }
        let Feed { axis, sign } = self.judge();
        let fed = axis.index();
        let coordinate = &mut self.position[fed];
        self.f += 2 * i64::from(sign) * *coordinate + 1;
        *coordinate += i64::from(sign);
        self.left[fed] -= 1;
        self.sweep.arrive(self.position);
        debug_assert!(self.invariant());
        Some(Pulse::on(axis, sign))
    }

    /// The motion that the next step makes.
    ///
    /// F decides while both axes are on their way. In the last quadrant an axis that stands at
    /// its end coordinate is not fed; when both stand, an end point off the circle is stepped
    /// out, x first.
    #[inline]
    #[must_use]
    pub fn judge(&self) -> Feed {
        let feeds = self.sweep.feeds();
        let stands = self.sweep.stands(self.position);
        match (stands[feeds.towards.axis.index()], stands[feeds.away.axis.index()]) {
            (false, false) if self.f >= 0 => feeds.towards,
            (false, true) => feeds.towards,
            (_, false) => feeds.away,
            (true, true) => {
                let Pulse([x, y]) = self.sweep.step_out(self.position);
                if x != 0 {
                    Feed { axis: crate::Axis::X, sign: x }
                } else {
                    Feed { axis: crate::Axis::Y, sign: y }
                }
            }
        }
    }

    /// The deviation function F at the present point.
    #[must_use]
    pub const fn deviation_function(&self) -> i64 {
        self.f
    }

    /// Where the arc is on its way round.
    #[must_use]
    pub const fn sweep(&self) -> &Sweep {
        &self.sweep
    }

    /// Whether the end rule is met.
    #[inline]
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.rule.is_met(self.left, self.larger)
    }

    /// What the counters of the end rule still hold, in pulses.
    #[must_use]
    pub const fn remaining(&self) -> u64 {
        self.rule.remaining(self.left, self.larger)
    }

    /// Pulses of each axis between here and the end point.
    #[must_use]
    pub const fn pulses_to_go(&self) -> [u64; 2] {
        self.left
    }

    /// The present point.
    #[must_use]
    pub const fn position(&self) -> [i64; 2] {
        self.position
    }

    /// What is missing to the end point: zero when done, but under [`EndRule::Larger`] the other
    /// axis may be left short.
    #[must_use]
    pub fn residual(&self) -> [i64; 2] {
        let end = self.sweep.end();
        [end[0] - self.position[0], end[1] - self.position[1]]
    }

    /// What always holds: the counters hold the pulses of the way that is left, and while F
    /// alone decides, −2R' < F ≤ 2R', where R' is the largest coordinate on the way.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let peak = self.sweep.peak();
        self.sweep.invariant()
            && self.left == self.sweep.pulses_to_go(self.position)
            && (self.sweep.stands(self.position) != [false; 2]
                || (-2 * peak < self.f
                    && self.f <= 2 * peak
                    && self.position.iter().all(|c| c.abs() <= peak)))
    }
}

impl Iterator for Arc {
    type Item = Pulse;

    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
