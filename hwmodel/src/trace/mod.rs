//! Traces: the signals of a circuit, declared once, and their waves over time.
//!
//! A circuit's [`probe`](crate::Circuit::probe) names every signal with its kind and its present
//! value, in one fixed order. The same call declares the list (once) and samples it (every
//! clock), so the header, the values and the viewer's layout cannot disagree.

mod background;
mod bench;
mod clock;
mod digits;
mod encoded;
mod fst;
mod gtkw;
mod section;
mod signal;
mod sucl;
mod tracer;
mod vcd;

pub use crate::probe::{Kind, Probe};
pub use background::BackgroundWriter;
pub use bench::Bench;
pub use clock::Clock;
pub use fst::Fst;
pub use gtkw::gtkw;
pub use signal::{Signal, SignalList};
pub use sucl::sucl;
pub use tracer::{Sampler, Tracer};
pub use vcd::Vcd;

use std::io;

/// A file format that takes value changes in the order of time.
pub trait Wave {
    /// All following changes happen at `time`, counted in the wave's timescale.
    ///
    /// # Errors
    /// The output's; a time that does not lie after the last one.
    fn time(&mut self, time: u64) -> io::Result<()>;

    /// Signal number `signal` of the list changes to `value`: the low bits of it, as many as the
    /// signal has; for a word, its place among the words.
    ///
    /// # Errors
    /// The output's.
    fn change(&mut self, signal: usize, value: u64) -> io::Result<()>;

    /// Several changes, each a signal's number and its value, in this order.
    ///
    /// # Errors
    /// The output's.
    fn changes(&mut self, changes: &[(usize, u64)]) -> io::Result<()> {
        changes.iter().try_for_each(|&(signal, value)| self.change(signal, value))
    }

    /// Writes out what is still held back.
    ///
    /// # Errors
    /// The output's.
    fn finish(&mut self) -> io::Result<()>;
}
