//! Whole programs: speeds at corners against an independent plan that knows the whole program, and the
//! samples of the motion against the limits.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use onepulse_core::{Direction, Plane};
use onepulse_plan::centre_path::{CentrePath, Compensation};
use onepulse_plan::speed::{AHEAD, Block, Limits, LookAhead, Path, Profile, Sample, Samples};
use onepulse_plan::{Curve, Machine, Motion, Rate, Tools, gcode::Program};
use proptest::prelude::*;
use std::cell::Cell;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::time::Duration;

const ACCELERATION: f64 = 1000.0;
const JERK: f64 = 2e4;
const CORNER: f64 = 5.0;

fn limits(jerk: Option<f64>) -> Limits {
    Limits::new(ACCELERATION, jerk, CORNER, 500.0).unwrap()
}

/// What the test knows of a block: the numbers that it made it of.
#[derive(Clone, Copy, Debug)]
struct Made {
    length: f64,
    steady: f64,
    start: [f64; 3],
    end: [f64; 3],
}

impl Made {
    fn block(&self) -> Block {
        Block::new(self.length, self.steady, self.start, self.end).unwrap()
    }
}

/// Numbers from 0 to 1 (SplitMix64).
struct Chance(u64);

impl Chance {
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / 2_f64.powi(53)
    }

    /// A number of any magnitude between two powers of ten.
    fn magnitude(&mut self, from: f64, to: f64) -> f64 {
        10_f64.powf(from + (to - from) * self.share())
    }
}

/// A program in stretches: of long blocks, of any, or of very short ones as free curves have them; with
/// tangent corners, slight and sharp ones and reversals; lines and arcs.
fn program(blocks: usize, seed: u64) -> Vec<Made> {
    let mut chance = Chance(seed);
    // Its plane is turned about x: by no angle at all, or by any.
    let tilt = (seed % 4) as f64;
    let direction =
        |heading: f64| [heading.cos(), heading.sin() * tilt.cos(), heading.sin() * tilt.sin()];
    let mut heading: f64 = 0.0;
    let mut made = Vec::with_capacity(blocks);
    let (mut stretch, mut kind) = (0, 0);
    while made.len() < blocks {
        if stretch == 0 {
            stretch = 50 + (chance.share() * 400.0) as usize;
            kind = (chance.share() * 3.0) as u8;
        }
        stretch -= 1;
        let length = match kind {
            0 => chance.magnitude(0.0, 2.0),
            1 => chance.magnitude(-6.0, 1.0),
            _ => chance.magnitude(-3.0, -1.0),
        };
        let steady = if kind == 2 { 80.0 } else { chance.magnitude(0.0, 2.5) };
        let sharpness = chance.share() * if kind == 2 { 0.81 } else { 1.0 };
        heading += match sharpness {
            0.0..0.5 => 0.0,
            0.5..0.8 => (chance.share() - 0.5) * 0.1,
            0.8..0.95 => (chance.share() - 0.5) * TAU,
            _ => PI,
        };
        let start = direction(heading);
        if chance.share() < 0.2 {
            heading += (chance.share() - 0.5) * TAU;
        }
        made.push(Made { length, steady, start, end: direction(heading) });
    }
    made
}

fn planned(program: &[Made], jerk: Option<f64>) -> Vec<Profile> {
    LookAhead::new(program.iter().map(Made::block), limits(jerk)).collect()
}

/// The speeds at all corners, both ends of the program included.
fn speeds(profiles: &[Profile]) -> Vec<f64> {
    profiles.iter().map(Profile::entry).chain(profiles.last().map(Profile::exit)).collect()
}

/// The way of a change of speed, phase by phase: the acceleration rises, holds, falls; the mean of the
/// speeds is that of both ends.
fn way(low: f64, high: f64, jerk: Option<f64>) -> f64 {
    let Some(jerk) = jerk else { return (high * high - low * low) / (2.0 * ACCELERATION) };
    if high <= low {
        return 0.0;
    }
    let rising = (ACCELERATION / jerk).min(((high - low) / jerk).sqrt());
    let holding = (high - low - jerk * rising * rising) / (jerk * rising);
    (low + high) / 2.0 * (2.0 * rising + holding.max(0.0))
}

