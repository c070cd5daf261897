//! The speeds at the corners, each low enough for all that comes after.

use super::{Block, Limits, Profile};
use std::collections::VecDeque;
use std::iter::Fuse;

/// How many blocks at least the look-ahead knows beyond the one it gives out. It holds twice as many.
pub const AHEAD: usize = 128;

/// Gives each block its entry and exit speed, as a [`Profile`], in order.
///
/// In a corner the velocity may jump by so much: v ≤ limit/|u_out − u_in|, and v is over neither
/// block's steady speed. From behind the last block known, where the speed is taken for 0, a backward
/// pass lowers each corner's speed to what can be braked to the one after; a forward pass lowers it to
/// what the one before can reach. A block's exit speed is the next one's entry speed, the same
/// number; the program starts and ends at rest, and is at rest behind a block that is
/// [stopping](Block::stopping).
///
/// A program that can stop within [`AHEAD`] blocks everywhere has the speeds of a look-ahead over the whole
/// of it: the highest with which each block is long enough to come from the lower of its two speeds,
/// and from any between, to the higher. "Any between", since along an S-curve a smaller change
/// can take more way: an entry speed once given must stay joined when more of the program is known and
/// the exit speed rises.
///
/// An S-curve has no acceleration where a block ends. Over blocks much shorter than a change of speed
/// that costs time: there the speed v rises by about j·L/(4v) a second, instead of a. Free curves in
/// very short lines are faster with linear ramps.
///
/// Blocks are planned in strides of [`AHEAD`], each of which passes over twice as many: either pass
/// visits a block at most twice, whatever the program.
#[derive(Clone, Debug)]
pub struct LookAhead<I> {
    blocks: Fuse<I>,
    limits: Limits,
    held: VecDeque<Held>,
    /// How many of the held blocks go out before the next passes.
    planned: usize,
    /// Steps of the backward and of the forward pass.
    #[cfg(test)]
    visits: [usize; 2],
}

#[derive(Clone, Copy, Debug)]
struct Held {
    block: Block,
    /// The highest speed at its start.
    corner: f64,
    /// The highest speed at its start from which all that is held behind it can be braked.
    bound: f64,
    /// The speed at its start as it is planned.
    entry: f64,
}

impl<I: Iterator<Item = Block>> LookAhead<I> {
    /// The look-ahead over these blocks.
    #[must_use]
    pub fn new(blocks: impl IntoIterator<Item = Block, IntoIter = I>, limits: Limits) -> Self {
        Self {
            blocks: blocks.into_iter().fuse(),
            limits,
            held: VecDeque::with_capacity(2 * AHEAD),
            planned: 0,
            #[cfg(test)]
            visits: [0; 2],
        }
    }

    fn plan(&mut self) {
        self.fill();
        self.pass_backward();
        self.pass_forward();
        let is_all = self.held.len() < 2 * AHEAD;
        self.planned = if is_all { self.held.len() } else { self.held.len() - AHEAD };
    }

    fn fill(&mut self) {
        while self.held.len() < 2 * AHEAD {
            let Some(block) = self.blocks.next() else { return };
            let before = self.held.back();
            let corner = before.map_or(0.0, |held| held.block.corner_speed(&block, &self.limits));
            // At rest: the end of what was planned without it.
            self.held.push_back(Held { block, corner, bound: 0.0, entry: 0.0 });
        }
    }

    fn pass_backward(&mut self) {
        let mut exit = 0.0;
        for held in self.held.iter_mut().rev() {
            held.bound = held.corner.min(self.limits.reach(exit, held.block.length()));
            exit = held.bound;
            #[cfg(test)]
            {
                self.visits[0] += 1;
            }
        }
    }

    fn pass_forward(&mut self) {
        for k in 1..self.held.len() {
            let Held { block, entry, .. } = self.held[k - 1];
            let next = &mut self.held[k];
            let exit = next.bound.min(self.limits.reach(entry, block.length()));
            // The speeds of the passes before hold on until these are joined to them. They are lower, but
            // by a rounding they may be higher, and this block too short to brake to these.
            if self.limits.longest_way(exit.min(entry), exit.max(entry)) <= block.length() {
                next.entry = exit;
            }
            #[cfg(test)]
            {
                self.visits[1] += 1;
            }
        }
    }
}

