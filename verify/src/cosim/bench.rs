//! The test bench of a twin, in C++ for Verilator.
//!
//! It reads commands as 64-bit words from standard input and answers with the outputs of every
//! clock, sampled before the edge that ends it:
//!
//! | words | meaning |
//! |---|---|
//! | 1, the inputs | a clock with `i_load` |
//! | 2 | a clock with `i_rst` |
//! | 3, k | k clocks with the pulse source enabled; answers k times |
//! | 4 | a clock without it; answers once |

use super::engine::Engine;
use std::fmt::Write;

/// A command's first word.
pub(super) mod opcode {
    pub(in super::super) const LOAD: u64 = 1;
    pub(in super::super) const RESET: u64 = 2;
    pub(in super::super) const RUN: u64 = 3;
    pub(in super::super) const STALL: u64 = 4;
}

/// The number of words before the registers: pulse, negative, done.
pub(super) const COMMON: usize = 3;

/// The source text. Ports over 64 bits are words of 32 for Verilator, so parts are fetched with
/// the functions that take both.
pub(super) fn source(engine: Engine, bits: u32) -> String {
    let module = engine.module();
    let mut loads = String::new();
    for port in engine.inputs() {
        let _ = match (*port, engine) {
            ("i_jv", Engine::DdaLine4) => {
                writeln!(
                    loads,
                    "      for (int axis = 0; axis < 4; axis++) set(top.{port}, axis * {bits}, {bits}, get());"
                )
            }
            _ => writeln!(loads, "      set(top.{port}, 0, 64, get());"),
        };
    }
    let mut samples = String::new();
    for output in engine.outputs(bits) {
        let (port, low, width) = (output.port, output.low, output.width);
        let _ = writeln!(samples, "  put(part(top.{port}, {low}, {width}));");
    }
    format!(
        r#"#include "V{module}.h"
#include <cstdint>
#include <cstdio>
#include <cstdlib>

static V{module} top;

static uint64_t get() {{
  uint64_t word;
  if (fread(&word, sizeof word, 1, stdin) != 1) exit(0);
  return word;
}}
static void put(uint64_t word) {{ fwrite(&word, sizeof word, 1, stdout); }}

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
  uint64_t mask = (width == 64 ? ~0ull : (1ull << width) - 1) << low;
  port = (Port)(((uint64_t)port & ~mask) | (value << low & mask));
}}
template <std::size_t Words> static void set(VlWide<Words>& port, int low, int width, uint64_t value) {{
  for (int bit = 0; bit < width; bit++) {{
    port[(low + bit) / 32] &= ~(1u << (low + bit) % 32);
    port[(low + bit) / 32] |= (uint32_t)(value >> bit & 1) << (low + bit) % 32;
  }}
}}
static void edge() {{
  top.i_clk = 1;
  top.eval();
  top.i_clk = 0;
  top.eval();
}}
static void sample() {{
  top.eval();
  put(top.o_pulse);
  put(top.o_negative);
  put(top.o_done);
{samples}}}

int main() {{
  top.i_clk = 0;
  top.i_rst = 0;
  top.i_load = 0;
  top.i_en = 0;
  for (;;) {{
    switch (get()) {{
    case 1:
{loads}      top.i_load = 1;
      edge();
      top.i_load = 0;
      break;
    case 2:
      top.i_rst = 1;
      edge();
      top.i_rst = 0;
      break;
    case 3:
      top.i_en = 1;
      for (uint64_t clocks = get(); clocks > 0; clocks--) {{
        sample();
        edge();
      }}
      top.i_en = 0;
      fflush(stdout);
      break;
    case 4:
      sample();
      edge();
      fflush(stdout);
      break;
    default:
      return 1;
    }}
  }}
}}
"#
    )
}
