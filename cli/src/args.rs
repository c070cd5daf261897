//! The command line.

use crate::choice::{EndRuleName, MethodName, PresetName, UpdateName};
use crate::compare;
use crate::contour_error::ContourErrorArguments;
use crate::curve::{AxisName, Curve, PlaneName, PlanePoint, Point, coordinate};
use crate::cutters::CutterOptions;
use crate::feed_rate::FeedRateArguments;
use crate::interpolator::DriveTimes;
use crate::motion_settings::MotionOptions;
use crate::offset;
use crate::plots;
use crate::pulses;
use crate::ramp::RampArguments;
use crate::sample::SamplingName;
use crate::table::{Format, Language};
use clap::{Args, Parser, Subcommand};
use onepulse_core::Direction;
use onepulse_hwmodel::interpolator::Interpolator;
use std::path::PathBuf;

/// NC interpolation: a G-code program, or one curve, into pulses, tables, waves and pictures.
#[derive(Debug, Parser)]
#[command(name = "onepulse", version, propagate_version = true)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// The pulses of one curve as CSV, or drawn
    Pulses(PulsesArguments),
    /// The step table of one curve as a textbook prints it
    Table(TableArguments),
    /// All methods side by side on one curve
    ///
    /// A line for each method that serves the curve and for each of its settings worth one. A cycle
    /// is a step of four beats, an accumulation or a clock of the rate multiplier's source, as in
    /// `onepulse pulses`; and of each method there are
    ///
    /// cycles, pulses of each axis;
    ///
    /// deviation, largest and root mean square: the distance from the true curve, in pulses, after
    /// every cycle that emits a pulse (an arc's curve is the circle through its start);
    ///
    /// v/v_max, the feed ratio: v is the length of the true curve that a cycle advances, v_max what it
    /// would with a pulse on every axis that the method may feed in one cycle: 1 pulse with ppc, which
    /// feeds one, and √2 with the others in the plane (√3 and 2 on lines of 3 and 4 axes). Its mean is
    /// that of the whole curve; least and largest are those of its parts, which are as many as are 32
    /// pulses long, 360 at most; spread is the largest by the least;
    ///
    /// jitter of each axis: the standard deviation of the cycles between successive pulses, divided by
    /// their mean (on arcs and parabolas these cycles change by themselves, however even the feed);
    ///
    /// end: exact, or what is missing to the end point.
    Compare(CompareArguments),
    /// The hardware model's wave of one curve
    Wave(WaveArguments),
    /// How fast the methods go, over the direction of a line or over its length
    FeedRate(FeedRateArguments),
    /// The points of one curve by data sampling, in millimetres
    Sample(SampleArguments),
    /// What ramps after interpolation and position loops take from circles and corners
    ///
    /// Each error three times, in millimetres: as the textbooks' formula has it, for periods that are short and
    /// errors that are small; exactly, period by period; and measured on a path that was run through. All
    /// are those of a steady speed; that of a circle is what its radius loses.
    ContourError(ContourErrorArguments),
    /// The pulses of one axis that starts and stops by itself, along a trapezoid or an S-curve
    ///
    /// The integer machines of an open loop: a speed register that changes by no more than the acceleration on
    /// each clock, and a phase register whose carry is the pulse. There are exactly as many pulses as asked,
    /// however few. Limits are rounded down to what the registers hold, which is said on standard error.
    /// The speed of a row is that of the register, in pulses a second.
    Ramp(RampArguments),
    /// The motion of a G-code program over time: speed, acceleration, jerk, pulse intervals
    ///
    /// Speeds are planned through the whole program: what the next 128 blocks at least demand is known in
    /// each of them. A row for each sample period and for the end of each block; lengths are millimetres,
    /// times seconds. Speed, acceleration and jerk are those commanded along the path; an interval is the
    /// mean time between the pulses of an axis since the row before; with --servo-gain there is the
    /// following error of each axis.
    ///
    /// The machine is at rest before a dwell (G04) and a program stop (M00). The rows of a dwell are those of
    /// its own line, for each period and for its end, at speed 0; the position loops run on. A stop takes no
    /// time and has no row.
    Profile(ProfileArguments),
    /// The path of the cutter's centre: the contours of a G-code program compensated by its radius
    ///
    /// A row for each line and arc, in millimetres; `line` is the program's. Roles are rapid and feed (as
    /// programmed), establish, offset (along a block, the radius away from it), corner and cancel. Columns of Z
    /// are appended if anything moves out of the plane of X and Y.
    Offset(OffsetArguments),
    /// A G-code program: pulses, waves, a picture and a report
    ///
    /// A block that moves in one of the planes XY, ZX and YZ is made by the machine of two axes on the two
    /// that move; a line that moves X, Y and Z at once by that of three, which dda, brm and min-deviation
    /// have in hardware. Every output has z if the program ever moves it; the picture shows
    /// all motions as seen along z.
    ///
    /// In a dwell (G04) time goes on and nothing is clocked; a program stop (M00) is named and takes no
    /// time. The report lists both as `pauses`, and has the tool (T) and the spindle's speed (S) of each
    /// block once the program has said them; nothing else is done with these.
    Run(Box<RunArguments>),
}

