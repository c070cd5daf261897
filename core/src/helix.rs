//! Helix: an arc in one plane and a linear axis across it.

mod distributor;
mod screw;

pub use distributor::Distributor;
pub use screw::Screw;

use crate::{Direction, EndRule, Error, Pulse, ppc};

/// An interpolation plane of three axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Plane {
    /// X and Y, across them Z: G17.
    #[default]
    Xy,
    /// Z and X, across them Y: G18.
    Zx,
    /// Y and Z, across them X: G19.
    Yz,
}

impl Plane {
    /// The places, in an array of x, y and z, of the plane's first axis, of its second, and of the
    /// axis across it. Seen from that axis' positive end, counter-clockwise turns the first into
    /// the second.
    #[must_use]
    pub const fn axes(self) -> [usize; 3] {
        match self {
            Self::Xy => [0, 1, 2],
            Self::Zx => [2, 0, 1],
            Self::Yz => [1, 2, 0],
        }
    }

    /// From the order of the plane (first, second, across) to x, y, z.
    #[inline]
    #[must_use]
    pub const fn place<T: Copy>(self, [first, second, across]: [T; 3]) -> [T; 3] {
        match self {
            Self::Xy => [first, second, across],
            Self::Zx => [second, across, first],
            Self::Yz => [across, first, second],
        }
    }
}

/// An arc by point-by-point comparison in a plane, with a linear axis that ends when it does.
///
/// The arc makes N steps in all ([`ppc::Arc::remaining`] at its start) and the linear axis |h|, so
/// T = max(N, |h|) cycles do. The longer of the two steps every cycle; for the shorter, of S steps, a
/// digital integrator modulo T adds S every cycle, from half load ⌊T/2⌋, and its carry is the step.
/// So after c cycles the shorter has made ⌊(⌊T/2⌋ + c·S)/T⌋ steps, which is within ½ of c·S/T, and
/// after T just S.
///
/// * N ≥ |h|: the linear axis is within half a pulse of h·k/N after k steps of the arc.
/// * |h| > N: the arc has made as many steps as k·N/|h| after k pulses of the linear axis, to within
///   half a step.
///
/// Half is attained: by a rise of 1 over an arc of even N, after N/2 steps. In the plane the path is
/// that of [`ppc::Arc`], one pulse from the circle at most.
///
/// ```
/// use onepulse_core::{Direction, Helix, Plane, Pulse};
/// // A quarter turn from (5,0) to (0,5) in ten steps, while z rises by 3.
/// let mut helix = Helix::new(Plane::Xy, [5, 0], [0, 5], Direction::Ccw, 3)?;
/// assert_eq!(helix.step(), Some(Pulse([-1, 0, 0])));
/// assert_eq!(helix.step(), Some(Pulse([0, 1, 1])));
/// assert_eq!(helix.by_ref().count(), 8);
/// assert_eq!(helix.position(), [0, 5, 3]);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Helix {
    arc: ppc::Arc,
    screw: Screw,
}

impl Helix {
    /// The helix about the plane's origin from `start` to `end`, given as the plane's first and
    /// second coordinate, that rises by `rise` pulses along the third axis; equal ends mean a full
    /// turn. A rise of 0 is the arc alone.
    ///
    /// # Errors
    /// As [`Sweep::new`](crate::Sweep::new); every rise is served.
    pub fn new(
        plane: Plane,
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        rise: i32,
    ) -> Result<Self, Error> {
        Ok(Self::about(plane, ppc::Arc::new(start, end, direction, EndRule::Total)?, rise))
    }

    /// The helix about an arc that has not begun.
    fn about(plane: Plane, arc: ppc::Arc, rise: i32) -> Self {
        Self { arc, screw: Screw::new(plane, arc.remaining(), rise) }
    }

    /// The helix about a given arc that has not begun, of the end rule [`EndRule::Total`]:
    /// [`Helix::new`] without the arc's roots.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn about_given(plane: Plane, arc: ppc::Arc, rise: i32) -> Self {
        Self::about(plane, arc, rise)
    }

    /// One cycle; `None` once the end point is reached.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse<3>> {
        let pulse = self.screw.cycle(|| self.arc.step().unwrap_or(Pulse::NONE))?;
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// The arc in the plane.
    #[must_use]
    pub const fn arc(&self) -> &ppc::Arc {
        &self.arc
    }

    /// The plane of the arc.
    #[must_use]
    pub const fn plane(&self) -> Plane {
        self.screw.plane()
    }

    /// T: the cycles from start to end.
    #[must_use]
    pub const fn cycles(&self) -> u64 {
        self.screw.distributor().cycles()
    }

    /// The remainder register of the shorter of arc and linear axis.
    #[must_use]
    pub const fn remainder(&self) -> u64 {
        self.screw.distributor().remainder()
    }

    /// Whether the end point is reached.
    #[inline]
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.screw.distributor().remaining() == 0
    }

    /// Cycles still to come.
    #[must_use]
    pub const fn remaining(&self) -> u64 {
        self.screw.distributor().remaining()
    }

    /// The present point, x, y, z: counted from the arc's centre in the plane, and from the start
    /// along the linear axis.
    #[must_use]
    pub fn position(&self) -> [i64; 3] {
        self.screw.position(self.arc.position())
    }

    /// What is missing to the end point: zero when done.
    #[must_use]
    pub fn residual(&self) -> [i64; 3] {
        self.screw.residual(self.arc.residual())
    }

    /// All but the arc.
    #[must_use]
    pub const fn screw(&self) -> &Screw {
        &self.screw
    }

    /// What always holds: the arc's own invariant, and the screw's for the steps that the arc still
    /// has to make.
    #[must_use]
    pub fn invariant(&self) -> bool {
        self.arc.invariant() && self.screw.invariant(self.arc.remaining())
    }
}

impl Iterator for Helix {
    type Item = Pulse<3>;

    #[inline]
    fn next(&mut self) -> Option<Pulse<3>> {
        self.step()
    }
}
