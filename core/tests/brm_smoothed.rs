//! The smoothed rate multiplier against the plain one's trains and against the line.
#![allow(clippy::unwrap_used)]

use onepulse_core::dda::Register;
use onepulse_core::{Error, brm};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// Pulses of a plain multiplier of n stages in its first c clocks, periods repeated: the stage of weight
/// 2^(n−1−t) passes the clocks that end in 10…0 with t zeros.
fn train(value: u64, bits: u32, clocks: u64) -> u64 {
    (0..bits)
        .filter(|t| value >> (bits - 1 - t) & 1 == 1)
        .map(|t| (1..=clocks).filter(|clock| clock.trailing_zeros() == t).count() as u64)
        .sum()
}

/// |pulses·2^(n+k) − value·clock| of one axis over a whole line, the largest.
fn largest_error(value: i32, bits: u32, smoothing: u32) -> u64 {
    let line = brm::Smoothed::new([value], bits, smoothing).unwrap();
    let clocks = 1_u64 << (bits + smoothing);
    let mut made = 0;
    let mut largest = 0;
    for (clock, pulse) in (1..).zip(line) {
        made += u64::from(pulse.0[0] == 1);
        largest = largest.max((made * clocks).abs_diff(value as u64 * clock));
    }
    largest
}

#[test]
fn without_smoothing_it_is_the_plain_multiplier() {
    for bits in 1..=6 {
        for x in -(1 << bits) + 1..1 << bits {
            for y in 0..1 << bits {
                let smoothed = brm::Smoothed::new([x, y], bits, 0).unwrap();
                assert!(smoothed.eq(brm::Line::new([x, y], bits).unwrap()));
            }
        }
    }
}

#[test]
fn by_hand() {
    // n = 2, k = 1, values 3 and 1: trains 1 2 3 5 6 7 and 2 6; the divider, at 1, passes every other
    // pulse from the first on.
    let line = brm::Smoothed::new([3, -1], 2, 1).unwrap();
    let clocks = |axis: usize, sign| {
        (1..).zip(line).filter(move |(_, pulse)| pulse.0[axis] == sign).map(|(clock, _)| clock)
    };
    assert!(clocks(0, 1).eq([1, 3, 6]));
    assert!(clocks(1, -1).eq([2]));
}

#[test]
fn every_narrow_line_divides_its_trains() {
    for bits in 1..=5 {
        for smoothing in 0..=4 {
            for value in 0..1 << bits {
                let mut line = brm::Smoothed::new([value], bits, smoothing).unwrap();
                assert_eq!(line.remaining(), 1 << (bits + smoothing));
                let period = train(value as u64, bits, 1 << bits);
                assert_eq!(period, value as u64);
                for clock in 1..=1_u64 << (bits + smoothing) {
                    let made = (clock >> bits) * period
                        + train(value as u64, bits, clock & ((1 << bits) - 1));
                    assert!(line.step().is_some());
                    let due = (made + (1 << smoothing >> 1)) >> smoothing;
                    assert_eq!(line.position()[0] as u64, due);
                }
                assert_eq!((line.step(), line.residual()), (None, [0]));
            }
        }
    }
}

#[test]
fn an_axis_is_off_by_the_plain_error_divided_and_a_half() {
    for bits in 1..=7 {
        for smoothing in 1..=4 {
            for value in 0..1 << bits {
                // In units of 2^-(n+k) pulses: D is plain/2ⁿ pulses.
                let plain = largest_error(value, bits, 0);
                let smoothed = largest_error(value, bits, smoothing);
                let bound = plain + (1 << (bits + smoothing - 1));
                assert!(smoothed <= bound, "{value} {bits} {smoothing}");
            }
        }
    }
    // One stage that passes every other clock is off by ½; then, with k = 1, the first of four clocks makes
    // the pulse that is due for a quarter: ½/2 + ½.
    assert_eq!((largest_error(1, 1, 0), largest_error(1, 1, 1)), (1, 3));
}

