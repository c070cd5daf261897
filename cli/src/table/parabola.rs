//! Parabolas: the steps that F decides on.

use super::Language;
use super::steps::{Steps, against_zero, fed, standing};
use crate::pulses::AXES;
use onepulse_core::parabola::{MinimumDeviation, Ppc, Shape};
use onepulse_core::{Axis, Pulse};

/// What a pulse along the axis of symmetry takes from F, and its letter.
fn along(shape: &Shape) -> (usize, i64) {
    (shape.axis().index(), 2 * i64::from(shape.parameter().unsigned_abs()))
}

/// How the pulses between two points changed F.
fn updated(shape: &Shape, [from, to]: [[i64; 2]; 2], [f, after]: [i64; 2], step: u64) -> String {
    let (mut formula, mut numbers) = (String::new(), String::new());
    let (axis, double_parameter) = along(shape);
    if from[axis] != to[axis] {
        formula += " - 2|p|";
        numbers += &format!(" - {double_parameter}");
    }
    let across = 1 - axis;
    if from[across] != to[across] {
        formula += &format!(" + 2|{}| + 1", AXES[across]);
        numbers += &format!(" + {} + 1", 2 * from[across].abs());
    }
    format!("F{step} = F{}{formula} = {f}{numbers} = {after}", step - 1)
}

impl Steps<2> for Ppc {
    fn first(&self) -> String {
        "F0 = 0".into()
    }

    fn judged(&self, step: u64, language: Language) -> String {
        let judged = against_zero("F", step, self.deviation_function());
        match self.pulses_to_go().map(|pulses| pulses == 0) {
            [false, false] => judged,
            stands => format!("{judged}, {}", standing(stands, language)),
        }
    }

    fn updated(&self, before: &Self, step: u64) -> String {
        let way = [before.position(), self.position()];
        let f = [before.deviation_function(), self.deviation_function()];
        updated(self.shape(), way, f, step)
    }

    fn position(&self) -> [i64; 2] {
        self.position()
    }

    fn to_go(&self) -> [u64; 2] {
        self.pulses_to_go()
    }
}

impl Steps<2> for MinimumDeviation {
    fn first(&self) -> String {
        "F0 = 0".into()
    }

    fn judged(&self, step: u64, language: Language) -> String {
        let f = self.deviation_function();
        match self.pulses_to_go().map(|pulses| pulses == 0) {
            [false, false] => {}
            stands => return format!("F{step} = {f}, {}", standing(stands, language)),
        }
        let shape = self.shape();
        let (axis, double_parameter) = along(shape);
        let [x, y] = shape.end().map(|c| c.signum() as i8);
        let [step_along, step_across] = match shape.axis() {
            Axis::X => [Pulse([x, 0]), Pulse([0, y])],
            Axis::Y => [Pulse([0, y]), Pulse([x, 0])],
        };
        let crosswise = 2 * self.position()[1 - axis].abs() + 1;
        let candidates = [
            (step_along, -double_parameter),
            (step_across, crosswise),
            (Pulse([x, y]), crosswise - double_parameter),
        ];
        candidates.map(|(pulse, change)| format!("{}: F = {}", fed(pulse), f + change)).join(", ")
    }

    fn updated(&self, before: &Self, step: u64) -> String {
        let way = [before.position(), self.position()];
        let f = [before.deviation_function(), self.deviation_function()];
        updated(self.shape(), way, f, step)
    }

    fn position(&self) -> [i64; 2] {
        self.position()
    }

    fn to_go(&self) -> [u64; 2] {
        self.pulses_to_go()
    }
}
