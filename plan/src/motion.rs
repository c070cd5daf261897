//! What a program asks for, block by block, in whole pulses.

use crate::Length;
use onepulse_core::Direction;

/// One curve that the interpolator has to make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Motion {
    /// The program's line, from 1.
    pub line: u32,
    /// Where the curve starts, in pulses from the program's origin.
    pub from: [i32; 2],
    /// Where it ends.
    pub to: [i32; 2],
    /// What lies between.
    pub curve: Curve,
    /// How fast.
    pub rate: Rate,
}

/// The curve between two points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curve {
    /// The straight line; its length is not zero.
    Line,
    /// An arc; equal ends mean a full circle. Start and end relative to the centre fit `i32`.
    Arc {
        /// The centre, in pulses from the program's origin.
        centre: [i64; 2],
        /// The sense.
        direction: Direction,
    },
}

/// The speed along the curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rate {
    /// As fast as the machine goes (G00).
    Rapid,
    /// A feed: the way of one minute. Positive.
    Feed(Length),
}
