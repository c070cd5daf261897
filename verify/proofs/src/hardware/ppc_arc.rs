//! H1 for the arc by point-by-point comparison: four clocks are one step, in registers of every width up
//! to 32 bits that holds the coordinates of the circle and of the end point.

use super::{cycle, idle};
use crate::any::{any_axis, any_rule};
use crate::ppc_arc::any_state_of;
use crate::same::same;
use onepulse_core::ppc::Arc;
use onepulse_core::{Axis, EndRule};
use onepulse_hwmodel::{Sweep, ppc};

/// What steps leave in registers that nothing reads before it is written anew: which axis was due last,
/// and whether coordinates were zero, which the sweep control notes for integration.
struct Leftovers {
    due: Axis,
    is_zero: [bool; 2],
}

/// The circuit at the start of a step: F as far as the register holds it, the magnitudes of the
/// coordinates, and in the end counters what is missing to the end point. Two end counters make up the
/// second rule, so that it leaves the one at 0.
fn related(arc: &Arc, rule: EndRule, larger: Axis, bits: u32, leftovers: &Leftovers) -> ppc::Arc {
    let sweep = arc.sweep();
    let (quadrant, crossings) = (sweep.quadrant(), sweep.crossings_left());
    let Leftovers { due, is_zero } = *leftovers;
    let sweep =
        Sweep::in_state(quadrant, crossings, arc.residual(), sweep.direction(), bits, is_zero);
    let e = match rule {
        EndRule::Total | EndRule::Larger => arc.remaining(),
        EndRule::PerAxis => 0,
    };
    let c = arc.position().map(i64::unsigned_abs);
    ppc::Arc::in_state(due, arc.deviation_function(), c, sweep, (rule, larger, e), bits)
}

#[kani::proof]
fn hardware_ppc_arc_clocks_are_a_step() {
    let (rule, larger) = (any_rule(), any_axis());
    let mut arc = any_state_of(rule, larger);
    let bits = u32::from(kani::any_where(|bits: &u8| (1..=32).contains(bits)));
    let is_held = |c: i64| c.unsigned_abs() >> bits == 0;
    let ([x, y], [x_end, y_end]) = (arc.position(), arc.sweep().end());
    kani::assume(is_held(x) && is_held(y) && is_held(x_end) && is_held(y_end));
    kani::assume(is_held(arc.sweep().peak()));
    let leftovers = Leftovers { due: any_axis(), is_zero: kani::any() };
    let mut circuit = related(&arc, rule, larger, bits, &leftovers);
    let crossings = arc.sweep().crossings_left();
    kani::cover!(arc.is_done() && rule == EndRule::Larger);
    match arc.step() {
        Some(pulse) => {
            kani::cover!(pulse.0[0] == -1);
            kani::cover!(pulse.0[1] == 1 && arc.is_done());
            assert!(same(cycle(&mut circuit).0, pulse.0));
        }
        None => idle(&mut circuit),
    }
    kani::cover!(arc.sweep().crossings_left() < crossings);
    assert!(circuit.agrees_with(&related(&arc, rule, larger, bits, &leftovers)));
}
