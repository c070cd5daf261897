//! Everything that a run writes, block by block: nothing is kept.

use super::circuits::Circuits;
use super::config::Config;
use super::motion_signals::MotionSignals;
use super::picture::Picture;
use super::report::{Report, Summary};
use super::survey::Survey;
use crate::action::standstill;
use crate::args::RunArguments;
use crate::choice::Method;
use crate::failure::Failure;
use crate::motion_settings::MotionSettings;
use crate::output::{OutputFile, OutputFolder, write_whole};
use crate::profile::{Row, svg};
use crate::pulses::{AXES, write_row};
use onepulse_core::{Plane, Pulse};
use onepulse_hwmodel::Circuit;
use onepulse_hwmodel::trace::{BackgroundWriter, Bench, Kind, SignalList, Tracer, Vcd, gtkw, sucl};
use onepulse_plan::Motion;
use onepulse_plan::gcode::Pause;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::ops::Range;
use std::time::Duration;

/// The files of a run.
#[derive(Debug)]
pub(super) struct Outputs {
    /// The axes of all files: two, or with z three.
    axes: usize,
    pulses: BufWriter<File>,
    pulses_file: OutputFile,
    picture: Picture,
    waves: Option<Waves>,
    pub(super) report: Report,
    line: u32,
    /// The plot of a planned motion.
    profile: Option<OutputFile>,
    folder: OutputFolder,
}

/// When the cycles of a curve come.
#[derive(Clone, Copy, Debug)]
pub(super) enum Pace {
    /// So many a second.
    Even { cycles_per_second: f64 },
    /// So many, evenly, from the record before to the time of this one.
    Until { record: Row, cycles: u64 },
}

/// `waves.vcd`: the circuits of the method, one scope each, on one time axis.
#[derive(Debug)]
struct Waves {
    tracer: Tracer<Vcd<BackgroundWriter<File>>>,
    file: OutputFile,
    list: SignalList,
    bench: Bench,
    line: usize,
    program_line: u32,
    /// The axes of the circuit that runs, one of [`PLANES`]; only where z moves.
    plane: Option<(usize, u64)>,
    /// The sample clock of two levels: 1 in the first clock of a sample.
    sample: Option<usize>,
    motion: Option<MotionSignals>,
    /// The end of what was traced.
    traced_until: u64,
    circuits: Circuits,
    /// Clocks of the run so far, and those that are traced.
    run_clocks: u64,
    window: Range<u64>,
    /// When the curve began.
    start: u64,
    clocks: u64,
    clocks_per_second: f64,
    pace: Pace,
    /// The first signal of the circuit that runs.
    first: usize,
}

/// The time axis of a run counts picoseconds.
const EXPONENT: i8 = -12;
const TICKS_PER_SECOND: f64 = 1e12;

impl Outputs {
    /// Begins the files in the folder that the command line names.
    pub(super) fn create(
        arguments: &RunArguments,
        config: &Config,
        method: &Method,
        survey: &Survey,
    ) -> Result<Self, Failure> {
        let axes = survey.axes();
        let folder = OutputFolder::open(&arguments.out)?;
        let pulses_file = folder.create("pulses.csv")?;
        let mut pulses = pulses_file.writer()?;
        let deltas = AXES[..axes].iter().map(|axis| format!(",d{axis}"));
        let columns = deltas.chain(AXES[..axes].iter().map(|axis| format!(",{axis}")));
        let header = writeln!(pulses, "line,cycle{}", columns.collect::<String>());
        header.map_err(|error| pulses_file.failure(&error))?;
        let picture = Picture::begin(folder.create("path.svg")?, &survey.backdrop)?;
        let waves = match arguments.no_waves {
            true => None,
            false => {
                let RunArguments { from, clocks, .. } = *arguments;
                let window = (from, clocks.map_or(u64::MAX, |clocks| from.saturating_add(clocks)));
                Some(Waves::begin(folder.create("waves.vcd")?, config, method, survey, window)?)
            }
        };
        let program = arguments.program.display().to_string();
        let report = Report::begin(folder.create("report.json")?, &program, config, method)?;
        let profile = None;
        Ok(Self { axes, pulses, pulses_file, picture, waves, report, line: 0, profile, folder })
    }

    /// Plots a planned motion.
    pub(super) fn plot(&mut self, rows: &[Row]) -> Result<(), Failure> {
        self.profile =
            Some(write_whole(&self.folder.path().join("profile.svg"), &svg(rows, self.axes)?)?);
        Ok(())
    }

    /// Begins a block.
    pub(super) fn begin(&mut self, motion: &Motion) -> Result<(), Failure> {
        self.line = motion.line;
        if let Some(waves) = &mut self.waves {
            waves.program_line = motion.line;
        }
        self.picture.begin_block(motion)
    }

