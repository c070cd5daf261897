//! The coarse one of two levels (粗插补): a block sample by sample, in whole pulses.
//!
//! Each period of T seconds has a point of the curve, by data sampling; the pulses between two of
//! them, rounded, are a microsegment. The fine level (精插补) makes every microsegment as a DDA line
//! of 2ⁿ accumulations in the same T, so that its pulses spread over the period: f_g = 2ⁿ/T. The
//! last sample of a block is what is left to the end point: a shorter way, which takes a whole
//! period too.
//!
//! Or the points are those of a planned motion, on the curve itself: then a block's end has a time of its
//! own, and parts the period; each part is a microsegment of 2ⁿ accumulations in its own time.

use super::interpolated::Interpolated;
use super::planned::{PlannedBlock, Speeds};
use super::speed::Speed;
use super::two_level::TwoLevel;
use crate::curve::Curve;
use crate::machine::Refusal;
use crate::profile::Row;
use onepulse_core::Error;
use onepulse_core::dda::{Radix, Register};
use onepulse_plan::sampling::{Arc, Line, Pulses, chord_error};
use serde::Serialize;

/// A block, sampled.
#[derive(Clone, Debug)]
pub(super) struct Coarse<'a> {
    samples: Samples<'a>,
    /// Of planned speeds, the record of each sample.
    records: &'a [Row],
    pub(super) report: SamplingReport,
}

/// The line of a sample.
#[derive(Clone, Copy, Debug)]
pub(super) struct Microsegment {
    /// Its pulses along the curve's axes; in a plane the third are none.
    pub(super) to: [i32; 3],
    /// The motion at its end, where speeds are planned.
    pub(super) record: Option<Row>,
}

/// The samples of a block, relative to its origin, along its curve's axes; in a plane the third
/// coordinate is 0. They count pulses, not millimetres: so start and
/// end are whole numbers, and whether an arc is a full turn is seen as exactly as in the pulse
/// methods.
#[derive(Clone, Debug)]
struct Samples<'a> {
    start: [f64; 3],
    points: Points<'a>,
    /// The way of a period; the longest, where speeds are planned.
    step: f64,
    /// An arc's radius.
    radius: Option<f64>,
}

#[derive(Clone, Debug)]
enum Points<'a> {
    Line(Line),
    SpaceLine(Line<3>),
    Arc(Arc),
    Planned {
        records: std::slice::Iter<'a, Row>,
        /// The curve's axes: their places among x, y and z.
        axes: [usize; 3],
        is_in_space: bool,
        /// Along these axes.
        origin: [i64; 3],
        pulse: f64,
    },
}

impl Iterator for Points<'_> {
    type Item = [f64; 3];

    fn next(&mut self) -> Option<[f64; 3]> {
        let in_plane = |[first, second]: [f64; 2]| [first, second, 0.0];
        match self {
            Self::Line(line) => line.next().map(in_plane),
            Self::SpaceLine(line) => line.next(),
            Self::Arc(arc) => arc.next().map(in_plane),
            Self::Planned { records, axes, is_in_space, origin, pulse } => {
                let point = records.next()?.point;
                let counted = |k: usize| point[axes[k]] / *pulse - origin[k] as f64;
                let across = if *is_in_space { counted(2) } else { 0.0 };
                Some([counted(0), counted(1), across])
            }
        }
    }
}

/// How points of a planned motion are found.
pub(super) const PLANNED: &str = "planned";

/// What the report says of the samples of a block; errors in pulses.
#[derive(Clone, Debug, Serialize)]
pub(super) struct SamplingReport {
    /// How the points were found; those of a line are the same by every method.
    method: &'static str,
    period_ms: f64,
    pub(super) samples: u64,
    /// n, the width of the fine level's registers.
    pub(super) bits: u32,
    step_mm: f64,
    /// The feed that these steps make.
    pub(super) feed_mm_per_min: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) feed_reduced_for: Option<Reduced>,
    /// Where they are planned. Step and feed are then those of the steady speed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) speeds_mm_per_s: Option<Speeds>,
    /// Largest of the chords: what one's nearest point to the centre lacks to its nearer end.
    pub(super) chord_error: f64,
    /// Largest |radius − R| of the samples; 0 for lines.
    pub(super) radius_error: f64,
    /// From a sample to its rounded point, at most.
    pub(super) rounding: f64,
    /// From the pulses to the microsegment that they make, at most.
    pub(super) fine: f64,
}

/// Why a block is slower than its feed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Reduced {
    /// A step is a quarter of the radius at most.
    Radius,
    /// No chord error may exceed the tolerance.
    Tolerance,
    /// v²/R is the largest centripetal acceleration.
    Centripetal,
}

