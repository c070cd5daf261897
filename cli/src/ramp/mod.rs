//! `onepulse ramp`: the pulses of one axis that starts and stops by itself.

mod registers;

use crate::failure::Failure;
use crate::plots::{self, Format, Plot};
use clap::Args;
use onepulse_core::Error;
use onepulse_core::ramp::{SCurve, Trapezoid};
use registers::Registers;
use std::io::{self, BufWriter, Write};

#[derive(Debug, Args)]
pub(crate) struct RampArguments {
    /// How many pulses
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pulses: u32,
    /// The frequency that the axis never exceeds, in pulses a second
    #[arg(long, value_name = "HZ", default_value_t = 20_000.0, allow_negative_numbers = true)]
    largest: f64,
    /// The frequency that it starts with and stops from at once, in pulses a second [default: what one
    /// clock's acceleration makes]
    #[arg(long, value_name = "HZ", conflicts_with = "jerk", allow_negative_numbers = true)]
    start: Option<f64>,
    /// By how much the frequency changes in a second
    #[arg(
        long,
        value_name = "HZ_PER_S",
        default_value_t = 100_000.0,
        allow_negative_numbers = true
    )]
    acceleration: f64,
    /// By how much the acceleration changes in a second: an S-curve [default: it jumps]
    #[arg(long, value_name = "HZ_PER_S2", allow_negative_numbers = true)]
    jerk: Option<f64>,
    /// The clock of the registers, in hertz
    #[arg(long, value_name = "HZ", default_value_t = 100_000.0, allow_negative_numbers = true)]
    clock: f64,
    /// How to write it
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// A clock with a pulse.
#[derive(Clone, Copy, Debug)]
struct Sent {
    /// From 1.
    clock: u64,
    /// What the axis moved on it, in pulses a second.
    speed: f64,
}

pub(crate) fn ramp(arguments: &RampArguments) -> Result<(), Failure> {
    let registers = Registers::new(arguments).map_err(Failure::Usage)?;
    eprintln!("note: {registers}");
    let refused = |error: Error| Failure::Usage(error.to_string());
    macro_rules! s_curve {
        ($($window:literal)*) => {
            match registers.window {
                1 => {
                    let ramp = Trapezoid::new(arguments.pulses, registers.limits).map_err(refused)?;
                    // Its speed is 0 again after the last clock.
                    let step = |ramp: &mut Trapezoid| {
                        let left = ramp.left();
                        Some((ramp.step()?, (left - ramp.left()) as u32))
                    };
                    write(sent(ramp, step, &registers), arguments)
                }
                $($window => {
                    let ramp = SCurve::<$window>::new(arguments.pulses, registers.limits);
                    let step = |ramp: &mut SCurve<$window>| Some((ramp.step()?, ramp.moved()));
                    write(sent(ramp.map_err(refused)?, step, &registers), arguments)
                })*
                _ => Err(Failure::Usage("--jerk: the window is too long".into())),
            }
        };
    }
    s_curve!(2 4 8 16 32 64 128 256 512 1024 2048 4096 8192)
}

/// The clocks of a ramp that have a pulse.
fn sent<R>(
    mut ramp: R,
    mut step: impl FnMut(&mut R) -> Option<(bool, u32)>,
    registers: &Registers,
) -> impl Iterator<Item = Sent> {
    let clocks = (1..).map_while(move |clock: u64| Some((clock, step(&mut ramp)?)));
    clocks
        .filter(|(_, (is_pulse, _))| *is_pulse)
        .map(|(clock, (_, moved))| Sent { clock, speed: registers.frequency(moved) })
}

fn write(sent: impl Iterator<Item = Sent>, arguments: &RampArguments) -> Result<(), Failure> {
    let clock = arguments.clock;
    let written = match arguments.format {
        Format::Csv => csv(sent, clock),
        Format::Svg => {
            let text = plot(&sent.collect::<Vec<_>>(), clock)?;
            io::stdout().lock().write_all(text.as_bytes())
        }
    };
    written.map_err(|error| Failure::stdout(&error))
}

fn csv(sent: impl Iterator<Item = Sent>, clock: f64) -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    writeln!(out, "pulse,clock,time,interval,speed")?;
    let mut last = None;
    for (pulse, Sent { clock: at, speed }) in (1_u64..).zip(sent) {
        write!(out, "{pulse},{at},{:.9},", at as f64 / clock)?;
        if let Some(last) = last {
            write!(out, "{:.9}", (at - last) as f64 / clock)?;
        }
        writeln!(out, ",{speed:.3}")?;
        last = Some(at);
    }
    out.flush()
}

fn plot(sent: &[Sent], clock: f64) -> Result<String, Failure> {
    let time = |sent: &Sent| sent.clock as f64 / clock;
    let speeds = sent.iter().map(|sent| Some((time(sent), sent.speed))).collect();
    let intervals =
        sent.windows(2).map(|pair| Some((time(&pair[1]), time(&pair[1]) - time(&pair[0]))));
    let plots = [
        Plot { quantity: "speed, pulses/s", curves: vec![("", speeds)] },
        Plot { quantity: "pulse interval, s", curves: vec![("", intervals.collect())] },
    ];
    plots::svg(&plots, "s")
}
