//! H1 for the line by point-by-point comparison: four clocks are one step, in registers of every width
//! up to 32 bits that holds the end point.

use super::{cycle, idle};
use crate::any::{any_axis, any_rule};
use crate::ppc_line::any_state;
use crate::same::same;
use onepulse_core::ppc::Line;
use onepulse_core::{Axis, EndRule};
use onepulse_hwmodel::ppc;

/// The circuit at the start of a step: F is the machine's, the axes' end counters hold the pulses that
/// they have to go, the rule's counter what is left by the rule. Two counters make up the second rule,
/// so that it leaves the one at 0. Which axis was due last is `leftover`.
fn related(line: &Line, end: [i32; 2], rule: EndRule, bits: u32, leftover: Axis) -> ppc::Line {
    let magnitude = end.map(|c| u64::from(c.unsigned_abs()));
    let larger = if magnitude[0] >= magnitude[1] { Axis::X } else { Axis::Y };
    let e = match rule {
        EndRule::Total | EndRule::Larger => line.remaining(),
        EndRule::PerAxis => 0,
    };
    let (f, je) = (line.deviation_function(), line.pulses_to_go());
    let is_negative = end.map(|c| c < 0);
    ppc::Line::in_state(leftover, f, je, (rule, larger, e), magnitude, is_negative, bits)
}

#[kani::proof]
fn hardware_ppc_line_clocks_are_a_step() {
    let end: [i32; 2] = kani::any();
    let rule = any_rule();
    let (mut line, _) = any_state(end, rule);
    let bits = u32::from(kani::any_where(|bits: &u8| (1..=32).contains(bits)));
    kani::assume(end.iter().all(|c| u64::from(c.unsigned_abs()) >> bits == 0));
    let mut circuit = related(&line, end, rule, bits, any_axis());
    kani::cover!(line.is_done() && line.residual()[1] != 0);
    match line.step() {
        Some(pulse) => {
            kani::cover!(pulse.0[0] == -1);
            kani::cover!(pulse.0[1] == 1 && line.is_done());
            assert!(same(cycle(&mut circuit).0, pulse.0));
        }
        None => idle(&mut circuit),
    }
    assert!(circuit.agrees_with(&related(&line, end, rule, bits, Axis::X)));
}
