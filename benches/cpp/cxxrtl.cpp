// Clocks the module under CXXRTL: as verilator.cpp, without waves.
#include "onepulse.cc"
#include "command.h"
#include <cinttypes>
#include <cstdio>

static uint64_t run(uint64_t clocks) {
  cxxrtl_design::p_onepulse top;
  uint64_t sum = 0;
  COMMAND(top)
  top.p_i__rst.set<bool>(false);
  top.p_i__en.set<bool>(true);
  top.p_i__load.set<bool>(true);
  top.step();
  for (uint64_t k = 0; k < clocks; k++) {
    top.p_i__clk.set<bool>(true);
    top.step();
    // A step shows outputs as they are before the registers change.
    top.p_i__clk.set<bool>(false);
    top.step();
    sum += top.p_o__pulse.get<uint32_t>();
    top.p_i__load.set<bool>(top.p_o__done.get<bool>());
  }
  return sum;
}

int main() {
  uint64_t clocks;
  while (scanf("%" SCNu64 "%*[^\n]", &clocks) == 1) {
    printf("%" PRIu64 "\n", run(clocks));
    fflush(stdout);
  }
}
