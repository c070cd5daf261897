//! H1 for the arc by point-by-point comparison: four clocks are one step, in registers of every width
//! up to 32 bits that holds the circle and the end point.
//!
//! A beat at a time: `related` says what the registers hold before each of the four. The machine crosses
//! into the next quadrant at the end of its step, the circuit in its fourth beat.

use super::idle;
use super::sweep_control::{may_lag, related_unwrapped, seen, with_any_leftovers};
use crate::any::{any_axis, any_rule};
use crate::ppc_arc::any_state;
use crate::same::same;
use onepulse_core::ppc::Arc;
use onepulse_core::{Axis, EndRule};
use onepulse_hwmodel::Circuit;
use onepulse_hwmodel::ppc::{self, Beat};

/// Any state of the machine, and a width of registers that hold the circle, the end point and the place.
fn any_state_in_registers(rule: EndRule) -> (Arc, u32) {
    let arc = any_state(rule);
    let bits = u32::from(kani::any_where(|bits: &u8| (1..=32).contains(bits)));
    let [x, y] = arc.position().map(i64::unsigned_abs);
    kani::assume((arc.sweep().largest_coordinate() | x | y) >> bits == 0);
    (arc, bits)
}

/// Whether F decides: no axis stands.
fn decides(arc: &Arc) -> bool {
    let [x, y] = arc.sweep().stands(arc.position());
    !x && !y
}

/// What the register F holds: the machine's F while it decides, then any word.
fn any_deviation(arc: &Arc, bits: u32) -> i64 {
    let word = kani::any_where(|f: &i64| -(2 << bits) <= *f && *f < 2 << bits);
    if decides(arc) { arc.deviation_function() } else { word }
}

/// The magnitudes of the machine's coordinates.
fn magnitudes(arc: &Arc) -> [u64; 2] {
    arc.position().map(i64::unsigned_abs)
}

/// What the rule's counter holds: what is left by the rule. Two counters make up the second rule, so
/// that it leaves the one at 0.
fn related_counter(arc: &Arc, rule: EndRule) -> (EndRule, Axis, u64) {
    let e = match rule {
        EndRule::Total | EndRule::Larger => arc.remaining(),
        EndRule::PerAxis => 0,
    };
    (rule, arc.larger(), e)
}

/// Any step of the machine from a state in which it is not done.
struct Step {
    rule: EndRule,
    bits: u32,
    before: Arc,
    after: Arc,
    pulse: [i8; 2],
    /// The axis of the pulse.
    due: Axis,
}

fn any_step() -> Step {
    let rule = any_rule();
    let (before, bits) = any_state_in_registers(rule);
    let mut after = before;
    let Some(pulse) = after.step() else {
        kani::assume(false);
        unreachable!("it is not done");
    };
    kani::cover!(after.sweep().crossings_left() < before.sweep().crossings_left());
    kani::cover!(pulse.0[0] == -1 && !decides(&before));
    let due = if pulse.0[0] == 0 { Axis::Y } else { Axis::X };
    Step { rule, bits, before, after, pulse: pulse.0, due }
}

impl Step {
    /// The circuit before one of the first three beats: all but the axis that is due, F and the
    /// coordinates is as before the step.
    fn related(&self, beat: Beat, due: Axis, f: i64, c: [u64; 2]) -> ppc::Arc {
        let sweep = seen(self.before.sweep(), self.before.position(), self.bits);
        let counter = related_counter(&self.before, self.rule);
        ppc::Arc::in_state(beat, due, f, c, sweep, counter, self.bits)
    }

    /// The magnitudes between feed and update: of the two that the pulse lies between the smaller.
    fn smaller(&self) -> [u64; 2] {
        let ([x, y], [x_after, y_after]) = (magnitudes(&self.before), magnitudes(&self.after));
        [x.min(x_after), y.min(y_after)]
    }
}

