//! `onepulse compare`: every method that serves a curve, side by side.

mod measure;
mod picture;
mod report;
mod truth;
mod variants;

use crate::args::CompareArguments;
use crate::curve::Curve;
use crate::failure::Failure;
use crate::machine::{Refusal, with_machines};
use crate::output::write_whole;
use clap::ValueEnum;
use measure::Measure;
use onepulse_core::Error;
use variants::Variant;

pub(crate) use picture::Picture;
pub(crate) use truth::Truth;

/// How a comparison is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Aligned columns
    #[default]
    Text,
    /// Comma-separated values
    Csv,
    /// One object, with a list of methods
    Json,
}

pub(crate) fn compare(arguments: &CompareArguments) -> Result<(), Failure> {
    let curve = arguments.curve.curve();
    if matches!(curve, Curve::Helix { .. }) {
        let why = "helices have one method, ppc: there is nothing to compare it with";
        return Err(Failure::Usage(why.into()));
    }
    let truth = Truth::new(&curve);
    let mut picture = match arguments.picture {
        Some(_) => Some(Picture::new("--picture", &curve, &truth)?),
        None => None,
    };
    let mut rows = Vec::new();
    for variant in variants::of(&curve) {
        let path = picture.as_mut().map(|picture| picture.begin_path(variant.title()));
        let measure = Measure { truth: truth.clone(), end: curve.end(), variant: &variant, path };
        match with_machines(&curve, &variant.method, arguments.bits, measure) {
            Ok(measured) => rows.push((variant, measured)),
            // The method has no such curve.
            Err(Refusal::Method(_)) => {}
            Err(why) => return Err(refused(why, &variant)),
        }
    }
    // Before the table: what cannot be written is said before anything is.
    if let (Some(picture), Some(path)) = (picture, &arguments.picture) {
        write_whole(path, &picture.svg())?.finish()?;
    }
    report::print(&curve, &truth, &rows, arguments.format)
}

/// A variant that its registers do not serve is named; a curve that is none is not its fault.
fn refused(why: Refusal, variant: &Variant) -> Failure {
    let is_of_registers = matches!(
        why,
        Refusal::Machine(Error::RegisterWidth { .. } | Error::RegisterTooNarrow { .. })
    );
    match why.usage() {
        Failure::Usage(text) if is_of_registers => {
            Failure::Usage(format!("{text} (for {})", variant.title()))
        }
        failure => failure,
    }
}
