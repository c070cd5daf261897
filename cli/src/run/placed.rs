//! A circuit of a plane on the axes of the machine.

use onepulse_core::{Plane, Pulse};
use onepulse_hwmodel::{Circuit, Probe};

/// A circuit of two axes, first and second of a plane, or of x, y and z, whose pulse outputs are
/// connected to the drives of x, y and z.
#[derive(Clone, Debug)]
pub(super) struct Placed<C, const AXES: usize> {
    pub(super) circuit: C,
    /// The plane of its axes; XY where it has three.
    pub(super) plane: Plane,
}

/// Pulses of the plane's axes, or of all three, as those of x, y and z.
pub(super) fn place<const AXES: usize>(plane: Plane, Pulse(pulses): Pulse<AXES>) -> Pulse<3> {
    let mut ordered = [0; 3];
    ordered.iter_mut().zip(pulses).for_each(|(slot, pulse)| *slot = pulse);
    Pulse(plane.place(ordered))
}

impl<C: Circuit<AXES>, const AXES: usize> Circuit<3> for Placed<C, AXES> {
    const CLOCKS_PER_CYCLE: u64 = C::CLOCKS_PER_CYCLE;
    const NAME: &'static str = C::NAME;

    fn pulses(&self) -> Pulse<3> {
        place(self.plane, self.circuit.pulses())
    }

    fn done(&self) -> bool {
        self.circuit.done()
    }

    fn is_mid_cycle(&self) -> bool {
        self.circuit.is_mid_cycle()
    }

    fn clock(&mut self) -> Pulse<3> {
        place(self.plane, self.circuit.clock())
    }

    fn probe(&self, probe: &mut impl Probe) {
        self.circuit.probe(probe);
    }
}
