//! `onepulse profile`: the motion of a program over time, which `onepulse run --accelerate` makes too.

mod chain;
mod plot;

use crate::args::ProfileArguments;
use crate::failure::Failure;
use crate::machine_file::MachineFile;
use crate::motion_settings::MotionSettings;
use crate::plots::Format;
use onepulse_plan::Motion;
use onepulse_plan::gcode::Program;
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
    let motions: Result<Vec<Motion>, _> = Program::new(BufReader::new(input), &machine).collect();
    let motions = motions.map_err(|error| Failure::program(&arguments.program, error))?;
    let rows = Rows::new(&motions, &machine, &settings, |_| f64::INFINITY);
    let rows = rows.map_err(|why| Failure::Fault(format!("{name}: {why}")))?;
    match arguments.format {
        Format::Csv => csv(rows, settings.servo.is_some()),
        Format::Svg => {
            let text = svg(&rows.collect::<Vec<_>>())?;
            io::stdout().lock().write_all(text.as_bytes())
        }
    }
    .map_err(|error| Failure::stdout(&error))
}

fn csv(rows: impl Iterator<Item = Row>, has_servo: bool) -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    let more = if has_servo { ",error_x,error_y" } else { "" };
    writeln!(out, "time,line,x,y,speed,acceleration,jerk,interval_x,interval_y{more}")?;
    for row in rows {
        let Row { time, line, point: [x, y], speed, acceleration, jerk, .. } = row;
        write!(out, "{time:.9},{line},{x:.6},{y:.6},{speed:.6},{acceleration:.3},{jerk:.3}")?;
        for interval in row.intervals {
            match interval {
                Some(seconds) => write!(out, ",{seconds:.9}")?,
                None => write!(out, ",")?,
            }
        }
        match row.following_errors {
            Some([x, y]) => write!(out, ",{x:.9},{y:.9}")?,
            None if has_servo => write!(out, ",,")?,
            None => {}
        }
        writeln!(out)?;
    }
    out.flush()
}
