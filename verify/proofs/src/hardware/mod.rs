//! H1: the circuits of `onepulse-hwmodel` do what the machines of `onepulse-core` do.
//!
//! For each machine `related` writes down what the registers of its circuit hold in each of its states.
//! From **any** such pair, reachable or not, the clocks of one cycle send the pulses of one step, and
//! leave a pair behind; so the two go on together, for runs of any length.

mod brm_line;
mod centred_arc;
mod dda_arc;
mod dda_line;
mod ppc_arc;
mod ppc_line;
mod sweep_control;

use onepulse_core::Pulse;
use onepulse_hwmodel::Circuit;

/// Clocks a circuit that is not done through one cycle; its pulses together.
#[inline(always)]
fn cycle<C: Circuit>(circuit: &mut C) -> Pulse {
    let mut pulses = Pulse::NONE;
    for clock in 0..C::CLOCKS_PER_CYCLE {
        assert!(circuit.is_mid_cycle() == (clock > 0) && !circuit.done());
        let Pulse([x, y]) = circuit.clock();
        pulses.0[0] += x;
        pulses.0[1] += y;
    }
    pulses
}

/// Clocks a circuit that is done, as the pulse source does that goes on: it sends nothing.
#[inline(always)]
fn idle<C: Circuit>(circuit: &mut C) {
    assert!(circuit.done() && !circuit.is_mid_cycle());
    let Pulse([x, y]) = circuit.clock();
    assert!(x == 0 && y == 0);
}
