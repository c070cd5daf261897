//! `machine.toml`: the machine that programs run on.

use crate::choice::{EndRuleName, MethodName, PresetName, UpdateName};
use crate::failure::Failure;
use crate::sample::SamplingName;
use onepulse_plan::{Integers, Length, Machine};
use serde::Deserialize;
use std::fs;
use std::path::Path;

/// The pulse equivalent of a machine that says nothing else.
const PULSE: Length = Length::from_picometres(Length::MILLIMETRE.picometres() / 100);

/// `machine.toml`. Everything may be left out.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct File {
    /// The pulse equivalent δ in millimetres.
    pulse_mm: Option<f64>,
    /// The speed of G00.
    rapid_mm_per_min: Option<f64>,
    /// What a coordinate without a decimal point counts.
    integers: Option<IntegersName>,
    pub(crate) method: Option<MethodName>,
    pub(crate) end_rule: Option<EndRuleName>,
    pub(crate) bits: Option<u32>,
    pub(crate) preset: Option<PresetName>,
    pub(crate) normalize: Option<bool>,
    pub(crate) update: Option<UpdateName>,
    /// Whether blocks are sampled, and made by digital integration from sample to sample.
    pub(crate) two_level: Option<bool>,
    pub(crate) period_ms: Option<f64>,
    pub(crate) sampling: Option<SamplingName>,
    pub(crate) tolerance_mm: Option<f64>,
    /// Whether two levels take speeds that are planned through the whole program.
    pub(crate) accelerate: Option<bool>,
    pub(crate) acceleration_mm_per_s2: Option<f64>,
    pub(crate) jerk_mm_per_s3: Option<f64>,
    pub(crate) corner_mm_per_s: Option<f64>,
    pub(crate) centripetal_mm_per_s2: Option<f64>,
    pub(crate) servo_gain_per_s: Option<f64>,
    pub(crate) servo_drive_ms: Option<f64>,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum IntegersName {
    Pulses,
    Units,
}

/// A machine file that was read, or nothing where none is given.
#[derive(Debug, Default)]
pub(crate) struct MachineFile {
    pub(crate) content: File,
    name: String,
}

impl MachineFile {
    pub(crate) fn read(path: Option<&Path>) -> Result<Self, Failure> {
        let Some(path) = path else { return Ok(Self::default()) };
        let name = path.display().to_string();
        let text = fs::read_to_string(path).map_err(|error| Failure::file(path, &error))?;
        let content =
            toml::from_str(&text).map_err(|error| Failure::Fault(format!("{name}: {error}")))?;
        Ok(Self { content, name })
    }

    /// Something in the file that is wrong.
    pub(crate) fn fault(&self, why: impl std::fmt::Display) -> Failure {
        Failure::Fault(format!("{}: {why}", self.name))
    }

    /// The machine, but for a pulse equivalent of the command line.
    pub(crate) fn machine(&self, pulse: Option<&str>) -> Result<Machine, Failure> {
        let mut machine = Machine::with_pulse(PULSE);
        let in_file = |why: String| self.fault(why);
        if let Some(pulse) = self.content.pulse_mm {
            // The shortest text of a float is the decimal that was written.
            machine.pulse = positive("pulse_mm", &pulse.to_string()).map_err(in_file)?;
        }
        if let Some(rapid) = self.content.rapid_mm_per_min {
            machine.rapid = positive("rapid_mm_per_min", &rapid.to_string()).map_err(in_file)?;
        }
        if let Some(IntegersName::Units) = self.content.integers {
            machine.integers = Integers::Units;
        }
        if let Some(pulse) = pulse {
            machine.pulse = positive("--pulse-mm", pulse).map_err(Failure::Usage)?;
        }
        Ok(machine)
    }
}

/// A positive number of the command line or the file.
pub(crate) fn positive(name: &str, text: &str) -> Result<Length, String> {
    match text.parse::<Length>() {
        Ok(length) if length > Length::ZERO => Ok(length),
        Ok(_) => Err(format!("{name} = {text}: more than zero is needed")),
        Err(why) => Err(format!("{name} = {text}: {why}")),
    }
}
