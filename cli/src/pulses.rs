//! `onepulse pulses`: the pulses of one curve as CSV.

use crate::args::CurveArguments;
use crate::choice::Method;
use crate::failure::Failure;
use crate::machine::{Refusal, Visitor, with_machines};
use onepulse_core::Pulse;
use onepulse_hwmodel::Circuit;
use std::io::{self, BufWriter, Write};

/// The letters of the axes.
pub(crate) const AXES: [&str; 4] = ["x", "y", "z", "a"];

pub(crate) fn pulses(arguments: &CurveArguments) -> Result<(), Failure> {
    let method = Method::from_options(&arguments.options).map_err(Failure::Usage)?;
    let curve = arguments.curve();
    let end = curve.end();
    with_machines(&curve, &method, arguments.options.bits, ToStdout { end })
        .map_err(Refusal::usage)?
        .map_err(|error| Failure::stdout(&error))
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
