//! Parabolas against their geometry: distances in whole numbers, candidates by brute force, sums in closed form.
#![allow(clippy::unwrap_used)]

use onepulse_core::dda::{Preset, Radix, Register};
use onepulse_core::parabola::{Dda, MinimumDeviation, Ppc, Shape};
use onepulse_core::{Axis, Error, Pulse};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

const AXES: [Axis; 2] = [Axis::X, Axis::Y];

fn shape(p: i32, u: i32, v: i32) -> Shape {
    Shape::new(Axis::X, p, [u, v]).unwrap()
}

/// The same parabola in another place of the plane.
fn turned(axis: Axis, p: i32, [u, v]: [i32; 2], signs: [i32; 2]) -> Shape {
    let end = [u * signs[0], v * signs[1]];
    let end = if axis == Axis::X { end } else { [end[1], end[0]] };
    Shape::new(axis, p * signs[0], end).unwrap()
}

fn points(pulses: impl Iterator<Item = Pulse>) -> impl Iterator<Item = [i64; 2]> {
    pulses.scan([0; 2], |point, Pulse([x, y])| {
        *point = [point[0] + i64::from(x), point[1] + i64::from(y)];
        Some(*point)
    })
}

/// v² − 2pu from the definition.
fn f(p: i64, [u, v]: [i64; 2]) -> i128 {
    i128::from(v) * i128::from(v) - 2 * i128::from(p) * i128::from(u)
}

/// Whether the parabola is met within one pulse along one of the axes.
fn is_within_a_pulse(p: i64, point: [i64; 2]) -> bool {
    let v = i128::from(point[1]);
    let on_the_row = f(p, point).abs() <= 2 * i128::from(p);
    let square = v * v - f(p, point);
    on_the_row || v >= 1 && (v - 1).pow(2) <= square && square <= (v + 1).pow(2)
}

/// Whether it is met within half a pulse along one of the axes.
fn is_within_half_a_pulse(p: i64, point: [i64; 2]) -> bool {
    let v = i128::from(point[1]);
    let on_the_row = f(p, point).abs() <= i128::from(p);
    let four_squares = 4 * (v * v - f(p, point));
    on_the_row || v >= 1 && (2 * v - 1).pow(2) <= four_squares && four_squares <= (2 * v + 1).pow(2)
}

/// The distance from the parabola. Its foot (t²/2p, t) has t³/2p² + t(1 − u/p) = v, which has just
/// one root above 0 where v > 0.
fn distance(p: i64, [u, v]: [i64; 2]) -> f64 {
    let [p, u, v] = [p, u, v].map(|c| c as f64);
    let slope = |t: f64| t * t * t / (2.0 * p * p) + t * (1.0 - u / p) - v;
    let (mut low, mut high) = (0.0, v + (2.0 * p * u).sqrt() + 1.0);
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        if slope(middle) < 0.0 { low = middle } else { high = middle }
    }
    (low * low / (2.0 * p) - u).hypot(low - v)
}

/// The path of point-by-point comparison by its rows: row v is left at the first u beyond v²/2p.
fn by_rows(p: i64, [u_end, v_end]: [i64; 2]) -> impl Iterator<Item = [i64; 2]> {
    let (mut u, mut v) = (0, 0);
    std::iter::from_fn(move || {
        let beyond = if v < v_end { (v * v / (2 * p) + 1).min(u_end) } else { u_end };
        if u < beyond {
            u += 1;
        } else if v < v_end {
            v += 1;
        } else {
            return None;
        }
        Some([u, v])
    })
}

/// The path of minimum deviation: all three neighbours measured, the single pulse across where it
/// is as good as the diagonal.
fn by_candidates(p: i64, end: [i64; 2]) -> impl Iterator<Item = [i64; 2]> {
    let mut point = [0, 0];
    std::iter::from_fn(move || {
        let steps: &[[i64; 2]] = match [point[0] < end[0], point[1] < end[1]] {
            [false, false] => return None,
            [true, true] => &[[0, 1], [1, 0], [1, 1]],
            [true, false] => &[[1, 0]],
            [false, true] => &[[0, 1]],
        };
        let neighbours = steps.iter().map(|step| [point[0] + step[0], point[1] + step[1]]);
        point = neighbours.min_by_key(|next| f(p, *next).abs())?;
        Some(point)
    })
}

