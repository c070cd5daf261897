//! A run: commands one after another, to their end or cut short by a new command or a reset, with
//! and without stalls of the pulse source.

use super::bench::Bench;
use super::driven::Driven;
use super::engine::Engine;
use super::fault::Fault;
use super::reading::{Reading, place};
use super::stimulus::{self, Command};
use super::wave::ModelWave;
use fastrand::Rng;
use onepulse_core::Pulse;
use onepulse_hwmodel::Circuit;
use onepulse_hwmodel::trace::{Kind, SignalList};
use std::fmt;
use std::path::Path;

/// What to run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plan<'a> {
    pub(super) engine: Engine,
    pub(super) bits: u32,
    pub(super) seed: u64,
    pub(super) clocks: u64,
    /// Where the model writes its wave. Such a run compares nothing itself: the waves tell.
    pub(super) wave: Option<&'a Path>,
}

/// What was run.
#[derive(Debug)]
pub(super) struct Summary {
    pub(super) commands: u64,
    pub(super) resets: u64,
    pub(super) clocks: u64,
    /// The signals of the model's wave.
    pub(super) list: SignalList,
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { commands, resets, clocks, .. } = self;
        write!(f, "{commands:5} commands, {resets:4} resets, {clocks:7} clocks")
    }
}

impl Plan<'_> {
    /// Runs commands until this many clocks were compared.
    ///
    /// # Errors
    /// The first difference: command seed, command, clock, signal and both values.
    pub(super) fn run(self, bench: Bench) -> Result<Summary, Fault> {
        match self.engine {
            Engine::DdaLine => self.run_with(bench, stimulus::dda_line::<2>),
            Engine::DdaLine4 => self.run_with(bench, stimulus::dda_line::<4>),
            Engine::DdaArc => self.run_with(bench, stimulus::dda_arc),
            Engine::DdaCentredArc => self.run_with(bench, stimulus::dda_centred_arc),
            Engine::PpcLine => self.run_with(bench, stimulus::ppc_line),
            Engine::PpcArc => self.run_with(bench, stimulus::ppc_arc),
            Engine::BrmLine => self.run_with(bench, stimulus::brm_line),
            Engine::ComparisonLine => self.run_with(bench, stimulus::comparison_line),
            Engine::ComparisonArc => self.run_with(bench, stimulus::comparison_arc),
            Engine::MinimumDeviationArc => self.run_with(bench, stimulus::minimum_deviation_arc),
            Engine::ParabolaPpc => self.run_with(bench, stimulus::parabola_ppc),
            Engine::MinimumDeviationLine => {
                self.run_with(bench, stimulus::minimum_deviation_line::<2>)
            }
            Engine::MinimumDeviationLine4 => {
                self.run_with(bench, stimulus::minimum_deviation_line::<4>)
            }
        }
    }

    /// `draw` makes a command from random choices, or none where the circuit refuses it.
    fn run_with<C: Circuit<AXES>, const AXES: usize>(
        self,
        bench: Bench,
        draw: fn(&mut Rng, u32) -> Option<Command<C>>,
    ) -> Result<Summary, Fault> {
        let example = (0..).find_map(|seed| draw(&mut Rng::with_seed(seed), self.bits));
        let Some(example) = example else {
            return Err("the circuit refuses all".to_owned().into());
        };
        let mut run = Run::new(self, bench, &example)?;
        let mut random = Rng::with_seed(self.seed ^ u64::from(self.bits) << 32);
        run.clock(Edge::Reset)?;
        while run.bench.clocks() < self.clocks {
            // Everything is derived from one number, so that a command can be run again by itself.
            let seed = random.u64(..);
            let mut choice = Rng::with_seed(seed);
            let Some(command) = draw(&mut choice, self.bits) else { continue };
            let (what, at) = (command.what.clone(), run.bench.clocks());
            let place = || format!("command seed {seed}: {what}, loaded in clock {at}");
            run.command(command, &mut choice).map_err(|fault| fault.within(&place()))?;
        }
        run.finish()
    }
}

/// A model and the bench with its twin.
struct Run<'a, C, const AXES: usize> {
    plan: Plan<'a>,
    bench: Bench,
    wave: Option<ModelWave>,
    list: SignalList,
    /// The number in the list of each output's signal.
    places: Vec<usize>,
    model: Model<C>,
    /// The words of the command's ports.
    ports: Vec<u64>,
    commands: u64,
    resets: u64,
}

/// What the model knows of the registers.
enum Model<C> {
    /// Nothing, before the first reset.
    Off,
    Reset,
    Loaded(Driven<C>),
}

/// What the edge does that ends a clock.
enum Edge<C> {
    Reset,
    Load(C),
    Run,
    Stall,
}

