//! Every curve of narrow registers, against the formulas of this crate.
#![allow(clippy::unwrap_used)]

use onepulse_core::dda::{self, Preset, Radix, Register};
use onepulse_core::{Direction, EndRule, Pulse, Sweep, brm, ppc};
use onepulse_verify::{brm_line, circles, dda_arc, dda_line, ppc_arc, ppc_line};

const PRESETS: [Preset; 3] = [Preset::Zero, Preset::Half, Preset::Full];
const DIRECTIONS: [Direction; 2] = [Direction::Cw, Direction::Ccw];

fn binary(bits: u32) -> Register {
    Register::new(Radix::Binary, bits).unwrap()
}

fn preset(preset: Preset, modulus: u64) -> u64 {
    match preset {
        Preset::Zero => 0,
        Preset::Half => modulus / 2,
        Preset::Full => modulus - 1,
    }
}

/// The points of a path, cycle by cycle, the start first.
fn path(start: [i64; 2], cycles: impl Iterator<Item = Pulse>) -> Vec<[i64; 2]> {
    let mut point = start;
    let mut path = vec![start];
    for Pulse([dx, dy]) in cycles {
        point = [point[0] + i64::from(dx), point[1] + i64::from(dy)];
        path.push(point);
    }
    path
}

fn radius([x, y]: [i64; 2]) -> f64 {
    ((x * x + y * y) as f64).sqrt()
}

fn points(most: i32) -> impl Iterator<Item = [i32; 2]> {
    (-most..=most).flat_map(move |x| (-most..=most).map(move |y| [x, y]))
}

#[test]
fn every_ppc_line() {
    for end in points(40) {
        let line = ppc::Line::new(end, EndRule::Total).unwrap();
        let walked = path([0, 0], line);
        assert!(walked[1..].iter().copied().eq(ppc_line::path(end)), "{end:?}");
        let same = ppc::Line::new(end, EndRule::PerAxis).unwrap();
        assert!(line.eq(same), "{end:?}");

        // The larger axis' counter alone: exact, but where both axes have the same number.
        let mut larger = ppc::Line::new(end, EndRule::Larger).unwrap();
        while larger.step().is_some() {}
        let [x, y] = end.map(i64::from);
        let expected = if x != 0 && x.abs() == y.abs() { [0, y.signum()] } else { [0, 0] };
        assert_eq!(larger.residual(), expected, "{end:?}");
    }
}

#[test]
fn every_ppc_arc() {
    for (square, circle) in circles(31) {
        let r = (square as f64).sqrt();
        for &start in &circle {
            for &end in &circle {
                for direction in DIRECTIONS {
                    let arc = ppc::Arc::new(start, end, direction, EndRule::Total).unwrap();
                    let walked = path(start.map(i64::from), arc);
                    let expected = ppc_arc::path(start, end, direction);
                    assert_eq!(walked[1..], expected, "{start:?} {end:?} {direction:?}");
                    assert_eq!(arc.remaining() as usize, expected.len());
                    let worst = walked.iter().map(|&p| (radius(p) - r).abs()).fold(0.0, f64::max);
                    assert!(worst <= 1.0, "{start:?} {end:?} {direction:?}: {worst}");
                    let same = ppc::Arc::new(start, end, direction, EndRule::PerAxis).unwrap();
                    assert!(arc.eq(same));
                }
            }
        }
    }
}

#[test]
fn the_larger_counter_leaves_an_arc_short_of_its_end_and_says_so() {
    let mut exact = 0;
    let mut short = 0;
    for circle in circles(12).values() {
        for &start in circle {
            for &end in circle {
                for direction in DIRECTIONS {
                    let full = ppc::Arc::new(start, end, direction, EndRule::Total).unwrap();
                    let [x, y] = full.pulses_to_go();
                    let counted = usize::from(x < y);
                    let mut arc = ppc::Arc::new(start, end, direction, EndRule::Larger).unwrap();
                    // It is the full path, cut off where the counted axis has all its pulses.
                    let cut: Vec<_> = arc.collect();
                    assert!(full.take(cut.len()).eq(cut.iter().copied()));
                    let pulses = cut.iter().filter(|p| p.0[counted] != 0).count();
                    assert_eq!(pulses as u64, x.max(y));
                    while arc.step().is_some() {}
                    assert_eq!(arc.residual()[counted], 0);
                    let rest: i64 = full.skip(cut.len()).map(|p| i64::from(p.0[1 - counted])).sum();
                    assert_eq!(arc.residual()[1 - counted], rest);
                    *(if rest == 0 { &mut exact } else { &mut short }) += 1;
                }
            }
        }
    }
    assert!(exact > 0 && short > 0, "{exact} exact, {short} short");
}

