//! Line by comparison integration: C1, N1 for every `i32` end point.
//!
//! D = |y_e| − |x_e| − 2F, F = |y_e|·(pulses of x to go) − |x_e|·(pulses of y to go); the two products are
//! ghosts of [`product`].

use crate::product::product;
use crate::same::same;
use onepulse_core::comparison::Line;

/// The two products of F.
struct Ghost([u64; 2]);

impl Ghost {
    fn difference(&self, [xe, ye]: [i64; 2]) -> i64 {
        // Below 2⁶³ in any state of the line, where it is within a `u32`'s range of 0.
        let f = self.0[0].wrapping_sub(self.0[1]) as i64;
        (ye - xe).wrapping_sub(2_i64.wrapping_mul(f))
    }
}

/// Any state on the line to `end` that satisfies the invariant.
fn any_state(end: [i32; 2]) -> (Line, Ghost) {
    let [xe, ye] = end.map(i32::unsigned_abs);
    let left: [u32; 2] = kani::any();
    let ghost = Ghost([product(ye, left[0]), product(xe, left[1])]);
    let line = Line::in_state(end, ghost.difference([xe, ye].map(i64::from)), left);
    kani::assume(line.invariant());
    (line, ghost)
}

#[kani::proof]
fn comparison_line_new_establishes_invariant() {
    let end: [i32; 2] = kani::any();
    let magnitude = end.map(|c| u64::from(c.unsigned_abs()));
    let Ok(line) = Line::new(end) else { panic!("every end point is served") };
    kani::cover!(end[0] == i32::MIN && end[1] > 0);
    kani::cover!(line.is_done());
    assert!(line.invariant());
    assert!(line.difference() == magnitude[1] as i64 - magnitude[0] as i64);
    assert!(same(line.position(), [0, 0]) && same(line.pulses_to_go(), magnitude));
}

/// A pulse at least, on axes that have some left, and D as it is defined.
#[kani::proof]
fn comparison_line_step_preserves_invariant() {
    let end: [i32; 2] = kani::any();
    let magnitude = end.map(|c| i64::from(c.unsigned_abs()));
    let (mut line, mut ghost) = any_state(end);
    let before = line;
    let Some(pulse) = line.step() else {
        assert!(before.is_done());
        return;
    };
    kani::cover!(pulse.0[0] == 1 && pulse.0[1] == -1);
    kani::cover!(end[0] == 0);
    kani::cover!(line.is_done());
    for axis in 0..2 {
        let feeds = pulse.0[axis] != 0;
        assert!(!feeds || pulse.0[axis] == end[axis].signum() as i8);
        assert!(line.pulses_to_go()[axis] + u64::from(feeds) == before.pulses_to_go()[axis]);
        let taken = if feeds { magnitude[1 - axis] as u64 } else { 0 };
        ghost.0[axis] = ghost.0[axis].wrapping_sub(taken);
    }
    assert!(pulse.0[0] != 0 || pulse.0[1] != 0);
    assert!(line.difference() == ghost.difference(magnitude));
    assert!(line.invariant());
}

/// 2·|F| ≤ |x_e| + |y_e| − 1 off the axes, and 0 on them.
#[kani::proof]
fn comparison_line_invariant_means_deviation() {
    let end: [i32; 2] = kani::any();
    let [xe, ye] = end.map(|c| i64::from(c.unsigned_abs()));
    let (line, _) = any_state(end);
    let twice_f = ye - xe - line.difference();
    kani::cover!(xe > 1 && ye > 1 && twice_f == xe + ye - 1);
    kani::cover!(xe > 1 && ye > 1 && twice_f == 1 - xe - ye);
    assert!(twice_f.abs() < xe + ye || twice_f == 0);
}

#[kani::proof]
fn comparison_line_done_means_end_point() {
    let end: [i32; 2] = kani::any();
    let (line, _) = any_state(end);
    let [x, y] = line.position();
    assert!(same(line.residual(), [i64::from(end[0]) - x, i64::from(end[1]) - y]));
    kani::cover!(line.is_done() && end[0] != 0 && end[1] != 0);
    if line.is_done() {
        assert!(same(line.residual(), [0, 0]));
    }
}
