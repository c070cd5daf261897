//! Lines in space by point-by-point comparison, against their layers and against the distance from the line.
#![allow(clippy::unwrap_used)]

use onepulse_core::{EndRule, Pulse, ppc};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

fn points<const N: usize>(
    pulses: impl Iterator<Item = Pulse<N>>,
) -> impl Iterator<Item = [i64; N]> {
    pulses.scan([0; N], |point, pulse| {
        for axis in 0..N {
            point[axis] += i64::from(pulse.0[axis]);
        }
        Some(*point)
    })
}

/// |p × e|² and |e|²: the square of the distance from the line to e is their quotient. In any number
/// of axes, by Lagrange's identity.
fn distance_squared<const N: usize>(point: [i64; N], end: [i64; N]) -> (i128, i128) {
    let (mut cross, mut length) = (0, 0);
    for i in 0..N {
        length += i128::from(end[i]).pow(2);
        for j in 0..i {
            let turn = i128::from(point[i]) * i128::from(end[j])
                - i128::from(point[j]) * i128::from(end[i]);
            cross += turn * turn;
        }
    }
    (cross, length)
}

/// The path by layers of the longest axis: after its m-th pulse each other axis is brought up to
/// ⌈e_i·m/e_M⌉, those that lack most first.
fn by_layers<const N: usize>(end: [i32; N]) -> impl Iterator<Item = [i64; N]> {
    let size = end.map(|c| i128::from(c).abs());
    let longest = size.iter().copied().max().unwrap();
    let leader = size.iter().position(|c| *c == longest).unwrap();
    let signs = end.map(|c| i64::from(c.signum()));
    let mut point = [0_i64; N];
    let layers = (1..=longest).flat_map(move |m| {
        // How far each is behind, times −e_M, once the longest axis has gone ahead.
        let mut due: Vec<(i128, usize)> = (0..N)
            .map(|axis| {
                let steps = (size[axis] * (m - 1) + longest - 1) / longest;
                (longest * steps - size[axis] * m, axis)
            })
            .filter(|(off, axis)| *off < 0 && *axis != leader)
            .collect();
        due.sort_unstable();
        std::iter::once(leader).chain(due.into_iter().map(|(_, axis)| axis))
    });
    layers.map(move |axis| {
        point[axis] += signs[axis];
        point
    })
}

#[test]
fn by_hand() {
    // Levels (x, z) after y: −1, −2; z +1; x +2; and so on.
    let path: Vec<_> = points(ppc::SpaceLine::new([1, -3, 2]).unwrap()).collect();
    assert_eq!(path, [[0, -1, 0], [0, -1, 1], [1, -1, 1], [1, -2, 1], [1, -2, 2], [1, -3, 2]]);
}

#[test]
fn every_small_line_of_three_axes() {
    let mut farthest = (0.0, [0; 3]);
    for end in (0..=12).flat_map(|x| (0..=12).flat_map(move |y| (0..=12).map(move |z| [x, y, z]))) {
        let mut line = ppc::SpaceLine::new(end).unwrap();
        assert_eq!(line.remaining(), end.iter().sum::<i32>() as u64);
        let longest = i64::from(*end.iter().max().unwrap());
        let to = end.map(i64::from);
        let leader = line.leader();
        assert_eq!(to[leader], longest);
        let path: Vec<_> = points(line.by_ref()).collect();
        assert_eq!(path.len() as i64, to.iter().sum::<i64>());
        assert!(path.iter().copied().eq(by_layers(end)), "{end:?}");
        assert_eq!((line.residual(), line.position()), ([0; 3], to));
        for point in path {
            for axis in 0..3 {
                let off = longest * point[axis] - to[axis] * point[leader];
                assert!(off.abs() <= longest);
            }
            let (cross, length) = distance_squared(point, to);
            assert!(cross < 2 * length, "{end:?} {point:?}");
            let distance = (cross as f64 / length as f64).sqrt();
            if distance > farthest.0 {
                farthest = (distance, end);
            }
        }
    }
    println!("three axes, ends up to 12: {} at most, on the line to {:?}", farthest.0, farthest.1);
    assert!((farthest.0 - (2.0 * 121.0 / 146.0_f64).sqrt()).abs() < 1e-9);
}

