//! Ramps within their limits, judged by nothing but the clocks of their pulses.
//!
//! After the clock t of pulse i, the axis has moved i pulses and what the phase register holds, which
//! is less than a clock's way, since the carry has just come. So the way P(t) is known but for an error
//! from 0 up to the largest speed; before the first clock and after the last, it is known. A divided
//! difference of a function of whole numbers is a mean of those over neighbours (discrete B-splines
//! are not negative), so that over any times
//!
//! * P\[t0, t1, t2\] is at most half of the largest |P(t + 1) − 2P(t) + P(t − 1)|, the acceleration, and
//! * P\[t0, t1, t2, t3\] at most a sixth of the largest third difference, the jerk.
//!
//! An error from 0 to E adds at most E times the sum of the divided difference's positive weights.
//! Multiplied by all denominators, these are inequalities of whole numbers.
#![allow(clippy::unwrap_used)]

use onepulse_core::ramp::{Limits, SCurve, Trapezoid};
use proptest::prelude::*;

/// An axis seen at its pulses and while it stands.
#[derive(Clone, Debug)]
struct Seen {
    /// Clocks and pulses made by then, in order.
    points: Vec<[i128; 2]>,
    /// The clock of the last pulse.
    end: i128,
    clocks: u64,
    /// The way of a pulse.
    pulse: i128,
    /// What a clock moves at most.
    largest: i128,
}

/// Runs a ramp whose phase register has so many bits.
fn seen(ramp: impl Iterator<Item = bool>, bits: u32, largest: u64) -> Seen {
    let mut points = vec![[0, 0]];
    let mut clocks = 0;
    for pulse in ramp {
        clocks += 1;
        if pulse {
            points.push([i128::from(clocks), points.len() as i128]);
        }
    }
    let [end, _] = points[points.len() - 1];
    Seen { points, end, clocks, pulse: 1 << bits, largest: i128::from(largest) }
}

fn trapezoid(pulses: u32, limits: Limits) -> Seen {
    let ramp = Trapezoid::new(pulses, limits).unwrap();
    seen(ramp, limits.bits, u64::from(limits.largest))
}

fn s_curve<const WINDOW: usize>(pulses: u32, limits: Limits) -> Seen {
    let ramp = SCurve::<WINDOW>::new(pulses, limits).unwrap();
    let bits = limits.bits + WINDOW.trailing_zeros();
    seen(ramp, bits, u64::from(limits.largest) * WINDOW as u64)
}

impl Seen {
    /// In units of so many to one of before.
    fn in_parts_of(self, parts: i128) -> Self {
        Self { pulse: parts * self.pulse, largest: parts * self.largest, ..self }
    }

    fn pulses(&self) -> usize {
        self.points.len() - 1
    }

    fn shortest_interval(&self) -> Option<i128> {
        self.points[1..].windows(2).map(|pair| pair[1][0] - pair[0][0]).min()
    }

    /// Every so many pulses, as far apart before the start and after the end as beside it.
    fn every(&self, pulses: usize) -> Vec<[i128; 2]> {
        let mut points: Vec<_> = self.points.iter().step_by(pulses).copied().collect();
        let last = [self.end, self.pulses() as i128];
        if points.last() != Some(&last) {
            points.push(last);
        }
        let first = points[1][0];
        let end = self.end - points[points.len() - 2][0];
        let before = (1..=3).rev().map(|i| [-i * first, 0]);
        let after = (1..=3).map(|i| [self.end + i * end, last[1]]);
        before.chain(points).chain(after).collect()
    }

    /// The spans that are looked at, in pulses.
    fn spans(&self) -> impl Iterator<Item = usize> {
        let most = self.pulses();
        (0..).map(|i| 1 << i).take_while(move |span| *span <= most)
    }

    /// Whether these points may be of a motion with this acceleration at most.
    fn accelerates(&self, points: &[[i128; 2]], most: i128) -> bool {
        points.windows(3).all(|points| {
            let [[a, p], [b, q]] = [0, 1].map(|i| apart(points[i], points[i + 1]));
            let difference = self.pulse * (q * a - p * b).abs();
            2 * difference < (a + b) * (most * a * b + 2 * self.largest)
        })
    }

    /// Whether this acceleration is kept from standstill to standstill.
    fn keeps_acceleration(&self, most: u64) -> bool {
        self.spans().all(|span| self.accelerates(&self.every(span), i128::from(most)))
    }

    /// Whether it is kept between the start and the last pulse.
    fn keeps_acceleration_on_the_way(&self, most: u64) -> bool {
        self.spans().all(|span| {
            let points: Vec<_> =
                self.points[..self.pulses()].iter().step_by(span).copied().collect();
            self.accelerates(&points, i128::from(most))
        })
    }

    /// Whether this jerk is kept from standstill to standstill.
    fn keeps_jerk(&self, most: u64) -> bool {
        self.spans().all(|span| {
            // Longer ones do not fit the products.
            let points = self.every(span);
            points.windows(4).filter(|points| points[3][0] - points[0][0] < 1 << 18).all(|points| {
                let [[a, p], [b, q], [c, r]] = [0, 1, 2].map(|i| apart(points[i], points[i + 1]));
                let [ab, bc, abc] = [a + b, b + c, a + b + c];
                let difference = (r * b - q * c) * a * ab - (q * a - p * b) * c * bc;
                let error = a * b * ab + c * ab * abc;
                let product = a * b * c * ab * bc * abc;
                6 * self.pulse * difference.abs()
                    < i128::from(most) * product + 6 * self.largest * error
            })
        })
    }
}

