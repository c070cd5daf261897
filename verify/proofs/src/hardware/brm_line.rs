//! H1 for the line by rate multiplier: one clock is one clock, with any number of stages up to 32.

use super::{cycle, idle};
use crate::any::any_binary_register;
use crate::brm::any_end;
use crate::same::same;
use onepulse_core::brm::Line;
use onepulse_hwmodel::brm;

/// The divider holds the clocks counted so far, in as many bits as it has stages: none when it has
/// overflowed, which has reset TG. The value registers hold |end|.
fn related(line: &Line, end: [i32; 2]) -> brm::Line {
    let is_negative = end.map(|c| c < 0);
    let register = line.register();
    let divider = line.clock() & (register.modulus() - 1);
    let tg = line.clock() < register.modulus();
    brm::Line::in_state(divider, tg, line.values(), is_negative, register.digits())
}

#[kani::proof]
#[kani::unwind(34)]
fn hardware_brm_line_clock_is_a_step() {
    let register = any_binary_register();
    let end = [any_end(register.modulus()), any_end(register.modulus())];
    let clock = kani::any_where(|clock: &u64| *clock <= register.modulus());
    let mut line = Line::after_clocks(end, register, clock);
    let mut circuit = related(&line, end);
    kani::cover!(line.is_done());
    match line.step() {
        Some(pulse) => {
            kani::cover!(pulse.0[0] == 1 && pulse.0[1] == -1);
            kani::cover!(line.is_done());
            assert!(same(cycle(&mut circuit).0, pulse.0));
        }
        None => idle(&mut circuit),
    }
    assert!(circuit.agrees_with(&related(&line, end)));
}
