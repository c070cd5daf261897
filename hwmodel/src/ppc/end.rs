//! The down counter of the end rules "total" and "larger".

use crate::probe::{Kind, Probe};
use onepulse_core::{Axis, EndRule};

/// A down counter that counts the pulses of both axes, or of the larger one alone.
///
/// Under the rule of two counters it is not used: the axes' own counters decide.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct EndCounter {
    rule: EndRule,
    larger: Axis,
    /// Pulses still to be counted.
    pub(super) e: u64,
}

impl EndCounter {
    /// The counter, loaded for a curve of so many pulses an axis.
    pub(super) const fn new(rule: EndRule, pulses: [u64; 2]) -> Self {
        let larger = if pulses[0] >= pulses[1] { Axis::X } else { Axis::Y };
        let e = match rule {
            EndRule::Total => pulses[0] + pulses[1],
            EndRule::Larger => pulses[larger.index()],
            EndRule::PerAxis => 0,
        };
        Self { rule, larger, e }
    }

    /// The counter in this state, reachable or not.
    #[cfg(feature = "proofs")]
    pub(super) const fn in_state(rule: EndRule, larger: Axis, e: u64) -> Self {
        Self { rule, larger, e }
    }

    /// Whether the end is reached; `axes_done` says so for the two counters.
    #[inline(always)]
    pub(super) const fn done(&self, axes_done: bool) -> bool {
        match self.rule {
            EndRule::PerAxis => axes_done,
            EndRule::Total | EndRule::Larger => self.e == 0,
        }
    }

    pub(super) fn probe(&self, bits: u32, probe: &mut impl Probe) {
        const WORDS: &[&str] = &["TOTAL", "PER_AXIS", "LARGER"];
        probe.signal("rule", Kind::Word(WORDS), self.rule as u64);
        probe.signal("larger_is_y", Kind::Bit, u64::from(self.larger == Axis::Y));
        probe.signal("e", Kind::Unsigned(bits), self.e);
    }

    /// The edge that counts a pulse on `axis`.
    #[inline(always)]
    pub(super) fn count(&mut self, axis: Axis) {
        let counts = match self.rule {
            EndRule::Total => true,
            EndRule::Larger => axis == self.larger,
            EndRule::PerAxis => false,
        };
        self.e -= u64::from(counts);
    }
}
