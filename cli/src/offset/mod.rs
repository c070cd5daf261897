//! `onepulse offset`: the path of the cutter's centre.

mod csv;
mod ngc;
mod picture;

use crate::args::OffsetArguments;
use crate::failure::Failure;
use crate::machine_file::MachineFile;
use clap::ValueEnum;
use onepulse_plan::centre_path::{PathError, Step};
use std::fs::File;
use std::io::{self, BufReader, Write};

/// How the path is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Comma separated values
    #[default]
    Csv,
    /// A G-code program that needs no compensation
    Ngc,
    /// A picture: the part, the path, what the cutter sweeps; and of a contour that it would cut
    /// into, where
    Svg,
}

pub(crate) fn offset(arguments: &OffsetArguments) -> Result<(), Failure> {
    let machine = MachineFile::read(arguments.config.as_deref())?;
    let machine = machine.machine(arguments.pulse_mm.as_deref())?;
    let cutters = arguments.cutters.load()?;
    let input = File::open(&arguments.program);
    let input = input.map_err(|error| Failure::file(&arguments.program, &error))?;
    // All of it first: nothing is written of a program that is wrong.
    let steps: Result<Vec<Step>, PathError> =
        cutters.path(BufReader::new(input), &machine).collect();
    let (text, failure) = match steps {
        Ok(steps) => {
            let text = match arguments.format {
                Format::Csv => csv::csv(&steps),
                Format::Ngc => ngc::ngc(&steps),
                Format::Svg => picture::path(&steps),
            };
            (text, None)
        }
        Err(error) => {
            let text = match &error {
                PathError::Program { gouges, .. } if arguments.format == Format::Svg => {
                    picture::gouges(gouges)
                }
                _ => String::new(),
            };
            (text, Some(Failure::program(&arguments.program, error)))
        }
    };
    let mut out = io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    match failure {
        Some(failure) => Err(failure),
        None => written.map_err(|error| Failure::stdout(&error)),
    }
}