#[kani::proof]
fn hardware_ppc_arc_judges() {
    let step = any_step();
    let f = any_deviation(&step.before, step.bits);
    let c = magnitudes(&step.before);
    let mut circuit = step.related(Beat::Judge, any_axis(), f, c);
    assert!(!circuit.done() && !circuit.is_mid_cycle());
    assert!(same(circuit.clock().0, [0, 0]));
    assert!(circuit.agrees_with(&step.related(Beat::Feed, step.due, f, c)));
}

#[kani::proof]
fn hardware_ppc_arc_feeds() {
    let step = any_step();
    let f = any_deviation(&step.before, step.bits);
    let mut circuit = step.related(Beat::Feed, step.due, f, magnitudes(&step.before));
    assert!(circuit.is_mid_cycle() && !circuit.done());
    assert!(same(circuit.clock().0, step.pulse));
    assert!(circuit.agrees_with(&step.related(Beat::Update, step.due, f, step.smaller())));
}

/// Coordinates and end counters.
#[kani::proof]
fn hardware_ppc_arc_updates() {
    let step = any_step();
    let f = any_deviation(&step.before, step.bits);
    let mut circuit = step.related(Beat::Update, step.due, f, step.smaller());
    assert!(circuit.is_mid_cycle() && !circuit.done());
    assert!(same(circuit.clock().0, [0, 0]));
    let after = &step.after;
    let (sweep, at) = (after.sweep(), after.position());
    let lags = sweep.crossings_left() < step.before.sweep().crossings_left();
    assert!(!lags || may_lag(sweep, at));
    let sweep = related_unwrapped(sweep, at, lags, step.bits);
    let (c, counter) = (magnitudes(after), related_counter(after, step.rule));
    let f = circuit.deviation_function();
    let related = ppc::Arc::in_state(Beat::Compare, step.due, f, c, sweep, counter, step.bits);
    assert!(circuit.agrees_with(&related));
}

/// F is the machine's as long as it decides.
#[kani::proof]
fn hardware_ppc_arc_updates_deviation() {
    let step = any_step();
    // An axis that stands goes on standing.
    assert!(decides(&step.before) || !decides(&step.after));
    kani::assume(decides(&step.after));
    // ppc_arc_step_preserves_invariant.
    let (peak, f) = (step.after.sweep().peak(), step.after.deviation_function());
    kani::assume(-2 * peak < f && f <= 2 * peak);
    kani::cover!(f < 0 && step.bits == 1);
    let before = step.before.deviation_function();
    let mut circuit = step.related(Beat::Update, step.due, before, step.smaller());
    circuit.clock();
    assert!(circuit.deviation_function() == f);
}

/// The fourth beat, after which the step is as one that has not begun.
#[kani::proof]
fn hardware_ppc_arc_compares() {
    let rule = any_rule();
    let (arc, bits) = any_state_in_registers(rule);
    let (at, f) = (arc.position(), any_deviation(&arc, bits));
    let lags: bool = kani::any();
    kani::assume(!lags || may_lag(arc.sweep(), at));
    kani::cover!(lags && arc.sweep().crossings_left() == 0);
    kani::cover!(!decides(&arc));
    let (due, c, counter) = (any_axis(), magnitudes(&arc), related_counter(&arc, rule));
    let sweep = with_any_leftovers(related_unwrapped(arc.sweep(), at, lags, bits));
    let mut circuit = ppc::Arc::in_state(Beat::Compare, due, f, c, sweep, counter, bits);
    assert!(circuit.is_mid_cycle() && !circuit.done());
    assert!(same(circuit.clock().0, [0, 0]));
    let sweep = seen(arc.sweep(), at, bits);
    let mut related = ppc::Arc::in_state(Beat::Judge, due, f, c, sweep, counter, bits);
    assert!(circuit.agrees_with(&related));
    assert!(related.done() == arc.is_done());
    if arc.is_done() {
        idle(&mut related);
        assert!(circuit.agrees_with(&related));
    }
}
