//! What is compared: each method, and the settings of it that are worth a line of their own.

use crate::choice::{Method, UpdateName};
use crate::curve::Curve;
use onepulse_core::EndRule;
use onepulse_core::dda::{Preset, Radix};

/// A method with its settings, and what the settings are called.
#[derive(Clone, Copy, Debug)]
pub(super) struct Variant {
    pub(super) method: Method,
    pub(super) name: &'static str,
}

impl Variant {
    /// In one line.
    pub(super) fn title(&self) -> String {
        format!("{} {}", self.method.name(), self.name).trim_end().to_owned()
    }

    /// Whether a cycle may feed more than one axis.
    pub(super) fn feeds_together(&self) -> bool {
        !matches!(self.method, Method::Ppc { .. })
    }
}

/// Stages of the dividers that smooth the rate multiplier here.
const SMOOTHING: u32 = 3;

/// All that may serve the curve. (What its machines refuse is left out later.)
pub(super) fn of(curve: &Curve) -> Vec<Variant> {
    let variant = |method, name| Variant { method, name };
    let dda = |preset, normalize, update, name| {
        let (radix, preset) = (Radix::Binary, Some(preset));
        Variant { method: Method::Dda { radix, preset, normalize, update }, name }
    };
    let of_curve = match curve {
        Curve::Line { .. } => vec![
            dda(Preset::Zero, false, UpdateName::Staggered, "zero preset"),
            dda(Preset::Half, false, UpdateName::Staggered, "half load"),
            dda(Preset::Zero, true, UpdateName::Staggered, "normalized"),
            variant(Method::Brm { smoothing: 0 }, ""),
            variant(Method::Brm { smoothing: SMOOTHING }, "smoothed by 8"),
        ],
        Curve::Arc { .. } => vec![
            dda(Preset::Zero, false, UpdateName::Simultaneous, "textbook, zero"),
            dda(Preset::Half, false, UpdateName::Simultaneous, "textbook, half"),
            dda(Preset::Half, false, UpdateName::Staggered, "staggered"),
        ],
        Curve::Parabola { .. } | Curve::Helix { .. } => vec![
            dda(Preset::Zero, false, UpdateName::Staggered, "zero preset"),
            dda(Preset::Half, false, UpdateName::Staggered, "half load"),
        ],
    };
    let mut all = vec![variant(Method::Ppc { end_rule: EndRule::Total }, "")];
    all.extend(of_curve);
    let others = [Method::MinDeviation, Method::Vector, Method::CompareIntegral];
    all.extend(others.map(|method| variant(method, "")));
    all
}
