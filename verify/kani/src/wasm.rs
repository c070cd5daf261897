//! Imports that the prover's glue gives a meaning to.
#![allow(unsafe_code)]

use core::panic::{Location, PanicInfo};

#[link(wasm_import_module = "kani")]
unsafe extern "C" {
    safe fn any32() -> u32;
    safe fn any64() -> u64;
    #[link_name = "assume"]
    safe fn assume32(condition: u32);
    #[link_name = "cover"]
    safe fn cover32(condition: u32, file: *const u8, length: usize, line: u32);
    safe fn fail(location: u32) -> !;
}

/// A value of so many bits, in the lowest of those given.
#[inline(always)]
pub(crate) fn any(bits: u32, _is_signed: bool) -> u64 {
    if bits <= 32 { u64::from(any32()) } else { any64() }
}

#[inline(always)]
pub(crate) fn assume(condition: bool) {
    assume32(u32::from(condition));
}

#[inline(always)]
pub(crate) fn cover(condition: bool, file: &'static str, line: u32) {
    cover32(u32::from(condition), file.as_ptr(), file.len(), line);
}

/// A panic is a failed property. The prover is given the address of the panic's [`Location`]
/// and reads it in the module's data: to read it here would put memory into every proof.
#[panic_handler]
fn panicked(panic: &PanicInfo<'_>) -> ! {
    fail(
        panic
            .location()
            .map_or(0, |location: &Location<'_>| core::ptr::from_ref(location) as usize as u32),
    )
}
