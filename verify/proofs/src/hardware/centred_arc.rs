//! H1 for the centred staggered arc: four clocks are one step, at every width up to 32 bits, as long as
//! the coordinates stay in their registers.
//!
//! A beat at a time: `related` says what the registers hold before each of the four. Between the axes
//! x has its pulse and y has not.

use super::idle;
use super::sweep_control::{holds_end, may_lag, related_unwrapped, seen, with_any_leftovers};
use crate::centred_arc::any_state;
use crate::same::same;
use onepulse_core::dda::CentredArc;
use onepulse_hwmodel::dda::{self, CentredBeat as Beat};
use onepulse_hwmodel::{Circuit, Sweep};

/// Any state of the machine in registers that hold the way to the end point, too.
fn any_state_in_registers() -> (CentredArc, u32) {
    let arc = any_state();
    let bits = arc.register().digits();
    kani::assume(holds_end(arc.sweep(), bits));
    (arc, bits)
}

/// Whether a coordinate is less than half its register: it has the headroom bit. A state that
/// `any_state` gives has it; that a step keeps it is D6 and D6+.
fn has_headroom(arc: &CentredArc, coordinate: i64) -> bool {
    let half = arc.register().modulus() / 2;
    coordinate.unsigned_abs() << arc.shift() < half
}

/// A step of the machine from a state in which it is not done.
struct Step {
    bits: u32,
    before: CentredArc,
    after: CentredArc,
    pulse: [i8; 2],
}

/// Any step of the machine.
fn any_step() -> Step {
    let (before, bits) = any_state_in_registers();
    let mut after = before;
    let Some(pulse) = after.step() else {
        kani::assume(false);
        unreachable!("it is not done");
    };
    let [x, y] = after.position();
    kani::assume(has_headroom(&after, x) && has_headroom(&after, y));
    kani::cover!(pulse.0[0] == 1 && pulse.0[1] == -1 && after.shift() > 0);
    kani::cover!(before.sweep().is_stepping_out(before.position()));
    Step { bits, before, after, pulse: pulse.0 }
}

/// Any step that takes sums as the machine's steps do, whatever the sums are, so that no solver has to
/// add them up: the machine's steps are among them (`hardware_centred_arc_adds_y`).
fn any_step_that_takes() -> Step {
    let (before, bits) = any_state_in_registers();
    kani::assume(!before.is_done());
    let pulse = [any_pulse(), any_pulse()];
    let jr = kani::any::<[u32; 2]>().map(u64::from);
    let step = Step { bits, before, after: taken(&before, pulse, jr), pulse };
    let [x, y] = step.after.position();
    kani::assume(step.takes_sums());
    kani::assume(has_headroom(&before, x) && has_headroom(&before, y));
    kani::cover!(step.takes(0) && pulse[0] == 1 && pulse[1] == -1 && before.shift() > 0);
    kani::cover!(!step.takes(1) && pulse[1] == -1);
    step
}

fn any_pulse() -> i8 {
    kani::any_where(|pulse: &i8| (-1..=1).contains(pulse))
}

/// The machine after these pulses and with these remainders.
fn taken(before: &CentredArc, pulse: [i8; 2], jr: [u64; 2]) -> CentredArc {
    let ([x, y], mut sweep) = (before.position(), *before.sweep());
    let position = [x + i64::from(pulse[0]), y + i64::from(pulse[1])];
    sweep.arrive(position);
    CentredArc::in_state(sweep, before.register(), before.shift(), jr, position)
}

impl Step {
    /// Whether an axis takes its sum; else its remainder stays.
    fn takes(&self, axis: usize) -> bool {
        let (sweep, at) = (self.before.sweep(), self.before.position());
        !sweep.is_stepping_out(at) && !sweep.stands(at)[axis]
    }

    /// Whether pulse and remainder of each axis are what a sum can hold, or those of an axis that takes
    /// none.
    fn takes_sums(&self) -> bool {
        let (sweep, at) = (self.before.sweep(), self.before.position());
        let (jr, jr_after) = (self.before.remainders(), self.after.remainders());
        let out = sweep.step_out(at).0;
        let steps_out = sweep.is_stepping_out(at);
        let takes_sum = |axis: usize| {
            if self.takes(axis) {
                jr_after[axis] >> self.bits == 0
            } else {
                let pulse = if steps_out { out[axis] } else { 0 };
                jr_after[axis] == jr[axis] && self.pulse[axis] == pulse
            }
        };
        takes_sum(0) && takes_sum(1)
    }

    /// Whether [`any_step_that_takes`] gives this step.
    fn is_one_that_takes(&self) -> bool {
        let [x, y] = self.pulse;
        let taken = taken(&self.before, self.pulse, self.after.remainders());
        let (sweep, expected) = (self.after.sweep(), taken.sweep());
        (-1..=1).contains(&x)
            && (-1..=1).contains(&y)
            && self.takes_sums()
            && same(self.after.position(), taken.position())
            && sweep.crossings_left() == expected.crossings_left()
            && sweep.quadrant() == expected.quadrant()
            && sweep.direction() == expected.direction()
            && same(sweep.end(), expected.end())
            && self.after.shift() == taken.shift()
            && self.after.register() == taken.register()
    }

    /// Where the arc is between the axes: x has its pulse.
    fn between(&self) -> [i64; 2] {
        [self.after.position()[0], self.before.position()[1]]
    }

