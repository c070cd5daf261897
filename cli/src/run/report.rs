//! `report.json`, and the summary on standard output.

use super::block::BlockResult;
use super::coarse::{Coarse, PLANNED, Reduced, SamplingReport};
use super::config::Config;
use super::planned::{MotionReport, ServoReport};
use super::speed::Speed;
use super::two_level::TwoLevel;
use crate::action::Move;
use crate::choice::{Method, UpdateName};
use crate::failure::Failure;
use crate::output::OutputFile;
use crate::pulses::AXES;
use onepulse_core::Direction;
use onepulse_plan::gcode::Pause;
use onepulse_plan::{Curve, Rate};
use serde::Serialize;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// What the report says of one block.
#[derive(Clone, Debug, Serialize)]
pub(super) struct BlockReport {
    /// The program's line, from 1.
    line: u32,
    curve: &'static str,
    method: &'static str,
    feed_mm_per_min: f64,
    /// Once the program has said T.
    #[serde(skip_serializing_if = "Option::is_none")]
    tool: Option<u32>,
    /// Once it has said S.
    #[serde(skip_serializing_if = "Option::is_none")]
    spindle_rpm: Option<f64>,
    cycles: u64,
    pulses: PerAxis<u64>,
    /// In pulses: from the line, or from the circle through the arc's start.
    largest_deviation: f64,
    endpoint_exact: bool,
    /// What is missing to the end point, in pulses.
    residual: PerAxis<i64>,
    duration_s: f64,
    /// Whether hardware model and software sent the same pulses.
    hardware_agrees: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    disagrees_at_cycle: Option<u64>,
    /// Of two levels: the coarse one, and what the deviation is made of.
    #[serde(skip_serializing_if = "Option::is_none")]
    sampling: Option<SamplingReport>,
}

/// What the report says of a dwell or a program stop.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct PauseReport {
    /// The program's line, from 1.
    line: u32,
    /// None of a program stop.
    dwell_s: Option<f64>,
}

impl PauseReport {
    pub(super) fn new(pause: &Pause) -> Self {
        Self { line: pause.place.line, dwell_s: pause.dwell.map(|time| time.as_secs_f64()) }
    }
}

/// A value for each axis that the program moves.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct PerAxis<T> {
    x: T,
    y: T,
    #[serde(skip_serializing_if = "Option::is_none")]
    z: Option<T>,
}

impl<T> PerAxis<T> {
    /// The values of the first axes, so many.
    pub(super) fn of([x, y, z]: [T; 3], axes: usize) -> Self {
        Self { x, y, z: (axes > 2).then_some(z) }
    }

    /// One after the other.
    fn values(self) -> impl Iterator<Item = T> {
        [Some(self.x), Some(self.y), self.z].into_iter().flatten()
    }

    /// All as text, with something between.
    fn joined(self, between: &str, text: impl FnMut(T) -> String) -> String {
        self.values().map(text).collect::<Vec<_>>().join(between)
    }
}

impl BlockReport {
    pub(super) fn new(
        step: &Move,
        method: &Method,
        speed: Speed,
        run: &BlockResult,
        coarse: Option<Coarse<'_>>,
        axes: usize,
    ) -> Self {
        let Move { motion, tool, spindle, .. } = step;
        let curve = match (motion.curve, motion.rate) {
            (Curve::Line, Rate::Rapid) => "rapid",
            (Curve::Line, Rate::Feed(_)) => "line",
            (Curve::Arc { direction: Direction::Cw, .. }, _) => "arc cw",
            (Curve::Arc { direction: Direction::Ccw, .. }, _) => "arc ccw",
        };
        let method = match (method, motion.curve) {
            _ if coarse.is_some() => "two levels",
            (Method::Dda { update: UpdateName::Staggered, .. }, Curve::Arc { .. }) => {
                "dda staggered"
            }
            (Method::Dda { update: UpdateName::Simultaneous, .. }, Curve::Arc { .. }) => {
                "dda simultaneous"
            }
            _ => method.name(),
        };
        Self {
            line: motion.line,
            curve,
            method,
            feed_mm_per_min: speed.millimetres_per_minute(),
            tool: *tool,
            spindle_rpm: *spindle,
            cycles: run.cycles,
            pulses: PerAxis::of(run.pulses, axes),
            largest_deviation: run.deviation,
            endpoint_exact: run.residual == [0; 3],
            residual: PerAxis::of(run.residual, axes),
            duration_s: run.seconds,
            hardware_agrees: run.disagreement.is_none(),
            disagrees_at_cycle: run.disagreement,
            sampling: coarse.map(|coarse| coarse.report.with_fine(run.fine)),
        }
    }
}

