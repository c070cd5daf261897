//! Arcs that judge F and may step both axes: M1, V1, C1, N1 as far as they do not depend on the judgement,
//! which may be any here, for every circle within `i32`, any sweep, any end point.
//!
//! What a method's own judgement keeps is asked of it alone, in `minimum_deviation_arc.rs`,
//! `vector_arc.rs` and `comparison_arc.rs`: it is a function of F and two magnitudes.

use crate::any::{any_direction, any_sweep};
use crate::product::square;
use onepulse_core::circle::{self, Due, Judgement};
use onepulse_core::vector::Octant;
use onepulse_core::{Pulse, Sweep, Walk};

/// Anything may be due, but what leads into the centre.
#[derive(Clone, Copy, Debug)]
struct Any;

impl Judgement for Any {
    fn due(_: i64, magnitudes: [i64; 2]) -> Due {
        let due = match kani::any_where(|due: &u8| *due < 3) {
            0 => Due::Towards,
            1 => Due::Away,
            _ => Due::Both,
        };
        let leads_to_centre = magnitudes[0] == 1 && magnitudes[1] == 0;
        kani::assume(due != Due::Towards || !leads_to_centre);
        due
    }

    fn is_within(_: i64, _: [i64; 2]) -> bool {
        true
    }
}

type Arc = circle::Arc<Any>;

/// Any state that satisfies the invariant: F = x² + y² − R², whatever R² from 1 on. That no coordinate
/// exceeds 2³¹ follows from it (lemma `coordinates_fit` in `verify/lemmas/circle_walk.smt2`).
#[inline(always)]
fn any_state<J: Judgement>() -> circle::Arc<J> {
    let sweep = any_sweep();
    let point: [u32; 2] = kani::any();
    kani::assume(point[0] <= 1 << 31 && point[1] <= 1 << 31);
    let [towards, away] = point.map(square);
    // The step to 1 from where F is known needs this one too.
    kani::assume(point[0] != 2 || towards == 4);
    let radius_squared = kani::any_where(|square: &i64| 1 <= *square && *square < 1 << 62);
    let f = towards - radius_squared + away;
    let arc = circle::Arc::in_state(Walk::in_state(sweep, f, point.map(i64::from)));
    kani::assume(arc.invariant());
    // Far beyond the bounds of every judgement, and no sum overflows.
    kani::assume(!arc.walk().is_free() || f.abs() <= 1 << 40);
    arc
}

/// From every start that has a circle to every end that has a direction.
#[kani::proof]
fn circle_new_establishes_invariant() {
    let (start, end): ([i32; 2], [i32; 2]) = (kani::any(), kani::any());
    let direction = any_direction();
    let Ok(sweep) = Sweep::with_given_roots(start, end, direction, 1, 1) else {
        kani::cover!(start[0] == 0 && start[1] == 0);
        return;
    };
    let arc = Arc::along_given(sweep, start);
    kani::cover!(sweep.crossings_left() == 4);
    kani::cover!(sweep.crossings_left() == 0);
    assert!(arc.invariant());
    assert!(arc.walk().deviation_function() == 0);
    let at = arc.walk().position();
    assert!(at[0] == i64::from(start[0]) && at[1] == i64::from(start[1]));
}

/// A step moves one axis or both by a pulse each, and F follows: a pulse of sign s on coordinate c
/// changes it by 2sc + 1.
#[kani::proof]
fn circle_step_follows_deviation() {
    let mut arc = any_state::<Any>();
    let before = arc;
    let at = before.walk().position();
    let stands = before.walk().sweep().stands(at);
    let Some(Pulse(pulse)) = arc.step() else {
        assert!(before.is_done());
        return;
    };
    kani::cover!(stands[0] && stands[1]);
    kani::cover!(pulse[0] != 0 && pulse[1] != 0);
    let [dx, dy] = pulse.map(i64::from);
    assert!(dx.abs() <= 1 && dy.abs() <= 1 && (dx != 0 || dy != 0));
    let to = arc.walk().position();
    assert!(to[0] == at[0] + dx && to[1] == at[1] + dy);
    let change = |sign: i64, c: i64| match sign {
        0 => 0,
        1.. => 2 * c + 1,
        _ => -2 * c + 1,
    };
    let f = before.walk().deviation_function() + change(dx, at[0]) + change(dy, at[1]);
    assert!(arc.walk().deviation_function() == f);
}

