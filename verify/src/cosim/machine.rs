//! The whole interpolator: commands by handshake, with gaps and without, wrong ones among them;
//! drives' times that change; refusals that are seen late; resets at any moment.

use super::bench::Bench;
use super::fault::Fault;
use super::ports::{Output, Port, Ports};
use super::reading::Reading;
use super::run::Summary;
use super::wave::ModelWave;
use fastrand::Rng;
use onepulse_core::Direction::{Ccw, Cw};
use onepulse_core::dda::Preset;
use onepulse_hwmodel::Timing;
use onepulse_hwmodel::interpolator::{Command, Inputs, Interpolator, Refusal};
use onepulse_hwmodel::trace::{Kind, Signal, SignalList};
use std::path::Path;

/// What to run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plan<'a> {
    pub(super) bits: u32,
    pub(super) axes: usize,
    pub(super) seed: u64,
    pub(super) clocks: u64,
    /// Where the model writes its wave. Such a run compares nothing itself: the waves tell.
    pub(super) wave: Option<&'a Path>,
}

/// Signals of which the twin has a vector, one element an axis.
const VECTORS: &[(&str, &str)] = &[
    ("interpolator", "pulse_"),
    ("interpolator", "negative_"),
    ("interpolator", "step_"),
    ("interpolator", "dir_"),
    ("interpolator", "pending_"),
    ("interpolator", "want_"),
    ("interpolator", "turned_"),
    ("interpolator", "timer_"),
    ("interpolator", "guard_"),
    ("decoder", "first_"),
    ("decoder", "negative_"),
    ("decoder", "start_negative_"),
    ("decoder", "start_"),
    ("decoder", "end_"),
    ("dda_line", "jv"),
    ("dda_line", "jr"),
    ("dda_line", "negative_"),
    ("ppc_line", "negative_"),
    ("brm_line", "value_"),
    ("brm_line", "negative_"),
];

/// Wires that the model shows and the twin keeps to itself; each is decoded from registers that are
/// compared.
const WIRES: &[&str] = &["fifo_valid", "fifo_ready", "carry_", "train_"];

impl Plan<'_> {
    /// The module as the bench sees it: every register that the model shows has a port.
    pub(super) fn ports(&self) -> Result<Ports, String> {
        match self.axes {
            2 => self.ports_of::<2>(),
            3 => self.ports_of::<3>(),
            _ => self.ports_of::<4>(),
        }
    }

    fn ports_of<const AXES: usize>(&self) -> Result<Ports, String> {
        let width = self.width();
        let bit = |name| Port::whole(name, 1);
        let mut inputs = vec![bit("i_rst"), bit("i_valid"), Port::whole("i_curve", 3)];
        inputs.extend(Port::each("i_start", width, 2));
        inputs.extend(Port::each("i_end", width, AXES));
        inputs.extend([bit("i_cw"), Port::whole("i_preset", 2), bit("i_normalize")]);
        inputs.push(Port::whole("i_period", Interpolator::<AXES>::PERIOD_BITS));
        inputs.push(bit("i_clear"));
        let times = ["i_length", "i_space", "i_setup", "i_hold"];
        inputs.extend(times.map(|name| Port::whole(name, Interpolator::<AXES>::TIMER_BITS)));
        let list = signals(&model::<AXES>(self.bits)?);
        let outputs = list.signals().iter().filter_map(output).collect();
        let parameters = vec![("N", self.bits), ("AXES", AXES as u32)];
        Ok(Ports { module: Interpolator::<AXES>::NAME, parameters, inputs, outputs })
    }

    /// Bits of a coordinate on the ports.
    const fn width(&self) -> u32 {
        if self.bits < 32 { self.bits + 1 } else { 32 }
    }

    /// Runs so many clocks.
    ///
    /// # Errors
    /// The first difference: clock, signal and both values.
    pub(super) fn run(self, bench: Bench) -> Result<Summary, Fault> {
        match self.axes {
            2 => self.run_with::<2>(bench),
            3 => self.run_with::<3>(bench),
            _ => self.run_with::<4>(bench),
        }
    }

    fn run_with<const AXES: usize>(self, mut bench: Bench) -> Result<Summary, Fault> {
        let mut machine = model::<AXES>(self.bits)?;
        let list = signals(&machine);
        let mut wave = self.wave.map(|path| ModelWave::create(path, &list)).transpose()?;
        let shown = list.signals().iter().enumerate();
        let places: Vec<_> =
            shown.filter(|(_, signal)| output(signal).is_some()).map(|(at, _)| at).collect();
        let mut host = Host::new(&self);
        let (mut commands, mut resets) = (0, 0);
        for clock in 0..self.clocks {
            let mut inputs = host.inputs(&machine);
            // Before the first reset the registers may have any content.
            inputs.reset |= clock == 0;
            resets += u64::from(inputs.reset);
            commands += u64::from(inputs.command.is_some() && machine.ready() && !inputs.reset);
            let mut reading = Reading { words: vec![1] };
            machine.probe(&mut reading);
            let outputs: Vec<_> = places.iter().map(|place| reading.words[*place]).collect();
            if let Some(wave) = &mut wave {
                wave.clock(|tracer| {
                    if clock > 0 {
                        machine.probe(&mut tracer.from(1));
                    }
                });
            }
            let is_compared = wave.is_none() && clock > 0;
            let expected = Some(&*outputs).filter(|_| is_compared);
            bench.clock(&host.words(&inputs), expected)?;
            machine.clock(&inputs);
        }
        bench.settle()?;
        wave.map_or(Ok(()), ModelWave::finish)?;
        Ok(Summary { commands, resets, clocks: self.clocks, list })
    }
}

