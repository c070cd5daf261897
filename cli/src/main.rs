//! NC interpolation from the command line.

mod action;
mod args;
mod backdrop;
mod choice;
mod compare;
mod contour_error;
mod curve;
mod cutters;
mod failure;
mod feed_rate;
mod interpolator;
mod machine;
mod machine_file;
mod motion_settings;
mod offset;
mod output;
mod plots;
mod profile;
mod pulses;
mod ramp;
mod run;
mod sample;
mod table;
mod wave;

use args::{Arguments, Command};
use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let done = match Arguments::parse().command {
        Command::Pulses(curve) => pulses::pulses(&curve),
        Command::Table(arguments) => table::table(&arguments),
        Command::Compare(arguments) => compare::compare(&arguments),
        Command::Wave(arguments) => wave::wave(&arguments),
        Command::FeedRate(arguments) => feed_rate::feed_rate(&arguments),
        Command::Sample(arguments) => sample::sample(&arguments),
        Command::Profile(arguments) => profile::profile(&arguments),
        Command::Offset(arguments) => offset::offset(&arguments),
        Command::ContourError(arguments) => contour_error::contour_error(&arguments),
        Command::Ramp(arguments) => ramp::ramp(&arguments),
        Command::Run(arguments) => run::run(&arguments),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
