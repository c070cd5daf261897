//! `onepulse wave --interpolator`: one curve as a command to the whole interpolator.

use crate::args::Options;
use crate::choice::{EndRuleName, Method, UpdateName};
use crate::curve::Curve;
use crate::failure::Failure;
use crate::machine;
use onepulse_core::dda::{Preset, Radix, Register};
use onepulse_core::{Error, Pulse};
use onepulse_hwmodel::interpolator::{Command, Curve as Engine, Inputs, Interpolator, Refusal};
use onepulse_hwmodel::trace::{Kind, Probe};
use onepulse_hwmodel::{Circuit, Timing, brm, dda, ppc};
use std::str::FromStr;

/// Clocks before the command comes, and after the interpolator is done.
const LEAD: u64 = 2;
const TAIL: u64 = 8;

/// An interpolator and what stands on its ports: one command, the drives' times, nothing else.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Host<const AXES: usize> {
    interpolator: Interpolator<AXES>,
    command: Command<AXES>,
    timing: Timing,
    is_taken: bool,
    clocks: u64,
    /// Clocks since the interpolator is done.
    done_for: u64,
}

impl<const AXES: usize> Host<AXES> {
    /// An interpolator of `bits` bits, or of as few as serve the command.
    fn new(command: Command<AXES>, timing: Timing, bits: Option<u32>) -> Result<Self, Failure> {
        let usage = |why: Error| machine::Refusal::Machine(why).usage();
        // The ports take the low bits only: here nobody may lose a high one.
        let coordinates = command.start.iter().chain(&command.end);
        let largest = coordinates.map(|c| c.unsigned_abs() as u32).max().unwrap_or(0);
        let needed = Register::holding(Radix::Binary, largest).digits().max(2);
        let build = |bits| {
            let interpolator = Interpolator::new(bits).map_err(usage)?;
            Ok(Self { interpolator, command, timing, is_taken: false, clocks: 0, done_for: 0 })
        };
        if let Some(bits) = bits {
            let host = build(bits)?;
            if bits < needed {
                return Err(usage(Error::RegisterTooNarrow { digits: bits, needed }));
            }
            return host.accepted();
        }
        let mut bits = needed;
        loop {
            let host: Self = build(bits)?;
            match host.refusal() {
                Refusal::TooLarge if bits < u32::BITS => bits += 1,
                _ => return host.accepted(),
            }
        }
    }

    fn accepted(self) -> Result<Self, Failure> {
        let why = match self.refusal() {
            Refusal::None => return Ok(self),
            Refusal::Curve => "it has no such curve",
            Refusal::Preset => "it has no such preset",
            Refusal::Coordinate => {
                "a coordinate is out of range, or of an axis that the curve lacks"
            }
            Refusal::Centre => "an arc cannot start or end in its centre",
            Refusal::TooLarge => "its registers do not hold the circle (--bits)",
            Refusal::Period => "it needs at least 6 clocks from a cycle to the next (--period)",
        };
        Err(Failure::Usage(format!("the interpolator refuses the command: {why}")))
    }

    /// What the interpolator says to the command.
    fn refusal(mut self) -> Refusal {
        while !self.is_taken || !self.interpolator.ready() {
            if self.interpolator.error() != Refusal::None {
                break;
            }
            self.clock();
        }
        self.interpolator.error()
    }

    fn is_valid(&self) -> bool {
        self.clocks >= LEAD && !self.is_taken
    }
}

impl<const AXES: usize> Circuit<AXES> for Host<AXES> {
    const CLOCKS_PER_CYCLE: u64 = 1;
    const NAME: &'static str = Interpolator::<AXES>::NAME;

    fn pulses(&self) -> Pulse<AXES> {
        self.interpolator.pulses()
    }

    fn done(&self) -> bool {
        self.done_for > TAIL
    }

    fn clock(&mut self) -> Pulse<AXES> {
        let pulses = self.pulses();
        let command = self.is_valid().then_some(self.command);
        self.is_taken |= command.is_some() && self.interpolator.ready();
        self.interpolator.clock(&Inputs { command, timing: self.timing, ..Inputs::default() });
        self.clocks += 1;
        let is_done = self.is_taken && self.interpolator.done();
        self.done_for += u64::from(is_done);
        pulses
    }

    fn probe(&self, probe: &mut impl Probe) {
        // The outputs and the handshake belong on top, beside the clock.
        probe.scope("");
        for (axis, step) in self.interpolator.steps().into_iter().enumerate() {
            probe.axis_signal("step_", axis, Kind::Bit, step.into());
        }
        for (axis, dir) in self.interpolator.dirs().into_iter().enumerate() {
            probe.axis_signal("dir_", axis, Kind::Bit, dir.into());
        }
        probe.signal("valid", Kind::Bit, self.is_valid().into());
        self.interpolator.probe(probe);
    }
}

