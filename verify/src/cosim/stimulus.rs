//! Commands for both: worked examples, corners, and random ones, run to their end, cut short by a
//! new command or by a reset, with and without stalls of the pulse source.

use super::bench::{COMMON, opcode};
use super::engine::{Engine, Output};
use super::twin::Twin;
use onepulse_core::dda::{self as software, Preset, Radix, Register};
use onepulse_core::{Direction, EndRule, Error, Pulse, ppc as software_ppc};
use onepulse_hwmodel::trace::{Kind, Probe, SignalList};
use onepulse_hwmodel::{Circuit, brm, dda, ppc};

/// A co-simulation of one module at one width.
pub(super) struct Run {
    engine: Engine,
    bits: u32,
    twin: Twin,
    outputs: Vec<Output>,
    random: fastrand::Rng,
    commands: u64,
    clocks: u64,
}

/// What a clock showed, as words: pulse, negative, done, and the signals in the circuit's order.
struct Reading {
    words: Vec<u64>,
}

/// Clocks that are asked for at a time.
const BATCH: u64 = 512;

impl Run {
    pub(super) fn new(engine: Engine, bits: u32, twin: Twin, seed: u64) -> Self {
        let random = fastrand::Rng::with_seed(seed ^ u64::from(bits) << 32 ^ engine as u64);
        let outputs = engine.outputs(bits);
        Self { engine, bits, twin, outputs, random, commands: 0, clocks: 0 }
    }

    pub(super) const fn commands(&self) -> u64 {
        self.commands
    }

    pub(super) const fn clocks_run(&self) -> u64 {
        self.clocks
    }

    /// Runs commands until this many clocks were compared.
    pub(super) fn clocks(&mut self, clocks: u64) -> Result<(), String> {
        self.twin.give(&[opcode::RESET])?;
        while self.clocks < clocks {
            // Everything is derived from one number, so that a command can be run again by itself.
            let seed = self.random.u64(..);
            let mut choice = fastrand::Rng::with_seed(seed);
            self.command(&mut choice).map_err(|why| format!("command seed {seed}: {why}"))?;
        }
        Ok(())
    }

    fn command(&mut self, choice: &mut fastrand::Rng) -> Result<(), String> {
        let bits = self.bits;
        let preset = [Preset::Zero, Preset::Half, Preset::Full][choice.usize(..3)];
        let rule = [EndRule::Total, EndRule::PerAxis, EndRule::Larger][choice.usize(..3)];
        let normalize = choice.bool();
        let (start, end, direction) = arc(choice, bits);
        let point = |choice: &mut fastrand::Rng| [0; 2].map(|_| coordinate(choice, bits));
        match self.engine {
            Engine::DdaLine => {
                let end = point(choice);
                self.dda_line(end, preset, normalize, choice)
            }
            Engine::DdaLine4 => {
                let end = [0; 4].map(|_| coordinate(choice, bits));
                self.dda_line(end, preset, normalize, choice)
            }
            Engine::BrmLine => {
                let end = point(choice);
                let circuit = brm::Line::new(end, bits);
                self.follow(circuit, format!("{end:?}"), choice, |register| {
                    vec![register("value_x") | register("value_y") << bits, signs(end)]
                })
            }
            Engine::PpcLine => {
                let end = point(choice);
                let larger_is_y = end[0].unsigned_abs() < end[1].unsigned_abs();
                let circuit = ppc::Line::new(end, bits, rule);
                self.follow(circuit, format!("{end:?} {rule:?}"), choice, |register| {
                    vec![
                        register("end_x"),
                        register("end_y"),
                        signs(end),
                        rule as u64,
                        u64::from(larger_is_y),
                        register("e"),
                    ]
                })
            }
            Engine::PpcArc => {
                let what = format!("{start:?} {end:?} {direction:?} {rule:?}");
                let to_go = software_ppc::Arc::new(start, end, direction, rule);
                let [x, y] = to_go.map_or([0; 2], |arc| arc.pulses_to_go());
                let circuit = ppc::Arc::new(start, end, direction, bits, rule);
                self.follow(circuit, what, choice, |register| {
                    let mut words = vec![register("cx"), register("cy")];
                    words.extend(sweep(&register, direction));
                    words.extend([rule as u64, u64::from(x < y), register("e")]);
                    words
                })
            }
            Engine::DdaArc => {
                let what = format!("{start:?} {end:?} {direction:?} {preset:?} {normalize}");
                let unit = Register::new(Radix::Binary, bits).and_then(|register| {
                    software::Arc::new(start, end, direction, register, preset, normalize)
                });
                let unit = unit.map_or(0, |arc| 1 << arc.shift());
                let circuit = dda::Arc::new(start, end, direction, bits, preset, normalize);
                self.follow(circuit, what, choice, |register| {
                    let mut words = vec![register("jvx"), register("jvy"), register("jrx"), unit];
                    words.extend(sweep(&register, direction));
                    words
                })
            }
            Engine::DdaCentredArc => {
                let what = format!("{start:?} {end:?} {direction:?} {normalize}");
                let unit = Register::new(Radix::Binary, bits).and_then(|register| {
                    software::CentredArc::new(start, end, direction, register, normalize)
                });
                let unit = unit.map_or(0, |arc| 1 << arc.shift());
                let circuit = dda::CentredArc::new(start, end, direction, bits, normalize);
                self.follow(circuit, what, choice, |register| {
                    let mut words = ["x", "y", "jrx", "jry"].map(register).to_vec();
                    words.push(unit);
                    words.extend(sweep(&register, direction));
                    words
                })
            }
        }
    }

