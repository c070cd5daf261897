//! Every circuit sends the pulses of its software counterpart, cycle for cycle.

#![allow(clippy::unwrap_used)]

use onepulse_core::dda::{Preset, Radix, Register};
use onepulse_core::parabola::{self as soft_parabola, Shape};
use onepulse_core::{Axis, Direction, EndRule, Error, Pulse};
use onepulse_core::{
    brm as soft_brm, comparison as soft_comparison, dda as soft_dda,
    minimum_deviation as soft_minimum_deviation, ppc as soft_ppc,
};
use onepulse_hwmodel::{Circuit, brm, comparison, dda, minimum_deviation, parabola, ppc};
use proptest::prelude::*;
use std::fmt::Debug;

const PRESETS: [Preset; 3] = [Preset::Zero, Preset::Half, Preset::Full];
const RULES: [EndRule; 3] = [EndRule::Total, EndRule::PerAxis, EndRule::Larger];
const AXES: [Axis; 2] = [Axis::X, Axis::Y];
const DIRECTIONS: [Direction; 2] = [Direction::Cw, Direction::Ccw];

/// Both run to the end, or are both refused for the same reason.
fn assert_equal<S, C, E, const AXES: usize>(
    software: Result<S, E>,
    circuit: Result<C, E>,
    what: impl Debug,
) where
    S: Iterator<Item = Pulse<AXES>>,
    C: Circuit<AXES>,
    E: Debug + PartialEq,
{
    match (software, circuit) {
        (Ok(mut software), Ok(circuit)) => {
            let mut circuit = circuit.cycles();
            for cycle in 1.. {
                let (soft, hard) = (software.next(), circuit.next());
                assert_eq!(soft, hard, "cycle {cycle} of {what:?}: software left, circuit right");
                if soft.is_none() {
                    break;
                }
            }
        }
        (software, circuit) => assert_eq!(software.err(), circuit.err(), "{what:?}"),
    }
}

fn binary(bits: u32) -> Register {
    Register::new(Radix::Binary, bits).unwrap()
}

fn dda_line(end: [i32; 2], bits: u32, preset: Preset, normalize: bool) {
    assert_equal(
        soft_dda::Line::new(end, binary(bits), preset, normalize),
        dda::Line::new(end, bits, preset, normalize),
        ("dda line", end, bits, preset, normalize),
    );
}

fn minimum_deviation_line<const AXES: usize>(end: [i32; AXES], bits: u32) {
    assert_equal(
        soft_minimum_deviation::Line::new(end),
        minimum_deviation::Line::new(end, bits),
        ("minimum deviation line", end, bits),
    );
}

fn comparison_line(end: [i32; 2], bits: u32) {
    assert_equal(
        soft_comparison::Line::new(end),
        comparison::Line::new(end, bits),
        ("comparison line", end, bits),
    );
}

/// The parabola to this end point, if it opens to that side.
fn parabola_ppc(axis: Axis, parameter: i32, end: [i32; 2], extra: u32) {
    let Ok(shape) = Shape::new(axis, parameter, end) else { return };
    let bits = parabola::Ppc::bits(&shape) + extra;
    assert_equal(
        soft_parabola::Ppc::new(shape),
        parabola::Ppc::new(shape, bits),
        ("parabola by point-by-point comparison", shape, bits),
    );
}

fn arcs(start: [i32; 2], end: [i32; 2], direction: Direction, bits: u32) {
    for normalize in [false, true] {
        for preset in PRESETS {
            assert_equal(
                soft_dda::Arc::new(start, end, direction, binary(bits), preset, normalize),
                dda::Arc::new(start, end, direction, bits, preset, normalize),
                ("dda arc", start, end, direction, bits, preset, normalize),
            );
        }
        assert_equal(
            soft_dda::CentredArc::new(start, end, direction, binary(bits), normalize),
            dda::CentredArc::new(start, end, direction, bits, normalize),
            ("centred arc", start, end, direction, bits, normalize),
        );
    }
    ppc_arc(start, end, direction);
    nearest_arcs(start, end, direction);
}

