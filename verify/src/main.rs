//! The checks that are programs of their own.

use clap::{Parser, Subcommand};
use onepulse_verify::cosim;
use std::process::ExitCode;

#[derive(Parser)]
#[command(name = "onepulse-verify")]
struct Arguments {
    #[command(subcommand)]
    check: Check,
}

#[derive(Subcommand)]
enum Check {
    /// The circuits against their Verilog twins, every register on every clock (needs Verilator)
    Cosim(cosim::Options),
}

fn main() -> ExitCode {
    let Check::Cosim(options) = Arguments::parse().check;
    match cosim::run(&options) {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("error: {why}");
            ExitCode::FAILURE
        }
    }
}
