//! Curves as the command line gives them.

use clap::ValueEnum;
use onepulse_core::{Axis, Direction, Plane};
use std::fmt;
use std::str::FromStr;

/// A curve in pulses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Curve {
    /// From the origin; two to four axes.
    Line { to: Vec<i32> },
    /// About the origin; equal ends mean a full circle.
    Arc { from: [i32; 2], to: [i32; 2], direction: Direction },
    /// From its vertex in the origin, about one of the axes: y² = 2px or x² = 2py.
    Parabola { axis: Axis, parameter: i32, to: [i32; 2] },
    /// An arc about the origin of a plane, and a rise across it; points in the plane's own axes.
    Helix { plane: Plane, from: [i32; 2], to: [i32; 2], direction: Direction, rise: i32 },
}

/// As the command line gives it.
impl fmt::Display for Curve {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sense = |direction: &_| if *direction == Direction::Cw { "cw" } else { "ccw" };
        match self {
            Self::Line { to } => {
                let to: Vec<_> = to.iter().map(i32::to_string).collect();
                write!(f, "line --to {}", to.join(","))
            }
            Self::Arc { from: [x, y], to: [xe, ye], direction } => {
                write!(f, "arc --from {x},{y} --to {xe},{ye} --{}", sense(direction))
            }
            Self::Parabola { axis, parameter, to: [x, y] } => {
                let upright = if *axis == Axis::Y { " --axis y" } else { "" };
                write!(f, "parabola --p {parameter} --to {x},{y}{upright}")
            }
            Self::Helix { plane, from: [x, y], to: [xe, ye], direction, rise } => {
                let plane = match plane {
                    Plane::Xy => "",
                    Plane::Zx => " --plane zx",
                    Plane::Yz => " --plane yz",
                };
                let sense = sense(direction);
                write!(f, "helix --from {x},{y} --to {xe},{ye} --rise {rise} --{sense}{plane}")
            }
        }
    }
}

/// An axis by its letter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum AxisName {
    /// y² = 2px
    #[default]
    X,
    /// x² = 2py
    Y,
}

/// A plane by its letters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum PlaneName {
    /// G17: points are x,y, and the rise is along z
    #[default]
    Xy,
    /// G18: points are z,x, and the rise is along y
    Zx,
    /// G19: points are y,z, and the rise is along x
    Yz,
}

impl From<AxisName> for Axis {
    fn from(name: AxisName) -> Self {
        match name {
            AxisName::X => Self::X,
            AxisName::Y => Self::Y,
        }
    }
}

impl From<PlaneName> for Plane {
    fn from(name: PlaneName) -> Self {
        match name {
            PlaneName::Xy => Self::Xy,
            PlaneName::Zx => Self::Zx,
            PlaneName::Yz => Self::Yz,
        }
    }
}

impl Curve {
    /// The end point.
    pub(crate) fn end(&self) -> Vec<i64> {
        match self {
            Self::Line { to } => to.iter().copied().map(i64::from).collect(),
            Self::Arc { to, .. } | Self::Parabola { to, .. } => to.map(i64::from).to_vec(),
            &Self::Helix { plane, to: [first, second], rise, .. } => {
                plane.place([first, second, rise]).map(i64::from).to_vec()
            }
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

/// A whole number of pulses.
pub(crate) fn coordinate(text: &str) -> Result<i32, String> {
    text.parse().map_err(|_| {
        format!("'{text}' is not a whole number of pulses from {} to {}", i32::MIN, i32::MAX)
    })
}