/// A curve and how to interpolate it.
#[derive(Debug, Args)]
pub(crate) struct CurveArguments {
    #[command(subcommand)]
    curve: CurveCommand,
    #[command(flatten)]
    pub(crate) options: Options,
}

#[derive(Debug, Args)]
pub(crate) struct CompareArguments {
    #[command(subcommand)]
    pub(crate) curve: CurveCommand,
    /// Register width [default: for each method the smallest that serves the curve]
    #[arg(long, value_name = "N", global = true, allow_negative_numbers = true)]
    pub(crate) bits: Option<u32>,
    /// How to write the comparison
    #[arg(long, value_enum, default_value_t, global = true)]
    pub(crate) format: compare::Format,
    /// Draw all paths over the true curve as SVG: plane curves of up to 64 pulses' length
    #[arg(long, value_name = "FILE.svg", global = true)]
    pub(crate) picture: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct PulsesArguments {
    #[command(flatten)]
    pub(crate) curve: CurveArguments,
    /// How to show them
    #[arg(long, value_enum, default_value_t, global = true)]
    pub(crate) format: pulses::Format,
}

#[derive(Debug, Args)]
pub(crate) struct TableArguments {
    #[command(flatten)]
    pub(crate) curve: CurveArguments,
    /// How to write the table
    #[arg(long, value_enum, default_value_t, global = true)]
    pub(crate) format: Format,
    /// The language of headings and words
    #[arg(long, value_enum, default_value_t, global = true)]
    pub(crate) lang: Language,
}

/// The heading of the options that belong to `--interpolator`.
const INTERPOLATOR: &str = "Whole interpolator";

#[derive(Debug, Args)]
pub(crate) struct WaveArguments {
    #[command(flatten)]
    pub(crate) curve: CurveArguments,
    /// The wave file, .vcd or .fst; beside it layouts for GTKWave (.gtkw) and Surfer (.sucl)
    #[arg(short, long, value_name = "FILE", global = true)]
    pub(crate) output: Option<PathBuf>,
    /// Frequency of the pulse source, which times the interpolation cycles, in hertz
    #[arg(
        long,
        value_name = "HZ",
        default_value_t = 1_000_000,
        global = true,
        allow_negative_numbers = true
    )]
    pub(crate) source_hz: u64,
    /// The first clock that is traced
    #[arg(long, value_name = "CLOCK", default_value_t = 0, global = true)]
    pub(crate) from_clock: u64,
    /// How many clocks are traced [default: all]
    #[arg(long, value_name = "N", global = true)]
    pub(crate) clocks: Option<u64>,
    /// Run the curve as a command through the whole interpolator: decoder, queue, pulse source,
    /// engine, and the step and direction outputs
    #[arg(long, global = true, help_heading = INTERPOLATOR)]
    pub(crate) interpolator: bool,
    /// Clocks from one interpolation cycle to the next, at least 6: the system clock is that many
    /// times --source-hz [default: 8]
    #[arg(
        long,
        value_name = "CLOCKS",
        global = true,
        help_heading = INTERPOLATOR,
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(1..1 << Interpolator::<2>::PERIOD_BITS)
    )]
    pub(crate) period: Option<u32>,
    /// What the drives ask for: clocks that step is high, that it is low, and that the direction
    /// stands before and after it [default: 2,2,2,2]
    #[arg(
        long,
        value_name = "LENGTH,SPACE,SETUP,HOLD",
        global = true,
        help_heading = INTERPOLATOR,
        allow_hyphen_values = true
    )]
    pub(crate) step_clocks: Option<DriveTimes>,
}

