//! Ramps: what they emit, against the limits.
#![allow(clippy::unwrap_used)]

use onepulse_core::Error;
use onepulse_core::ramp::{Limits, SCurve, Trapezoid};
use proptest::prelude::*;

fn limits() -> impl Strategy<Value = Limits> {
    (4..=20_u32).prop_flat_map(|bits: u32| {
        let most: u32 = (1 << bits) - 1;
        (Just(bits), 1..=most, 1..=most, 1..=most).prop_map(|(bits, a, b, acceleration)| Limits {
            bits,
            start: a.min(b),
            acceleration: acceleration.min(a.max(b) / 3 + 1),
            largest: a.max(b),
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn pulses_are_exact_and_limits_kept(pulses in 0..400_u32, limits in limits()) {
        let mut ramp = Trapezoid::new(pulses, limits).unwrap();
        let Limits { bits, start, acceleration, largest } = limits;
        let (mut made, mut clock, mut last) = (0_u32, 0_u64, None);
        // In units of 2⁻ⁿ pulses, from the way itself.
        let (mut left, mut way_before) = (ramp.left(), 0_u64);
        while let Some(pulse) = ramp.step() {
            clock += 1;
            let way = left - ramp.left();
            left = ramp.left();
            prop_assert!(way > 0 && way <= u64::from(largest));
            let is_end = left == 0 && way < u64::from(start);
            // Up or down by the acceleration, or by the start speed at both ends.
            let change = way.abs_diff(way_before);
            let may = if way_before == 0 { u64::from(start) } else { u64::from(acceleration) };
            prop_assert!(change <= may || is_end && way_before <= u64::from(start + acceleration), "{} {}", way_before, way);
            way_before = way;
            if pulse {
                made += 1;
                // No interval below that of the largest speed.
                if let Some(last) = last {
                    prop_assert!(clock - last >= (1 << bits) / u64::from(largest));
                }
                last = Some(clock);
            }
        }
        prop_assert_eq!(made, pulses);
        prop_assert_eq!(ramp.phase(), 0);
        // From the last clock it stops at once.
        prop_assert!(way_before <= u64::from(start));
    }
}

/// A long way: up for as many clocks as down, the largest speed in between, and no longer than the
/// trapezoid's own formula asks for.
#[test]
fn a_long_way_is_a_trapezoid() {
    let limits = Limits { bits: 16, start: 100, acceleration: 50, largest: 10_000 };
    let mut ramp = Trapezoid::new(1000, limits).unwrap();
    let mut speeds = vec![];
    let mut left = ramp.left();
    while ramp.step().is_some() {
        speeds.push(left - ramp.left());
        left = ramp.left();
    }
    let up = (10_000 - 100) / 50;
    assert!((0..=up).all(|k| speeds[k as usize] == 100 + 50 * k));
    let at_most = speeds.iter().filter(|speed| **speed == 10_000).count() as u64;
    // Both slopes cover 2·Σ(100 + 50·k), k < up; the rest is at the largest speed, but for what is
    // left over, which takes a clock at each of some lower speeds at most.
    let slopes = 2 * (100 * up + 50 * up * (up - 1) / 2);
    assert_eq!(at_most, ((1000 << 16) - slopes) / 10_000);
    let clocks = speeds.len() as u64;
    assert!((2 * up + at_most..=2 * up + at_most + 2).contains(&clocks), "{clocks}");
}

#[test]
fn too_short_to_reach_the_speed() {
    let limits = Limits { bits: 16, start: 100, acceleration: 50, largest: 10_000 };
    for pulses in 0..60 {
        let ramp = Trapezoid::new(pulses, limits).unwrap();
        assert_eq!(ramp.filter(|pulse| *pulse).count(), pulses as usize);
    }
}

/// What an S-curve does on each clock, against the means of the trapezoid's ways. With half the
/// jerk where the trapezoid's ramps are apart; returns whether they are.
fn check_s_curve<const WINDOW: usize>(pulses: u32, limits: Limits) -> bool {
    let Limits { start, acceleration, largest, .. } = limits;
    let mut trapezoid = Trapezoid::new(pulses, limits).unwrap();
    let (mut ways, mut left) = (vec![0; WINDOW + 1], trapezoid.left());
    while trapezoid.step().is_some() {
        ways.push(left - trapezoid.left());
        left = trapezoid.left();
    }
    ways.resize(ways.len() + WINDOW, 0);
    let rises = ways.windows(2).rposition(|pair| pair[0] < pair[1]);
    let falls = ways.windows(2).position(|pair| pair[0] > pair[1]);
    let is_apart = rises.zip(falls).is_some_and(|(rise, fall)| fall > rise + WINDOW);
    let [start, a] = [start, acceleration].map(i64::from);
    let jerk = if is_apart { start.max(a) } else { 2 * start.max(a) };

    let mut ramp = SCurve::<WINDOW>::new(pulses, limits).unwrap();
    let unit = u64::from(pulses) << (limits.bits + WINDOW.trailing_zeros());
    let (mut moved, mut made, mut sums) = (0, 0, [0; 3]);
    for latest in ways.windows(WINDOW).skip(2) {
        let sum: u64 = latest.iter().sum();
        if sum > 0 {
            made += u32::from(ramp.step().unwrap());
            moved += sum;
            assert_eq!(u64::from(ramp.moved()), sum);
            assert_eq!(ramp.to_come(), unit - moved);
            assert!(ramp.invariant());
        }
        assert!(sum <= u64::from(largest) * WINDOW as u64);
        sums = [sums[1], sums[2], sum as i64];
        let [before, change] = [sums[1] - sums[0], sums[2] - sums[1]];
        assert!(change.abs() <= WINDOW as i64 * a + (start - a).max(0));
        assert!((change - before).abs() <= jerk);
    }
    assert!(ramp.is_done() && ramp.step().is_none());
    assert_eq!((made, ramp.pulses(), ramp.phase(), moved), (pulses, pulses, 0, unit));
    is_apart
}

/// All limits of up to 4 bits, with blocks too short to reach the speed and long enough.
#[test]
fn every_small_ramp_makes_its_pulses() {
    let (mut apart, mut together) = (0, 0);
    for bits in 1..=4 {
        for largest in 1..1_u32 << bits {
            for [start, acceleration] in pairs(largest) {
                let limits = Limits { bits, start, acceleration, largest };
                for pulses in 0..=12 {
                    let ramp = Trapezoid::new(pulses, limits).unwrap();
                    assert_eq!(ramp.filter(|pulse| *pulse).count(), pulses as usize);
                    let is_apart = [
                        check_s_curve::<2>(pulses, limits),
                        check_s_curve::<4>(pulses, limits),
                        check_s_curve::<32>(pulses, limits),
                    ];
                    apart += is_apart.iter().filter(|is_apart| **is_apart).count();
                    together += is_apart.iter().filter(|is_apart| !**is_apart).count();
                }
            }
        }
    }
    assert!(apart > 1000 && together > 1000, "{apart} {together}");
}

/// All pairs of 1 up to the largest.
fn pairs(largest: u32) -> impl Iterator<Item = [u32; 2]> {
    (1..=largest).flat_map(move |a| (1..=largest).map(move |b| [a, b]))
}

/// Both bounds of the S-curve are reached, so that no smaller ones hold.
#[test]
fn the_bounds_of_an_s_curve_are_reached() {
    let reached = |pulses: u32, limits| {
        let mut ramp = SCurve::<4>::new(pulses, limits).unwrap();
        let mut sums = vec![0, 0, 0];
        while ramp.step().is_some() {
            sums.push(i64::from(ramp.moved()));
        }
        sums.extend([0, 0]);
        let changes: Vec<i64> = sums.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let jerks = changes.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        (changes.iter().map(|change| change.abs()).max(), jerks.max())
    };
    // Up to the largest speed and down again: 1 + 2 + … + 15 + … + 1 units, 15 pulses with 15 of them.
    let gentle = Limits { bits: 4, start: 1, acceleration: 1, largest: 15 };
    assert_eq!(reached(15, gentle), (Some(4), Some(2)));
    // A pulse of four clocks at the start speed, which the trapezoid jumps to and from.
    let jumping = Limits { bits: 4, start: 4, acceleration: 1, largest: 4 };
    assert_eq!(reached(1, jumping), (Some(4), Some(8)));
    let jumping = Limits { bits: 4, start: 6, acceleration: 1, largest: 12 };
    assert_eq!(reached(30, jumping), (Some(4 + 5), Some(6)));
}

#[test]
fn limits_out_of_range_are_refused() {
    let good = Limits { bits: 8, start: 16, acceleration: 4, largest: 128 };
    for bad in [
        Limits { start: 0, ..good },
        Limits { acceleration: 0, ..good },
        Limits { acceleration: 129, ..good },
        Limits { largest: 15, ..good },
        Limits { largest: 256, ..good },
    ] {
        assert_eq!(Trapezoid::new(5, bad), Err(Error::RampLimits), "{bad:?}");
        assert_eq!(SCurve::<2>::new(5, bad), Err(Error::RampLimits), "{bad:?}");
    }
    let wide = Limits { bits: 32, ..good };
    assert_eq!(Trapezoid::new(5, wide), Err(Error::RegisterWidth { digits: 32, widest: 31 }));
    assert_eq!(SCurve::<2>::new(5, wide), Err(Error::RegisterWidth { digits: 32, widest: 31 }));
    // The window's bits count too.
    let limits = Limits { bits: 21, ..good };
    assert!(SCurve::<1024>::new(5, limits).is_ok());
    let refused = SCurve::<2048>::new(5, limits);
    assert_eq!(refused, Err(Error::RegisterWidth { digits: 32, widest: 31 }));
}
