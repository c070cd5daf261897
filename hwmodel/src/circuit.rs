//! What every circuit can do: show its outputs, take a clock edge, be traced.

use crate::probe::Probe;
use onepulse_core::Pulse;

/// A clocked circuit that interpolates one curve.
pub trait Circuit<const AXES: usize = 2> {
    /// Clocks that one interpolation cycle takes.
    const CLOCKS_PER_CYCLE: u64;

    /// The circuit's name in traces.
    const NAME: &'static str;

    /// The pulse wires during this clock.
    fn pulses(&self) -> Pulse<AXES>;

    /// The done wire: the end counters stand, no cycle is under way, and no pulse follows.
    fn done(&self) -> bool;

    /// Whether a cycle is under way: its further clocks do not wait for the pulse source.
    fn is_mid_cycle(&self) -> bool {
        false
    }

    /// A clock edge with the pulse source: every register takes its next content at once. Returns the pulses of the
    /// clock that it ends.
    fn clock(&mut self) -> Pulse<AXES>;

    /// Shows every register and every wire worth seeing, in one fixed order.
    fn probe(&self, probe: &mut impl Probe);

    /// Runs the circuit on, an interpolation cycle at a time.
    fn cycles(self) -> Cycles<Self, AXES>
    where
        Self: Sized,
    {
        Cycles { circuit: self }
    }
}

/// The interpolation cycles of a circuit: for each, the pulses of its clocks together.
#[derive(Clone, Debug)]
pub struct Cycles<C, const AXES: usize> {
    circuit: C,
}

impl<C: Circuit<AXES>, const AXES: usize> Iterator for Cycles<C, AXES> {
    type Item = Pulse<AXES>;

    fn next(&mut self) -> Option<Pulse<AXES>> {
        if self.circuit.done() {
            return None;
        }
        let mut cycle = Pulse::NONE;
        for _ in 0..C::CLOCKS_PER_CYCLE {
            let pulses = self.circuit.clock();
            for axis in 0..AXES {
                cycle.0[axis] += pulses.0[axis];
            }
        }
        Some(cycle)
    }
}
