//! Co-simulation: a circuit of `onepulse-hwmodel` and its Verilog twin get the same commands and
//! the same clocks, and every register and output is compared on every clock.
//!
//! | module | |
//! |---|---|
//! | `ports` | a module as words that go in and words that come out on every clock |
//! | `simulator` | what a simulator does: `verilator`, `icarus` |
//! | `bench` | clocks for a twin, compared with what the model says |
//! | `wave`, `waves` | the model's wave of a run, compared with that of Icarus |
//! | `engine`, `stimulus`, `driven`, `run` | the engines' ports, commands, pulse source and runs |
//! | `machine` | the whole interpolator and who gives it commands |
//! | `mutants` | changes of the Verilog that each comparison must find |
//!
//! What stands above the engines knows nothing of them: any module can be compared that is
//! described by its `Ports`, with a model that hands a `Bench` its words clock by clock.

mod bench;
mod driven;
mod engine;
mod fault;
mod icarus;
mod machine;
mod mutants;
mod ports;
mod reading;
mod run;
mod simulator;
mod stimulus;
mod verilator;
mod wave;
mod waves;

use bench::Bench;
use clap::Args;
use engine::Engine;
use fault::Fault;
use icarus::Icarus;
use onepulse_hwmodel::interpolator::Interpolator;
use ports::Ports;
use run::{Plan, Summary};
use simulator::Tool;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;
use waves::Compared;

/// What to co-simulate.
#[derive(Debug, Args)]
pub struct Options {
    /// Only this module, for example dda_line
    #[arg(long)]
    module: Option<String>,
    /// Only registers of this width
    #[arg(long)]
    bits: Option<u32>,
    /// Clocks of each module at each width [default: 300000, of waves 40000]
    #[arg(long)]
    clocks: Option<u64>,
    /// The simulator of the twins
    #[arg(long, value_enum, default_value_t = Tool::Verilator)]
    simulator: Tool,
    /// Instead, compare the wave that the model writes with the one that Icarus writes
    #[arg(long, conflicts_with = "simulator")]
    waves: bool,
    /// Change the Verilog in small ways and demand that each change is found
    #[arg(long)]
    mutants: bool,
    /// Where the random commands begin
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The folder of the Verilog files
    #[arg(long, default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/../hwmodel/rtl"))]
    rtl: PathBuf,
    /// The folder that simulators are built in
    #[arg(long, default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/cosim"))]
    build: PathBuf,
}

/// The register widths that are co-simulated.
const WIDTHS: [u32; 4] = [8, 16, 24, 32];

/// The interpolators that are co-simulated: width and number of axes.
const MACHINES: [(u32, usize); 5] = [(8, 2), (8, 4), (16, 3), (24, 2), (32, 4)];

/// Runs the co-simulations that are asked for.
///
/// # Errors
/// A twin that cannot be built, and the first difference: module, width, command, clock, signal
/// and both values.
pub fn run(options: &Options) -> Result<(), String> {
    if options.mutants {
        // Waves take long, and differ where the words do.
        let is_asked = |twin: Twin| options.is_of_module(twin);
        let [rtl, build] = [&options.rtl, &options.build];
        return mutants::run(rtl, build, !options.waves, is_asked, |rtl, build, twin| {
            options.check(rtl, build, twin).map(drop)
        });
    }
    let is_asked = |twin: &Twin| {
        options.is_of_module(*twin) && options.bits.is_none_or(|bits| bits == twin.bits())
    };
    let engines = Engine::ALL.into_iter();
    let twins = engines.flat_map(|engine| WIDTHS.map(|bits| Twin::Engine { engine, bits }));
    let machines = MACHINES.map(|(bits, axes)| Twin::Machine { bits, axes });
    let twins: Vec<_> = twins.chain(machines).filter(is_asked).collect();
    if twins.is_empty() {
        return Err("there is no such module or width".to_owned());
    }
    for twin in twins {
        let (module, bits, axes) = (twin.module(), twin.bits(), twin.axes());
        let equal = options
            .check(&options.rtl, &options.build, twin)
            .map_err(|fault| fault.within(&format!("{module} of {bits} bits, {axes} axes")))?;
        println!("{module:16} {bits:2} bits, {axes} axes: {equal}");
    }
    Ok(())
}

/// What is compared: an engine or the whole interpolator, at a width.
#[derive(Clone, Copy, Debug)]
enum Twin {
    Engine { engine: Engine, bits: u32 },
    Machine { bits: u32, axes: usize },
}

impl Twin {
    const fn module(self) -> &'static str {
        match self {
            Self::Engine { engine, .. } => engine.module(),
            Self::Machine { .. } => Interpolator::<2>::NAME,
        }
    }

    const fn bits(self) -> u32 {
        match self {
            Self::Engine { bits, .. } | Self::Machine { bits, .. } => bits,
        }
    }

    const fn axes(self) -> usize {
        match self {
            Self::Engine { engine, .. } => engine.axes(),
            Self::Machine { axes, .. } => axes,
        }
    }

    fn ports(self) -> Result<Ports, String> {
        match self {
            Self::Engine { engine, bits } => Ok(engine.ports(bits)),
            Self::Machine { bits, axes } => {
                machine::Plan { bits, axes, seed: 0, clocks: 0, wave: None }.ports()
            }
        }
    }

    fn run(
        self,
        bench: Bench,
        seed: u64,
        clocks: u64,
        wave: Option<&Path>,
    ) -> Result<Summary, Fault> {
        match self {
            Self::Engine { engine, bits } => Plan { engine, bits, seed, clocks, wave }.run(bench),
            Self::Machine { bits, axes } => {
                machine::Plan { bits, axes, seed, clocks, wave }.run(bench)
            }
        }
    }
}

impl Options {
    fn is_of_module(&self, twin: Twin) -> bool {
        self.module.as_ref().is_none_or(|module| module == twin.module())
    }

    /// Compares one twin, and says what was equal.
    fn check(&self, rtl: &Path, build: &Path, twin: Twin) -> Result<String, Fault> {
        let enough = if self.waves { 40_000 } else { 300_000 };
        let clocks = self.clocks.unwrap_or(enough);
        let begun = Instant::now();
        let ports = twin.ports()?;
        if self.waves {
            return waves_of(rtl, build, ports, |bench, wave| {
                twin.run(bench, self.seed, clocks, Some(wave))
            });
        }
        let simulator = self.simulator.start(rtl, build, &ports)?;
        let built = begun.elapsed();
        let run = twin.run(Bench::new(ports, simulator), self.seed, clocks, None)?;
        let seconds = (begun.elapsed() - built).as_secs_f64();
        Ok(format!("{run} equal, {seconds:.1} s"))
    }
}

/// Compares the waves of a run, which stay in the folder `waves`.
fn waves_of(
    rtl: &Path,
    build: &Path,
    ports: Ports,
    run: impl FnOnce(Bench, &Path) -> Result<Summary, Fault>,
) -> Result<String, Fault> {
    let folder = build.join("waves");
    fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let [model, twin] =
        ["model", "twin"].map(|side| folder.join(format!("{}_{side}.vcd", ports.label())));
    let simulator = Icarus::start(rtl, build, &ports, Some(&twin))?;
    // The twin has written all of its wave when the bench is gone.
    let run = run(Bench::new(ports.clone(), Box::new(simulator)), &model)?;
    let Compared { signals, changes } =
        waves::compare(&ports, &run.list, run.clocks, &model, &twin)?;
    Ok(format!("{run}: {changes:6} changes of {signals} signals equal"))
}
