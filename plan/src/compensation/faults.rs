//! The overcuts found so far, and the blocks whose path they spoil.

use super::curve::Curve;
use super::vector::Vector;
use super::{Overcut, OvercutKind};

/// The overcuts found so far.
#[derive(Debug)]
pub(super) struct Faults {
    pub(super) overcuts: Vec<Overcut>,
    /// For each block of the section: whether the path along it is not what it would be without the
    /// overcut.
    pub(super) is_spoilt: Vec<bool>,
}

impl Faults {
    /// None yet, in a section of this many blocks.
    pub(super) fn none(blocks: usize) -> Self {
        Self { overcuts: vec![], is_spoilt: vec![false; blocks] }
    }

    /// The middle one of three curves is at fault, here. The paths of its neighbours end nowhere.
    pub(super) fn block(&mut self, kind: OvercutKind, curves: &[Curve], at: Vector) {
        let line = curves[1].block.line;
        self.overcuts.push(Overcut { kind, line, other_line: None, at });
        self.spoil(curves);
    }

    /// The corner between two curves is at fault.
    pub(super) fn corner(&mut self, kind: OvercutKind, curves: &[Curve]) {
        let [line, other] = [0, 1].map(|place| curves[place].block.line);
        let at = curves[1].start.point;
        self.overcuts.push(Overcut { kind, line, other_line: Some(other), at });
        self.spoil(curves);
    }

    fn spoil(&mut self, curves: &[Curve]) {
        for curve in curves {
            self.is_spoilt[curve.index] = true;
        }
    }
}