#[test]
fn every_ppc_end_point_off_the_circle() {
    for start in points(6).filter(|p| *p != [0, 0]) {
        for end in points(8).filter(|p| *p != [0, 0]) {
            for direction in DIRECTIONS {
                let mut arc = ppc::Arc::new(start, end, direction, EndRule::Total).unwrap();
                let mut steps = arc.remaining();
                while arc.step().is_some() {
                    steps -= 1;
                    assert_eq!(arc.remaining(), steps);
                }
                assert_eq!(steps, 0);
                assert_eq!(arc.position(), end.map(i64::from), "{start:?} {direction:?}");
            }
        }
    }
}

#[test]
fn every_dda_line() {
    for bits in 1..=5 {
        let modulus = 1_u64 << bits;
        for end in points(modulus as i32 - 1) {
            for load in PRESETS {
                for normalize in [false, true] {
                    check_dda_line(end, binary(bits), load, normalize);
                }
            }
        }
    }
    let decimal = Register::new(Radix::Decimal, 1).unwrap();
    for end in points(9) {
        for load in PRESETS {
            check_dda_line(end, decimal, load, false);
        }
    }
}

fn check_dda_line(end: [i32; 2], register: Register, load: Preset, normalize: bool) {
    let line = dda::Line::new(end, register, load, normalize).unwrap();
    let modulus = register.modulus();
    let largest = u64::from(end[0].unsigned_abs().max(end[1].unsigned_abs()));
    let mut shift = 0;
    while normalize && largest > 0 && (largest << shift) < modulus / 2 {
        shift += 1;
    }
    let walked = path([0, 0], line);
    assert_eq!(walked.len() as u64, (modulus >> shift) + 1, "{end:?} {load:?} {normalize}");
    for (k, point) in walked.iter().enumerate() {
        for axis in 0..2 {
            let integrand = u64::from(end[axis].unsigned_abs()) << shift;
            let begun = preset(load, modulus);
            let due = dda_line::overflows(integrand, begun, modulus, k as u64) as i64;
            assert_eq!(point[axis], due * i64::from(end[axis].signum()), "{end:?} {load:?} {k}");
        }
    }
    assert_eq!(walked.last(), Some(&end.map(i64::from)));
}

#[test]
fn every_textbook_dda_arc() {
    // Worst radial deviation of quarter circles and of all arcs within a quadrant: over one pulse,
    // as this circuit is known for.
    let mut worst = [0.0_f64; 3];
    for bits in 2..=6 {
        for (square, circle) in circles((1 << bits) - 1) {
            let r = (square as f64).sqrt();
            for &start in &circle {
                for &end in &circle {
                    for direction in DIRECTIONS {
                        let crossings = Sweep::new(start, end, direction).unwrap().crossings_left();
                        for (load, worst) in PRESETS.into_iter().zip(&mut worst) {
                            let register = binary(bits);
                            let arc = dda::Arc::new(start, end, direction, register, load, false);
                            // Beyond one quadrant the circle grows out of a register this tight.
                            let Ok(arc) = arc else {
                                assert!(crossings > 0, "{start:?} {end:?} {direction:?}");
                                continue;
                            };
                            let walked = path(start.map(i64::from), arc);
                            assert_eq!(walked.last(), Some(&end.map(i64::from)));
                            if crossings == 0 {
                                let begun = preset(load, register.modulus());
                                let end = end.map(i64::from);
                                let checked = dda_arc::check_textbook(&walked, end, begun, bits, 0);
                                assert_eq!(checked, Ok(()), "{start:?} {end:?} {direction:?}");
                                for &point in &walked {
                                    *worst = (radius(point) - r).abs().max(*worst);
                                }
                            }
                        }
                    }
                }
            }
        }
    }
    let rounded = worst.map(|w| (w * 1000.0).round() / 1000.0);
    assert_eq!(rounded, [1.696, 1.161, 1.056]);
}

