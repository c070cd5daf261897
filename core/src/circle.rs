//! Arcs by the methods that judge F = x² + y² − R² and may feed both axes in one step.
//!
//! They differ in their [`Judgement`] alone: [minimum deviation](crate::minimum_deviation::Arc),
//! [vector discrimination](crate::vector::Arc) and [comparison integration](crate::comparison::Arc).

use crate::{Direction, Error, Pulse, Sweep, Walk};
use core::marker::PhantomData;

/// What a method feeds where F decides: the axis that leads towards zero in this quadrant, the one that
/// leads away from it, or both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Due {
    /// The coordinate that shrinks.
    Towards,
    /// The coordinate that grows.
    Away,
    /// Both in one step.
    Both,
}

/// The rule of a method, and what it keeps F within.
///
/// Both are asked with F and the magnitudes of the coordinate that is fed towards zero and of the one
/// that is fed away from it.
pub trait Judgement {
    /// What is fed next.
    fn due(f: i64, magnitudes: [i64; 2]) -> Due;

    /// Whether F is within the bounds that the rule keeps.
    fn is_within(f: i64, magnitudes: [i64; 2]) -> bool;
}

/// An arc about the origin by the method of the judgement, any sweep up to a full turn.
///
/// An end point off the circle (a program rounded to pulses) is reached too: see [`Sweep`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arc<J> {
    walk: Walk,
    judgement: PhantomData<J>,
}

impl<J: Judgement> Arc<J> {
    /// The arc from `start` to `end`; equal ends mean a full circle.
    ///
    /// # Errors
    /// As [`Sweep::new`].
    pub fn new(start: [i32; 2], end: [i32; 2], direction: Direction) -> Result<Self, Error> {
        Ok(Self::at(Walk::new(Sweep::new(start, end, direction)?, start)))
    }

    const fn at(walk: Walk) -> Self {
        Self { walk, judgement: PhantomData }
    }

    /// The arc from `start` along a sweep that begins there: [`Arc::new`] without its roots.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn along_given(sweep: Sweep, start: [i32; 2]) -> Self {
        Self::at(Walk::new(sweep, start))
    }

    /// The arc at this place, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(walk: Walk) -> Self {
        Self::at(walk)
    }

    /// One step; `None` at the end point.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse> {
        if self.is_done() {
            return None;
        }
        let pulse = self.walk.step(J::due);
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// The place on the circle.
    #[must_use]
    pub const fn walk(&self) -> &Walk {
        &self.walk
    }

    /// Whether the end point is reached.
    #[inline]
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.walk.is_at_end()
    }

    /// What always holds: while F decides, it is within the bounds of the method, and the coordinate that
    /// is fed towards zero has not come there yet; where that would be the centre, the circle lies
    /// outside.
    #[must_use]
    pub fn invariant(&self) -> bool {
        let [towards, away] = self.walk.magnitudes();
        let f = self.walk.deviation_function();
        self.walk.invariant()
            && (!self.walk.is_free()
                || J::is_within(f, [towards, away])
                    && towards > 0
                    && (towards > 1 || away > 0 || f <= 0))
    }
}

impl<J: Judgement> Iterator for Arc<J> {
    type Item = Pulse;

    #[inline]
    fn next(&mut self) -> Option<Pulse> {
        self.step()
    }
}
