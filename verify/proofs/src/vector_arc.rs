//! Arc by vector discrimination: V1, N1 for every circle within `i32`, any sweep, any end point.

use crate::circle_walk::{self, any_state};
use onepulse_core::vector::Octant;

#[kani::proof]
fn vector_arc_new_establishes_invariant() {
    let arc = circle_walk::new_establishes_invariant::<Octant>();
    kani::cover!(arc.walk().sweep().crossings_left() == 4);
    kani::cover!(arc.walk().sweep().crossings_left() == 0);
}

#[kani::proof]
fn vector_arc_step_follows_deviation() {
    let mut arc = any_state::<Octant>();
    let stands = arc.walk().sweep().stands(arc.walk().position());
    let pulse = circle_walk::step_follows_deviation(&mut arc);
    kani::cover!(stands[0] && stands[1] && pulse.is_some());
    kani::cover!(pulse.is_some_and(|pulse| pulse.0[0] != 0 && pulse.0[1] != 0));
}

/// The sweep stays what it was, or goes on by a quadrant.
#[kani::proof]
fn vector_arc_step_preserves_sweep() {
    let mut arc = any_state::<Octant>();
    let crossings = arc.walk().sweep().crossings_left();
    arc.step();
    kani::cover!(arc.walk().sweep().crossings_left() < crossings);
    assert!(arc.walk().sweep().invariant());
}

/// And the whole of the invariant, where that holds.
#[kani::proof]
fn vector_arc_step_preserves_invariant() {
    let mut arc = any_state::<Octant>();
    let crossings = arc.walk().sweep().crossings_left();
    arc.step();
    kani::cover!(arc.walk().sweep().crossings_left() < crossings);
    kani::assume(arc.walk().sweep().invariant());
    assert!(arc.invariant());
}

#[kani::proof]
fn vector_arc_step_makes_progress() {
    let mut arc = any_state::<Octant>();
    let is_free = arc.walk().is_free();
    let goes_on = circle_walk::step_makes_progress(&mut arc);
    kani::cover!(goes_on && is_free);
    kani::cover!(goes_on && !is_free);
}

/// −2m ≤ F < 2m, m = max(|x|, |y|), while F decides.
#[kani::proof]
fn vector_arc_invariant_means_deviation() {
    let arc = any_state::<Octant>();
    let [x, y] = arc.walk().position().map(i64::abs);
    let f = arc.walk().deviation_function();
    let largest = x.max(y);
    kani::cover!(arc.walk().is_free() && f == -2 * largest && x > 2 && y > 2);
    assert!(!arc.walk().is_free() || -2 * largest <= f && f < 2 * largest);
}

#[kani::proof]
fn vector_arc_done_means_end_point() {
    let arc = any_state::<Octant>();
    let is_done = circle_walk::done_means_end_point(&arc);
    kani::cover!(is_done);
    kani::cover!(!is_done);
}

/// Where F decides: the smaller coordinate's axis always, the other one to get back over the circle.
#[kani::proof]
fn vector_arc_step_follows_rule() {
    let mut arc = any_state::<Octant>();
    kani::assume(arc.walk().is_free());
    let (f, [t, a]) = (arc.walk().deviation_function(), circle_walk::magnitudes(arc.walk()));
    let due = circle_walk::fed(&mut arc);
    kani::cover!(due[0] && due[1]);
    kani::cover!(due[0] && !due[1]);
    kani::cover!(!due[0] && due[1]);
    let leads_out = t > a;
    assert!(if leads_out { due[1] } else { due[0] });
    assert!(due[0] && due[1] || (f < 0) == leads_out);
    assert!(!(due[0] && due[1]) || (f >= 0) == leads_out);
}
