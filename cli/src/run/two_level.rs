//! The settings of two levels: data sampling, and DDA lines between the samples.

use crate::args::RunArguments;
use crate::choice::{MethodName, PresetName};
use crate::failure::Failure;
use crate::machine_file::{File, positive};
use crate::sample::SamplingName;

/// How blocks are sampled, and in which registers the samples are made.
#[derive(Clone, Copy, Debug)]
pub(super) struct TwoLevel {
    /// The sample period T.
    pub(super) period_ms: f64,
    pub(super) sampling: SamplingName,
    /// The largest chord error.
    pub(super) tolerance_mm: Option<f64>,
    /// The width of the registers, if it is not the smallest that serves a block.
    pub(super) bits: Option<u32>,
    /// Whether speeds are planned through the whole program; the points are then on the curve itself.
    pub(super) accelerate: bool,
}

/// The sample period of a machine that says nothing else, that of the FANUC 7M.
const PERIOD_MS: f64 = 8.0;

impl TwoLevel {
    /// The settings of a command line and its machine file, if they ask for two levels.
    pub(super) fn load(
        arguments: &RunArguments,
        file: &File,
        in_file: impl Fn(String) -> Failure + Copy,
    ) -> Result<Option<Self>, Failure> {
        let given = &arguments.options;
        let is_of_file = file.two_level == Some(true);
        let is_dda = |method: Option<MethodName>| matches!(method, None | Some(MethodName::Dda));
        if arguments.two_level && !is_dda(given.method) {
            return Err(Failure::Usage("--two-level belongs to --method dda".into()));
        }
        // Another method on the command line overrules the file.
        if !(arguments.two_level || is_of_file && is_dda(given.method)) {
            return match unused(&[
                (arguments.accelerate, "--accelerate"),
                (arguments.period.is_some(), "--period"),
                (arguments.sampling.is_some(), "--sampling"),
                (arguments.tolerance.is_some(), "--tolerance"),
            ]) {
                None => Ok(None),
                Some(option) => Err(Failure::Usage(format!("{option} belongs to --two-level"))),
            };
        }
        if !arguments.two_level && given.method.is_none() && !is_dda(file.method) {
            return Err(in_file("two_level = true belongs to method = \"dda\"".into()));
        }
        if let Some(option) = unused(&[
            (!matches!(given.preset, None | Some(PresetName::Half)), "--preset"),
            (given.normalize, "--normalize"),
            (given.update.is_some(), "--update"),
        ]) {
            return Err(Failure::Usage(format!(
                "{option} is not for two levels: the line of a sample takes half load and 2^n accumulations"
            )));
        }
        let accelerate = arguments.accelerate || file.accelerate == Some(true);
        if accelerate && arguments.sampling.is_some() {
            return Err(Failure::Usage(
                "--sampling is not for --accelerate: the points are on the curve itself".into(),
            ));
        }
        let number = |option: &str, text: &Option<String>, key: &str, value: Option<f64>| {
            let number = match (text, value) {
                (Some(text), _) => positive(option, text).map_err(Failure::Usage)?,
                // The shortest text of a float is the decimal that was written.
                (None, Some(value)) => positive(key, &value.to_string()).map_err(in_file)?,
                (None, None) => return Ok(None),
            };
            Ok(Some(number.millimetres()))
        };
        // A decimal of milliseconds is read as one of millimetres is.
        let period_ms = number("--period", &arguments.period, "period_ms", file.period_ms)?;
        let tolerance_mm =
            number("--tolerance", &arguments.tolerance, "tolerance_mm", file.tolerance_mm)?;
        Ok(Some(Self {
            period_ms: period_ms.unwrap_or(PERIOD_MS),
            sampling: arguments.sampling.or(file.sampling).unwrap_or_default(),
            tolerance_mm,
            // The width of a machine of one level is far more than a sample needs.
            bits: given.bits.or(file.bits.filter(|_| is_of_file)),
            accelerate,
        }))
    }
}

/// The first option that is given.
fn unused(options: &[(bool, &'static str)]) -> Option<&'static str> {
    options.iter().find(|(is_given, _)| *is_given).map(|(_, option)| *option)
}
