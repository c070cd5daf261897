#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| onepulse_fuzz::path(data));
