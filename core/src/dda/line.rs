//! Straight line by digital integration.

use super::{Preset, Radix, Register};
use crate::{Error, Pulse};

/// A line from the origin, any number of axes.
///
/// Every clock, JR ← JR + JV on each axis; the carry is the pulse. JV = |end|, so after
/// radix^n accumulations each axis has had exactly |end| pulses, whatever the preset. With
/// left-shift normalization (左移规格化) the integrands are shifted left by Q bits, until one has
/// its top bit set, and 2^(n−Q) accumulations do.
///
/// ```
/// use onepulse_core::dda::{Line, Preset, Radix, Register};
/// let register = Register::new(Radix::Binary, 3)?;
/// let line = Line::new([4, 6], register, Preset::Zero, false)?;
/// assert_eq!(line.filter(|pulse| !pulse.is_none()).count(), 6);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line<const AXES: usize = 2> {
    jv: [u64; AXES],
    jr: [u64; AXES],
    sign: [i8; AXES],
    position: [i64; AXES],
    end: [i32; AXES],
    left: u64,
    shift: u32,
    register: Register,
}

impl<const AXES: usize> Line<AXES> {
    /// The line to `end` in registers like `register`.
    ///
    /// # Errors
    /// An end coordinate that the register cannot hold; normalization of a decimal register.
    pub fn new(
        end: [i32; AXES],
        register: Register,
        preset: Preset,
        normalize: bool,
    ) -> Result<Self, Error> {
        let largest = end.iter().fold(0, |most, c| c.unsigned_abs().max(most));
        let needed = Register::holding(register.radix(), largest).digits();
        if register.digits() < needed {
            return Err(Error::RegisterTooNarrow { digits: register.digits(), needed });
        }
        if normalize && register.radix() != Radix::Binary {
            return Err(Error::NormalizationNeedsBinary);
        }
        // A line without length has nothing to shift.
        let shift = if normalize && largest > 0 { register.digits() - needed } else { 0 };
        Ok(Self {
            jv: end.map(|c| u64::from(c.unsigned_abs()) << shift),
            jr: [preset.value(register); AXES],
            sign: end.map(|c| c.signum() as i8),
            position: [0; AXES],
            end,
            left: register.modulus() >> shift,
            shift,
            register,
        })
    }

    /// The line to `end` in this state, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn in_state(
        end: [i32; AXES],
        register: Register,
        shift: u32,
        jr: [u64; AXES],
        position: [i64; AXES],
        left: u64,
    ) -> Self {
        let jv = end.map(|c| u64::from(c.unsigned_abs()) << shift);
        let sign = end.map(|c| c.signum() as i8);
        Self { jv, jr, sign, position, end, left, shift, register }
    }

    /// One accumulation on every axis; `None` once all are made.
    #[inline]
    pub fn step(&mut self) -> Option<Pulse<AXES>> {
        if self.left == 0 {
            return None;
        }
        let modulus = self.register.modulus();
        let mut pulse = Pulse::NONE;
        for axis in 0..AXES {
            let sum = self.jr[axis] + self.jv[axis];
            let carry = sum >= modulus;
            self.jr[axis] = if carry { sum - modulus } else { sum };
            pulse.0[axis] = if carry { self.sign[axis] } else { 0 };
            self.position[axis] += i64::from(pulse.0[axis]);
        }
        self.left -= 1;
        debug_assert!(self.invariant());
        Some(pulse)
    }

    /// The integrand registers.
    #[must_use]
    pub const fn integrands(&self) -> [u64; AXES] {
        self.jv
    }

    /// The remainder registers.
    #[must_use]
    pub const fn remainders(&self) -> [u64; AXES] {
        self.jr
    }

    /// The width of the registers.
    #[must_use]
    pub const fn register(&self) -> Register {
        self.register
    }

    /// Q, the number of left shifts that normalization made.
    #[must_use]
    pub const fn shift(&self) -> u32 {
        self.shift
    }

    /// Whether all accumulations are made.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.left == 0
    }

    /// Accumulations still to be made.
    #[must_use]
    pub const fn remaining(&self) -> u64 {
        self.left
    }

    /// The present point, counted from the line's start.
    #[must_use]
    pub const fn position(&self) -> [i64; AXES] {
        self.position
    }

    /// What is missing to the end point: zero when done.
    #[must_use]
    pub fn residual(&self) -> [i64; AXES] {
        core::array::from_fn(|axis| i64::from(self.end[axis]) - self.position[axis])
    }

    /// What always holds: every register is within its width, and the accumulations left bring
    /// each axis exactly the pulses that it lacks: ⌊(JR + left·JV)/2ⁿ⌋.
    #[must_use]
    pub fn invariant(&self) -> bool {
        // Both factors are 2³² at most, and JV is less.
        self.invariant_given(self.jv.map(|jv| self.left * jv))
    }

    /// The invariant for given products left·JV, which a proof may know otherwise than by
    /// multiplying.
    #[must_use]
    pub fn invariant_given(&self, due: [u64; AXES]) -> bool {
        let modulus = self.register.modulus();
        let residual = self.residual();
        self.left <= modulus >> self.shift
            && (0..AXES).all(|axis| {
                let lacking = residual[axis].unsigned_abs();
                let Some(total) = due[axis].checked_add(self.jr[axis]) else { return false };
                self.jv[axis] < modulus
                    && self.jr[axis] < modulus
                    && lacking == self.register.overflows(total)
                    && lacking <= u64::from(self.end[axis].unsigned_abs())
            })
    }
}

impl<const AXES: usize> Iterator for Line<AXES> {
    type Item = Pulse<AXES>;

    #[inline]
    fn next(&mut self) -> Option<Pulse<AXES>> {
        self.step()
    }
}
