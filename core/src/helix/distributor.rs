//! Who steps when: the cycles of a helix shared out.

/// Shares cycles out between an arc of N steps and a linear axis of |h| pulses, so that both end with
/// the last one.
///
/// The longer of the two steps in each of the T = max(N, |h|) cycles; for the shorter, of S steps, an
/// integrator modulo T adds S every cycle, from half load ⌊T/2⌋, and its carry is the step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Distributor {
    /// T, and how many of them are to go.
    cycles: u64,
    left: u64,
    /// S, and the remainder register.
    shorter: u64,
    rest: u64,
    /// Whether it is the linear axis that steps every cycle.
    rise_is_longer: bool,
}

impl Distributor {
    /// Between an arc of so many steps and a linear axis of so many pulses.
    pub(super) fn new(steps: u64, height: u32) -> Self {
        let height = u64::from(height);
        let cycles = steps.max(height);
        Self {
            cycles,
            left: cycles,
            shorter: steps.min(height),
            rest: cycles / 2,
            rise_is_longer: height > steps,
        }
    }

    /// `Distributor::new`, with so many cycles to go and the remainder register in this state,
    /// reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn in_state(steps: u64, height: u32, left: u64, rest: u64) -> Self {
        Self { left, rest, ..Self::new(steps, height) }
    }

    /// One cycle: whether the arc steps, and whether the linear axis does; `None` after the last.
    #[inline]
    pub fn share(&mut self) -> Option<[bool; 2]> {
        if self.left == 0 {
            return None;
        }
        let sum = self.rest + self.shorter;
        let carry = sum >= self.cycles;
        self.rest = if carry { sum - self.cycles } else { sum };
        self.left -= 1;
        Some(if self.rise_is_longer { [carry, true] } else { [true, carry] })
    }

    /// T: the cycles from start to end.
    #[must_use]
    pub const fn cycles(&self) -> u64 {
        self.cycles
    }

    /// Cycles still to come.
    #[must_use]
    pub const fn remaining(&self) -> u64 {
        self.left
    }

    /// The remainder register.
    #[must_use]
    pub const fn remainder(&self) -> u64 {
        self.rest
    }

    /// Of the steps that arc and linear axis still have to make, those of the longer and those of the
    /// shorter.
    #[must_use]
    pub const fn longer_and_shorter(&self, [to_turn, to_rise]: [u64; 2]) -> [u64; 2] {
        if self.rise_is_longer { [to_rise, to_turn] } else { [to_turn, to_rise] }
    }

    /// What always holds: with the steps that arc and linear axis still have to make, the longer has
    /// as many as there are cycles to go, and these bring the shorter just the d that it lacks:
    /// rest + left·S = ⌊T/2⌋ + d·T.
    #[must_use]
    pub fn invariant(&self, to_go: [u64; 2]) -> bool {
        let [_, lacking] = self.longer_and_shorter(to_go);
        let product = |a: u64, b: u64| i128::from(a) * i128::from(b);
        let ahead = product(lacking, self.cycles) - product(self.left, self.shorter);
        i64::try_from(ahead).is_ok_and(|ahead| self.counters_hold(to_go, ahead))
    }

    /// The invariant for a given d·T − left·S, which a proof may know otherwise than by multiplying.
    #[must_use]
    pub fn counters_hold(&self, to_go: [u64; 2], ahead: i64) -> bool {
        let [longer, shorter] = self.longer_and_shorter(to_go);
        self.rest < self.cycles
            && self.left <= self.cycles
            && longer == self.left
            && shorter <= self.shorter
            && self.rest as i64 == (self.cycles / 2) as i64 + ahead
    }
}
