//! Helices: the arc in the plane, the linear axis by its share, and the end of both together.
#![allow(clippy::unwrap_used)]

use onepulse_core::Direction::{Ccw, Cw};
use onepulse_core::{EndRule, Error, Helix, Plane, Pulse, ppc};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Zx, Plane::Yz];

/// ⌊a/b + ½⌋ where ½ is counted as ⌊b/2⌋/b.
fn rounded(a: u64, b: u64) -> u64 {
    (b / 2 + a) / b
}

/// The whole helix against its parts: the arc's pulses in their order, and each of the two after c of T
/// cycles at its share, half a step off at most.
fn follow(plane: Plane, start: [i32; 2], end: [i32; 2], ccw: bool, rise: i32) {
    let direction = if ccw { Ccw } else { Cw };
    let arc = ppc::Arc::new(start, end, direction, EndRule::Total).unwrap();
    let (steps, height) = (arc.remaining(), u64::from(rise.unsigned_abs()));
    let mut helix = Helix::new(plane, start, end, direction, rise).unwrap();
    let cycles = helix.cycles();
    assert_eq!((cycles, helix.remaining()), (steps.max(height), cycles));
    let [first, second, across] = plane.axes();
    let mut in_the_plane = Vec::new();
    let mut made = [0, 0];
    for cycle in 1..=cycles {
        let pulse = helix.step().unwrap();
        let in_plane = [pulse.0[first], pulse.0[second]];
        if in_plane != [0, 0] {
            in_the_plane.push(Pulse(in_plane));
            made[0] += 1;
        }
        let across = i32::from(pulse.0[across]);
        assert!(across == 0 || across == rise.signum());
        made[1] += u64::from(across != 0);
        for (made, whole) in made.into_iter().zip([steps, height]) {
            assert_eq!(made, rounded(cycle * whole, cycles));
            assert!((2 * made * cycles).abs_diff(2 * cycle * whole) <= cycles);
        }
        assert_eq!(helix.remaining(), cycles - cycle);
        let residual = helix.residual();
        assert_eq!(residual[plane.axes()[2]].unsigned_abs(), height - made[1]);
    }
    assert_eq!((helix.step(), helix.residual()), (None, [0, 0, 0]));
    assert!(in_the_plane.into_iter().eq(arc));
    let reached = helix.position();
    assert_eq!(reached[first], i64::from(end[0]));
    assert_eq!(reached[second], i64::from(end[1]));
    assert_eq!(reached[across], i64::from(rise));
}

#[test]
fn by_hand() {
    // Four steps, z by one: at the half, 2 of 4.
    let helix = Helix::new(Plane::Xy, [2, 0], [0, 2], Ccw, -1).unwrap();
    let pulses: Vec<_> = helix.map(|pulse| pulse.0).collect();
    assert_eq!(pulses, [[-1, 0, 0], [0, 1, -1], [0, 1, 0], [-1, 0, 0]]);
    // Two steps, z by five: T = 5, from 2: 4, 6 − 5 = 1, 3, 5 − 5 = 0, 2.
    let helix = Helix::new(Plane::Xy, [1, 0], [0, 1], Ccw, 5).unwrap();
    let pulses: Vec<_> = helix.map(|pulse| pulse.0).collect();
    assert_eq!(pulses, [[0, 0, 1], [-1, 0, 1], [0, 0, 1], [0, 1, 1], [0, 0, 1]]);
}

#[test]
fn the_planes_turn_the_first_axis_into_the_second() {
    // The cross product of the first and the second axis is the one across.
    for plane in PLANES {
        let [first, second, across] = plane.axes();
        let unit = |axis| [0, 1, 2].map(|other| i32::from(other == axis));
        let ([ax, ay, az], [bx, by, bz]) = (unit(first), unit(second));
        assert_eq!([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], unit(across));
        let placed = plane.place([10, 20, 30]);
        assert_eq!([first, second, across].map(|axis| placed[axis]), [10, 20, 30]);
    }
    let first_pulse = |plane| Helix::new(plane, [9, 0], [0, 9], Ccw, 0).unwrap().step();
    assert_eq!(first_pulse(Plane::Xy), Some(Pulse([-1, 0, 0])));
    assert_eq!(first_pulse(Plane::Zx), Some(Pulse([0, 0, -1])));
    assert_eq!(first_pulse(Plane::Yz), Some(Pulse([0, -1, 0])));
}

