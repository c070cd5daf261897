//! The machines at full width, against the formulas of this crate.
#![allow(clippy::unwrap_used)]

use onepulse_core::dda::{self, Preset, Radix, Register};
use onepulse_core::{Direction, EndRule, Pulse, brm, ppc};
use onepulse_verify::{brm_line, dda_line, ppc_arc, ppc_line};
use proptest::prelude::*;

/// Cycles that are followed where a whole run would take too long.
const CYCLES: usize = 3000;

fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        4 => any::<i32>(),
        2 => -2000..=2000,
        1 => prop::sample::select(vec![i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX]),
    ]
}

fn positions<const N: usize>(
    cycles: impl Iterator<Item = Pulse<N>>,
) -> impl Iterator<Item = [i64; N]> {
    cycles.scan([0; N], |position, pulse| {
        for axis in 0..N {
            position[axis] += i64::from(pulse.0[axis]);
        }
        Some(*position)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn ppc_lines(end in [coordinate(), coordinate()]) {
        let line = ppc::Line::new(end, EndRule::Total).unwrap();
        let length = u64::from(end[0].unsigned_abs()) + u64::from(end[1].unsigned_abs());
        prop_assert_eq!(line.remaining(), length);
        let walked = positions(line).take(CYCLES);
        prop_assert!(walked.eq(ppc_line::path(end).take(CYCLES)));
    }

    #[test]
    fn dda_lines_of_three_axes(
        end in [coordinate(), coordinate(), coordinate()],
        extra in 0..4_u32,
        load in 0..3_usize,
        normalize: bool,
    ) {
        let largest = end.iter().map(|c| c.unsigned_abs()).max().unwrap();
        let narrowest = Register::holding(Radix::Binary, largest);
        let bits = (narrowest.digits() + extra).min(32);
        let register = Register::new(Radix::Binary, bits).unwrap();
        let preset = [Preset::Zero, Preset::Half, Preset::Full][load];
        let begun = [0, 1 << (bits - 1), (1 << bits) - 1][load];
        let line = dda::Line::new(end, register, preset, normalize).unwrap();
        let shift = if normalize && largest > 0 { largest.leading_zeros() - (32 - bits) } else { 0 };
        prop_assert_eq!(line.remaining(), 1 << (bits - shift));
        for (k, point) in (1_u64..).zip(positions(line).take(CYCLES)) {
            for axis in 0..3 {
                let integrand = u64::from(end[axis].unsigned_abs()) << shift;
                let due = dda_line::overflows(integrand, begun, 1 << bits, k) as i64;
                prop_assert_eq!(point[axis], due * i64::from(end[axis].signum()));
            }
        }
    }

    #[test]
    fn brm_lines(end in [coordinate(), coordinate()]) {
        let line = brm::Line::new(end, 32).unwrap();
        for (k, point) in (1_u64..).zip(positions(line).take(CYCLES)) {
            for axis in 0..2 {
                let value = u64::from(end[axis].unsigned_abs());
                let due = brm_line::pulses(value, 32, k) as i64;
                prop_assert_eq!(point[axis], due * i64::from(end[axis].signum()));
            }
        }
    }

    /// Full circles and quarter circles of a large radius, through all crossings.
    #[test]
    fn ppc_circles(radius in 1..3000_i32, quadrant in 0..4_usize, ends in 0..4_usize, ccw: bool) {
        let direction = if ccw { Direction::Ccw } else { Direction::Cw };
        let points = [[radius, 0], [0, radius], [-radius, 0], [0, -radius]];
        let (start, end) = (points[quadrant], points[ends]);
        let arc = ppc::Arc::new(start, end, direction, EndRule::Total).unwrap();
        let [x, y] = start.map(i64::from);
        let walked = positions(arc).map(|p| [p[0] + x, p[1] + y]);
        prop_assert!(walked.eq(ppc_arc::path(start, end, direction)));
    }

    /// The largest circles there are: the first steps, within one pulse, and no overflow.
    #[test]
    fn the_largest_arcs(start in [coordinate(), coordinate()], end in [coordinate(), coordinate()], ccw: bool) {
        let direction = if ccw { Direction::Ccw } else { Direction::Cw };
        let square = |[x, y]: [i128; 2]| x * x + y * y;
        let r2 = square(start.map(i128::from));
        let fits = r2 > 0 && r2 <= i128::from(i32::MAX).pow(2);
        let arc = ppc::Arc::new(start, end, direction, EndRule::Total);
        prop_assert_eq!(arc.is_ok(), fits && end != [0, 0]);
        if let Ok(mut arc) = arc {
            let steps = arc.remaining();
            // While no axis stands: (R−1)² ≤ x² + y² ≤ (R+1)², that is (d − 1)² ≤ 4R² for the
            // difference d of the squares, where d > 1.
            for k in 1..=CYCLES.min(steps as usize) {
                arc.step().unwrap();
                prop_assert_eq!(arc.remaining(), steps - k as u64);
                if arc.sweep().stands(arc.position()) == [false, false] {
                    let difference = (square(arc.position().map(i128::from)) - r2).abs();
                    prop_assert!(difference <= 1 || (difference - 1).pow(2) <= 4 * r2);
                }
            }
        }
        let bits = dda::CentredArc::bits(start, end, direction).unwrap_or(0);
        if let Ok(register) = Register::new(Radix::Binary, bits) {
            let mut arc = dda::CentredArc::new(start, end, direction, register, false).unwrap();
            for _ in 0..CYCLES {
                arc.step();
            }
            if arc.sweep().stands(arc.position()) == [false, false] {
                let difference = (square(arc.position().map(i128::from)) - r2).abs();
                prop_assert!(difference <= 1 || (difference - 1).pow(2) <= 4 * r2);
            }
        }
    }
}
