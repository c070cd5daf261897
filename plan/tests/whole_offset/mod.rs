//! The offset of a closed contour by the library `cavalier_contours`, and whether it is all there. The library
//! takes away from the offset what comes nearer than it should and joins what is left.

use crate::curves::SAME;
use cavalier_contours::core::math::Vector2;
use cavalier_contours::polyline::{
    PlineOffsetOptions, PlineSource, PlineVertex, Polyline, seg_arc_radius_and_center,
    seg_midpoint, seg_tangent_vector,
};
use std::panic::catch_unwind;

fn segment(contour: &Polyline, index: usize) -> (PlineVertex, PlineVertex) {
    (contour.at(index), contour.at(contour.next_wrapping_index(index)))
}

/// The directions at both ends of a segment.
pub(crate) fn tangents(contour: &Polyline, index: usize) -> [Vector2; 2] {
    let (start, end) = segment(contour, index);
    [start.pos(), end.pos()].map(|at| seg_tangent_vector(start, end, at).normalize())
}

pub(crate) fn tangents_before(contour: &Polyline, index: usize) -> [Vector2; 2] {
    tangents(contour, contour.prev_wrapping_index(index))
}

/// The curve that a part of an offset lies on.
#[derive(Clone, Copy, Debug)]
enum Carrier {
    Line { through: Vector2, tangent: Vector2 },
    Circle { centre: Vector2, radius: f64, is_ccw: bool },
}

impl Carrier {
    fn holds(&self, start: PlineVertex, end: PlineVertex) -> bool {
        let ends = [start.pos(), seg_midpoint(start, end), end.pos()];
        match *self {
            Carrier::Line { through, tangent } => {
                start.bulge == 0.0
                    && tangent.dot(end.pos() - start.pos()) > 0.0
                    && ends.iter().all(|&at| tangent.perp_dot(at - through).abs() < 1e-6)
            }
            Carrier::Circle { centre, radius, is_ccw } => {
                start.bulge != 0.0
                    && (start.bulge > 0.0) == is_ccw
                    && ends.iter().all(|&at| ((at - centre).length() - radius).abs() < 1e-6)
            }
        }
    }
}

/// What the whole offset consists of, by the definition of an offset: each segment's, and a circle
/// about each outside corner. None if an arc has no offset.
fn carriers(contour: &Polyline, offset: f64) -> Option<Vec<Carrier>> {
    let mut carriers = Vec::new();
    for k in 0..contour.segment_count() {
        let (start, end) = segment(contour, k);
        let [first, last] = tangents(contour, k);
        if start.bulge == 0.0 {
            let through = start.pos() + first.perp().scale(offset);
            carriers.push(Carrier::Line { through, tangent: first });
        } else {
            let (radius, centre) = seg_arc_radius_and_center(start, end);
            let is_ccw = start.bulge > 0.0;
            let radius = if is_ccw { radius - offset } else { radius + offset };
            if radius <= 0.0 {
                return None;
            }
            carriers.push(Carrier::Circle { centre, radius, is_ccw });
        }
        let next = tangents(contour, contour.next_wrapping_index(k))[0];
        let turn = last.perp_dot(next);
        if turn * offset < -1e-9 {
            let (radius, is_ccw) = (offset.abs(), offset < 0.0);
            carriers.push(Carrier::Circle { centre: end.pos(), radius, is_ccw });
        }
    }
    Some(carriers)
}

/// Whether the path follows the carriers once around, in their order, and leaves none out.
fn follows(path: &Polyline, carriers: &[Carrier]) -> bool {
    let count = carriers.len();
    (0..count).any(|first| {
        let holds = |on: usize, (start, end)| {
            on < count && carriers[(first + on) % count].holds(start, end)
        };
        let mut on = 0;
        let is_held = path.iter_segments().enumerate().all(|(k, segment)| {
            if k > 0 && !holds(on, segment) {
                on += 1;
            }
            let is_held = holds(on, segment);
            // Parts of one line or circle.
            while holds(on + 1, segment) {
                on += 1;
            }
            is_held
        });
        is_held && on + 1 == count
    })
}

/// The library's offset, to the left if it is positive. None where the library left anything out, or
/// where the offset of the contour's start is not on it.
fn whole_offset(contour: &Polyline, offset: f64) -> Option<Polyline> {
    let options = PlineOffsetOptions {
        pos_equal_eps: 1e-7,
        offset_dist_eps: 1e-7,
        ..PlineOffsetOptions::new()
    };
    let mut loops = contour.parallel_offset_opt(offset, &options);
    let only = loops.pop().filter(|_| loops.is_empty())?;
    let start = contour.at(0).pos() + tangents(contour, 0)[0].perp().scale(offset);
    let is_whole = follows(&only, &carriers(contour, offset)?)
        && only.closest_point(start, SAME)?.distance < 1e-6;
    is_whole.then_some(only)
}

/// What the library says of a contour.
pub(crate) enum Judgement {
    /// All of the offset is there.
    Whole(Polyline),
    /// Some of it came too near.
    Lacking,
    /// A hair more or less would turn the answer, or the library trips over its own roundings.
    Undecided,
}

pub(crate) fn judge(contour: &Polyline, offset: f64) -> Judgement {
    let [less, more] = [1.0 - 1e-4, 1.0 + 1e-4].map(|share| share * offset);
    let all = catch_unwind(|| [less, offset, more].map(|offset| whole_offset(contour, offset)));
    match all {
        Ok([Some(_), Some(whole), Some(_)]) => Judgement::Whole(whole),
        Ok([None, None, None]) => Judgement::Lacking,
        _ => Judgement::Undecided,
    }
}
