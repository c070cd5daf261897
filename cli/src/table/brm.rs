//! The gated stages of the rate multiplier, clock by clock.

use super::{Language, Table, pulse_name};
use crate::pulses::AXES;
use onepulse_core::brm;

/// The table of a line.
pub(super) struct LineTable<const N: usize> {
    pub(super) machine: brm::Line<N>,
}

impl<const N: usize> Table for LineTable<N> {
    fn headings(&self, language: Language) -> Vec<String> {
        let mut headings = vec![
            language.pick("clock", "时钟").to_owned(),
            language.pick("stage of weight", "通过级的权").to_owned(),
        ];
        for (axis, value) in AXES[..N].iter().zip(self.machine.values()) {
            let gate = language.pick("gate", "门");
            headings.push(format!("{gate} {axis} ({value})"));
            headings.push(format!("Δ{axis}"));
        }
        headings
    }

    fn rows(&self, language: Language) -> impl Iterator<Item = Vec<String>> {
        let mut machine = self.machine;
        (1_u64..).map_while(move |clock| {
            let gate = machine.gate();
            let values = machine.values();
            let pulse = machine.step()?;
            let stage = if gate == 0 {
                language.pick("overflow", "溢出").to_owned()
            } else {
                gate.to_string()
            };
            let mut row = vec![clock.to_string(), stage];
            for axis in 0..N {
                row.push(u8::from(values[axis] & gate != 0).to_string());
                row.push(pulse_name(pulse.0[axis], axis));
            }
            Some(row)
        })
    }
}
