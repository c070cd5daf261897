// Clocks the wrapper under CXXRTL: as verilator.cpp, without waves.
#include "onepulse.cc"
#include <cinttypes>
#include <cstdio>

static uint64_t run(uint64_t clocks) {
  cxxrtl_design::p_onepulse top;
  uint64_t sum = 0;
  top.p_load.set<bool>(true);
  top.step();
  for (uint64_t k = 0; k < clocks; k++) {
    top.p_clk.set<bool>(true);
    top.step();
    // A step shows outputs as they are before the registers change.
    top.p_clk.set<bool>(false);
    top.step();
    sum += top.p_pulse.get<uint32_t>();
    top.p_load.set<bool>(top.p_done.get<bool>());
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
