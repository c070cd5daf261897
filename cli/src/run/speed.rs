//! From a feed to the frequency of the pulse source.

use crate::choice::{Method, UpdateName};
use crate::curve::Curve;
use onepulse_core::dda;
use onepulse_core::dda::{CentredArc, Line, Radix, Register};
use onepulse_plan::Length;

/// A speed along the curve on a machine with some pulse equivalent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Speed {
    /// The way of one minute.
    pub(super) per_minute: Length,
    /// The pulse equivalent.
    pub(super) pulse: Length,
}

impl Speed {
    /// In millimetres a minute.
    pub(super) fn millimetres_per_minute(self) -> f64 {
        self.per_minute.millimetres()
    }

    /// In pulse equivalents a second.
    pub(super) fn pulses_per_second(self) -> f64 {
        self.per_minute.picometres() as f64 / self.pulse.picometres() as f64 / 60.0
    }

    /// The frequency f_g of the pulse source at which the curve is made at this speed.
    ///
    /// A digital integrator or rate multiplier of 2ⁿ clocks makes v = 60·δ·(L/2^(n−Q))·f_g, so
    /// f_g can be chosen to give the speed exactly (for an arc, L is R and a clock turns it by
    /// 1/2^(n−Q)). Point-by-point comparison makes v = 60·δ·f_g along an axis and 1/√2 of it
    /// at 45°: its f_g gives the speed along an axis, as the textbooks have it.
    pub(super) fn cycles_per_second(self, curve: &Curve, method: &Method, bits: u32) -> f64 {
        let speed = self.pulses_per_second();
        let accumulations = |shift: u32| 2_f64.powi(bits.saturating_sub(shift) as i32);
        match (method, curve) {
            (Method::Dda { .. } | Method::Brm { .. }, Curve::Line { to }) => {
                let length = to.iter().map(|&c| f64::from(c).powi(2)).sum::<f64>().sqrt();
                speed * accumulations(line_shift(to, method, bits)) / length
            }
            (Method::Dda { .. }, &Curve::Arc { from, .. }) => {
                let radius = f64::from(from[0]).hypot(f64::from(from[1]));
                speed * accumulations(arc_shift(curve, method, bits)) / radius
            }
            // A pulse every cycle.
            _ => speed,
        }
    }
}

/// Q of a line; 0 where the machine will be refused anyway.
fn line_shift(to: &[i32], method: &Method, bits: u32) -> u32 {
    let Method::Dda { normalize, .. } = *method else {
        return 0;
    };
    match *to {
        [x, y] => shift([x, y], normalize, bits),
        [x, y, z] => shift([x, y, z], normalize, bits),
        _ => 0,
    }
}

fn shift<const AXES: usize>(to: [i32; AXES], normalize: bool, bits: u32) -> u32 {
    let register = Register::new(Radix::Binary, bits);
    let line = register.and_then(|r| Line::new(to, r, dda::Preset::Zero, normalize));
    line.map_or(0, |line| line.shift())
}

/// Q of an arc; 0 where the machine will be refused anyway.
fn arc_shift(curve: &Curve, method: &Method, bits: u32) -> u32 {
    let (Method::Dda { normalize, update, .. }, &Curve::Arc { from, to, direction }) =
        (method, curve)
    else {
        return 0;
    };
    let Ok(register) = Register::new(Radix::Binary, bits) else {
        return 0;
    };
    match update {
        UpdateName::Staggered => {
            let arc = CentredArc::new(from, to, direction, register, *normalize);
            arc.map_or(0, |arc| arc.shift())
        }
        UpdateName::Simultaneous => {
            let preset = dda::Preset::Zero;
            let arc = dda::Arc::new(from, to, direction, register, preset, *normalize);
            arc.map_or(0, |arc| arc.shift())
        }
    }
}
