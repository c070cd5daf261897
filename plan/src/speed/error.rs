//! Why a speed cannot be planned.

use std::fmt;

/// What a number counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Quantity {
    /// The limit of the acceleration along the path, mm/s².
    Acceleration,
    /// The limit of the jerk along the path, mm/s³.
    Jerk,
    /// The limit of the jump of the velocity in a corner, mm/s.
    Corner,
    /// The limit of the acceleration across an arc, mm/s².
    Centripetal,
    /// The length of a block, mm.
    Length,
    /// The steady speed of a block, mm/s.
    SteadySpeed,
    /// The sample period, s.
    Period,
}

/// Why a speed cannot be planned.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SpeedError {
    /// A quantity that is not between 10⁻¹² and 10¹².
    OutOfRange {
        /// Which.
        quantity: Quantity,
        /// As it was given.
        value: f64,
    },
    /// A direction whose length is not 1.
    NoDirection,
    /// An arc that starts or ends in its centre, or over 2³¹ pulses from it.
    NoArc,
    /// An entry or exit speed that is not between 0 and the steady speed.
    NotBelowSteady {
        /// The speed in mm/s.
        speed: f64,
        /// The steady speed in mm/s.
        steady: f64,
    },
    /// A block too short to come from its entry speed to its exit speed.
    TooShort {
        /// Its length in millimetres.
        length: f64,
        /// The way of the change of speed in millimetres.
        needed: f64,
    },
}

impl SpeedError {
    /// The value if it is neither so small nor so large that products of some of them vanish or
    /// overflow.
    pub(super) fn in_range(quantity: Quantity, value: f64) -> Result<f64, Self> {
        if (1e-12..=1e12).contains(&value) {
            Ok(value)
        } else {
            Err(Self::OutOfRange { quantity, value })
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Acceleration => "acceleration",
            Self::Jerk => "jerk",
            Self::Corner => "jump of the velocity in a corner",
            Self::Centripetal => "centripetal acceleration",
            Self::Length => "length of a block",
            Self::SteadySpeed => "steady speed of a block",
            Self::Period => "sample period",
        })
    }
}

impl fmt::Display for SpeedError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange { quantity, value } => {
                write!(f, "the {quantity}, {value}, is not a positive number from 1e-12 to 1e12")
            }
            Self::NoDirection => f.write_str("a direction is not a unit vector"),
            Self::NoArc => {
                f.write_str("an arc starts or ends in its centre, or over 2^31 pulses from it")
            }
            Self::NotBelowSteady { speed, steady } => write!(
                f,
                "an entry or exit speed of {speed} mm/s is not between 0 and the steady speed, \
                 {steady} mm/s"
            ),
            Self::TooShort { length, needed } => write!(
                f,
                "a block of {length} mm is too short for its entry and exit speed, which need \
                 {needed} mm: let them differ less, or allow more acceleration"
            ),
        }
    }
}

impl std::error::Error for SpeedError {}
