//! The machine that a program runs on: `machine.toml`, and what the command line overrides.

use super::speed::Speed;
use super::two_level::TwoLevel;
use crate::args::{Options, RunArguments};
use crate::choice::{EndRuleName, MethodName, PresetName, UpdateName};
use crate::failure::Failure;
use crate::sample::SamplingName;
use onepulse_plan::{Integers, Length, Machine, Motion, Rate};
use serde::Deserialize;
use std::fs;

/// A machine.
#[derive(Clone, Debug)]
pub(super) struct Config {
    pub(super) machine: Machine,
    /// The width of the registers; of two levels, the most that the samples of a block may take.
    pub(super) bits: u32,
    pub(super) options: Options,
    /// Where blocks are sampled first.
    pub(super) two_level: Option<TwoLevel>,
}

/// `machine.toml`. Everything may be left out.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    /// The pulse equivalent δ in millimetres.
    pulse_mm: Option<f64>,
    /// The speed of G00.
    rapid_mm_per_min: Option<f64>,
    /// What a coordinate without a decimal point counts.
    integers: Option<IntegersName>,
    pub(super) method: Option<MethodName>,
    end_rule: Option<EndRuleName>,
    pub(super) bits: Option<u32>,
    preset: Option<PresetName>,
    normalize: Option<bool>,
    update: Option<UpdateName>,
    /// Whether blocks are sampled, and made by digital integration from sample to sample.
    pub(super) two_level: Option<bool>,
    pub(super) period_ms: Option<f64>,
    pub(super) sampling: Option<SamplingName>,
    pub(super) tolerance_mm: Option<f64>,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum IntegersName {
    Pulses,
    Units,
}

/// The pulse equivalent of a machine that says nothing else.
const PULSE: Length = Length::from_picometres(Length::MILLIMETRE.picometres() / 100);

/// Wide enough for ±8 million pulses with the headroom bit that circles need.
const BITS: u32 = 24;

/// A rate multiplier takes 2ⁿ clocks for every line, however short.
const BRM_BITS: u32 = 16;

impl Config {
    /// The machine of a command line.
    pub(super) fn load(arguments: &RunArguments) -> Result<Self, Failure> {
        let (file, name) = match &arguments.config {
            None => (File::default(), String::new()),
            Some(path) => {
                let name = path.display().to_string();
                let text = fs::read_to_string(path).map_err(|e| Failure::file(path, &e))?;
                let file = toml::from_str(&text)
                    .map_err(|error| Failure::Fault(format!("{name}: {error}")))?;
                (file, name)
            }
        };
        let in_file = |why: String| Failure::Fault(format!("{name}: {why}"));

        let mut machine = Machine::with_pulse(PULSE);
        if let Some(pulse) = file.pulse_mm {
            // The shortest text of a float is the decimal that was written.
            machine.pulse = positive("pulse_mm", &pulse.to_string()).map_err(in_file)?;
        }
        if let Some(rapid) = file.rapid_mm_per_min {
            machine.rapid = positive("rapid_mm_per_min", &rapid.to_string()).map_err(in_file)?;
        }
        if let Some(IntegersName::Units) = file.integers {
            machine.integers = Integers::Units;
        }
        if let Some(pulse) = &arguments.pulse_mm {
            machine.pulse = positive("--pulse-mm", pulse).map_err(Failure::Usage)?;
        }
        let given = &arguments.options;
        if given.radix.as_deref() == Some("10") {
            return Err(Failure::Usage("the circuits are binary: leave --radix 10 out".into()));
        }
        let two_level = TwoLevel::load(arguments, &file, in_file)?;
        let method = match two_level {
            Some(_) => MethodName::Dda,
            None => given.method.or(file.method).unwrap_or(MethodName::Ppc),
        };
        // Settings of the file that another method would use wait there for it.
        let is_dda = method == MethodName::Dda && two_level.is_none();
        let half = two_level.map(|_| PresetName::Half);
        let options = Options {
            method: Some(method),
            end_rule: given.end_rule.or(file.end_rule.filter(|_| method == MethodName::Ppc)),
            bits: None,
            radix: given.radix.clone(),
            preset: half.or(given.preset).or(file.preset.filter(|_| is_dda)),
            normalize: given.normalize || is_dda && file.normalize.unwrap_or(true),
            update: given.update.or(file.update.filter(|_| is_dda)),
            smooth: given.smooth,
        };
        let default = if method == MethodName::Brm { BRM_BITS } else { BITS };
        let bits = match two_level {
            Some(two_level) => two_level.bits,
            None => given.bits.or(file.bits),
        };
        let bits = bits.unwrap_or(default);
        if !(2..=32).contains(&bits) {
            let why = format!("registers of {bits} bits are not offered: 2 to 32 are");
            return Err(match given.bits {
                Some(_) => Failure::Usage(format!("--bits: {why}")),
                None => in_file(format!("bits = {bits}: {why}")),
            });
        }
        Ok(Self { machine, bits, options, two_level })
    }

    /// The speed that a motion is to have.
    pub(super) fn speed(&self, motion: &Motion) -> Speed {
        let per_minute = match motion.rate {
            Rate::Rapid => self.machine.rapid,
            Rate::Feed(feed) => feed,
        };
        Speed { per_minute, pulse: self.machine.pulse }
    }
}

/// A positive number of the command line or the file.
pub(super) fn positive(name: &str, text: &str) -> Result<Length, String> {
    match text.parse::<Length>() {
        Ok(length) if length > Length::ZERO => Ok(length),
        Ok(_) => Err(format!("{name} = {text}: more than zero is needed")),
        Err(why) => Err(format!("{name} = {text}: {why}")),
    }
}