impl<'a, C: Circuit<AXES>, const AXES: usize> Run<'a, C, AXES> {
    fn new(plan: Plan<'a>, bench: Bench, example: &Command<C>) -> Result<Self, String> {
        let list = signals(&example.circuit);
        let wave = plan.wave.map(|path| ModelWave::create(path, &list)).transpose()?;
        let mut places = Vec::new();
        for output in &bench.ports().outputs {
            let at = place(&list, &output.signal);
            places.push(at.ok_or_else(|| format!("the circuit has no {}", output.signal))?);
        }
        let ports = vec![0; example.words.len()];
        let model = Model::Off;
        Ok(Self { plan, bench, wave, list, places, model, ports, commands: 0, resets: 0 })
    }

    /// Loads a command and clocks it, to two clocks after done or until it is cut short.
    fn command(&mut self, command: Command<C>, choice: &mut Rng) -> Result<(), Fault> {
        self.commands += 1;
        self.ports = command.words;
        self.clock(Edge::Load(command.circuit))?;
        // What the ports have without i_load must not matter.
        self.ports.iter_mut().for_each(|word| *word = !*word);

        // Every order of magnitude alike, and no run is one command only.
        let left = (self.plan.clocks / 4) >> choice.u32(..16);
        let left = left.min(self.plan.clocks.saturating_sub(self.bench.clocks()));
        // Of 256 clocks: from a source that never stops to one much slower than the clock.
        let stalls = [0, 1, 64, 192][choice.usize(..4)];
        let mut after_done = 2;
        for _ in 0..left {
            let is_done = matches!(&self.model, Model::Loaded(driven) if driven.circuit.done());
            self.clock(if choice.u8(..) < stalls { Edge::Stall } else { Edge::Run })?;
            after_done -= u32::from(is_done);
            if after_done == 0 {
                break;
            }
        }
        if choice.u8(..4) == 0 {
            self.resets += 1;
            self.clock(Edge::Reset)?;
            for _ in 0..3 {
                self.clock(Edge::Run)?;
            }
        }
        self.bench.settle()
    }

    /// One clock: what the model shows goes to the bench and into the wave, and the edge follows.
    fn clock(&mut self, edge: Edge<C>) -> Result<(), Fault> {
        let is_enabled = matches!(edge, Edge::Run);
        let (resets, loads) = (matches!(edge, Edge::Reset), matches!(edge, Edge::Load(_)));
        let mut inputs = [resets, loads, is_enabled].map(u64::from).to_vec();
        inputs.extend(&self.ports);
        let outputs = self.shown(is_enabled);
        if let Some(wave) = &mut self.wave {
            wave.clock(|tracer| {
                for (place, word) in self.places.iter().zip(outputs.iter().flatten()) {
                    let is_round = *place < AROUND;
                    // The circuit shows its own signals, those without a port too.
                    if is_round || matches!(self.model, Model::Reset) {
                        tracer.set(*place, *word);
                    }
                }
                if let Model::Loaded(driven) = &self.model {
                    tracer.sample(AROUND, &driven.circuit);
                }
            });
        }
        let is_compared = self.wave.is_none();
        self.bench.clock(&inputs, outputs.as_deref().filter(|_| is_compared))?;
        match (edge, &mut self.model) {
            (Edge::Reset, model) => *model = Model::Reset,
            (Edge::Load(circuit), model) => *model = Model::Loaded(Driven::new(circuit)),
            (Edge::Run | Edge::Stall, Model::Loaded(driven)) => driven.edge(is_enabled),
            (Edge::Run | Edge::Stall, Model::Off | Model::Reset) => {}
        }
        Ok(())
    }

    /// The words of all outputs in a clock.
    fn shown(&self, is_enabled: bool) -> Option<Vec<u64>> {
        let driven = match &self.model {
            Model::Off => return None,
            Model::Reset => {
                let outputs = self.bench.ports().outputs.iter();
                return Some(outputs.map(|output| Engine::after_reset(&output.signal)).collect());
            }
            Model::Loaded(driven) => driven,
        };
        let Pulse(pulses) = driven.pulses(is_enabled);
        let bits = |holds: fn(i8) -> bool| {
            (0..AXES).map(|axis| u64::from(holds(pulses[axis])) << axis).sum::<u64>()
        };
        let around = vec![1, bits(|p| p != 0), bits(|p| p < 0), u64::from(driven.circuit.done())];
        let words = Reading::after(around, &driven.circuit).words;
        Some(self.places.iter().map(|place| words[*place]).collect())
    }

    fn finish(mut self) -> Result<Summary, Fault> {
        self.bench.settle()?;
        self.wave.map_or(Ok(()), ModelWave::finish)?;
        let (commands, resets, clocks) = (self.commands, self.resets, self.bench.clocks());
        Ok(Summary { commands, resets, clocks, list: self.list })
    }
}

/// The signals round the circuit, which come first in the list.
const AROUND: usize = 4;

/// The signals of a run: the clock, the outputs that every engine has, and the circuit.
fn signals<C: Circuit<AXES>, const AXES: usize>(circuit: &C) -> SignalList {
    let mut list = SignalList::new();
    list.add("clk", Kind::Bit);
    list.add("pulse", Kind::Unsigned(AXES as u32));
    list.add("negative", Kind::Unsigned(AXES as u32));
    list.add("done", Kind::Bit);
    list.add_circuit(circuit);
    list
}