impl SamplingReport {
    /// Once the pulses are made.
    pub(super) fn with_fine(self, fine: f64) -> Self {
        Self { fine, ..self }
    }

    /// What the largest deviation cannot exceed. A point of the path is `fine` or less off its
    /// microsegment, whose ends are `rounding` or less off two samples, so that it is no further off
    /// their chord; and a point of the chord is off the circle by no more than the other two.
    pub(super) fn bound(&self) -> f64 {
        self.chord_error + self.radius_error + self.rounding + self.fine
    }
}

impl<'a> Coarse<'a> {
    /// Samples a block for fine registers of at most `widest` bits.
    pub(super) fn new(
        curve: &Curve,
        speed: Speed,
        two_level: &TwoLevel,
        widest: u32,
    ) -> Result<Self, Refusal> {
        let asked = speed.pulses_per_second() * two_level.period_ms / 1000.0;
        let tolerance = two_level.tolerance_mm.map(|mm| mm / speed.pulse.millimetres());
        let samples = Samples::of(curve, asked, two_level, tolerance)?;
        let (step, radius) = (samples.step, samples.radius);
        let feed_reduced_for = match radius {
            _ if step == asked => None,
            Some(radius) if step == radius / 4.0 => Some(Reduced::Radius),
            _ => Some(Reduced::Tolerance),
        };
        let report = SamplingReport {
            method: radius.map_or("line", |_| two_level.sampling.name()),
            period_ms: two_level.period_ms,
            samples: 0,
            bits: 0,
            step_mm: step * speed.pulse.millimetres(),
            feed_mm_per_min: speed.millimetres_per_minute() * (step / asked),
            feed_reduced_for,
            speeds_mm_per_s: None,
            chord_error: 0.0,
            radius_error: 0.0,
            rounding: 0.0,
            fine: 0.0,
        };
        Self::surveyed(samples, &[], report, two_level, widest)
    }

    /// The samples of a block's planned motion, likewise.
    pub(super) fn planned(
        block: &Interpolated,
        speed: Speed,
        planned: &PlannedBlock<'a>,
        two_level: &TwoLevel,
        widest: u32,
    ) -> Result<Self, Refusal> {
        let PlannedBlock { records, speeds, reduced, .. } = *planned;
        let pulse = speed.pulse.millimetres();
        let (start, radius) = match block.curve {
            Curve::Arc { from, .. } => {
                let [x, y] = from.map(f64::from);
                ([x, y, 0.0], Some(x.hypot(y)))
            }
            _ => ([0.0; 3], None),
        };
        let step_mm = speeds.steady * two_level.period_ms / 1000.0;
        let report = SamplingReport {
            method: PLANNED,
            period_ms: two_level.period_ms,
            samples: 0,
            bits: 0,
            step_mm,
            feed_mm_per_min: speeds.steady * 60.0,
            feed_reduced_for: reduced,
            speeds_mm_per_s: Some(speeds),
            chord_error: 0.0,
            radius_error: 0.0,
            rounding: 0.0,
            fine: 0.0,
        };
        let points = Points::Planned {
            records: records.iter(),
            axes: block.plane.axes(),
            is_in_space: block.is_in_space(),
            origin: block.in_order(block.origin),
            pulse,
        };
        let samples = Samples { start, points, step: step_mm / pulse, radius };
        Self::surveyed(samples, records, report, two_level, widest)
    }

    /// Fills in the report, and finds the width of the registers.
    fn surveyed(
        samples: Samples<'a>,
        records: &'a [Row],
        mut report: SamplingReport,
        two_level: &TwoLevel,
        widest: u32,
    ) -> Result<Self, Refusal> {
        let largest = samples.survey(&mut report);
        let largest = u32::try_from(largest).unwrap_or(u32::MAX);
        let needed = Register::holding(Radix::Binary, largest).digits();
        if needed > widest {
            return Err(Error::RegisterTooNarrow { digits: widest, needed }.into());
        }
        report.bits = two_level.bits.unwrap_or(needed);
        Ok(Self { samples, records, report })
    }

    /// The cycles of a microsegment.
    pub(super) fn cycles(&self) -> u64 {
        1 << self.report.bits
    }

    /// The frequency f_g of the fine level, where every sample takes a period.
    pub(super) fn cycles_per_second(&self) -> f64 {
        2_f64.powi(self.report.bits as i32) / (self.report.period_ms / 1000.0)
    }

