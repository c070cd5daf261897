//! Line in space by point-by-point comparison: P6, P7, N1 for three axes and every `i32` end point.
//!
//! As on the plane line, F_i = |e_i|·(pulses of M to go) − |e_M|·(pulses of i to go); the products are
//! the ghosts of [`product`], a pair for each axis but M, the one that leads.

use crate::product::product;
use crate::same::same;
use onepulse_core::ppc::SpaceLine;

const AXES: usize = 3;

/// For each axis, its end coordinate times the leader's pulses to go, and the leader's times its own.
struct Ghost([[u64; 2]; AXES]);

impl Ghost {
    fn deviations(&self) -> [i64; AXES] {
        // Below 2⁶³ in any state of the line, where F is within an `i32`'s range of 0.
        self.0.map(|[ahead, behind]| ahead.wrapping_sub(behind) as i64)
    }
}

/// The part of an array that belongs to the longest axis, the earliest of several.
fn of_leader<T: Copy>([x, y, z]: [u32; AXES], parts: [T; AXES]) -> T {
    if x >= y && x >= z {
        parts[0]
    } else if y >= z {
        parts[1]
    } else {
        parts[2]
    }
}

/// Any state on the line to `end` that satisfies the invariant.
fn any_state(end: [i32; AXES]) -> (SpaceLine, Ghost) {
    let magnitude = end.map(i32::unsigned_abs);
    let left: [u32; AXES] = kani::any();
    let (longest, leading) = (of_leader(magnitude, magnitude), of_leader(magnitude, left));
    let leader = of_leader(magnitude, [0, 1, 2]);
    let mut ghost = Ghost([[0; 2]; AXES]);
    for axis in 0..AXES {
        if axis != leader {
            ghost.0[axis] = [product(magnitude[axis], leading), product(longest, left[axis])];
        }
    }
    let Ok(line) = SpaceLine::in_state(end, ghost.deviations(), left) else {
        panic!("every end point is served")
    };
    kani::assume(line.bounds_hold());
    (line, ghost)
}

#[kani::proof]
fn space_line_new_establishes_invariant() {
    let end: [i32; AXES] = kani::any();
    let Ok(line) = SpaceLine::new(end) else { panic!("every end point is served") };
    let magnitude = end.map(i32::unsigned_abs);
    kani::cover!(end[0] == i32::MIN && end[1] < 0 && line.leader() == 0);
    kani::cover!(line.leader() == 2);
    assert!(line.bounds_hold());
    assert!(line.leader() == of_leader(magnitude, [0, 1, 2]));
    assert!(same(line.deviation_functions(), [0; AXES]));
    assert!(same(line.pulses_to_go(), magnitude.map(u64::from)));
    assert!(same(line.position(), [0; AXES]));
    assert!(line.remaining() == magnitude.iter().map(|c| u64::from(*c)).sum::<u64>());
}

/// One step is one pulse on one axis that has some left, every F_i follows it, and stays within its
/// bounds.
#[kani::proof]
fn space_line_step_preserves_invariant() {
    let end: [i32; AXES] = kani::any();
    let magnitude = end.map(i32::unsigned_abs);
    let (mut line, ghost) = any_state(end);
    let before = line;
    let fed = before.judge();
    let leader = before.leader();
    kani::cover!(!before.is_done() && fed == leader);
    kani::cover!(fed != leader && fed == 2 && before.deviation_functions()[0] < 0);

    let Some(pulse) = line.step() else {
        assert!(before.is_done() && before.remaining() == 0);
        return;
    };
    assert!(line.remaining() + 1 == before.remaining());
    let longest = i64::from(of_leader(magnitude, magnitude));
    for axis in 0..AXES {
        let is_fed = axis == fed;
        let left = before.pulses_to_go()[axis];
        assert!(!is_fed || left > 0 && pulse.0[axis] != 0);
        assert!(pulse.0[axis] == if is_fed { end[axis].signum() as i8 } else { 0 });
        assert!(line.pulses_to_go()[axis] + u64::from(is_fed) == left);
        let [mut ahead, mut behind] = ghost.0[axis];
        if axis != leader {
            ahead = ahead.wrapping_sub(if fed == leader { u64::from(magnitude[axis]) } else { 0 });
            behind = behind.wrapping_sub(if is_fed { longest as u64 } else { 0 });
        }
        assert!(line.deviation_functions()[axis] == ahead.wrapping_sub(behind) as i64);
    }
    assert!(line.bounds_hold());
}

/// −|e_i| ≤ F_i ≤ |e_M|: in the projection on the plane of i and M, within one pulse along i.
#[kani::proof]
fn space_line_invariant_means_deviation() {
    let end: [i32; AXES] = kani::any();
    let magnitude = end.map(i32::unsigned_abs);
    let (line, _) = any_state(end);
    let longest = i64::from(of_leader(magnitude, magnitude));
    kani::cover!(line.deviation_functions()[1] == longest - 1 && longest > 1);
    for axis in 0..AXES {
        assert!(line.deviation_functions()[axis].abs() <= longest);
    }
}

#[kani::proof]
fn space_line_done_means_end_point() {
    let end: [i32; AXES] = kani::any();
    let (line, _) = any_state(end);
    kani::cover!(line.is_done() && end[0] != 0 && end[1] < 0 && end[2] != 0);
    assert!(line.is_done() == (line.remaining() == 0));
    for axis in 0..AXES {
        let (at, missing) = (line.position()[axis], line.residual()[axis]);
        assert!(at + missing == i64::from(end[axis]));
        assert!(!line.is_done() || missing == 0);
    }
}
