//! H1 for the textbook's arc by digital integration: two clocks are one step, at every width up to 32
//! bits.

use super::sweep_control::{self, holds_end, may_lag, with_any_leftovers};
use super::{cycle, idle};
use crate::dda_arc::any_state;
use crate::same::same;
use onepulse_core::dda::Arc;
use onepulse_hwmodel::{Sweep, dda};

/// The circuit at the start of a cycle: the integrands follow the machine's position, the remainders are
/// its own. What the sums were is `leftover`.
fn related(arc: &Arc, sweep: Sweep, leftover: [u64; 2]) -> dda::Arc {
    let (jv, jr) = (arc.integrands(), arc.remainders());
    dda::Arc::in_state(jv, jr, leftover, 1 << arc.shift(), sweep, arc.register().digits())
}

#[kani::proof]
fn hardware_dda_arc_clocks_are_a_step() {
    let mut arc = any_state();
    let bits = arc.register().digits();
    kani::assume(holds_end(arc.sweep(), bits));
    let (at, crossings) = (arc.position(), arc.sweep().crossings_left());
    let lags: bool = kani::any();
    kani::assume(!lags || may_lag(arc.sweep(), at));
    let sweep = with_any_leftovers(sweep_control::related(arc.sweep(), at, lags, bits));
    let mut circuit = related(&arc, sweep, kani::any::<[u32; 2]>().map(u64::from));
    kani::cover!(arc.is_done());
    kani::cover!(lags && crossings == 0);
    kani::cover!(arc.sweep().is_stepping_out(at) && !arc.is_done());
    match arc.step() {
        Some(pulse) => {
            kani::cover!(pulse.0[0] == 1 && pulse.0[1] == -1);
            assert!(same(cycle(&mut circuit).0, pulse.0));
        }
        None => idle(&mut circuit),
    }
    let lags = arc.sweep().crossings_left() < crossings;
    kani::cover!(lags);
    let sweep = sweep_control::related(arc.sweep(), arc.position(), lags, bits);
    assert!(circuit.agrees_with(&related(&arc, sweep, [0; 2])));
}
