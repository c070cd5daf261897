//! The checks that are programs of their own.

use clap::{Parser, Subcommand};
use onepulse_verify::{cosim, lemmas, proof_mutants, prover, rtl_formal, sweep};
use std::process::ExitCode;

#[derive(Parser)]
#[command(name = "onepulse-verify")]
struct Arguments {
    #[command(subcommand)]
    check: Check,
}

#[derive(Subcommand)]
enum Check {
    /// The circuits against their Verilog twins, every register on every clock (needs Verilator or
    /// Icarus Verilog)
    Cosim(cosim::Options),
    /// The claims of verify/claims.toml, by the harnesses of verify/proofs (needs
    /// tools/install-proof-tools)
    Prove(prover::Options),
    /// The mathematics of the proofs, by two solvers (needs z3 and cvc5)
    Lemmas(lemmas::Options),
    /// Whether the harnesses see every small change of the machines (see docs/mutants.md)
    Mutants(proof_mutants::Options),
    /// The properties of the Verilog twins, by induction (needs Yosys and Yices)
    RtlFormal(rtl_formal::Options),
    /// Every curve of narrow registers: what holds, and what does not
    Sweep(sweep::Options),
}

fn main() -> ExitCode {
    let done = match Arguments::parse().check {
        Check::Cosim(options) => cosim::run(&options),
        Check::Prove(options) => prover::run(&options),
        Check::Lemmas(options) => lemmas::run(&options),
        Check::Mutants(options) => proof_mutants::run(&options),
        Check::RtlFormal(options) => rtl_formal::run(&options),
        Check::Sweep(options) => sweep::run(&options),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("error: {why}");
            ExitCode::FAILURE
        }
    }
}
