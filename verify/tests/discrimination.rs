//! Minimum deviation, vector discrimination and comparison integration against closed forms and
//! geometry.
#![allow(clippy::unwrap_used)]

use onepulse_core::{Direction, Pulse, Walk, comparison, minimum_deviation, vector};
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

/// k·b/a to the nearest whole number, the lower one of two.
fn rounded(k: u64, b: u64, a: u64) -> u64 {
    let twice = 2 * u128::from(k) * u128::from(b);
    let a = u128::from(a);
    ((twice + a - 1) / (2 * a)) as u64
}

/// What axis `axis` of a line has after `k` steps, by the nearest point and by the first one not short.
fn along<const N: usize>(end: [i32; N], k: u64, count: impl Fn(u64, u64, u64) -> u64) -> [i64; N] {
    let magnitude = end.map(|c| u64::from(c.unsigned_abs()));
    let longest = *magnitude.iter().max().unwrap();
    std::array::from_fn(|axis| {
        i64::from(end[axis].signum()) * count(k, magnitude[axis], longest) as i64
    })
}

/// The points of a line by comparison integration, from the times of its pulses: the i-th of x at
/// (2i − 1)·|y_e|/2, the j-th of y at (2j − 1)·|x_e|/2.
fn compared(end: [i32; 2]) -> impl Iterator<Item = [i64; 2]> {
    let [xe, ye] = end.map(|c| u64::from(c.unsigned_abs()));
    let (mut i, mut j) = (0, 0);
    std::iter::from_fn(move || {
        let next = |count: u64, most: u64, interval: u64| {
            (count < most).then(|| u128::from(2 * count + 1) * u128::from(interval))
        };
        let (x, y) = (next(i, xe, ye), next(j, ye, xe));
        let first = x.into_iter().chain(y).min()?;
        i += u64::from(x == Some(first));
        j += u64::from(y == Some(first));
        let [x, y] = end.map(|c| i64::from(c.signum()));
        Some([x * i as i64, y * j as i64])
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
            prop_assert_eq!(point, along(end, k, rounded));
        }
    }

    #[test]
    fn lines_by_vectors(end in [coordinate(), coordinate()]) {
        let line = vector::Line::new(end).unwrap();
        for (k, point) in (1_u64..).zip(positions(line).take(CYCLES)) {
            let expected = along(end, k, |k, b, a| match b {
                0 => 0,
                _ if b == a => k,
                _ => ((u128::from(k) - 1) * u128::from(b) / u128::from(a)) as u64 + 1,
            });
            prop_assert_eq!(point, expected);
        }
    }

    #[test]
    fn lines_by_intervals(end in [coordinate(), coordinate()]) {
        let line = comparison::Line::new(end).unwrap();
        prop_assert!(positions(line).take(CYCLES).eq(compared(end).take(CYCLES)));
    }
}

/// All machines of one kind of curve, and twice, to the 0.0001, what they may be off.
#[test]
fn every_short_line_ends_exactly_within_its_bound() {
    let mut worst = [0.0_f64; 3];
    for (x, y) in (-40..=40_i32).flat_map(|x| (-40..=40).map(move |y| (x, y))) {
        let end = [x, y];
        let [a, b] = [x.abs().max(y.abs()), x.abs().min(y.abs())].map(f64::from);
        let length = a.hypot(b);
        let paths: [Vec<[i64; 2]>; 3] = [
            positions(minimum_deviation::Line::new(end).unwrap()).collect(),
            positions(vector::Line::new(end).unwrap()).collect(),
            positions(comparison::Line::new(end).unwrap()).collect(),
        ];
        // Times the length, from the documentation of each.
        let bounds = [a / 2.0, (a - b).max(b - 1.0), (a + b - 1.0) / 2.0];
        for (method, path) in paths.iter().enumerate() {
            assert_eq!(path.last().copied().unwrap_or([0, 0]), end.map(i64::from));
            for [px, py] in path {
                let off = (i64::from(x) * py - i64::from(y) * px).abs() as f64;
                assert!(off <= bounds[method], "{end:?}, method {method}: {off}/{length}");
                if length > 0.0 {
                    worst[method] = worst[method].max(off / length);
                }
            }
        }
        // A pulse of the longer axis on every step.
        assert!(paths[..2].iter().all(|path| path.len() == a as usize));
    }
    // The bounds are reached, or nearly: ½ along y is less across the line.
    let [nearest, vectors, intervals] = worst;
    assert!((0.44..=0.5).contains(&nearest), "{nearest}");
    assert!((0.9..1.0).contains(&vectors), "{vectors}");
    assert!((0.69..0.708).contains(&intervals), "{intervals}");
}