/// The arcs that move one axis or both.
fn nearest_arcs(start: [i32; 2], end: [i32; 2], direction: Direction) {
    let narrowest = comparison::Arc::bits(start, end, direction).unwrap_or(32);
    assert_equal(
        soft_comparison::Arc::new(start, end, direction),
        comparison::Arc::new(start, end, direction, narrowest),
        ("comparison arc", start, end, direction),
    );
    let narrowest = minimum_deviation::Arc::bits(start, end, direction).unwrap_or(32);
    assert_equal(
        soft_minimum_deviation::Arc::new(start, end, direction),
        minimum_deviation::Arc::new(start, end, direction, narrowest),
        ("minimum deviation arc", start, end, direction),
    );
}

fn ppc_arc(start: [i32; 2], end: [i32; 2], direction: Direction) {
    let narrowest = ppc::Arc::bits(start, end, direction).unwrap_or(32);
    for rule in RULES {
        assert_equal(
            soft_ppc::Arc::new(start, end, direction, rule),
            ppc::Arc::new(start, end, direction, narrowest, rule),
            ("ppc arc", start, end, direction, rule),
        );
    }
}

/// Lattice points with coordinates in −most..=most.
fn points(most: i32) -> impl Iterator<Item = [i32; 2]> {
    (-most..=most).flat_map(move |x| (-most..=most).map(move |y| [x, y]))
}

#[test]
fn every_line_of_up_to_6_bits() {
    for bits in 1..=6 {
        for end in points((1 << bits) - 1) {
            for preset in PRESETS {
                dda_line(end, bits, preset, false);
                dda_line(end, bits, preset, true);
            }
            assert_equal(
                soft_brm::Line::new(end, bits),
                brm::Line::new(end, bits),
                ("brm line", end, bits),
            );
            minimum_deviation_line(end, bits);
            comparison_line(end, bits);
            for rule in RULES {
                assert_equal(
                    soft_ppc::Line::new(end, rule),
                    ppc::Line::new(end, bits, rule),
                    ("ppc line", end, bits, rule),
                );
            }
        }
    }
}

#[test]
fn every_arc_between_lattice_points_of_up_to_6_bits() {
    for bits in 2..=6 {
        let most: i32 = (1 << bits) - 1;
        let square = |[x, y]: [i32; 2]| x * x + y * y;
        let mut rings = std::collections::BTreeMap::<i32, Vec<[i32; 2]>>::new();
        for point in points(most).filter(|&p| square(p) > 0 && square(p) <= most * most) {
            rings.entry(square(point)).or_default().push(point);
        }
        for ring in rings.values() {
            for &start in ring {
                for &end in ring {
                    for direction in DIRECTIONS {
                        arcs(start, end, direction, bits);
                    }
                }
            }
        }
    }
}

/// From every point and to every point, on the circle or off it.
#[test]
fn every_small_arc_that_moves_one_axis_or_both() {
    for start in points(5) {
        for end in points(7) {
            for direction in DIRECTIONS {
                nearest_arcs(start, end, direction);
            }
        }
    }
}

#[test]
fn every_end_point_off_the_circle_of_3_bits() {
    for start in points(4) {
        for end in points(7) {
            for direction in DIRECTIONS {
                arcs(start, end, direction, 4);
            }
        }
    }
}

/// To every end point, on the parabola or off it.
#[test]
fn every_parabola_of_up_to_4_bits() {
    for axis in AXES {
        for parameter in -15..=15 {
            for end in points(15) {
                parabola_ppc(axis, parameter, end, 0);
            }
        }
    }
}

#[test]
fn a_parabola_that_the_registers_do_not_hold_is_refused() {
    let shape = |p, end| Shape::new(Axis::X, p, end).unwrap();
    let wide = [(1, [0, 16], 5), (1, [31, 0], 5), (-16, [-1, 1], 5), (i32::MIN, [0, 0], 32)];
    for (p, end, needed) in wide {
        let shape = shape(p, end);
        assert_eq!(parabola::Ppc::bits(&shape), needed);
        let error = Error::RegisterTooNarrow { digits: 4, needed };
        assert_eq!(parabola::Ppc::new(shape, 4).err(), Some(error));
        assert!(parabola::Ppc::new(shape, needed).is_ok());
    }
    for bits in [0, 33] {
        let error = parabola::Ppc::new(shape(1, [1, 1]), bits).err();
        assert_eq!(error, Some(Error::RegisterWidth { digits: bits, widest: 32 }));
    }
}

