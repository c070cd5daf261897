/* Products, for a solver. By far most of them are a sign times a number: told so, the solver need
   not find out through a multiplier of 64 bits (seconds instead of minutes). The value is that of
   the plain product in every case. */

static inline u32 times_32(u32 a, u32 b) {
  return a == 0 ? 0 : a == 1 ? b : a == (u32)-1 ? -b : a * b;
}

static inline u64 times_64(u64 a, u64 b) {
  return a == 0 ? 0 : a == 1 ? b : a == (u64)-1 ? -b : a * b;
}

