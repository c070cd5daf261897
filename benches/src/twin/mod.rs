//! The circuits' Verilog twins, run by Verilator and CXXRTL on the same command as the circuit.
//!
//! `modules` knows the ports of each module, `wrapper` puts a module between a clock and the
//! signals that the circuit's wave has, `engine` makes a simulator of it, and `simulator` runs it.

mod engine;
pub mod modules;
mod registers;
mod simulator;
mod wrapper;

pub use engine::Engine;
pub use simulator::Simulator;

use registers::Registers;

/// A Verilog module with a command for it.
#[derive(Clone, Debug)]
pub struct Twin {
    /// The module.
    pub module: &'static str,
    parameters: Vec<(&'static str, u64)>,
    axes: usize,
    /// The ports of the command, and their values.
    command: Vec<(&'static str, u64)>,
    /// The ports that show registers, and the circuit's names for these, the high bits first.
    shown: Vec<(&'static str, &'static [&'static str])>,
    /// The registers of the circuit.
    registers: Registers,
}

impl Twin {
    /// The signals of the circuit that no port of the module shows.
    #[must_use]
    pub fn not_shown(&self) -> Vec<&str> {
        let is_shown = |name: &str| self.shown.iter().any(|(_, names)| names.contains(&name));
        self.registers.names().filter(|name| !is_shown(name)).collect()
    }
}
