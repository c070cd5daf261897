//! Lines by digital integration, with every preset, plain and normalized.

use super::{Machine, demand, every_end, path, take};
use crate::dda_line;
use crate::sweep::curve::Curve;
use crate::sweep::tally::Tally;
use onepulse_core::dda::{Line, Preset, Radix, Register};

const PRESETS: [(Preset, &str); 3] =
    [(Preset::Zero, "zero"), (Preset::Half, "half load"), (Preset::Full, "full load")];

pub(super) fn machines(bits: u32) -> Vec<Machine> {
    let mut machines = Vec::new();
    for (preset, preset_name) in PRESETS {
        for normalize in [false, true] {
            let suffix = if normalize { ", normalized" } else { "" };
            let name = format!("DDA lines, {preset_name}{suffix}");
            let most = (1 << bits) - 1;
            let draw = move |end, tally: &mut Tally| draw(end, bits, preset, normalize, tally);
            let items = every_end(&name, most, draw);
            let bound = match preset {
                Preset::Half => "≤ √2/2, 2^(n−Q) cycles",
                Preset::Zero | Preset::Full => "< 1, 2^(n−Q) cycles",
            };
            machines.push(Machine { name, bound, items });
        }
    }
    machines
}

fn draw(end: [i32; 2], bits: u32, preset: Preset, normalize: bool, tally: &mut Tally) {
    let to = end.map(i64::from);
    let curve = Curve::Line { end: to };
    let line = Register::new(Radix::Binary, bits)
        .and_then(|register| Line::new(end, register, preset, normalize));
    match line {
        Ok(line) => {
            let walked = path([0, 0], line, 1 << bits);
            let checked = check(to, bits, preset, normalize, &walked);
            take(tally, curve, bits, &walked, checked);
        }
        Err(why) => tally.fault(curve, bits, why.to_string()),
    }
}

fn check(
    end: [i64; 2],
    bits: u32,
    preset: Preset,
    normalize: bool,
    walked: &[[i64; 2]],
) -> Result<(), String> {
    let modulus = 1_u64 << bits;
    let larger = end[0].abs().max(end[1].abs());
    // Q shifts bring the larger coordinate's highest bit to the top of the register.
    let shift = if normalize && larger > 0 { bits - 1 - larger.ilog2() } else { 0 };
    let cycles = walked.len() as u64 - 1;
    demand(cycles == modulus >> shift, || format!("takes {cycles} cycles"))?;
    demand(walked.last() == Some(&end), || "misses its end point".to_owned())?;
    let begun = match preset {
        Preset::Zero => 0,
        Preset::Half => modulus / 2,
        Preset::Full => modulus - 1,
    };
    let length_squared = end[0].pow(2) + end[1].pow(2);
    for (k, &[x, y]) in walked.iter().enumerate() {
        let due = end.map(|c| {
            let integrand = c.unsigned_abs() << shift;
            dda_line::overflows(integrand, begun, modulus, k as u64) as i64 * c.signum()
        });
        demand(due == [x, y], || {
            format!("is at {x},{y} after {k} cycles, not at {},{}", due[0], due[1])
        })?;
        let cross_squared = (end[0] * y - end[1] * x).pow(2);
        let is_within = match preset {
            Preset::Half => 2 * cross_squared <= length_squared,
            Preset::Zero | Preset::Full => cross_squared < length_squared || end == [0, 0],
        };
        demand(is_within, || format!("strays at {x},{y}"))?;
    }
    Ok(())
}