    /// Begins a curve of the block, which circuit C makes in a plane or in space.
    pub(super) fn begin_curve<C: Circuit<N>, const N: usize>(&mut self, pace: Pace, plane: Plane) {
        if let Some(waves) = &mut self.waves {
            waves.clocks = 0;
            waves.pace = pace;
            let cycles_per_second = match pace {
                Pace::Even { cycles_per_second } => cycles_per_second,
                // From where the wave is: one that had to be late makes up for it.
                Pace::Until { record, cycles } => {
                    let ticks = ticks(record.time).saturating_sub(waves.start);
                    cycles as f64 * (TICKS_PER_SECOND / ticks as f64)
                }
            };
            waves.clocks_per_second = cycles_per_second * C::CLOCKS_PER_CYCLE as f64;
            waves.first = waves.circuits.first::<C, N>();
            if let Some((_, axes)) = &mut waves.plane {
                *axes = if N > 2 { IN_SPACE } else { plane as u64 };
            }
        }
    }

    /// Gives the circuit a clock.
    pub(super) fn clock<C: Circuit<3>>(&mut self, circuit: &mut C) -> Pulse<3> {
        match &mut self.waves {
            Some(waves) => waves.clock(circuit),
            None => circuit.clock(),
        }
    }

    /// Takes the pulses of a cycle and the position after them.
    pub(super) fn pulse(
        &mut self,
        cycle: u64,
        pulse: Pulse<3>,
        position: [i64; 3],
    ) -> Result<(), Failure> {
        let mut digits = itoa::Buffer::new();
        let line = self.pulses.write_all(digits.format(self.line).as_bytes());
        let ([dx, dy, _], [x, y, _]) = (pulse.0, position);
        line.and_then(|()| self.pulses.write_all(b","))
            .and_then(|()| match self.axes {
                2 => write_row(&mut self.pulses, cycle, Pulse([dx, dy]), [x, y]),
                _ => write_row(&mut self.pulses, cycle, pulse, position),
            })
            .map_err(|error| self.pulses_file.failure(&error))?;
        self.picture.pulse(pulse)
    }

    /// Ends the curve, which took so many cycles.
    pub(super) fn end_curve<C: Circuit<3>>(
        &mut self,
        cycles: u64,
        circuit: &C,
    ) -> Result<(), Failure> {
        if let Some(waves) = &mut self.waves {
            let end = match waves.pace {
                Pace::Even { cycles_per_second } => {
                    let seconds = cycles as f64 / cycles_per_second;
                    waves.start.saturating_add((seconds * TICKS_PER_SECOND) as u64)
                }
                Pace::Until { record, .. } => {
                    if let Some(motion) = &mut waves.motion {
                        motion.reach(&record);
                    }
                    ticks(record.time)
                }
            };
            waves.start = end.max(waves.edge(2 * waves.clocks));
            let (first, start) = (waves.first, waves.start);
            if waves.window.contains(&waves.run_clocks) {
                waves.traced_until = start;
                waves.bench.sample(&mut waves.tracer, first, circuit, start);
                if let Some(motion) = &waves.motion {
                    motion.trace(&mut waves.tracer);
                }
            }
            waves.tracer.check().map_err(|error| waves.file.failure(&error))?;
        }
        Ok(())
    }

    /// Ends the block.
    pub(super) fn end(&mut self) -> Result<(), Failure> {
        self.picture.end_block()
    }

    /// Lets the time of a pause pass, where speeds are planned with these records: nothing is clocked.
    pub(super) fn pause(&mut self, pause: &Pause, records: &[Row]) -> Result<(), Failure> {
        let (Some(waves), Some(dwell)) = (&mut self.waves, standstill(pause)) else {
            return Ok(());
        };
        waves.rest(pause.place.line, dwell, records);
        waves.tracer.check().map_err(|error| waves.file.failure(&error))
    }

    /// Completes the files; only now they appear in the folder.
    pub(super) fn finish(mut self, summary: &Summary, config: &Config) -> Result<(), Failure> {
        self.pulses.flush().map_err(|error| self.pulses_file.failure(&error))?;
        let mut files = vec![self.pulses_file, self.picture.finish()?];
        files.extend(self.profile);
        if let Some(waves) = self.waves {
            let Waves { tracer, file, list, traced_until, pace, clocks_per_second, .. } = waves;
            let period = match (pace, config.motion) {
                // Of a whole sample period: the last part of one may be no time to speak of.
                (Pace::Until { cycles, .. }, Some(MotionSettings { period, .. })) => {
                    TICKS_PER_SECOND * period / cycles as f64
                }
                _ => TICKS_PER_SECOND / clocks_per_second,
            };
            tracer.finish(traced_until.saturating_add(1)).map_err(|error| file.failure(&error))?;
            let place = |name| self.folder.path().join(name);
            files.push(write_whole(&place("waves.gtkw"), &gtkw("waves.vcd", &list, period))?);
            files.push(write_whole(&place("waves.sucl"), &sucl("waves.vcd", &list))?);
            files.push(file);
        }
        files.push(self.report.finish(summary, config)?);
        files.into_iter().try_for_each(OutputFile::finish)
    }
}

