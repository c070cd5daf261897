//! What a program asks for, block by block, in whole pulses.

use crate::Length;
use onepulse_core::{Direction, Plane};

/// One curve that the interpolator has to make. Points are x, y and z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Motion {
    /// The program's line, from 1.
    pub line: u32,
    /// Where the curve starts, in pulses from the program's origin.
    pub from: [i32; 3],
    /// Where it ends. Any two points of a program are an `i32` apart along each axis.
    pub to: [i32; 3],
    /// What lies between.
    pub curve: Curve,
    /// How fast.
    pub rate: Rate,
}

/// The curve between two points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curve {
    /// The straight line; its length is not zero.
    Line,
    /// An arc in a plane: the axis across it does not move. Equal ends mean a full circle. Start and end
    /// relative to the centre fit `i32`.
    Arc {
        /// Its plane.
        plane: Plane,
        /// The centre along the plane's first and second axis, in pulses from the program's origin: in
        /// G18 z comes first, then x.
        centre: [i64; 2],
        /// The sense, seen from the positive end of the axis across the plane.
        direction: Direction,
    },
}

/// The speed along the curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rate {
    /// As fast as the machine goes (G00).
    Rapid,
    /// A feed: the way of one minute. Positive.
    Feed(Length),
}

impl Motion {
    /// The plane of the curve: an arc's own; that of a line is the first of XY, ZX and YZ in which it
    /// lies, its third coordinate constant. `None` for a line that moves all three axes.
    ///
    /// ```
    /// use onepulse_core::Plane;
    /// use onepulse_plan::{Curve, Motion, Rate};
    /// let to = |to| Motion { line: 1, from: [0; 3], to, curve: Curve::Line, rate: Rate::Rapid };
    /// assert_eq!(to([5, 0, 0]).plane(), Some(Plane::Xy));
    /// assert_eq!(to([0, 0, -3]).plane(), Some(Plane::Zx));
    /// assert_eq!(to([0, 2, -3]).plane(), Some(Plane::Yz));
    /// assert_eq!(to([1, 2, -3]).plane(), None);
    /// ```
    #[must_use]
    pub fn plane(&self) -> Option<Plane> {
        if let Curve::Arc { plane, .. } = self.curve {
            return Some(plane);
        }
        [Plane::Xy, Plane::Zx, Plane::Yz].into_iter().find(|plane| {
            let [_, _, across] = plane.axes();
            self.from[across] == self.to[across]
        })
    }

    /// Whether it moves the third axis.
    #[must_use]
    pub fn moves_z(&self) -> bool {
        self.plane() != Some(Plane::Xy)
    }

    /// Its start and its end along the first and the second axis of a plane.
    #[must_use]
    pub fn ends_in(&self, plane: Plane) -> [[i32; 2]; 2] {
        let [first, second, _] = plane.axes();
        [self.from, self.to].map(|point| [point[first], point[second]])
    }
}
