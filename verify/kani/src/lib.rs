//! What a harness calls, where it is not Kani that runs it.
//!
//! The harnesses of `onepulse-proofs` are ordinary Kani source. `cargo kani` brings its own crate
//! `kani`; elsewhere this one takes its place, with the same names:
//!
//! * built for WebAssembly, on the way to CBMC, every function is an import that the prover gives a
//!   meaning to;
//! * built natively, values are drawn at random, from the boundaries, and at narrow widths all of
//!   them: see [`native`].
#![cfg_attr(target_arch = "wasm32", no_std)]

mod arbitrary;
#[cfg(not(target_arch = "wasm32"))]
pub mod native;
#[cfg(target_arch = "wasm32")]
mod wasm;
#[cfg(not(target_arch = "wasm32"))]
use native as engine;
#[cfg(target_arch = "wasm32")]
use wasm as engine;

pub use arbitrary::{Arbitrary, any, any_where};
pub use onepulse_kani_macros::{proof, solver, unwind};

/// Goes on only if the condition holds.
#[inline(always)]
pub fn assume(condition: bool) {
    engine::assume(condition);
}

/// Asks for a run that comes here with the condition true: without one, what the harness
/// assumes may be a contradiction.
#[macro_export]
macro_rules! cover {
    () => {
        $crate::cover!(true)
    };
    ($condition:expr $(, $message:literal)?) => {
        $crate::__cover($condition, file!(), line!())
    };
}

#[doc(hidden)]
#[inline(always)]
pub fn __cover(condition: bool, file: &'static str, line: u32) {
    engine::cover(condition, file, line);
}