/// The largest distance from the line to (x, y) of the points of a run, in pulses.
fn distance([x, y]: [i32; 2], bits: u32, smoothing: u32) -> f64 {
    let length = f64::from(x).hypot(f64::from(y));
    let mut point = [0, 0];
    let mut largest = 0;
    for pulse in brm::Smoothed::new([x, y], bits, smoothing).unwrap() {
        point = [point[0] + i64::from(pulse.0[0]), point[1] + i64::from(pulse.0[1])];
        largest = largest.max((point[0] * i64::from(y) - point[1] * i64::from(x)).abs());
    }
    if length == 0.0 { 0.0 } else { largest as f64 / length }
}

#[test]
fn a_plane_line_is_off_by_the_plain_distance_divided_and_less_than_a_pulse() {
    let half_diagonal = 0.5_f64.sqrt();
    for smoothing in 1..=3 {
        for x in 0..64 {
            for y in 0..64 {
                let bound = distance([x, y], 6, 0) / f64::from(1 << smoothing) + half_diagonal;
                assert!(distance([x, y], 6, smoothing) <= bound + 1e-9);
            }
        }
    }
}

#[test]
fn what_smoothing_buys_on_the_most_uneven_line() {
    // x = 1010101010b, y = x/2: 10·√5/10 pulses without it.
    let end = [682, 341];
    let found = [0, 1, 2, 3, 4].map(|k| (1000.0 * distance(end, 10, k)).round() as i32);
    println!("smoothing 0 to 4: {found:?} thousandths of a pulse");
    assert_eq!(found, [2236, 1342, 894, 894, 447]);
}

#[test]
fn what_does_not_fit_is_refused() {
    let new = |end, bits, smoothing| brm::Smoothed::new([end, 0], bits, smoothing).err();
    let narrow = |digits, needed| Some(Error::RegisterTooNarrow { digits, needed });
    assert_eq!(new(16, 4, 3), narrow(4, 5));
    assert_eq!(new(15, 4, 3), None);
    assert_eq!(new(15, 4, 28), None);
    let width = |digits| Some(Error::RegisterWidth { digits, widest: 32 });
    assert_eq!(new(15, 4, 29), width(33));
    assert_eq!(new(15, 32, u32::MAX), width(u32::MAX));
    assert_eq!(new(0, 0, 3), width(0));
    assert_eq!(new(i32::MIN, 31, 1), narrow(31, 32));
    assert_eq!(new(i32::MIN, 32, 0), None);
}

proptest! {
    #![proptest_config(ProptestConfig {
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0xb4a),
        ..ProptestConfig::with_cases(2000)
    })]

    #[test]
    fn lines_of_three_axes(end in any::<[i32; 3]>(), shift in 0..32_u32, smoothing in 0..12_u32) {
        let end = end.map(|c| c >> shift);
        let largest = end.iter().fold(0, |most, c| c.unsigned_abs().max(most));
        let bits = Register::holding(onepulse_core::dda::Radix::Binary, largest).digits();
        prop_assume!(bits + smoothing <= 32);
        let mut line = brm::Smoothed::new(end, bits, smoothing).unwrap();
        for clock in 1..=500_u64.min(line.remaining()) {
            line.step();
            for axis in 0..3 {
                let value = u64::from(end[axis].unsigned_abs());
                // Of the clocks so far, those with t zeros at the end.
                let made: u64 = (0..bits)
                    .filter(|t| value >> (bits - 1 - t) & 1 == 1)
                    .map(|t| (clock + (1 << t)) >> (t + 1))
                    .sum();
                let due = ((made + (1 << smoothing >> 1)) >> smoothing) as i64;
                prop_assert_eq!(line.position()[axis], due * i64::from(end[axis].signum()));
            }
        }
        if line.remaining() < 1 << 16 {
            while line.step().is_some() {}
            prop_assert_eq!(line.position(), end.map(i64::from));
        }
    }
}
