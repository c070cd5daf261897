//! The sweep control of the arcs by digital integration, beside the sweep of the machine.

use onepulse_core as software;
use onepulse_hwmodel::Sweep;

/// Whether the circuit may still be in the quadrant before: a machine crosses over at the end of a step,
/// a circuit looks for it at the start of its cycle. A circuit that has just been loaded, on an axis,
/// need not cross.
pub(super) fn may_lag(sweep: &software::Sweep, position: [i64; 2]) -> bool {
    let away = sweep.feeds().away.axis;
    away.of(position) == 0 && away.other().of(position) != 0 && sweep.crossings_left() < 4
}

/// The sweep control at the start of a cycle: quadrant and crossings are the machine's, or those before
/// them; the end counters hold what is missing to the end point.
pub(super) fn related(sweep: &software::Sweep, position: [i64; 2], lags: bool, bits: u32) -> Sweep {
    let direction = sweep.direction();
    let (quadrant, crossings) = if lags {
        (sweep.quadrant().next(direction.reversed()), sweep.crossings_left() + 1)
    } else {
        (sweep.quadrant(), sweep.crossings_left())
    };
    let je = [sweep.end()[0] - position[0], sweep.end()[1] - position[1]];
    Sweep::in_state(quadrant, crossings, je, direction, bits, [false; 2])
}

/// The same with anything in the flip-flops that the cycle's look writes.
pub(super) fn with_any_leftovers(sweep: Sweep) -> Sweep {
    let [at_end, stands, negative, shrinks]: [[bool; 2]; 4] = kani::any();
    sweep.with_leftovers(at_end, stands, kani::any(), negative, shrinks)
}

/// Whether registers of so many bits hold the end point, so that the end counters hold the way to it.
pub(super) fn holds_end(sweep: &software::Sweep, bits: u32) -> bool {
    sweep.end().iter().all(|c| c.unsigned_abs() >> bits == 0)
}
