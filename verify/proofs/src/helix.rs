//! Helix: Q4, N1 for every arc that has a circle and every rise.
//!
//! The arc is one of `ppc_arc.rs`, in any state; that its steps to go fall by one with each step is shown
//! there. rest + left·S = ⌊T/2⌋ + d·T, where d is what the shorter of arc and linear axis lacks; the two
//! products are ghosts here, up to 2⁶⁶.

use crate::any::any_direction;
use crate::ppc_arc::any_state as any_arc;
use crate::same::same;
use onepulse_core::{EndRule, Helix, Plane, Sweep, ppc::Arc};

fn any_plane() -> Plane {
    match kani::any_where(|plane: &u8| *plane < 3) {
        0 => Plane::Xy,
        1 => Plane::Zx,
        _ => Plane::Yz,
    }
}

/// `factor · count`. To a solver any number with these properties of the product (lemmas in
/// `verify/lemmas/product.smt2`).
#[cfg(any(kani, target_arch = "wasm32"))]
fn product(factor: u64, count: u64) -> u128 {
    let halves: [u64; 2] = kani::any();
    let product = u128::from(halves[0]) << 64 | u128::from(halves[1]);
    kani::assume(product < 1 << 80);
    let factor = u128::from(factor);
    kani::assume(match count {
        0 => product == 0,
        1 => product == factor,
        _ => product >= 2 * factor,
    });
    product
}

/// `factor · count`. A counterexample's own numbers when one is run again.
#[cfg(not(any(kani, target_arch = "wasm32")))]
fn product(factor: u64, count: u64) -> u128 {
    let product = u128::from(factor) * u128::from(count);
    let [high, low] = [(product >> 64) as u64, product as u64].map(kani::native::given);
    u128::from(high) << 64 | u128::from(low)
}

/// What the products leave free: the cycles to go if the linear axis is the longer one and the arc lacks
/// `to_turn` steps, else the pulses that the linear axis lacks in `to_turn` cycles.
#[cfg(any(kani, target_arch = "wasm32"))]
fn any_count(_steps: u64, _height: u64, _to_turn: u64) -> u64 {
    kani::any()
}

/// The same natively: the count that keeps the remainder in its register.
#[cfg(not(any(kani, target_arch = "wasm32")))]
fn any_count(steps: u64, height: u64, to_turn: u64) -> u64 {
    let [steps, height, to_turn] = [steps, height, to_turn].map(u128::from);
    kani::native::chosen(|drawn| {
        let count = if height > steps {
            // left·N <= ⌊h/2⌋ + d·h < left·N + h.
            let most = (height / 2 + to_turn * height) / steps.max(1);
            most.saturating_sub(u128::from(drawn) % height.div_ceil(steps.max(1)))
        } else {
            // d·N >= left·h − ⌊N/2⌋.
            (to_turn * height).saturating_sub(steps / 2).div_ceil(steps.max(1))
        };
        count as u64
    })
}

/// A helix somewhere on its way.
struct Any {
    helix: Helix,
    plane: Plane,
    rise: i32,
    /// S.
    shorter: u64,
    /// left·S and d·T.
    due: u128,
    lacking: u128,
}

/// Any state that satisfies the invariant; an arc has fewer than 2³⁶ steps.
fn any_state() -> Any {
    let arc = any_arc(EndRule::Total);
    let (plane, rise): (_, i32) = (any_plane(), kani::any());
    let to_turn = arc.remaining();
    let steps = to_turn + u64::from(kani::any::<u32>());
    kani::assume(steps < 1 << 36);
    let height = u64::from(rise.unsigned_abs());
    let (cycles, shorter) = (steps.max(height), steps.min(height));
    let count = any_count(steps, height, to_turn);
    kani::assume(count <= height);
    let (left, lacking) = if height > steps { (count, to_turn) } else { (to_turn, count) };
    let risen = (height - count) as u32;
    let (due, lacking) = (product(shorter, left), product(cycles, lacking));
    let rest = (u128::from(cycles / 2) + lacking).wrapping_sub(due);
    kani::assume(rest < u128::from(cycles));
    let helix = Helix::in_state(plane, arc, steps, rise, risen, left, rest as u64);
    kani::assume(helix.counters_hold(due, lacking));
    Any { helix, plane, rise, shorter, due, lacking }
}