#[test]
fn comparison_by_hand() {
    // y² = 4x to (4, 4): F 0 −4 −3 0 −4 1 −3 4 0.
    let mut curve = Ppc::new(shape(2, 4, 4)).unwrap();
    for (pulse, f) in [
        ([1, 0], -4),
        ([0, 1], -3),
        ([0, 1], 0),
        ([1, 0], -4),
        ([0, 1], 1),
        ([1, 0], -3),
        ([0, 1], 4),
        ([1, 0], 0),
    ] {
        assert_eq!(curve.step(), Some(Pulse(pulse)));
        assert_eq!(curve.deviation_function(), f);
    }
    assert_eq!((curve.step(), curve.residual()), (None, [0, 0]));
}

#[test]
fn every_small_parabola_by_comparison() {
    let mut farthest = 0_f64;
    for p in 1..=9 {
        for u in 0..=40 {
            for v in 0..=30 {
                let end = [i64::from(u), i64::from(v)];
                let mut curve = Ppc::new(shape(p, u, v)).unwrap();
                assert_eq!(curve.remaining(), (u + v) as u64);
                let path: Vec<_> = points(curve.by_ref()).collect();
                assert!(path.iter().copied().eq(by_rows(i64::from(p), end)), "{p} {end:?}");
                assert_eq!((curve.residual(), curve.position()), ([0, 0], end));
                let is_on_the_parabola = f(i64::from(p), end) == 0;
                for point in path {
                    let is_on_its_way = point[0] < end[0] && point[1] < end[1];
                    if is_on_its_way || is_on_the_parabola {
                        assert!(is_within_a_pulse(i64::from(p), point), "{p} {end:?} {point:?}");
                        farthest = farthest.max(distance(i64::from(p), point));
                    }
                }
            }
        }
    }
    println!("comparison: {farthest} at most");
    assert!((farthest - 1.0).abs() < 1e-9);
    // It is attained by the first pulse, whose nearest point is the vertex.
    assert!((distance(1, [1, 0]) - 1.0).abs() < 1e-9);
}

#[test]
fn every_small_parabola_by_minimum_deviation() {
    let (mut farthest, mut farthest_along_an_axis) = (0_f64, 0_f64);
    for p in 1..=9 {
        for u in 0..=40 {
            for v in 0..=30 {
                let end = [i64::from(u), i64::from(v)];
                let mut curve = MinimumDeviation::new(shape(p, u, v)).unwrap();
                let path: Vec<_> = points(curve.by_ref()).collect();
                assert!(path.iter().copied().eq(by_candidates(i64::from(p), end)), "{p} {end:?}");
                assert_eq!((curve.residual(), curve.position()), ([0, 0], end));
                let is_on_the_parabola = f(i64::from(p), end) == 0;
                for point in path {
                    let is_on_its_way = point[0] < end[0] && point[1] < end[1];
                    if is_on_its_way || is_on_the_parabola {
                        let p = i64::from(p);
                        assert!(is_within_half_a_pulse(p, point), "{p} {end:?} {point:?}");
                        farthest = farthest.max(distance(p, point));
                        let [u, v] = point.map(|c| c as f64);
                        let along = (v * v / (2 * p) as f64 - u).abs();
                        let across = ((2 * p) as f64 * u).sqrt() - v;
                        farthest_along_an_axis =
                            farthest_along_an_axis.max(along.min(across.abs()));
                    }
                }
            }
        }
    }
    println!("minimum deviation: {farthest}, along an axis {farthest_along_an_axis} at most");
    assert!(farthest <= 0.5 && farthest_along_an_axis == 0.5);
}

#[test]
fn half_a_pulse_is_attained_by_minimum_deviation() {
    // y² = 2x: (0, 1) and (1, 1) are as good.
    let mut curve = MinimumDeviation::new(shape(1, 8, 4)).unwrap();
    assert_eq!(curve.step(), Some(Pulse([0, 1])));
    assert!(is_within_half_a_pulse(1, [0, 1]));
    assert_eq!(f(1, [0, 1]), 1);
    // And in the plane it is approached: y² = 2px with p = k², at (0, k).
    let mut curve = MinimumDeviation::new(shape(10_000, 8, 1000)).unwrap();
    let walked: Vec<_> = points(curve.by_ref()).take(100).collect();
    assert_eq!(walked.last(), Some(&[0, 100]));
    assert!(distance(10_000, [0, 100]) > 0.499);
}

