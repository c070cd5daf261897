//! Arc by digital integration as the textbooks have it: D1, D4, N1 for every width up to 32 bits.
//!
//! The harnesses assume that there is room for one pulse more in the integrands' registers. Whether an
//! arc that crosses quadrants can come to their end is the sweeps' to say (see the claims).

use crate::any::{any_binary_register, any_preset};
use crate::quadrant_walk::{any_place, any_start, distance, is_less, is_place};
use onepulse_core::Feeds;
use onepulse_core::dda::Arc;

/// Any state that satisfies the invariant, with room for one pulse in the registers.
pub(crate) fn any_state() -> Arc {
    let (sweep, position) = any_place();
    let register = any_binary_register();
    let shift = u32::from(kani::any_where(|shift: &u8| u32::from(*shift) < register.digits()));
    let jr: [u32; 2] = kani::any();
    let arc = Arc::in_state(sweep, register, shift, jr.map(u64::from), position);
    let modulus = register.modulus();
    let has_room = |c: i64| (c.unsigned_abs() + 1) << shift < modulus;
    kani::assume(arc.invariant() && position.into_iter().all(has_room));
    arc
}

/// A register serves the arc if the largest coordinate fits, and with crossings 5 more. Normalization
/// shifts the start's larger coordinate to the second bit, if what must fit does not forbid it.
#[kani::proof]
fn dda_arc_new_establishes_invariant() {
    let (sweep, start) = any_start();
    let (register, preset, normalize) = (any_binary_register(), any_preset(), kani::any());
    let modulus = register.modulus();
    let crosses = sweep.crossings_left() > 0;
    let largest = sweep.largest_coordinate() + if crosses { 5 } else { 0 };
    let Ok(arc) = Arc::along_given(sweep, start, register, preset, normalize) else {
        assert!(largest >= modulus);
        return;
    };
    kani::cover!(crosses && arc.shift() > 0);
    assert!(largest < modulus && largest << arc.shift() < modulus);
    let at_start = u64::from(start[0].unsigned_abs().max(start[1].unsigned_abs()));
    assert!(arc.shift() == 0 || normalize && at_start << arc.shift() < modulus / 2);
    assert!(
        !normalize
            || at_start << arc.shift() >= modulus / 4
            || largest << (arc.shift() + 1) >= modulus
    );
    let (at, jr) = (arc.position(), arc.remainders());
    assert!(at[0] == i64::from(start[0]) && at[1] == i64::from(start[1]));
    assert!(jr[0] == preset.value(register) && jr[1] == jr[0]);
    assert!(arc.invariant());
    assert!(is_place(arc.sweep(), at));
}

/// D1: an accumulation adds the integrand as it was to what remainder and pulse are worth together;
/// a pulse is one step where the quadrant leads; an axis that stands does nothing.
#[kani::proof]
fn dda_arc_step_adds_integrands() {
    let mut arc = any_state();
    let before = arc;
    let at = arc.position();
    let stands = arc.sweep().stands(at);
    let Feeds { towards, away } = arc.sweep().feeds();
    let (jv, jr) = (arc.integrands(), arc.remainders());
    kani::assume(!arc.sweep().is_stepping_out(at));
    let Some(pulse) = arc.step() else {
        assert!(before.is_done());
        return;
    };
    kani::cover!(pulse.0[0] != 0 && pulse.0[1] != 0);
    kani::cover!(stands[0] && pulse.0[1] != 0);
    let (to, after) = (arc.position(), arc.remainders());
    for feed in [towards, away] {
        let axis = feed.axis;
        let pulse = axis.of(pulse.0);
        assert!(axis.of(to) == axis.of(at) + i64::from(pulse));
        assert!(pulse == 0 || pulse == feed.sign);
        if axis.of(stands) {
            assert!(pulse == 0 && axis.of(after) == axis.of(jr));
        } else {
            let worth = u64::from(pulse.unsigned_abs()) << arc.register().digits();
            assert!(worth + axis.of(after) == axis.of(jr) + axis.of(jv));
        }
    }
}

#[kani::proof]
fn dda_arc_step_preserves_invariant() {
    let mut arc = any_state();
    let crossings = arc.sweep().crossings_left();
    arc.step();
    kani::cover!(arc.sweep().crossings_left() < crossings);
    kani::cover!(arc.is_done());
    assert!(arc.invariant());
    assert!(is_place(arc.sweep(), arc.position()));
}

/// D4: every step is progress, so that every arc ends, whatever its preset.
#[kani::proof]
fn dda_arc_step_makes_progress() {
    let mut arc = any_state();
    let modulus = arc.register().modulus();
    let before = arc;
    if arc.step().is_none() {
        return;
    }
    kani::cover!(before.sweep().is_stepping_out(before.position()));
    kani::cover!(arc.sweep().crossings_left() < before.sweep().crossings_left());
    let far = |arc: &Arc| {
        distance(arc.sweep(), arc.position(), |feed| modulus - feed.axis.of(arc.remainders()))
    };
    assert!(is_less(far(&arc), far(&before)));
}

#[kani::proof]
fn dda_arc_done_means_end_point() {
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
