//! Line by vector discrimination: V1, N1 for every `i32` end point.
//!
//! V = b·(pulses of the longer axis to go) − a·(pulses of the shorter one to go); the two products are
//! ghosts of [`product`].

use crate::product::product;
use crate::same::same;
use onepulse_core::Axis;
use onepulse_core::vector::Line;

/// The two products of V.
struct Ghost([u64; 2]);

impl Ghost {
    fn product(&self) -> i64 {
        // Below 2⁶³ in any state of the line, where it is within a `u32`'s range of 0.
        self.0[0].wrapping_sub(self.0[1]) as i64
    }
}

/// The lengths a and b of the longer axis and the shorter one.
fn lengths(end: [i32; 2]) -> [u32; 2] {
    let [x, y] = end.map(i32::unsigned_abs);
    [x.max(y), x.min(y)]
}

/// Any state on any line that satisfies the invariant.
fn any_state() -> (Line, Ghost, [i32; 2]) {
    let end: [i32; 2] = kani::any();
    let left: [u32; 2] = kani::any();
    let [a, b] = lengths(end);
    let x_is_longer = end[0].unsigned_abs() >= end[1].unsigned_abs();
    let (longer, shorter) = if x_is_longer { (left[0], left[1]) } else { (left[1], left[0]) };
    let ghost = Ghost([product(b, longer), product(a, shorter)]);
    let line = Line::in_state(end, ghost.product(), left);
    kani::assume(line.invariant());
    (line, ghost, end)
}

#[kani::proof]
fn vector_line_new_establishes_invariant() {
    let end: [i32; 2] = kani::any();
    let magnitude = end.map(|c| u64::from(c.unsigned_abs()));
    let Ok(line) = Line::new(end) else { panic!("every end point is served") };
    kani::cover!(end[0] == i32::MIN && end[1] > 0);
    kani::cover!(line.is_done());
    assert!(line.invariant());
    assert!(line.vector_product() == 0 && same(line.position(), [0, 0]));
    assert!(same(line.pulses_to_go(), magnitude));
    assert!(line.remaining() == magnitude[0].max(magnitude[1]));
    assert!((line.longer() == Axis::X) == (magnitude[0] >= magnitude[1]));
}

/// A pulse of the longer axis on every step, and V as it is defined.
#[kani::proof]
fn vector_line_step_preserves_invariant() {
    let (mut line, mut ghost, end) = any_state();
    let before = line;
    let [a, b] = lengths(end);
    let longer = line.longer();
    let Some(pulse) = line.step() else {
        assert!(before.is_done());
        return;
    };
    kani::cover!(pulse.0[0] == 1 && pulse.0[1] == -1);
    kani::cover!(b > 0 && longer.other().of(pulse.0) == 0);
    assert!(line.remaining() + 1 == before.remaining());
    for axis in 0..2 {
        let feeds = pulse.0[axis] != 0;
        assert!(!feeds || pulse.0[axis] == end[axis].signum() as i8);
        assert!(line.pulses_to_go()[axis] + u64::from(feeds) == before.pulses_to_go()[axis]);
    }
    assert!(longer.of(pulse.0) != 0);
    let feeds_both = longer.other().of(pulse.0) != 0;
    ghost.0[0] = ghost.0[0].wrapping_sub(b.into());
    ghost.0[1] = ghost.0[1].wrapping_sub(if feeds_both { a.into() } else { 0 });
    assert!(line.vector_product() == ghost.product());
    assert!(line.invariant());
}

/// V/a, what the shorter axis is off, is below one pulse.
#[kani::proof]
fn vector_line_invariant_means_deviation() {
    let (line, _, end) = any_state();
    let [a, b] = lengths(end);
    kani::cover!(b > 1 && line.vector_product() == 1 - i64::from(b));
    assert!(a == 0 || line.vector_product().abs() < i64::from(a));
}

#[kani::proof]
fn vector_line_done_means_end_point() {
    let (line, _, end) = any_state();
    let [x, y] = line.position();
    assert!(same(line.residual(), [i64::from(end[0]) - x, i64::from(end[1]) - y]));
    kani::cover!(line.is_done() && end[0] != 0 && end[1] != 0);
    if line.is_done() {
        assert!(same(line.residual(), [0, 0]));
    }
}
