//! Ramps: what they emit, against the limits.

use onepulse_core::Error;
use onepulse_core::ramp::{Limits, Trapezoid};
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
    }
    let wide = Limits { bits: 32, ..good };
    assert_eq!(Trapezoid::new(5, wide), Err(Error::RegisterWidth { digits: 32, widest: 31 }));
}