#[test]
fn more_axes_share_the_counter() {
    for preset in PRESETS {
        let end = [5, -13, 0, 9];
        assert_equal(
            soft_dda::Line::new(end, binary(4), preset, false),
            dda::Line::new(end, 4, preset, false),
            end,
        );
    }
    let end = [5, -13, 7];
    assert_equal(soft_brm::Line::new(end, 4), brm::Line::new(end, 4), end);
}

#[test]
fn every_line_by_minimum_deviation_in_space() {
    for [x, y] in points(7) {
        for z in -7..=7 {
            minimum_deviation_line([x, y, z], 3);
        }
    }
    minimum_deviation_line([-9, 31, 30, 17, 0], 5);
}

#[test]
fn a_line_that_the_registers_do_not_hold_is_refused() {
    let error = |needed| Some(Error::RegisterTooNarrow { digits: 4, needed });
    for (end, needed) in [([16, 0], 5), ([0, -31], 5), ([i32::MIN, 3], 32)] {
        assert_eq!(minimum_deviation::Line::new(end, 4).err(), error(needed));
        assert_eq!(comparison::Line::new(end, 4).err(), error(needed));
    }
    for bits in [0, 33] {
        assert!(minimum_deviation::Line::new([1, 1], bits).is_err());
        assert!(comparison::Line::new([1, 1], bits).is_err());
    }
}

/// A coordinate of up to `bits` bits with its sign, the boundaries more often.
fn coordinate(bits: u32) -> impl Strategy<Value = i32> {
    let most = ((1_i64 << bits) - 1) as i32;
    prop_oneof![3 => -most..=most, 1 => Just(most), 1 => Just(-most), 1 => Just(0)]
}

