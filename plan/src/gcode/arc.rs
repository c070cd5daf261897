//! An arc as programmed, and the same arc in whole pulses.

use super::centre::{self, NoCentre};
use super::modes::too_far;
use super::word::Fault;
use crate::Length;
use num_bigint::BigUint;
use onepulse_core::{Direction, Sweep};
use std::ops::Range;

/// Where the centre of an arc is, and which of the two ways round it goes. Points are of the
/// arc's plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ProgrammedArc {
    /// About a point seen from the start and the end, exactly.
    Centre { start: [Length; 2], end: [Length; 2], centre: [Length; 2] },
    /// With a radius: negative for the way of more than half a turn.
    Radius { chord: [Length; 2], radius: Length, span: (usize, usize) },
}

/// A line or, with a centre, an arc between two points, in pulses.
type Piece = ([[i32; 2]; 2], Option<[i64; 2]>);

/// How far apart the radii at the start and the end of an arc may be. Within it the arc runs on
/// the circle through its start, and still ends on its end point.
const RADIUS_TOLERANCE: Length = Length::from_picometres(5_000_000);

/// Points further than this from a centre would overflow what is computed of them.
const FARTHEST: u64 = 1 << 62;

/// The tolerance on a machine: what writing three decimals costs, or two pulses if that is more.
fn tolerance(pulse: Length) -> Length {
    RADIUS_TOLERANCE.max(Length::from_picometres(pulse.picometres().saturating_mul(2)))
}

/// The arc about the point `offset` away from the start.
pub(super) fn by_centre(
    [from, to]: [[Length; 2]; 2],
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
    if start.iter().chain(&end).any(|c| c.picometres().unsigned_abs() > FARTHEST) {
        return Err(far());
    }
    let tolerance = tolerance(pulse);
    if !are_within(squared(start), squared(end), tolerance) {
        let radius = |[x, y]: [Length; 2]| x.millimetres().hypot(y.millimetres());
        return Err(Fault::new(
            span.clone(),
            format!(
                "the end point is off the circle: its radius is {:.6} mm, the start's {:.6} mm",
                radius(end),
                radius(start)
            ),
            format!(
                "correct the end point or the centre; a difference of {} mm is tolerated",
                tolerance.millimetres()
            ),
        ));
    }
    Ok(ProgrammedArc::Centre { start, end, centre })
}

/// The arc of a radius.
pub(super) fn by_radius(
    [from, to]: [[Length; 2]; 2],
    radius: Length,
    span: &Range<usize>,
) -> Result<ProgrammedArc, Fault> {
    let far = || too_far(span);
    let chord =
        [to[0].checked_sub(from[0]).ok_or_else(far)?, to[1].checked_sub(from[1]).ok_or_else(far)?];
    if chord.iter().chain([&radius]).any(|c| c.picometres().unsigned_abs() > FARTHEST) {
        return Err(far());
    }
    Ok(ProgrammedArc::Radius { chord, radius, span: (span.start, span.end) })
}

