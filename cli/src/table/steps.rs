//! Machines that judge, feed and compute their deviation anew, step by step.

use super::{Language, Table, pulse_name};
use crate::pulses::AXES;
use onepulse_core::Pulse;

/// A machine whose steps a table shows.
pub(super) trait Steps<const N: usize>: Iterator<Item = Pulse<N>> + Copy {
    /// The deviation before the first step.
    fn first(&self) -> String;

    /// What decides on step `step` + 1.
    fn judged(&self, step: u64, language: Language) -> String;

    /// How step `step` made the deviation what it is; `before` is the machine before it.
    fn updated(&self, before: &Self, step: u64) -> String;

    /// The present point.
    fn position(&self) -> [i64; N];

    /// What the end counters hold.
    fn to_go(&self) -> [u64; N];
}

/// The table of such a machine.
pub(super) struct StepTable<M, const N: usize> {
    pub(super) machine: M,
}

impl<M: Steps<N>, const N: usize> Table for StepTable<M, N> {
    fn headings(&self, language: Language) -> Vec<String> {
        let pick = |english, chinese| language.pick(english, chinese).to_owned();
        let mut headings = vec![
            pick("step", "序号"),
            pick("judge", "偏差判别"),
            pick("feed", "坐标进给"),
            pick("update", "偏差计算"),
        ];
        headings.extend(AXES[..N].iter().map(ToString::to_string));
        let counter = language.pick("end counter", "终点计数器");
        headings.extend(AXES[..N].iter().map(|axis| format!("{counter} E{axis}")));
        headings
    }

    fn rows(&self, language: Language) -> impl Iterator<Item = Vec<String>> {
        let mut machine = self.machine;
        let mut first = vec![language.pick("start", "起点").to_owned(), String::new()];
        first.extend([String::new(), machine.first()]);
        first.extend(place(&machine));
        let steps = (1_u64..).map_while(move |step| {
            let before = machine;
            let pulse = machine.next()?;
            let mut row = vec![
                step.to_string(),
                before.judged(step - 1, language),
                fed(pulse),
                machine.updated(&before, step),
            ];
            row.extend(place(&machine));
            Some(row)
        });
        std::iter::once(first).chain(steps)
    }
}

/// The coordinates, then the end counters.
fn place<M: Steps<N>, const N: usize>(machine: &M) -> impl Iterator<Item = String> + use<M, N> {
    let position = machine.position().map(|c| c.to_string());
    position.into_iter().chain(machine.to_go().map(|counter| counter.to_string()))
}

/// The pulses of a step: +Δx -Δy.
pub(super) fn fed<const N: usize>(Pulse(pulse): Pulse<N>) -> String {
    let names = (0..N).map(|axis| pulse_name(pulse[axis], axis));
    names.filter(|name| !name.is_empty()).collect::<Vec<_>>().join(" ")
}

/// A value against zero: F3 = 2 > 0.
pub(super) fn against_zero(name: &str, step: u64, value: i64) -> String {
    match value {
        0 => format!("{name}{step} = 0"),
        _ => format!("{name}{step} = {value} {} 0", if value > 0 { ">" } else { "<" }),
    }
}

/// Axes that stand at their ends, of which there are some.
pub(super) fn standing(stands: [bool; 2], language: Language) -> String {
    match stands {
        [true, true] => format!("x y {}", language.pick("stand", "已到终点")),
        [is_x, _] => {
            let stands = language.pick("stands", "已到终点");
            format!("{} {stands}", if is_x { "x" } else { "y" })
        }
    }
}