    fn dda_line<const AXES: usize>(
        &mut self,
        end: [i32; AXES],
        preset: Preset,
        normalize: bool,
        choice: &mut fastrand::Rng,
    ) -> Result<(), String> {
        let what = format!("{end:?} {preset:?} {normalize}");
        let (bits, is_wide) = (self.bits, AXES > 2);
        let circuit = dda::Line::new(end, bits, preset, normalize);
        self.follow(circuit, what, choice, |register| {
            let jv: Vec<_> =
                ["jvx", "jvy", "jvz", "jva"][..AXES].iter().map(|jv| register(jv)).collect();
            let mut words = if is_wide { jv } else { vec![jv[0] | jv[1] << bits] };
            words.extend([register("jrx"), register("je"), signs(end)]);
            words
        })
    }

    /// Loads a circuit's first register contents into the twin and clocks both. `load` makes the
    /// words of the command from the registers by name.
    fn follow<C: Circuit<AXES>, const AXES: usize>(
        &mut self,
        circuit: Result<C, Error>,
        what: String,
        choice: &mut fastrand::Rng,
        load: impl FnOnce(&dyn Fn(&str) -> u64) -> Vec<u64>,
    ) -> Result<(), String> {
        // What the circuit refuses never reaches the twin's registers.
        let Ok(mut circuit) = circuit else { return Ok(()) };
        let mut list = SignalList::new();
        list.add_circuit(&circuit);
        let place = |name: &str| list.signals().iter().position(|s| s.name == name);
        let first = read(&circuit, true);
        let register = |name: &str| place(name).map_or(0, |at| first.words[COMMON + at]);
        let mut words = vec![opcode::LOAD];
        words.extend(load(&register));
        self.twin.give(&words)?;
        self.commands += 1;

        let mut places = Vec::new();
        for output in &self.outputs {
            let at = place(output.signal);
            places.push(at.ok_or_else(|| format!("the circuit has no {}", output.signal))?);
        }
        let mut answer = vec![0; COMMON + self.outputs.len()];
        // Most commands run on for two clocks after done; long ones are cut short.
        let mut left = match choice.u8(..16) {
            0 | 1 => choice.u64(..200),
            2 => 1 << 17,
            _ => 1 << 12,
        };
        let mut after_done = 2;
        let mut clock = 0;
        while left > 0 && after_done > 0 {
            let is_stalled = choice.u8(..16) == 0;
            let batch = if is_stalled { 1 } else { choice.u64(1..=BATCH).min(left) };
            if is_stalled {
                self.twin.give(&[opcode::STALL])?;
            } else {
                self.twin.give(&[opcode::RUN, batch])?;
            }
            self.twin.send()?;
            for _ in 0..batch {
                self.twin.answer(&mut answer)?;
                let is_clocked = !is_stalled || circuit.is_mid_cycle();
                let reading = read(&circuit, is_clocked);
                self.compare(&reading, &places, &answer)
                    .map_err(|why| format!("{what}, clock {clock}: {why}"))?;
                after_done -= u64::from(circuit.done() && after_done > 0);
                if is_clocked {
                    circuit.clock();
                }
                clock += 1;
            }
            left -= batch.min(left);
            self.clocks += batch;
        }
        if choice.u8(..8) == 0 {
            self.reset()?;
        }
        Ok(())
    }

