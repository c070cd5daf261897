//! A remainder register that runs up and down.

/// JR: its carry out is a pulse forwards, its borrow a pulse backwards.
#[derive(Clone, Copy)]
pub(super) struct Accumulator {
    content: i64,
    modulus: i64,
}

impl Accumulator {
    /// A register of n bits at half load 2^(n−1), and so much more.
    pub(super) fn half_loaded_and(more: i64, bits: u32) -> Self {
        Self { content: (1 << (bits - 1)) + more, modulus: 1 << bits }
    }

    /// Adds; the pulse.
    pub(super) fn add(&mut self, integrand: i64) -> i64 {
        self.content += integrand;
        if self.content >= self.modulus {
            self.content -= self.modulus;
            1
        } else if self.content < 0 {
            self.content += self.modulus;
            -1
        } else {
            0
        }
    }
}