/// The report, written block by block.
#[derive(Debug)]
pub(super) struct Report {
    out: BufWriter<File>,
    file: OutputFile,
    is_first: bool,
}

impl Report {
    pub(super) fn begin(
        file: OutputFile,
        program: &str,
        config: &Config,
        method: &Method,
    ) -> Result<Self, Failure> {
        let mut report = Self { out: file.writer()?, file, is_first: true };
        let mut machine = serde_json::json!({
            "pulse_mm": config.machine.pulse.millimetres(),
            "bits": config.bits,
            "method": method.name(),
        });
        if let Some(levels) = config.two_level {
            machine["bits"] = serde_json::json!(levels.bits);
            machine["two_level"] = serde_json::json!({
                "period_ms": levels.period_ms,
                "sampling": if levels.accelerate { PLANNED } else { levels.sampling.name() },
                "tolerance_mm": levels.tolerance_mm,
            });
        }
        let program = serde_json::json!(program);
        let head = format!("{{\n\"program\": {program},\n\"machine\": {machine},\n\"blocks\": [");
        let written = report.out.write_all(head.as_bytes());
        report.check(written)?;
        Ok(report)
    }

    /// Adds a block.
    pub(super) fn block(&mut self, block: &BlockReport) -> Result<(), Failure> {
        let separator: &[u8] = if self.is_first { b"\n" } else { b",\n" };
        self.is_first = false;
        let written = self.out.write_all(separator);
        let written = written.and_then(|()| Ok(serde_json::to_writer(&mut self.out, block)?));
        self.check(written)
    }

    /// Completes the file.
    pub(super) fn finish(
        mut self,
        summary: &Summary,
        config: &Config,
    ) -> Result<OutputFile, Failure> {
        let pulse = config.machine.pulse.millimetres();
        let totals = serde_json::json!({
            "blocks": summary.blocks,
            "cycles": summary.cycles,
            "pulses": PerAxis::of(summary.pulses, summary.axes),
            "largest_deviation": summary.deviation,
            "endpoints_exact": summary.endpoints_exact,
            "duration_s": summary.seconds,
        });
        let mut position = serde_json::json!({});
        let axes = AXES[..summary.axes].iter().zip(summary.position);
        for (axis, pulses) in axes.clone() {
            position[*axis] = pulses.into();
        }
        for (axis, pulses) in axes {
            position[format!("{axis}_mm")] = (pulses as f64 * pulse).into();
        }
        let written = self.out.write_all(b"\n],\n");
        let written = written.and_then(|()| match summary.pauses.as_slice() {
            [] => Ok(()),
            pauses => writeln!(self.out, "\"pauses\": {},", serde_json::to_string(pauses)?),
        });
        let written = written.and_then(|()| {
            write!(self.out, "\"totals\": {totals},\n\"final_position\": {position},\n")
        });
        let written = written.and_then(|()| match &summary.motion {
            None => Ok(()),
            Some(motion) => {
                writeln!(self.out, "\"motion\": {},", serde_json::to_string(motion)?)
            }
        });
        let written = written
            .and_then(|()| writeln!(self.out, "\"hardware_agrees\": {}\n}}", summary.agrees))
            .and_then(|()| self.out.flush());
        self.check(written)?;
        Ok(self.file)
    }

    fn check(&self, written: io::Result<()>) -> Result<(), Failure> {
        written.map_err(|error| self.file.failure(&error))
    }
}

/// The whole run.
#[derive(Debug)]
pub(super) struct Summary {
    /// Those that the program moves: two, or with z three.
    axes: usize,
    blocks: u64,
    cycles: u64,
    pulses: [u64; 3],
    deviation: f64,
    endpoints_exact: bool,
    seconds: f64,
    position: [i64; 3],
    pub(super) agrees: bool,
    /// The samples of the block with the largest deviation, and its line.
    worst: Option<(u32, SamplingReport)>,
    samples: u64,
    /// Where speeds are planned.
    pub(super) motion: Option<MotionReport>,
    /// All dwells and stops.
    pauses: Vec<PauseReport>,
    /// The first blocks and pauses, for showing.
    shown: Vec<Shown>,
}