#[test]
fn all_orientations_and_branches_are_alike() {
    for p in [1, 2, 5, 12] {
        for end in [[0, 0], [7, 0], [0, 7], [18, 6], [17, 9], [3, 20]] {
            let register = Register::new(Radix::Binary, 6).unwrap();
            let paths = |shape| {
                let ppc = Ppc::new(shape).unwrap().collect::<Vec<_>>();
                let nearest = MinimumDeviation::new(shape).unwrap().collect::<Vec<_>>();
                let dda = Dda::new(shape, register, Preset::Half).unwrap().collect::<Vec<_>>();
                [ppc, nearest, dda]
            };
            let first = paths(turned(Axis::X, p, end, [1, 1]));
            for axis in AXES {
                for signs in [[1, 1], [1, -1], [-1, 1], [-1, -1]] {
                    let other = paths(turned(axis, p, end, signs));
                    for (path, other) in first.iter().zip(&other) {
                        let place = |Pulse([u, v]): &Pulse| {
                            let pulse = [u * signs[0] as i8, v * signs[1] as i8];
                            Pulse(if axis == Axis::X { pulse } else { [pulse[1], pulse[0]] })
                        };
                        assert!(path.iter().map(place).eq(other.iter().copied()));
                    }
                }
            }
        }
    }
}

/// What the registers must have brought after k clocks, until an axis stands: v = ⌊(load + k·p)/2ⁿ⌋, and
/// u the same of the sum of all v so far.
fn by_sums(p: i64, load: i64, bits: u32) -> impl Iterator<Item = [i64; 2]> {
    let mut sum = 0;
    (1..).map(move |k| {
        sum += (load + (k - 1) * p) >> bits;
        [(load + sum) >> bits, (load + k * p) >> bits]
    })
}

#[test]
fn integration_adds_what_the_sums_say() {
    for bits in 1..=6 {
        let register = Register::new(Radix::Binary, bits).unwrap();
        let most = (1 << bits) - 1;
        for (preset, load) in
            [(Preset::Zero, 0), (Preset::Half, 1 << (bits - 1)), (Preset::Full, most)]
        {
            for p in 1..=most {
                for end in [[i32::MAX, most as i32], [most as i32, 1 + most as i32 / 2]] {
                    let curve = Dda::new(shape(p as i32, end[0], end[1]), register, preset);
                    let is_on_its_way =
                        |[u, v]: &[i64; 2]| *u < i64::from(end[0]) && *v < i64::from(end[1]);
                    let sums = by_sums(p, load, bits).take_while(is_on_its_way);
                    assert!(points(curve.unwrap()).take_while(is_on_its_way).eq(sums));
                }
            }
        }
    }
}

/// The points of all parabolas whose parameter and last v leave so many bits of the registers free, with
/// their parameters, up to the pulse with which v stands.
fn integrated(bits: u32, headroom: u32, preset: Preset) -> impl Iterator<Item = (i64, [i64; 2])> {
    let register = Register::new(Radix::Binary, bits).unwrap();
    let most = (1 << (bits - headroom)) - 1;
    (1..=most).flat_map(move |p| {
        let curve = Dda::new(shape(p, i32::MAX, most), register, preset).unwrap();
        let mut stands = false;
        points(curve)
            .take_while(move |point| !std::mem::replace(&mut stands, point[1] == i64::from(most)))
            .map(move |point| (i64::from(p), point))
    })
}

/// The farthest of these points, and where it is: p, u, v.
fn farthest(bits: u32, headroom: u32, preset: Preset) -> (f64, [i64; 3]) {
    let mut farthest = (0.0, [0; 3]);
    for (p, point) in integrated(bits, headroom, preset) {
        let off = distance(p, point);
        if off > farthest.0 {
            farthest = (off, [p, point[0], point[1]]);
        }
    }
    farthest
}

