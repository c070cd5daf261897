//! `onepulse feed-rate`: how fast the methods go at one frequency of the pulse source.

mod plot;

use crate::failure::Failure;
use crate::plots::Format;
use clap::{Args, ValueEnum};
use onepulse_core::dda::{self, Preset, Radix, Register};
use onepulse_core::{EndRule, Error, comparison, minimum_deviation, ppc, vector};
use std::f64::consts::SQRT_2;
use std::fmt::Write as _;
use std::io::{self, Write as _};

/// What the speed is shown over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Over {
    /// The direction of a line, 0 to 90 degrees: methods that feed on every cycle
    Direction,
    /// The length of a line, along an axis: digital integration, as it is and normalized
    Length,
}

#[derive(Debug, Args)]
pub(crate) struct FeedRateArguments {
    /// What v/v_max is shown over
    #[arg(value_enum)]
    over: Over,
    /// Register width of digital integration
    #[arg(long, value_name = "N", default_value_t = 8, allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(1..=12))]
    bits: u32,
    /// How to write it
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// v/v_max of several methods over one quantity.
///
/// v is the distance from start to end over the cycles of the whole line, in pulses, and v_max the
/// largest that the method comes to.
struct Curves {
    title: &'static str,
    over: &'static str,
    names: Vec<&'static str>,
    /// The quantity, and a ratio for each name.
    rows: Vec<(f64, Vec<f64>)>,
}

pub(crate) fn feed_rate(arguments: &FeedRateArguments) -> Result<(), Failure> {
    let curves = match arguments.over {
        Over::Direction => over_direction(),
        Over::Length => over_length(arguments.bits),
    };
    let curves = curves.map_err(|error| Failure::Usage(error.to_string()))?;
    let text = match arguments.format {
        Format::Csv => csv(&curves),
        Format::Svg => plot::svg(&curves)?,
    };
    let written = io::stdout().lock().write_all(text.as_bytes());
    written.map_err(|error| Failure::stdout(&error))
}

/// Lines of this length point in every direction with enough precision for four digits.
const LENGTH: f64 = 50_000.0;

fn over_direction() -> Result<Curves, Error> {
    let mut rows = Vec::new();
    for degrees in 0..=90 {
        let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
        let end = [LENGTH * cos, LENGTH * sin].map(|c| c.round() as i32);
        let length = f64::from(end[0]).hypot(end[1].into());
        let speed = |cycles: usize| length / cycles as f64;
        rows.push((
            f64::from(degrees),
            vec![
                speed(ppc::Line::new(end, EndRule::Total)?.count()),
                speed(comparison::Line::new(end)?.count()) / SQRT_2,
                speed(minimum_deviation::Line::new(end)?.count()) / SQRT_2,
                speed(vector::Line::new(end)?.count()) / SQRT_2,
            ],
        ));
    }
    Ok(Curves {
        title: "Feed rate over the direction of a line",
        over: "degrees",
        names: vec!["ppc", "compare-integral", "min-deviation", "vector"],
        rows,
    })
}

fn over_length(bits: u32) -> Result<Curves, Error> {
    let register = Register::new(Radix::Binary, bits)?;
    let mut rows = Vec::new();
    for length in 1..1 << bits {
        let mut ratios = Vec::new();
        for normalize in [false, true] {
            let line = dda::Line::new([length, 0], register, Preset::Zero, normalize)?;
            // A pulse on every cycle is what the longest line comes near to.
            ratios.push(f64::from(length) / line.remaining() as f64);
        }
        rows.push((f64::from(length), ratios));
    }
    Ok(Curves {
        title: "Feed rate over the length of a line",
        over: "length",
        names: vec!["dda", "dda-normalized"],
        rows,
    })
}

fn csv(curves: &Curves) -> String {
    let mut text = format!("{},{}\n", curves.over, curves.names.join(","));
    for (quantity, ratios) in &curves.rows {
        let ratios: Vec<_> = ratios.iter().map(|ratio| format!("{ratio:.4}")).collect();
        // Writing to a string does not fail.
        let _ = writeln!(text, "{quantity},{}", ratios.join(","));
    }
    text
}
