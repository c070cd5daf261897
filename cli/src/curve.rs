//! Curves as the command line gives them.

use onepulse_core::Direction;
use std::str::FromStr;

/// A curve in pulses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Curve {
    /// From the origin; two to four axes.
    Line { to: Vec<i32> },
    /// About the origin; equal ends mean a full circle.
    Arc { from: [i32; 2], to: [i32; 2], direction: Direction },
}

impl Curve {
    /// The end point.
    pub(crate) fn end(&self) -> Vec<i64> {
        match self {
            Self::Line { to } => to.iter().copied().map(i64::from).collect(),
            Self::Arc { to, .. } => to.iter().copied().map(i64::from).collect(),
        }
    }
}

/// Whole coordinates, separated by commas.
#[derive(Clone, Debug)]
pub(crate) struct Point(pub(crate) Vec<i32>);

/// Two whole coordinates, separated by a comma.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlanePoint(pub(crate) [i32; 2]);

impl FromStr for Point {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let coordinates = text.split(',').map(coordinate).collect::<Result<Vec<_>, _>>()?;
        match coordinates.len() {
            2..=4 => Ok(Self(coordinates)),
            count => Err(format!("2 to 4 coordinates are needed, as in 5,3: here is {count}")),
        }
    }
}

impl FromStr for PlanePoint {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let coordinates = text.split(',').map(coordinate).collect::<Result<Vec<_>, _>>()?;
        let count = coordinates.len();
        let pair = coordinates.try_into();
        pair.map(Self).map_err(|_| format!("2 coordinates are needed, as in 5,0: here is {count}"))
    }
}

fn coordinate(text: &str) -> Result<i32, String> {
    text.parse().map_err(|_| {
        format!("'{text}' is not a whole number of pulses from {} to {}", i32::MIN, i32::MAX)
    })
}