#[derive(Debug, Args)]
pub(crate) struct SampleArguments {
    #[command(subcommand)]
    curve: CurveCommand,
    /// The feed in millimetres a minute
    #[arg(long, value_name = "MM_PER_MIN", global = true, default_value = "300")]
    pub(crate) feed: String,
    /// The sample period in milliseconds
    #[arg(long, value_name = "MS", global = true, default_value = "8")]
    pub(crate) period: String,
    /// How the points of an arc are found
    #[arg(long, value_enum, global = true, default_value_t)]
    pub(crate) method: SamplingName,
    /// The pulse equivalent in millimetres
    #[arg(long, value_name = "MM", global = true, default_value = "0.001")]
    pub(crate) pulse_mm: String,
    /// The largest chord error of an arc, in millimetres: the feed is reduced to keep it
    #[arg(long, value_name = "MM", global = true)]
    pub(crate) tolerance: Option<String>,
    /// Of an arc, for each sample: the chord error, exactly and as textbooks approximate it, and
    /// what the point is off the radius
    #[arg(long, global = true)]
    pub(crate) errors: bool,
}

#[derive(Debug, Args)]
pub(crate) struct OffsetArguments {
    /// The G-code program
    pub(crate) program: PathBuf,
    /// The machine: pulse equivalent, what integers count
    #[arg(long, value_name = "machine.toml")]
    pub(crate) config: Option<PathBuf>,
    /// The pulse equivalent in millimetres
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    pub(crate) pulse_mm: Option<String>,
    /// How to write it
    #[arg(long, value_enum, default_value_t)]
    pub(crate) format: offset::Format,
    #[command(flatten)]
    pub(crate) cutters: CutterOptions,
}

/// The heading of the options that belong to `--two-level`.
const TWO_LEVELS: &str = "Two levels";

#[derive(Debug, Args)]
pub(crate) struct ProfileArguments {
    /// The G-code program
    pub(crate) program: PathBuf,
    /// The machine: pulse equivalent, speeds, limits
    #[arg(long, value_name = "machine.toml")]
    pub(crate) config: Option<PathBuf>,
    /// The pulse equivalent in millimetres
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    pub(crate) pulse_mm: Option<String>,
    /// How to write it
    #[arg(long, value_enum, default_value_t)]
    pub(crate) format: plots::Format,
    /// The sample period in milliseconds [default: 8]
    #[arg(long, value_name = "MS", allow_negative_numbers = true)]
    pub(crate) period: Option<String>,
    #[command(flatten)]
    pub(crate) motion: MotionOptions,
    #[command(flatten)]
    pub(crate) cutters: CutterOptions,
}

#[derive(Debug, Args)]
pub(crate) struct RunArguments {
    /// The G-code program
    pub(crate) program: PathBuf,
    /// The machine: pulse equivalent, speeds, registers
    #[arg(long, value_name = "machine.toml")]
    pub(crate) config: Option<PathBuf>,
    /// Where to write waves.vcd, waves.gtkw, waves.sucl, pulses.csv, path.svg and report.json, and with
    /// --accelerate profile.svg
    #[arg(long, value_name = "DIR", default_value = "out")]
    pub(crate) out: PathBuf,
    /// Write no waves (the hardware model still runs and is compared)
    #[arg(long)]
    pub(crate) no_waves: bool,
    /// The first clock of the run that is traced
    #[arg(long, value_name = "CLOCK", default_value_t = 0)]
    pub(crate) from: u64,
    /// How many clocks are traced [default: all]
    #[arg(long, value_name = "N")]
    pub(crate) clocks: Option<u64>,
    /// The pulse equivalent in millimetres
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    pub(crate) pulse_mm: Option<String>,
    /// Coarse and fine interpolation: sample every block once a period, and make a DDA line of 2^n
    /// accumulations of every sample. The last sample of a block, a shorter way, takes a whole period too
    #[arg(long, help_heading = TWO_LEVELS)]
    pub(crate) two_level: bool,
    /// The sample period in milliseconds [default: 8]
    #[arg(long, value_name = "MS", help_heading = TWO_LEVELS, allow_negative_numbers = true)]
    pub(crate) period: Option<String>,
    /// How the samples of an arc are found [default: 7m]
    #[arg(long, value_enum, help_heading = TWO_LEVELS)]
    pub(crate) sampling: Option<SamplingName>,
    /// The largest chord error of an arc: its feed is reduced to keep it
    #[arg(long, value_name = "MM", help_heading = TWO_LEVELS, allow_negative_numbers = true)]
    pub(crate) tolerance: Option<String>,
    /// Acceleration before interpolation: two levels with the speeds of `onepulse profile`, planned
    /// through the whole program within the limits under Motion. The sample periods run on through the
    /// blocks, each of which ends at a time of its own
    #[arg(long, help_heading = TWO_LEVELS)]
    pub(crate) accelerate: bool,
    #[command(flatten)]
    pub(crate) motion: MotionOptions,
    #[command(flatten)]
    pub(crate) cutters: CutterOptions,
    #[command(flatten)]
    pub(crate) options: Options,
}

