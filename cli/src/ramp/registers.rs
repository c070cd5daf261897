//! From frequencies to what the registers of a ramp hold.

use super::RampArguments;
use onepulse_core::ramp::Limits;
use std::fmt;

/// The registers of a ramp: as wide as there are, so that the units are as small as can be.
#[derive(Clone, Copy, Debug)]
pub(super) struct Registers {
    pub(super) limits: Limits,
    /// The clocks over which speeds are averaged: 1 where they are not.
    pub(super) window: u32,
    clock: f64,
}

/// Width of the widest phase register.
const WIDEST: u32 = 31;

/// The longest window on offer.
const LONGEST: u32 = 8192;

impl Registers {
    /// Rounds down to units, so that no limit is exceeded.
    pub(super) fn new(arguments: &RampArguments) -> Result<Self, String> {
        let RampArguments { largest, start, acceleration, jerk, clock, .. } = *arguments;
        let given = [
            ("--largest", largest),
            ("--start", start.unwrap_or(1.0)),
            ("--acceleration", acceleration),
            ("--jerk", jerk.unwrap_or(1.0)),
            ("--clock", clock),
        ];
        for (option, value) in given {
            if !(value > 0.0 && value.is_finite()) {
                return Err(format!("{option} {value}: more than zero is needed"));
            }
        }
        let window = jerk.map_or(Ok(1), |jerk| window(acceleration, jerk, clock))?;
        let bits = WIDEST - window.ilog2();
        let unit = 2_f64.powi(bits as i32) / clock;
        let held = |option: &str, units: f64| match units.floor() {
            units if units < 1.0 => Err(format!(
                "{option} is less than {bits} bits hold at this clock: take a slower --clock"
            )),
            units if units >= 2_f64.powi(bits as i32) => {
                Err(format!("{option} is more than a pulse on every clock: take a faster --clock"))
            }
            units => Ok(units as u32),
        };
        let largest = held("--largest", largest * unit)?;
        // An axis that cannot change its speed so fast within its limits need not.
        let acceleration =
            held("--acceleration", (acceleration / clock * unit).min(largest.into()))?;
        let start = match start {
            Some(start) => held("--start", start * unit)?,
            None => acceleration,
        };
        if start > largest {
            return Err("--start is over --largest".into());
        }
        Ok(Self { limits: Limits { bits, start, acceleration, largest }, window, clock })
    }

    /// The pulses a second that a way on one clock makes.
    pub(super) fn frequency(&self, moved: u32) -> f64 {
        let units = f64::from(moved) / f64::from(self.window);
        units * self.clock / 2_f64.powi(self.limits.bits as i32)
    }
}

/// The shortest window that keeps the jerk: it is 2a/W a clock at most.
fn window(acceleration: f64, jerk: f64, clock: f64) -> Result<u32, String> {
    let clocks = 2.0 * acceleration * clock / jerk;
    if clocks > LONGEST.into() {
        let most = 2.0 * acceleration * clock / f64::from(LONGEST);
        return Err(format!(
            "--jerk {jerk} takes a mean over more than {LONGEST} clocks: {most:.0} at least, or a slower --clock"
        ));
    }
    Ok((clocks.ceil() as u32).next_power_of_two().max(2))
}

impl fmt::Display for Registers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Limits { bits, start, acceleration, largest } = self.limits;
        let pulses = |units: u32| self.frequency(units) * f64::from(self.window);
        write!(
            f,
            "{bits} bits: from {:.3} to {:.3} pulses/s by {:.3} pulses/s²",
            pulses(start),
            pulses(largest),
            pulses(acceleration) * self.clock
        )?;
        match self.window {
            1 => Ok(()),
            window => write!(f, ", the mean of {window} clocks"),
        }
    }
}
