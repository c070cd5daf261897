//! A circuit behind its pulse source.

use onepulse_core::Pulse;
use onepulse_hwmodel::Circuit;

/// A circuit whose clocks may come without `i_en`.
///
/// This is the one place that knows what such a clock means, in the model as in the twin: no
/// cycle begins, but one that is under way goes on.
#[derive(Debug)]
pub(super) struct Driven<C> {
    pub(super) circuit: C,
}

impl<C> Driven<C> {
    pub(super) const fn new(circuit: C) -> Self {
        Self { circuit }
    }

    /// The pulse wires during a clock.
    pub(super) fn pulses<const AXES: usize>(&self, is_enabled: bool) -> Pulse<AXES>
    where
        C: Circuit<AXES>,
    {
        if is_enabled || self.circuit.is_mid_cycle() { self.circuit.pulses() } else { Pulse::NONE }
    }

    /// The edge that ends a clock.
    pub(super) fn edge<const AXES: usize>(&mut self, is_enabled: bool)
    where
        C: Circuit<AXES>,
    {
        if is_enabled || self.circuit.is_mid_cycle() {
            self.circuit.clock();
        }
    }
}