#[test]
fn how_far_integration_strays() {
    // In thousandths of a pulse, for registers of 2 bits and more.
    for (preset, expected) in [
        (Preset::Zero, [1126, 1225, 1251, 1335, 1350, 1365, 1371]),
        (Preset::Half, [567, 624, 783, 870, 976, 974, 1017]),
        (Preset::Full, [647, 843, 929, 967, 1006, 1038, 1062]),
    ] {
        for (bits, expected) in (2..).zip(expected) {
            let (off, [p, u, v]) = farthest(bits, 0, preset);
            println!("{preset:?} {bits} bits: {off:.3} with p = {p} at ({u}, {v})");
            assert_eq!((1000.0 * off).round() as i32, expected);
        }
    }
}

#[test]
fn how_far_integration_strays_with_headroom() {
    // One bit and two bits of it, for registers of 3 bits and more, in thousandths of a pulse.
    for (headroom, expected) in
        [(1, [567, 624, 776, 785, 825, 837]), (2, [375, 567, 647, 716, 750, 754])]
    {
        for (bits, expected) in (3..).zip(expected) {
            let (off, [p, u, v]) = farthest(bits, headroom, Preset::Half);
            println!("{headroom} of {bits} bits: {off:.3} with p = {p} at ({u}, {v})");
            assert_eq!((1000.0 * off).round() as i32, expected);
        }
    }
    // To the other presets it is little help: 8 bits.
    for (preset, expected) in [(Preset::Zero, [1222, 1147]), (Preset::Full, [1062, 1062])] {
        for (headroom, expected) in (1..).zip(expected) {
            let (off, _) = farthest(8, headroom, preset);
            assert_eq!((1000.0 * off).round() as i32, expected);
        }
    }
}

/// docs/proofs/parabola_dda.md: with the other presets no headroom is enough.
#[test]
fn integration_without_half_load_loses_a_pulse_in_every_register() {
    for (preset, narrowest, p, lost, expected) in
        [(Preset::Zero, 2, 3, [0, 3], 1126), (Preset::Full, 8, 18, [4, 10], 1062)]
    {
        for bits in narrowest..=16 {
            let register = Register::new(Radix::Binary, bits).unwrap();
            let end = shape(p, i32::MAX, (1 << bits) - 1);
            let curve = Dda::new(end, register, preset).unwrap();
            assert!(points(curve).any(|point| point == lost), "{preset:?}, {bits} bits");
        }
        assert_eq!((1000.0 * distance(i64::from(p), lost)).round() as i32, expected);
    }
}

/// docs/proofs/parabola_dda.md: F's bounds, whatever is left free of the registers.
#[test]
fn integration_keeps_the_deviation_function_in_bounds() {
    for bits in 1..=7 {
        let m = 1 << bits;
        for preset in [Preset::Zero, Preset::Half, Preset::Full] {
            for (p, point) in integrated(bits, 0, preset) {
                let (f, p, v) = (f(p, point), i128::from(p), i128::from(point[1]));
                let grown = 2 * (p - 1) * v;
                let (least, most) = match preset {
                    Preset::Zero => (-v, m * (v + 2 * p) + grown - 2 * p),
                    Preset::Half => (-v - p, m * (v + p) + grown - 2 * p),
                    Preset::Full => (-v - 2 * p, m * v + grown),
                };
                assert!(least <= f && m * f <= most, "{preset:?}: {p} at {point:?}");
                let grown = v * p + p * p / 4;
                assert!(preset != Preset::Half || m * f <= m * (v + p) + grown - 2 * p);
            }
        }
    }
}

/// docs/proofs/parabola_dda.md: what the remainder register across holds after its pulses, with half
/// load: in sum v·p/2 + p²/8 at most.
#[test]
fn remainders_after_the_pulses_across() {
    for bits in 1..=8 {
        let register = Register::new(Radix::Binary, bits).unwrap();
        let most = (1 << bits) - 1;
        for p in 1..=most {
            let end = shape(p, i32::MAX, most);
            let mut curve = Dda::new(end, register, Preset::Half).unwrap();
            let (mut v, mut sum) = (0, 0);
            while v < most as u64 {
                if curve.step().is_some_and(|pulse| pulse.0[1] != 0) {
                    (v, sum) = (v + 1, sum + curve.remainders()[1]);
                    assert!(8 * sum <= 4 * v * p as u64 + (p * p) as u64, "{p} at v = {v}");
                }
            }
        }
    }
}

