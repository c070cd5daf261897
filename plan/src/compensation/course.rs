//! The section's curves in a row, and the corners between them.

use super::corner::Corner;
use super::curve::{Curve, TOUCH};
use super::faults::Faults;
use super::vector::{Vector, distance};
use super::{Overcut, OvercutKind, Section, Side};
use std::iter::once;
use std::ops::Range;

/// The section's curves, without those of length zero: the approach first, the leave last.
#[derive(Debug)]
pub(super) struct Course {
    pub(super) curves: Vec<Curve>,
    /// Each between the curve of its place and the next.
    pub(super) corners: Vec<Corner>,
    pub(super) side: Side,
    pub(super) radius: f64,
    /// How many blocks the section has, with those of length zero.
    blocks: usize,
}

impl Course {
    /// The section's curves.
    ///
    /// # Errors
    /// What is no curve, or does not hang together.
    pub(super) fn new(section: &Section, side: Side, radius: f64) -> Result<Self, Vec<Overcut>> {
        let mut overcuts = vec![];
        if !(0.0..=1e7).contains(&radius) {
            let (kind, line) = (OvercutKind::Radius { radius }, section.approach.line);
            overcuts.push(Overcut { kind, line, other_line: None, at: [0.0; 2] });
        }
        let blocks = section.contour.len() + 2;
        let mut curves: Vec<Curve> = Vec::with_capacity(blocks);
        // The end of the block before; none after one that is refused.
        let mut end: Option<Vector> = None;
        let all = once(&section.approach).chain(&section.contour).chain(once(&section.leave));
        for (index, block) in all.enumerate() {
            let is_outer = index == 0 || index == blocks - 1;
            let refused = match Curve::of(index, *block, side) {
                Err(kind) => Some(kind),
                Ok(None) if is_outer => Some(OvercutKind::NoLength),
                Ok(Some(curve)) if is_outer && !curve.is_line() => Some(OvercutKind::NotALine),
                Ok(curve) => {
                    let [from, to] = block.element.ends();
                    let gap = end.map_or(0.0, |end| distance(end, from));
                    end = Some(to);
                    curves.extend(curve);
                    (gap > TOUCH).then_some(OvercutKind::Disconnected { gap })
                }
            };
            if let Some(kind) = refused {
                let at = block
                    .element
                    .ends()
                    .into_iter()
                    .find(|point| point.iter().all(|c| c.is_finite()));
                let (line, at) = (block.line, at.unwrap_or([0.0; 2]));
                overcuts.push(Overcut { kind, line, other_line: None, at });
                if !matches!(kind, OvercutKind::Disconnected { .. }) {
                    end = None;
                }
            }
        }
        if !overcuts.is_empty() {
            return Err(overcuts);
        }
        let corners = curves
            .windows(2)
            .map(|pair| Corner::between(&pair[0].end, &pair[1].start, radius))
            .collect();
        Ok(Self { curves, corners, side, radius, blocks })
    }

    /// The places of the contour's curves.
    pub(super) fn contour(&self) -> Range<usize> {
        1..self.curves.len() - 1
    }

    /// The arcs in which the tool does not fit. Where it is as large as the arc, its centre stands still
    /// there: the path must come to that point and go on from it with the arc's tangents.
    pub(super) fn small_arcs(&self) -> Faults {
        let mut faults = Faults::none(self.blocks);
        let radius = self.radius;
        for place in self.contour() {
            let curve = &self.curves[place];
            let Some(arc) = curve.arc_within(radius) else { continue };
            let is_smooth = self.corners[place - 1..=place] == [Corner::Tangent; 2];
            if arc < radius - TOUCH || !is_smooth {
                let kind = OvercutKind::SmallArc { arc, radius };
                faults.block(kind, &self.curves[place - 1..=place + 1], curve.start.point);
            }
        }
        faults
    }
}
