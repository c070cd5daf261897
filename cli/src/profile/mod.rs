//! `onepulse profile`: the motion of a program over time, which `onepulse run --accelerate` makes too.

mod chain;
mod plot;

use crate::action::Action;
use crate::args::ProfileArguments;
use crate::failure::Failure;
use crate::machine_file::MachineFile;
use crate::motion_settings::MotionSettings;
use crate::plots::Format;
use crate::pulses::AXES;
use std::fs::File;
use std::io::{self, BufReader, BufWriter, Write};

pub(crate) use chain::{Row, Rows};
pub(crate) use plot::svg;

pub(crate) fn profile(arguments: &ProfileArguments) -> Result<(), Failure> {
    let file = MachineFile::read(arguments.config.as_deref())?;
    let machine = file.machine(arguments.pulse_mm.as_deref())?;
    let settings = MotionSettings::load(&arguments.motion, arguments.period.as_deref(), &file)?;
    let name = arguments.program.display().to_string();
    let input = File::open(&arguments.program);
    let input = input.map_err(|error| Failure::file(&arguments.program, &error))?;
    // All of it first: a program that is wrong somewhere has no profile.
    let mut actions = Vec::new();
    for step in arguments.cutters.load()?.path(BufReader::new(input), &machine) {
        let step = step.map_err(|error| Failure::program(&arguments.program, error))?;
        actions.extend(Action::of(step));
    }
    let rows = Rows::new(&actions, &machine, &settings, |_| f64::INFINITY);
    let rows = rows.map_err(|why| Failure::Fault(format!("{name}: {why}")))?;
    let axes = rows.axes();
    match arguments.format {
        Format::Csv => csv(rows, axes, settings.servo.is_some()),
        Format::Svg => {
            let text = svg(&rows.collect::<Vec<_>>(), axes)?;
            io::stdout().lock().write_all(text.as_bytes())
        }
    }
    .map_err(|error| Failure::stdout(&error))
}

/// Writes the rows, with so many axes.
fn csv(rows: impl Iterator<Item = Row>, axes: usize, has_servo: bool) -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    let columns = |stem: &str| -> String {
        AXES[..axes].iter().map(|axis| format!(",{stem}{axis}")).collect()
    };
    let (points, intervals) = (columns(""), columns("interval_"));
    let errors = if has_servo { columns("error_") } else { String::new() };
    writeln!(out, "time,line{points},speed,acceleration,jerk{intervals}{errors}")?;
    for row in rows {
        let Row { time, line, speed, acceleration, jerk, .. } = row;
        write!(out, "{time:.9},{line}")?;
        for c in &row.point[..axes] {
            write!(out, ",{c:.6}")?;
        }
        write!(out, ",{speed:.6},{acceleration:.3},{jerk:.3}")?;
        for interval in &row.intervals[..axes] {
            match interval {
                Some(seconds) => write!(out, ",{seconds:.9}")?,
                None => write!(out, ",")?,
            }
        }
        for axis in (0..axes).filter(|_| has_servo) {
            match row.following_errors {
                Some(errors) => write!(out, ",{:.9}", errors[axis])?,
                None => write!(out, ",")?,
            }
        }
        writeln!(out)?;
    }
    out.flush()
}
