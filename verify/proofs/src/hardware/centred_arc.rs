//! H1 for the centred staggered arc: four clocks are one step, at every width up to 32 bits.

use super::integration::{self, holds_end, may_lag, with_any_leftovers};
use super::{cycle, idle};
use crate::centred_arc::any_state;
use crate::same::same;
use onepulse_core::dda::CentredArc;
use onepulse_hwmodel::{Sweep, dda};

/// The circuit at the start of a cycle: the machine's coordinates, shifted left by Q, and its remainders.
/// What the sum was is `leftover`.
fn related(arc: &CentredArc, sweep: Sweep, leftover: u64) -> dda::CentredArc {
    let (j, jr) = (arc.position().map(|c| c << arc.shift()), arc.remainders());
    dda::CentredArc::in_state(j, jr, leftover, 1 << arc.shift(), sweep, arc.register().digits())
}

#[kani::proof]
fn hardware_centred_arc_clocks_are_a_step() {
    let mut arc = any_state();
    let bits = arc.register().digits();
    kani::assume(holds_end(arc.sweep(), bits));
    let (at, crossings) = (arc.position(), arc.sweep().crossings_left());
    let lags: bool = kani::any();
    kani::assume(!lags || may_lag(arc.sweep(), at));
    let sweep = with_any_leftovers(integration::related(arc.sweep(), at, lags, bits));
    let mut circuit = related(&arc, sweep, u64::from(kani::any::<u32>()));
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
    let sweep = integration::related(arc.sweep(), arc.position(), lags, bits);
    assert!(circuit.agrees_with(&related(&arc, sweep, 0)));
}
