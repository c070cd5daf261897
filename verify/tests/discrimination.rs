//! Minimum deviation, vector discrimination and comparison integration against closed forms and
//! geometry.
#![allow(clippy::unwrap_used)]

use onepulse_core::{Direction, Pulse, Walk, comparison, minimum_deviation, vector};
use onepulse_verify::step_lines;
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
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn lines_of_least_deviation(end in [coordinate(), coordinate(), coordinate()]) {
        let line = minimum_deviation::Line::new(end).unwrap();
        let longest = end.iter().map(|c| u64::from(c.unsigned_abs())).max().unwrap();
        prop_assert_eq!(line.remaining(), longest);
        for (k, point) in (1_u64..).zip(positions(line).take(CYCLES)) {
            prop_assert_eq!(point, step_lines::nearest(end, k));
        }
    }

    #[test]
    fn lines_by_vectors(end in [coordinate(), coordinate()]) {
        let line = vector::Line::new(end).unwrap();
        for (k, point) in (1_u64..).zip(positions(line).take(CYCLES)) {
            prop_assert_eq!(point, step_lines::by_vectors(end, k));
        }
    }

    #[test]
    fn lines_by_intervals(end in [coordinate(), coordinate()]) {
        let line = comparison::Line::new(end).unwrap();
        prop_assert!(positions(line).take(CYCLES).eq(step_lines::by_intervals(end).take(CYCLES)));
    }
}

/// A pulse, whether F alone decided it, and the place after it.
type Step = (Pulse, bool, Walk);

/// An arc of one of the methods, step by step.
type Steps = Box<dyn Iterator<Item = Step>>;

type Arc = fn([i32; 2], [i32; 2], Direction) -> Steps;

const ARCS: [(Arc, &str); 3] =
    [(nearest, "minimum deviation"), (by_vectors, "vector"), (by_intervals, "comparison")];

macro_rules! steps {
    ($name:ident, $machine:ty) => {
        fn $name(start: [i32; 2], end: [i32; 2], direction: Direction) -> Steps {
            let mut arc = <$machine>::new(start, end, direction).unwrap();
            Box::new(std::iter::from_fn(move || {
                let is_free = arc.walk().is_free();
                arc.step().map(|pulse| (pulse, is_free, *arc.walk()))
            }))
        }
    };
}
steps!(nearest, minimum_deviation::Arc);
steps!(by_vectors, vector::Arc);
steps!(by_intervals, comparison::Arc);

/// Whether a point is within the bound of its method from the circle.
fn is_within(method: usize, [x, y]: [i64; 2], radius_squared: i64) -> bool {
    let [x, y] = [x, y].map(|c| i128::from(c.abs()));
    let off = (x * x + y * y - i128::from(radius_squared)).abs();
    match method {
        // Half a pulse inside, and 1/(8R) more outside.
        0 => off <= x.max(y),
        // One pulse: (R − 1)² ≤ x² + y² ≤ (R + 1)², that is (x² + y² − R² − 1)² ≤ 4R².
        1 => {
            let inner = x * x + y * y - i128::from(radius_squared) - 1;
            inner * inner <= 4 * i128::from(radius_squared)
        }
        _ => off <= x + y,
    }
}

/// Towards the y axis in the first quadrant, the i-th pulse of x is due in the middle of an interval
/// t₀ − i + ½ after those before it, the j-th of y in the middle of one of a₀ + j − ½: times four, whole
/// numbers.
#[test]
fn quadrants_by_intervals_have_their_pulses_when_due() {
    for [t, a] in (1..60_i64).flat_map(|t| (0..60).map(move |a| [t, a])) {
        let due = |first: i64, by: i64| {
            let mut past = 0;
            (0..).map(move |count: i64| {
                let interval = 2 * (first + by * count) + by;
                let middle = 2 * past + interval;
                past += interval;
                middle
            })
        };
        let (mut x, mut y) = (due(t, -1).peekable(), due(a, 1).peekable());
        let mut at = [t, a];
        let turn = [-(a as i32), t as i32];
        for (_, _, walk) in by_intervals([t as i32, a as i32], turn, Direction::Ccw) {
            // The first quadrant alone, before the axis is reached.
            if at[0] == 0 {
                break;
            }
            let first = *x.peek().min(y.peek()).unwrap();
            if x.next_if_eq(&first).is_some() {
                at[0] -= 1;
            }
            if y.next_if_eq(&first).is_some() {
                at[1] += 1;
            }
            assert_eq!(walk.position(), at, "from {t},{a}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(3000) })]

    /// Also where the end point is off the circle, as in a program rounded to pulses.
    #[test]
    fn arcs_end_exactly(
        start in [-3000..3000_i32, -3000..3000_i32],
        off in [-2..=2_i32, -2..=2_i32],
        turn in 0.0..std::f64::consts::TAU,
        clockwise: bool,
    ) {
        prop_assume!(start != [0, 0]);
        let direction = if clockwise { Direction::Cw } else { Direction::Ccw };
        let radius = f64::from(start[0]).hypot(f64::from(start[1]));
        let end = [radius * turn.cos(), radius * turn.sin()].map(|c| c.round() as i32);
        let end = [end[0] + off[0], end[1] + off[1]];
        prop_assume!(end != [0, 0]);
        let radius_squared = (start[0].pow(2) + start[1].pow(2)).into();
        for (method, (steps, name)) in ARCS.iter().enumerate() {
            let mut at = start.map(i64::from);
            for (Pulse([dx, dy]), is_free, _) in steps(start, end, direction) {
                at = [at[0] + i64::from(dx), at[1] + i64::from(dy)];
                if is_free {
                    prop_assert!(is_within(method, at, radius_squared), "{}: {:?}", name, at);
                }
            }
            prop_assert_eq!(at, end.map(i64::from), "{}", name);
        }
    }

    #[test]
    fn arcs_of_any_size_keep_within_their_bounds(
        // The largest circles there are, and any that fits for sure.
        start in prop_oneof![
            1 => prop::sample::select(vec![[i32::MAX, 0], [0, -i32::MAX]]),
            9 => [coordinate(), coordinate()].prop_map(|start| start.map(|c| c >> 1)),
        ],
        clockwise: bool,
    ) {
        prop_assume!(start != [0, 0]);
        let squared = start.map(|c| i64::from(c) * i64::from(c));
        let direction = if clockwise { Direction::Cw } else { Direction::Ccw };
        for (method, (steps, name)) in ARCS.iter().enumerate() {
            let mut at = start.map(i64::from);
            for (Pulse([dx, dy]), _, _) in steps(start, start, direction).take(CYCLES) {
                at = [at[0] + i64::from(dx), at[1] + i64::from(dy)];
                prop_assert!(is_within(method, at, squared[0] + squared[1]), "{}: {:?}", name, at);
            }
        }
    }
}