impl Waves {
    fn begin(
        file: OutputFile,
        config: &Config,
        method: &Method,
        survey: &Survey,
        window: (u64, u64),
    ) -> Result<Self, Failure> {
        let mut list = SignalList::new();
        let axes = survey.axes();
        let bench = Bench::declare(&mut list, &[0; 3][..axes]);
        let line = list.add("program_line", Kind::Unsigned(32));
        let plane = (axes > 2).then(|| (list.add("plane", Kind::Word(&PLANES)), 0));
        let sample = config.two_level.map(|_| list.add("sample", Kind::Bit));
        let motion = config.motion.map(|motion| MotionSignals::declare(&mut list, &motion, axes));
        let circuits = Circuits::declare(&mut list, config, method, survey)
            .map_err(|why| Failure::Usage(format!("--bits {}: {why}", config.bits)))?;
        let writer = file.background_writer()?;
        let vcd = Vcd::new(writer, &list, EXPONENT).map_err(|error| file.failure(&error))?;
        Ok(Self {
            tracer: Tracer::new(vcd, &list),
            file,
            list,
            bench,
            line,
            program_line: 0,
            plane,
            sample,
            motion,
            traced_until: 0,
            circuits,
            run_clocks: 0,
            window: window.0..window.1,
            start: 0,
            clocks: 0,
            clocks_per_second: 1.0,
            pace: Pace::Even { cycles_per_second: 1.0 },
            first: 0,
        })
    }

    /// When a half period of the curve's clock begins.
    fn edge(&self, half_periods: u64) -> u64 {
        let seconds = half_periods as f64 / 2.0 / self.clocks_per_second;
        // An edge at least a tick after the other, however fast the clock.
        self.start.saturating_add(((seconds * TICKS_PER_SECOND) as u64).max(half_periods))
    }

    /// Goes on by the time of a dwell, or to the last of its records, without a clock.
    fn rest(&mut self, line: u32, dwell: Duration, records: &[Row]) {
        let end = |record: &Row| ticks(record.time);
        let even = self.start.saturating_add(ticks(dwell.as_secs_f64()));
        // The clock falls a tick after its last edge at least, and rises a tick later at least.
        let until = records.last().map_or(even, end).max(self.start.saturating_add(2));
        let first = records.first().map_or(until, end).max(self.start.saturating_add(2));
        let is_traced = self.window.contains(&self.run_clocks);
        if is_traced {
            let half = (TICKS_PER_SECOND / self.clocks_per_second / 2.0) as u64;
            let room = (first - self.start) / 2;
            // Before the first clock there is no edge to fall from.
            let high = if self.run_clocks == 0 { 0 } else { half.max(1).min(room) };
            self.tracer.at(self.start);
            self.tracer.set(self.line, u64::from(line));
            if let Some(sample) = self.sample {
                self.tracer.set(sample, 0);
            }
            if let Some(motion) = &self.motion {
                motion.trace(&mut self.tracer);
            }
            self.bench.rest(&mut self.tracer, self.start.saturating_add(high));
            self.traced_until = until;
        }
        for record in records {
            let Some(motion) = &mut self.motion else { break };
            motion.reach(record);
            if is_traced {
                self.tracer.at(end(record).max(first));
                motion.trace(&mut self.tracer);
            }
        }
        self.start = until;
    }

    fn clock<C: Circuit<3>>(&mut self, circuit: &mut C) -> Pulse<3> {
        let (rise, fall) = (self.edge(2 * self.clocks), self.edge(2 * self.clocks + 1));
        let is_traced = self.window.contains(&self.run_clocks);
        let is_first = self.clocks == 0;
        self.clocks += 1;
        self.run_clocks += 1;
        if is_traced {
            self.traced_until = fall;
            self.tracer.at(rise);
            self.tracer.set(self.line, u64::from(self.program_line));
            if let Some((signal, axes)) = self.plane {
                self.tracer.set(signal, axes);
            }
            if let Some(sample) = self.sample {
                self.tracer.set(sample, u64::from(is_first));
            }
            if let Some(motion) = &self.motion {
                motion.trace(&mut self.tracer);
            }
            self.bench.clock(&mut self.tracer, self.first, circuit, rise, fall)
        } else {
            self.bench.skip(circuit)
        }
    }
}

/// The axes of a circuit, in its order: those of a [`Plane`], or all.
static PLANES: [&str; 4] = ["xy", "zx", "yz", "xyz"];
const IN_SPACE: u64 = 3;

/// The tick of the time axis at a time in seconds.
fn ticks(seconds: f64) -> u64 {
    (seconds * TICKS_PER_SECOND).round() as u64
}