/// Whether `length` is enough from `low`, and from any speed between, to `high`.
fn is_enough(length: f64, low: f64, high: f64, jerk: Option<f64>) -> bool {
    if way(low, high, jerk) > length {
        return false;
    }
    // From a third of it on, the way grows shorter by itself.
    let (mut from, mut to) = (low, (high / 3.0).max(low));
    // The way has one maximum: a third of the interval is left out at a time.
    for _ in 0..if jerk.is_some() && from < to { 60 } else { 0 } {
        let [one, other] = [1.0, 2.0].map(|thirds| from + (to - from) * thirds / 3.0);
        if way(one, high, jerk) < way(other, high, jerk) { from = one } else { to = other }
    }
    way(from, high, jerk) <= length
}

/// The highest speed up to `most` that `length` joins with `low`.
fn reached(length: f64, low: f64, most: f64, jerk: Option<f64>) -> f64 {
    if low >= most || is_enough(length, low, most, jerk) {
        return most;
    }
    let (mut from, mut to) = (low, most);
    for _ in 0..60 {
        let middle = from + (to - from) / 2.0;
        if is_enough(length, low, middle, jerk) { from = middle } else { to = middle }
    }
    from
}

/// The highest speed in the corner before block `k`, as the directions and steady speeds have it.
fn corner(program: &[Made], k: usize) -> f64 {
    if k == 0 || k == program.len() {
        return 0.0;
    }
    let (before, after) = (&program[k - 1], &program[k]);
    let turned =
        (0..3).map(|axis| (after.start[axis] - before.end[axis]).powi(2)).sum::<f64>().sqrt();
    before.steady.min(after.steady).min(CORNER / turned)
}

/// The speeds at all corners with the whole program in sight.
fn optimum(program: &[Made], jerk: Option<f64>) -> Vec<f64> {
    let mut speeds: Vec<f64> = (0..=program.len()).map(|k| corner(program, k)).collect();
    for k in (0..program.len()).rev() {
        speeds[k] = reached(program[k].length, speeds[k + 1], speeds[k], jerk);
    }
    for k in 0..program.len() {
        speeds[k + 1] = reached(program[k].length, speeds[k], speeds[k + 1], jerk);
    }
    speeds
}

fn assert_joined(program: &[Made], profiles: &[Profile], jerk: Option<f64>) {
    assert_eq!(profiles.len(), program.len());
    let speeds = speeds(profiles);
    assert_eq!((speeds[0], speeds[program.len()]), (0.0, 0.0));
    for (k, (made, profile)) in program.iter().zip(profiles).enumerate() {
        assert_eq!(profile.length(), made.length);
        assert_eq!(profile.exit(), speeds[k + 1], "block {k}");
        let again =
            Profile::new(made.length, profile.entry(), profile.exit(), made.steady, &limits(jerk));
        assert_eq!(again, Ok(*profile), "block {k}");
        assert!(profile.peak() <= made.steady, "block {k}");
        if let Some(next) = program.get(k + 1) {
            let [x, y, z] =
                [0, 1, 2].map(|axis| (next.start[axis] - made.end[axis]) * profile.exit());
            assert!(x.hypot(y).hypot(z) <= CORNER * (1.0 + 1e-9), "corner {k}");
        }
    }
}

/// Never over the plan that sees the whole program, and below it only where the blocks ahead are
/// too short to stop in, or after such a place.
fn assert_as_high_as_can_be(program: &[Made], found: &[f64], jerk: Option<f64>) -> usize {
    let optimum = optimum(program, jerk);
    let mut lower = 0;
    for k in 1..program.len() {
        assert!(found[k] <= optimum[k] * (1.0 + 1e-9), "{k}: {} {}", found[k], optimum[k]);
        let can_be = reached(program[k - 1].length, found[k - 1], optimum[k], jerk);
        if found[k] < can_be * (1.0 - 1e-9) {
            let ahead = &program[k..program.len().min(k + AHEAD)];
            let stopped = |exit, made: &Made| reached(made.length, exit, can_be, jerk);
            let stops_from = ahead.iter().rev().fold(0.0, stopped);
            assert!(stops_from < can_be, "{k}: {} of {can_be}", found[k]);
            assert!(found[k] >= stops_from * (1.0 - 1e-9), "{k}: {} {stops_from}", found[k]);
        }
        lower += usize::from(found[k] < optimum[k] * (1.0 - 1e-9));
    }
    lower
}

