//! `path.svg`: the programmed curves and the staircase of pulses over them, seen from the positive end of z:
//! of a motion in space, its projection on the XY plane.

use crate::backdrop::{self, Backdrop};
use crate::failure::Failure;
use crate::output::OutputFile;
use onepulse_core::{Direction, Plane, Pulse};
use onepulse_plan::{Curve, Motion, Rate};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::fs::File;
use std::io::{self, BufWriter, Seek, SeekFrom, Write};

/// The picture, written as the run goes on. Its frame is known at the end only, so room is left
/// for it at the beginning.
#[derive(Debug)]
pub(super) struct Picture {
    out: BufWriter<File>,
    file: OutputFile,
    /// Smallest and largest x and y so far.
    frame: [[i64; 2]; 2],
    position: [i64; 2],
    /// The straight run of pulses that is not written yet.
    run: ([i8; 2], i64),
    corners_left: u32,
}

/// Room for the opening tag.
const FRAME: usize = 200;

/// Corners of the staircase that are drawn. A viewer copes with these, and where there are more
/// no eye could tell the steps from the curve; curves are drawn to the last.
const CORNERS: u32 = 400_000;

/// An em is a pixel of the picture at its first size: the frame sets the font size so.
const STYLE: &str = "<style>path{fill:none;stroke-linejoin:round}\
.f{stroke:#9db8d9;stroke-width:4em}.r{stroke:#b9b9b9;stroke-width:1.5em;stroke-dasharray:6em 4em}\
.s{stroke:#c0392b;stroke-width:.8em}";

impl Picture {
    /// Begins the picture over what is known before.
    pub(super) fn begin(file: OutputFile, backdrop: &Backdrop) -> Result<Self, Failure> {
        let mut out = file.writer()?;
        let more = if backdrop.frame().is_some() { backdrop::STYLE } else { "" };
        let begun = writeln!(out, "{:FRAME$}", "").and_then(|()| {
            write!(out, "{STYLE}{more}</style>\n<g transform=\"scale(1,-1)\">\n{}", backdrop.svg())
        });
        begun.map_err(|error| file.failure(&error))?;
        let none = ([0, 0], 0);
        let mut frame = [[0; 2]; 2];
        if let Some([low, high]) = backdrop.frame() {
            for axis in 0..2 {
                frame[0][axis] = (low[axis].floor() as i64).min(0);
                frame[1][axis] = (high[axis].ceil() as i64).max(0);
            }
        }
        Ok(Self { out, file, frame, position: [0; 2], run: none, corners_left: CORNERS })
    }

    /// Draws the curve of a block, and begins its staircase.
    pub(super) fn begin_block(&mut self, motion: &Motion) -> Result<(), Failure> {
        let [[x, y], [xe, ye]] = motion.ends_in(Plane::Xy);
        self.position = [x.into(), y.into()];
        self.include(self.position);
        let class = match motion.rate {
            Rate::Rapid => "r",
            Rate::Feed(_) => "f",
        };
        let d = match motion.curve {
            Curve::Line => format!("M{x} {y}L{xe} {ye}"),
            Curve::Arc { plane: Plane::Xy, centre, direction } => arc(motion, centre, direction),
            Curve::Arc { plane, centre, direction } => {
                arc_from_the_side(motion, plane, centre, direction)
            }
        };
        let steps = if self.corners_left > 0 {
            format!("<path class=\"s\" d=\"M{x} {y}")
        } else {
            String::new()
        };
        let written = write!(self.out, "<path class=\"{class}\" d=\"{d}\"/>\n{steps}");
        self.check(written)
    }

    /// Takes a step, of which z does not show.
    pub(super) fn pulse(&mut self, Pulse([x, y, _]): Pulse<3>) -> Result<(), Failure> {
        let pulse = [x, y];
        if pulse == [0, 0] {
            return Ok(());
        }
        for axis in 0..2 {
            self.position[axis] += i64::from(pulse[axis]);
        }
        self.include(self.position);
        if pulse == self.run.0 {
            self.run.1 += 1;
            return Ok(());
        }
        let written = self.write_run();
        self.run = (pulse, 1);
        self.check(written)
    }

    pub(super) fn end_block(&mut self) -> Result<(), Failure> {
        let is_drawn = self.corners_left > 0;
        let mut written = self.write_run();
        if is_drawn {
            // The last corner may just have used up what was left: the path is open all the same.
            written = written.and_then(|()| self.out.write_all(b"\"/>\n"));
        }
        self.check(written)
    }

    fn write_run(&mut self) -> io::Result<()> {
        let ([dx, dy], count) = std::mem::take(&mut self.run);
        // One corner is kept for the end of the block.
        if count == 0 || self.corners_left <= 1 {
            return Ok(());
        }
        self.corners_left -= 1;
        match (i64::from(dx) * count, i64::from(dy) * count) {
            (x, 0) => write!(self.out, "h{x}"),
            (0, y) => write!(self.out, "v{y}"),
            (x, y) => write!(self.out, "l{x} {y}"),
        }
    }

    /// Completes the file.
    pub(super) fn finish(mut self) -> Result<OutputFile, Failure> {
        let written = self.write_frame();
        self.check(written)?;
        Ok(self.file)
    }

