//! An arc as programmed, and the same arc in whole pulses.

use super::centre::{self, NoCentre};
use super::modes::too_far;
use super::word::Fault;
use crate::{Curve, Length};
use onepulse_core::{Direction, Plane, Sweep};
use std::ops::Range;

/// Where the centre of an arc is, and which of the two ways round it goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ProgrammedArc {
    /// About a point seen from the start and the end, exactly.
    Centre { start: [Length; 2], end: [Length; 2], centre: [Length; 2] },
    /// With a radius: negative for the way of more than half a turn.
    Radius { chord: [Length; 2], radius: Length, span: (usize, usize) },
}

/// A curve and its two ends, in pulses.
type Piece = ([[i32; 2]; 2], Curve);

/// How far apart the radii at the start and the end of an arc may be. Within it the arc runs on
/// the circle through its start, and still ends on its end point.
const RADIUS_TOLERANCE: Length = Length::from_picometres(5_000_000);

/// The tolerance on a machine: what writing three decimals costs, or two pulses if that is more.
fn tolerance(pulse: Length) -> Length {
    RADIUS_TOLERANCE.max(Length::from_picometres(pulse.picometres().saturating_mul(2)))
}

/// The arc about the point `offset` away from the start.
pub(super) fn by_centre(
    from: [Length; 2],
    to: [Length; 2],
    offset: [Length; 2],
    pulse: Length,
    span: &Range<usize>,
) -> Result<ProgrammedArc, Fault> {
    let far = || too_far(span);
    let mut centre = [Length::ZERO; 2];
    let mut start = [Length::ZERO; 2];
    let mut end = [Length::ZERO; 2];
    for axis in 0..2 {
        centre[axis] = from[axis].checked_add(offset[axis]).ok_or_else(far)?;
        start[axis] = from[axis].checked_sub(centre[axis]).ok_or_else(far)?;
        end[axis] = to[axis].checked_sub(centre[axis]).ok_or_else(far)?;
    }
    let radius = |[x, y]: [Length; 2]| x.millimetres().hypot(y.millimetres());
    let tolerance = tolerance(pulse).millimetres();
    if (radius(start) - radius(end)).abs() > tolerance {
        return Err(Fault::new(
            span.clone(),
            format!(
                "the end point is off the circle: its radius is {:.6} mm, the start's {:.6} mm",
                radius(end),
                radius(start)
            ),
            format!("correct X Y or I J; a difference of {tolerance} mm is tolerated"),
        ));
    }
    Ok(ProgrammedArc::Centre { start, end, centre })
}

/// The arc of a radius.
pub(super) fn by_radius(
    from: [Length; 2],
    to: [Length; 2],
    radius: Length,
    span: &Range<usize>,
) -> Result<ProgrammedArc, Fault> {
    let far = || too_far(span);
    let chord =
        [to[0].checked_sub(from[0]).ok_or_else(far)?, to[1].checked_sub(from[1]).ok_or_else(far)?];
    Ok(ProgrammedArc::Radius { chord, radius, span: (span.start, span.end) })
}

impl ProgrammedArc {
    /// The arc in whole pulses: one piece, or two of which the second may be empty.
    ///
    /// Where start and end nearly meet, rounding can turn a short way into a whole turn or a
    /// whole turn into nothing. The short way is then a line; the whole turn is made to its start,
    /// and a line adds what is missing.
    pub(super) fn in_pulses(
        self,
        ends: [[i32; 2]; 2],
        direction: Direction,
        pulse: Length,
        span: &Range<usize>,
    ) -> Result<[Piece; 2], Fault> {
        let [from, to] = ends;
        let (centre, is_long) = match self {
            Self::Centre { start, end, centre } => {
                let exact = |point: [Length; 2]| point.map(|c| i128::from(c.picometres()));
                let centre = centre.map(|c| c.in_pulses(pulse));
                (centre, is_long_way(exact(start), exact(end), direction))
            }
            Self::Radius { chord, radius, span } => {
                let is_left = (direction == Direction::Ccw) == (radius >= Length::ZERO);
                let offset = centre::centre(chord, radius, is_left, pulse, tolerance(pulse))
                    .map_err(|why| no_centre(why, span.0..span.1))?;
                let centre = [0, 1].map(|axis| i64::from(from[axis]).saturating_add(offset[axis]));
                (centre, radius < Length::ZERO)
            }
        };
        let seen = |point: [i32; 2]| -> Option<[i32; 2]> {
            let x = i64::from(point[0]).checked_sub(centre[0])?;
            let y = i64::from(point[1]).checked_sub(centre[1])?;
            Some([i32::try_from(x).ok()?, i32::try_from(y).ok()?])
        };
        let (Some(start), Some(end)) = (seen(from), seen(to)) else {
            return Err(too_far(span));
        };
        let nothing = ([to, to], Curve::Line);
        if start == [0, 0] || end == [0, 0] {
            // A circle smaller than a pulse.
            return Ok([(ends, Curve::Line), nothing]);
        }
        Sweep::new(start, end, direction).map_err(|why| {
            Fault::new(span.clone(), why.to_string(), "take a coarser pulse equivalent")
        })?;
        let arc = Curve::Arc { plane: Plane::Xy, centre, direction };
        let runs_long = is_long_way(start.map(i128::from), end.map(i128::from), direction);
        let is_near = (0..2).all(|axis| start[axis].abs_diff(end[axis]) <= 4);
        Ok(match (is_long, runs_long) {
            (false, true) if is_near => [(ends, Curve::Line), nothing],
            (true, false) if is_near => [([from, from], arc), (ends, Curve::Line)],
            _ => [(ends, arc), nothing],
        })
    }
}

/// Whether the way from `start` to `end` about the origin is more than half a turn; ends in one
/// direction from it are a whole turn.
fn is_long_way(start: [i128; 2], end: [i128; 2], direction: Direction) -> bool {
    let turn = start[0] * end[1] - start[1] * end[0];
    let is_opposite = start[0] * end[0] + start[1] * end[1] < 0;
    match direction {
        _ if turn == 0 => !is_opposite,
        Direction::Ccw => turn < 0,
        Direction::Cw => turn > 0,
    }
}

fn no_centre(why: NoCentre, span: Range<usize>) -> Fault {
    match why {
        NoCentre::SamePoint => Fault::new(
            span,
            "an arc by its radius that ends where it starts: any circle through the point would do",
            "give the centre with I J",
        ),
        NoCentre::TooFarApart => Fault::new(
            span,
            "the end point is further away than this radius reaches",
            "correct X Y, or take a radius of at least half the distance",
        ),
    }
}