/// docs/proofs/parabola_dda.md: the distances that follow.
#[test]
fn integration_keeps_its_distance() {
    let half = |k: f64| (1.0 + k) * 0.5_f64.sqrt();
    let full = 1.25_f64.sqrt();
    for (preset, bounds) in [
        (Preset::Zero, [1.25 * 2.0_f64.sqrt(), 2.0_f64.sqrt(), 2.0_f64.sqrt()]),
        (Preset::Half, [half(1.0), 1.0, half(0.25)]),
        (Preset::Full, [full; 3]),
    ] {
        for (headroom, bound) in (0..).zip(bounds) {
            for bits in headroom + 1..=7 {
                let (off, at) = farthest(bits, headroom, preset);
                assert!(off <= bound, "{preset:?}, {headroom} of {bits} bits: {off} at {at:?}");
            }
        }
    }
}

/// How near to its bound, √5/2 = 1.118, full load comes: F = −164 here, of −(v + 2p) = −166.
#[test]
fn integration_with_full_load_comes_near_its_bound() {
    let register = Register::new(Radix::Binary, 11).unwrap();
    let mut curve = points(Dda::new(shape(66, 100, 100), register, Preset::Full).unwrap());
    assert!(curve.any(|point| point == [10, 34]));
    assert_eq!(f(66, [10, 34]), -164);
    assert_eq!((1000.0 * distance(66, [10, 34])).round() as i32, 1103);
}

#[test]
fn integration_always_ends_exactly() {
    for bits in 1..=4 {
        let register = Register::new(Radix::Binary, bits).unwrap();
        let most = (1 << bits) - 1;
        for preset in [Preset::Zero, Preset::Half, Preset::Full] {
            for p in 1..=most {
                for u in 0..=2 * most {
                    for v in 0..=most {
                        let mut curve = Dda::new(shape(p, u, v), register, preset).unwrap();
                        assert_eq!(curve.remaining(), (u + v) as u64);
                        let clocks = curve.by_ref().count() as i32;
                        assert_eq!(curve.position(), [u, v].map(i64::from));
                        assert!(curve.is_done() && curve.residual() == [0, 0]);
                        assert!(clocks <= (u + v) << bits);
                    }
                }
            }
        }
    }
}

#[test]
fn what_the_register_cannot_hold_is_refused() {
    let binary = |bits| Register::new(Radix::Binary, bits).unwrap();
    let refused = |digits, needed| Some(Error::RegisterTooNarrow { digits, needed });
    let new = |shape, register| Dda::new(shape, register, Preset::Zero).err();
    assert_eq!(new(shape(1, 1000, 16), binary(4)), refused(4, 5));
    assert_eq!(new(shape(16, 1000, 1), binary(4)), refused(4, 5));
    assert_eq!(new(shape(15, 1000, 15), binary(4)), None);
    assert_eq!(new(shape(1, 0, i32::MIN), binary(31)), refused(31, 32));
    assert_eq!(new(shape(1, 0, i32::MIN), binary(32)), None);
    let decimal = Register::new(Radix::Decimal, 5).unwrap();
    assert_eq!(new(shape(1, 1, 1), decimal), Some(Error::ParabolaNeedsBinary));
}

fn parameter() -> impl Strategy<Value = i32> {
    prop_oneof![
        3 => any::<i32>(),
        3 => 1..=2000,
        2 => -2000..=-1,
        1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, -1, 1, i32::MAX - 1, i32::MAX]),
    ]
    .prop_filter("no curve", |p| *p != 0)
}

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        2 => any::<i32>(),
        4 => -1500..=1500,
        1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX]),
    ]
}

fn any_shape() -> impl Strategy<Value = Shape> {
    let sides = prop::sample::select(AXES.to_vec());
    (sides, parameter(), coordinate(), coordinate()).prop_map(|(axis, p, along, across)| {
        let along = if (along < 0) == (p < 0) { along } else { !along };
        let along = if along < 0 && p > 0 || along > 0 && p < 0 { 0 } else { along };
        let end = if axis == Axis::X { [along, across] } else { [across, along] };
        Shape::new(axis, p, end).unwrap()
    })
}

