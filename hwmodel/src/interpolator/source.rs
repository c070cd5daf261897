//! The pulse source.

use crate::probe::{Kind, Probe};

/// Divides the system clock to the rate of cycles, which is the feed.
///
/// A tick starts a cycle; the next comes a period later, or as soon after that as somebody can take
/// it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PulseSource {
    is_due: bool,
    count: u32,
}

impl PulseSource {
    pub(super) const fn reset() -> Self {
        Self { is_due: true, count: 0 }
    }

    /// The tick wire, if a cycle can be taken.
    pub(super) const fn tick(&self, is_ready: bool) -> bool {
        self.is_due && is_ready
    }

    /// A clock edge; `period` counts from a tick.
    pub(super) const fn clock(&mut self, tick: bool, period: u32, period_bits: u32) {
        if tick {
            self.is_due = false;
            self.count = period.wrapping_sub(2) & ((1 << period_bits) - 1);
        } else if self.count == 0 {
            self.is_due = true;
        } else {
            self.count -= 1;
        }
    }

    pub(super) fn probe(&self, period_bits: u32, probe: &mut impl Probe) {
        probe.signal("due", Kind::Bit, u64::from(self.is_due));
        probe.signal("count", Kind::Unsigned(period_bits), u64::from(self.count));
    }
}