/// Any coordinate, the largest and the smallest more often.
fn longest() -> impl Strategy<Value = i32> {
    prop_oneof![3 => any::<i32>(), 1 => Just(i32::MAX), 1 => Just(i32::MIN), 1 => Just(0)]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    #[test]
    fn lines_at_random_widths(
        (bits, end) in (2_u32..=16).prop_flat_map(|b| (Just(b), [coordinate(b), coordinate(b)])),
        preset in 0..3_usize,
        rule in 0..3_usize,
        normalize: bool,
    ) {
        dda_line(end, bits, PRESETS[preset], normalize);
        assert_equal(soft_brm::Line::new(end, bits), brm::Line::new(end, bits), (end, bits));
        assert_equal(
            soft_ppc::Line::new(end, RULES[rule]),
            ppc::Line::new(end, bits, RULES[rule]),
            (end, bits),
        );
        minimum_deviation_line(end, bits);
        comparison_line(end, bits);
    }

    #[test]
    fn parabolas_at_random_widths(
        end in (2_u32..=16).prop_flat_map(|b| [coordinate(b), coordinate(b)]),
        parameter in (2_u32..=16).prop_flat_map(coordinate),
        extra in 0..3_u32,
        upright: bool,
    ) {
        let axis = AXES[usize::from(upright)];
        let opens = if axis.of(end) < 0 { -parameter.abs() } else { parameter.abs() };
        parabola_ppc(axis, opens, end, extra);
    }

    #[test]
    fn arcs_at_random_widths(
        start in (2_u32..=9).prop_flat_map(|b| [coordinate(b), coordinate(b)]),
        end in (2_u32..=9).prop_flat_map(|b| [coordinate(b), coordinate(b)]),
        extra in 0..3_u32,
        ccw: bool,
    ) {
        let direction = DIRECTIONS[usize::from(ccw)];
        let bits = soft_dda::CentredArc::bits(start, end, direction).unwrap_or(4) + extra;
        arcs(start, end, direction, bits);
    }

    /// Wide registers, in which a whole run would take too long: the first cycles.
    #[test]
    fn the_first_cycles_at_full_width(
        end in [any::<i32>(), any::<i32>()],
        start in [any::<i32>(), any::<i32>()],
        bits in 17_u32..=32,
        ccw: bool,
        normalize: bool,
    ) {
        const CYCLES: usize = 5000;
        let narrowed = |c: i32| c >> (33 - bits);
        let (start, end) = (start.map(narrowed), end.map(narrowed));
        let direction = DIRECTIONS[usize::from(ccw)];
        for preset in PRESETS {
            if let (Ok(soft), Ok(hard)) = (
                soft_dda::Line::new(end, binary(bits), preset, normalize),
                dda::Line::new(end, bits, preset, normalize),
            ) {
                prop_assert!(soft.take(CYCLES).eq(hard.cycles().take(CYCLES)));
            }
            if let (Ok(soft), Ok(hard)) = (
                soft_dda::Arc::new(start, end, direction, binary(bits), preset, normalize),
                dda::Arc::new(start, end, direction, bits, preset, normalize),
            ) {
                prop_assert!(soft.take(CYCLES).eq(hard.cycles().take(CYCLES)));
            }
        }
        let soft = soft_dda::CentredArc::new(start, end, direction, binary(bits), normalize);
        let hard = dda::CentredArc::new(start, end, direction, bits, normalize);
        prop_assert_eq!(soft.err(), hard.err());
        if let (Ok(soft), Ok(hard)) = (soft, hard) {
            prop_assert!(soft.take(CYCLES).eq(hard.cycles().take(CYCLES)));
        }
        let soft = soft_ppc::Arc::new(start, end, direction, EndRule::Total);
        if let (Ok(soft), Ok(hard)) = (soft, ppc::Arc::new(start, end, direction, 32, EndRule::Total)) {
            prop_assert!(soft.take(CYCLES).eq(hard.cycles().take(CYCLES)));
        }
        let soft = soft_comparison::Arc::new(start, end, direction);
        let narrowest = comparison::Arc::bits(start, end, direction).unwrap_or(32);
        if let (Ok(soft), Ok(hard)) = (soft, comparison::Arc::new(start, end, direction, narrowest)) {
            prop_assert!(soft.take(CYCLES).eq(hard.cycles().take(CYCLES)));
        }
        let soft = soft_minimum_deviation::Arc::new(start, end, direction);
        let hard = minimum_deviation::Arc::new(start, end, direction, narrowest);
        if let (Ok(soft), Ok(hard)) = (soft, hard) {
            prop_assert!(soft.take(CYCLES).eq(hard.cycles().take(CYCLES)));
        }
        let soft = soft_ppc::Line::new(end, EndRule::Total).unwrap();
        let hard = ppc::Line::new(end, 32, EndRule::Total).unwrap();
        prop_assert!(soft.take(CYCLES).eq(hard.cycles().take(CYCLES)));
        let soft = soft_comparison::Line::new(end).unwrap();
        let hard = comparison::Line::new(end, bits - 1).unwrap();
        prop_assert!(soft.take(CYCLES).eq(hard.cycles().take(CYCLES)));
        let soft = soft_minimum_deviation::Line::new(end).unwrap();
        let hard = minimum_deviation::Line::new(end, bits - 1).unwrap();
        prop_assert!(soft.take(CYCLES).eq(hard.cycles().take(CYCLES)));
    }

    #[test]
    fn the_first_cycles_of_the_longest_parabolas(
        end in [longest(), longest()],
        parameter in longest(),
        narrower in 0..32_u32,
        upright: bool,
    ) {
        const CYCLES: usize = 5000;
        let axis = AXES[usize::from(upright)];
        if let Ok(shape) = Shape::new(axis, parameter >> narrower, end) {
            let soft = soft_parabola::Ppc::new(shape).unwrap();
            let hard = parabola::Ppc::new(shape, 32).unwrap();
            prop_assert!(soft.take(CYCLES).eq(hard.cycles().take(CYCLES)));
        }
    }

    #[test]
    fn the_first_cycles_of_the_longest_lines(end in [longest(), longest(), longest()]) {
        const CYCLES: usize = 5000;
        let soft = soft_minimum_deviation::Line::new(end).unwrap();
        let hard = minimum_deviation::Line::new(end, 32).unwrap();
        prop_assert!(soft.take(CYCLES).eq(hard.cycles().take(CYCLES)));
        let end = [end[0], end[1]];
        let soft = soft_comparison::Line::new(end).unwrap();
        let hard = comparison::Line::new(end, 32).unwrap();
        prop_assert!(soft.take(CYCLES).eq(hard.cycles().take(CYCLES)));
    }
}
