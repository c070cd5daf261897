//! `onepulse sample`: the points of one curve by data sampling, as CSV.

use crate::args::SampleArguments;
use crate::curve::Curve;
use crate::failure::Failure;
use clap::ValueEnum;
use onepulse_plan::Length;
use onepulse_plan::sampling::{
    Arc, ArcMethod, Line, SamplingError, chord_error, step, textbook_chord_error,
};
use serde::Deserialize;
use std::io::{self, BufWriter, Write};

/// The methods by their names on the command line and in `machine.toml`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum SamplingName {
    /// Time division, with the direction of 45° in the middle of the step
    #[default]
    #[value(name = "7m")]
    #[serde(rename = "7m")]
    SevenM,
    /// Extended digital integration
    #[value(name = "7360")]
    #[serde(rename = "7360")]
    ExtendedDda,
    /// Along the tangent, closed by the circle's equation
    DirectFunction,
    /// Second order recursion
    SecondOrder,
}

impl SamplingName {
    /// As it is written.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::SevenM => "7m",
            Self::ExtendedDda => "7360",
            Self::DirectFunction => "direct-function",
            Self::SecondOrder => "second-order",
        }
    }
}

impl From<SamplingName> for ArcMethod {
    fn from(name: SamplingName) -> Self {
        match name {
            SamplingName::SevenM => Self::SevenM,
            SamplingName::ExtendedDda => Self::ExtendedDda,
            SamplingName::DirectFunction => Self::DirectFunction,
            SamplingName::SecondOrder => Self::SecondOrder,
        }
    }
}

pub(crate) fn sample(arguments: &SampleArguments) -> Result<(), Failure> {
    let positive = |option: &str, text: &str| -> Result<Length, Failure> {
        let length: Result<Length, _> = text.parse();
        let length =
            length.map_err(|error| Failure::Usage(format!("{option}: '{text}' is {error}")))?;
        match length.picometres() {
            1.. => Ok(length),
            _ => Err(Failure::Usage(format!("{option}: '{text}' is not positive"))),
        }
    };
    let pulse = positive("--pulse-mm", &arguments.pulse_mm)?;
    let feed = positive("--feed", &arguments.feed)?;
    let period = positive("--period", &arguments.period)?.millimetres() / 1000.0;
    let tolerance = arguments.tolerance.as_ref();
    let tolerance = tolerance.map(|text| positive("--tolerance", text)).transpose()?;
    let asked = step(feed, period);
    // Whole pulses, exactly until here.
    let millimetres = |c: i32| {
        let picometres = i128::from(c) * i128::from(pulse.picometres());
        picometres as f64 / Length::MILLIMETRE.picometres() as f64
    };
    let failed = |error: SamplingError| Failure::Usage(error.to_string());
    let written = match arguments.curve() {
        Curve::Line { to } => match to[..] {
            [x, y] => line([x, y].map(millimetres), asked).map_err(failed)?,
            [x, y, z] => line([x, y, z].map(millimetres), asked).map_err(failed)?,
            [x, y, z, a] => line([x, y, z, a].map(millimetres), asked).map_err(failed)?,
            _ => return Err(Failure::Usage("--to: a line has 2 to 4 axes".into())),
        },
        Curve::Arc { from, to, direction } => {
            let [start, end] = [from, to].map(|point| point.map(millimetres));
            let arc = Arc::new(start, end, direction, arguments.method.into(), asked);
            let mut arc = arc.map_err(failed)?;
            if let Some(tolerance) = tolerance {
                arc = arc.within(tolerance.millimetres()).map_err(failed)?;
                if arc.step() < asked {
                    let reduced = feed.millimetres() * arc.step() / asked;
                    eprintln!("note: feed reduced to {reduced:.3} mm/min to keep the tolerance");
                }
            }
            let errors = arguments.errors.then_some((start, arc.radius()));
            write_arc(arc, errors)
        }
        Curve::Parabola { .. } | Curve::Helix { .. } => {
            return Err(Failure::Usage("lines and arcs are sampled".into()));
        }
    };
    written.map_err(|error| Failure::stdout(&error))
}

/// Writes the points of a line.
fn line<const AXES: usize>(end: [f64; AXES], step: f64) -> Result<io::Result<()>, SamplingError> {
    let line = Line::new(end, step)?;
    let written = || {
        let mut out = BufWriter::new(io::stdout().lock());
        writeln!(out, "k,{}", crate::pulses::AXES[..AXES].join(","))?;
        for (k, point) in (1_u64..).zip(line) {
            writeln!(out, "{k},{}", point.map(|c| c.to_string()).join(","))?;
        }
        out.flush()
    };
    Ok(written())
}

/// Writes the points of an arc; from its start and with its radius, their errors too.
fn write_arc(arc: Arc, errors: Option<([f64; 2], f64)>) -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    let columns =
        if errors.is_some() { ",chord_error,textbook_chord_error,radius_error" } else { "" };
    writeln!(out, "k,x,y{columns}")?;
    let mut last = errors.map_or([0.0; 2], |(start, _)| start);
    for (k, [x, y]) in (1_u64..).zip(arc) {
        write!(out, "{k},{x},{y}")?;
        if let Some((_, radius)) = errors {
            let chord = (x - last[0]).hypot(y - last[1]);
            let exact = chord_error(radius, chord);
            let textbook = textbook_chord_error(radius, chord);
            write!(out, ",{exact:e},{textbook:e},{:e}", x.hypot(y) - radius)?;
        }
        writeln!(out)?;
        last = [x, y];
    }
    out.flush()
}
