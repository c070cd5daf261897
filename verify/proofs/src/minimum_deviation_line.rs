//! Line by minimum deviation: M1, N1 for every `i32` end point. Each axis is held against the longest
//! one alone, so that two of them stand for any number.
//!
//! d_i = 2·(|e_M|·(pulses of i to go) − |e_i|·(steps to go)); the two products are ghosts of
//! [`product`].

use crate::product::product;
use crate::same::same;
use onepulse_core::minimum_deviation::Line;

/// |e_M|·(pulses to go) and |e_i|·(steps to go) of each axis.
struct Ghost([[u64; 2]; 2]);

impl Ghost {
    fn deviation(&self, axis: usize) -> i64 {
        let [pulses, steps] = self.0[axis];
        // Below 2⁶³ in any state of the line, where it is within a `u32`'s range of 0.
        2_i64.wrapping_mul(pulses.wrapping_sub(steps) as i64)
    }
}

/// Any state on any line that satisfies the invariant.
fn any_state() -> (Line, Ghost, [i32; 2]) {
    let end: [i32; 2] = kani::any();
    let longest: u32 = kani::any_where(|longest: &u32| *longest <= 1 << 31);
    let (left, steps): ([u32; 2], u32) = (kani::any(), kani::any());
    let magnitude = end.map(i32::unsigned_abs);
    let ghost = Ghost([
        [product(longest, left[0]), product(magnitude[0], steps)],
        [product(longest, left[1]), product(magnitude[1], steps)],
    ]);
    let deviation = [ghost.deviation(0), ghost.deviation(1)];
    let line = Line::in_state(end, longest, deviation, left, steps);
    kani::assume(line.invariant());
    (line, ghost, end)
}

#[kani::proof]
fn minimum_deviation_line_new_establishes_invariant() {
    let end: [i32; 2] = kani::any();
    let magnitude = end.map(|c| u64::from(c.unsigned_abs()));
    let Ok(line) = Line::new(end) else { panic!("every end point is served") };
    kani::cover!(end[0] == i32::MIN && end[1] > 0);
    kani::cover!(line.is_done());
    assert!(line.invariant());
    assert!(same(line.deviations(), [0, 0]) && same(line.position(), [0, 0]));
    assert!(same(line.pulses_to_go(), magnitude));
    assert!(line.remaining() == magnitude[0].max(magnitude[1]));
}

/// One step less to go, a pulse taken from the axes that are fed, and d as it is defined.
#[kani::proof]
fn minimum_deviation_line_step_preserves_invariant() {
    let (mut line, mut ghost, end) = any_state();
    let before = line;
    let Some(pulse) = line.step() else {
        assert!(before.is_done());
        return;
    };
    kani::cover!(pulse.0[0] == 0 && pulse.0[1] == -1);
    kani::cover!(line.is_done());
    assert!(line.remaining() + 1 == before.remaining());
    for axis in 0..2 {
        let feeds = pulse.0[axis] != 0;
        assert!(!feeds || pulse.0[axis] == end[axis].signum() as i8);
        assert!(line.pulses_to_go()[axis] + u64::from(feeds) == before.pulses_to_go()[axis]);
        let [pulses, steps] = &mut ghost.0[axis];
        *pulses = pulses.wrapping_sub(if feeds { u64::from(line.longest()) } else { 0 });
        *steps = steps.wrapping_sub(u64::from(end[axis].unsigned_abs()));
        assert!(line.deviations()[axis] == ghost.deviation(axis));
    }
    assert!(line.invariant());
}

/// What an axis is off, d/(2·|e_M|), is half a pulse at most.
#[kani::proof]
fn minimum_deviation_line_invariant_means_deviation() {
    let (line, _, _) = any_state();
    kani::cover!(line.longest() > 2 && line.deviations()[0] == i64::from(line.longest()));
    for axis in 0..2 {
        assert!(2 * line.deviations()[axis].abs() <= 2 * i64::from(line.longest()));
    }
}

#[kani::proof]
fn minimum_deviation_line_done_means_end_point() {
    let (line, _, end) = any_state();
    let [x, y] = line.position();
    assert!(same(line.residual(), [i64::from(end[0]) - x, i64::from(end[1]) - y]));
    kani::cover!(line.is_done() && end[0] != 0 && end[1] != 0);
    if line.is_done() {
        assert!(same(line.residual(), [0, 0]));
    }
}
