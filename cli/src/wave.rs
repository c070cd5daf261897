//! `onepulse wave`: the hardware model's wave of one curve.

use crate::args::WaveArguments;
use crate::choice::Method;
use crate::failure::Failure;
use crate::interpolator::{self, Host, with_host};
use crate::machine::{Refusal, Visitor, with_machines};
use crate::output::{OutputFile, write_whole};
use onepulse_core::Pulse;
use onepulse_core::dda::Radix;
use onepulse_hwmodel::trace::{Bench, Clock, Fst, SignalList, Tracer, Vcd, Wave, gtkw, sucl};
use onepulse_hwmodel::{Circuit, Timing};
use std::io;
use std::path::Path;

pub(crate) fn wave(arguments: &WaveArguments) -> Result<(), Failure> {
    let options = &arguments.curve.options;
    let method = Method::from_options(options).map_err(Failure::Usage)?;
    if matches!(method, Method::Dda { radix: Radix::Decimal, .. }) {
        return Err(Failure::Usage("the circuits are binary: leave --radix 10 out".into()));
    }
    let Some(path) = &arguments.output else {
        return Err(Failure::Usage("where to? add -o FILE.vcd or -o FILE.fst".into()));
    };
    let window = Window { from: arguments.from_clock, clocks: arguments.clocks };
    let recording = Recording { path, source_hz: arguments.source_hz, window };
    let curve = arguments.curve.curve();
    if arguments.interpolator {
        let period = arguments.period.unwrap_or(PERIOD);
        let timing = arguments.step_clocks.map_or(TIMING, |times| times.0);
        let timed = Timed { recording, period };
        return with_host(&curve, &method, options, period, timing, timed)?;
    }
    let of_interpolator = [
        (arguments.period.is_some(), "--period"),
        (arguments.step_clocks.is_some(), "--step-clocks"),
    ];
    if let Some((_, option)) = of_interpolator.iter().find(|(is_given, _)| *is_given) {
        return Err(Failure::Usage(format!("{option} belongs to --interpolator")));
    }
    with_machines(&curve, &method, options.bits, recording).map_err(Refusal::usage)?
}

/// Clocks from one interpolation cycle to the next, where the command line does not say.
const PERIOD: u32 = 8;

/// A drive's times, likewise.
const TIMING: Timing = Timing { length: 2, space: 2, setup: 2, hold: 2 };

struct Recording<'a> {
    path: &'a Path,
    source_hz: u64,
    window: Window,
}

/// The clocks that are traced.
#[derive(Clone, Copy)]
struct Window {
    from: u64,
    clocks: Option<u64>,
}

impl Visitor for Recording<'_> {
    type Output = Result<(), Failure>;

    fn visit<S, C, const N: usize>(
        self,
        _: S,
        circuit: impl FnOnce() -> Result<C, Refusal>,
        start: [i64; N],
    ) -> Result<(), Failure>
    where
        S: Iterator<Item = Pulse<N>>,
        C: Circuit<N>,
    {
        let circuit = circuit().map_err(Refusal::usage)?;
        let shown = Shown { parts: &["", C::NAME], zoom: 1.0 };
        self.write(circuit, start, C::CLOCKS_PER_CYCLE, &shown)
    }
}

/// A recording of the whole interpolator.
struct Timed<'a> {
    recording: Recording<'a>,
    period: u32,
}

impl interpolator::Visitor for Timed<'_> {
    type Output = Result<(), Failure>;

    fn visit<const AXES: usize>(
        self,
        host: Host<AXES>,
        start: [i64; AXES],
        engine: &str,
    ) -> Result<(), Failure> {
        // The outputs, then how the command becomes a curve and the curve pulses, then all else.
        let parts = &[
            "",
            "interpolator.ready",
            "interpolator.running",
            "interpolator.done",
            "decoder.state",
            engine,
            "interpolator",
            "decoder",
        ];
        let shown = Shown { parts, zoom: f64::from(self.period) / 2.0 };
        self.recording.write(host, start, self.period.into(), &shown)
    }
}

/// What a layout shows of a wave.
struct Shown<'a> {
    /// Scopes and signals, see [`SignalList::arranged`].
    parts: &'a [&'a str],
    /// How many clocks take the room that a clock of a bare circuit has.
    zoom: f64,
}

impl Recording<'_> {
    /// Writes the wave, and layouts for viewers.
    fn write<C: Circuit<N>, const N: usize>(
        self,
        circuit: C,
        start: [i64; N],
        clocks_per_cycle: u64,
        shown: &Shown<'_>,
    ) -> Result<(), Failure> {
        let clock = self.source_hz.checked_mul(clocks_per_cycle).and_then(Clock::new);
        let Some(clock) = clock else {
            let fastest = Clock::FASTEST / clocks_per_cycle;
            return Err(Failure::Usage(format!("--source-hz is 1 to {fastest} here")));
        };
        let mut list = SignalList::new();
        let bench = Bench::declare(&mut list, &start);
        let first = list.add_circuit(&circuit);

        let file_name = self.path.file_name().unwrap_or_default().to_string_lossy();
        let file = OutputFile::create(self.path)?;
        let failure = |error: io::Error| file.failure(&error);
        match self.path.extension().and_then(|extension| extension.to_str()) {
            Some("vcd") => {
                let writer = file.background_writer()?;
                let wave = Vcd::new(writer, &list, clock.exponent()).map_err(failure)?;
                record(Tracer::new(wave, &list), bench, first, circuit, clock, self.window)
                    .map_err(failure)?;
            }
            Some("fst") => {
                let wave = Fst::new(file.writer()?, &list, clock.exponent()).map_err(failure)?;
                record(Tracer::new(wave, &list), bench, first, circuit, clock, self.window)
                    .map_err(failure)?;
            }
            _ => {
                return Err(Failure::Usage(format!(
                    "{}: a wave file ends in .vcd or .fst",
                    self.path.display()
                )));
            }
        }
        let list = list.arranged(shown.parts);
        let layouts = [
            ("gtkw", gtkw(&file_name, &list, clock.viewer_period() * shown.zoom)),
            ("sucl", sucl(&file_name, &list)),
        ];
        let layouts = layouts
            .map(|(extension, text)| write_whole(&self.path.with_extension(extension), &text));
        let layouts = layouts.into_iter().collect::<Result<Vec<_>, _>>()?;
        file.finish()?;
        layouts.into_iter().try_for_each(OutputFile::finish)
    }
}

fn record<W: Wave, C: Circuit<N>, const N: usize>(
    mut tracer: Tracer<W>,
    mut bench: Bench,
    first: usize,
    mut circuit: C,
    clock: Clock,
    window: Window,
) -> io::Result<()> {
    let mut k = 0;
    while k < window.from && !circuit.done() {
        bench.skip(&mut circuit);
        k += 1;
    }
    let end = window.clocks.map_or(u64::MAX, |clocks| k.saturating_add(clocks));
    while k < end && !circuit.done() {
        bench.clock(&mut tracer, first, &mut circuit, clock.rise(k), clock.fall(k));
        tracer.check()?;
        k += 1;
    }
    bench.sample(&mut tracer, first, &circuit, clock.rise(k));
    tracer.finish(clock.fall(k))?;
    Ok(())
}
