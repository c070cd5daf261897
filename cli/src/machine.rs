//! From a curve and a method to the state machine and the circuit that serve it.

use crate::choice::{Method, UpdateName};
use crate::curve::Curve;
use crate::failure::Failure;
use onepulse_core::dda::{Preset, Radix, Register};
use onepulse_core::parabola::{self, Shape};
use onepulse_core::{Direction, EndRule, Error, Helix, Plane, Pulse, Sweep};
use onepulse_core::{brm, comparison, dda, minimum_deviation, ppc, vector};
use onepulse_hwmodel::trace::Probe;
use onepulse_hwmodel::{self as hw, Circuit};
use onepulse_plan::sampling::SamplingError;
use std::fmt;

/// Why no machine serves a curve.
#[derive(Clone, Debug)]
pub(crate) enum Refusal {
    /// The method does not do that.
    Method(&'static str),
    /// The machine of that method refuses the curve or the registers.
    Machine(Error),
    /// The curve cannot be sampled.
    Sampling(SamplingError),
}

/// The staggered circle with another preset.
pub(crate) const HALF_LOAD_ONLY: Refusal = Refusal::Method(
    "the staggered circuit takes half load only: with full load it starves, with zero it is off \
     centre; leave --preset out, or take --update simultaneous",
);

/// A line of more axes by a method of the plane.
pub(crate) const TWO_AXES_ONLY: Refusal = Refusal::Method(
    "this method serves lines of 2 axes only: use --method ppc, dda, brm or min-deviation",
);

/// More stages than there are.
const TOO_SMOOTH: Refusal = Refusal::Method(
    "--smooth: the multiplier and the dividers behind it have 32 stages at most together",
);

/// An arc by the rate multiplier.
pub(crate) const LINES_ONLY: Refusal =
    Refusal::Method("the rate multiplier serves lines only: use another --method");

/// What only the software does.
pub(crate) const SOFTWARE_ONLY: Refusal = Refusal::Method(
    "the hardware model has no circuit for this: it has them for --method ppc (lines of 2 \
     axes, arcs, parabolas), compare-integral (lines of 2 axes, arcs), dda and min-deviation (lines, arcs) and brm (lines, without --smooth); \
     pulses, table and compare need none",
);

/// A method of which the whole interpolator has no engine.
pub(crate) const NO_ENGINE: Refusal = Refusal::Method(
    "the whole interpolator has no engine for this: it has them for --method ppc (lines of 2 axes, \
     arcs), dda (lines, arcs) and brm (lines, without --smooth); leave --interpolator out",
);

/// A parabola by a method that has none.
pub(crate) const NO_PARABOLA: Refusal =
    Refusal::Method("parabolas are served by --method ppc, dda and min-deviation only");

/// Where every counter counts to the end, and no other rule is known.
const NO_LARGER: Refusal = Refusal::Method(
    "--end-rule larger is for lines of 2 axes and arcs: this curve always ends exactly",
);

impl Refusal {
    /// As an error of a command line that gave the curve.
    pub(crate) fn usage(self) -> Failure {
        let option = match &self {
            Self::Machine(Error::RegisterWidth { .. } | Error::RegisterTooNarrow { .. }) => {
                "--bits: "
            }
            Self::Machine(Error::StartInCentre | Error::CircleTooLarge { .. }) => "--from: ",
            Self::Machine(Error::EndInCentre | Error::EndBehindVertex { .. }) => "--to: ",
            Self::Machine(Error::NoParameter) => "--p: ",
            _ => "",
        };
        Failure::Usage(format!("{option}{self}"))
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Method(why) => f.write_str(why),
            Self::Machine(why) => why.fmt(f),
            Self::Sampling(why) => why.fmt(f),
        }
    }
}

impl From<Error> for Refusal {
    fn from(why: Error) -> Self {
        Self::Machine(why)
    }
}

impl From<SamplingError> for Refusal {
    fn from(why: SamplingError) -> Self {
        Self::Sampling(why)
    }
}

