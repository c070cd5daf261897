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
//! | `mutants` | changes of the Verilog that each comparison must find |
//!
//! What stands above the engines knows nothing of them: any module can be compared that is
//! described by its `Ports`, with a model that hands a `Bench` its words clock by clock.

mod bench;
mod driven;
mod engine;
mod fault;
mod icarus;
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
use run::Plan;
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

/// Runs the co-simulations that are asked for.
///
/// # Errors
/// A twin that cannot be built, and the first difference: module, width, command, clock, signal
/// and both values.
pub fn run(options: &Options) -> Result<(), String> {
    if options.mutants {
        let bits = options.bits.unwrap_or(WIDTHS[0]);
        return mutants::run(&options.rtl, &options.build, |rtl, build, engine| {
            options.check(rtl, build, engine, bits).map(drop)
        });
    }
    let is_asked = |engine: &Engine| options.module.as_ref().is_none_or(|m| m == engine.module());
    let engines: Vec<_> = Engine::ALL.into_iter().filter(is_asked).collect();
    let widths: Vec<_> =
        WIDTHS.into_iter().filter(|bits| options.bits.is_none_or(|b| b == *bits)).collect();
    if engines.is_empty() || widths.is_empty() {
        return Err("there is no such module or width".to_owned());
    }
    for engine in engines {
        for &bits in &widths {
            let equal = options
                .check(&options.rtl, &options.build, engine, bits)
                .map_err(|fault| fault.within(&format!("{} of {bits} bits", engine.module())))?;
            println!("{:16} {bits:2} bits, {} axes: {equal}", engine.module(), engine.axes());
        }
    }
    Ok(())
}

impl Options {
    /// Compares one module at one width, and says what was equal.
    fn check(&self, rtl: &Path, build: &Path, engine: Engine, bits: u32) -> Result<String, Fault> {
        let enough = if self.waves { 40_000 } else { 300_000 };
        let clocks = self.clocks.unwrap_or(enough);
        let plan = Plan { engine, bits, seed: self.seed, clocks, wave: None };
        let begun = Instant::now();
        if self.waves {
            return waves_of(rtl, build, plan);
        }
        let ports = engine.ports(bits);
        let simulator = self.simulator.start(rtl, build, &ports)?;
        let built = begun.elapsed();
        let run = plan.run(Bench::new(ports, simulator))?;
        let seconds = (begun.elapsed() - built).as_secs_f64();
        Ok(format!("{run} equal, {seconds:.1} s"))
    }
}

/// Compares the waves of a run, which stay in the folder `waves`.
fn waves_of(rtl: &Path, build: &Path, plan: Plan<'_>) -> Result<String, Fault> {
    let ports = plan.engine.ports(plan.bits);
    let folder = build.join("waves");
    fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let [model, twin] =
        ["model", "twin"].map(|side| folder.join(format!("{}_{side}.vcd", ports.label())));
    let simulator = Icarus::start(rtl, build, &ports, Some(&twin))?;
    // The twin has written all of its wave when the bench is gone.
    let run =
        Plan { wave: Some(&model), ..plan }.run(Bench::new(ports.clone(), Box::new(simulator)))?;
    let Compared { signals, changes } =
        waves::compare(&ports, &run.list, run.clocks, &model, &twin)?;
    Ok(format!("{run}: {changes:6} changes of {signals} signals equal"))
}