/// A line of the summary.
#[allow(clippy::large_enum_variant, reason = "nearly all are blocks")]
#[derive(Debug)]
enum Shown {
    Block(BlockReport),
    Pause(PauseReport),
}

/// Blocks and pauses that the summary shows one by one.
const SHOWN: usize = 40;

impl Summary {
    /// Of a run in which nothing has moved yet.
    pub(super) const fn new(axes: usize) -> Self {
        Self {
            axes,
            blocks: 0,
            cycles: 0,
            pulses: [0; 3],
            deviation: 0.0,
            endpoints_exact: true,
            seconds: 0.0,
            position: [0; 3],
            agrees: true,
            worst: None,
            samples: 0,
            motion: None,
            pauses: Vec::new(),
            shown: Vec::new(),
        }
    }

    /// Adds a block that ended in `position`.
    pub(super) fn add(&mut self, block: &BlockReport, position: [i64; 3]) {
        self.blocks += 1;
        self.cycles += block.cycles;
        for (sum, pulses) in self.pulses.iter_mut().zip(block.pulses.values()) {
            *sum += pulses;
        }
        if let Some(sampling) = &block.sampling {
            self.samples += sampling.samples;
            if self.worst.is_none() || block.largest_deviation > self.deviation {
                self.worst = Some((block.line, sampling.clone()));
            }
        }
        self.deviation = self.deviation.max(block.largest_deviation);
        self.endpoints_exact &= block.endpoint_exact;
        self.seconds += block.duration_s;
        self.position = position;
        self.agrees &= block.hardware_agrees;
        if self.shown.len() < SHOWN {
            self.shown.push(Shown::Block(block.clone()));
        }
    }

    /// Adds a dwell, with its time, or a stop.
    pub(super) fn pause(&mut self, pause: PauseReport) {
        self.seconds += pause.dwell_s.unwrap_or(0.0);
        self.pauses.push(pause);
        if self.shown.len() < SHOWN {
            self.shown.push(Shown::Pause(pause));
        }
    }

    /// The readable summary on standard output.
    pub(super) fn print(
        &self,
        program: &str,
        folder: &Path,
        config: &Config,
    ) -> Result<(), Failure> {
        self.write(io::stdout().lock(), program, folder, config)
            .map_err(|error| Failure::stdout(&error))
    }

    fn write(
        &self,
        mut out: impl Write,
        program: &str,
        folder: &Path,
        config: &Config,
    ) -> io::Result<()> {
        let pulse = config.machine.pulse.millimetres();
        let registers = match config.two_level {
            Some(levels) if levels.bits.is_none() => "the smallest registers that serve".to_owned(),
            _ => format!("{} bit registers", config.bits),
        };
        writeln!(out, "{program}: pulse equivalent {pulse} mm, {registers}\n")?;
        writeln!(
            out,
            "{:>6}  {:8}  {:16}  {:>10}  {}  {:>9}  {:>9}  {:>9}",
            "line",
            "curve",
            "method",
            "cycles",
            AXES[..self.axes]
                .iter()
                .map(|axis| format!("{axis} pulses"))
                .collect::<Vec<_>>()
                .join("  "),
            "deviation",
            "end",
            "time"
        )?;
        for shown in &self.shown {
            let block = match shown {
                Shown::Block(block) => block,
                Shown::Pause(pause) => {
                    self.write_pause(&mut out, *pause)?;
                    continue;
                }
            };
            let end = if block.endpoint_exact {
                "exact".to_owned()
            } else {
                block.residual.joined(",", |missing| missing.to_string())
            };
            writeln!(
                out,
                "{:>6}  {:8}  {:16}  {:>10}  {}  {:>9.4}  {end:>9}  {:>7.3} s",
                block.line,
                block.curve,
                block.method,
                block.cycles,
                block.pulses.joined("  ", |pulses| format!("{pulses:>8}")),
                block.largest_deviation,
                block.duration_s
            )?;
        }
        let all = self.blocks + self.pauses.len() as u64;
        if all > self.shown.len() as u64 {
            writeln!(out, "   ...  {} more in report.json", all - self.shown.len() as u64)?;
        }
        writeln!(
            out,
            "\n{} blocks, {} cycles, {} pulses, {:.3} s; final position {}",
            self.blocks,
            self.cycles,
            PerAxis::of(self.pulses, self.axes).joined(" + ", |pulses| pulses.to_string()),
            self.seconds,
            PerAxis::of(self.position, self.axes).joined(",", |c| c.to_string())
        )?;
        if !self.pauses.is_empty() {
            let dwells: Vec<f64> = self.pauses.iter().filter_map(|pause| pause.dwell_s).collect();
            let (count, seconds) = (dwells.len(), dwells.iter().sum::<f64>());
            let stops = self.pauses.len() - count;
            writeln!(out, "dwells: {count}, {seconds:.3} s in all; program stops: {stops}")?;
        }
        write!(out, "largest deviation {:.4} pulses", self.deviation)?;
        match &self.worst {
            None => writeln!(out)?,
            Some((line, worst)) => {
                let SamplingReport { chord_error, radius_error, rounding, fine, .. } = worst;
                writeln!(
                    out,
                    ", in line {line} <= {:.4} = chord error {chord_error:.4} + radius error \
                     {radius_error:.4} + rounding {rounding:.4} + fine deviation {fine:.4}",
                    worst.bound()
                )?;
            }
        }
        if let Some(levels) = config.two_level {
            let TwoLevel { period_ms, .. } = levels;
            match &self.motion {
                None => writeln!(
                    out,
                    "{} samples of {period_ms} ms; the last of a block, a shorter way, takes as long",
                    self.samples
                )?,
                Some(motion) => self.write_motion(&mut out, period_ms, motion)?,
            }
            self.write_reduced(&mut out)?;
        }
        let exact = if self.endpoints_exact { "every" } else { "NOT every" };
        writeln!(out, "{exact} block ends exactly on its end point")?;
        let agree = if self.agrees { "agree on every pulse" } else { "DISAGREE" };
        writeln!(out, "hardware model and software {agree}")?;
        writeln!(out, "written to {}", folder.display())?;
        out.flush()
    }

