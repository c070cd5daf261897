//! Arc by comparison integration: C1, N1 for every circle within `i32`, any sweep, any end point.

use crate::circle_walk::{self, any_state};
use onepulse_core::comparison::Interval;

#[kani::proof]
fn comparison_arc_new_establishes_invariant() {
    let arc = circle_walk::new_establishes_invariant::<Interval>();
    kani::cover!(arc.walk().sweep().crossings_left() == 4);
    kani::cover!(arc.walk().sweep().crossings_left() == 0);
}

#[kani::proof]
fn comparison_arc_step_follows_deviation() {
    let mut arc = any_state::<Interval>();
    let stands = arc.walk().sweep().stands(arc.walk().position());
    let pulse = circle_walk::step_follows_deviation(&mut arc);
    kani::cover!(stands[0] && stands[1] && pulse.is_some());
    kani::cover!(pulse.is_some_and(|pulse| pulse.0[0] != 0 && pulse.0[1] != 0));
}

/// The sweep stays what it was, or goes on by a quadrant.
#[kani::proof]
fn comparison_arc_step_preserves_sweep() {
    let mut arc = any_state::<Interval>();
    let crossings = arc.walk().sweep().crossings_left();
    arc.step();
    kani::cover!(arc.walk().sweep().crossings_left() < crossings);
    assert!(arc.walk().sweep().invariant());
}

/// And the whole of the invariant, where that holds.
#[kani::proof]
fn comparison_arc_step_preserves_invariant() {
    let mut arc = any_state::<Interval>();
    let crossings = arc.walk().sweep().crossings_left();
    arc.step();
    kani::cover!(arc.walk().sweep().crossings_left() < crossings);
    kani::assume(arc.walk().sweep().invariant());
    assert!(arc.invariant());
}

#[kani::proof]
fn comparison_arc_step_makes_progress() {
    let mut arc = any_state::<Interval>();
    let is_free = arc.walk().is_free();
    let goes_on = circle_walk::step_makes_progress(&mut arc);
    kani::cover!(goes_on && is_free);
    kani::cover!(goes_on && !is_free);
}

/// |F| ≤ |x| + |y| while F decides.
#[kani::proof]
fn comparison_arc_invariant_means_deviation() {
    let arc = any_state::<Interval>();
    let [x, y] = arc.walk().position().map(i64::abs);
    let f = arc.walk().deviation_function();
    kani::cover!(arc.walk().is_free() && f == -x - y && x > 2 && y > 2);
    assert!(!arc.walk().is_free() || f.abs() <= x + y);
}

#[kani::proof]
fn comparison_arc_done_means_end_point() {
    let arc = any_state::<Interval>();
    let is_done = circle_walk::done_means_end_point(&arc);
    kani::cover!(is_done);
    kani::cover!(!is_done);
}

/// Where F decides: the axis of which the pulse is due first. Past intervals and half of the present one
/// differ by (−2F + (2t − 1) − (2a + 1))/4, which is below zero where F > t − a − 1.
#[kani::proof]
fn comparison_arc_step_follows_rule() {
    let mut arc = any_state::<Interval>();
    kani::assume(arc.walk().is_free());
    let (f, [t, a]) = (arc.walk().deviation_function(), circle_walk::magnitudes(arc.walk()));
    let due = circle_walk::fed(&mut arc);
    kani::cover!(due[0] && due[1]);
    kani::cover!(due[0] && !due[1]);
    kani::cover!(!due[0] && due[1]);
    let level = t - a - 1;
    assert!(due[0] == (f >= level) && due[1] == (f <= level));
}
