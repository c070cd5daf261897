//! What is given: lines and arcs in millimetres, as programmed.

use onepulse_core::Direction;

/// A line or an arc in the plane, in millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Element {
    /// The straight line.
    Line {
        /// Where it starts.
        from: [f64; 2],
        /// Where it ends.
        to: [f64; 2],
    },
    /// An arc; equal ends mean a full circle. An end off the circle through the start, as programs
    /// rounded to a few decimals have it, is seen from the centre in its own direction and at its
    /// own distance.
    Arc {
        /// Where it starts.
        from: [f64; 2],
        /// Where it ends.
        to: [f64; 2],
        /// What it turns about.
        centre: [f64; 2],
        /// The sense.
        direction: Direction,
    },
}

impl Element {
    /// Where it starts and where it ends.
    #[must_use]
    pub const fn ends(&self) -> [[f64; 2]; 2] {
        match *self {
            Self::Line { from, to } | Self::Arc { from, to, .. } => [from, to],
        }
    }
}

/// One block of the program between switching the compensation on and off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// The curve as programmed.
    pub element: Element,
    /// The program's line.
    pub line: u32,
    /// Whether the tool cuts here. A rapid is compensated as any other, but nothing of it is there to be
    /// protected, and the path along it may come near the contour.
    pub is_machined: bool,
}

/// What is compensated in one go. Each block starts where the one before ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// The line on which the compensation is established (刀补建立).
    pub approach: Block,
    /// The blocks compensated (刀补进行). Lines of no length are passed over.
    pub contour: Vec<Block>,
    /// The line on which the compensation is cancelled (刀补撤消).
    pub leave: Block,
}

/// On which side of the contour the tool is, in the direction of travel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// G41.
    Left,
    /// G42.
    Right,
}

/// How the tool goes round an outside corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Corners {
    /// In straight lines, as the C type has it: extended from 90°, with a link inserted below.
    Straight,
    /// On an arc about the corner.
    Arcs,
}

/// A piece of the path of the tool's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// The curve; it starts where the one before ends, to the last bit.
    pub element: Element,
    /// What it is for.
    pub role: Role,
    /// The block it belongs to: 0 the approach, then the contour's, counted from 1, then the leave.
    /// What goes round a corner belongs to the block before it.
    pub block: usize,
}

/// What a piece of the path is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// From the uncompensated start to the radius away from the contour.
    Establish,
    /// Along a block, the radius away from it.
    Offset,
    /// Round an outside corner.
    Corner,
    /// Back to the uncompensated end.
    Cancel,
}
