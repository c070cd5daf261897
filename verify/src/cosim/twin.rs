//! A twin as a running process.

use super::bench;
use super::engine::Engine;
use std::fs;
use std::io::{BufReader, BufWriter, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// A Verilog module under Verilator, talked to over pipes.
#[derive(Debug)]
pub(super) struct Twin {
    process: Child,
    commands: Option<BufWriter<ChildStdin>>,
    answers: BufReader<ChildStdout>,
}

impl Twin {
    /// Builds the simulator of a module at a width, and starts it.
    pub(super) fn build(
        rtl: &Path,
        build: &Path,
        engine: Engine,
        bits: u32,
    ) -> Result<Self, String> {
        let module = engine.module();
        let folder = build.join(format!("{module}_{}_{bits}", engine.axes()));
        fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        let bench = folder.join("bench.cpp");
        fs::write(&bench, bench::source(engine, bits))
            .map_err(|e| format!("{}: {e}", bench.display()))?;

        let mut verilator = Command::new("verilator");
        // Lint is a check of its own: a mutant may be untidy.
        verilator.args(["--cc", "--exe", "--build", "-Wno-fatal", "-O3", "--x-assign", "unique"]);
        verilator.args(["--x-initial", "unique", "-CFLAGS", "-O1", "--top-module", module]);
        verilator.arg(format!("-GN={bits}"));
        if engine.has_axes() {
            verilator.arg(format!("-GAXES={}", engine.axes()));
        }
        verilator.arg("-y").arg(rtl).arg("--Mdir").arg(&folder);
        verilator.arg(rtl.join(format!("{module}.v"))).arg(&bench);
        let output =
            verilator.output().map_err(|e| format!("verilator: {e} (Debian package verilator)"))?;
        if !output.status.success() {
            let said = String::from_utf8_lossy(&output.stderr);
            return Err(format!("verilator could not build {module}:\n{said}"));
        }

        let program = folder.join(format!("V{module}"));
        let mut process = Command::new(&program)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|e| format!("{}: {e}", program.display()))?;
        let pipes = (process.stdin.take(), process.stdout.take());
        let (Some(stdin), Some(stdout)) = pipes else {
            return Err("the simulator has no pipes".to_owned());
        };
        let commands = Some(BufWriter::new(stdin));
        Ok(Self { process, commands, answers: BufReader::with_capacity(1 << 16, stdout) })
    }

    /// Gives a command.
    pub(super) fn give(&mut self, words: &[u64]) -> Result<(), String> {
        let Some(commands) = &mut self.commands else {
            return Err("the simulator has ended".to_owned());
        };
        for word in words {
            commands.write_all(&word.to_le_bytes()).map_err(|e| format!("the simulator: {e}"))?;
        }
        Ok(())
    }

    /// Sends the commands off, so that they are answered.
    pub(super) fn send(&mut self) -> Result<(), String> {
        let sent = self.commands.as_mut().map_or(Ok(()), Write::flush);
        sent.map_err(|e| format!("the simulator: {e}"))
    }

    /// The outputs of one clock.
    pub(super) fn answer(&mut self, words: &mut [u64]) -> Result<(), String> {
        for word in words {
            let mut bytes = [0; 8];
            self.answers.read_exact(&mut bytes).map_err(|e| format!("the simulator: {e}"))?;
            *word = u64::from_le_bytes(bytes);
        }
        Ok(())
    }
}

impl Drop for Twin {
    fn drop(&mut self) {
        // Without commands the simulator ends by itself.
        self.commands = None;
        let _ = self.process.wait();
    }
}
