// Clocks the module, or its wrapper, under Verilator as a test bench does. Each line of standard input asks for a run: the number of
// clocks, and the wave file if the simulator was built to write one. It is answered with the sum
// of the pulse wires over the clocks, which must be the Rust circuit's.
#include "Vonepulse.h"
#include "command.h"
#include <cinttypes>
#include <cstdio>
#if VM_TRACE_FST
#include "verilated_fst_c.h"
using Trace = VerilatedFstC;
#elif VM_TRACE
#include "verilated_vcd_c.h"
using Trace = VerilatedVcdC;
#else
// Without a wave nothing is left of this.
struct Trace {
  void open(const char*) {}
  void dump(uint64_t) {}
  void close() {}
};
#endif

// i_clk and the wires of the wrapper that a wave is to show; not the twin's inside.
static const int DEPTH = 2;

static uint64_t run(uint64_t clocks, const char* file) {
  VerilatedContext context;
  context.traceEverOn(VM_TRACE);
  Vonepulse top(&context);
  Trace trace;
#if VM_TRACE
  top.trace(&trace, DEPTH);
#endif
  trace.open(file);
  uint64_t sum = 0;
  // An edge is a change that is seen.
  COMMAND(top)
  top.i_clk = 0;
  top.i_rst = 0;
  top.i_en = 1;
  top.i_load = 1;
  top.eval();
  for (uint64_t k = 0; k < clocks; k++) {
    top.i_clk = 1;
    top.eval();
    trace.dump(2 * k);
    sum += top.o_pulse;
    top.i_clk = 0;
    top.i_load = top.o_done;
    top.eval();
    trace.dump(2 * k + 1);
  }
  trace.close();
  return sum;
}

int main() {
  uint64_t clocks;
  char file[4096] = "";
  while (scanf("%" SCNu64 "%*1[ ]%4095[^\n]", &clocks, file) >= 1) {
    printf("%" PRIu64 "\n", run(clocks, file));
    fflush(stdout);
  }
}
