//! The path as a picture, or where the cutter would cut into the part.

use crate::backdrop::{self, Backdrop, curve, parts, reach, start};
use onepulse_core::Plane;
use onepulse_plan::centre_path::{CentreMove, Gouge, Role, Step};
use onepulse_plan::gcode::Cutter;
use std::fmt::Write;

/// Pictures have a thousand units a millimetre, so that decimals of it are few.
const SCALE: f64 = 1000.0;

const WIDTH: f64 = 900.0;

/// The part, the path of the cutter's centre and what the cutter sweeps, seen across the plane of the
/// first contour, else across that of X and Y.
pub(super) fn path(steps: &[Step]) -> String {
    let moves = || {
        steps.iter().filter_map(|step| match step {
            Step::Move(step) => Some(step),
            Step::Pause(_) => None,
        })
    };
    let compensated = moves().find(|step| step.cutter != Cutter::Off);
    let plane = compensated.map_or(Plane::Xy, |step| step.plane);
    let mut backdrop = Backdrop::new(plane, SCALE);
    let mut frame = Frame::default();
    let mut text = String::new();
    for step in moves() {
        backdrop.add(step);
        draw(step, plane, &mut frame, &mut text);
    }
    if let Some(corners) = backdrop.frame() {
        corners.into_iter().for_each(|corner| frame.include(corner, 0.0));
    }
    frame.svg(&(backdrop.svg() + &text))
}

/// The contours that the cutter would cut into, with the cutter in the places where it does.
pub(super) fn gouges(gouges: &[Gouge]) -> String {
    let mut frame = Frame::default();
    let (mut text, mut labels) = (String::new(), String::new());
    for Gouge { contour, radius, overcuts, .. } in gouges {
        for element in contour {
            let (from, to, arc) = parts(*element);
            let d = start(from, SCALE) + &curve(from, to, arc, SCALE);
            let _ = writeln!(text, "<path class=\"p\" d=\"{d}\"/>");
            for (centre, off) in reach([from, to], arc) {
                frame.include(centre.map(|c| c * SCALE), off * SCALE);
            }
        }
        // One label for all in one place.
        let mut lines: Vec<([f64; 2], Vec<u32>)> = Vec::new();
        for overcut in overcuts {
            let both = [Some(overcut.line), overcut.other_line].into_iter().flatten();
            match lines.iter_mut().find(|(at, _)| *at == overcut.at) {
                Some((_, known)) => known.extend(both),
                None => lines.push((overcut.at, both.collect())),
            }
            let [x, y] = overcut.at.map(|c| c * SCALE);
            let radius = radius * SCALE;
            frame.include([x, y], radius);
            let _ = writeln!(
                text,
                "<circle class=\"g\" cx=\"{x:.4}\" cy=\"{y:.4}\" r=\"{radius:.4}\"/>"
            );
        }
        for (at, mut numbers) in lines {
            numbers.sort_unstable();
            numbers.dedup();
            let numbers: Vec<_> = numbers.iter().map(u32::to_string).collect();
            let name = if numbers.len() == 1 { "line" } else { "lines" };
            let [x, y] = at.map(|c| c * SCALE);
            // Text stands upright outside the mirrored group.
            let _ = writeln!(
                labels,
                "<text x=\"{x:.4}\" y=\"{:.4}\">{name} {}</text>",
                -y,
                numbers.join(", ")
            );
        }
    }
    frame.svg_with(&text, &labels)
}

fn draw(step: &CentreMove, plane: Plane, frame: &mut Frame, text: &mut String) {
    let [first, second, _] = plane.axes();
    let [from, to] = [step.from, step.to].map(|point| [point[first], point[second]]);
    // What is seen from the side is drawn as a straight line.
    let arc = step.arc.filter(|_| step.plane == plane);
    if from == to && arc.is_none() {
        return;
    }
    let class = match step.role {
        Role::Rapid => "r",
        Role::Feed => "f",
        Role::Establish | Role::Cancel => "e",
        Role::Offset => "s",
        Role::Corner => "c",
    };
    let d = start(from, SCALE) + &curve(from, to, arc, SCALE);
    let _ = writeln!(text, "<path class=\"{class}\" d=\"{d}\"/>");
    for (centre, off) in reach([from, to], arc) {
        frame.include(centre.map(|c| c * SCALE), off * SCALE);
    }
}

/// What a picture shows.
#[derive(Clone, Copy, Debug)]
struct Frame {
    low: [f64; 2],
    high: [f64; 2],
}

impl Default for Frame {
    /// The origin is always in it.
    fn default() -> Self {
        Self { low: [0.0; 2], high: [0.0; 2] }
    }
}

impl Frame {
    fn include(&mut self, centre: [f64; 2], radius: f64) {
        for axis in 0..2 {
            self.low[axis] = self.low[axis].min(centre[axis] - radius);
            self.high[axis] = self.high[axis].max(centre[axis] + radius);
        }
    }

    fn svg(&self, drawn: &str) -> String {
        self.svg_with(drawn, "")
    }

    fn svg_with(&self, drawn: &str, labels: &str) -> String {
        let size = [0, 1].map(|axis| (self.high[axis] - self.low[axis]).max(1.0));
        let margin = size[0].max(size[1]) * 0.04;
        let [width, height] = size.map(|side| side + 2.0 * margin);
        let (x, y) = (self.low[0] - margin, -self.high[1] - margin);
        // An em is a pixel of the picture at its first size.
        let em = width / WIDTH;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" font-size=\"{em:.4}\" \
             viewBox=\"{x:.1} {y:.1} {width:.1} {height:.1}\">\n\
             <style>path,circle{{fill:none;stroke-linejoin:round}}text{{font:14em sans-serif;fill:#c0392b}}{}\
             .f{{stroke:#9db8d9;stroke-width:3em}}\
             .r{{stroke:#b9b9b9;stroke-width:1.5em;stroke-dasharray:6em 4em}}\
             .e{{stroke:#0072b2;stroke-width:1.5em;stroke-dasharray:6em 4em}}\
             .s{{stroke:#0072b2;stroke-width:1.5em}}.c{{stroke:#d55e00;stroke-width:1.5em}}\
             circle{{stroke:#c0392b;stroke-width:1.5em;fill:#c0392b;fill-opacity:.15}}</style>\n\
             <rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"#fff\"/>\n\
             <g transform=\"scale(1,-1)\">\n{drawn}</g>\n{labels}</svg>\n",
            backdrop::STYLE
        )
    }
}
