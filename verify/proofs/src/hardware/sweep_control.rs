//! The sweep control of the circuits of arcs, beside the sweep of the machine.

use onepulse_core::{self as software, Axis, Feeds};
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

/// The same where the registers hold the position and the end point, so that the end counters need not
/// wrap.
pub(super) fn related_unwrapped(
    sweep: &software::Sweep,
    position: [i64; 2],
    lags: bool,
    bits: u32,
) -> Sweep {
    let end = sweep.end();
    related(sweep, position, lags, bits).with_counters([end[0] - position[0], end[1] - position[1]])
}

/// The same with anything in the flip-flops that the cycle's look writes.
pub(super) fn with_any_leftovers(sweep: Sweep) -> Sweep {
    let [at_end, stands, negative, shrinks]: [[bool; 2]; 4] = kani::any();
    sweep.with_leftovers(at_end, stands, kani::any(), negative, shrinks)
}

/// The same after a look: in the last quadrant an axis stands whose end counter is at zero or past it,
/// and every pulse goes to the end point; before it every axis goes where the quadrant leads. A pulse
/// makes the coordinate that is fed towards zero smaller, or one that goes back.
pub(super) fn seen(sweep: &software::Sweep, position: [i64; 2], bits: u32) -> Sweep {
    let is_last = sweep.crossings_left() == 0;
    let (Feeds { towards, away }, end) = (sweep.feeds(), sweep.end());
    let at_end = [position[0] == end[0], position[1] == end[1]];
    let see = |axis: Axis| {
        let feed = if axis == towards.axis { towards } else { away };
        let to_end = axis.of(end) < axis.of(position);
        let negative = if is_last { to_end } else { feed.sign < 0 };
        let goes_back = negative != (feed.sign < 0);
        (negative, (axis == towards.axis) != goes_back)
    };
    let [(nx, shrinks_x), (ny, shrinks_y)] = [see(Axis::X), see(Axis::Y)];
    related_unwrapped(sweep, position, false, bits).with_look(
        at_end,
        sweep.stands(position),
        sweep.is_stepping_out(position),
        [nx, ny],
        [shrinks_x, shrinks_y],
    )
}

/// Whether registers of so many bits hold the end point, so that the end counters hold the way to it.
pub(super) fn holds_end(sweep: &software::Sweep, bits: u32) -> bool {
    sweep.end().iter().all(|c| c.unsigned_abs() >> bits == 0)
}
