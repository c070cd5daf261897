/* The linear memory, in two parts: the stack, at the bottom, and the module's data above it.

   The stack is small enough for CBMC to keep every byte of it as a variable of its own: addresses
   on it are constants, so that a load is wires. The data are constants and never split. Loads and
   stores are put together of bytes, as a copy between a word and an array of bytes (the way of
   wasm2c) makes CBMC update the whole array.

   Included into the C of wasm2c between its prelude and the module's own code. STACK_BYTES,
   DATA_BYTES and DATA come from the module. */

static u8 stack_memory[STACK_BYTES];
static const u8 data_memory[DATA_BYTES] = {DATA};

/* An access beyond the module's memory is a failed property, even where a page would back it. */
static inline void check_address(u64 address, u32 bytes, u64 end) {
  if (address + bytes > end) {
    wasm_rt_trap(WASM_RT_TRAP_OOB);
  }
}

static inline u8 byte_at(u64 address) {
  return address < STACK_BYTES ? stack_memory[address] : data_memory[address - STACK_BYTES];
}

static inline u8 load_1(u64 address) {
  check_address(address, 1, STACK_BYTES + DATA_BYTES);
  return byte_at(address);
}

static inline u16 load_2(u64 address) {
  check_address(address, 2, STACK_BYTES + DATA_BYTES);
  return (u16)(byte_at(address) | (u16)byte_at(address + 1) << 8);
}

static inline u32 load_4(u64 address) {
  check_address(address, 4, STACK_BYTES + DATA_BYTES);
  return (u32)byte_at(address) | (u32)byte_at(address + 1) << 8 |
         (u32)byte_at(address + 2) << 16 | (u32)byte_at(address + 3) << 24;
}

static inline u64 load_8(u64 address) {
  u32 low = load_4(address);
  return (u64)low | (u64)load_4(address + 4) << 32;
}

/* The module's data are never written. */
static inline void store_1(u64 address, u8 value) {
  check_address(address, 1, STACK_BYTES);
  stack_memory[address] = value;
}

static inline void store_2(u64 address, u16 value) {
  check_address(address, 2, STACK_BYTES);
  stack_memory[address] = (u8)value;
  stack_memory[address + 1] = (u8)(value >> 8);
}

static inline void store_4(u64 address, u32 value) {
  check_address(address, 4, STACK_BYTES);
  stack_memory[address] = (u8)value;
  stack_memory[address + 1] = (u8)(value >> 8);
  stack_memory[address + 2] = (u8)(value >> 16);
  stack_memory[address + 3] = (u8)(value >> 24);
}

static inline void store_8(u64 address, u64 value) {
  store_4(address, (u32)value);
  store_4(address + 4, (u32)(value >> 32));
}

#define i32_load(memory, address) load_4(address)
#define i64_load(memory, address) load_8(address)
#define i32_load8_s(memory, address) ((u32)(s32)(s8)load_1(address))
#define i64_load8_s(memory, address) ((u64)(s64)(s8)load_1(address))
#define i32_load8_u(memory, address) ((u32)load_1(address))
#define i64_load8_u(memory, address) ((u64)load_1(address))
#define i32_load16_s(memory, address) ((u32)(s32)(s16)load_2(address))
#define i64_load16_s(memory, address) ((u64)(s64)(s16)load_2(address))
#define i32_load16_u(memory, address) ((u32)load_2(address))
#define i64_load16_u(memory, address) ((u64)load_2(address))
#define i64_load32_s(memory, address) ((u64)(s64)(s32)load_4(address))
#define i64_load32_u(memory, address) ((u64)load_4(address))
#define i32_store(memory, address, value) store_4(address, value)
#define i64_store(memory, address, value) store_8(address, value)
#define i32_store8(memory, address, value) store_1(address, (u8)(value))
#define i32_store16(memory, address, value) store_2(address, (u16)(value))
#define i64_store8(memory, address, value) store_1(address, (u8)(value))
#define i64_store16(memory, address, value) store_2(address, (u16)(value))
#define i64_store32(memory, address, value) store_4(address, (u32)(value))

/* The data are in data_memory from the start. */
#undef LOAD_DATA
#define LOAD_DATA(memory, offset, data, bytes) ((void)0)
