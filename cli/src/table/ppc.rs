//! The four beats of point-by-point comparison, step by step.

use super::{Language, Table, pulse_name};
use onepulse_core::ppc;

/// The table of a line.
pub(super) struct LineTable {
    pub(super) machine: ppc::Line,
    pub(super) end: [i32; 2],
}

/// The table of an arc.
pub(super) struct ArcTable {
    pub(super) machine: ppc::Arc,
}

fn headings(language: Language) -> Vec<String> {
    let pick = |english, chinese| language.pick(english, chinese).to_owned();
    vec![
        pick("step", "序号"),
        pick("judge", "偏差判别"),
        pick("feed", "坐标进给"),
        pick("update", "偏差计算"),
        pick("compare", "终点比较"),
    ]
}

fn start(language: Language, rest: &str, counter: u64) -> Vec<String> {
    let start = language.pick("start", "起点").to_owned();
    vec![start, String::new(), String::new(), format!("F0 = 0{rest}"), format!("E = {counter}")]
}

/// The judge beat: F against zero, or why F does not decide.
fn judged(step: u64, f: i64, overruled: Option<usize>, language: Language) -> String {
    match overruled {
        Some(axis) => {
            format!("F{step} = {f}, {} {}", ["x", "y"][axis], language.pick("stands", "已到终点"))
        }
        None if f == 0 => format!("F{step} = 0"),
        None => format!("F{step} = {f} {} 0", if f > 0 { ">" } else { "<" }),
    }
}

fn compared(before: u64, after: u64) -> String {
    format!("E = {before} - {} = {after}", before - after)
}

impl Table for LineTable {
    fn headings(&self, language: Language) -> Vec<String> {
        headings(language)
    }

    fn rows(&self, language: Language) -> impl Iterator<Item = Vec<String>> {
        let mut machine = self.machine;
        let [xe, ye] = self.end.map(i32::unsigned_abs);
        let first = start(language, "", machine.remaining());
        let steps = (0_u64..).map_while(move |step| {
            let (f, counter) = (machine.deviation_function(), machine.remaining());
            let axis = machine.judge().index();
            let pulse = machine.step()?;
            let is_overruled = (f >= 0) != (axis == 0);
            let (sign, name, end) = [('-', "|y_e|", ye), ('+', "|x_e|", xe)][axis];
            Some(vec![
                (step + 1).to_string(),
                judged(step, f, is_overruled.then_some(1 - axis), language),
                pulse_name(pulse.0[axis], axis),
                format!(
                    "F{next} = F{step} {sign} {name} = {f} {sign} {end} = {after}",
                    next = step + 1,
                    after = machine.deviation_function()
                ),
                compared(counter, machine.remaining()),
            ])
        });
        std::iter::once(first).chain(steps)
    }
}

impl Table for ArcTable {
    fn headings(&self, language: Language) -> Vec<String> {
        headings(language)
    }

    fn rows(&self, language: Language) -> impl Iterator<Item = Vec<String>> {
        let mut machine = self.machine;
        let [x, y] = machine.position();
        let first = start(language, &format!(", x = {x}, y = {y}"), machine.remaining());
        let steps = (0_u64..).map_while(move |step| {
            let (f, counter) = (machine.deviation_function(), machine.remaining());
            let (before, feeds) = (machine.position(), machine.sweep().feeds());
            let feed = machine.judge();
            machine.step()?;
            let axis = feed.axis.index();
            let due = if f >= 0 { feeds.towards } else { feeds.away };
            // A feed towards zero takes 2c − 1 from F, one away from it adds 2c + 1.
            let coordinate = before[axis].abs();
            let sign = if machine.position()[axis].abs() > coordinate { '+' } else { '-' };
            let name = ["x", "y"][axis];
            let [x, y] = machine.position();
            Some(vec![
                (step + 1).to_string(),
                judged(step, f, (feed != due).then_some(due.axis.index()), language),
                pulse_name(feed.sign, axis),
                format!(
                    "F{next} = F{step} {sign} 2|{name}| + 1 = {f} {sign} {twice} + 1 = {after}, x = {x}, y = {y}",
                    next = step + 1,
                    twice = 2 * coordinate,
                    after = machine.deviation_function()
                ),
                compared(counter, machine.remaining()),
            ])
        });
        std::iter::once(first).chain(steps)
    }
}
