//! Line by point-by-point comparison: P1, P2, N1 for every `i32` end point.
//!
//! F = |y_e|·(pulses of x to go) − |x_e|·(pulses of y to go) is the invariant that keeps a used up
//! axis from being fed; the two products are the ghosts of [`product`].

use crate::any::any_rule;
use crate::product::product;
use crate::same::same;
use onepulse_core::EndRule;
use onepulse_core::ppc::Line;

/// The pulses of x and y to go, each multiplied by the other axis' end coordinate.
pub(crate) struct Ghost([u64; 2]);

impl Ghost {
    fn deviation(&self) -> i64 {
        // Below 2⁶³ in any state of the line, where F is within an `i32`'s range of 0.
        self.0[0].wrapping_sub(self.0[1]) as i64
    }
}

/// Any state on the line to `end` that satisfies the invariant.
pub(crate) fn any_state(end: [i32; 2], rule: EndRule) -> (Line, Ghost) {
    let [xe, ye] = end.map(i32::unsigned_abs);
    let left: [u32; 2] = kani::any();
    let ghost = Ghost([product(ye, left[0]), product(xe, left[1])]);
    let line = Line::in_state(end, rule, ghost.deviation(), left);
    kani::assume(line.invariant());
    (line, ghost)
}

#[kani::proof]
fn ppc_line_new_establishes_invariant() {
    let end: [i32; 2] = kani::any();
    let [xe, ye] = end.map(i32::unsigned_abs).map(u64::from);
    let rule = any_rule();
    let Ok(line) = Line::new(end, rule) else { panic!("every end point is served") };
    kani::cover!(end[0] == i32::MIN && end[1] < 0);
    assert!(line.invariant());
    assert!(line.deviation_function() == 0);
    assert!(same(line.pulses_to_go(), [xe, ye]));
    assert!(same(line.position(), [0, 0]));
    match rule {
        EndRule::Total | EndRule::PerAxis => assert!(line.remaining() == xe + ye),
        EndRule::Larger => assert!(line.remaining() == xe.max(ye)),
    }
}

/// One step is one pulse on one axis that has some left, F follows it, and stays within its
/// bounds.
#[kani::proof]
fn ppc_line_step_preserves_invariant() {
    let end: [i32; 2] = kani::any();
    let rule = any_rule();
    let [xe, ye] = end.map(|c| i64::from(c.unsigned_abs()));
    let (mut line, mut ghost) = any_state(end, rule);
    let before = line;
    kani::cover!(line.deviation_function() < 0);
    kani::cover!(line.deviation_function() >= 0 && !line.is_done());
    kani::cover!(end[0] == 0 && !line.is_done());

    let Some(pulse) = line.step() else {
        assert!(before.is_done() && same(line.pulses_to_go(), before.pulses_to_go()));
        return;
    };
    assert!(!before.is_done());
    let [left_x, left_y] = before.pulses_to_go();
    let change = if pulse.0[0] != 0 {
        assert!(same(pulse.0, [end[0].signum() as i8, 0]));
        assert!(left_x > 0 && same(line.pulses_to_go(), [left_x - 1, left_y]));
        ghost.0[0] = ghost.0[0].wrapping_sub(ye as u64);
        -ye
    } else {
        assert!(same(pulse.0, [0, end[1].signum() as i8]) && pulse.0[1] != 0);
        assert!(left_y > 0 && same(line.pulses_to_go(), [left_x, left_y - 1]));
        ghost.0[1] = ghost.0[1].wrapping_sub(xe as u64);
        xe
    };
    assert!(line.deviation_function() == before.deviation_function() + change);
    assert!(line.deviation_function() == ghost.deviation());
    assert!(line.invariant());
    match rule {
        EndRule::Total | EndRule::PerAxis => assert!(line.remaining() + 1 == before.remaining()),
        EndRule::Larger => assert!(line.remaining() <= before.remaining()),
    }
}

/// −|y_e| ≤ F ≤ |x_e|, so that |F| ≤ L.
#[kani::proof]
fn ppc_line_invariant_means_deviation() {
    let end: [i32; 2] = kani::any();
    let [xe, ye] = end.map(|c| i64::from(c.unsigned_abs()));
    let (line, _) = any_state(end, any_rule());
    kani::cover!(line.deviation_function() == xe && xe > ye && ye > 0);
    assert!(line.deviation_function().abs() <= xe.max(ye));
}

/// Under the rules that count both axes. Under the third, the larger axis is at its end, x where they
/// are alike, and what the other is missing is told.
#[kani::proof]
fn ppc_line_done_means_end_point() {
    let end: [i32; 2] = kani::any();
    let rule = any_rule();
    let (line, _) = any_state(end, rule);
    let [x, y] = line.position();
    assert!(same(line.residual(), [i64::from(end[0]) - x, i64::from(end[1]) - y]));
    assert!(line.is_done() == (line.remaining() == 0));
    kani::cover!(line.is_done() && end[0] != 0 && end[1] != 0);
    kani::cover!(line.is_done() && !same(line.residual(), [0, 0]));
    if line.is_done() {
        let larger = if end[0].unsigned_abs() >= end[1].unsigned_abs() { 0 } else { 1 };
        assert!(line.residual()[larger] == 0);
        assert!(rule == EndRule::Larger || same(line.residual(), [0, 0]));
    }
}