/// Something to be done with the two machines of a curve.
pub(crate) trait Visitor {
    type Output;

    /// Takes the software machine, the circuit's maker, and where the curve starts.
    fn visit<S, C, const AXES: usize>(
        self,
        software: S,
        circuit: impl FnOnce() -> Result<C, Refusal>,
        start: [i64; AXES],
    ) -> Self::Output
    where
        S: Iterator<Item = Pulse<AXES>>,
        C: Circuit<AXES>;
}

/// The circuit of a method that has none: there is no value of it.
enum NoCircuit {}

/// The maker of the circuit that there is not.
fn no_circuit() -> Result<NoCircuit, Refusal> {
    Err(SOFTWARE_ONLY)
}

impl<const AXES: usize> Circuit<AXES> for NoCircuit {
    const CLOCKS_PER_CYCLE: u64 = 1;
    const NAME: &'static str = "none";

    fn pulses(&self) -> Pulse<AXES> {
        match *self {}
    }

    fn done(&self) -> bool {
        match *self {}
    }

    fn clock(&mut self) -> Pulse<AXES> {
        match *self {}
    }

    fn probe(&self, _: &mut impl Probe) {
        match *self {}
    }
}

/// Builds the machines of a curve, in registers of `bits` bits or the smallest that serve, and
/// shows them to the visitor.
pub(crate) fn with_machines<V: Visitor>(
    curve: &Curve,
    method: &Method,
    bits: Option<u32>,
    visitor: V,
) -> Result<V::Output, Refusal> {
    match curve {
        Curve::Line { to } => match *to.as_slice() {
            [x, y] => plane_line([x, y], method, bits, visitor),
            [x, y, z] => line([x, y, z], method, bits, visitor),
            [x, y, z, a] => line([x, y, z, a], method, bits, visitor),
            _ => Err(Refusal::Method("a line has 2 to 4 axes")),
        },
        &Curve::Arc { from, to, direction } => arc(from, to, direction, method, bits, visitor),
        &Curve::Parabola { axis, parameter, to } => {
            let needed = holding(Radix::Binary, &[to[0], to[1], parameter]);
            parabola(Shape::new(axis, parameter, to)?, needed, method, bits, visitor)
        }
        &Curve::Helix { plane, from, to, direction, rise } => {
            helix(plane, [from, to], direction, rise, method, bits, visitor)
        }
    }
}

/// A line of two axes: some methods have no other.
fn plane_line<V: Visitor>(
    to: [i32; 2],
    method: &Method,
    bits: Option<u32>,
    visitor: V,
) -> Result<V::Output, Refusal> {
    let needed = holding(Radix::Binary, &to);
    let start = [0; 2];
    match *method {
        Method::Ppc { end_rule } => {
            let bits = width(bits, 32, needed)?;
            let software = ppc::Line::new(to, end_rule)?;
            let circuit = || Ok(hw::ppc::Line::new(to, bits, end_rule)?);
            Ok(visitor.visit(software, circuit, start))
        }
        Method::Vector => {
            width(bits, 32, needed)?;
            Ok(visitor.visit(vector::Line::new(to)?, no_circuit, start))
        }
        Method::CompareIntegral => {
            let bits = width(bits, 32, needed)?;
            let circuit = || Ok(hw::comparison::Line::new(to, bits)?);
            Ok(visitor.visit(comparison::Line::new(to)?, circuit, start))
        }
        Method::Dda { .. } | Method::Brm { .. } | Method::MinDeviation => {
            line(to, method, bits, visitor)
        }
    }
}

