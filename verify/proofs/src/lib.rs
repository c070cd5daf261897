//! The proofs of the interpolators, as Kani harnesses: one file a machine, named as in
//! `onepulse-core`.
//!
//! A machine is proved by induction, in pieces without a loop: *new* establishes its invariant,
//! one *step* from **any** state that satisfies it (reachable or not, at full register width)
//! preserves it, and what it buys is shown apart. So the claims hold for runs of any length.
//!
//! Products are kept out of the solvers: where an invariant has one, the harness carries it as a
//! number of its own (`product.rs`) of which no more is known than the lemmas of
//! `verify/lemmas` say.
//!
//! The crate is empty but for the engines that run the harnesses.
#![cfg(any(test, kani, target_arch = "wasm32"))]
#![cfg_attr(target_arch = "wasm32", no_std)]

mod any;
mod brm;
mod brm_smoothed;
mod centred_arc;
mod circle;
mod comparison_arc;
mod comparison_line;
mod dda_arc;
mod dda_line;
mod hardware;
mod helix;
mod judgement;
mod minimum_deviation_arc;
mod minimum_deviation_line;
mod parabola;
mod ppc_arc;
mod ppc_line;
mod product;
mod quadrant_walk;
mod ramp_s_curve;
mod ramp_trapezoid;
mod same;
mod space_line;
mod vector_arc;
mod vector_line;
#[cfg(feature = "wrong")]
mod wrong;
