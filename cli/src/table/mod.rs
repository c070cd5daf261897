//! `onepulse table`: the step table of one curve as a textbook prints it.

mod arcs;
mod brm;
mod dda;
mod helix;
pub(crate) mod layout;
mod lines;
mod parabola;
mod ppc;
mod steps;

use crate::args::TableArguments;
use crate::choice::{Method, UpdateName};
use crate::curve::Curve;
use crate::failure::Failure;
use crate::machine::{LINES_ONLY, NO_PARABOLA, Refusal, TWO_AXES_ONLY, Visitor, with_machines};
use crate::pulses::say_residual;
use clap::ValueEnum;
use onepulse_core::dda::{Radix, Register};
use onepulse_core::{self as core, Direction, EndRule, Error, Pulse};
use onepulse_hwmodel::Circuit;
use steps::StepTable;

/// How a table is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Aligned columns
    #[default]
    Text,
    /// A Markdown table
    Md,
    /// Comma-separated values
    Csv,
}

/// The language of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Language {
    /// English
    #[default]
    En,
    /// Chinese
    Zh,
}

impl Language {
    /// The word in this language.
    pub(crate) const fn pick(self, english: &'static str, chinese: &'static str) -> &'static str {
        match self {
            Self::En => english,
            Self::Zh => chinese,
        }
    }
}

/// A table that can be gone through more than once, a row at a time.
pub(crate) trait Table {
    /// The column headings.
    fn headings(&self, language: Language) -> Vec<String>;

    /// The rows.
    fn rows(&self, language: Language) -> impl Iterator<Item = Vec<String>>;
}

pub(crate) fn table(arguments: &TableArguments) -> Result<(), Failure> {
    let options = &arguments.curve.options;
    let method = Method::from_options(options).map_err(Failure::Usage)?;
    let curve = arguments.curve.curve();
    // The one place that knows what suits together says what does not, and where it ends: only the
    // rule of the larger axis need be run to know.
    let may_be_short = matches!(method, Method::Ppc { end_rule: EndRule::Larger });
    let ending = Ending { end: may_be_short.then(|| curve.end()) };
    with_machines(&curve, &method, options.bits, ending).map_err(Refusal::usage)?;
    let write = |why: Error| Refusal::from(why).usage();
    match (method, &curve) {
        (Method::Ppc { end_rule }, Curve::Line { to }) if to.len() == 2 => {
            let machine = core::ppc::Line::new([to[0], to[1]], end_rule).map_err(write)?;
            print(&ppc::LineTable { machine, end: [to[0], to[1]] }, arguments)
        }
        (Method::Vector, Curve::Line { to }) => {
            let machine = core::vector::Line::new([to[0], to[1]]).map_err(write)?;
            print(&StepTable { machine }, arguments)
        }
        (Method::CompareIntegral, Curve::Line { to }) => {
            let machine = core::comparison::Line::new([to[0], to[1]]).map_err(write)?;
            print(&StepTable { machine }, arguments)
        }
        (_, Curve::Line { to }) => match *to.as_slice() {
            [x, y] => line([x, y], &method, arguments),
            [x, y, z] => line([x, y, z], &method, arguments),
            [x, y, z, a] => line([x, y, z, a], &method, arguments),
            _ => Err(Failure::Usage("a line has 2 to 4 axes".into())),
        },
        (_, &Curve::Arc { from, to, direction }) => arc(from, to, direction, &method, arguments),
        (_, &Curve::Parabola { axis, parameter, to }) => {
            let shape = core::parabola::Shape::new(axis, parameter, to).map_err(write)?;
            parabola(shape, &method, arguments)
        }
        (_, &Curve::Helix { plane, from, to, direction, rise }) => {
            let machine = core::Helix::new(plane, from, to, direction, rise).map_err(write)?;
            print(&helix::HelixTable { machine }, arguments)
        }
    }
}

/// A line of any number of axes.
fn line<const N: usize>(
    to: [i32; N],
    method: &Method,
    arguments: &TableArguments,
) -> Result<(), Failure> {
    let write = |why: Error| Refusal::from(why).usage();
    let largest = to.iter().map(|c| c.unsigned_abs()).max().unwrap_or(0);
    let bits = arguments.curve.options.bits;
    match *method {
        Method::Dda { radix, preset, normalize, .. } => {
            let digits = bits.unwrap_or_else(|| Register::holding(radix, largest).digits());
            let register = Register::new(radix, digits).map_err(write)?;
            let preset = preset.unwrap_or_default();
            let machine = core::dda::Line::new(to, register, preset, normalize).map_err(write)?;
            print(&dda::LineTable { machine }, arguments)
        }
        Method::Brm { smoothing } => {
            let bits = bits.unwrap_or_else(|| Register::holding(Radix::Binary, largest).digits());
            if smoothing == 0 {
                let machine = core::brm::Line::new(to, bits).map_err(write)?;
                print(&brm::LineTable { machine }, arguments)
            } else {
                let machine = core::brm::Smoothed::new(to, bits, smoothing).map_err(write)?;
                print(&brm::SmoothedTable { machine }, arguments)
            }
        }
        Method::MinDeviation => {
            let machine = core::minimum_deviation::Line::new(to).map_err(write)?;
            print(&StepTable { machine }, arguments)
        }
        Method::Ppc { .. } => {
            let machine = core::ppc::SpaceLine::new(to).map_err(write)?;
            print(&StepTable { machine }, arguments)
        }
        Method::Vector | Method::CompareIntegral => Err(TWO_AXES_ONLY.usage()),
    }
}