    /// The line of each sample.
    pub(super) fn microsegments(&self) -> impl Iterator<Item = Microsegment> + use<'a> {
        let Samples { start, points, .. } = self.samples.clone();
        let mut pulses = Pulses::new(1.0, start);
        let records = self.records;
        points.enumerate().map(move |(k, point)| {
            // Any two points of a program are an i32 apart.
            let to = pulses.to(point).map(|c| c as i32);
            Microsegment { to, record: records.get(k).copied() }
        })
    }
}

impl Samples<'_> {
    fn of(
        curve: &Curve,
        asked: f64,
        two_level: &TwoLevel,
        tolerance: Option<f64>,
    ) -> Result<Self, Refusal> {
        const NOT_SAMPLED: Refusal = Refusal::Method("lines of 2 and 3 axes and arcs are sampled");
        match *curve {
            Curve::Line { ref to } => {
                let points = match *to.as_slice() {
                    [x, y] => Points::Line(Line::new([x, y].map(f64::from), asked)?),
                    [x, y, z] => Points::SpaceLine(Line::new([x, y, z].map(f64::from), asked)?),
                    _ => return Err(NOT_SAMPLED),
                };
                Ok(Self { start: [0.0; 3], points, step: asked, radius: None })
            }
            Curve::Arc { from, to, direction } => {
                let [start, end] = [from, to].map(|point| point.map(f64::from));
                let radius = start[0].hypot(start[1]);
                let step = asked.min(radius / 4.0);
                let mut arc = Arc::new(start, end, direction, two_level.sampling.into(), step)?;
                if let Some(tolerance) = tolerance {
                    arc = arc.within(tolerance)?;
                }
                let (step, radius) = (arc.step(), Some(radius));
                let start = [start[0], start[1], 0.0];
                Ok(Self { start, points: Points::Arc(arc), step, radius })
            }
            Curve::Parabola { .. } | Curve::Helix { .. } => Err(NOT_SAMPLED),
        }
    }

    /// Goes through the samples once: their number and errors go into the report. Returns the most
    /// pulses that an axis has in one of them.
    fn survey(&self, report: &mut SamplingReport) -> u64 {
        let mut pulses = Pulses::new(1.0, self.start);
        let (mut last, mut largest) = (self.start, 0);
        for point in self.points.clone() {
            report.samples += 1;
            let [x, y, z] = pulses.to(point).map(i64::unsigned_abs);
            largest = largest.max(x).max(y).max(z);
            let [x, y, z] = pulses.position().map(|c| c as f64);
            let off = (point[0] - x).hypot(point[1] - y).hypot(point[2] - z);
            report.rounding = report.rounding.max(off);
            if let Some(radius) = self.radius {
                report.chord_error = report.chord_error.max(sagitta(last, point));
                let off = (point[0].hypot(point[1]) - radius).abs();
                report.radius_error = report.radius_error.max(off);
            }
            last = point;
        }
        largest
    }
}

/// What a chord's nearest point to the centre lacks to its end nearer to the centre: the chord error
/// where both are on one circle, and right too where the end point of an arc is off it.
fn sagitta([x, y, _]: [f64; 3], [to_x, to_y, _]: [f64; 3]) -> f64 {
    let (from, to) = ([x, y], [to_x, to_y]);
    let radius = |[x, y]: [f64; 2]| x.hypot(y);
    let (near, far) = if radius(from) <= radius(to) { (from, to) } else { (to, from) };
    let way = [far[0] - near[0], far[1] - near[1]];
    // From the nearer end to the foot of the perpendicular: half the chord, or less.
    let to_foot = -(near[0] * way[0] + near[1] * way[1]) / radius(way);
    // No number where the chord has no length; none below zero lies on the chord.
    if to_foot > 0.0 { chord_error(radius(near), 2.0 * to_foot.min(radius(near))) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chords_of_known_points() {
        // The 3-4-5 triangle: from (−3, 4) to (3, 4) the circle of radius 5 is 1 off.
        assert!((sagitta([-3.0, 4.0, 0.0], [3.0, 4.0, 0.0]) - 1.0).abs() < 1e-15);
        // The further end further out on the same line, in either order.
        assert!((sagitta([-3.0, 4.0, 0.0], [9.0, 4.0, 0.0]) - 1.0).abs() < 1e-15);
        assert!((sagitta([9.0, 4.0, 0.0], [-3.0, 4.0, 0.0]) - 1.0).abs() < 1e-15);
        // The nearer end is the nearest point.
        assert_eq!(sagitta([3.0, 4.0, 0.0], [9.0, 4.0, 0.0]), 0.0);
        assert_eq!(sagitta([3.0, 4.0, 0.0], [3.0, 4.0, 0.0]), 0.0);
        // Through the centre.
        assert_eq!(sagitta([-1.0, 0.0, 0.0], [2.0, 0.0, 0.0]), 1.0);
    }
}
