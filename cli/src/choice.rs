//! Which interpolator serves, and how it is set up.

use crate::args::Options;
use clap::ValueEnum;
use onepulse_core::EndRule;
use onepulse_core::dda::{Preset, Radix};
use serde::Deserialize;

/// The methods by their names on the command line and in `machine.toml`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum MethodName {
    /// Point-by-point comparison
    Ppc,
    /// Digital integration
    Dda,
    /// Binary rate multiplier (lines only)
    Brm,
    /// Minimum deviation
    MinDeviation,
    /// Vector discrimination
    Vector,
    /// Comparison integration
    CompareIntegral,
}

impl MethodName {
    /// As it is written.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Ppc => "ppc",
            Self::Dda => "dda",
            Self::Brm => "brm",
            Self::MinDeviation => "min-deviation",
            Self::Vector => "vector",
            Self::CompareIntegral => "compare-integral",
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum EndRuleName {
    /// One counter for both axes
    Total,
    /// A counter an axis
    PerAxis,
    /// A counter for the axis with more pulses
    Larger,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum PresetName {
    /// 000…0
    Zero,
    /// 100…0
    Half,
    /// 111…1
    Full,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum UpdateName {
    /// The textbook's circuit, which exceeds one pulse
    Simultaneous,
    /// The centred staggered circuit, which keeps within one pulse
    Staggered,
}

/// A method and its settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    Ppc { end_rule: EndRule },
    Dda { radix: Radix, preset: Option<Preset>, normalize: bool, update: UpdateName },
    Brm { smoothing: u32 },
    MinDeviation,
    Vector,
    CompareIntegral,
}

impl Method {
    /// The method that the options ask for.
    ///
    /// An option of another method is refused: it would be without effect, which whoever gave it
    /// does not expect.
    pub(crate) fn from_options(options: &Options) -> Result<Self, String> {
        let name = options.method.unwrap_or(MethodName::Ppc);
        let owned = [
            (options.radix.is_some(), "--radix", MethodName::Dda),
            (options.preset.is_some(), "--preset", MethodName::Dda),
            (options.normalize, "--normalize", MethodName::Dda),
            (options.update.is_some(), "--update", MethodName::Dda),
            (options.end_rule.is_some(), "--end-rule", MethodName::Ppc),
            (options.smooth.is_some(), "--smooth", MethodName::Brm),
        ];
        let is_foreign = |(is_given, _, owner): &&(bool, _, _)| *is_given && *owner != name;
        if let Some((_, option, owner)) = owned.iter().find(is_foreign) {
            return Err(format!("{option} belongs to --method {}", owner.name()));
        }
        Ok(match name {
            MethodName::Ppc => Self::Ppc {
                end_rule: match options.end_rule {
                    None | Some(EndRuleName::Total) => EndRule::Total,
                    Some(EndRuleName::PerAxis) => EndRule::PerAxis,
                    Some(EndRuleName::Larger) => EndRule::Larger,
                },
            },
            MethodName::Dda => Self::Dda {
                radix: match options.radix.as_deref() {
                    Some("10") => Radix::Decimal,
                    _ => Radix::Binary,
                },
                preset: options.preset.map(|preset| match preset {
                    PresetName::Zero => Preset::Zero,
                    PresetName::Half => Preset::Half,
                    PresetName::Full => Preset::Full,
                }),
                normalize: options.normalize,
                update: options.update.unwrap_or(UpdateName::Staggered),
            },
            MethodName::Brm => Self::Brm { smoothing: options.smooth.unwrap_or(0) },
            MethodName::MinDeviation => Self::MinDeviation,
            MethodName::Vector => Self::Vector,
            MethodName::CompareIntegral => Self::CompareIntegral,
        })
    }

    /// The name in reports.
    pub(crate) const fn name(&self) -> &'static str {
        let name = match self {
            Self::Ppc { .. } => MethodName::Ppc,
            Self::Dda { .. } => MethodName::Dda,
            Self::Brm { .. } => MethodName::Brm,
            Self::MinDeviation => MethodName::MinDeviation,
            Self::Vector => MethodName::Vector,
            Self::CompareIntegral => MethodName::CompareIntegral,
        };
        name.name()
    }

    /// Whether the hardware model has a circuit of the method for lines that move more than two axes.
    pub(crate) const fn has_circuit_in_space(&self) -> bool {
        matches!(self, Self::Dda { .. } | Self::Brm { smoothing: 0 } | Self::MinDeviation)
    }

    /// Whether the hardware model has circuits of the method.
    pub(crate) const fn has_circuit(&self) -> bool {
        !matches!(self, Self::Brm { smoothing: 1.. } | Self::Vector)
    }
}