    /// The remainders there.
    fn remainders_between(&self) -> [u64; 2] {
        [self.after.remainders()[0], self.before.remainders()[1]]
    }

    /// What the sum of an axis holds: the remainder after it and the pulse, or if it is not taken
    /// anything.
    fn sum(&self, axis: usize) -> u64 {
        let top = match self.pulse[axis] {
            0 => 0b00,
            1 => 0b01,
            _ => 0b11,
        };
        let sum = any_sum(self.bits);
        if self.takes(axis) { top << self.bits | self.after.remainders()[axis] } else { sum }
    }

    /// The circuit in the three beats after the look.
    fn related(&self, beat: Beat, at: [i64; 2], jr: [u64; 2], sum: u64) -> dda::CentredArc {
        let (sweep, from) = (self.before.sweep(), self.before.position());
        let end = sweep.end();
        let sweep = seen(sweep, from, self.bits).with_counters([end[0] - at[0], end[1] - at[1]]);
        related(&self.before, beat, at, jr, sum, sweep)
    }
}

/// The circuit whose integrands follow this place.
fn related(
    arc: &CentredArc,
    beat: Beat,
    at: [i64; 2],
    jr: [u64; 2],
    sum: u64,
    sweep: Sweep,
) -> dda::CentredArc {
    let j = [at[0] << arc.shift(), at[1] << arc.shift()];
    dda::CentredArc::in_state(beat, j, jr, sum, 1 << arc.shift(), sweep, arc.register().digits())
}

/// Any content of the sum register.
fn any_sum(bits: u32) -> u64 {
    kani::any::<u64>() & ((4 << bits) - 1)
}

/// The sum of x, and the look.
#[kani::proof]
fn hardware_centred_arc_adds_x() {
    let step = any_step();
    let (before, bits) = (&step.before, step.bits);
    let (at, jr) = (before.position(), before.remainders());
    let lags: bool = kani::any();
    kani::assume(!lags || may_lag(before.sweep(), at));
    kani::cover!(lags && before.sweep().crossings_left() == 0);
    let sweep = with_any_leftovers(related_unwrapped(before.sweep(), at, lags, bits));
    let mut circuit = related(before, Beat::AddX, at, jr, any_sum(bits), sweep);
    assert!(!circuit.done() && !circuit.is_mid_cycle());
    assert!(same(circuit.clock().0, [0, 0]));
    assert!(circuit.agrees_with(&step.related(Beat::MoveX, at, jr, step.sum(0))));
}

/// What x takes of it.
#[kani::proof]
fn hardware_centred_arc_moves_x() {
    let step = any_step_that_takes();
    let (at, jr) = (step.before.position(), step.before.remainders());
    let mut circuit = step.related(Beat::MoveX, at, jr, step.sum(0));
    assert!(circuit.is_mid_cycle() && !circuit.done());
    assert!(same(circuit.clock().0, [step.pulse[0], 0]));
    let (at, jr) = (step.between(), step.remainders_between());
    assert!(circuit.agrees_with(&step.related(Beat::AddY, at, jr, 0)));
}

/// The sum of y.
#[kani::proof]
fn hardware_centred_arc_adds_y() {
    let step = any_step();
    assert!(step.is_one_that_takes());
    let (at, jr) = (step.between(), step.remainders_between());
    let mut circuit = step.related(Beat::AddY, at, jr, any_sum(step.bits));
    assert!(circuit.is_mid_cycle() && !circuit.done());
    assert!(same(circuit.clock().0, [0, 0]));
    assert!(circuit.agrees_with(&step.related(Beat::MoveY, at, jr, step.sum(1))));
}

/// What y takes of it, after which the step is as one that has not begun.
#[kani::proof]
fn hardware_centred_arc_moves_y() {
    let step = any_step_that_takes();
    let (at, jr) = (step.between(), step.remainders_between());
    let mut circuit = step.related(Beat::MoveY, at, jr, step.sum(1));
    assert!(circuit.is_mid_cycle() && !circuit.done());
    assert!(same(circuit.clock().0, [0, step.pulse[1]]));
    let (before, after) = (&step.before, &step.after);
    let (sweep, at) = (after.sweep(), after.position());
    let lags = sweep.crossings_left() < before.sweep().crossings_left();
    kani::cover!(lags);
    assert!(!lags || may_lag(sweep, at));
    let sweep = related_unwrapped(sweep, at, lags, step.bits);
    assert!(circuit.agrees_with(&related(after, Beat::AddX, at, after.remainders(), 0, sweep)));
}

/// It is done when the machine is, and then it idles.
#[kani::proof]
fn hardware_centred_arc_idles() {
    let (arc, bits) = any_state_in_registers();
    let (at, jr) = (arc.position(), arc.remainders());
    let lags: bool = kani::any();
    kani::assume(!lags || may_lag(arc.sweep(), at));
    kani::cover!(lags);
    kani::cover!(arc.is_done());
    let sweep = with_any_leftovers(related_unwrapped(arc.sweep(), at, lags, bits));
    let mut circuit = related(&arc, Beat::AddX, at, jr, any_sum(bits), sweep);
    assert!(circuit.done() == arc.is_done());
    if arc.is_done() {
        idle(&mut circuit);
        let sweep = related_unwrapped(arc.sweep(), at, false, bits);
        assert!(circuit.agrees_with(&related(&arc, Beat::AddX, at, jr, 0, sweep)));
    }
}
