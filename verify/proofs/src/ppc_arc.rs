//! Arc by point-by-point comparison: P3, P4, P5, N1 for every circle within `i32`, any sweep, any
//! end point.
//!
//! F = x² + y² − R² holds throughout; the squares are the ghosts of [`square`]. What F says of the
//! coordinates, by the lemmas of `verify/lemmas/ppc_arc.smt2`, is what the harnesses may assume:
//! see [`lemmas`].

use crate::any::{any_axis, any_direction, any_rule, any_sweep};
use crate::product::square;
use onepulse_core::ppc::Arc;
use onepulse_core::{Axis, EndRule, Pulse, Sweep};

/// What follows for t, the coordinate fed towards zero, and a, the one fed away from it, from
/// F = t² + a² − R² and the largest coordinate p = ⌈√(R² − 1)⌉ (1 for R = 1).
fn lemmas(f: i64, t: i64, a: i64, sweep: &Sweep) -> bool {
    let peak = sweep.peak();
    let is_unit_circle = sweep.radius_rounded_up() == 1;
    // below_the_peak_while_inside: off the axis, a has not come to the peak.
    (f >= 0 || t < 1 || a < peak)
        // last_column_is_left_at_the_peak.
        && (f < 0 || t != 1 || a >= peak || is_unit_circle)
}

/// R² of a sweep's circle: any number below 2⁶², and 1 for the circle of radius 1 alone.
#[cfg(any(kani, target_arch = "wasm32"))]
fn any_radius_squared(sweep: &Sweep) -> i64 {
    kani::any_where(|square: &i64| {
        1 <= *square && *square < 1 << 62 && (*square == 1) == (sweep.radius_rounded_up() == 1)
    })
}

/// R² of a sweep's circle: between the squares that its roots have.
#[cfg(not(any(kani, target_arch = "wasm32")))]
fn any_radius_squared(sweep: &Sweep) -> i64 {
    let (peak, rounded_up) = (sweep.peak(), sweep.radius_rounded_up() as i64);
    let least = (rounded_up - 1).pow(2) + 1;
    let most = if rounded_up > peak { least } else { peak.pow(2) };
    kani::native::chosen(|drawn| least as u64 + drawn % (most - least + 1) as u64) as i64
}

/// Any state that satisfies the invariant.
pub(crate) fn any_state(rule: EndRule) -> Arc {
    let sweep = any_sweep();
    let point: [u32; 2] = kani::any();
    kani::assume(point[0] <= 1 << 31 && point[1] <= 1 << 31);
    let [towards, away] = point.map(square);
    let f = towards - any_radius_squared(&sweep) + away;
    let point = point.map(i64::from);
    kani::assume(lemmas(f, point[0], point[1], &sweep));
    let arc = Arc::in_state(sweep, rule, any_axis(), f, point);
    kani::assume(arc.invariant());
    arc
}

/// One step moves one axis by one pulse, F follows it exactly, and F alone decides until an axis
/// stands.
#[kani::proof]
fn ppc_arc_step_follows_deviation() {
    let mut arc = any_state(any_rule());
    let before = arc;
    let at = before.position();
    let stands = before.sweep().stands(at);
    let feeds = before.sweep().feeds();
    let judged = before.judge();
    let Some(pulse) = arc.step() else {
        assert!(before.is_done());
        return;
    };
    kani::cover!(before.sweep().crossings_left() > arc.sweep().crossings_left());
    kani::cover!(before.deviation_function() < 0);
    kani::cover!(stands[0] && stands[1]);

    let [dx, dy] = pulse.0.map(i64::from);
    assert!(dx.abs() + dy.abs() == 1);
    assert!(judged.axis.of(pulse.0) == judged.sign);
    let to = arc.position();
    assert!(to[0] == at[0] + dx && to[1] == at[1] + dy);
    assert!(to[0].abs() <= 1 << 31 && to[1].abs() <= 1 << 31);
    let along = if dx == 0 { signed(dy, at[1]) } else { signed(dx, at[0]) };
    assert!(arc.deviation_function() == before.deviation_function() + 2 * along + 1);
    if !stands[0] && !stands[1] {
        let due = if before.deviation_function() >= 0 { feeds.towards } else { feeds.away };
        assert!(pulse.0[due.axis.index()] == due.sign);
    }
}

