//! The paths of all methods over the true curve, as SVG.

use super::truth::Truth;
use crate::curve::Curve;
use crate::failure::Failure;
use onepulse_core::{Axis, Direction};
use std::fmt::Write;

/// The longest curve that is drawn, in pulses: of longer ones no eye could tell the steps apart.
const LONGEST: f64 = 64.0;

/// Nine that are told apart by eye, the darker and the lighter in turn.
const COLOURS: [&str; 9] = [
    "#d62728", "#1f77b4", "#17becf", "#2ca02c", "#8c564b", "#e377c2", "#ff7f0e", "#9467bd",
    "#555555",
];

/// The side of a pulse at the picture's first size, in pixels.
const PULSE: f64 = 48.0;

/// How far the paths lie beside each other, in pulses: they would hide each other else.
const BESIDE: f64 = 0.035;

/// A picture of a short plane curve.
#[derive(Debug)]
pub(crate) struct Picture {
    curve: Curve,
    start: [i64; 2],
    paths: Vec<(String, Vec<[i64; 2]>)>,
}

impl Picture {
    /// An empty picture, for which this option asks.
    pub(crate) fn new(option: &str, curve: &Curve, truth: &Truth) -> Result<Self, Failure> {
        if curve.end().len() != 2 {
            return Err(Failure::Usage(format!("{option}: only curves of 2 axes are drawn")));
        }
        // An end point beside the curve is part of the way.
        let beside = truth.clone().reach([curve.end()[0], curve.end()[1]]).distance;
        let length = truth.length() + beside;
        if length > LONGEST {
            return Err(Failure::Usage(format!(
                "{option}: this curve is {length:.0} pulses long, and the steps of up to {LONGEST} \
                 can be seen: leave it out, or take a shorter curve"
            )));
        }
        let start = match *curve {
            Curve::Arc { from, .. } => from.map(i64::from),
            _ => [0; 2],
        };
        Ok(Self { curve: curve.clone(), start, paths: Vec::new() })
    }

    /// Begins the path of a method.
    pub(crate) fn begin_path(&mut self, title: String) -> &mut Vec<[i64; 2]> {
        let place = self.paths.len();
        self.paths.push((title, vec![self.start]));
        &mut self.paths[place].1
    }

    /// The finished picture.
    pub(crate) fn svg(mut self) -> String {
        // What its method refused has not begun.
        self.paths.retain(|(_, points)| points.len() > 1);
        let points = self.paths.iter().flat_map(|(_, points)| points).copied();
        let (mut low, mut high) = (self.start, self.start);
        for point in points {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        let pixel = |pulses: i64| pulses as f64 * PULSE;
        let [left, top] = [pixel(low[0]) - PULSE, -pixel(high[1]) - PULSE];
        let plot = [0, 1].map(|axis| pixel(high[axis] - low[axis]) + 2.0 * PULSE);
        let lines = self.paths.len() as f64 + 1.0;
        let [width, height] = [plot[0] + 220.0, plot[1].max(24.0 * lines + 2.0 * PULSE)];
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"{left} {top} {width} {height}\" font-family=\"sans-serif\" font-size=\"14\">\n\
             <title>{}</title>\n<rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" \
             fill=\"#fff\"/>\n",
            self.curve
        );
        // Infallible: these write to a string.
        let _ = self.draw(&mut svg, [low, high]);
        let _ = self.legend(&mut svg, [left + plot[0], top + PULSE]);
        svg.push_str("</svg>\n");
        svg
    }

