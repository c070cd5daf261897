//! A helix, cycle by cycle: how the cycles are shared out between arc and linear axis, and what each
//! does with them.

use super::{Language, Table, pulse_name};
use crate::pulses::AXES;
use onepulse_core::{Helix, Pulse};

/// The table of a helix.
pub(super) struct HelixTable {
    pub(super) machine: Helix,
}

impl Table for HelixTable {
    fn headings(&self, language: Language) -> Vec<String> {
        let mut headings = vec![
            language.pick("cycle", "序号").to_owned(),
            format!("{} JR", language.pick("distributor's remainder", "分配余数")),
            format!("{} F", language.pick("deviation function", "偏差")),
        ];
        headings.extend(AXES[..3].iter().map(|axis| format!("Δ{axis}")));
        headings.extend(AXES[..3].iter().map(|axis| (*axis).to_owned()));
        headings.push(language.pick("cycles to go", "终点判别").to_owned());
        headings
    }

    fn rows(&self, _: Language) -> impl Iterator<Item = Vec<String>> {
        let mut machine = self.machine;
        let first = row(0, &machine, Pulse::NONE);
        let rest = (1..).map_while(move |cycle| {
            let pulse = machine.step()?;
            Some(row(cycle, &machine, pulse))
        });
        std::iter::once(first).chain(rest)
    }
}

fn row(cycle: u64, helix: &Helix, Pulse(pulse): Pulse<3>) -> Vec<String> {
    let mut row = vec![
        cycle.to_string(),
        helix.remainder().to_string(),
        helix.arc().deviation_function().to_string(),
    ];
    row.extend((0..3).map(|axis| pulse_name(pulse[axis], axis)));
    row.extend(helix.position().map(|c| c.to_string()));
    row.push(helix.remaining().to_string());
    row
}