/// An arc of one of the methods, step by step.
type Steps = Box<dyn Iterator<Item = (Pulse, Walk)>>;

type Arc = fn([i32; 2], [i32; 2], Direction) -> Steps;

const ARCS: [(Arc, &str); 3] =
    [(nearest, "minimum deviation"), (by_vectors, "vector"), (by_intervals, "comparison")];

macro_rules! steps {
    ($name:ident, $machine:ty) => {
        fn $name(start: [i32; 2], end: [i32; 2], direction: Direction) -> Steps {
            let mut arc = <$machine>::new(start, end, direction).unwrap();
            Box::new(std::iter::from_fn(move || arc.step().map(|pulse| (pulse, *arc.walk()))))
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

fn lattice_points(radius_squared: i32) -> Vec<[i32; 2]> {
    let most = radius_squared.isqrt();
    let all = (-most..=most).flat_map(|x| (-most..=most).map(move |y| [x, y]));
    all.filter(|[x, y]| x * x + y * y == radius_squared).collect()
}

#[test]
fn every_arc_between_points_of_a_small_circle_is_within_its_bound() {
    let mut arcs = 0;
    let mut worst = [0.0_f64; 3];
    for radius_squared in 1..=450 {
        let points = lattice_points(radius_squared);
        for (&start, &end) in points.iter().flat_map(|s| points.iter().map(move |e| (s, e))) {
            for direction in [Direction::Cw, Direction::Ccw] {
                arcs += 1;
                for (method, (steps, name)) in ARCS.iter().enumerate() {
                    let what = || format!("{name}, {start:?} to {end:?}, {direction:?}");
                    let mut at = start.map(i64::from);
                    let mut visited: Vec<[i64; 2]> = vec![];
                    for (Pulse([dx, dy]), walk) in steps(start, end, direction) {
                        at = [at[0] + i64::from(dx), at[1] + i64::from(dy)];
                        assert!(dx != 0 || dy != 0, "{}", what());
                        assert!(is_within(method, at, radius_squared.into()), "{}: {at:?}", what());
                        assert_eq!(walk.position(), at);
                        let radius = (at[0] as f64).hypot(at[1] as f64);
                        let off = (radius - f64::from(radius_squared).sqrt()).abs();
                        worst[method] = worst[method].max(off);
                        visited.push(at);
                    }
                    assert_eq!(at, end.map(i64::from), "{}", what());
                    let is_on = |p: &&[i64; 2]| p[0] * p[0] + p[1] * p[1] == radius_squared.into();
                    let passed: Vec<_> = visited.iter().filter(is_on).collect();
                    let between = passed_between(&points, start, end, direction);
                    assert_eq!(passed.len(), between, "{}", what());
                }
            }
        }
    }
    assert!(arcs > 29_000, "{arcs}");
    let [nearest, vectors, intervals] = worst;
    assert!((0.45..=0.5).contains(&nearest), "{nearest}");
    assert!((0.9..=1.0).contains(&vectors), "{vectors}");
    assert!((0.65..0.71).contains(&intervals), "{intervals}");
}

/// How many of a circle's points lie on the arc, its end included and its start not.
fn passed_between(
    points: &[[i32; 2]],
    start: [i32; 2],
    end: [i32; 2],
    direction: Direction,
) -> usize {
    let turn = |[x, y]: [i32; 2]| {
        let angle = f64::from(y).atan2(f64::from(x)) - f64::from(start[1]).atan2(start[0].into());
        let ahead = if direction == Direction::Ccw { angle } else { -angle };
        let whole = std::f64::consts::TAU;
        // The start itself is a whole turn ahead.
        let ahead = ahead.rem_euclid(whole);
        if ahead < 1e-9 || ahead > whole - 1e-9 { whole } else { ahead }
    };
    points.iter().filter(|point| turn(**point) <= turn(end) + 1e-9).count()
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
        for (_, walk) in by_intervals([t as i32, a as i32], turn, Direction::Ccw) {
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
            let mut is_free = true;
            for (Pulse([dx, dy]), walk) in steps(start, end, direction) {
                at = [at[0] + i64::from(dx), at[1] + i64::from(dy)];
                if is_free {
                    prop_assert!(is_within(method, at, radius_squared), "{}: {:?}", name, at);
                }
                is_free = walk.is_free();
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
            for (Pulse([dx, dy]), _) in steps(start, start, direction).take(CYCLES) {
                at = [at[0] + i64::from(dx), at[1] + i64::from(dy)];
                prop_assert!(is_within(method, at, squared[0] + squared[1]), "{}: {:?}", name, at);
            }
        }
    }
}