    fn draw(&self, svg: &mut String, [low, high]: [[i64; 2]; 2]) -> std::fmt::Result {
        writeln!(svg, "<g transform=\"scale({PULSE},-{PULSE})\" fill=\"none\">")?;
        let mut grid = String::new();
        for x in low[0]..=high[0] {
            write!(grid, "M{x} {}V{}", low[1], high[1])?;
        }
        for y in low[1]..=high[1] {
            write!(grid, "M{} {y}H{}", low[0], high[0])?;
        }
        writeln!(svg, "<path d=\"{grid}\" stroke=\"#e4e4e4\" stroke-width=\".02\"/>")?;
        let curve = true_curve(&self.curve);
        writeln!(svg, "<path d=\"{curve}\" stroke=\"#f3d36b\" stroke-width=\".14\"/>")?;
        for (place, (_, points)) in self.paths.iter().enumerate() {
            let beside = (place as f64 - (self.paths.len() - 1) as f64 / 2.0) * BESIDE;
            let points = points.iter().map(|[x, y]| format!("{x},{y}")).collect::<Vec<_>>();
            // Not along the diagonal, where steps may lie.
            writeln!(
                svg,
                "<polyline transform=\"translate({beside:.4},{:.4})\" stroke=\"{}\" \
                 stroke-width=\".03\" stroke-linejoin=\"round\" points=\"{}\"/>",
                -0.6 * beside,
                COLOURS[place % COLOURS.len()],
                points.join(" ")
            )?;
        }
        writeln!(svg, "</g>")
    }

    fn legend(&self, svg: &mut String, [x, mut y]: [f64; 2]) -> std::fmt::Result {
        let entries = self.paths.iter().enumerate();
        let entries = entries.map(|(place, (title, _))| (title.as_str(), COLOURS[place % 9], 3));
        for (title, colour, thickness) in [("true curve", "#f3d36b", 7)].into_iter().chain(entries)
        {
            writeln!(
                svg,
                "<path d=\"M{x} {y}h28\" stroke=\"{colour}\" stroke-width=\"{thickness}\"/>\
                 <text x=\"{}\" y=\"{}\">{title}</text>",
                x + 36.0,
                y + 5.0
            )?;
            y += 24.0;
        }
        Ok(())
    }
}

/// The true curve in SVG's words.
fn true_curve(curve: &Curve) -> String {
    match *curve {
        Curve::Line { ref to } => format!("M0 0L{} {}", to[0], to[1]),
        Curve::Arc { from, to, direction } | Curve::Helix { from, to, direction, .. } => {
            arc(from, to, direction)
        }
        // A parabola is a Bézier curve of the second degree: its middle point is where the
        // tangents of its ends meet, on the vertex' tangent at half the way across.
        Curve::Parabola { axis, parameter, to } => {
            let across = f64::from(axis.other().of(to));
            let along = across * across / (2.0 * f64::from(parameter));
            match axis {
                Axis::X => format!("M0 0Q0 {} {along:.4} {across}", across / 2.0),
                Axis::Y => format!("M0 0Q{} 0 {across} {along:.4}", across / 2.0),
            }
        }
    }
}

/// An arc, a full circle as two halves, as SVG cannot draw it in one. It ends on the circle, in the
/// direction of its end.
fn arc(from: [i32; 2], to: [i32; 2], direction: Direction) -> String {
    let [x, y, xe, ye] = [from[0], from[1], to[0], to[1]].map(i128::from);
    let turn = if direction == Direction::Ccw { x * ye - y * xe } else { y * xe - x * ye };
    let is_full = turn == 0 && x * xe + y * ye > 0;
    let ([x, y], [xe, ye]) = (from.map(f64::from), to.map(f64::from));
    let radius = x.hypot(y);
    let sense = u8::from(direction == Direction::Ccw);
    let half = format!("A{radius} {radius} 0 0 {sense}");
    if is_full {
        return format!("M{x} {y}{half} {} {}{half} {x} {y}", -x, -y);
    }
    let outwards = radius / xe.hypot(ye);
    let (xe, ye, is_long) = (xe * outwards, ye * outwards, u8::from(turn < 0));
    format!("M{x} {y}A{radius} {radius} 0 {is_long} {sense} {xe:.4} {ye:.4}")
}