fn model<const AXES: usize>(bits: u32) -> Result<Interpolator<AXES>, String> {
    Interpolator::new(bits).map_err(|why| why.to_string())
}

/// The clock and the interpolator.
fn signals<const AXES: usize>(machine: &Interpolator<AXES>) -> SignalList {
    let mut list = SignalList::new();
    list.add("clk", Kind::Bit);
    machine.probe(&mut list);
    list
}

/// The port that shows a signal of the model, if one does.
fn output(signal: &Signal) -> Option<Output> {
    let Signal { scope, name, kind } = signal;
    if scope.is_empty() || WIRES.iter().any(|wire| name.starts_with(wire)) {
        return None;
    }
    let prefix = if *scope == "interpolator" { String::new() } else { format!("{scope}_") };
    let width = match kind {
        Kind::Word(words) => words.len().next_power_of_two().ilog2(),
        _ => kind.bits(),
    };
    let element = VECTORS.iter().find_map(|(of, stem)| {
        let letter = name.strip_prefix(stem).filter(|_| of == scope)?;
        Some((stem.trim_end_matches('_'), "xyza".find(letter)?))
    });
    let port = match element {
        Some((vector, axis)) => {
            Port { name: format!("o_{prefix}{vector}"), low: axis as u32 * width, width }
        }
        None => Port::whole(format!("o_{prefix}{name}"), width),
    };
    Some(Output::new(format!("{scope}_{name}"), port))
}

/// Who gives the commands.
struct Host<const AXES: usize> {
    random: Rng,
    bits: u32,
    width: u32,
    /// Commands to begin with.
    examples: Vec<Command<AXES>>,
    /// What stands on the ports, and whether it is meant.
    command: Command<AXES>,
    is_offered: bool,
    /// Of 256 clocks without an offer, in how many a new one is made.
    eagerness: u8,
    timing: Timing,
}

impl<const AXES: usize> Host<AXES> {
    fn new(plan: &Plan<'_>) -> Self {
        let seed = plan.seed ^ u64::from(plan.bits) << 32 ^ (AXES as u64) << 40;
        let mut examples = worked_examples();
        examples.reverse();
        let command = examples[0];
        Self {
            random: Rng::with_seed(seed),
            bits: plan.bits,
            width: plan.width(),
            examples,
            command,
            is_offered: false,
            eagerness: 255,
            timing: Timing { length: 2, space: 2, setup: 2, hold: 2 },
        }
    }

