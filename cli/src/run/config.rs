//! The machine that a program runs on: `machine.toml`, and what the command line overrides.

use super::speed::Speed;
use super::two_level::TwoLevel;
use crate::args::{Options, RunArguments};
use crate::choice::{MethodName, PresetName};
use crate::cutters::Cutters;
use crate::failure::Failure;
use crate::machine_file::MachineFile;
use crate::motion_settings::MotionSettings;
use onepulse_plan::{Machine, Motion, Rate};

/// A machine.
#[derive(Clone, Debug)]
pub(super) struct Config {
    pub(super) machine: Machine,
    /// The width of the registers; of two levels, the most that the samples of a block may take.
    pub(super) bits: u32,
    pub(super) options: Options,
    /// Where blocks are sampled first.
    pub(super) two_level: Option<TwoLevel>,
    /// What the speeds are planned by, where they are.
    pub(super) motion: Option<MotionSettings>,
    pub(super) cutters: Cutters,
}

/// Wide enough for ±8 million pulses with the headroom bit that circles need.
const BITS: u32 = 24;

/// A rate multiplier takes 2ⁿ clocks for every line, however short.
const BRM_BITS: u32 = 16;

impl Config {
    /// The machine of a command line.
    pub(super) fn load(arguments: &RunArguments) -> Result<Self, Failure> {
        let machine_file = MachineFile::read(arguments.config.as_deref())?;
        let machine = machine_file.machine(arguments.pulse_mm.as_deref())?;
        let in_file = |why: String| machine_file.fault(why);
        let file = &machine_file.content;
        let given = &arguments.options;
        if given.radix.as_deref() == Some("10") {
            return Err(Failure::Usage("the circuits are binary: leave --radix 10 out".into()));
        }
        let two_level = TwoLevel::load(arguments, file, in_file)?;
        let motion = if two_level.is_some_and(|levels| levels.accelerate) {
            let period = arguments.period.as_deref();
            Some(MotionSettings::load(&arguments.motion, period, &machine_file)?)
        } else if let Some(option) = arguments.motion.given() {
            return Err(Failure::Usage(format!("{option} belongs to --accelerate")));
        } else {
            None
        };
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
        let cutters = arguments.cutters.load()?;
        Ok(Self { machine, bits, options, two_level, motion, cutters })
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
