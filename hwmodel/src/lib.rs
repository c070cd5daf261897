//! The interpolators of `onepulse-core` as digital logic, clock by clock and bit by bit.
//!
//! A circuit is a struct of *registers* of fixed width. Its clock has two phases, as in
//! synchronous hardware: the combinational part computes every register's next content and
//! every wire from the present contents, then the clock edge commits them all at once. The carry
//! out of an adder *is* the pulse. Folders, files and names are those of `onepulse-core`, so
//! that the two can be read side by side:
//!
//! | circuit | clocks a cycle | as in the core |
//! |---|---|---|
//! | [`dda::Line`] | 1 | [`onepulse_core::dda::Line`], radix 2 |
//! | [`dda::Arc`] | 2: add, correct | [`onepulse_core::dda::Arc`] |
//! | [`dda::CentredArc`] | 4: add and move, x and y | [`onepulse_core::dda::CentredArc`] |
//! | [`ppc::Line`], [`ppc::Arc`] | 4, one a beat | [`onepulse_core::ppc`] |
//! | [`brm::Line`] | 1 | [`onepulse_core::brm::Line`] |
//! | [`comparison::Line`] | 1 | [`onepulse_core::comparison::Line`] |
//! | [`comparison::Arc`] | 2: judge, move | [`onepulse_core::comparison::Arc`] |
//! | [`minimum_deviation::Line`] | 1 | [`onepulse_core::minimum_deviation::Line`] |
//! | [`minimum_deviation::Arc`] | 2: judge, move | [`onepulse_core::minimum_deviation::Arc`] |
//! | [`parabola::Ppc`] | 1 | [`onepulse_core::parabola::Ppc`] |
//!
//! [`interpolator::Interpolator`] is the whole machine: the engines of the first three methods behind a decoder and a [`Fifo`] of
//! commands, with a pulse source for the feed, and with a [`StepDir`] for each axis' drive.
//!
//! `trace` writes their waves as VCD or FST. Without the feature `waves` it is left out, and what is left,
//! the circuits alone, needs neither the standard library nor memory to allocate.
//!
//! ```
//! use onepulse_core::{Pulse, dda::Preset};
//! use onepulse_hwmodel::{Circuit, dda};
//!
//! let mut circuit = dda::Line::new([4, 6], 3, Preset::Zero, false)?;
//! assert_eq!(circuit.pulses(), Pulse([0, 0])); // 0 + 4 and 0 + 6: no carry out of 3 bits
//! circuit.clock();
//! assert_eq!(circuit.pulses(), Pulse([1, 1])); // 4 + 4 and 6 + 6 overflow
//! # Ok::<(), onepulse_core::Error>(())
//! ```
#![cfg_attr(not(any(test, feature = "waves")), no_std)]

pub mod brm;
mod circuit;
pub mod comparison;
pub mod dda;
mod fifo;
pub mod interpolator;
pub mod minimum_deviation;
pub mod parabola;
pub mod ppc;
mod probe;
mod step_dir;
mod sweep;
#[cfg(feature = "waves")]
pub mod trace;
mod walk;
mod word;

pub use circuit::{Circuit, Cycles};
pub use fifo::Fifo;
pub use probe::{Kind, Probe};
pub use step_dir::{StepDir, Timing};
pub use sweep::Sweep;