#[derive(Debug, Subcommand)]
pub(crate) enum CurveCommand {
    /// A line from the origin
    Line {
        /// The end point, 2 to 4 axes
        #[arg(long, value_name = "X,Y[,Z[,A]]", allow_hyphen_values = true)]
        to: Point,
    },
    /// An arc about the origin; equal ends mean a full circle
    #[command(group(clap::ArgGroup::new("sense").required(true).args(["cw", "ccw"])))]
    Arc {
        /// The start point
        #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
        from: PlanePoint,
        /// The end point
        #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
        to: PlanePoint,
        /// Clockwise
        #[arg(long)]
        cw: bool,
        /// Counter-clockwise
        #[arg(long)]
        ccw: bool,
    },
    /// A parabola from its vertex in the origin: y² = 2px, or x² = 2py
    Parabola {
        /// The parameter p; below zero the parabola opens to the negative side of its axis
        #[arg(long, value_name = "P", allow_hyphen_values = true, value_parser = coordinate)]
        p: i32,
        /// The end point; on the parabola, or rounded to pulses
        #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
        to: PlanePoint,
        /// The axis of symmetry
        #[arg(long, value_enum, default_value_t)]
        axis: AxisName,
    },
    /// An arc about the origin of a plane, with a rise across it
    #[command(group(clap::ArgGroup::new("turn").required(true).args(["cw", "ccw"])))]
    Helix {
        /// The start point in the plane
        #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
        from: PlanePoint,
        /// The end point in the plane; the start point means a full turn
        #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
        to: PlanePoint,
        /// The way across the plane
        #[arg(long, value_name = "Z", allow_hyphen_values = true, value_parser = coordinate)]
        rise: i32,
        /// The plane of the arc
        #[arg(long, value_enum, default_value_t)]
        plane: PlaneName,
        /// Clockwise
        #[arg(long)]
        cw: bool,
        /// Counter-clockwise
        #[arg(long)]
        ccw: bool,
    },
}

/// How to interpolate.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Interpolation")]
pub(crate) struct Options {
    /// The interpolation method [default: ppc]
    #[arg(long, value_enum, global = true)]
    pub(crate) method: Option<MethodName>,
    /// When point-by-point comparison has arrived [default: total]
    #[arg(long, value_enum, global = true)]
    pub(crate) end_rule: Option<EndRuleName>,
    /// Register width [default: the smallest that serves the curve]
    #[arg(long, value_name = "N", global = true, allow_negative_numbers = true)]
    pub(crate) bits: Option<u32>,
    /// Register radix of DDA lines, 2 or 10: --bits then counts digits [default: 2]
    #[arg(long, value_name = "2|10", global = true, value_parser = ["2", "10"])]
    pub(crate) radix: Option<String>,
    /// What the DDA remainder registers start with [default: zero; half for staggered arcs]
    #[arg(long, value_enum, global = true)]
    pub(crate) preset: Option<PresetName>,
    /// Shift the DDA integrands left first
    #[arg(long, global = true)]
    pub(crate) normalize: bool,
    /// DDA arcs: the centred staggered circuit, or the textbook's [default: staggered]
    #[arg(long, value_enum, global = true)]
    pub(crate) update: Option<UpdateName>,
    /// Send the rate multiplier's trains through dividers by 2^K, of which its source makes up by
    /// 2^K times the clocks
    #[arg(
        long,
        value_name = "K",
        global = true,
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(0..=31)
    )]
    pub(crate) smooth: Option<u32>,
}

impl SampleArguments {
    /// The curve.
    pub(crate) fn curve(&self) -> Curve {
        self.curve.curve()
    }
}

impl CurveArguments {
    /// The curve.
    pub(crate) fn curve(&self) -> Curve {
        self.curve.curve()
    }
}

impl CurveCommand {
    /// The curve.
    pub(crate) fn curve(&self) -> Curve {
        let sense = |is_cw| if is_cw { Direction::Cw } else { Direction::Ccw };
        match *self {
            Self::Line { ref to } => Curve::Line { to: to.0.clone() },
            Self::Arc { from, to, cw, .. } => {
                Curve::Arc { from: from.0, to: to.0, direction: sense(cw) }
            }
            Self::Parabola { p, to, axis } => {
                Curve::Parabola { axis: axis.into(), parameter: p, to: to.0 }
            }
            Self::Helix { from, to, rise, plane, cw, .. } => {
                let (from, to, direction) = (from.0, to.0, sense(cw));
                Curve::Helix { plane: plane.into(), from, to, direction, rise }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }
}