impl ProgrammedArc {
    /// The arc in whole pulses: one piece, two, or none.
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
    ) -> Result<[Option<Piece>; 2], Fault> {
        let [from, to] = ends;
        let (centre, is_long) = match self {
            Self::Centre { start, end, centre } => {
                let centre = centre.map(|c| c.in_pulses(pulse));
                (centre, is_long_way(exact(start), exact(end), direction))
            }
            Self::Radius { chord, radius, span } => {
                let is_left = is_left(radius, direction);
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
        let line = (from != to).then_some((ends, None));
        if start == [0, 0] || end == [0, 0] {
            // A circle smaller than a pulse.
            return Ok([line, None]);
        }
        Sweep::new(start, end, direction).map_err(|why| {
            Fault::new(span.clone(), why.to_string(), "take a coarser pulse equivalent")
        })?;
        let runs_long = is_long_way(start.map(i128::from), end.map(i128::from), direction);
        let is_near = (0..2).all(|axis| start[axis].abs_diff(end[axis]) <= 4);
        Ok(match (is_long, runs_long) {
            (false, true) if is_near => [line, None],
            (true, false) if is_near => [Some(([from, from], Some(centre))), line],
            _ => [Some((ends, Some(centre))), None],
        })
    }

    /// The centre as programmed, in millimetres, of an arc from `from`.
    pub(crate) fn centre(self, from: [Length; 2], direction: Direction) -> [f64; 2] {
        match self {
            Self::Centre { centre, .. } => centre.map(Length::millimetres),
            Self::Radius { chord, radius, .. } => {
                let diameter = 2 * u128::from(radius.picometres().unsigned_abs());
                let chord_squared = squared(chord);
                let excess = (diameter * diameter).saturating_sub(chord_squared);
                let height = (excess as f64 / chord_squared as f64).sqrt() / 2.0;
                let height = if is_left(radius, direction) { height } else { -height };
                let [dx, dy] = chord.map(Length::millimetres);
                let [x, y] = from.map(Length::millimetres);
                [x + dx / 2.0 - dy * height, y + dy / 2.0 + dx * height]
            }
        }
    }

    /// The centre in millimetres of the circle just through the start and the end point, on which an
    /// arc is compensated.
    ///
    /// Where their radii differ, within the tolerance, the programmed centre is moved along the chord
    /// until it is as far from both.
    pub(crate) fn common_centre(
        self,
        from: [Length; 2],
        direction: Direction,
        pulse: Length,
        span: &Range<usize>,
    ) -> Result<[f64; 2], Fault> {
        let programmed = self.centre(from, direction);
        match self {
            Self::Radius { chord, radius, span: (start, end) } => {
                let left = is_left(radius, direction);
                centre::centre(chord, radius, left, pulse, tolerance(pulse))
                    .map(|_| programmed)
                    .map_err(|why| no_centre(why, start..end))
            }
            Self::Centre { start, end, .. } => {
                let [begun, ended] = [squared(start), squared(end)];
                if begun == ended {
                    return Ok(programmed);
                }
                let excess =
                    if ended > begun { (ended - begun) as f64 } else { -((begun - ended) as f64) };
                let chord = [0, 1].map(|axis| end[axis].millimetres() - start[axis].millimetres());
                let length = chord[0].hypot(chord[1]);
                let square_millimetre = (Length::MILLIMETRE.picometres() as f64).powi(2);
                let way = excess / square_millimetre / (2.0 * length);
                if is_long_way(exact(start), exact(end), direction)
                    && way.abs() > tolerance(pulse).millimetres()
                {
                    return Err(Fault::new(
                        span.clone(),
                        "this nearly whole turn ends off its circle: it has no centre to be compensated about",
                        "end where the arc starts, or correct the centre",
                    ));
                }
                Ok([0, 1].map(|axis| programmed[axis] + way * chord[axis] / length))
            }
        }
    }
}

/// Whether the centre of an arc by its radius is on the left of its chord.
fn is_left(radius: Length, direction: Direction) -> bool {
    (direction == Direction::Ccw) == (radius >= Length::ZERO)
}

fn exact(point: [Length; 2]) -> [i128; 2] {
    point.map(|c| i128::from(c.picometres()))
}

/// The square of a distance, in square picometres.
fn squared(point: [Length; 2]) -> u128 {
    let [x, y] = point.map(|c| u128::from(c.picometres().unsigned_abs()));
    x * x + y * y
}

/// Whether the roots of two squares are no further apart than `tolerance`: |√a − √b| ≤ t where
/// a + b − t² ≤ 2√(ab).
fn are_within(a: u128, b: u128, tolerance: Length) -> bool {
    let [a, b] = [a, b].map(BigUint::from);
    let square = BigUint::from(tolerance.picometres().unsigned_abs()).pow(2);
    let sum = &a + &b;
    sum <= square || (sum - square).pow(2) <= 4_u32 * a * b
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