fn arc(
    from: [i32; 2],
    to: [i32; 2],
    direction: Direction,
    method: &Method,
    arguments: &TableArguments,
) -> Result<(), Failure> {
    let write = |why: Error| Refusal::from(why).usage();
    let register = |needed: Result<u32, Error>| {
        let bits = arguments.curve.options.bits.map_or(needed, Ok).map_err(write)?;
        Register::new(Radix::Binary, bits).map_err(write)
    };
    match *method {
        Method::Ppc { end_rule } => {
            let machine = core::ppc::Arc::new(from, to, direction, end_rule).map_err(write)?;
            print(&ppc::ArcTable { machine }, arguments)
        }
        Method::Dda { preset, normalize, update: UpdateName::Simultaneous, .. } => {
            let register = register(core::dda::Arc::bits(from, to, direction))?;
            let preset = preset.unwrap_or_default();
            let machine = core::dda::Arc::new(from, to, direction, register, preset, normalize);
            print(&dda::ArcTable { machine: machine.map_err(write)? }, arguments)
        }
        Method::Dda { normalize, update: UpdateName::Staggered, .. } => {
            let register = register(core::dda::CentredArc::bits(from, to, direction))?;
            let machine = core::dda::CentredArc::new(from, to, direction, register, normalize);
            print(&dda::CentredArcTable { machine: machine.map_err(write)? }, arguments)
        }
        Method::MinDeviation => {
            let machine = core::minimum_deviation::Arc::new(from, to, direction).map_err(write)?;
            print(&StepTable { machine }, arguments)
        }
        Method::Vector => {
            let machine = core::vector::Arc::new(from, to, direction).map_err(write)?;
            print(&StepTable { machine }, arguments)
        }
        Method::CompareIntegral => {
            let machine = core::comparison::Arc::new(from, to, direction).map_err(write)?;
            print(&StepTable { machine }, arguments)
        }
        Method::Brm { .. } => Err(LINES_ONLY.usage()),
    }
}

fn parabola(
    shape: core::parabola::Shape,
    method: &Method,
    arguments: &TableArguments,
) -> Result<(), Failure> {
    let write = |why: Error| Refusal::from(why).usage();
    match *method {
        Method::Ppc { .. } => {
            let machine = core::parabola::Ppc::new(shape).map_err(write)?;
            print(&StepTable { machine }, arguments)
        }
        Method::MinDeviation => {
            let machine = core::parabola::MinimumDeviation::new(shape).map_err(write)?;
            print(&StepTable { machine }, arguments)
        }
        Method::Dda { radix, preset, .. } => {
            let bits = arguments.curve.options.bits;
            let bits = bits.unwrap_or_else(|| core::parabola::Dda::bits(&shape));
            let register = Register::new(radix, bits).map_err(write)?;
            let preset = preset.unwrap_or_default();
            let machine = core::parabola::Dda::new(shape, register, preset).map_err(write)?;
            print(&dda::ParabolaTable { machine }, arguments)
        }
        _ => Err(NO_PARABOLA.usage()),
    }
}

fn print(table: &impl Table, arguments: &TableArguments) -> Result<(), Failure> {
    let written = layout::write(std::io::stdout().lock(), table, arguments.format, arguments.lang);
    written.map_err(|error| Failure::stdout(&error))
}

/// Says what is left short of the end point, if one is given.
struct Ending {
    end: Option<Vec<i64>>,
}

impl Visitor for Ending {
    type Output = ();

    fn visit<S, C, const N: usize>(
        self,
        software: S,
        _: impl FnOnce() -> Result<C, Refusal>,
        start: [i64; N],
    ) where
        S: Iterator<Item = Pulse<N>>,
        C: Circuit<N>,
    {
        let Some(end) = self.end else { return };
        let mut position = start;
        for Pulse(pulse) in software {
            for axis in 0..N {
                position[axis] += i64::from(pulse[axis]);
            }
        }
        say_residual(&end, &position);
    }
}

/// A pulse as it stands in a table: +Δx, −Δy, or nothing.
fn pulse_name(sign: i8, axis: usize) -> String {
    let axis = crate::pulses::AXES[axis];
    match sign {
        1 => format!("+Δ{axis}"),
        -1 => format!("-Δ{axis}"),
        _ => String::new(),
    }
}