#[test]
fn every_small_helix() {
    let on_5 = [[5, 0], [3, 4], [-4, 3], [0, -5]];
    for plane in PLANES {
        for start in on_5 {
            for end in on_5.into_iter().chain([[4, 4], [-6, 1]]) {
                for rise in -45..=45 {
                    for ccw in [true, false] {
                        follow(plane, start, end, ccw, rise);
                    }
                }
            }
        }
    }
}

#[test]
fn half_a_pulse_is_attained() {
    // Ten steps, a rise of one: after five the share is ½, and the pulse is made.
    let mut helix = Helix::new(Plane::Xy, [5, 0], [0, 5], Ccw, 1).unwrap();
    assert!(helix.by_ref().take(4).all(|pulse| pulse.0[2] == 0));
    assert_eq!(helix.step().map(|pulse| pulse.0[2]), Some(1));
}

#[test]
fn no_circle_no_helix() {
    let new = |start, end| Helix::new(Plane::Zx, start, end, Cw, 7).err();
    assert_eq!(new([0, 0], [1, 0]), Some(Error::StartInCentre));
    assert_eq!(new([1, 0], [0, 0]), Some(Error::EndInCentre));
    let start = [i32::MIN, 0];
    assert_eq!(new(start, start), Some(Error::CircleTooLarge { start }));
}

/// Cycles that are followed where a whole run would take too long.
const CYCLES: usize = 1000;

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![2 => any::<i32>(), 2 => -60..=60, 1 => prop::sample::select(vec![0, i32::MIN, i32::MAX])]
}

proptest! {
    #![proptest_config(ProptestConfig {
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0x4e11),
        ..ProptestConfig::with_cases(3000)
    })]

    #[test]
    fn helices_of_any_pitch(
        start in [-40..=40, -40..=40],
        end in [-40..=40, -40..=40],
        plane in prop::sample::select(PLANES.to_vec()),
        ccw: bool,
        rise in -900..=900,
    ) {
        if start != [0, 0] && end != [0, 0] {
            follow(plane, start, end, ccw, rise);
        }
    }

    #[test]
    fn helices_at_full_width(
        start in [coordinate(), coordinate()],
        end in [coordinate(), coordinate()],
        plane in prop::sample::select(PLANES.to_vec()),
        rise in coordinate(),
    ) {
        let Ok(mut helix) = Helix::new(plane, start, end, Cw, rise) else { return Ok(()) };
        let mut arc = ppc::Arc::new(start, end, Cw, EndRule::Total).unwrap();
        let (steps, height) = (u128::from(arc.remaining()), u128::from(rise.unsigned_abs()));
        let cycles = steps.max(height);
        prop_assert_eq!(u128::from(helix.remaining()), cycles);
        let axes = plane.axes();
        let mut made = [0_u128, 0];
        for (cycle, pulse) in (1..).zip(helix.by_ref().take(CYCLES)) {
            let in_plane = [pulse.0[axes[0]], pulse.0[axes[1]]];
            if in_plane != [0, 0] {
                prop_assert_eq!(arc.step(), Some(Pulse(in_plane)));
                made[0] += 1;
            }
            made[1] += u128::from(pulse.0[axes[2]] != 0);
            for (made, whole) in made.into_iter().zip([steps, height]) {
                prop_assert!((2 * made * cycles).abs_diff(2 * cycle * whole) <= cycles);
            }
        }
        if cycles <= CYCLES as u128 {
            prop_assert_eq!((helix.step(), helix.residual()), (None, [0, 0, 0]));
        }
    }
}
