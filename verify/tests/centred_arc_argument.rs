//! The argument for the centred circle (docs/proofs/centred_arc.md), step by step on real circles: that it is
//! about the machine, and the finitely many circles that its inequalities leave out.

use onepulse_core::Direction::{self, Ccw, Cw};
use onepulse_core::dda::{CentredArc, Radix, Register};

/// The machine with no end: half a clock at a time.
#[derive(Clone, Copy)]
struct Circle {
    turn: i64,
    m: i64,
    point: [i64; 2],
    /// The remainder registers, from their middle.
    rest: [i64; 2],
}

impl Circle {
    fn new(start: [i64; 2], direction: Direction, bits: u32) -> Self {
        let turn = if direction == Ccw { 1 } else { -1 };
        Self { turn, m: 1 << bits, point: start, rest: [turn * start[1] / 2, 0] }
    }

    fn integrand(&self, axis: usize) -> i64 {
        if axis == 0 { -self.turn * self.point[1] } else { self.turn * self.point[0] }
    }

    /// Half a clock; the pulse.
    fn half(&mut self, axis: usize) -> i64 {
        let (half, sum) = (self.m / 2, self.rest[axis] + self.integrand(axis));
        let pulse = i64::from(sum >= half) - i64::from(sum < -half);
        self.rest[axis] = sum - pulse * self.m;
        self.point[axis] += pulse;
        pulse
    }

    /// Psi, before the half clock of an axis.
    fn psi(&self, axis: usize) -> i64 {
        let [x, y] = self.point;
        let [a, b] = self.rest;
        let cross = if axis == 0 { -self.turn * x * y } else { self.turn * x * y };
        self.m * (x * x + y * y) + 2 * (a * x + b * y) + cross
    }

    /// The coordinate that falls in this quadrant, and the one that grows.
    fn towards_and_away(&self) -> [i64; 2] {
        let [x, y] = self.point;
        let x_falls = self.turn * x * y > 0 || y == 0;
        if x_falls { [x.abs(), y.abs()] } else { [y.abs(), x.abs()] }
    }
}

fn square(point: [i64; 2]) -> i64 {
    point[0] * point[0] + point[1] * point[1]
}

/// Whether the point is within one pulse of the circle, in integers.
fn is_within_a_pulse(s: i64, r2: i64) -> bool {
    let [below, above] = [r2 + 1 - s, s - r2 - 1];
    [below, above].iter().all(|&d| d <= 0 || d * d <= 4 * r2)
}

/// A full turn and on to the start's direction, no axis standing; each half clock is shown: its axis, the
/// circle before and after, its pulse, and whether a quadrant was entered.
fn turn(mut circle: Circle, mut show: impl FnMut(usize, &Circle, &Circle, i64, bool)) {
    let start = circle.point;
    let mut crossings = 0;
    for clock in 0.. {
        assert!(clock < 16 * circle.m, "{start:?} starves");
        for axis in [0, 1] {
            let before = circle;
            let pulse = circle.half(axis);
            let [x, y] = circle.point;
            let enters = pulse != 0 && circle.point[axis] == 0;
            crossings += i32::from(enters);
            // A start on an axis is met again at the fourth crossing.
            let is_past = circle.turn * (start[0] * y - start[1] * x) > 0;
            if crossings > 4 || crossings == 4 && (start.contains(&0) || is_past) {
                return;
            }
            show(axis, &before, &circle, pulse, enters);
        }
    }
}

#[test]
fn each_step_of_the_argument_on_full_turns() {
    for bits in 6..=11 {
        let m = 1_i64 << bits;
        // Up to the widest circle that leaves the integrands room.
        let radii = [1, 2, 3, m / 32, m / 16, m / 8, m / 4, m / 2 - 2];
        for radius in radii {
            for k in 0..6 {
                let x0 = radius * k / 6;
                let y0 = ((radius * radius - x0 * x0) as f64).sqrt() as i64;
                for start in [[x0, y0], [-y0, x0], [-x0, -y0], [y0, -x0]] {
                    for direction in [Ccw, Cw] {
                        follow(Circle::new(start, direction, bits));
                    }
                }
            }
        }
    }
}