    /// The line of a dwell or a stop.
    fn write_pause(&self, out: &mut impl Write, pause: PauseReport) -> io::Result<()> {
        let PauseReport { line, dwell_s } = pause;
        match dwell_s {
            None => writeln!(out, "{line:>6}  stop"),
            Some(seconds) => {
                // From the column of the method to that of the end.
                let blank = 50 + 10 * self.axes;
                writeln!(out, "{line:>6}  {:8}  {:blank$}  {seconds:>7.3} s", "dwell", "")
            }
        }
    }

    /// How the planned motion is at most.
    fn write_motion(
        &self,
        out: &mut impl Write,
        period_ms: f64,
        motion: &MotionReport,
    ) -> io::Result<()> {
        let MotionReport {
            largest_speed_mm_per_s: speed,
            largest_acceleration_mm_per_s2: acceleration,
            largest_jerk_mm_per_s3: jerk,
            servo,
            ..
        } = *motion;
        write!(
            out,
            "{} samples, at periods of {period_ms} ms and block ends: at most {speed:.3} mm/s, \
             {acceleration:.3} mm/s²",
            self.samples
        )?;
        match jerk {
            Some(jerk) => writeln!(out, ", {jerk:.3} mm/s³")?,
            None => writeln!(out)?,
        }
        if let Some(ServoReport { gain_per_s, largest_following_error_mm }) = servo {
            let errors = AXES.iter().zip(largest_following_error_mm.values());
            let errors: Vec<_> =
                errors.map(|(axis, error)| format!("{error:.4} mm in {axis}")).collect();
            let errors = errors.join(", ");
            writeln!(out, "largest following errors {errors}; K_v is {gain_per_s}/s")?;
        }
        Ok(())
    }

    /// Which feeds could not be kept, and why.
    fn write_reduced(&self, out: &mut impl Write) -> io::Result<()> {
        for shown in &self.shown {
            let Shown::Block(block) = shown else { continue };
            let Some(sampling) = &block.sampling else { continue };
            let why = match sampling.feed_reduced_for {
                None => continue,
                Some(Reduced::Radius) => "steps of a quarter of the radius",
                Some(Reduced::Tolerance) => "the chord error tolerated",
                Some(Reduced::Centripetal) => "the centripetal acceleration",
            };
            writeln!(
                out,
                "note: line {}: feed reduced from {} to {:.3} mm/min, {why}",
                block.line, block.feed_mm_per_min, sampling.feed_mm_per_min
            )?;
        }
        Ok(())
    }
}
