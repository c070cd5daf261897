//! A twin under Verilator: compiled to C++, with a bench that reads and writes binary words.

use super::ports::{Port, Ports};
use super::simulator::{Pipes, Simulator, broken, build};
use std::fmt::Write as _;
use std::fs;
use std::io::{Read, Write as _};
use std::path::Path;
use std::process::Command;

#[derive(Debug)]
pub(super) struct Verilator {
    pipes: Pipes,
    outputs: usize,
}

impl Verilator {
    /// Builds a twin and starts it.
    pub(super) fn start(rtl: &Path, folder: &Path, ports: &Ports) -> Result<Self, String> {
        let module = ports.module;
        let folder = folder.join(format!("verilator_{}", ports.label()));
        fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        let bench = folder.join("bench.cpp");
        fs::write(&bench, source(ports)).map_err(|e| format!("{}: {e}", bench.display()))?;

        let mut verilator = Command::new("verilator");
        // Lint is a check of its own: a mutant may be untidy.
        verilator.args(["--cc", "--exe", "--build", "-Wno-fatal", "-O3", "--x-assign", "unique"]);
        verilator.args(["--x-initial", "unique", "-CFLAGS", "-O1", "--top-module", module]);
        verilator.args(ports.parameters.iter().map(|(name, value)| format!("-G{name}={value}")));
        verilator.arg("-y").arg(rtl).arg("--Mdir").arg(&folder);
        verilator.arg(rtl.join(format!("{module}.v"))).arg(&bench);
        build(&mut verilator)?;

        let pipes = Pipes::start(&mut Command::new(folder.join(format!("V{module}"))))?;
        Ok(Self { pipes, outputs: ports.outputs.len() })
    }
}

impl Simulator for Verilator {
    fn clocks(
        &mut self,
        clocks: u64,
        inputs: &[u64],
        outputs: &mut Vec<Option<u64>>,
    ) -> Result<(), String> {
        self.pipes.send(|stdin| {
            stdin.write_all(&clocks.to_le_bytes())?;
            for word in inputs {
                stdin.write_all(&word.to_le_bytes())?;
            }
            stdin.flush()
        })?;
        for _ in 0..clocks as usize * self.outputs {
            let mut bytes = [0; 8];
            self.pipes.stdout.read_exact(&mut bytes).map_err(broken)?;
            outputs.push(Some(u64::from_le_bytes(bytes)));
        }
        Ok(())
    }
}

/// The bench. It reads a number of clocks and their inputs, and answers with their outputs.
///
/// Ports over 64 bits are words of 32 for Verilator, so parts go through functions that take both.
fn source(ports: &Ports) -> String {
    let module = ports.module;
    let (inputs, outputs) = (ports.inputs.len(), ports.outputs.len());
    let mut drive = String::new();
    for (at, Port { name, low, width }) in ports.inputs.iter().enumerate() {
        let _ = writeln!(drive, "      set(top.{name}, {low}, {width}, in[{at}]);");
    }
    let mut sample = String::new();
    for (at, output) in ports.outputs.iter().enumerate() {
        let part =
            |name: &str| format!("part(top.{name}, {}, {})", output.port.low, output.port.width);
        let gate = output.gate.map_or(String::new(), |gate| format!(" & {}", part(gate)));
        let _ = writeln!(sample, "      out[{at}] = {}{gate};", part(&output.port.name));
    }
    format!(
        r#"#include "V{module}.h"
#include <cstdint>
#include <cstdio>

static V{module} top;

template <class Port> static uint64_t part(Port port, int low, int width) {{
  return ((uint64_t)port >> low) & (~0ull >> (64 - width));
}}
template <std::size_t Words> static uint64_t part(const VlWide<Words>& port, int low, int width) {{
  uint64_t value = 0;
  for (int bit = 0; bit < width; bit++)
    value |= (uint64_t)(port[(low + bit) / 32] >> ((low + bit) % 32) & 1) << bit;
  return value;
}}
template <class Port> static void set(Port& port, int low, int width, uint64_t value) {{
  uint64_t mask = (~0ull >> (64 - width)) << low;
  port = (Port)(((uint64_t)port & ~mask) | (value << low & mask));
}}
template <std::size_t Words> static void set(VlWide<Words>& port, int low, int width, uint64_t value) {{
  for (int bit = 0; bit < width; bit++) {{
    port[(low + bit) / 32] &= ~(1u << (low + bit) % 32);
    port[(low + bit) / 32] |= (uint32_t)(value >> bit & 1) << (low + bit) % 32;
  }}
}}

int main() {{
  static uint64_t clocks, in[{inputs}], out[{outputs}];
  while (fread(&clocks, sizeof clocks, 1, stdin) == 1) {{
    for (; clocks > 0; clocks--) {{
      if (fread(in, sizeof in, 1, stdin) != 1) return 1;
      top.i_clk = 0;
{drive}      top.eval();
{sample}      fwrite(out, sizeof out, 1, stdout);
      top.i_clk = 1;
      top.eval();
    }}
    fflush(stdout);
  }}
}}
"#
    )
}
