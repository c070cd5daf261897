//! What the arcs that judge F, feed one axis or both and count nothing have in common: how any state
//! of them looks, and what is asked of each.

use crate::any::{any_direction, any_sweep};
use crate::product::square;
use onepulse_core::circle::{Arc, Judgement};
use onepulse_core::{Pulse, Sweep, Walk};

/// Any state that satisfies the invariant: F = x² + y² − R², whatever R² from 1 on. That no coordinate
/// exceeds 2³¹ follows from it (lemma `coordinates_fit` in `verify/lemmas/circle_walk.smt2`).
#[inline(always)]
pub(crate) fn any_state<J: Judgement>() -> Arc<J> {
    let sweep = any_sweep();
    let point: [u32; 2] = kani::any();
    kani::assume(point[0] <= 1 << 31 && point[1] <= 1 << 31);
    let [towards, away] = point.map(square);
    let radius_squared = kani::any_where(|square: &i64| 1 <= *square && *square < 1 << 62);
    let f = towards - radius_squared + away;
    let arc = Arc::<J>::in_state(Walk::in_state(sweep, f, point.map(i64::from)));
    kani::assume(arc.invariant());
    arc
}

/// From every start that has a circle to every end that has a direction.
#[inline(always)]
pub(crate) fn new_establishes_invariant<J: Judgement>() -> Arc<J> {
    let (start, end): ([i32; 2], [i32; 2]) = (kani::any(), kani::any());
    let direction = any_direction();
    let Ok(sweep) = Sweep::with_given_roots(start, end, direction, 1, 1) else {
        kani::assume(false);
        unreachable!("the centre is no start and no end");
    };
    let arc = Arc::<J>::along_given(sweep, start);
    assert!(arc.invariant());
    assert!(arc.walk().deviation_function() == 0);
    let at = arc.walk().position();
    assert!(at[0] == i64::from(start[0]) && at[1] == i64::from(start[1]));
    arc
}

/// A step moves one axis or both by a pulse each, and F follows: a pulse of sign s on coordinate c
/// changes it by 2sc + 1. The pulses are the answer.
#[inline(always)]
pub(crate) fn step_follows_deviation<J: Judgement + Copy>(arc: &mut Arc<J>) -> Option<Pulse> {
    let before = *arc;
    let at = before.walk().position();
    let Some(pulse) = arc.step() else {
        assert!(before.is_done());
        return None;
    };
    let [dx, dy] = pulse.0.map(i64::from);
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
    Some(pulse)
}

/// A step is progress: fewer quadrants are to go, or fewer axes to come to stand, or less of the way:
/// while both go on, what is fed towards zero shrinks or what is fed away from it grows, and then the
/// pulses to the end point get fewer. All of it has a least value.
#[inline(always)]
pub(crate) fn step_makes_progress<J: Judgement + Copy>(arc: &mut Arc<J>) -> bool {
    let before = distance(arc.walk());
    if arc.step().is_none() {
        return false;
    }
    let [quadrants, going, way] = distance(arc.walk());
    let crosses = quadrants < before[0];
    let stands = quadrants == before[0] && going < before[1];
    let moves = quadrants == before[0] && going == before[1] && way < before[2];
    assert!(crosses || stands || moves);
    true
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
#[inline(always)]
pub(crate) fn done_means_end_point<J: Judgement>(arc: &Arc<J>) -> bool {
    let [x, y] = arc.walk().residual();
    let (end, at) = (arc.walk().sweep().end(), arc.walk().position());
    assert!(x == end[0] - at[0] && y == end[1] - at[1]);
    if arc.is_done() {
        assert!(x == 0 && y == 0 && arc.walk().sweep().crossings_left() == 0);
    }
    arc.is_done()
}

/// The coordinate that is fed towards zero in this quadrant, and the one that is fed away from it.
pub(crate) fn magnitudes(walk: &Walk) -> [i64; 2] {
    let (feeds, at) = (walk.sweep().feeds(), walk.position());
    [feeds.towards.axis.of(at).abs(), feeds.away.axis.of(at).abs()]
}

/// Makes a step of an arc that is not at its end, and tells which of these two it feeds.
#[inline(always)]
pub(crate) fn fed<J: Judgement + Copy>(arc: &mut Arc<J>) -> [bool; 2] {
    let feeds = arc.walk().sweep().feeds();
    match arc.step() {
        Some(Pulse(pulse)) => [feeds.towards.axis.of(pulse) != 0, feeds.away.axis.of(pulse) != 0],
        None => panic!("an axis is on its way"),
    }
}
