//! From ways to pulses.

/// A phase register: it sums up ways, and its carry is the pulse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Phase {
    /// Its width, 1 to 31: a pulse is a way of 2^bits.
    pub(super) bits: u32,
    pub(super) register: u32,
    /// Pulses made.
    pub(super) pulses: u32,
}

impl Phase {
    pub(super) const fn new(bits: u32) -> Self {
        Self { bits, register: 0, pulses: 0 }
    }

    /// Whether a way of less than a pulse makes the next one full.
    #[inline]
    pub(super) fn add(&mut self, way: u32) -> bool {
        // Both are below 2³¹.
        let sum = self.register + way;
        let pulse = sum >> self.bits != 0;
        self.register = sum & ((1 << self.bits) - 1);
        self.pulses += u32::from(pulse);
        pulse
    }

    /// Whether the register and a way that is left are whole pulses together.
    pub(super) const fn completes(&self, left: u64) -> bool {
        let pulse = 1 << self.bits;
        (self.register as u64) < pulse && (left + self.register as u64) & (pulse - 1) == 0
    }
}
