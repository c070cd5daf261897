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
    Brm,
}

impl Method {
    /// The method that the options ask for.
    ///
    /// An option of another method is refused: it would be without effect, which whoever gave it
    /// does not expect.
    pub(crate) fn from_options(options: &Options) -> Result<Self, String> {
        let name = options.method.unwrap_or(MethodName::Ppc);
        let of_dda = [
            (options.radix.is_some(), "--radix"),
            (options.preset.is_some(), "--preset"),
            (options.normalize, "--normalize"),
            (options.update.is_some(), "--update"),
        ];
        let of_ppc = [(options.end_rule.is_some(), "--end-rule")];
        let foreign: &[_] = match name {
            MethodName::Ppc => &of_dda,
            MethodName::Dda => &of_ppc,
            MethodName::Brm => &[of_dda[0], of_dda[1], of_dda[2], of_dda[3], of_ppc[0]],
        };
        if let Some((_, option)) = foreign.iter().find(|(is_given, _)| *is_given) {
            let owner = if *option == "--end-rule" { "ppc" } else { "dda" };
            return Err(format!("{option} belongs to --method {owner}"));
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
            MethodName::Brm => Self::Brm,
        })
    }

    /// The name in reports.
    pub(crate) const fn name(&self) -> &'static str {
        match self {
            Self::Ppc { .. } => "ppc",
            Self::Dda { .. } => "dda",
            Self::Brm => "brm",
        }
    }
}
