//! `path.svg`: the programmed curves and the staircase of pulses over them.

use crate::failure::Failure;
use crate::output::OutputFile;
use onepulse_core::{Direction, Pulse};
use onepulse_plan::{Curve, Motion, Rate};
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
.s{stroke:#c0392b;stroke-width:.8em}</style>\n<g transform=\"scale(1,-1)\">\n";

impl Picture {
    pub(super) fn begin(file: OutputFile) -> Result<Self, Failure> {
        let mut out = file.writer()?;
        let room = writeln!(out, "{:FRAME$}", "").and_then(|()| out.write_all(STYLE.as_bytes()));
        room.map_err(|error| file.failure(&error))?;
        let none = ([0, 0], 0);
        Ok(Self {
            out,
            file,
            frame: [[0; 2]; 2],
            position: [0; 2],
            run: none,
            corners_left: CORNERS,
        })
    }

    /// Draws the curve of a block, and begins its staircase.
    pub(super) fn begin_block(&mut self, motion: &Motion) -> Result<(), Failure> {
        self.position = motion.from.map(i64::from);
        self.include(self.position);
        let class = match motion.rate {
            Rate::Rapid => "r",
            Rate::Feed(_) => "f",
        };
        let [x, y] = motion.from;
        let d = match motion.curve {
            Curve::Line => format!("M{x} {y}L{} {}", motion.to[0], motion.to[1]),
            Curve::Arc { centre, direction } => arc(motion, centre, direction),
        };
        let steps = if self.corners_left > 0 {
            format!("<path class=\"s\" d=\"M{x} {y}")
        } else {
            String::new()
        };
        let written = write!(self.out, "<path class=\"{class}\" d=\"{d}\"/>\n{steps}");
        self.check(written)
    }

    /// Takes a step.
    pub(super) fn pulse(&mut self, Pulse(pulse): Pulse) -> Result<(), Failure> {
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
    let (start, end) = (seen(motion.from), seen(motion.to));
    let radius = start[0].hypot(start[1]);
    let sense = u8::from(direction == Direction::Ccw);
    let ([x, y], [xe, ye]) = (motion.from, motion.to);
    if motion.from == motion.to {
        let across = [0, 1].map(|axis| 2 * centre[axis] - i64::from(motion.from[axis]));
        return format!(
            "M{x} {y}A{radius:.3} {radius:.3} 0 0 {sense} {} {}A{radius:.3} {radius:.3} 0 0 {sense} {xe} {ye}",
            across[0], across[1]
        );
    }
    let turn = start[0] * end[1] - start[1] * end[0];
    let is_long = if direction == Direction::Ccw { turn < 0.0 } else { turn > 0.0 };
    format!("M{x} {y}A{radius:.3} {radius:.3} 0 {} {sense} {xe} {ye}", u8::from(is_long))
}