#[test]
fn every_centred_dda_arc() {
    let mut arcs = 0_u32;
    let mut worst = [0.0_f64; 2];
    for bits in 2..=7 {
        for (square, circle) in circles((1 << (bits - 1)) - 1) {
            let r = (square as f64).sqrt();
            for &start in &circle {
                for &end in &circle {
                    for direction in DIRECTIONS {
                        let arc = dda::CentredArc::new(start, end, direction, binary(bits), false)
                            .unwrap();
                        let walked = path(start.map(i64::from), arc);
                        let end = end.map(i64::from);
                        assert_eq!(walked.last(), Some(&end));
                        // Where both axes are short of the end, none stands.
                        let may_stand = |p: [i64; 2]| p[0] == end[0] || p[1] == end[1];
                        let checked =
                            dda_arc::check_centred(&walked, direction, bits, 0, may_stand);
                        assert_eq!(checked, Ok(()), "{start:?} {end:?} {direction:?}");
                        for &point in &walked {
                            let worst = &mut worst[usize::from(bits >= 4)];
                            *worst = (radius(point) - r).abs().max(*worst);
                        }
                        arcs += 1;
                    }
                }
            }
        }
    }
    assert_eq!(arcs, 411_424);
    let rounded = worst.map(|w| (w * 1000.0).round() / 1000.0);
    assert_eq!(rounded, [0.828, 0.931]);
}

#[test]
fn a_circle_larger_than_the_headroom_bit_leaves_the_pulse() {
    // R = 31.95: over 2^(n−1) − 1 for n = 6, so it is refused there; with n = 7 it stays within.
    let start = [11, -30];
    let new = |bits| dda::CentredArc::new(start, start, Direction::Cw, binary(bits), false);
    assert!(new(6).is_err());
    let r = radius(start.map(i64::from));
    let walked = path(start.map(i64::from), new(7).unwrap());
    assert!(walked.iter().all(|&p| (radius(p) - r).abs() < 1.0));
}

#[test]
fn normalizing_a_centred_arc_changes_its_speed_alone() {
    // JV·2^Q in n bits overflows exactly when JV does in n − Q bits.
    for (square, circle) in circles(15) {
        // R ≤ 2^(n−1) − 1, by counting up.
        let narrow = (2..).find(|n| square <= ((1_i64 << (n - 1)) - 1).pow(2));
        for &start in &circle {
            for direction in DIRECTIONS {
                let needed = dda::CentredArc::bits(start, start, direction).unwrap();
                assert_eq!(Some(needed), narrow, "{start:?}");
                let plain =
                    dda::CentredArc::new(start, start, direction, binary(needed), false).unwrap();
                let wide = binary(needed + 5);
                let normal = dda::CentredArc::new(start, start, direction, wide, true).unwrap();
                assert_eq!(normal.shift(), 5);
                let (plain, normal) = (path([0, 0], plain), path([0, 0], normal));
                // A start with odd y₀ keeps its half step in the wider register.
                if start[1] % 2 == 0 {
                    assert_eq!(plain, normal, "{start:?}");
                }
            }
        }
    }
}

#[test]
fn every_brm_line() {
    for bits in 1..=6 {
        for end in points((1 << bits) - 1) {
            let line = brm::Line::new(end, bits).unwrap();
            for (k, point) in path([0, 0], line).iter().enumerate() {
                for axis in 0..2 {
                    let value = u64::from(end[axis].unsigned_abs());
                    let due = brm_line::pulses(value, bits, k as u64) as i64;
                    assert_eq!(point[axis], due * i64::from(end[axis].signum()), "{end:?} {k}");
                }
            }
        }
    }
}

#[test]
fn the_rate_multiplier_strays_with_its_width() {
    // x = 1010…b, y = x/2: n·√5/10 from the line.
    for bits in [4, 6, 8, 10] {
        let x = (0..bits).filter(|b| b % 2 == 1).map(|b| 1 << b).sum::<i32>();
        let end = [x, x / 2];
        let line = brm::Line::new(end, bits).unwrap();
        let length = f64::from(end[0]).hypot(f64::from(end[1]));
        let worst = path([0, 0], line)
            .iter()
            .map(|p| (i64::from(end[0]) * p[1] - i64::from(end[1]) * p[0]).abs())
            .max()
            .unwrap();
        let expected = f64::from(bits) * 5_f64.sqrt() / 10.0;
        assert!(
            (worst as f64 / length - expected).abs() < 0.005,
            "{bits}: {}",
            worst as f64 / length
        );
    }
}
