//! Why a machine refused to be built.

use core::fmt;

/// What cannot work, and why. Every constructor of this crate that can fail returns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// The arc starts in its own centre: there is no circle.
    StartInCentre,
    /// The arc ends in its own centre: no sweep leads there.
    EndInCentre,
    /// The circle about the origin through `start` leaves the `i32` coordinates.
    CircleTooLarge {
        /// The arc's start point.
        start: [i32; 2],
    },
    /// A register of so many digits is not offered.
    RegisterWidth {
        /// Digits asked for.
        digits: u32,
        /// The widest register of that radix.
        widest: u32,
    },
    /// The register cannot hold the curve.
    RegisterTooNarrow {
        /// Digits of the register.
        digits: u32,
        /// Digits that the curve needs.
        needed: u32,
    },
    /// Left-shift normalization looks at a binary register's highest bit.
    NormalizationNeedsBinary,
    /// Arcs are integrated in binary registers.
    ArcNeedsBinary,
    /// Limits of a ramp with which an axis could not start, or not keep them.
    RampLimits,
    /// A parabola y² = 2px with p = 0 is no curve.
    NoParameter,
    /// The end point lies on the side of the vertex to which the parabola does not open.
    EndBehindVertex {
        /// The parabola's end point.
        end: [i32; 2],
    },
    /// Parabolas are integrated in binary registers.
    ParabolaNeedsBinary,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::StartInCentre => {
                f.write_str("the arc starts in its centre (0,0): its radius would be zero")
            }
            Self::EndInCentre => {
                f.write_str("the arc ends in its centre (0,0): no point of a circle lies there")
            }
            Self::CircleTooLarge { start: [x, y] } => write!(
                f,
                "the circle through {x},{y} has a radius over {} pulses: its points do not fit 32-bit coordinates",
                i32::MAX
            ),
            Self::RegisterWidth { digits, widest } => {
                write!(f, "a register of {digits} digits is not offered: 1 to {widest} are")
            }
            Self::RegisterTooNarrow { digits, needed } => {
                write!(f, "a register of {digits} digits cannot hold this curve: it needs {needed}")
            }
            Self::NormalizationNeedsBinary => {
                f.write_str("left-shift normalization is defined on binary registers: use radix 2")
            }
            Self::RampLimits => f.write_str(
                "a ramp needs a start speed and an acceleration of 1 or more, and a largest speed that is \
                 neither below these nor 2^n or more",
            ),
            Self::ArcNeedsBinary => {
                f.write_str("arcs are integrated in binary registers: use radix 2")
            }
            Self::NoParameter => f.write_str("the parabola has the parameter 0: it is no curve"),
            Self::EndBehindVertex { end: [x, y] } => write!(
                f,
                "the end point {x},{y} lies behind the vertex: the parabola opens to the other side"
            ),
            Self::ParabolaNeedsBinary => {
                f.write_str("parabolas are integrated in binary registers: use radix 2")
            }
        }
    }
}

impl core::error::Error for Error {}
