//! Writes the values that changed, and only those.

use super::{Kind, Probe, SignalList, Wave};
use crate::Circuit;
use std::io;

/// Remembers every signal's last value and hands a [`Wave`] what changes.
#[derive(Debug)]
pub struct Tracer<W> {
    wave: W,
    last: Vec<Option<u64>>,
    now: u64,
    is_stamped: bool,
    /// The signal that the next probed value belongs to.
    cursor: usize,
    failed: Option<io::Error>,
}

impl<W: Wave> Tracer<W> {
    /// A tracer for the signals of the list that the wave was opened with.
    pub fn new(wave: W, signals: &SignalList) -> Self {
        let last = vec![None; signals.signals().len()];
        Self { wave, last, now: 0, is_stamped: false, cursor: 0, failed: None }
    }

    /// All following values are those at `time`.
    pub fn at(&mut self, time: u64) {
        self.is_stamped = self.is_stamped && time == self.now;
        self.now = time;
    }

    /// The present value of a signal.
    #[inline]
    pub fn set(&mut self, signal: usize, value: u64) {
        // Inline: whether a signal changes is foreseen best at a place of its own.
        if self.last[signal] != Some(value) {
            self.change(signal, value);
        }
    }

    #[inline(never)]
    fn change(&mut self, signal: usize, value: u64) {
        if self.failed.is_some() {
            return;
        }
        self.last[signal] = Some(value);
        let stamp = if self.is_stamped { Ok(()) } else { self.wave.time(self.now) };
        self.is_stamped = true;
        self.failed = stamp.and_then(|()| self.wave.change(signal, value)).err();
    }

    /// As a [`Probe`], for values of which the first is that of signal number `first`.
    pub fn from(&mut self, first: usize) -> &mut Self {
        self.cursor = first;
        self
    }

    /// The present values of a circuit whose first signal has the number `first`.
    pub fn sample<C: Circuit<AXES>, const AXES: usize>(&mut self, first: usize, circuit: &C) {
        circuit.probe(self.from(first));
    }

    /// Whether everything could be written so far.
    ///
    /// # Errors
    /// The first error of the wave's output; nothing was written after it.
    pub fn check(&mut self) -> io::Result<()> {
        self.failed.take().map_or(Ok(()), Err)
    }

    /// Ends the wave at `time`, the last of the time axis.
    ///
    /// # Errors
    /// The first error of the wave's output.
    pub fn finish(mut self, time: u64) -> io::Result<W> {
        self.check()?;
        self.at(time);
        if !self.is_stamped {
            self.wave.time(time)?;
        }
        self.wave.finish()?;
        Ok(self.wave)
    }
}

impl<W: Wave> Probe for Tracer<W> {
    fn axis_signal(&mut self, stem: &'static str, _: usize, kind: Kind, value: u64) {
        self.signal(stem, kind, value);
    }

    fn signal(&mut self, _: &'static str, _: Kind, value: u64) {
        self.set(self.cursor, value);
        self.cursor += 1;
    }
}