/// A line of any number of axes.
fn line<V: Visitor, const AXES: usize>(
    to: [i32; AXES],
    method: &Method,
    bits: Option<u32>,
    visitor: V,
) -> Result<V::Output, Refusal> {
    let start = [0; AXES];
    match *method {
        Method::Dda { radix, preset, normalize, .. } => {
            let digits = bits.unwrap_or_else(|| holding(radix, &to));
            let register = Register::new(radix, digits)?;
            let preset = preset.unwrap_or_default();
            let software = dda::Line::new(to, register, preset, normalize)?;
            let circuit = || Ok(hw::dda::Line::new(to, digits, preset, normalize)?);
            Ok(visitor.visit(software, circuit, start))
        }
        Method::Brm { smoothing } => {
            let bits = bits.unwrap_or_else(|| holding(Radix::Binary, &to));
            let software = brm::Line::new(to, bits)?;
            if smoothing == 0 {
                return Ok(visitor.visit(software, || Ok(hw::brm::Line::new(to, bits)?), start));
            }
            // The width itself is right: it is the sum of the two that is too much.
            let software = brm::Smoothed::new(to, bits, smoothing).map_err(|_| TOO_SMOOTH)?;
            Ok(visitor.visit(software, no_circuit, start))
        }
        Method::Ppc { end_rule } => {
            if end_rule == EndRule::Larger {
                return Err(NO_LARGER);
            }
            width(bits, 32, holding(Radix::Binary, &to))?;
            Ok(visitor.visit(ppc::SpaceLine::new(to)?, no_circuit, start))
        }
        Method::MinDeviation => {
            let bits = width(bits, 32, holding(Radix::Binary, &to))?;
            let circuit = || Ok(hw::minimum_deviation::Line::new(to, bits)?);
            Ok(visitor.visit(minimum_deviation::Line::new(to)?, circuit, start))
        }
        Method::Vector | Method::CompareIntegral => Err(TWO_AXES_ONLY),
    }
}

fn arc<V: Visitor>(
    from: [i32; 2],
    to: [i32; 2],
    direction: Direction,
    method: &Method,
    bits: Option<u32>,
    visitor: V,
) -> Result<V::Output, Refusal> {
    let start = from.map(i64::from);
    match *method {
        Method::Ppc { end_rule } => {
            let needed = hw::ppc::Arc::bits(from, to, direction)?;
            let bits = width(bits, 32, needed)?;
            let software = ppc::Arc::new(from, to, direction, end_rule)?;
            let circuit = || Ok(hw::ppc::Arc::new(from, to, direction, bits, end_rule)?);
            Ok(visitor.visit(software, circuit, start))
        }
        Method::Dda { radix, preset, normalize, update: UpdateName::Simultaneous } => {
            let needed = dda::Arc::bits(from, to, direction)?;
            let bits = bits.unwrap_or(needed);
            let register = Register::new(radix, bits)?;
            let preset = preset.unwrap_or_default();
            let software = dda::Arc::new(from, to, direction, register, preset, normalize);
            let circuit = || Ok(hw::dda::Arc::new(from, to, direction, bits, preset, normalize)?);
            Ok(visitor.visit(software?, circuit, start))
        }
        Method::Dda { radix, preset, normalize, update: UpdateName::Staggered } => {
            if !matches!(preset, None | Some(Preset::Half)) {
                return Err(HALF_LOAD_ONLY);
            }
            let needed = dda::CentredArc::bits(from, to, direction)?;
            let bits = bits.unwrap_or(needed);
            let register = Register::new(radix, bits)?;
            let software = dda::CentredArc::new(from, to, direction, register, normalize);
            let circuit = || Ok(hw::dda::CentredArc::new(from, to, direction, bits, normalize)?);
            Ok(visitor.visit(software?, circuit, start))
        }
        Method::MinDeviation => {
            let bits = width(bits, 32, hw::minimum_deviation::Arc::bits(from, to, direction)?)?;
            let software = minimum_deviation::Arc::new(from, to, direction)?;
            let circuit = || Ok(hw::minimum_deviation::Arc::new(from, to, direction, bits)?);
            Ok(visitor.visit(software, circuit, start))
        }
        Method::Vector => {
            width(bits, 32, holding_arc(from, to, direction)?)?;
            Ok(visitor.visit(vector::Arc::new(from, to, direction)?, no_circuit, start))
        }
        Method::CompareIntegral => {
            let bits = width(bits, 32, hw::comparison::Arc::bits(from, to, direction)?)?;
            let software = comparison::Arc::new(from, to, direction)?;
            let circuit = || Ok(hw::comparison::Arc::new(from, to, direction, bits)?);
            Ok(visitor.visit(software, circuit, start))
        }
        Method::Brm { .. } => Err(LINES_ONLY),
    }
}