fn follow(circle: Circle) {
    let (start, m) = (circle.point, circle.m);
    let r2 = square(start);
    let slack = start[0].abs();
    assert!((circle.psi(0) - m * r2).abs() <= slack);
    let mut n = 0;
    let mut bound = start[0].abs().max(start[1].abs());
    let mut entered = (0, circle.towards_and_away());
    turn(circle, |axis, before, after, pulse, enters| {
        let d = before.integrand(axis);
        let change = after.psi(1 - axis) - before.psi(axis);
        assert_eq!(change, pulse * (2 * before.rest[axis] + d) - m * pulse * pulse);
        assert!(change.abs() <= d.abs() && (pulse == 0 || pulse == d.signum()));
        n += d.abs() * pulse.abs();
        let psi = after.psi(1 - axis);
        assert!((psi - m * r2).abs() <= n + slack);

        let [x, y] = after.point;
        bound = bound.max(x.abs()).max(y.abs());
        let (ns, [t1, a1]) = entered;
        let [t, a] = if enters { [0, x.abs() + y.abs()] } else { after.towards_and_away() };
        assert!(n <= ns + t * a - t1 * a1 + 2 * bound * (t1 - t));
        if enters {
            entered = (n, after.towards_and_away());
        }
        let s = square(after.point);
        let cross = (x * y).abs();
        assert!(m * (s - r2).abs() <= m * (x.abs() + y.abs()) + cross + n + slack);
        if is_within_a_pulse(s, r2) {
            assert!(n <= 8 * bound * bound + 2 * bound, "{start:?} {m}");
        }
        if 16 * 16 * r2 <= m * m {
            assert!(is_within_a_pulse(s, r2), "{start:?} {m}");
        }
    });
}

/// From R² on, the lemmas cover the registers with k·R <= 2^n.
const COVERED: [(i64, i64); 5] = [(16, 1030), (32, 14), (64, 4), (128, 2), (256, 1)];

#[test]
fn the_circles_that_the_lemmas_leave_out() {
    let mut count = 0;
    for bits in 4..=10 {
        let m = 1_i64 << bits;
        for start in lattice(1029) {
            let r2 = square(start);
            let serves = |k: i64| k * k * r2 <= m * m;
            if !serves(16) || COVERED.iter().any(|&(k, from)| serves(k) && r2 >= from) {
                continue;
            }
            count += 1;
            for direction in [Ccw, Cw] {
                turn(Circle::new(start, direction, bits), |_, _, after, _, _| {
                    let s = square(after.point);
                    assert!(s > 0 && is_within_a_pulse(s, r2), "{start:?} {bits}");
                });
            }
        }
    }
    assert_eq!(count, 3296);
}

fn lattice(largest: i64) -> impl Iterator<Item = [i64; 2]> {
    let side = 0..=2 * largest.isqrt();
    let points = side.clone().flat_map(move |x| side.clone().map(move |y| [x, y]));
    let points = points.map(move |point| point.map(|c| c - largest.isqrt()));
    points.filter(move |&point| (1..=largest).contains(&square(point)))
}

#[test]
fn the_machine_without_an_end_is_the_core_s() {
    for bits in 5..=8 {
        let register = Register::new(Radix::Binary, bits).unwrap();
        for start in lattice(1 << (2 * bits - 4)) {
            let start32 = start.map(|c| c as i32);
            for direction in [Ccw, Cw] {
                let mut arc =
                    CentredArc::new(start32, start32, direction, register, false).unwrap();
                let mut circle = Circle::new(start, direction, bits);
                while arc.sweep().stands(arc.position()) == [false; 2] {
                    let pulse = arc.step().unwrap().0.map(i64::from);
                    assert_eq!(pulse, [circle.half(0), circle.half(1)]);
                    assert_eq!(arc.position(), circle.point);
                    let half = 1 << (bits - 1);
                    assert_eq!(arc.remainders().map(|jr| jr as i64 - half), circle.rest);
                }
            }
        }
    }
}