#[test]
fn a_hundred_thousand_blocks_are_joined_as_fast_as_can_be() {
    let program = program(100_000, 1);
    for jerk in [None, Some(JERK)] {
        let profiles = planned(&program, jerk);
        assert_joined(&program, &profiles, jerk);
        let speeds = speeds(&profiles);
        let lower = assert_as_high_as_can_be(&program, &speeds, jerk);
        // The horizon matters somewhere, but not at many corners; and there is speed.
        assert!((1..5_000).contains(&lower), "{lower}");
        let mean = speeds.iter().sum::<f64>() / speeds.len() as f64;
        assert!(mean > 5.0, "{mean}");
    }
}

/// A stop parts a program: what comes before it and what comes after are planned by themselves.
#[test]
fn a_stop_is_an_end_and_a_start() {
    let program = program(200, 4);
    let stops = [0, 1, 63, 64, 150, 199];
    let stopping = |(k, made): (usize, &Made)| match stops.contains(&k) {
        true => made.block().stopping(),
        false => made.block(),
    };
    for jerk in [None, Some(JERK)] {
        let blocks = program.iter().enumerate().map(stopping);
        let found: Vec<_> = LookAhead::new(blocks, limits(jerk)).collect();
        let mut from = 0;
        let parts = stops.iter().flat_map(|&stop| {
            let part = planned(&program[from..=stop], jerk);
            from = stop + 1;
            part
        });
        assert_eq!(found, parts.collect::<Vec<_>>());
        let through = planned(&program, jerk);
        assert!(stops[..5].iter().all(|&stop| through[stop].exit() > 0.0));
    }
}

/// And wherever it falls in the strides of a long program.
#[test]
fn every_stop_of_a_long_program_is_one() {
    let program = program(3_000, 5);
    for (jerk, every) in [(None, 7), (Some(JERK), 97), (None, 300)] {
        let stops = |k: usize| k % every == every - 1;
        let blocks = program.iter().enumerate();
        let blocks = blocks.map(|(k, made)| match stops(k) {
            true => made.block().stopping(),
            false => made.block(),
        });
        let profiles: Vec<_> = LookAhead::new(blocks, limits(jerk)).collect();
        assert_joined(&program, &profiles, jerk);
        let moving = profiles.iter().enumerate().filter(|(k, profile)| {
            assert!(!stops(*k) || profile.exit() == 0.0, "{k}");
            profile.exit() > 0.0
        });
        assert!(moving.count() > 3_000 - 3_000 / every - 20);
    }
}

/// Every block is known before it is needed, and none much earlier.
#[test]
fn the_look_ahead_holds_as_much_as_it_says() {
    let program = program(2_000, 2);
    let read = Cell::new(0);
    let blocks = program.iter().map(Made::block).inspect(|_| read.set(read.get() + 1));
    let mut given = 0;
    for _ in LookAhead::new(blocks, limits(None)) {
        given += 1;
        assert!(read.get() >= (given + AHEAD).min(program.len()), "{given}: {}", read.get());
        assert!(read.get() < given + 2 * AHEAD, "{given}: {}", read.get());
    }
    assert_eq!((given, read.get()), (program.len(), program.len()));
}

#[test]
fn programs_of_no_block_and_of_one() {
    assert_eq!(planned(&[], None), []);
    assert_eq!(Samples::new(planned(&[], None), 0.01).unwrap().next(), None);
    let one = Made { length: 2.0, steady: 100.0, start: [1.0, 0.0, 0.0], end: [1.0, 0.0, 0.0] };
    let alone = Profile::new(2.0, 0.0, 0.0, 100.0, &limits(Some(JERK))).unwrap();
    assert_eq!(planned(&[one], Some(JERK)), [alone]);
}

fn samples(program: &[Made], jerk: Option<f64>, period: f64) -> Vec<Sample> {
    Samples::new(planned(program, jerk), period).unwrap().collect()
}

