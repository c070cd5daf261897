//! The circuits' Verilog twins, run by Verilator and CXXRTL on the same command as the circuit.
//!
//! `modules` knows the ports of each module, `engine` makes a simulator of it with the command at
//! its inputs, `wrapper` puts a module beside the signals that the circuit's wave has, and
//! `simulator` runs it.

mod engine;
pub mod modules;
mod registers;
mod simulator;
mod wrapper;

pub use engine::Engine;
pub use simulator::Simulator;

use onepulse_hwmodel::Circuit;
use registers::Registers;

/// The letters of the axes.
const AXES: [&str; 4] = ["x", "y", "z", "a"];

/// A Verilog module with a command for it.
#[derive(Clone, Debug)]
pub struct Twin {
    /// The module.
    pub module: &'static str,
    /// Its parameters besides the width.
    parameters: Vec<(&'static str, u64)>,
    axes: usize,
    /// The ports of the command, and their values.
    command: Vec<(String, u64)>,
    /// The ports that show registers, and the circuit's names for these, the high bits first.
    shown: Vec<(String, Vec<String>)>,
    /// The registers of the circuit.
    registers: Registers,
}

impl Twin {
    /// The twin of a circuit: a register has a port of its name.
    fn of<C: Circuit<AXES>, const AXES: usize>(circuit: &C) -> Self {
        let registers = Registers::of(circuit);
        let shown = registers.names().map(|name| (format!("o_{name}"), vec![name.to_owned()]));
        Self {
            module: C::NAME,
            parameters: vec![("N", modules::BITS.into())],
            axes: AXES,
            command: Vec::new(),
            shown: shown.collect(),
            registers,
        }
    }

    /// The module is told its number of axes.
    fn with_axes(mut self) -> Self {
        self.parameters.push(("AXES", self.axes as u64));
        self
    }

    /// One port has the registers `stem` of all axes.
    fn with_bus(mut self, port: &str, stem: &str) -> Self {
        let names: Vec<_> = self.each_axis(stem).rev().collect();
        self = self.without(stem);
        self.shown.push((port.to_owned(), names));
        self
    }

    /// No port shows what the circuit calls `stem`.
    fn without(mut self, stem: &str) -> Self {
        let hidden: Vec<_> = self.each_axis(stem).collect();
        self.shown.retain(|(_, names)| !names.iter().any(|name| hidden.contains(name)));
        self
    }

    /// The command has such a port.
    fn with_input(mut self, port: &str, value: u64) -> Self {
        self.command.push((port.to_owned(), value));
        self
    }

    /// The command has ports for the first contents of these registers.
    fn with_inputs(self, names: &[&str]) -> Self {
        names.iter().fold(self, |twin, name| {
            let loaded = twin.registers.loaded(name);
            twin.with_input(&format!("i_{name}"), loaded)
        })
    }

    /// The command has one port for the first contents of the registers `stem` of all axes.
    fn with_input_bus(self, port: &str, stem: &str) -> Self {
        let value = self.each_axis(stem).rev().fold(0, |value, name| {
            value << self.registers.bits(&name) | self.registers.loaded(&name)
        });
        self.with_input(port, value)
    }

    fn each_axis(&self, stem: &str) -> impl DoubleEndedIterator<Item = String> + use<> {
        let names: Vec<_> = AXES[..self.axes].iter().map(|axis| format!("{stem}{axis}")).collect();
        names.into_iter()
    }

    /// The signals of the circuit that no port of the module shows.
    #[must_use]
    pub fn not_shown(&self) -> Vec<&str> {
        let is_shown =
            |name: &str| self.shown.iter().any(|(_, names)| names.iter().any(|n| n == name));
        self.registers.names().filter(|name| !is_shown(name)).collect()
    }
}