    /// After a reset nothing is left to do, and nothing is sent.
    fn reset(&mut self) -> Result<(), String> {
        self.twin.give(&[opcode::RESET, opcode::RUN, 3])?;
        self.twin.send()?;
        let mut answer = vec![0; COMMON + self.outputs.len()];
        for _ in 0..3 {
            self.twin.answer(&mut answer)?;
            if answer[0] != 0 || answer[2] != 1 {
                return Err("pulses or not done after a reset".to_owned());
            }
        }
        Ok(())
    }

    fn compare(&self, reading: &Reading, places: &[usize], answer: &[u64]) -> Result<(), String> {
        let differ = |signal: &str, model: u64, twin: u64| {
            Err(format!("{signal} is {model} in the model, {twin} in the twin"))
        };
        let [pulse, negative, done] = [0, 1, 2].map(|at| (reading.words[at], answer[at]));
        if pulse.0 != pulse.1 {
            return differ("pulse", pulse.0, pulse.1);
        }
        // A direction means something where there is a pulse.
        if negative.0 & pulse.0 != negative.1 & pulse.0 {
            return differ("negative", negative.0 & pulse.0, negative.1 & pulse.0);
        }
        if done.0 != done.1 {
            return differ("done", done.0, done.1);
        }
        for ((output, place), twin) in self.outputs.iter().zip(places).zip(&answer[COMMON..]) {
            let model = reading.words[COMMON + place] & (u64::MAX >> (64 - output.width));
            if model != *twin {
                return differ(output.signal, model, *twin);
            }
        }
        Ok(())
    }
}

impl Probe for Reading {
    fn axis_signal(&mut self, stem: &'static str, _: usize, kind: Kind, value: u64) {
        self.signal(stem, kind, value);
    }

    fn signal(&mut self, _: &'static str, kind: Kind, value: u64) {
        // A word's value is its place, whatever the number of bits.
        let bits = if let Kind::Word(_) = kind { 64 } else { kind.bits() };
        self.words.push(value & (u64::MAX >> (64 - bits)));
    }
}

fn read<C: Circuit<AXES>, const AXES: usize>(circuit: &C, is_enabled: bool) -> Reading {
    let Pulse(pulses) = if is_enabled { circuit.pulses() } else { Pulse::NONE };
    let bits = |holds: fn(i8) -> bool| {
        (0..AXES).map(|axis| u64::from(holds(pulses[axis])) << axis).sum::<u64>()
    };
    let words = vec![bits(|p| p != 0), bits(|p| p < 0), u64::from(circuit.done())];
    let mut reading = Reading { words };
    circuit.probe(&mut reading);
    reading
}

/// The sweep's part of an arc's command.
fn sweep(register: &dyn Fn(&str) -> u64, direction: Direction) -> [u64; 5] {
    let cw = u64::from(direction == Direction::Cw);
    [register("quadrant"), register("crossings"), cw, register("jex"), register("jey")]
}

fn signs<const AXES: usize>(end: [i32; AXES]) -> u64 {
    (0..AXES).map(|axis| u64::from(end[axis] < 0) << axis).sum()
}

/// A coordinate of up to `bits` bits: of any size, the corners more often.
fn coordinate(choice: &mut fastrand::Rng, bits: u32) -> i32 {
    let bits = bits.min(31);
    let largest = (1_i64 << bits) - 1;
    let magnitude = match choice.u8(..8) {
        0 => 0,
        1 => 1,
        2 => largest,
        3 => 1 << (bits - 1),
        // Every order of magnitude alike.
        _ => choice.i64(0..=largest) >> choice.u32(..bits),
    };
    (if choice.bool() { -magnitude } else { magnitude }) as i32
}

/// An arc that circuits of this width serve most of the time: between lattice points of one
/// circle, or ending off it.
fn arc(choice: &mut fastrand::Rng, bits: u32) -> ([i32; 2], [i32; 2], Direction) {
    let direction = if choice.bool() { Direction::Cw } else { Direction::Ccw };
    let small = choice.u32(2..bits.min(31));
    let start = [0; 2].map(|_| coordinate(choice, small));
    let [x, y] = start;
    let end = match choice.u8(..10) {
        0 => start,
        1 => [-x, -y],
        2 => [y, -x],
        3 => [-y, x],
        4 => [x, -y],
        5 => [y, x],
        6 => [x.saturating_add(choice.i32(-2..=2)), y.saturating_add(choice.i32(-2..=2))],
        7 => [y.saturating_add(choice.i32(-2..=2)), x],
        8 => [-x, y],
        _ => [0; 2].map(|_| coordinate(choice, small)),
    };
    (start, end, direction)
}
