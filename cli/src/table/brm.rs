//! The gated stages of the rate multiplier, clock by clock.

use super::{Language, Table, pulse_name};
use crate::pulses::AXES;
use onepulse_core::brm;

/// The table of a line.
pub(super) struct LineTable<const N: usize> {
    pub(super) machine: brm::Line<N>,
}

/// The table of a line with dividers behind the trains.
pub(super) struct SmoothedTable<const N: usize> {
    pub(super) machine: brm::Smoothed<N>,
}

impl<const N: usize> Table for LineTable<N> {
    fn headings(&self, language: Language) -> Vec<String> {
        let mut headings = source_headings(language);
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
            let mut row = source(clock, gate, language);
            for axis in 0..N {
                row.push(u8::from(values[axis] & gate != 0).to_string());
                row.push(pulse_name(pulse.0[axis], axis));
            }
            Some(row)
        })
    }
}

impl<const N: usize> Table for SmoothedTable<N> {
    fn headings(&self, language: Language) -> Vec<String> {
        let mut headings = source_headings(language);
        for (axis, value) in AXES[..N].iter().zip(self.machine.train().values()) {
            headings.push(format!("{} {axis} ({value})", language.pick("train", "脉冲串")));
            headings.push(format!("{} {axis}", language.pick("divider", "均匀器")));
            headings.push(format!("Δ{axis}"));
        }
        headings
    }

    fn rows(&self, language: Language) -> impl Iterator<Item = Vec<String>> {
        let mut machine = self.machine;
        (1_u64..).map_while(move |clock| {
            let (gate, values) = (machine.train().gate(), machine.train().values());
            let pulse = machine.step()?;
            let mut row = source(clock, gate, language);
            for axis in 0..N {
                row.push(u8::from(values[axis] & gate != 0).to_string());
                row.push(machine.dividers()[axis].to_string());
                row.push(pulse_name(pulse.0[axis], axis));
            }
            Some(row)
        })
    }
}

fn source_headings(language: Language) -> Vec<String> {
    [("clock", "时钟"), ("stage of weight", "通过级的权")]
        .map(|(english, chinese)| language.pick(english, chinese).to_owned())
        .into()
}

/// The clock of the source, and the stage that it passes.
fn source(clock: u64, gate: u64, language: Language) -> Vec<String> {
    let stage =
        if gate == 0 { language.pick("overflow", "溢出").to_owned() } else { gate.to_string() };
    vec![clock.to_string(), stage]
}
