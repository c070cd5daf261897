//! The path as a program.

use onepulse_core::{Direction, Plane};
use onepulse_plan::centre_path::{CentreMove, Step};
use onepulse_plan::gcode::Pause;
use onepulse_plan::{Length, Rate};
use std::fmt::Write;

/// A program in millimetres that moves the cutter's centre just so. Its coordinates are whole
/// picometres, those of which `run` makes pulses.
pub(super) fn ngc(steps: &[Step]) -> String {
    let mut out = Writer::default();
    out.text.push_str("%\nG21 G90 G17 G40\n");
    for step in steps {
        match step {
            Step::Move(step) => out.step(step),
            Step::Pause(Pause { dwell: Some(time), .. }) => {
                let nanoseconds = format!("{:09}", time.subsec_nanos());
                let decimals = nanoseconds.trim_end_matches('0');
                let _ = writeln!(out.text, "G04 P{}.{decimals}", time.as_secs());
            }
            Step::Pause(Pause { dwell: None, .. }) => out.text.push_str("M00\n"),
        }
    }
    out.text.push_str("M30\n%\n");
    out.text
}

#[derive(Default)]
struct Writer {
    text: String,
    plane: Plane,
    feed: Option<Length>,
    tool: Option<u32>,
    spindle: Option<f64>,
}

impl Writer {
    fn step(&mut self, step: &CentreMove) {
        let [from, to] = [step.from, step.to].map(|point| point.map(Length::nearest));
        if from == to && (step.arc.is_none() || step.from != step.to) {
            return;
        }
        let mut words = Vec::new();
        if step.plane != self.plane {
            self.plane = step.plane;
            words.push(
                match step.plane {
                    Plane::Xy => "G17",
                    Plane::Zx => "G18",
                    Plane::Yz => "G19",
                }
                .to_owned(),
            );
        }
        words.push(
            match (step.arc, step.rate) {
                (Some((_, Direction::Cw)), _) => "G02",
                (Some((_, Direction::Ccw)), _) => "G03",
                (None, Rate::Rapid) => "G00",
                (None, Rate::Feed(_)) => "G01",
            }
            .to_owned(),
        );
        for axis in 0..3 {
            if from[axis] != to[axis] {
                words.push(format!("{}{}", ["X", "Y", "Z"][axis], decimal(to[axis])));
            }
        }
        if let Some((centre, _)) = step.arc {
            let [first, second, _] = step.plane.axes();
            for (axis, c) in [(first, centre[0]), (second, centre[1])] {
                let offset = Length::nearest(c).checked_sub(from[axis]).unwrap_or_default();
                words.push(format!("{}{}", ["I", "J", "K"][axis], decimal(offset)));
            }
        }
        if let Rate::Feed(feed) = step.rate {
            if self.feed.replace(feed) != Some(feed) {
                words.push(format!("F{}", decimal(feed)));
            }
        }
        if step.spindle != self.spindle {
            self.spindle = step.spindle;
            words.extend(step.spindle.map(|speed| format!("S{speed}")));
        }
        if step.tool != self.tool {
            self.tool = step.tool;
            words.extend(step.tool.map(|tool| format!("T{tool}")));
        }
        self.text.push_str(&words.join(" "));
        self.text.push('\n');
    }
}

/// Millimetres with a decimal point.
fn decimal(length: Length) -> String {
    let picometres = length.picometres();
    let sign = if picometres < 0 { "-" } else { "" };
    let whole = picometres.unsigned_abs() / 1_000_000_000;
    let decimals = format!("{:09}", picometres.unsigned_abs() % 1_000_000_000);
    format!("{sign}{whole}.{}", decimals.trim_end_matches('0'))
}