/// The records in order: the grid complete, every block's end there and exact, and between records no more
/// than the limits.
fn assert_sampled(program: &[Made], samples: &[Sample], jerk: Option<f64>, period: f64) {
    let (mut ends, mut periods) = (0, 0_u32);
    let (mut time, mut way, mut speed, mut acceleration) = (0.0, 0.0, 0.0, 0.0);
    for sample in samples {
        assert_eq!(sample.block, ends, "{sample:?}");
        assert!(sample.is_on_grid || sample.is_block_end);
        if sample.is_on_grid {
            periods += 1;
            let off = (sample.time - f64::from(periods) * period).abs();
            let allowed = if sample.is_block_end { 1.01e-6 * period } else { 0.0 };
            assert!(off <= allowed, "{sample:?} is off the grid by {off}");
        }
        let dt = sample.time - time;
        // The times are rounded, and so differences of them.
        let rounding = 4.0 * f64::EPSILON * sample.time;
        assert!(dt > -rounding, "{sample:?}");
        let limit = ACCELERATION * (dt * (1.0 + 1e-6) + rounding) + 1e-12 * speed;
        assert!((sample.speed - speed).abs() <= limit, "{sample:?} after {speed} mm/s");
        if let Some(jerk) = jerk {
            let limit = jerk * (dt * (1.0 + 1e-6) + rounding) + 1e-9;
            assert!((sample.acceleration - acceleration).abs() <= limit, "{sample:?}");
        }
        assert!(sample.way >= way - 1e-12, "{sample:?}");
        assert!(sample.speed <= program[ends].steady);
        let most = (sample.speed.max(speed) + ACCELERATION * dt) * (dt + rounding) + 1e-12;
        assert!(sample.way - way <= most, "{sample:?}");
        (time, way, speed, acceleration) =
            (sample.time, sample.way, sample.speed, sample.acceleration);
        if sample.is_block_end {
            assert_eq!(sample.way, program[ends].length, "{sample:?}");
            ends += 1;
            way = 0.0;
        }
    }
    assert_eq!(ends, program.len());
    assert_eq!(speed, 0.0);
    assert_eq!(f64::from(periods), (time / period + 1e-6).floor());
}

#[test]
fn samples_keep_the_limits_and_every_end() {
    let program = program(5_000, 3);
    for jerk in [None, Some(JERK)] {
        for period in [0.008, 0.001] {
            assert_sampled(&program, &samples(&program, jerk, period), jerk, period);
        }
    }
}

/// The textbook's increments: a·T more each period, then the steady speed, then a·T less.
#[test]
fn a_line_runs_by_the_textbook_s_increments() {
    let line = Made { length: 20.0, steady: 100.0, start: [1.0, 0.0, 0.0], end: [1.0, 0.0, 0.0] };
    let period = 0.008;
    let samples = samples(&[line], None, period);
    // 0.1 s and 5 mm up and down, 10 mm at 100 mm/s: 0.3 s.
    assert_eq!(samples.len(), 38);
    for (k, sample) in samples[..37].iter().enumerate() {
        assert!(sample.is_on_grid && !sample.is_block_end);
        let time = (k + 1) as f64 * period;
        let (speed, way) = if time <= 0.1 {
            (ACCELERATION * time, ACCELERATION * time * time / 2.0)
        } else if time <= 0.2 {
            (100.0, 5.0 + 100.0 * (time - 0.1))
        } else {
            let left = 0.3 - time;
            (ACCELERATION * left, 20.0 - ACCELERATION * left * left / 2.0)
        };
        assert!((sample.speed - speed).abs() < 1e-9, "{sample:?} {speed}");
        assert!((sample.way - way).abs() < 1e-9, "{sample:?} {way}");
    }
    let end = samples[37];
    assert!(end.is_block_end && !end.is_on_grid);
    assert_eq!((end.way, end.speed, end.acceleration), (20.0, 0.0, -ACCELERATION));
    assert!((end.time - 0.3).abs() < 1e-12);
}

/// Tangent blocks are one to the speed: nothing dips where one ends within a period.
#[test]
fn the_speed_does_not_dip_from_block_to_block() {
    let made = Made { length: 0.77, steady: 100.0, start: [0.6, 0.0, 0.8], end: [0.6, 0.0, 0.8] };
    let program = [made; 100];
    let samples = samples(&program, None, 0.008);
    let steady = samples.iter().filter(|sample| (7..93).contains(&sample.block));
    assert!(steady.clone().count() > 86);
    assert!(steady.into_iter().all(|sample| sample.speed == 100.0 && sample.acceleration == 0.0));
}

