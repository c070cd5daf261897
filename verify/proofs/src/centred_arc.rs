//! Arc by digital integration, staggered and centred: D4, D6, N1 for every width up to 32 bits.
//!
//! D6 for every n: with a = JR_x − 2^(n−1) and b = JR_y − 2^(n−1), Ψ = 2ⁿ(x² + y²) + 2(ax + by) ∓ xy
//! (− ccw, + cw) changes at pulses only, and by so little that it bounds the radius. The step is
//! here; the algebra is in `verify/lemmas/centred_arc.smt2`, the argument in
//! `docs/proofs/centred_arc.md`.

use crate::any::any_binary_register;
use crate::quadrant_walk::{any_place, any_start, distance, is_less, is_place};
use onepulse_core::dda::CentredArc;
use onepulse_core::{Direction, Feeds};

/// Any state that satisfies the invariant, with room for one pulse in the registers.
pub(crate) fn any_state() -> CentredArc {
    let (sweep, position) = any_place();
    let register = any_binary_register();
    let shift = u32::from(kani::any_where(|shift: &u8| u32::from(*shift) < register.digits()));
    let jr: [u32; 2] = kani::any();
    let arc = CentredArc::in_state(sweep, register, shift, jr.map(u64::from), position);
    let half = register.modulus() / 2;
    let has_room = |c: i64| (c.unsigned_abs() + 1) << shift <= half;
    kani::assume(arc.invariant() && position.into_iter().all(has_room));
    arc
}

fn signed(is_negative: bool, value: i64) -> i64 {
    if is_negative { -value } else { value }
}

/// A register serves the arc if the largest coordinate is less than half of it, the headroom bit; that
/// is what normalization leaves. y starts at half load, x half a step of y ahead of it.
#[kani::proof]
fn centred_arc_new_establishes_invariant() {
    let (sweep, start) = any_start();
    let (register, normalize): (_, bool) = (any_binary_register(), kani::any());
    let half = register.modulus() / 2;
    let largest = sweep.largest_coordinate();
    let Ok(arc) = CentredArc::along_given(sweep, start, register, normalize) else {
        assert!(largest >= half);
        return;
    };
    let shift = arc.shift();
    kani::cover!(shift > 0);
    assert!(largest << shift < half);
    assert!(if normalize { largest << (shift + 1) >= half } else { shift == 0 });
    let (at, jr) = (arc.position(), arc.remainders());
    assert!(at[0] == i64::from(start[0]) && at[1] == i64::from(start[1]));
    let ahead = (at[1] << shift) / 2;
    let is_cw = arc.sweep().direction() == Direction::Cw;
    assert!(jr[0] as i64 == half as i64 + signed(is_cw, ahead) && jr[1] == half);
    assert!(arc.invariant());
    assert!(is_place(arc.sweep(), at));
}

/// D6's step, until an axis stands. A remainder, as a number about zero, takes its integrand and
/// gives 2ⁿ to each pulse; a pulse has the sign of its integrand; and what it changes Ψ by,
/// p(2a ∓ y) − 2ⁿ and q(2b ± x') − 2ⁿ, is no more than the integrand.
#[kani::proof]
fn centred_arc_step_bounds_its_change() {
    let mut arc = any_state();
    kani::assume(arc.shift() == 0);
    let at = arc.position();
    let stands = arc.sweep().stands(at);
    kani::assume(!stands[0] && !stands[1]);
    let modulus = arc.register().modulus() as i64;
    let half = modulus / 2;
    let about_zero = |arc: &CentredArc| arc.remainders().map(|jr| jr as i64 - half);
    let [a, b] = about_zero(&arc);
    let turn = arc.sweep().direction() == Direction::Cw;
    let Some(pulse) = arc.step() else { panic!("an arc on its way is not done") };
    let [p, q] = pulse.0;
    kani::cover!(p == 1 && q == -1);
    kani::cover!(p == 0 && q == 0);
    let [x, y] = arc.position();
    let [a_after, b_after] = about_zero(&arc);
    // x takes its pulse before y is fed by it.
    for (remainder, after, integrand, pulse) in
        [(a, a_after, signed(!turn, at[1]), p), (b, b_after, signed(turn, x), q)]
    {
        assert!(-half <= after && after < half);
        let worth = match pulse {
            0 => 0,
            1 => modulus,
            _ => -modulus,
        };
        assert!(after == remainder + integrand - worth);
        if pulse != 0 {
            assert!((pulse > 0) == (integrand > 0) && integrand != 0);
            let change = signed(pulse < 0, 2 * remainder + integrand) - modulus;
            assert!(change.abs() <= integrand.abs());
        }
    }
    assert!(x == at[0] + i64::from(p) && y == at[1] + i64::from(q));
}

/// A pulse is one step where the quadrant leads, and an axis that stands does nothing.
#[kani::proof]
fn centred_arc_step_follows_quadrant() {
    let mut arc = any_state();
    let before = arc;
    let at = arc.position();
    let stands = arc.sweep().stands(at);
    let Feeds { towards, away } = arc.sweep().feeds();
    kani::assume(!arc.sweep().is_stepping_out(at));
    let Some(pulse) = arc.step() else {
        assert!(before.is_done());
        return;
    };
    kani::cover!(stands[0] && pulse.0[1] != 0);
    let to = arc.position();
    for feed in [towards, away] {
        let pulse = feed.axis.of(pulse.0);
        assert!(feed.axis.of(to) == feed.axis.of(at) + i64::from(pulse));
        assert!(pulse == 0 || pulse == feed.sign);
        assert!(!feed.axis.of(stands) || pulse == 0);
    }
}

#[kani::proof]
fn centred_arc_step_preserves_invariant() {
    let mut arc = any_state();
    let crossings = arc.sweep().crossings_left();
    arc.step();
    kani::cover!(arc.sweep().crossings_left() < crossings);
    kani::cover!(arc.is_done());
    assert!(arc.invariant());
    assert!(is_place(arc.sweep(), arc.position()));
}

/// D4: every step is progress, so that every arc ends.
#[kani::proof]
fn centred_arc_step_makes_progress() {
    let mut arc = any_state();
    let modulus = arc.register().modulus();
    let before = arc;
    if arc.step().is_none() {
        return;
    }
    kani::cover!(before.sweep().is_stepping_out(before.position()));
    kani::cover!(arc.sweep().crossings_left() < before.sweep().crossings_left());
    // A remainder runs up to a carry or down to a borrow.
    let far = |arc: &CentredArc| {
        distance(arc.sweep(), arc.position(), |feed| {
            let jr = feed.axis.of(arc.remainders());
            if feed.sign > 0 { modulus - jr } else { jr }
        })
    };
    assert!(is_less(far(&arc), far(&before)));
}

#[kani::proof]
fn centred_arc_done_means_end_point() {
    let arc = any_state();
    kani::cover!(arc.is_done());
    let (at, end) = (arc.position(), arc.sweep().end());
    if arc.is_done() {
        assert!(at[0] == end[0] && at[1] == end[1] && arc.remaining() == 0);
    }
    // The sum of the two end counters.
    if arc.sweep().crossings_left() == 0 {
        assert!(arc.remaining() == at[0].abs_diff(end[0]) + at[1].abs_diff(end[1]));
    }
}
