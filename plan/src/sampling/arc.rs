//! An arc, sample by sample.

use super::{SamplingError, largest_step};
use onepulse_core::Direction;
use std::f64::consts::TAU;

/// How the next point of an arc is found. All take steps of about f along the arc; x and y are
/// counted from the centre, and the formulas are those of a clockwise arc.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArcMethod {
    /// Time division of the FANUC 7M: tan α = (x + ½·f·cos 45°)/(y − ½·f·sin 45°) is the direction of the
    /// chord, with 45° for the angle in the middle; Δx = f·cos α, and Δy closes the step on the circle,
    /// Δy = y − √(R² − (x + Δx)²). The guess bends the length of the step alone, never the radius.
    SevenM,
    /// Extended digital integration of the 7360: with λ = f/R, Δx = λ·(y − ½·λ·x) and
    /// Δy = −λ·(x + ½·λ·y). Each step multiplies the radius by √(1 + λ⁴/4).
    ExtendedDda,
    /// Δx = f·y/R along the tangent, and y from the circle: y = √(R² − x²).
    DirectFunction,
    /// x′ = x₋₁ + 2·λ·y and y′ = y₋₁ − 2·λ·x, x₋₁ and y₋₁ the point before this one. With λ = sin θ, θ the
    /// angle of a step, that is exact: cos(φ + θ) − cos(φ − θ) = −2·sin θ·sin φ.
    SecondOrder,
}

/// The points of an arc about the origin, in millimetres, one for each sample period; the last one is the
/// end point itself.
///
/// 7M and the direct function close every step on the circle, and the recursion is exact, but for
/// rounding. The radius of the extended digital integration grows by R·((1 + λ⁴/4)^(k/2) − 1) in k
/// steps, π/4·λ³·R or so a turn.
///
/// ```
/// use onepulse_core::Direction;
/// use onepulse_plan::sampling::{Arc, ArcMethod};
/// let arc = Arc::new([5.0, 0.0], [0.0, 5.0], Direction::Ccw, ArcMethod::SevenM, 0.5)?;
/// assert_eq!(arc.last(), Some([0.0, 5.0]));
/// # Ok::<(), onepulse_plan::sampling::SamplingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    method: ArcMethod,
    step: f64,
    /// What no chord may exceed.
    longest: f64,
    radius: f64,
    /// Of the start, kept so that no step adds an error to it.
    radius_squared: f64,
    end: [f64; 2],
    /// 1 counter-clockwise, −1 clockwise.
    turn: f64,
    at: [f64; 2],
    before: [f64; 2],
    /// The angle to the end point.
    left: f64,
}

impl Arc {
    /// The arc from `start` to `end`; ends in the same direction from the centre mean a full turn.
    ///
    /// # Errors
    /// A step that is no positive length, or longer than a quarter of the radius; a point in the centre or
    /// not finite.
    pub fn new(
        start: [f64; 2],
        end: [f64; 2],
        direction: Direction,
        method: ArcMethod,
        step: f64,
    ) -> Result<Self, SamplingError> {
        if !start.iter().chain(&end).all(|c| c.is_finite()) {
            return Err(SamplingError::NotFinite);
        }
        if start == [0.0; 2] || end == [0.0; 2] {
            return Err(SamplingError::InCentre);
        }
        let radius = start[0].hypot(start[1]);
        if step.is_nan() || step <= radius * 1e-12 {
            return Err(SamplingError::NoStep);
        }
        if step > radius / 4.0 {
            return Err(SamplingError::StepTooLong { step, radius });
        }
        let turn = if direction == Direction::Ccw { 1.0 } else { -1.0 };
        let ahead = angle(start, end) * turn;
        let left = if ahead > 0.0 { ahead } else { ahead + TAU };
        // Where the recursion comes from: a step before the start.
        let before = turned(start, -turn * step_angle(step, radius));
        let radius_squared = start[0] * start[0] + start[1] * start[1];
        let longest = f64::INFINITY;
        Ok(Self {
            method,
            step,
            longest,
            radius,
            radius_squared,
            end,
            turn,
            at: start,
            before,
            left,
        })
    }

    /// The same arc with less feed, if need be, so that no chord error exceeds `tolerance`: shorter steps
    /// all along, and where a method's approximation would make one longer than it was meant to be, that one
    /// shorter too.
    ///
    /// # Errors
    /// A tolerance that leaves no step.
    pub fn within(mut self, tolerance: f64) -> Result<Self, SamplingError> {
        self.longest = largest_step(self.radius, tolerance);
        // Less by what rounding may add.
        self.step = self.step.min(self.longest * (1.0 - 1e-9));
        if self.step.is_nan() || self.step <= self.radius * 1e-12 {
            return Err(SamplingError::NoStep);
        }
        self.before = turned(self.at, -self.turn * step_angle(self.step, self.radius));
        Ok(self)
    }

    /// The way of a sample period along the arc, as it is meant to be.
    #[must_use]
    pub const fn step(&self) -> f64 {
        self.step
    }

