//! The coarse one of two levels (粗插补): a block sample by sample, in whole pulses.
//!
//! Each period of T seconds has a point of the curve, by data sampling; the pulses between two of
//! them, rounded, are a microsegment. The fine level (精插补) makes every microsegment as a DDA line
//! of 2ⁿ accumulations in the same T, so that its pulses spread over the period: f_g = 2ⁿ/T. The
//! last sample of a block is what is left to the end point: a shorter way, which takes a whole
//! period too.

use super::speed::Speed;
use super::two_level::TwoLevel;
use crate::curve::Curve;
use crate::machine::Refusal;
use onepulse_core::Error;
use onepulse_core::dda::{Radix, Register};
use onepulse_plan::sampling::{Arc, Line, Pulses, chord_error};
use serde::Serialize;

/// A block, sampled.
#[derive(Clone, Debug)]
pub(super) struct Coarse {
    samples: Samples,
    pub(super) report: SamplingReport,
}

/// The samples of a block, relative to its origin. They count pulses, not millimetres: so start and
/// end are whole numbers, and whether an arc is a full turn is seen as exactly as in the pulse
/// methods.
#[derive(Clone, Copy, Debug)]
struct Samples {
    start: [f64; 2],
    points: Points,
    /// The way of a period.
    step: f64,
    /// An arc's radius.
    radius: Option<f64>,
}

#[derive(Clone, Copy, Debug)]
enum Points {
    Line(Line),
    Arc(Arc),
}

impl Iterator for Points {
    type Item = [f64; 2];

    fn next(&mut self) -> Option<[f64; 2]> {
        match self {
            Self::Line(line) => line.next(),
            Self::Arc(arc) => arc.next(),
        }
    }
}

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

impl Coarse {
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
        let Samples { step, radius, .. } = samples;
        let feed_reduced_for = match radius {
            _ if step == asked => None,
            Some(radius) if step == radius / 4.0 => Some(Reduced::Radius),
            _ => Some(Reduced::Tolerance),
        };
        let mut report = SamplingReport {
            method: radius.map_or("line", |_| two_level.sampling.name()),
            period_ms: two_level.period_ms,
            samples: 0,
            bits: 0,
            step_mm: step * speed.pulse.millimetres(),
            feed_mm_per_min: speed.millimetres_per_minute() * (step / asked),
            feed_reduced_for,
            chord_error: 0.0,
            radius_error: 0.0,
            rounding: 0.0,
            fine: 0.0,
        };
        let largest = samples.survey(&mut report);
        let largest = u32::try_from(largest).unwrap_or(u32::MAX);
        let needed = Register::holding(Radix::Binary, largest).digits();
        if needed > widest {
            return Err(Error::RegisterTooNarrow { digits: widest, needed }.into());
        }
        report.bits = two_level.bits.unwrap_or(needed);
        Ok(Self { samples, report })
    }

    /// The frequency f_g of the fine level.
    pub(super) fn cycles_per_second(&self) -> f64 {
        2_f64.powi(self.report.bits as i32) / (self.report.period_ms / 1000.0)
    }

    /// The pulses of each sample.
    pub(super) fn microsegments(&self) -> impl Iterator<Item = [i32; 2]> + use<> {
        let Samples { start, points, .. } = self.samples;
        let mut pulses = Pulses::new(1.0, start);
        // Any two points of a program are an i32 apart.
        points.map(move |point| pulses.to(point).map(|c| c as i32))
    }
}

impl Samples {
    fn of(
        curve: &Curve,
        asked: f64,
        two_level: &TwoLevel,
        tolerance: Option<f64>,
    ) -> Result<Self, Refusal> {
        const PLANE_ONLY: Refusal = Refusal::Method("lines of 2 axes and arcs are sampled");
        match *curve {
            Curve::Line { ref to } => {
                let &[x, y] = to.as_slice() else { return Err(PLANE_ONLY) };
                let points = Points::Line(Line::new([x, y].map(f64::from), asked)?);
                Ok(Self { start: [0.0; 2], points, step: asked, radius: None })
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
                Ok(Self { start, points: Points::Arc(arc), step, radius })
            }
            Curve::Parabola { .. } | Curve::Helix { .. } => Err(PLANE_ONLY),
        }
    }

    /// Goes through the samples once: their number and errors go into the report. Returns the most
    /// pulses that an axis has in one of them.
    fn survey(&self, report: &mut SamplingReport) -> u64 {
        let mut pulses = Pulses::new(1.0, self.start);
        let (mut last, mut largest) = (self.start, 0);
        for point in self.points {
            report.samples += 1;
            let [x, y] = pulses.to(point).map(i64::unsigned_abs);
            largest = largest.max(x).max(y);
            let [x, y] = pulses.position().map(|c| c as f64);
            report.rounding = report.rounding.max((point[0] - x).hypot(point[1] - y));
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
fn sagitta(from: [f64; 2], to: [f64; 2]) -> f64 {
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
        assert!((sagitta([-3.0, 4.0], [3.0, 4.0]) - 1.0).abs() < 1e-15);
        // The further end further out on the same line, in either order.
        assert!((sagitta([-3.0, 4.0], [9.0, 4.0]) - 1.0).abs() < 1e-15);
        assert!((sagitta([9.0, 4.0], [-3.0, 4.0]) - 1.0).abs() < 1e-15);
        // The nearer end is the nearest point.
        assert_eq!(sagitta([3.0, 4.0], [9.0, 4.0]), 0.0);
        assert_eq!(sagitta([3.0, 4.0], [3.0, 4.0]), 0.0);
        // Through the centre.
        assert_eq!(sagitta([-1.0, 0.0], [2.0, 0.0]), 1.0);
    }
}
