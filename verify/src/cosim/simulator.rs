//! What every simulator of a twin does, and the process that it is.

use super::icarus::Icarus;
use super::ports::Ports;
use super::verilator::Verilator;
use clap::ValueEnum;
use std::io::{BufReader, BufWriter};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// A module under simulation. Its first clock finds every register with any content.
pub(super) trait Simulator {
    /// Runs clocks. `inputs` has the words of all inputs of the first clock, then those of the
    /// second; the words of all outputs, as they are before the rising edge that ends each clock,
    /// are put behind what `outputs` has. A word with an unknown bit is `None`.
    ///
    /// The inputs are sent before any output is read, so the answer must fit in a pipe.
    fn clocks(
        &mut self,
        clocks: u64,
        inputs: &[u64],
        outputs: &mut Vec<Option<u64>>,
    ) -> Result<(), String>;
}

/// The simulators to choose from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Tool {
    /// Fast; knows 0 and 1 only
    Verilator,
    /// Slower, quick to build; knows unknown bits
    Icarus,
}

impl Tool {
    /// Builds the simulator of a module from the Verilog files of a folder, in a folder of its
    /// own below `build`, and starts it.
    pub(super) fn start(
        self,
        rtl: &Path,
        build: &Path,
        ports: &Ports,
    ) -> Result<Box<dyn Simulator>, String> {
        Ok(match self {
            Self::Verilator => Box::new(Verilator::start(rtl, build, ports)?),
            Self::Icarus => Box::new(Icarus::start(rtl, build, ports, None)?),
        })
    }
}

/// A running process with a pipe to it and one back.
#[derive(Debug)]
pub(super) struct Pipes {
    process: Child,
    /// `None` only at the end.
    stdin: Option<BufWriter<ChildStdin>>,
    pub(super) stdout: BufReader<ChildStdout>,
}

impl Pipes {
    pub(super) fn start(command: &mut Command) -> Result<Self, String> {
        let mut process = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|e| format!("{}: {e}", command.get_program().to_string_lossy()))?;
        let (Some(stdin), Some(stdout)) = (process.stdin.take(), process.stdout.take()) else {
            return Err("the simulator has no pipes".to_owned());
        };
        let stdin = Some(BufWriter::with_capacity(1 << 16, stdin));
        Ok(Self { process, stdin, stdout: BufReader::with_capacity(1 << 16, stdout) })
    }

    /// Sends what `write` writes.
    pub(super) fn send(
        &mut self,
        write: impl FnOnce(&mut BufWriter<ChildStdin>) -> std::io::Result<()>,
    ) -> Result<(), String> {
        self.stdin.as_mut().map_or(Ok(()), write).map_err(broken)
    }
}

impl Drop for Pipes {
    fn drop(&mut self) {
        // Without inputs the simulator ends by itself.
        self.stdin = None;
        let _ = self.process.wait();
    }
}

/// Says that a pipe broke.
pub(super) fn broken(why: std::io::Error) -> String {
    format!("the simulator: {why}")
}

/// Runs a tool that builds a simulator.
pub(super) fn build(command: &mut Command) -> Result<(), String> {
    let tool = command.get_program().to_string_lossy().into_owned();
    let output =
        command.output().map_err(|e| format!("{tool}: {e} (run tools/install-rtl-tools)"))?;
    if output.status.success() {
        return Ok(());
    }
    Err(format!("{tool} could not build the twin:\n{}", String::from_utf8_lossy(&output.stderr)))
}