/// An arc that has not begun, on any circle.
fn any_new_arc() -> Arc {
    let (start, end): ([i32; 2], [i32; 2]) = (kani::any(), kani::any());
    let peak = i64::from(kani::any_where(|peak: &i32| *peak >= 1));
    kani::assume(start.map(|c| i64::from(c).abs()).iter().all(|c| *c <= peak));
    match Sweep::with_given_roots(start, end, any_direction(), peak, peak as u64) {
        Ok(sweep) => Arc::along_given(sweep, start, EndRule::Total),
        Err(_) => {
            kani::assume(false);
            unreachable!("the centre is no start and no end")
        }
    }
}

#[kani::proof]
fn helix_new_establishes_invariant() {
    let arc = any_new_arc();
    let (plane, rise): (_, i32) = (any_plane(), kani::any());
    let helix = Helix::about_given(plane, arc, rise);
    let (steps, height) = (arc.remaining(), u64::from(rise.unsigned_abs()));
    kani::cover!(height > steps && rise < 0);
    kani::cover!(height < steps && rise > 0);
    assert!(steps < 1 << 36);
    assert!(helix.remaining() == steps.max(height) && helix.cycles() == helix.remaining());
    assert!(helix.remainder() == helix.cycles() / 2);
    let [longer, shorter] = helix.steps_to_go();
    assert!(longer == steps.max(height) && shorter == steps.min(height));
    // left·S and d·T are both S·T.
    assert!(helix.cycles() == 0 || helix.counters_hold(0, 0));
    let across = plane.axes()[2];
    assert!(helix.position()[across] == 0 && helix.residual()[across] == i64::from(rise));
}

/// One cycle steps the longer and, where the remainder overflows, the shorter, each of which has a step
/// left.
#[kani::proof]
fn helix_step_preserves_invariant() {
    let Any { mut helix, plane, rise, shorter, due, lacking } = any_state();
    let before = helix;
    let Some(pulse) = helix.step() else {
        assert!(before.remaining() == 0);
        return;
    };
    let [longer_left, shorter_left] = before.steps_to_go();
    let [longer_after, shorter_after] = helix.steps_to_go();
    let carry = shorter_after != shorter_left;
    kani::cover!(carry && rise < 0);
    kani::cover!(!carry && helix.arc().remaining() == before.arc().remaining());
    assert!(helix.remaining() + 1 == before.remaining());
    assert!(longer_after + 1 == longer_left);
    assert!(shorter_after + u64::from(carry) == shorter_left);
    let due = due - u128::from(shorter);
    let lacking = lacking - if carry { u128::from(before.cycles()) } else { 0 };
    assert!(helix.counters_hold(due, lacking));

    let [first, second, across] = plane.axes().map(|axis| pulse.0[axis]);
    let turned = before.arc().remaining() - helix.arc().remaining();
    assert!(turned == u64::from(first != 0) + u64::from(second != 0));
    assert!(across == 0 || i32::from(across) == rise.signum());
    let [at, to] = [before, helix].map(|helix| helix.position()[plane.axes()[2]]);
    assert!(to == at + i64::from(across));
}

/// After c cycles the shorter has made c·S/T steps to within half a one: the difference, times T, is that
/// of the remainder from half load. And when no cycle is left, no step is.
#[kani::proof]
fn helix_done_means_end_point() {
    let Any { helix, .. } = any_state();
    let off = helix.remainder().abs_diff(helix.cycles() / 2);
    kani::cover!(2 * off == helix.cycles());
    assert!(2 * off <= helix.cycles());
    kani::cover!(helix.is_done());
    if helix.is_done() {
        assert!(same(helix.steps_to_go(), [0, 0]));
        assert!(same(helix.residual(), [0, 0, 0]));
    }
}