    /// The radius, that of the start.
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// The point after `at`, which keeps the tolerance.
    fn following(&self) -> [f64; 2] {
        let mut step = self.step;
        loop {
            let next = self.after(step);
            let chord = (next[0] - self.at[0]).hypot(next[1] - self.at[1]);
            if chord <= self.longest {
                return next;
            }
            step *= self.longest / chord * (1.0 - 1e-9);
        }
    }

    /// The point after `at` by a step of this length.
    fn after(&self, step: f64) -> [f64; 2] {
        let Self { at: [x, y], turn, radius, .. } = *self;
        match self.method {
            ArcMethod::SevenM => self.closed(|x, y| {
                // sin 45° and cos 45°.
                let middle = 0.5 * step * std::f64::consts::FRAC_1_SQRT_2;
                let (rise, run) = (x + middle, y - middle);
                let scale = step / rise.hypot(run);
                [scale * run, scale * rise]
            }),
            ArcMethod::DirectFunction => self.closed(|x, y| [step * y / radius, step * x / radius]),
            ArcMethod::ExtendedDda => {
                let lambda = step / radius;
                let half = 0.5 * lambda;
                [x - lambda * (turn * y + half * x), y + lambda * (turn * x - half * y)]
            }
            ArcMethod::SecondOrder => {
                let twice = 2.0 * turn * step_angle(step, radius).sin();
                [self.before[0] - twice * y, self.before[1] + twice * x]
            }
        }
    }

    /// A clockwise step in the first quadrant by Δx and −Δy, functions of x and y, of which the larger
    /// decides and the other one is closed on the circle. The arc is turned there by quarters, and
    /// mirrored if it is counter-clockwise, which changes no digit.
    fn closed(&self, way: impl Fn(f64, f64) -> [f64; 2]) -> [f64; 2] {
        let [mut x, mut y] = [-self.turn * self.at[0], self.at[1]];
        let mut quarters = 0;
        while x < 0.0 || y <= 0.0 {
            (x, y) = (-y, x);
            quarters += 1;
        }
        let [dx, dy] = way(x, y);
        let other = |c: f64| (self.radius_squared - c * c).sqrt();
        (x, y) = if y >= x { (x + dx, other(x + dx)) } else { (other(y - dy), y - dy) };
        for _ in 0..quarters {
            (x, y) = (y, -x);
        }
        [-self.turn * x, y]
    }
}

impl Iterator for Arc {
    type Item = [f64; 2];

    fn next(&mut self) -> Option<[f64; 2]> {
        if self.left <= 0.0 {
            return None;
        }
        let next = self.following();
        let advance = angle(self.at, next) * self.turn;
        // What is left may be less than rounding makes of a whole number of steps.
        let is_last = self.left <= advance * (1.0 + 1e-9);
        (self.before, self.at) = (self.at, next);
        self.left -= advance;
        if is_last {
            self.left = 0.0;
            self.at = self.end;
        }
        Some(self.at)
    }
}

/// The angle from one point to another, counter-clockwise, −π to π.
fn angle([x, y]: [f64; 2], [to_x, to_y]: [f64; 2]) -> f64 {
    (x * to_y - y * to_x).atan2(x * to_x + y * to_y)
}

/// A point turned about the origin.
fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [x * cos - y * sin, y * cos + x * sin]
}

