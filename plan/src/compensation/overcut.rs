//! Why a section cannot be compensated (过切预报).

use std::fmt;

/// A place where the tool would cut into the contour, or where nothing can be computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overcut {
    /// What is wrong.
    pub kind: OvercutKind,
    /// The program's line at fault.
    pub line: u32,
    /// The other line at fault, where there are two.
    pub other_line: Option<u32>,
    /// Where, in millimetres; finite.
    pub at: [f64; 2],
}

/// What is wrong. Lengths are millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum OvercutKind {
    /// The tool's radius is not a number from 0 to 10⁷.
    Radius {
        /// As it was given.
        radius: f64,
    },
    /// A coordinate is not a number from −10⁷ to 10⁷.
    OutOfRange {
        /// As it was given.
        coordinate: f64,
    },
    /// A block does not start where the one before ends.
    Disconnected {
        /// How far from it.
        gap: f64,
    },
    /// The compensation is established or cancelled on an arc.
    NotALine,
    /// The compensation is established or cancelled on a line of no length.
    NoLength,
    /// An arc of no radius, or an end off its circle by over a tenth of it.
    NoArc {
        /// The distances of start and end from the centre.
        radii: [f64; 2],
    },
    /// The tool is larger than the arc in which it runs.
    SmallArc {
        /// The arc's radius.
        arc: f64,
        /// The tool's.
        radius: f64,
    },
    /// The tool takes so much off both ends of a block that its path there would run backward.
    ShortBlock {
        /// How long the block is.
        length: f64,
        /// How much the corners take off it.
        taken: f64,
    },
    /// The paths along two blocks do not meet at their inside corner.
    NoMeeting {
        /// The tool's radius.
        radius: f64,
    },
    /// An inside corner, which the B type does not know; the program needs an arc between the two blocks.
    InsideCorner {
        /// The tool's radius, the least one of that arc.
        radius: f64,
    },
    /// The path along the first line's block comes nearer than the radius to that of the other line.
    Interference {
        /// How near.
        distance: f64,
        /// The tool's radius.
        radius: f64,
    },
}

impl fmt::Display for Overcut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.other_line {
            Some(other) => write!(f, "lines {} and {other}: ", self.line)?,
            None => write!(f, "line {}: ", self.line)?,
        }
        self.kind.fmt(f)
    }
}

impl fmt::Display for OvercutKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Radius { radius } => {
                write!(f, "the tool's radius, {radius} mm, is not a number from 0 to 1e7")
            }
            Self::OutOfRange { coordinate } => {
                write!(f, "a coordinate, {coordinate} mm, is not a number from -1e7 to 1e7")
            }
            Self::Disconnected { gap } => {
                write!(f, "the block starts {gap:.6} mm from the end of the one before")
            }
            Self::NotALine => f.write_str(
                "the compensation is established and cancelled on a line, not on an arc",
            ),
            Self::NoLength => {
                f.write_str("the compensation is established or cancelled on a line of no length")
            }
            Self::NoArc { radii: [start, end] } => {
                write!(f, "start and end are {start:.6} and {end:.6} mm from the centre: no arc")
            }
            Self::SmallArc { arc, radius } => write!(
                f,
                "the tool, with a radius of {radius:.6} mm, is larger than the arc in which it runs, \
                 with {arc:.6} mm"
            ),
            Self::ShortBlock { length, taken } => write!(
                f,
                "the tool takes {taken:.6} mm off the ends of a block of {length:.6} mm: its path \
                 there would run backward"
            ),
            Self::NoMeeting { radius } => write!(
                f,
                "the tool, with a radius of {radius:.6} mm, does not fit into the corner: its paths \
                 do not meet there"
            ),
            Self::InsideCorner { radius } => write!(
                f,
                "an inside corner needs an arc of at least {radius:.6} mm between the two blocks \
                 in the B type"
            ),
            Self::Interference { distance, radius } => write!(
                f,
                "along the first the tool cuts {:.6} mm into the second",
                radius - distance
            ),
        }
    }
}

impl std::error::Error for Overcut {}