    fn write_frame(&mut self) -> io::Result<()> {
        self.out.write_all(b"</g>\n</svg>\n")?;
        let [low, high] = self.frame;
        let size = [high[0] - low[0], high[1] - low[1]].map(|side| side.max(1) as f64);
        let margin = size[0].max(size[1]) * 0.04;
        let tag = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" font-size=\"{:.4}\" viewBox=\"{:.1} {:.1} {:.1} {:.1}\">",
            (size[0] + 2.0 * margin) / 900.0,
            low[0] as f64 - margin,
            -(high[1] as f64) - margin,
            size[0] + 2.0 * margin,
            size[1] + 2.0 * margin,
        );
        self.out.seek(SeekFrom::Start(0))?;
        write!(self.out, "{tag:FRAME$}")?;
        self.out.flush()
    }

    fn include(&mut self, point: [i64; 2]) {
        for axis in 0..2 {
            self.frame[0][axis] = self.frame[0][axis].min(point[axis]);
            self.frame[1][axis] = self.frame[1][axis].max(point[axis]);
        }
    }

    fn check(&self, written: io::Result<()>) -> Result<(), Failure> {
        written.map_err(|error| self.file.failure(&error))
    }
}

/// The path of an arc: a full circle as two halves, as SVG cannot draw it in one.
fn arc(motion: &Motion, centre: [i64; 2], direction: Direction) -> String {
    let seen = |point: [i32; 2]| [0, 1].map(|axis| (i64::from(point[axis]) - centre[axis]) as f64);
    let ends = motion.ends_in(Plane::Xy);
    let [start, end] = ends.map(seen);
    let radius = start[0].hypot(start[1]);
    let sense = u8::from(direction == Direction::Ccw);
    let [[x, y], [xe, ye]] = ends;
    if [x, y] == [xe, ye] {
        let across = [2 * centre[0] - i64::from(x), 2 * centre[1] - i64::from(y)];
        return format!(
            "M{x} {y}A{radius:.3} {radius:.3} 0 0 {sense} {} {}A{radius:.3} {radius:.3} 0 0 {sense} {xe} {ye}",
            across[0], across[1]
        );
    }
    let turn = start[0] * end[1] - start[1] * end[0];
    let is_long = if direction == Direction::Ccw { turn < 0.0 } else { turn > 0.0 };
    format!("M{x} {y}A{radius:.3} {radius:.3} 0 {} {sense} {xe} {ye}", u8::from(is_long))
}

/// The path of an arc in the ZX or YZ plane, which is seen as a straight one: to and fro, by way of the points
/// furthest out that it passes, to its end.
fn arc_from_the_side(
    motion: &Motion,
    plane: Plane,
    centre: [i64; 2],
    direction: Direction,
) -> String {
    let [start, end] = motion.ends_in(plane);
    let angle = |point: [i32; 2]| {
        let [first, second] = [0, 1].map(|axis| (i64::from(point[axis]) - centre[axis]) as f64);
        second.atan2(first)
    };
    let radius = [0, 1].map(|axis| (i64::from(start[axis]) - centre[axis]) as f64);
    let radius = radius[0].hypot(radius[1]);
    // The way to an angle, from 0 to a full turn.
    let turn = if direction == Direction::Ccw { 1.0 } else { -1.0 };
    let ahead = |to: f64| ((to - angle(start)) * turn).rem_euclid(TAU);
    let sweep = if start == end { TAU } else { ahead(angle(end)) };
    // The one axis of the plane that shows, and the angles at which it is largest and smallest.
    let (shown, largest) = if plane == Plane::Yz { (0, 0.0) } else { (1, FRAC_PI_2) };
    let furthest = [(largest, radius), (largest + PI, -radius)];
    let mut passed = furthest.map(|(angle, off)| (ahead(angle), centre[shown] as f64 + off));
    passed.sort_by(|one, other| one.0.total_cmp(&other.0));
    let [[x, y], [xe, ye]] = motion.ends_in(Plane::Xy);
    let mut path = format!("M{x} {y}");
    for (_, at) in passed.into_iter().filter(|(way, _)| 0.0 < *way && *way < sweep) {
        // Either X and Z or Y and Z move.
        path += &if plane == Plane::Yz { format!("L{x} {at:.3}") } else { format!("L{at:.3} {y}") };
    }
    path + &format!("L{xe} {ye}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(from: [i32; 3], to: [i32; 3], plane: Plane, centre: [i64; 2], is_ccw: bool) -> String {
        let direction = if is_ccw { Direction::Ccw } else { Direction::Cw };
        let curve = Curve::Arc { plane, centre, direction };
        let motion = Motion { line: 1, from, to, curve, rate: Rate::Rapid };
        arc_from_the_side(&motion, plane, centre, direction)
    }

    #[test]
    fn arcs_from_the_side_go_as_far_as_they_bulge() {
        // In ZX about (0, 0), y = 7: z first, so counter-clockwise goes from z to x.
        let quarter = drawn([0, 7, 5], [5, 7, 0], Plane::Zx, [0, 0], true);
        assert_eq!(quarter, "M0 7L5 7");
        let three_quarters = drawn([0, 7, 5], [5, 7, 0], Plane::Zx, [0, 0], false);
        assert_eq!(three_quarters, "M0 7L-5.000 7L5 7");
        let half = drawn([3, 7, -4], [3, 7, 4], Plane::Zx, [0, 0], false);
        assert_eq!(half, "M3 7L5.000 7L3 7");
        // In YZ, x = 7: a full circle about y = 10, and from its right half a turn over the top.
        let turn = drawn([7, 13, 4], [7, 13, 4], Plane::Yz, [10, 0], true);
        assert_eq!(turn, "M7 13L7 5.000L7 15.000L7 13");
        let over = drawn([7, 14, 3], [7, 6, -3], Plane::Yz, [10, 0], true);
        assert_eq!(over, "M7 14L7 5.000L7 6");
    }
}