/// A period that ends where a block does is one record, not two.
#[test]
fn an_end_on_the_grid_is_one_record() {
    // 0.1 s up, 0.1 s on, 0.1 s down.
    let line = Made { length: 20.0, steady: 100.0, start: [1.0, 0.0, 0.0], end: [1.0, 0.0, 0.0] };
    let samples = samples(&[line; 3], None, 0.1);
    // The three are one line of 60 mm, which takes 0.7 s: blocks end after 0.25, 0.45 and 0.7 s.
    let ends: Vec<_> =
        samples.iter().map(|sample| (sample.is_on_grid, sample.is_block_end)).collect();
    let (on, end, both) = ((true, false), (false, true), (true, true));
    assert_eq!(ends, [on, on, end, on, on, end, on, on, both]);
}

/// At rest before, between and after two lines of 0.3 s, on one grid of periods.
#[test]
fn the_periods_run_on_through_dwells() {
    let line = Made { length: 20.0, steady: 100.0, start: [1.0, 0.0, 0.0], end: [1.0, 0.0, 0.0] };
    let lines = [line.block().stopping(), line.block()];
    let lines: Vec<_> = LookAhead::new(lines, limits(None)).collect();
    let [before, between, after] =
        [50, 250, 100].map(|ms| Profile::standing(Duration::from_millis(ms)));
    let profiles = [before, lines[0], between, lines[1], after];
    let samples: Vec<_> = Samples::new(profiles, 0.1).unwrap().collect();
    let (on, end, both) = ((true, false), (false, true), (true, true));
    let expected = [
        (0.05, 0, end, 0.0, 0.0),
        (0.1, 1, on, 50.0, 1.25),
        (0.2, 1, on, 100.0, 10.0),
        (0.3, 1, on, 50.0, 18.75),
        (0.35, 1, end, 0.0, 20.0),
        (0.4, 2, on, 0.0, 0.0),
        (0.5, 2, on, 0.0, 0.0),
        (0.6, 2, both, 0.0, 0.0),
        (0.7, 3, on, 100.0, 5.0),
        (0.8, 3, on, 100.0, 15.0),
        (0.9, 3, both, 0.0, 20.0),
        (1.0, 4, both, 0.0, 0.0),
    ];
    assert_eq!(samples.len(), expected.len());
    for (sample, (time, block, ends, speed, way)) in samples.iter().zip(expected) {
        assert_eq!((sample.block, (sample.is_on_grid, sample.is_block_end)), (block, ends));
        let near = |found: f64, due: f64| (found - due).abs() < 1e-9;
        assert!(near(sample.time, time) && near(sample.speed, speed), "{sample:?}");
        assert!(near(sample.way, way), "{sample:?}");
        assert!(block % 2 == 1 || sample.speed == 0.0 && sample.acceleration == 0.0, "{sample:?}");
    }
}

#[test]
fn a_full_circle_keeps_its_radius_and_the_centripetal_limit() {
    let machine = Machine::with_pulse("0.001".parse().unwrap());
    let limits = limits(Some(JERK));
    let motion = Motion {
        line: 1,
        from: [15_000, 0, 0],
        to: [15_000, 0, 0],
        curve: Curve::Arc { plane: Plane::Xy, centre: [10_000, 0], direction: Direction::Ccw },
        rate: Rate::Feed("6000".parse().unwrap()),
    };
    let path = Path::of(&motion, machine.pulse).unwrap();
    let block = Block::of(&motion, &machine, &limits).unwrap();
    assert!((block.length() - 10.0 * PI).abs() < 1e-9);
    let samples: Vec<_> = Samples::new(LookAhead::new([block], limits), 0.004).unwrap().collect();
    // √(500·5) = 50 mm/s, of 100 commanded.
    let fastest = samples.iter().map(|sample| sample.speed).fold(0.0, f64::max);
    assert_eq!(fastest, 50.0);
    let mut angle = 0.0;
    let mut last: [f64; 2] = [5.0, 0.0];
    for sample in &samples {
        let [x, y, _] = path.point(sample.way);
        let seen = [x - 10.0, y];
        assert!((seen[0].hypot(seen[1]) - 5.0).abs() < 1e-9);
        angle +=
            (last[0] * seen[1] - last[1] * seen[0]).atan2(last[0] * seen[0] + last[1] * seen[1]);
        assert!((angle * 5.0 - sample.way).abs() < 1e-9);
        last = seen;
    }
    assert_eq!(path.point(samples[samples.len() - 1].way), [15.0, 0.0, 0.0]);
}

