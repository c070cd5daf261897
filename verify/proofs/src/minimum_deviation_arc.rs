//! Arc by minimum deviation: M1, N1 for every circle within `i32`, any sweep, any end point.

use crate::circle_walk::{self, any_state};
use onepulse_core::minimum_deviation::Nearest;

#[kani::proof]
fn minimum_deviation_arc_new_establishes_invariant() {
    let arc = circle_walk::new_establishes_invariant::<Nearest>();
    kani::cover!(arc.walk().sweep().crossings_left() == 4);
    kani::cover!(arc.walk().sweep().crossings_left() == 0);
}

#[kani::proof]
fn minimum_deviation_arc_step_follows_deviation() {
    let mut arc = any_state::<Nearest>();
    let stands = arc.walk().sweep().stands(arc.walk().position());
    let pulse = circle_walk::step_follows_deviation(&mut arc);
    kani::cover!(stands[0] && stands[1] && pulse.is_some());
    kani::cover!(pulse.is_some_and(|pulse| pulse.0[0] != 0 && pulse.0[1] != 0));
}

/// The sweep stays what it was, or goes on by a quadrant.
#[kani::proof]
fn minimum_deviation_arc_step_preserves_sweep() {
    let mut arc = any_state::<Nearest>();
    let crossings = arc.walk().sweep().crossings_left();
    arc.step();
    kani::cover!(arc.walk().sweep().crossings_left() < crossings);
    assert!(arc.walk().sweep().invariant());
}

/// And the whole of the invariant, where that holds.
#[kani::proof]
fn minimum_deviation_arc_step_preserves_invariant() {
    let mut arc = any_state::<Nearest>();
    let crossings = arc.walk().sweep().crossings_left();
    arc.step();
    kani::cover!(arc.walk().sweep().crossings_left() < crossings);
    kani::assume(arc.walk().sweep().invariant());
    assert!(arc.invariant());
}

#[kani::proof]
fn minimum_deviation_arc_step_makes_progress() {
    let mut arc = any_state::<Nearest>();
    let is_free = arc.walk().is_free();
    let goes_on = circle_walk::step_makes_progress(&mut arc);
    kani::cover!(goes_on && is_free);
    kani::cover!(goes_on && !is_free);
}

/// |F| ≤ max(|x|, |y|) while F decides.
#[kani::proof]
fn minimum_deviation_arc_invariant_means_deviation() {
    let arc = any_state::<Nearest>();
    let [x, y] = arc.walk().position().map(i64::abs);
    let f = arc.walk().deviation_function();
    let largest = x.max(y);
    kani::cover!(arc.walk().is_free() && f == largest && x > 2 && y > 2);
    assert!(!arc.walk().is_free() || f.abs() <= largest);
}

#[kani::proof]
fn minimum_deviation_arc_done_means_end_point() {
    let arc = any_state::<Nearest>();
    let is_done = circle_walk::done_means_end_point(&arc);
    kani::cover!(is_done);
    kani::cover!(!is_done);
}

/// Where F decides, no other step that leads on would leave less of it: in whole numbers the least |F| is
/// that of one step alone.
#[kani::proof]
fn minimum_deviation_arc_step_follows_rule() {
    let mut arc = any_state::<Nearest>();
    kani::assume(arc.walk().is_free());
    let (f, [t, a]) = (arc.walk().deviation_function(), circle_walk::magnitudes(arc.walk()));
    let due = circle_walk::fed(&mut arc);
    let left = arc.walk().deviation_function().abs();
    kani::cover!(due[0] && due[1]);
    kani::cover!(due[0] && !due[1]);
    kani::cover!(!due[0] && due[1]);
    assert!(left < (f - 2 * t + 1).abs() || due == [true, false]);
    assert!(left < (f + 2 * a + 1).abs() || due == [false, true]);
    assert!(left < (f - 2 * t + 1 + 2 * a + 1).abs() || due == [true, true]);
}