fn signed(sign: i64, value: i64) -> i64 {
    if sign < 0 { -value } else { value }
}

/// The counter of the axis that moves falls by one.
#[kani::proof]
fn ppc_arc_step_counts_down() {
    let mut arc = any_state(any_rule());
    let [x, y] = arc.pulses_to_go();
    let Some(Pulse([dx, dy])) = arc.step() else { return };
    kani::cover!(arc.is_done());
    let [x_after, y_after] = arc.pulses_to_go();
    assert!(x_after + u64::from(dx.unsigned_abs()) == x);
    assert!(y_after + u64::from(dy.unsigned_abs()) == y);
}

/// The invariant's first part: the sweep stays what it was, or goes on by a quadrant.
#[kani::proof]
fn ppc_arc_step_preserves_sweep() {
    let mut arc = any_state(any_rule());
    let crossings = arc.sweep().crossings_left();
    arc.step();
    kani::cover!(arc.sweep().crossings_left() < crossings);
    assert!(arc.sweep().invariant());
}

/// Its second: the counters hold the way that is left.
#[kani::proof]
fn ppc_arc_step_preserves_counters() {
    let mut arc = any_state(any_rule());
    let crossings = arc.sweep().crossings_left();
    arc.step();
    kani::cover!(arc.sweep().crossings_left() < crossings);
    assert!(arc.counters_hold());
}

/// And the whole of it, where these two hold.
#[kani::proof]
fn ppc_arc_step_preserves_invariant() {
    let mut arc = any_state(any_rule());
    let crossings = arc.sweep().crossings_left();
    arc.step();
    kani::cover!(arc.sweep().crossings_left() < crossings);
    kani::assume(arc.sweep().invariant());
    kani::assume(arc.counters_hold());
    assert!(arc.invariant());
}

/// Under the rules that count both axes. Under the third, what is missing is told.
#[kani::proof]
fn ppc_arc_done_means_end_point() {
    let rule = any_rule();
    let arc = any_state(rule);
    let (end, at) = (arc.sweep().end(), arc.position());
    let residual = arc.residual();
    assert!(residual[0] == end[0] - at[0] && residual[1] == end[1] - at[1]);
    assert!(arc.is_done() == (arc.remaining() == 0));
    kani::cover!(arc.is_done() && residual[0] != 0);
    kani::cover!(arc.is_done() && rule == EndRule::Total);
    if arc.is_done() && rule != EndRule::Larger {
        assert!(residual[0] == 0 && residual[1] == 0);
    }
}

/// From every start that has a circle to every end that has a direction.
#[kani::proof]
fn ppc_arc_new_establishes_invariant() {
    let (start, end): ([i32; 2], [i32; 2]) = (kani::any(), kani::any());
    let direction = any_direction();
    let peak = i64::from(kani::any_where(|peak: &i32| *peak >= 1));
    // points_of_the_circle_are_not_above_the_peak.
    kani::assume(start.map(|c| i64::from(c).abs()).iter().all(|c| *c <= peak));
    let Ok(sweep) = Sweep::with_given_roots(start, end, direction, peak, peak as u64) else {
        kani::cover!(start[0] == 0 && start[1] == 0);
        assert!(start == [0, 0] || end == [0, 0]);
        return;
    };
    let rule = any_rule();
    let arc = Arc::along_given(sweep, start, rule);
    kani::cover!(sweep.crossings_left() == 4);
    kani::cover!(sweep.crossings_left() == 0);
    assert!(arc.invariant());
    assert!(arc.deviation_function() == 0);
    let [x, y] = arc.pulses_to_go();
    assert!(arc.larger() == if x >= y { Axis::X } else { Axis::Y });
    let at = arc.position();
    assert!(at[0] == i64::from(start[0]) && at[1] == i64::from(start[1]));
}