impl<I: Iterator<Item = Block>> Iterator for LookAhead<I> {
    type Item = Profile;

    fn next(&mut self) -> Option<Profile> {
        if self.planned == 0 {
            self.plan();
        }
        let Held { block, entry, .. } = self.held.pop_front()?;
        self.planned -= 1;
        let exit = self.held.front().map_or(0.0, |next| next.entry);
        Some(Profile::joined(block.length(), entry, exit, block.steady(), &self.limits))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As many tangent blocks, too short to stop in: all of what is held is braked through each time.
    fn visits(blocks: usize) -> [usize; 2] {
        let along = [1.0, 0.0, 0.0];
        let block = Block::new(1e-3, 100.0, along, along).unwrap();
        let limits = Limits::new(1000.0, Some(2e4), 1.0, 1.0).unwrap();
        let mut look_ahead = LookAhead::new(std::iter::repeat_n(block, blocks), limits);
        assert_eq!(look_ahead.by_ref().count(), blocks);
        look_ahead.visits
    }

    #[test]
    fn each_block_is_visited_twice_by_each_pass_however_long_the_program() {
        let [few, many] = [10_000, 100_000].map(visits);
        for pass in 0..2 {
            assert!(few[pass] >= 10_000 && few[pass] <= 20_000, "{few:?}");
            let ratio = many[pass] as f64 / few[pass] as f64;
            assert!((9.9..10.1).contains(&ratio), "{few:?} {many:?}");
        }
    }

    /// A bound that came out a rounding lower than in the pass before, and a block whose change of speed
    /// is a few roundings.
    #[test]
    fn what_rounding_unjoins_stays_as_it_was_planned() {
        let along = [1.0, 0.0, 0.0];
        let limits = Limits::new(1000.0, None, 1.0, 1.0).unwrap();
        let block = Block::new(1e-9, 1e6, along, along).unwrap();
        let exit = 1e4_f64;
        let entry = limits.reach(exit, block.length());
        assert!(entry > exit);
        let lower = f64::from_bits(exit.to_bits() - 1);
        assert!(limits.way(lower, entry) > block.length());
        let mut look_ahead = LookAhead::new([], limits);
        for (bound, entry) in [(entry, entry), (lower, exit)] {
            look_ahead.held.push_back(Held { block, corner: 1e6, bound, entry });
        }
        look_ahead.pass_forward();
        assert_eq!(look_ahead.held[1].entry, exit);
        // What is joined is taken, and higher.
        look_ahead.held[1].bound = entry;
        look_ahead.pass_forward();
        assert_eq!(look_ahead.held[1].entry, entry);
    }

    /// What the short blocks of a horizon can stop from is less than the steady speed; more than that
    /// is not given, as the program may end behind it.
    #[test]
    fn what_is_not_in_sight_is_taken_for_a_stop() {
        let along = [1.0, 0.0, 0.0];
        let block = Block::new(1e-2, 100.0, along, along).unwrap();
        let limits = Limits::new(1000.0, None, 1.0, 1.0).unwrap();
        let speeds: Vec<_> = LookAhead::new(vec![block; 1000], limits).map(|p| p.exit()).collect();
        let fastest = speeds.iter().fold(0.0_f64, |most, &speed| most.max(speed));
        // √(2·a·L) of all that is held, and of as much as is always ahead.
        let stopping = |blocks: usize| (2.0 * 1000.0 * 1e-2 * blocks as f64).sqrt();
        assert!(fastest <= stopping(2 * AHEAD) * (1.0 + 1e-9), "{fastest}");
        let middle = &speeds[AHEAD..1000 - AHEAD - 1];
        assert!(middle.iter().all(|&speed| speed >= stopping(AHEAD) * (1.0 - 1e-9)), "{middle:?}");
    }
}