/// From the text of a program to points: the corner is a point of its own and slow, the tangent one is
/// passed at speed.
#[test]
fn a_program_is_sampled_through_its_corners() {
    let machine = Machine::with_pulse("0.001".parse().unwrap());
    let limits = limits(None);
    let text = "G91 G01 F3000\nX10.\nG03 X5. Y5. J5.\nG01 X10.\n";
    let program = Program::new(text.as_bytes(), &machine, &Tools::Unknown);
    let path = CentrePath::new(program, &machine, Compensation::default());
    let motions: Vec<_> = path.motions().collect::<Result<_, _>>().unwrap();
    let paths: Vec<_> =
        motions.iter().map(|motion| Path::of(motion, machine.pulse).unwrap()).collect();
    let blocks = motions.iter().map(|motion| Block::of(motion, &machine, &limits).unwrap());
    let samples: Vec<_> = Samples::new(LookAhead::new(blocks, limits), 0.008).unwrap().collect();
    let ends: Vec<_> = samples.iter().filter(|sample| sample.is_block_end).collect();
    let points: Vec<_> = ends.iter().map(|end| paths[end.block].point(end.way)).collect();
    assert_eq!(points, [[10.0, 0.0, 0.0], [15.0, 5.0, 0.0], [25.0, 5.0, 0.0]]);
    assert_eq!(ends[0].speed, 50.0);
    // A right angle: the velocity jumps by √2 of the speed.
    assert!((ends[1].speed - CORNER / 2_f64.sqrt()).abs() < 1e-9);
    assert_eq!(ends[2].speed, 0.0);
    assert!((ends[1].way - 5.0 * FRAC_PI_2).abs() < 1e-9);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(100) })]

    #[test]
    fn any_program_is_joined_and_sampled(
        blocks in 1..800_usize,
        seed: u64,
        jerk in prop::option::of(2.0..8.0_f64),
    ) {
        let jerk = jerk.map(|digits| 10_f64.powf(digits));
        let program = program(blocks, seed);
        let profiles = planned(&program, jerk);
        assert_joined(&program, &profiles, jerk);
        assert_as_high_as_can_be(&program, &speeds(&profiles), jerk);
        assert_sampled(&program, &samples(&program, jerk, 0.01), jerk, 0.01);
    }

    /// Blocks so short that a change of speed is a few roundings.
    #[test]
    fn the_shortest_blocks_are_joined(seed: u64, is_smooth: bool) {
        let jerk = is_smooth.then_some(1e6);
        let mut chance = Chance(seed);
        let program: Vec<_> = (0..1000).map(|_| Made {
            length: if chance.share() < 0.1 { 10.0 } else { chance.magnitude(-12.0, -8.0) },
            steady: 1000.0,
            start: [1.0, 0.0, 0.0],
            end: if chance.share() < 0.01 { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] },
        }).collect();
        assert_joined(&program, &planned(&program, jerk), jerk);
    }

    /// A program that ends less than a rounding of the speed behind the first horizon: all is planned
    /// again, and comes out nearly the same.
    #[test]
    fn plans_that_differ_by_roundings_are_joined(seed: u64, is_smooth: bool, tail in 1..8_usize) {
        let jerk = is_smooth.then_some(1e12);
        let mut chance = Chance(seed);
        let program: Vec<_> = (0..2 * AHEAD + tail).map(|k| Made {
            length: if k >= 2 * AHEAD {
                1e-12
            } else if k == 0 || chance.share() < 0.1 {
                chance.magnitude(3.0, 6.0)
            } else {
                chance.magnitude(-11.0, -7.0)
            },
            steady: 1e6,
            start: [1.0, 0.0, 0.0],
            end: [1.0, 0.0, 0.0],
        }).collect();
        assert_joined(&program, &planned(&program, jerk), jerk);
    }
}