/// While F decides, a step feeds what the judgement says is due. (One stands for all: the step is the
/// same code.)
#[kani::proof]
fn circle_step_feeds_what_is_due() {
    let mut arc = any_state::<Octant>();
    kani::assume(arc.walk().is_free());
    let feeds = arc.walk().sweep().feeds();
    let due = Octant::due(arc.walk().deviation_function(), arc.walk().magnitudes());
    kani::cover!(due == Due::Towards);
    kani::cover!(due == Due::Away);
    kani::cover!(due == Due::Both);
    let Some(Pulse(pulse)) = arc.step() else { panic!("an axis is on its way") };
    let sign = |is_fed: bool, sign: i8| if is_fed { sign } else { 0 };
    assert!(feeds.towards.axis.of(pulse) == sign(due != Due::Away, feeds.towards.sign));
    assert!(feeds.away.axis.of(pulse) == sign(due != Due::Towards, feeds.away.sign));
}

/// The sweep stays what it was, or goes on by a quadrant.
#[kani::proof]
fn circle_step_preserves_sweep() {
    let mut arc = any_state::<Any>();
    let crossings = arc.walk().sweep().crossings_left();
    arc.step();
    kani::cover!(arc.walk().sweep().crossings_left() < crossings);
    assert!(arc.walk().sweep().invariant());
}

/// And the rest of the invariant, where that holds, but for what the judgement keeps.
#[kani::proof]
fn circle_step_preserves_invariant() {
    let mut arc = any_state::<Any>();
    let crossings = arc.walk().sweep().crossings_left();
    arc.step();
    kani::cover!(arc.walk().sweep().crossings_left() < crossings);
    kani::assume(arc.walk().sweep().invariant());
    assert!(arc.invariant());
}

/// A step is progress: fewer quadrants are to go, or fewer axes to come to stand, or less of the way:
/// while both go on, what is fed towards zero shrinks or what is fed away from it grows, and then the
/// pulses to the end point get fewer. All of it has a least value.
#[kani::proof]
fn circle_step_makes_progress() {
    let mut arc = any_state::<Any>();
    let is_free = arc.walk().is_free();
    let before = distance(arc.walk());
    if arc.step().is_none() {
        return;
    }
    kani::cover!(is_free);
    kani::cover!(!is_free);
    let [quadrants, going, way] = distance(arc.walk());
    let crosses = quadrants < before[0];
    let stands = quadrants == before[0] && going < before[1];
    let moves = quadrants == before[0] && going == before[1] && way < before[2];
    assert!(crosses || stands || moves);
}

fn distance(walk: &Walk) -> [u64; 3] {
    let sweep = walk.sweep();
    let at = walk.position();
    let (towards, away) = (sweep.feeds().towards.axis, sweep.feeds().away.axis);
    let [x_stands, y_stands] = sweep.stands(at);
    let going = u64::from(!x_stands) + u64::from(!y_stands);
    let [t, a] = [towards.of(at), away.of(at)];
    let way = if going == 2 {
        // Coordinates are 2³¹ at most, and one more after a step.
        t.unsigned_abs() + (1 << 32) - a.unsigned_abs()
    } else {
        t.abs_diff(towards.of(sweep.end())) + a.abs_diff(away.of(sweep.end()))
    };
    [u64::from(sweep.crossings_left()), going, way]
}

/// At the end of its way an arc is on its end point, on or off the circle.
#[kani::proof]
fn circle_done_means_end_point() {
    let arc = any_state::<Any>();
    let [x, y] = arc.walk().residual();
    let (end, at) = (arc.walk().sweep().end(), arc.walk().position());
    assert!(x == end[0] - at[0] && y == end[1] - at[1]);
    kani::cover!(arc.is_done());
    kani::cover!(!arc.is_done());
    if arc.is_done() {
        assert!(x == 0 && y == 0 && arc.walk().sweep().crossings_left() == 0);
    }
}
