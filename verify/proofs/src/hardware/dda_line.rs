//! H1 for the line by digital integration: one clock is one step, at every width up to 32 bits.

use super::{cycle, idle};
use crate::dda_line::any_state_of_two;
use crate::same::same;
use onepulse_core::dda::Line;
use onepulse_hwmodel::dda;

/// The circuit's registers are the machine's; its counter of accumulations holds those that are left,
/// and a sign flip-flop says where the axis' end point lies.
fn related(line: &Line) -> dda::Line {
    let ([x, y], [x_lacks, y_lacks]) = (line.position(), line.residual());
    let is_negative = [x + x_lacks < 0, y + y_lacks < 0];
    let bits = line.register().digits();
    dda::Line::in_state(line.integrands(), line.remainders(), line.remaining(), is_negative, bits)
}

#[kani::proof]
fn hardware_dda_line_clock_is_a_step() {
    let mut line = any_state_of_two();
    let mut circuit = related(&line);
    kani::cover!(line.is_done());
    match line.step() {
        Some(pulse) => {
            kani::cover!(pulse.0[0] == 1 && pulse.0[1] == -1 && line.shift() > 0);
            assert!(same(cycle(&mut circuit).0, pulse.0));
        }
        None => idle(&mut circuit),
    }
    kani::cover!(line.is_done());
    assert!(circuit.agrees_with(&related(&line)));
}
