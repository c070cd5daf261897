//! What a picture shows under a path: the part's contours, and what the cutter sweeps along them.

use onepulse_core::{Direction, Plane};
use onepulse_plan::centre_path::{CentreMove, Role};
use onepulse_plan::compensation::Element;
use onepulse_plan::gcode::Cutter;
use std::fmt::Write;

/// The classes of what it draws; an em is a pixel. What is swept is a stroke as wide as the cutter, with
/// a lighter one over it, so that its outline shows.
pub(crate) const STYLE: &str = ".o{stroke:#7fa883;stroke-linecap:round}\
.i{stroke:#eaf3ea;stroke-linecap:round}.p{stroke:#222;stroke-width:1.5em}";

/// The backdrop of a path as it grows, in units of its picture.
#[derive(Clone, Debug)]
pub(crate) struct Backdrop {
    plane: Plane,
    /// Units a millimetre.
    scale: f64,
    part: String,
    /// Of each contour the cutter's diameter and the path of its centre.
    swept: Vec<(f64, String)>,
    frame: Option<[[f64; 2]; 2]>,
}

/// The part of a cutter's width that is not its outline.
const INSIDE: f64 = 0.985;

impl Backdrop {
    /// An empty one, of what lies in this plane.
    pub(crate) const fn new(plane: Plane, scale: f64) -> Self {
        Self { plane, scale, part: String::new(), swept: Vec::new(), frame: None }
    }

    /// Adds what a step has of it.
    pub(crate) fn add(&mut self, step: &CentreMove) {
        let Cutter::On { radius, .. } = step.cutter else { return };
        if step.plane != self.plane {
            return;
        }
        if let Some(element) = step.contour {
            let (from, to, arc) = parts(element);
            self.part +=
                &format!("{}{}", start(from, self.scale), curve(from, to, arc, self.scale));
            self.include([from, to], arc, 0.0);
        }
        let [first, second, _] = step.plane.axes();
        let [from, to] = [step.from, step.to].map(|point| [point[first], point[second]]);
        if step.role == Role::Establish || self.swept.is_empty() {
            self.swept.push((2.0 * radius * self.scale, start(from, self.scale)));
        }
        if let Some((_, path)) = self.swept.last_mut() {
            *path += &curve(from, to, step.arc, self.scale);
        }
        self.include([from, to], step.arc, radius);
    }

    /// What it draws.
    pub(crate) fn svg(&self) -> String {
        let mut text = String::new();
        for (class, part) in [("o", 1.0), ("i", INSIDE)] {
            for (width, d) in &self.swept {
                let width = width * part;
                // Writing into a string cannot fail.
                let _ = writeln!(
                    text,
                    "<path class=\"{class}\" stroke-width=\"{width:.3}\" d=\"{d}\"/>"
                );
            }
        }
        if !self.part.is_empty() {
            let _ = writeln!(text, "<path class=\"p\" d=\"{}\"/>", self.part);
        }
        text
    }

    /// Its lower left and upper right corner, if there is anything.
    pub(crate) const fn frame(&self) -> Option<[[f64; 2]; 2]> {
        self.frame
    }

    fn include(&mut self, ends: [[f64; 2]; 2], arc: Arc, radius: f64) {
        let [mut low, mut high] =
            self.frame.unwrap_or([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]]);
        for (centre, off) in reach(ends, arc) {
            for axis in 0..2 {
                low[axis] = low[axis].min((centre[axis] - off - radius) * self.scale);
                high[axis] = high[axis].max((centre[axis] + off + radius) * self.scale);
            }
        }
        self.frame = Some([low, high]);
    }
}

/// Circles that a curve stays within: its ends, and of an arc the whole.
pub(crate) fn reach([from, to]: [[f64; 2]; 2], arc: Arc) -> impl Iterator<Item = ([f64; 2], f64)> {
    let whole = arc.map(|(centre, _)| (centre, (from[0] - centre[0]).hypot(from[1] - centre[1])));
    [(from, 0.0), (to, 0.0)].into_iter().chain(whole)
}

/// The centre and the sense of an arc; none of a line.
type Arc = Option<([f64; 2], Direction)>;

/// Start, end and arc of a curve.
pub(crate) const fn parts(element: Element) -> ([f64; 2], [f64; 2], Arc) {
    match element {
        Element::Line { from, to } => (from, to, None),
        Element::Arc { from, to, centre, direction } => (from, to, Some((centre, direction))),
    }
}

/// The beginning of a path.
pub(crate) fn start(from: [f64; 2], scale: f64) -> String {
    format!("M{}", point(from, scale))
}

/// The curve from where a path has come: a full circle as two halves, as SVG cannot draw it in one.
pub(crate) fn curve(from: [f64; 2], to: [f64; 2], arc: Arc, scale: f64) -> String {
    let Some((centre, direction)) = arc else { return format!("L{}", point(to, scale)) };
    let [x, y] = [0, 1].map(|axis| from[axis] - centre[axis]);
    let [x_end, y_end] = [0, 1].map(|axis| to[axis] - centre[axis]);
    let radius = x.hypot(y) * scale;
    let sense = u8::from(direction == Direction::Ccw);
    let arc = |is_long: bool, to| {
        format!("A{radius:.4} {radius:.4} 0 {} {sense} {}", u8::from(is_long), point(to, scale))
    };
    if from == to {
        let across = [centre[0] - x, centre[1] - y];
        return arc(false, across) + &arc(false, to);
    }
    let turn = x * y_end - y * x_end;
    arc(if direction == Direction::Ccw { turn < 0.0 } else { turn > 0.0 }, to)
}

fn point([x, y]: [f64; 2], scale: f64) -> String {
    format!("{:.4} {:.4}", x * scale, y * scale)
}