/// Something to be done with a host.
pub(crate) trait Visitor {
    type Output;

    /// Takes the host, where the curve starts, and the name of the engine that runs.
    fn visit<const AXES: usize>(
        self,
        host: Host<AXES>,
        start: [i64; AXES],
        engine: &str,
    ) -> Self::Output;
}

/// Makes the curve a command of that period, and shows the visitor an interpolator that takes it.
pub(crate) fn with_host<V: Visitor>(
    curve: &Curve,
    method: &Method,
    options: &Options,
    period: u32,
    timing: Timing,
    visitor: V,
) -> Result<V::Output, Failure> {
    if !matches!(options.end_rule, None | Some(EndRuleName::PerAxis)) {
        let why =
            "--end-rule: the interpolator counts an axis at a time: leave it out, or per-axis";
        return Err(Failure::Usage(why.into()));
    }
    let bits = options.bits;
    match curve {
        Curve::Line { to } => match *to.as_slice() {
            [x, y] => line([x, y], method, bits, period, timing, visitor),
            [x, y, z] => line([x, y, z], method, bits, period, timing, visitor),
            [x, y, z, a] => line([x, y, z, a], method, bits, period, timing, visitor),
            _ => Err(machine::Refusal::Method("a line has 2 to 4 axes").usage()),
        },
        &Curve::Arc { from, to, direction } => {
            let command = match *method {
                Method::Ppc { .. } => Command::ppc_arc(from, to, direction, period),
                Method::Dda { preset, normalize, update: UpdateName::Simultaneous, .. } => {
                    let preset = preset.unwrap_or_default();
                    Command::dda_arc(from, to, direction, preset, normalize, period)
                }
                Method::Dda { preset: None | Some(Preset::Half), normalize, .. } => {
                    Command::dda_centred_arc(from, to, direction, normalize, period)
                }
                Method::Dda { .. } => return Err(machine::HALF_LOAD_ONLY.usage()),
                Method::Brm { .. } => return Err(machine::LINES_ONLY.usage()),
                Method::MinDeviation | Method::Vector | Method::CompareIntegral => {
                    return Err(machine::NO_ENGINE.usage());
                }
            };
            show(Host::new(command, timing, bits)?, from.map(i64::from), visitor)
        }
        Curve::Parabola { .. } | Curve::Helix { .. } => Err(machine::NO_ENGINE.usage()),
    }
}

fn line<V: Visitor, const AXES: usize>(
    to: [i32; AXES],
    method: &Method,
    bits: Option<u32>,
    period: u32,
    timing: Timing,
    visitor: V,
) -> Result<V::Output, Failure> {
    let command = match *method {
        Method::Ppc { .. } => Command::ppc_line(to, period),
        Method::Dda { preset, normalize, .. } => {
            Command::dda_line(to, preset.unwrap_or_default(), normalize, period)
        }
        Method::Brm { smoothing: 0 } => Command::brm_line(to, period),
        Method::Brm { .. } | Method::MinDeviation | Method::Vector | Method::CompareIntegral => {
            return Err(machine::NO_ENGINE.usage());
        }
    };
    show(Host::new(command, timing, bits)?, [0; AXES], visitor)
}

fn show<V: Visitor, const AXES: usize>(
    host: Host<AXES>,
    start: [i64; AXES],
    visitor: V,
) -> Result<V::Output, Failure> {
    let engine = match Engine::from_code(host.command.curve) {
        Some(Engine::DdaLine) => dda::Line::<AXES>::NAME,
        Some(Engine::DdaArc) => dda::Arc::NAME,
        Some(Engine::DdaCentredArc) => dda::CentredArc::NAME,
        Some(Engine::PpcLine) => ppc::Line::NAME,
        Some(Engine::PpcArc) => ppc::Arc::NAME,
        Some(Engine::BrmLine) => brm::Line::<AXES>::NAME,
        None => "",
    };
    Ok(visitor.visit(host, start, engine))
}

/// The drives' times as the command line gives them: length, space, setup, hold.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DriveTimes(pub(crate) Timing);

impl FromStr for DriveTimes {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let longest = (1 << Interpolator::<2>::TIMER_BITS) - 1;
        let clocks = |word: &str| match word.parse() {
            Ok(clocks) if (1..=longest).contains(&clocks) => Ok(clocks),
            _ => Err(format!("'{word}' is not a number of clocks from 1 to {longest}")),
        };
        match *text.split(',').map(clocks).collect::<Result<Vec<u32>, _>>()? {
            [length, space, setup, hold] => Ok(Self(Timing { length, space, setup, hold })),
            ref times => Err(format!("4 times are needed, as in 2,2,2,2: here is {}", times.len())),
        }
    }
}