/// From one point to the next.
fn apart(from: [i128; 2], to: [i128; 2]) -> [i128; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

/// The bounds of an S-curve, in units of 2⁻ⁿ/WINDOW pulses.
fn bounds(limits: Limits, window: u64) -> [u64; 2] {
    let [start, a] = [limits.start, limits.acceleration].map(u64::from);
    [window * a + start.saturating_sub(a), 2 * start.max(a)]
}

/// Limits with 3200 clocks a pulse at most.
fn limits() -> impl Strategy<Value = Limits> {
    (6..=20_u32).prop_flat_map(|bits| {
        let most: u32 = (1 << bits) - 1;
        (most.div_ceil(100)..=most, 0..=5_u32, 1..=most, 0..=12_u32).prop_map(
            move |(largest, slower, acceleration, gentler)| Limits {
                bits,
                start: (largest >> slower).max(1),
                acceleration: (acceleration.min(largest) >> gentler).max(1),
                largest,
            },
        )
    })
}

fn check_s_curve<const WINDOW: usize>(pulses: u32, limits: Limits) -> Result<(), TestCaseError> {
    let ramp = s_curve::<WINDOW>(pulses, limits);
    prop_assert_eq!(ramp.pulses(), pulses as usize);
    let clocks = Trapezoid::new(pulses, limits).unwrap().count() as u64;
    let more = if pulses == 0 { 0 } else { WINDOW as u64 - 1 };
    prop_assert_eq!(ramp.clocks, clocks + more);
    // The last clock has a pulse.
    prop_assert_eq!(ramp.end, i128::from(ramp.clocks));
    let least = i128::from((1_u32 << limits.bits) / limits.largest);
    prop_assert!(ramp.shortest_interval().is_none_or(|interval| interval >= least));
    let [acceleration, jerk] = bounds(limits, WINDOW as u64);
    prop_assert!(ramp.keeps_acceleration(acceleration));
    prop_assert!(ramp.keeps_jerk(jerk));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1000) })]

    #[test]
    fn s_curves_keep_their_limits(pulses in 0..600_u32, limits in limits()) {
        check_s_curve::<2>(pulses, limits)?;
        check_s_curve::<16>(pulses, limits)?;
        check_s_curve::<256>(pulses, limits)?;
    }

    #[test]
    fn trapezoids_keep_their_limits(pulses in 0..600_u32, limits in limits()) {
        let ramp = trapezoid(pulses, limits);
        let Limits { bits, start, acceleration, largest } = limits;
        prop_assert_eq!(ramp.pulses(), pulses as usize);
        prop_assert_eq!(ramp.end, i128::from(ramp.clocks));
        let least = i128::from((1_u32 << bits) / largest);
        prop_assert!(ramp.shortest_interval().is_none_or(|interval| interval >= least));
        // It jumps by the start speed at both ends.
        prop_assert!(ramp.keeps_acceleration(u64::from(acceleration.max(start))));
    }
}

/// Ramps of 8192 clocks, up to a pulse every 8.
const LONG: Limits = Limits { bits: 18, start: 4, acceleration: 4, largest: 1 << 15 };
const A: u64 = LONG.acceleration as u64;

#[test]
fn a_ramp_of_twice_the_acceleration_is_seen() {
    let hasty = Limits { acceleration: 2 * LONG.acceleration, ..LONG };
    for pulses in [40, 300, 2000] {
        assert!(trapezoid(pulses, LONG).keeps_acceleration(A));
        assert!(!trapezoid(pulses, hasty).keeps_acceleration(A));
        assert!(s_curve::<512>(pulses, LONG).keeps_acceleration(512 * A));
        assert!(!s_curve::<512>(pulses, hasty).keeps_acceleration(512 * A));
    }
    // By a quarter too, where there is the way for it.
    let hasty = Limits { acceleration: LONG.acceleration * 5 / 4, ..LONG };
    assert!(!trapezoid(2000, hasty).keeps_acceleration(A));
    assert!(!s_curve::<512>(2000, hasty).keeps_acceleration(512 * A));
}

#[test]
fn a_trapezoid_is_seen_to_jerk() {
    for pulses in [300, 1000, 2000] {
        assert!(!trapezoid(pulses, LONG).in_parts_of(4096).keeps_jerk(2 * A));
        assert!(s_curve::<4096>(pulses, LONG).keeps_jerk(2 * A));
    }
}

/// Half the jerk where the ramps are apart; a window of half the clocks has twice that.
#[test]
fn a_shorter_window_is_seen_to_jerk() {
    assert!(s_curve::<8192>(3000, LONG).keeps_jerk(A));
    assert!(s_curve::<4096>(3000, LONG).keeps_jerk(A));
    assert!(!s_curve::<4096>(3000, LONG).in_parts_of(2).keeps_jerk(A));
}

/// A start speed above the acceleration: the trapezoid jumps by it, the S-curve by a WINDOW-th.
#[test]
fn a_start_speed_is_spread_over_the_window() {
    let limits = Limits { start: 1 << 14, ..LONG };
    let [acceleration, jerk] = bounds(limits, 2048);
    assert_eq!([acceleration, jerk], [2048 * A + (1 << 14) - A, 2 << 14]);
    let ramp = s_curve::<2048>(2000, limits);
    assert!(ramp.keeps_acceleration(acceleration) && ramp.keeps_jerk(jerk));
    assert!(!ramp.keeps_acceleration(2048 * A));
    assert!(!ramp.keeps_jerk(2 * A));
    assert!(!trapezoid(2000, limits).keeps_acceleration(A));
    assert!(trapezoid(2000, limits).keeps_acceleration_on_the_way(A));
}
