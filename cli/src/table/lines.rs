//! Lines by the methods that move several axes in a step, and lines in space.

use super::Language;
use super::steps::{Steps, against_zero};
use crate::pulses::AXES;
use onepulse_core::{Axis, comparison, minimum_deviation, ppc, vector};

/// d of each axis but the leading one: by how much it is behind, 2·|e| of the leading one to the
/// pulse.
impl<const N: usize> Steps<N> for minimum_deviation::Line<N> {
    fn first(&self) -> String {
        let zero = |axis| format!("d{axis} = 0");
        self.others().map(|(axis, _)| zero(AXES[axis])).collect::<Vec<_>>().join(", ")
    }

    fn judged(&self, _: u64, _: Language) -> String {
        let longest = i64::from(self.longest());
        let judged = |(axis, end): (usize, u64)| {
            let (name, d) = (AXES[axis], self.deviations()[axis]);
            let due = d + 2 * end as i64;
            let sign = if due > longest { ">" } else { "≤" };
            format!("d{name} + 2|{name}_e| = {d} + {} = {due} {sign} {longest}", 2 * end)
        };
        self.others().map(judged).collect::<Vec<_>>().join(", ")
    }

    fn updated(&self, before: &Self, _: u64) -> String {
        let longest = i64::from(self.longest());
        let updated = |(axis, end): (usize, u64)| {
            let (name, after) = (AXES[axis], self.deviations()[axis]);
            let due = before.deviations()[axis] + 2 * end as i64;
            if due > longest {
                format!("d{name} = {due} - {} = {after}", 2 * longest)
            } else {
                format!("d{name} = {after}")
            }
        };
        before.others().map(updated).collect::<Vec<_>>().join(", ")
    }

    fn position(&self) -> [i64; N] {
        self.position()
    }

    fn to_go(&self) -> [u64; N] {
        self.pulses_to_go()
    }
}

/// The axes that follow a leading one, and their ways.
trait Others {
    fn others(&self) -> impl Iterator<Item = (usize, u64)>;
}

impl<const N: usize> Others for minimum_deviation::Line<N> {
    fn others(&self) -> impl Iterator<Item = (usize, u64)> {
        let (position, left) = (self.position(), self.pulses_to_go());
        let way = move |axis: usize| position[axis].unsigned_abs() + left[axis];
        let longest = u64::from(self.longest());
        let leader = (0..N).find(|axis| way(*axis) == longest);
        (0..N).filter(move |axis| Some(*axis) != leader).map(move |axis| (axis, way(axis)))
    }
}

impl Steps<2> for vector::Line {
    fn first(&self) -> String {
        "V0 = 0".into()
    }

    fn judged(&self, step: u64, language: Language) -> String {
        let [_, b] = lengths(self);
        let judged = against_zero("V", step, self.vector_product());
        if b.1 == 0 {
            let stands = language.pick("stands", "已到终点");
            return format!("{judged}, {} {stands}", AXES[self.longer().other().index()]);
        }
        judged
    }

    fn updated(&self, before: &Self, step: u64) -> String {
        let [(a_name, a), (b_name, b)] = lengths(before);
        let (v, after) = (before.vector_product(), self.vector_product());
        let head = format!("V{step} = V{}", step - 1);
        if after > v || a == b && v <= 0 {
            format!("{head} + |{a_name}_e| - |{b_name}_e| = {v} + {a} - {b} = {after}")
        } else {
            format!("{head} - |{b_name}_e| = {v} - {b} = {after}")
        }
    }

    fn position(&self) -> [i64; 2] {
        self.position()
    }

    fn to_go(&self) -> [u64; 2] {
        self.pulses_to_go()
    }
}

/// The longer axis with its way, and the other one.
fn lengths(line: &vector::Line) -> [(&'static str, u64); 2] {
    let (position, left) = (line.position(), line.pulses_to_go());
    let length = |axis: Axis| {
        let place = axis.index();
        (AXES[place], position[place].unsigned_abs() + left[place])
    };
    [line.longer(), line.longer().other()].map(length)
}

impl Steps<2> for comparison::Line {
    fn first(&self) -> String {
        let [x, y] = self.pulses_to_go();
        format!("D0 = |y_e| - |x_e| = {y} - {x} = {}", self.difference())
    }

    fn judged(&self, step: u64, _: Language) -> String {
        against_zero("D", step, self.difference())
    }

    fn updated(&self, before: &Self, step: u64) -> String {
        let (position, left) = (before.position(), before.pulses_to_go());
        let [x, y] = [0, 1].map(|axis| 2 * (position[axis].unsigned_abs() + left[axis]));
        let (d, after) = (before.difference(), self.difference());
        let head = format!("D{step} = D{}", step - 1);
        match d.signum() {
            -1 => format!("{head} + 2|y_e| = {d} + {y} = {after}"),
            1 => format!("{head} - 2|x_e| = {d} - {x} = {after}"),
            _ => format!("{head} + 2|y_e| - 2|x_e| = {d} + {y} - {x} = {after}"),
        }
    }

    fn position(&self) -> [i64; 2] {
        self.position()
    }

    fn to_go(&self) -> [u64; 2] {
        self.pulses_to_go()
    }
}

/// F of each axis but the one that leads.
impl<const N: usize> Steps<N> for ppc::SpaceLine<N> {
    fn first(&self) -> String {
        functions(self, "0")
    }

    fn judged(&self, step: u64, _: Language) -> String {
        functions(self, &step.to_string())
    }

    fn updated(&self, _: &Self, step: u64) -> String {
        functions(self, &step.to_string())
    }

    fn position(&self) -> [i64; N] {
        self.position()
    }

    fn to_go(&self) -> [u64; N] {
        self.pulses_to_go()
    }
}

fn functions<const N: usize>(line: &ppc::SpaceLine<N>, step: &str) -> String {
    let others = (0..N).filter(|axis| *axis != line.leader());
    let function =
        |axis: usize| format!("F{}{step} = {}", AXES[axis], line.deviation_functions()[axis]);
    others.map(function).collect::<Vec<_>>().join(", ")
}