#[test]
fn the_bound_in_space_is_approached() {
    let farthest = |n: i32| {
        let end = [1, 1, n];
        let squares = points(ppc::SpaceLine::new(end).unwrap())
            .map(|point| distance_squared(point, end.map(i64::from)));
        squares.map(|(cross, length)| cross as f64 / length as f64).fold(0.0, f64::max).sqrt()
    };
    // (1, 1, 1) from the line to (1, 1, n): |(n − 1, 1 − n, 0)|² = 2(n − 1)², over n² + 2.
    assert!((farthest(7) - (72.0 / 51.0_f64).sqrt()).abs() < 1e-12);
    assert!(farthest(1000) > 1.41 && farthest(1000) < 2.0_f64.sqrt());
}

#[test]
fn two_axes_with_x_leading_are_the_plane_line() {
    for end in (-20..=20).flat_map(|x: i32| (-x.abs()..=x.abs()).map(move |y| [x, y])) {
        let line = ppc::SpaceLine::new(end).unwrap();
        assert!(line.eq(ppc::Line::new(end, EndRule::Total).unwrap()), "{end:?}");
    }
}

#[test]
fn every_octant_by_symmetry() {
    for end in [[3, 5, 7], [7, 5, 3], [4, 4, 4], [0, 6, 5], [9, 0, 0], [0, 0, 0]] {
        let first: Vec<_> = ppc::SpaceLine::new(end).unwrap().collect();
        for octant in 0..8 {
            let sign = [0, 1, 2].map(|axis| if octant >> axis & 1 == 1 { -1 } else { 1 });
            let other = ppc::SpaceLine::new([0, 1, 2].map(|axis| end[axis] * sign[axis])).unwrap();
            let turned = |pulse: &Pulse<3>| Pulse([0, 1, 2].map(|i| pulse.0[i] * sign[i] as i8));
            assert!(first.iter().map(turned).eq(other));
        }
    }
}

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        3 => any::<i32>(),
        3 => -800..=800,
        1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX]),
    ]
}

const STEPS: usize = 1000;

proptest! {
    #![proptest_config(ProptestConfig {
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0x5_9ace),
        ..ProptestConfig::with_cases(2000)
    })]

    #[test]
    fn lines_of_three_axes(end in [coordinate(), coordinate(), coordinate()]) {
        let to = end.map(i64::from);
        let mut line = ppc::SpaceLine::new(end).unwrap();
        let total = line.remaining();
        prop_assert_eq!(total, to.iter().map(|c| c.unsigned_abs()).sum::<u64>());
        let walked: Vec<_> = points(line.by_ref().take(STEPS)).collect();
        prop_assert!(walked.iter().copied().eq(by_layers(end).take(STEPS)));
        for point in walked {
            let (cross, length) = distance_squared(point, to);
            prop_assert!(cross < 2 * length);
        }
        if total <= STEPS as u64 {
            prop_assert_eq!((line.step(), line.position(), line.residual()), (None, to, [0; 3]));
        }
    }

    #[test]
    fn lines_of_five_axes(end in [-300..=300, -300..=300, -300..=300, -300..=300, -300..=300]) {
        let to = end.map(i64::from);
        let mut line = ppc::SpaceLine::new(end).unwrap();
        let walked: Vec<_> = points(line.by_ref()).collect();
        prop_assert!(walked.iter().copied().eq(by_layers(end)));
        for point in walked {
            let (cross, length) = distance_squared(point, to);
            prop_assert!(cross < 4 * length);
        }
        prop_assert_eq!((line.position(), line.residual()), (to, [0; 5]));
    }
}