fn parabola<V: Visitor>(
    shape: Shape,
    needed: u32,
    method: &Method,
    bits: Option<u32>,
    visitor: V,
) -> Result<V::Output, Refusal> {
    let start = [0; 2];
    match *method {
        Method::Ppc { end_rule: EndRule::Larger } => Err(NO_LARGER),
        Method::Ppc { .. } => {
            let bits = width(bits, 32, needed)?;
            let circuit = || Ok(hw::parabola::Ppc::new(shape, bits)?);
            Ok(visitor.visit(parabola::Ppc::new(shape)?, circuit, start))
        }
        Method::MinDeviation => {
            width(bits, 32, needed)?;
            Ok(visitor.visit(parabola::MinimumDeviation::new(shape)?, no_circuit, start))
        }
        Method::Dda { normalize: true, .. } => {
            Err(Refusal::Method("--normalize is for lines and arcs: leave it out"))
        }
        Method::Dda { radix, preset, .. } => {
            let bits = bits.unwrap_or_else(|| parabola::Dda::bits(&shape));
            let register = Register::new(radix, bits)?;
            let software = parabola::Dda::new(shape, register, preset.unwrap_or_default())?;
            Ok(visitor.visit(software, no_circuit, start))
        }
        Method::Brm { .. } | Method::Vector | Method::CompareIntegral => Err(NO_PARABOLA),
    }
}

fn helix<V: Visitor>(
    plane: Plane,
    [from, to]: [[i32; 2]; 2],
    direction: Direction,
    rise: i32,
    method: &Method,
    bits: Option<u32>,
    visitor: V,
) -> Result<V::Output, Refusal> {
    match method {
        Method::Ppc { end_rule: EndRule::Larger } => Err(NO_LARGER),
        Method::Ppc { .. } => {
            let needed = holding_arc(from, to, direction)?.max(holding(Radix::Binary, &[rise]));
            width(bits, 32, needed)?;
            let software = Helix::new(plane, from, to, direction, rise)?;
            let start = plane.place([from[0], from[1], 0]).map(i64::from);
            Ok(visitor.visit(software, no_circuit, start))
        }
        _ => Err(Refusal::Method("helices are served by --method ppc only")),
    }
}

/// The narrowest register that holds the coordinates of an arc and of its end, in bits.
fn holding_arc(from: [i32; 2], to: [i32; 2], direction: Direction) -> Result<u32, Error> {
    let largest = Sweep::new(from, to, direction)?.largest_coordinate();
    // A circle of this crate stays within 32 bits.
    Ok(Register::holding(Radix::Binary, largest as u32).digits())
}

/// The narrowest register that holds the coordinates, in digits.
fn holding(radix: Radix, coordinates: &[i32]) -> u32 {
    let largest = coordinates.iter().map(|c| c.unsigned_abs()).max().unwrap_or(0);
    Register::holding(radix, largest).digits()
}

/// A width that the software machine does not ask for but its circuit has.
fn width(bits: Option<u32>, widest: u32, needed: u32) -> Result<u32, Error> {
    match bits {
        None => Ok(needed),
        Some(digits) if digits == 0 || digits > widest => {
            Err(Error::RegisterWidth { digits, widest })
        }
        Some(digits) if digits < needed => Err(Error::RegisterTooNarrow { digits, needed }),
        Some(bits) => Ok(bits),
    }
}