    /// The ports of the next clock.
    fn inputs(&mut self, machine: &Interpolator<AXES>) -> Inputs<AXES> {
        if !self.is_offered {
            // What stands on the ports without valid must not matter.
            self.command = draw(&mut self.random, self.bits, self.width);
            if self.random.u8(..) <= self.eagerness {
                self.is_offered = true;
                self.command = self.examples.pop().unwrap_or(self.command);
            }
        }
        if self.examples.is_empty() && self.random.u8(..) == 0 {
            self.eagerness = [0, 4, 64, 255][self.random.usize(..4)];
            let mut time = || self.random.u32(..20) >> self.random.u32(..5);
            self.timing = Timing { length: time(), space: time(), setup: time(), hold: time() };
        }
        let is_refused = machine.error() != Refusal::None;
        let inputs = Inputs {
            // Long curves are cut short so, too.
            reset: self.examples.is_empty() && self.random.u16(..1500) == 0,
            command: self.is_offered.then_some(self.command),
            clear: self.random.u8(..if is_refused { 8 } else { 64 }) == 0,
            timing: self.timing,
        };
        if machine.ready() && !inputs.reset {
            self.is_offered = false;
        }
        inputs
    }

    /// Those ports as words.
    fn words(&self, inputs: &Inputs<AXES>) -> Vec<u64> {
        let Command { curve, start, end, cw, preset, normalize, period } = self.command;
        let port = |c: i64| c as u64 & (u64::MAX >> (64 - self.width));
        let valid = inputs.command.is_some();
        let mut words = vec![u64::from(inputs.reset), u64::from(valid), u64::from(curve)];
        words.extend(start.map(port));
        words.extend(end.map(port));
        words.extend([u64::from(cw), u64::from(preset), u64::from(normalize)]);
        words.extend([u64::from(period), u64::from(inputs.clear)]);
        let Timing { length, space, setup, hold } = inputs.timing;
        words.extend([length, space, setup, hold].map(u64::from));
        words
    }
}

/// The worked examples of the textbooks.
fn worked_examples<const AXES: usize>() -> Vec<Command<AXES>> {
    let point = |x, y| {
        let mut end = [0; AXES];
        end[0] = x;
        end[1] = y;
        end
    };
    vec![
        Command::ppc_line(point(5, 3), 6),
        Command::ppc_line(point(3, 5), 6),
        Command::ppc_arc([5, 0], [0, 5], Ccw, 6),
        Command::dda_line(point(4, 6), Preset::Zero, true, 6),
        Command::dda_line(point(8, -6), Preset::Half, true, 7),
        Command::dda_arc([5, 0], [0, 5], Ccw, Preset::Zero, true, 6),
        Command::dda_centred_arc([3, 4], [3, 4], Cw, true, 9),
        Command::dda_line(point(10, 6), Preset::Full, true, 6),
    ]
}

/// A command of any kind; most are short, and few are wrong.
fn draw<const AXES: usize>(random: &mut Rng, bits: u32, width: u32) -> Command<AXES> {
    let size = match random.u8(..8) {
        0 => random.u32(1..width),
        1 => width - 1,
        _ => random.u32(1..5),
    };
    let mut coordinate = || {
        let largest = (1_i64 << size.min(width - 1)) - 1;
        let magnitude = match random.u8(..16) {
            0 | 1 => 0,
            2 => largest,
            3 => 1,
            // The most negative number, now and then.
            4 if size == width - 1 => return -largest - 1,
            _ => random.i64(0..=largest),
        };
        if random.bool() { -magnitude } else { magnitude }
    };
    let start = [coordinate(), coordinate()];
    let mut end = [0; AXES].map(|_| coordinate());
    // Rate multiplication takes all clocks of its register.
    let curves: &[u8] =
        if bits > 8 { &[0, 0, 0, 1, 1, 2, 2, 3, 4, 4] } else { &[0, 1, 1, 2, 2, 3, 4, 4, 5] };
    let curve =
        if random.u8(..32) == 0 { random.u8(..8) } else { curves[random.usize(..curves.len())] };
    if matches!(curve, 1..=4) && random.u8(..8) > 0 {
        end[2..].fill(0);
        let [x, y] = start;
        let on_circle = [[x, y], [-x, -y], [y, -x], [-y, x], [-x, y], [y, x], [x, -y]];
        if let Some(point) = on_circle.get(random.usize(..10)) {
            end[..2].copy_from_slice(point);
        }
    }
    Command {
        curve,
        start,
        end,
        cw: random.bool(),
        preset: if random.u8(..32) == 0 { 3 } else { random.u8(..3) },
        normalize: random.u8(..8) > 0,
        period: match random.u8(..32) {
            0 => random.u32(..6),
            1 => random.u32(..1 << 24),
            _ => random.u32(6..16),
        },
    }
}
