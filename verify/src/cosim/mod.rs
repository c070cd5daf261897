//! Co-simulation: a circuit of `onepulse-hwmodel` and its Verilog twin get the same commands and
//! the same clocks, and every register and output is compared on every clock.
//!
//! The twin runs under Verilator as a process of its own; `bench` is the test bench that it is
//! built with, `twin` talks to it, `engine` knows the ports of each module, and `stimulus`
//! makes the commands.

mod bench;
mod engine;
mod mutants;
mod stimulus;
mod twin;

use clap::Args;
use engine::Engine;
use std::path::PathBuf;
use std::time::Instant;
use twin::Twin;

/// What to co-simulate.
#[derive(Debug, Args)]
pub struct Options {
    /// Only this module, for example dda_line
    #[arg(long)]
    module: Option<String>,
    /// Only registers of this width
    #[arg(long)]
    bits: Option<u32>,
    /// Clocks of each module at each width
    #[arg(long, default_value_t = 300_000)]
    clocks: u64,
    /// Instead, change the Verilog in small ways and demand that each change is found
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
        // Only what hides runs through all of them.
        return mutants::run(&options.rtl, &options.build, bits, 10 * options.clocks);
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
            let twin = Twin::build(&options.rtl, &options.build, engine, bits)?;
            let begun = Instant::now();
            let mut run = stimulus::Run::new(engine, bits, twin, options.seed);
            run.clocks(options.clocks)
                .map_err(|why| format!("{} of {bits} bits: {why}", engine.module()))?;
            println!(
                "{:16} {bits:2} bits, {} axes: {:5} commands, {:8} clocks equal, {:.1} s",
                engine.module(),
                engine.axes(),
                run.commands(),
                run.clocks_run(),
                begun.elapsed().as_secs_f64()
            );
        }
    }
    Ok(())
}
