//! Paths run through ramps and loops, and how far they come out off the programmed ones.

use onepulse_plan::after_interpolation::{increments, points};
use onepulse_plan::servo::Axis;
use std::f64::consts::TAU;

/// Turns until a start is forgotten.
const TURNS: f64 = 20.0;

/// Sample periods at least until a loop has settled.
const PERIODS: usize = 10_000;

/// Points of an increment that are looked at.
const CUTS: u32 = 64;

/// The points of a circle, `step` apart along it, for many turns and periods.
fn round(radius: f64, step: f64) -> (usize, impl Fn(usize) -> [f64; 2]) {
    let angle = step / radius;
    let samples = ((TURNS * TAU / angle).ceil() as usize).max(PERIODS);
    (samples, move |k: usize| {
        let (sin, cos) = (angle * k as f64).sin_cos();
        [radius * cos, radius * sin]
    })
}

/// What a ramp takes from the radius of a circle, once the start is forgotten.
pub(super) fn circle<I: Iterator<Item = [f64; 2]>>(
    radius: f64,
    step: f64,
    ramp: impl FnOnce(Vec<[f64; 2]>) -> I,
) -> f64 {
    let (samples, on) = round(radius, step);
    let way = increments(on(0), (1..=samples).map(&on)).collect();
    let ramped = points(on(0), ramp(way)).nth(samples - 1);
    ramped.map_or(0.0, |[x, y]| radius - x.hypot(y))
}

/// What two loops take from it.
pub(super) fn circle_followed(axis: Axis, radius: f64, step: f64) -> f64 {
    let (samples, on) = round(radius, step);
    let mut axes = [axis; 2];
    for k in 0..=samples {
        let [x, y] = on(k);
        // The axes count from where they start, on the circle.
        axes[0].step(x - radius);
        axes[1].step(y);
    }
    radius - (radius + axes[0].position()).hypot(axes[1].position())
}

/// How far a loop is behind on a line.
pub(super) fn following_error(mut axis: Axis, step: f64) -> f64 {
    let errors = (0..PERIODS).map(|k| axis.step(step * k as f64).following_error);
    errors.last().unwrap_or_default()
}

/// The largest distance from a corner of 90° of what a ramp makes of it, gone round at a steady speed.
pub(super) fn corner<I: Iterator<Item = [f64; 2]>>(
    step: f64,
    periods: usize,
    ramp: impl FnOnce(Vec<[f64; 2]>) -> I,
) -> f64 {
    let leg = |way: [f64; 2]| std::iter::repeat_n(way, periods);
    let length = step * periods as f64;
    let mut from = [-length, 0.0];
    let mut most = 0.0_f64;
    for increment in ramp(leg([step, 0.0]).chain(leg([0.0, step])).collect()) {
        for cut in 1..=CUTS {
            let share = f64::from(cut) / f64::from(CUTS);
            let [x, y] = [0, 1].map(|axis| from[axis] + share * increment[axis]);
            most = most.max((-x).min(y));
        }
        from = [0, 1].map(|axis| from[axis] + increment[axis]);
    }
    most
}