/// Steps that are followed where a whole run would take too long.
const STEPS: usize = 1000;

fn magnitudes(shape: &Shape, [x, y]: [i64; 2]) -> [i64; 2] {
    if shape.axis() == Axis::X { [x.abs(), y.abs()] } else { [y.abs(), x.abs()] }
}

proptest! {
    #![proptest_config(ProptestConfig {
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0x9a4a_b01a),
        ..ProptestConfig::with_cases(4000)
    })]

    #[test]
    fn comparison_keeps_one_pulse(shape in any_shape()) {
        let p = i64::from(shape.parameter()).abs();
        let end = shape.end().map(i64::from);
        let ahead = magnitudes(&shape, end);
        let mut curve = Ppc::new(shape).unwrap();
        let total = curve.remaining();
        prop_assert_eq!(total, end[0].unsigned_abs() + end[1].unsigned_abs());
        let walked: Vec<_> =
            points(curve.by_ref().take(STEPS)).map(|point| magnitudes(&shape, point)).collect();
        prop_assert!(walked.iter().copied().eq(by_rows(p, ahead).take(STEPS)));
        for point in walked {
            if point[0] < ahead[0] && point[1] < ahead[1] {
                prop_assert!(is_within_a_pulse(p, point), "{:?}", point);
            }
        }
        if total <= STEPS as u64 {
            prop_assert_eq!((curve.step(), curve.position(), curve.residual()), (None, end, [0, 0]));
        }
    }

    #[test]
    fn minimum_deviation_keeps_half_a_pulse(shape in any_shape()) {
        let p = i64::from(shape.parameter()).abs();
        let end = shape.end().map(i64::from);
        let ahead = magnitudes(&shape, end);
        let mut curve = MinimumDeviation::new(shape).unwrap();
        let [x, y] = curve.pulses_to_go();
        let walked: Vec<_> =
            points(curve.by_ref().take(STEPS)).map(|point| magnitudes(&shape, point)).collect();
        prop_assert!(walked.iter().copied().eq(by_candidates(p, ahead).take(STEPS)));
        for point in walked {
            if point[0] < ahead[0] && point[1] < ahead[1] {
                prop_assert!(is_within_half_a_pulse(p, point), "{:?}", point);
            }
        }
        if x + y <= STEPS as u64 {
            prop_assert_eq!((curve.step(), curve.position(), curve.residual()), (None, end, [0, 0]));
        }
    }

    /// To an end point on the parabola both keep their bounds to the end.
    #[test]
    fn ends_on_the_parabola(k in 1..40_i64, p in 1..40_i64, low: bool, axis in prop::sample::select(AXES.to_vec())) {
        // v = 2pk, u = 2pk².
        let end = [2 * p * k * k, 2 * p * k].map(|c| c as i32);
        let shape = turned(axis, p as i32, end, if low { [-1, -1] } else { [1, 1] });
        for point in points(Ppc::new(shape).unwrap()) {
            prop_assert!(is_within_a_pulse(p, magnitudes(&shape, point)));
        }
        for point in points(MinimumDeviation::new(shape).unwrap()) {
            prop_assert!(is_within_half_a_pulse(p, magnitudes(&shape, point)));
        }
    }

    #[test]
    fn integration_at_full_width(shape in any_shape(), extra in 0..3_u32, load in 0..3_usize) {
        let bits = (Dda::bits(&shape) + extra).min(32);
        let register = Register::new(Radix::Binary, bits).unwrap();
        let preset = [Preset::Zero, Preset::Half, Preset::Full][load];
        let begun = [0, 1 << (bits - 1), (1 << bits) - 1][load];
        let ahead = magnitudes(&shape, shape.end().map(i64::from));
        let is_on_its_way = |[u, v]: &[i64; 2]| *u < ahead[0] && *v < ahead[1];
        let curve = Dda::new(shape, register, preset).unwrap();
        let walked = points(curve).map(|point| magnitudes(&shape, point)).take(STEPS);
        let p = i64::from(shape.parameter()).abs();
        let sums = by_sums(p, begun, bits).take(STEPS).take_while(is_on_its_way);
        prop_assert!(walked.take_while(is_on_its_way).eq(sums));
    }
}
