//! `onepulse pulses`: the pulses of one curve as CSV, or drawn.

use crate::args::PulsesArguments;
use crate::choice::Method;
use crate::compare::{Picture, Truth};
use crate::curve::Curve;
use crate::failure::Failure;
use crate::machine::{Refusal, Visitor, with_machines};
use clap::ValueEnum;
use onepulse_core::Pulse;
use onepulse_hwmodel::Circuit;
use std::io::{self, BufWriter, Write};

/// The letters of the axes.
pub(crate) const AXES: [&str; 4] = ["x", "y", "z", "a"];

/// How pulses are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Comma-separated values, a row for each cycle with a pulse
    #[default]
    Csv,
    /// The path over the true curve
    Svg,
}

pub(crate) fn pulses(arguments: &PulsesArguments) -> Result<(), Failure> {
    let PulsesArguments { curve: arguments, format } = arguments;
    let method = Method::from_options(&arguments.options).map_err(Failure::Usage)?;
    let curve = arguments.curve();
    let bits = arguments.options.bits;
    match format {
        Format::Csv => {
            let end = curve.end();
            with_machines(&curve, &method, bits, ToStdout { end }).map_err(Refusal::usage)?
        }
        Format::Svg => io::stdout().lock().write_all(drawn(&curve, &method, bits)?.as_bytes()),
    }
    .map_err(|error| Failure::stdout(&error))
}

/// The picture of a short plane curve.
fn drawn(curve: &Curve, method: &Method, bits: Option<u32>) -> Result<String, Failure> {
    let mut picture = Picture::new("--format svg", curve, &Truth::new(curve))?;
    let path = Path(picture.begin_path(method.name().to_owned()));
    with_machines(curve, method, bits, path).map_err(Refusal::usage)?;
    Ok(picture.svg())
}

/// Takes the points of a path in a plane, of which the start is there.
struct Path<'a>(&'a mut Vec<[i64; 2]>);

impl Visitor for Path<'_> {
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
        let mut at = start;
        for pulse in software.filter(|pulse| !pulse.is_none()) {
            for axis in 0..N {
                at[axis] += i64::from(pulse.0[axis]);
            }
            self.0.push([at[0], at[1]]);
        }
    }
}

struct ToStdout {
    end: Vec<i64>,
}

impl Visitor for ToStdout {
    type Output = io::Result<()>;

    fn visit<S, C, const N: usize>(
        self,
        software: S,
        _: impl FnOnce() -> Result<C, Refusal>,
        start: [i64; N],
    ) -> io::Result<()>
    where
        S: Iterator<Item = Pulse<N>>,
        C: Circuit<N>,
    {
        let mut out = BufWriter::with_capacity(1 << 16, io::stdout().lock());
        let deltas = AXES[..N].iter().map(|axis| format!(",d{axis}"));
        let axes = AXES[..N].iter().map(|axis| format!(",{axis}"));
        writeln!(out, "cycle{}", deltas.chain(axes).collect::<String>())?;
        let mut position = start;
        for (cycle, pulse) in (1_u64..).zip(software) {
            if !pulse.is_none() {
                for axis in 0..N {
                    position[axis] += i64::from(pulse.0[axis]);
                }
                write_row(&mut out, cycle, pulse, position)?;
            }
        }
        out.flush()?;
        say_residual(&self.end, &position);
        Ok(())
    }
}

/// Says on standard error how far a path that has ended is from its end point, if it is: the
/// end rule of the larger axis may leave the other one short.
pub(crate) fn say_residual(end: &[i64], position: &[i64]) {
    let short: Vec<_> = end.iter().zip(position).map(|(e, p)| (e - p).to_string()).collect();
    if end != position {
        eprintln!("note: not exact: the end point is {} pulses further", short.join(","));
    }
}

/// A row of a pulse file: the cycle, the pulse of each axis, the position after them.
pub(crate) fn write_row<const N: usize>(
    out: &mut impl Write,
    cycle: u64,
    Pulse(pulse): Pulse<N>,
    position: [i64; N],
) -> io::Result<()> {
    let mut digits = itoa::Buffer::new();
    out.write_all(digits.format(cycle).as_bytes())?;
    for number in pulse.map(i64::from).into_iter().chain(position) {
        out.write_all(b",")?;
        out.write_all(digits.format(number).as_bytes())?;
    }
    out.write_all(b"\n")
}
