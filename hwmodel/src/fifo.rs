//! A queue of commands.

use crate::probe::{Kind, Probe};

/// A ring of entries and two pointers, with one bit more than an address: equal pointers mean an
/// empty queue, pointers that differ in the highest bit alone a full one.
///
/// ```text
///            ┌───┬───┬───┬───┐
///  push ────▶│   │   │   │   │────▶ head, pop
///            └───┴─▲─┴───┴─▲─┘
///               write     read
/// ```
///
/// The head falls through: it is there in the clock after it was put in, without being asked for.
/// In Verilog this is `command_fifo`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fifo<T, const DEPTH: usize = 4> {
    entries: [T; DEPTH],
    write: usize,
    read: usize,
}

impl<T: Copy + Default, const DEPTH: usize> Fifo<T, DEPTH> {
    /// An empty queue. Its depth is a power of two, at least 2; any other does not compile.
    #[must_use]
    pub fn new() -> Self {
        const { assert!(DEPTH >= 2 && DEPTH.is_power_of_two()) };
        Self { entries: [T::default(); DEPTH], write: 0, read: 0 }
    }

    /// A clock edge with reset: the pointers go back, and nobody sees the entries any more.
    pub const fn reset(&mut self) {
        self.write = 0;
        self.read = 0;
    }

    /// The ready wire: there is room for an entry.
    #[must_use]
    pub const fn ready(&self) -> bool {
        self.write ^ self.read != DEPTH
    }

    /// The head entry, if there is one.
    #[must_use]
    pub const fn head(&self) -> Option<T> {
        if self.write == self.read { None } else { Some(self.entries[self.read % DEPTH]) }
    }

    /// A clock edge: puts in an entry if there is room, and takes the head if there is one.
    #[inline]
    pub fn clock(&mut self, push: Option<T>, pop: bool) {
        let advance = |pointer: usize| (pointer + 1) % (2 * DEPTH);
        let (put, take) = (push.filter(|_| self.ready()), pop && self.write != self.read);
        if let Some(entry) = put {
            self.entries[self.write % DEPTH] = entry;
            self.write = advance(self.write);
        }
        if take {
            self.read = advance(self.read);
        }
    }

    /// Shows the pointers and the two wires.
    pub fn probe(&self, probe: &mut impl Probe) {
        let pointer = Kind::Unsigned(DEPTH.ilog2() + 1);
        probe.signal("fifo_write", pointer, self.write as u64);
        probe.signal("fifo_read", pointer, self.read as u64);
        probe.signal("fifo_valid", Kind::Bit, u64::from(self.write != self.read));
        probe.signal("fifo_ready", Kind::Bit, u64::from(self.ready()));
    }
}

impl<T: Copy + Default, const DEPTH: usize> Default for Fifo<T, DEPTH> {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::VecDeque;

    fn is_a_queue<const DEPTH: usize>(seed: u64) {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut fifo = Fifo::<u32, DEPTH>::new();
        let mut queue = VecDeque::new();
        let (mut was_full, mut was_empty_again) = (false, false);
        for number in 0..10_000 {
            assert_eq!(fifo.head(), queue.front().copied());
            assert_eq!(fifo.ready(), queue.len() < DEPTH);
            was_full |= queue.len() == DEPTH;
            was_empty_again |= was_full && queue.is_empty();
            if random.u32(..1000) == 0 {
                fifo.reset();
                queue.clear();
                continue;
            }
            // Now the source is faster, now the sink.
            let is_filling = number / 64 % 2 == 0;
            let push = (random.u32(..4) < if is_filling { 3 } else { 1 }).then_some(number);
            let pop = random.u32(..4) < if is_filling { 1 } else { 3 };
            let is_ready = queue.len() < DEPTH;
            fifo.clock(push, pop);
            if pop {
                queue.pop_front();
            }
            if is_ready {
                queue.extend(push);
            }
        }
        assert!(was_full && was_empty_again);
    }

    #[test]
    fn it_neither_loses_nor_repeats_nor_reorders() {
        for seed in 0..20 {
            is_a_queue::<2>(seed);
            is_a_queue::<4>(seed);
            is_a_queue::<16>(seed);
        }
    }
}
