//! The textbook's circuit, staggered and fully loaded.

/// A quarter circle from (R, 0) to (0, R): carries only, both remainders at 11…1, x adds and moves
/// first, then y adds the x just updated.
///
/// Fully loaded, x arrives early. At x = 0 nothing is added to y any more: if y has not come to R by
/// then, it starves. The core steps out of that; the circuit alone cannot, so it is not offered.
///
/// Normalized, the integrands are shifted left until R has its highest bit at the top.
pub(crate) struct StaggeredFullLoad {
    x: u64,
    y: u64,
    jr: [u64; 2],
    modulus: u64,
    shift: u32,
    radius: u64,
}

impl StaggeredFullLoad {
    pub(crate) fn new(radius: u64, bits: u32, normalize: bool) -> Self {
        let modulus = 1 << bits;
        let shift = if normalize { bits - 1 - radius.ilog2() } else { 0 };
        Self { x: radius, y: 0, jr: [modulus - 1; 2], modulus, shift, radius }
    }

    /// Draws on until the end point or until nothing can move any more; whether it starved.
    pub(crate) fn starves(mut self) -> bool {
        loop {
            let stands = [self.x == 0, self.y == self.radius];
            if stands == [true, true] {
                return false;
            }
            if (stands[0] || self.y == 0) && (stands[1] || self.x == 0) {
                return true;
            }
            if !stands[0] {
                let pulse = self.add(0, self.y);
                self.x -= pulse;
            }
            if !stands[1] {
                let pulse = self.add(1, self.x);
                self.y += pulse;
            }
        }
    }

    fn add(&mut self, axis: usize, integrand: u64) -> u64 {
        let sum = self.jr[axis] + (integrand << self.shift);
        self.jr[axis] = sum % self.modulus;
        sum / self.modulus
    }
}
