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
    /// What has changed now and is not yet handed over, `count` changes: one place more than there
    /// are signals.
    changes: Vec<(usize, u64)>,
    count: usize,
    failed: Option<io::Error>,
}

impl<W: Wave> Tracer<W> {
    /// A tracer for the signals of the list that the wave was opened with.
    pub fn new(wave: W, signals: &SignalList) -> Self {
        let signals = signals.signals().len();
        let (last, changes) = (vec![None; signals], vec![(0, 0); signals + 1]);
        Self { wave, last, now: 0, is_stamped: false, changes, count: 0, failed: None }
    }

    /// All following values are those at `time`.
    pub fn at(&mut self, time: u64) {
        if time != self.now {
            self.hand_over();
            self.is_stamped = false;
            self.now = time;
        }
    }

    /// The present value of a signal.
    #[inline]
    pub fn set(&mut self, signal: usize, value: u64) {
        // Inline: whether a signal changes is foreseen best at a place of its own.
        if self.last[signal] != Some(value) {
            self.last[signal] = Some(value);
            self.changes[self.count] = (signal, value);
            self.count += 1;
            // Signals that change more than once at a time.
            if self.count == self.changes.len() {
                self.hand_over();
            }
        }
    }

    #[inline(never)]
    fn hand_over(&mut self) {
        let changes = &self.changes[..self.count];
        self.count = 0;
        if changes.is_empty() || self.failed.is_some() {
            return;
        }
        let stamp = if self.is_stamped { Ok(()) } else { self.wave.time(self.now) };
        self.is_stamped = true;
        self.failed = stamp.and_then(|()| self.wave.changes(changes)).err();
    }

    /// A [`Probe`] for values of which the first is that of signal number `first`.
    pub fn from(&mut self, first: usize) -> Sampler<'_, W> {
        Sampler { tracer: self, cursor: first }
    }

    /// The present values of a circuit whose first signal has the number `first`.
    pub fn sample<C: Circuit<AXES>, const AXES: usize>(&mut self, first: usize, circuit: &C) {
        circuit.probe(&mut self.from(first));
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
        self.at(time);
        self.hand_over();
        self.check()?;
        if !self.is_stamped {
            self.wave.time(time)?;
        }
        self.wave.finish()?;
        Ok(self.wave)
    }
}

/// Takes the present values of signals in the order of their numbers.
///
/// It lives no longer than a sample, so that its place in the list need not be kept in memory.
#[derive(Debug)]
pub struct Sampler<'a, W> {
    tracer: &'a mut Tracer<W>,
    /// The signal that the next value belongs to.
    cursor: usize,
}

impl<W: Wave> Probe for Sampler<'_, W> {
    #[inline]
    fn axis_signal(&mut self, stem: &'static str, _: usize, kind: Kind, value: u64) {
        self.signal(stem, kind, value);
    }

    #[inline]
    fn signal(&mut self, _: &'static str, _: Kind, value: u64) {
        self.tracer.set(self.cursor, value);
        self.cursor += 1;
    }
}
