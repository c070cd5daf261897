//! Pulses: what one interpolation cycle sends to the axes.

/// One of the two axes of an interpolation plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// The first axis of the plane.
    X,
    /// The second axis of the plane.
    Y,
}

impl Axis {
    /// The axis' place in an array of coordinates.
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
        }
    }

    /// The axis' part of a pair.
    ///
    /// (A choice between values, not an index: machines whose arrays are never indexed by a
    /// variable can live in processor registers, and in a solver's variables.)
    #[inline]
    #[must_use]
    pub const fn of<T: Copy>(self, [x, y]: [T; 2]) -> T {
        match self {
            Self::X => x,
            Self::Y => y,
        }
    }

    /// The plane's other axis.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::X => Self::Y,
            Self::Y => Self::X,
        }
    }
}

/// The pulses of one interpolation cycle: −1, 0 or +1 for each axis.
///
/// A digital integrator has many cycles in which no axis gets a pulse; such a cycle is
/// [`Pulse::NONE`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pulse<const AXES: usize = 2>(pub [i8; AXES]);

impl<const AXES: usize> Pulse<AXES> {
    /// A cycle that moves no axis.
    pub const NONE: Self = Self([0; AXES]);

    /// Whether no axis moves.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.0 == [0; AXES]
    }
}

impl Pulse {
    /// A pulse of `sign` (−1 or +1) on one axis of the plane, none on the other.
    #[must_use]
    pub const fn on(axis: Axis, sign: i8) -> Self {
        match axis {
            Axis::X => Self([sign, 0]),
            Axis::Y => Self([0, sign]),
        }
    }
}

/// A magnitude with the sign of a pulse. (A choice, not a product: cheap on processors without a
/// multiplier, and in proofs.)
#[inline]
pub(crate) const fn signed(sign: i8, magnitude: i64) -> i64 {
    if sign > 0 {
        magnitude
    } else if sign < 0 {
        -magnitude
    } else {
        0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sign_of_zero_makes_zero() {
        assert_eq!([1, 0, -1].map(|sign| signed(sign, 7)), [7, 0, -7]);
    }

    #[test]
    fn no_pulse_is_none_of_any_axis() {
        assert!(Pulse([0, 0]).is_none());
        assert!(!Pulse([0, -1]).is_none() && !Pulse([1, 0]).is_none());
    }
}
