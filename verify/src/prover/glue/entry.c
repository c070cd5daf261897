/* What the harnesses import, and an entry for each of them.

   Appended to the module's C. CHECK_COVERS and TABLE_ELEMENTS are made from the module, and a
   CHECK for every harness follows. Properties are told apart by their texts. */

struct w2c_kani {
  int nothing;
};

u32 nondet_u32(void);
u64 nondet_u64(void);

/* The names drawn_… are what a counterexample's values are read from. */
u32 w2c_kani_any32(struct w2c_kani* kani) {
  u32 drawn_32 = nondet_u32();
  return drawn_32;
}

u64 w2c_kani_any64(struct w2c_kani* kani) {
  u64 drawn_64 = nondet_u64();
  return drawn_64;
}

void w2c_kani_assume(struct w2c_kani* kani, u32 condition) {
  __CPROVER_assume(condition != 0);
}

/* A cover is the property that it is never met: it has to fail. */
#define CHECK_COVER(known_file, known_line, text)         \
  if (file == (known_file) && line == (known_line)) {     \
    __CPROVER_assert(condition == 0, text);               \
    return;                                               \
  }

void w2c_kani_cover(struct w2c_kani* kani, u32 condition, u32 file, u32 length, u32 line) {
  CHECK_COVERS
  __CPROVER_assert(0, "known cover");
}

void w2c_kani_fail(struct w2c_kani* kani, u32 location) {
  u32 panic_location = location;
  __CPROVER_assert(0, "panic");
  __CPROVER_assume(0);
}

void wasm_rt_trap(int code) {
  int trap_code = code;
  __CPROVER_assert(0, "trap");
  __CPROVER_assume(0);
}

static wasm_rt_funcref_t function_table[TABLE_ELEMENTS];

void wasm_rt_allocate_funcref_table(wasm_rt_funcref_table_t* table, uint32_t elements,
                                    uint32_t max_elements) {
  if (elements > TABLE_ELEMENTS) {
    wasm_rt_trap(WASM_RT_TRAP_OOB);
  }
  table->data = function_table;
  table->size = elements;
  table->max_size = max_elements;
}

static w2c_proofs module_instance;
static struct w2c_kani imports;

#define CHECK(entry, harness)                               \
  void entry(void) {                                        \
    wasm2c_proofs_instantiate(&module_instance, &imports);  \
    harness(&module_instance);                              \
    __CPROVER_assert(0, "end");                             \
  }

