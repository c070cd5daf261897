//! Data sampling (数据采样插补): the points of a line or an arc, one for each sample period.
//!
//! Lengths here are `f64` millimetres, as in the controls that do so: pulses are rounded from the
//! points, each time from the whole way so far ([`Pulses`]), so that nothing is lost over a block.
//!
//! The points of an arc are those of its plane, its first axis and its second: in G18 they are z and x
//! ([`Plane`](onepulse_core::Plane)).
//!
//! | | line | arc |
//! |---|---|---|
//! | 7M, time division (时间分割法) | [`Line`] | [`ArcMethod::SevenM`] |
//! | 7360, extended digital integration (扩展DDA) | [`Line`] | [`ArcMethod::ExtendedDda`] |
//! | direct function (直接函数法) | | [`ArcMethod::DirectFunction`] |
//! | second order recursion (二阶递归法) | | [`ArcMethod::SecondOrder`] |

mod arc;
mod chord;
mod line;
mod pulses;

use crate::Length;
use std::fmt;

pub use arc::{Arc, ArcMethod};
pub use chord::{chord_error, largest_step, textbook_chord_error};
pub use line::Line;
pub use pulses::Pulses;

/// The step f = v·T: the way, in millimetres, of one sample period of `period_s` seconds at a
/// feed of so much a minute. (FANUC 7M: T = 8 ms, f = 2v/15 µm with v in mm/min.)
#[must_use]
pub fn step(feed: Length, period_s: f64) -> f64 {
    feed.millimetres() / 60.0 * period_s
}

/// Why a curve cannot be sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SamplingError {
    /// A step that is not a positive length.
    NoStep,
    /// A point that is not finite.
    NotFinite,
    /// An arc that starts or ends in its centre.
    InCentre,
    /// Steps too long for the arc: with chords over a quarter of the radius the methods' own
    /// approximations are worth nothing.
    StepTooLong {
        /// The step in millimetres.
        step: f64,
        /// The radius in millimetres.
        radius: f64,
    },
}

impl fmt::Display for SamplingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoStep => f.write_str("the way of a sample period is not a positive length"),
            Self::NotFinite => f.write_str("a coordinate is not a finite number"),
            Self::InCentre => f.write_str("an arc starts or ends in its centre"),
            Self::StepTooLong { step, radius } => write!(
                f,
                "a step of {step} mm is over a quarter of the radius, {radius} mm: take less feed or a \
                 shorter period"
            ),
        }
    }
}

impl std::error::Error for SamplingError {}
