//! Which parabola, and where it ends.

use crate::{Axis, Error};

/// A parabola with its vertex in the origin, and an end point.
///
/// With [`Axis::X`] as its axis of symmetry it is y² = 2px, with [`Axis::Y`] x² = 2py: p > 0 opens
/// it to the positive side of that axis, p < 0 to the negative. The end point's other coordinate
/// says which branch is meant. All in pulse equivalents.
///
/// ```
/// use onepulse_core::{Axis, Error, parabola::Shape};
/// let downwards = Shape::new(Axis::Y, -2, [4, -4])?; // x² = −4y
/// assert_eq!(Shape::new(Axis::Y, -2, [4, 4]), Err(Error::EndBehindVertex { end: [4, 4] }));
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Shape {
    axis: Axis,
    parameter: i32,
    end: [i32; 2],
}

impl Shape {
    /// The parabola with this axis of symmetry and parameter p, from its vertex to `end`: any
    /// `i32` values.
    ///
    /// An end point off the parabola is served, and so are one on the axis of symmetry and the
    /// vertex itself.
    ///
    /// # Errors
    /// p = 0, where there is no parabola; an end point on the side of the vertex to which the
    /// parabola does not open.
    pub const fn new(axis: Axis, parameter: i32, end: [i32; 2]) -> Result<Self, Error> {
        if parameter == 0 {
            return Err(Error::NoParameter);
        }
        let along = axis.of(end);
        if along != 0 && (along < 0) != (parameter < 0) {
            return Err(Error::EndBehindVertex { end });
        }
        Ok(Self { axis, parameter, end })
    }

    /// The axis of symmetry.
    #[must_use]
    pub const fn axis(&self) -> Axis {
        self.axis
    }

    /// p; its sign is that of the side to which the parabola opens.
    #[must_use]
    pub const fn parameter(&self) -> i32 {
        self.parameter
    }

    /// The end point.
    #[must_use]
    pub const fn end(&self) -> [i32; 2] {
        self.end
    }

    /// 2|p|: what a pulse along the axis of symmetry takes from F.
    #[inline]
    pub(super) const fn double_parameter(&self) -> i64 {
        2 * self.parameter.unsigned_abs() as i64
    }

    /// The magnitudes of the end point: along the axis of symmetry, and across it.
    #[inline]
    pub(super) fn magnitude(&self) -> [u32; 2] {
        self.reorder(self.end).map(i32::unsigned_abs)
    }

    /// The signs of the pulses along the axis of symmetry and across it.
    #[inline]
    pub(super) fn sign(&self) -> [i8; 2] {
        self.reorder(self.end).map(|c| c.signum() as i8)
    }

    /// From the order x, y to that of along, across; and back, which is the same.
    #[inline]
    pub(super) const fn reorder<T: Copy>(&self, [first, second]: [T; 2]) -> [T; 2] {
        match self.axis {
            Axis::X => [first, second],
            Axis::Y => [second, first],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_parabola_is_refused() {
        for axis in [Axis::X, Axis::Y] {
            for end in [[0, 0], [3, 3], [i32::MIN, i32::MAX]] {
                assert_eq!(Shape::new(axis, 0, end), Err(Error::NoParameter));
            }
            // The vertex and the line across it belong to either side.
            for parameter in [1, -1, i32::MIN, i32::MAX] {
                let across = if axis == Axis::X { [0, -7] } else { [-7, 0] };
                assert!(Shape::new(axis, parameter, [0, 0]).is_ok());
                assert!(Shape::new(axis, parameter, across).is_ok());
            }
        }
        let behind = |end| Err(Error::EndBehindVertex { end });
        assert_eq!(Shape::new(Axis::X, 3, [-1, 5]), behind([-1, 5]));
        assert_eq!(Shape::new(Axis::X, -3, [1, 5]), behind([1, 5]));
        assert_eq!(Shape::new(Axis::Y, 3, [5, i32::MIN]), behind([5, i32::MIN]));
        assert!(Shape::new(Axis::Y, -3, [5, i32::MIN]).is_ok());
    }
}