/// The angle of a chord.
fn step_angle(step: f64, radius: f64) -> f64 {
    2.0 * (step / (2.0 * radius)).asin()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::chord_error;
    use proptest::prelude::*;

    const METHODS: [ArcMethod; 4] = [
        ArcMethod::SevenM,
        ArcMethod::ExtendedDda,
        ArcMethod::DirectFunction,
        ArcMethod::SecondOrder,
    ];

    #[test]
    fn what_cannot_be_sampled_is_refused() {
        let new = |start, end, step| {
            Arc::new(start, end, Direction::Cw, ArcMethod::SevenM, step).map(|arc| arc.radius())
        };
        let (start, end) = ([4.0, 3.0], [0.0, 5.0]);
        assert_eq!(new(start, end, 1.0), Ok(5.0));
        for step in [0.0, -1.0, f64::NAN, 1e-15] {
            assert_eq!(new(start, end, step), Err(SamplingError::NoStep), "{step}");
        }
        let too_long = SamplingError::StepTooLong { step: 1.5, radius: 5.0 };
        assert_eq!(new(start, end, 1.5), Err(too_long));
        assert_eq!(new([0.0; 2], end, 1.0), Err(SamplingError::InCentre));
        assert_eq!(new(start, [0.0; 2], 1.0), Err(SamplingError::InCentre));
        assert_eq!(new(start, [f64::NAN, 0.0], 1.0), Err(SamplingError::NotFinite));
    }

    /// Bounds on the radius, relative to it, after k steps.
    fn radius_bound(method: ArcMethod, lambda: f64, k: usize) -> f64 {
        match method {
            ArcMethod::SevenM | ArcMethod::DirectFunction => 1e-9,
            // Rounding grows by a term a step, and with it linearly.
            ArcMethod::SecondOrder => 1e-9 + 1e-14 * k as f64,
            ArcMethod::ExtendedDda => {
                ((1.0 + lambda.powi(4) / 4.0).ln() * k as f64 / 2.0).exp_m1() * (1.0 + 1e-9) + 1e-12
            }
        }
    }

    /// What a step may be too long by, in steps for each λ.
    fn stretch(method: ArcMethod) -> f64 {
        match method {
            ArcMethod::SevenM => 0.3,
            // Most where x = y and λ = ¼: 1.19 steps.
            ArcMethod::DirectFunction => 0.8,
            // √(1 + λ²/4) of a radius that grows.
            ArcMethod::ExtendedDda => 0.1,
            ArcMethod::SecondOrder => 0.0,
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(500) })]

        /// Every quadrant, both senses, any sweep.
        #[test]
        fn points_keep_to_the_circle_and_end_on_the_end_point(
            radius in 0.1..1000.0,
            from in 0.0..TAU,
            sweep in 0.001..TAU,
            lambda in 0.001..0.25,
            clockwise: bool,
        ) {
            let direction = if clockwise { Direction::Cw } else { Direction::Ccw };
            let turn = if clockwise { -1.0 } else { 1.0 };
            let on = |angle: f64| [radius * angle.cos(), radius * angle.sin()];
            let (start, end, step) = (on(from), on(from + turn * sweep), radius * lambda);
            for method in METHODS {
                let points: Vec<_> =
                    Arc::new(start, end, direction, method, step).unwrap().collect();
                prop_assert_eq!(points.last(), Some(&end));
                let expected = sweep / step_angle(step, radius);
                let count = points.len() as f64;
                prop_assert!(
                    (expected / (1.0 + lambda) - 1e-6..expected * (1.0 + lambda) + 1.0).contains(&count),
                    "{:?}: {} points for {}", method, count, expected
                );
                let (mut last, mut swept) = (start, 0.0);
                for (k, &point) in points.iter().enumerate() {
                    let off = (point[0].hypot(point[1]) / radius - 1.0).abs();
                    prop_assert!(off <= radius_bound(method, lambda, k + 1), "{:?} {}: {}", method, k, off);
                    let chord = (point[0] - last[0]).hypot(point[1] - last[1]);
                    let most = step * (1.0 + stretch(method) * lambda + 1e-9);
                    prop_assert!(chord <= most, "{:?} {}: {} of {}", method, k, chord / step, lambda);
                    let advance = angle(last, point) * turn;
                    prop_assert!(advance > 0.0);
                    swept += advance;
                    last = point;
                }
                prop_assert!((swept - sweep).abs() < 1e-9);
            }
        }

        #[test]
        fn full_turns_come_back(radius in 0.1..1000.0, from in 0.0..TAU, lambda in 0.001..0.25) {
            let start: [f64; 2] = [radius * from.cos(), radius * from.sin()];
            for method in METHODS {
                let points = Arc::new(start, start, Direction::Ccw, method, radius * lambda).unwrap();
                let count = points.count() as f64;
                prop_assert!(count > TAU / lambda * 0.9);
                prop_assert_eq!(points.last(), Some(start));
            }
        }

        #[test]
        fn no_chord_error_exceeds_the_tolerance(
            radius in 0.1..1000.0,
            from in 0.0..TAU,
            lambda in 0.001..0.25,
            share in 1e-7..0.02,
        ) {
            let start: [f64; 2] = [radius * from.cos(), radius * from.sin()];
            let end = turned(start, 2.0);
            let tolerance = radius * share;
            for method in METHODS {
                let arc = Arc::new(start, end, Direction::Ccw, method, radius * lambda).unwrap();
                let arc = arc.within(tolerance).unwrap();
                prop_assert!(arc.step() <= radius * lambda);
                let mut last = start;
                for point in arc {
                    let chord = (point[0] - last[0]).hypot(point[1] - last[1]);
                    // From geometry: what the middle of the chord lacks to the radius, but for what the
                    // extended integration adds to that itself.
                    let to_chord: f64 = radius * radius - chord * chord / 4.0;
                    prop_assert!(radius - to_chord.sqrt()
                        <= tolerance * (1.0 + 1e-6) + 1e-12 * radius, "{:?}", method);
                    last = point;
                }
                prop_assert_eq!(last, end);
            }
            let arc = Arc::new(start, end, Direction::Ccw, METHODS[0], radius * lambda).unwrap();
            prop_assert_eq!(arc.within(0.0).unwrap_err(), SamplingError::NoStep);
        }

        /// Two neighbours on the circle: the point in the middle of their chord is the chord error
        /// away from it.
        #[test]
        fn the_chord_error_is_that_of_the_points(radius in 0.1..1000.0, lambda in 0.01..0.25) {
            let arc = Arc::new(
                [radius, 0.0], [0.0, radius], Direction::Ccw, ArcMethod::SecondOrder, radius * lambda,
            ).unwrap();
            let mut last = [radius, 0.0];
            for point in arc {
                let chord = (point[0] - last[0]).hypot(point[1] - last[1]);
                let middle = (point[0] + last[0]).hypot(point[1] + last[1]) / 2.0;
                prop_assert!((radius - middle - chord_error(radius, chord)).abs() < 1e-9 * radius);
                last = point;
            }
        }
    }
}
