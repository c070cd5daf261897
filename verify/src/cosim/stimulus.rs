//! Commands for both: corners and random curves, each as the model's circuit and as the words that
//! load the twin.

use super::reading::Registers;
use fastrand::Rng;
use onepulse_core::dda::{self as software, Preset, Radix, Register};
use onepulse_core::parabola::Shape;
use onepulse_core::{Axis, Direction, EndRule, ppc as software_ppc};
use onepulse_hwmodel::{brm, comparison, dda, minimum_deviation, parabola, ppc};

/// A command.
#[derive(Debug)]
pub(super) struct Command<C> {
    /// For messages.
    pub(super) what: String,
    /// The circuit as it is once loaded.
    pub(super) circuit: C,
    /// The words of the command's ports.
    pub(super) words: Vec<u64>,
}

pub(super) fn dda_line<const AXES: usize>(
    choice: &mut Rng,
    bits: u32,
) -> Option<Command<dda::Line<AXES>>> {
    let end = [0; AXES].map(|_| coordinate(choice, bits));
    let (preset, normalize) = (preset(choice), choice.bool());
    let circuit = dda::Line::new(end, bits, preset, normalize).ok()?;
    let registers = Registers::of(&circuit);
    let jv = &["jvx", "jvy", "jvz", "jva"][..AXES];
    let mut words: Vec<_> = jv.iter().map(|jv| registers.get(jv)).collect();
    words.extend([registers.get("jrx"), registers.get("je"), signs(end)]);
    Some(Command { what: format!("{end:?} {preset:?} {normalize}"), circuit, words })
}

pub(super) fn brm_line(choice: &mut Rng, bits: u32) -> Option<Command<brm::Line>> {
    let end = [0; 2].map(|_| coordinate(choice, bits));
    let circuit = brm::Line::new(end, bits).ok()?;
    let registers = Registers::of(&circuit);
    let words = vec![registers.get("value_x"), registers.get("value_y"), signs(end)];
    Some(Command { what: format!("{end:?}"), circuit, words })
}

pub(super) fn comparison_line(choice: &mut Rng, bits: u32) -> Option<Command<comparison::Line>> {
    let end = [0; 2].map(|_| coordinate(choice, bits));
    let circuit = comparison::Line::new(end, bits).ok()?;
    let registers = Registers::of(&circuit);
    let mut words = ["end_x", "end_y", "d"].map(|name| registers.get(name)).to_vec();
    words.push(signs(end));
    Some(Command { what: format!("{end:?}"), circuit, words })
}

pub(super) fn comparison_arc(choice: &mut Rng, bits: u32) -> Option<Command<comparison::Arc>> {
    let (start, end, direction) = arc(choice, bits);
    let circuit = comparison::Arc::new(start, end, direction, bits).ok()?;
    let words = walk(&Registers::of(&circuit), direction);
    Some(Command { what: format!("{start:?} {end:?} {direction:?}"), circuit, words })
}

pub(super) fn minimum_deviation_arc(
    choice: &mut Rng,
    bits: u32,
) -> Option<Command<minimum_deviation::Arc>> {
    let (start, end, direction) = arc(choice, bits);
    let circuit = minimum_deviation::Arc::new(start, end, direction, bits).ok()?;
    let words = walk(&Registers::of(&circuit), direction);
    Some(Command { what: format!("{start:?} {end:?} {direction:?}"), circuit, words })
}

pub(super) fn parabola_ppc(choice: &mut Rng, bits: u32) -> Option<Command<parabola::Ppc>> {
    let shape = shape(choice, bits)?;
    let circuit = parabola::Ppc::new(shape, bits).ok()?;
    let registers = Registers::of(&circuit);
    let names = ["p", "je_along", "je_across", "axis_is_y"];
    let mut words = names.map(|name| registers.get(name)).to_vec();
    words.push(signs(shape.end()));
    Some(Command { what: format!("{shape:?}"), circuit, words })
}

/// The command of an arc whose F begins at 0.
fn walk(registers: &Registers, direction: Direction) -> Vec<u64> {
    let mut words = ["cx", "cy"].map(|name| registers.get(name)).to_vec();
    words.extend(sweep(registers, direction));
    words
}

pub(super) fn minimum_deviation_line<const AXES: usize>(
    choice: &mut Rng,
    bits: u32,
) -> Option<Command<minimum_deviation::Line<AXES>>> {
    let end = [0; AXES].map(|_| coordinate(choice, bits));
    let circuit = minimum_deviation::Line::new(end, bits).ok()?;
    let registers = Registers::of(&circuit);
    let mut words = Vec::new();
    for stem in ["end_", "rest_", "d"] {
        let names = ["x", "y", "z", "a"][..AXES].iter().map(|letter| format!("{stem}{letter}"));
        words.extend(names.map(|name| registers.get(&name)));
    }
    words.extend([registers.get("steps"), signs(end)]);
    Some(Command { what: format!("{end:?}"), circuit, words })
}

pub(super) fn ppc_line(choice: &mut Rng, bits: u32) -> Option<Command<ppc::Line>> {
    let end = [0; 2].map(|_| coordinate(choice, bits));
    let rule = rule(choice);
    let larger_is_y = end[0].unsigned_abs() < end[1].unsigned_abs();
    let circuit = ppc::Line::new(end, bits, rule).ok()?;
    let registers = Registers::of(&circuit);
    let mut words = ["end_x", "end_y"].map(|name| registers.get(name)).to_vec();
    words.extend([signs(end), rule as u64, u64::from(larger_is_y), registers.get("e")]);
    Some(Command { what: format!("{end:?} {rule:?}"), circuit, words })
}

pub(super) fn ppc_arc(choice: &mut Rng, bits: u32) -> Option<Command<ppc::Arc>> {
    let (start, end, direction) = arc(choice, bits);
    let rule = rule(choice);
    let [x, y] = software_ppc::Arc::new(start, end, direction, rule).ok()?.pulses_to_go();
    let circuit = ppc::Arc::new(start, end, direction, bits, rule).ok()?;
    let registers = Registers::of(&circuit);
    let mut words = vec![registers.get("cx"), registers.get("cy")];
    words.extend(sweep(&registers, direction));
    words.extend([rule as u64, u64::from(x < y), registers.get("e")]);
    let what = format!("{start:?} {end:?} {direction:?} {rule:?}");
    Some(Command { what, circuit, words })
}

pub(super) fn dda_arc(choice: &mut Rng, bits: u32) -> Option<Command<dda::Arc>> {
    let (start, end, direction) = arc(choice, bits);
    let (preset, normalize) = (preset(choice), choice.bool());
    let width = Register::new(Radix::Binary, bits).ok()?;
    let arc = software::Arc::new(start, end, direction, width, preset, normalize).ok()?;
    let circuit = dda::Arc::new(start, end, direction, bits, preset, normalize).ok()?;
    let registers = Registers::of(&circuit);
    let mut words = ["jvx", "jvy", "jrx"].map(|name| registers.get(name)).to_vec();
    words.push(1 << arc.shift());
    words.extend(sweep(&registers, direction));
    let what = format!("{start:?} {end:?} {direction:?} {preset:?} {normalize}");
    Some(Command { what, circuit, words })
}

pub(super) fn dda_centred_arc(choice: &mut Rng, bits: u32) -> Option<Command<dda::CentredArc>> {
    let (start, end, direction) = arc(choice, bits);
    let normalize = choice.bool();
    let width = Register::new(Radix::Binary, bits).ok()?;
    let arc = software::CentredArc::new(start, end, direction, width, normalize).ok()?;
    let circuit = dda::CentredArc::new(start, end, direction, bits, normalize).ok()?;
    let registers = Registers::of(&circuit);
    let mut words = ["x", "y", "jrx", "jry"].map(|name| registers.get(name)).to_vec();
    words.push(1 << arc.shift());
    words.extend(sweep(&registers, direction));
    Some(Command { what: format!("{start:?} {end:?} {direction:?} {normalize}"), circuit, words })
}

/// The sweep's part of an arc's command.
fn sweep(registers: &Registers, direction: Direction) -> [u64; 5] {
    let cw = u64::from(direction == Direction::Cw);
    [
        registers.get("quadrant"),
        registers.get("crossings"),
        cw,
        registers.get("jex"),
        registers.get("jey"),
    ]
}

fn signs<const AXES: usize>(end: [i32; AXES]) -> u64 {
    (0..AXES).map(|axis| u64::from(end[axis] < 0) << axis).sum()
}

fn preset(choice: &mut Rng) -> Preset {
    [Preset::Zero, Preset::Half, Preset::Full][choice.usize(..3)]
}

fn rule(choice: &mut Rng) -> EndRule {
    [EndRule::Total, EndRule::PerAxis, EndRule::Larger][choice.usize(..3)]
}

/// A coordinate of up to `bits` bits: of any size, the corners more often.
fn coordinate(choice: &mut Rng, bits: u32) -> i32 {
    let bits = bits.min(31);
    let largest = (1_i64 << bits) - 1;
    let magnitude = match choice.u8(..8) {
        0 => 0,
        1 => 1,
        2 => largest,
        3 => 1 << (bits - 1),
        // Every order of magnitude alike.
        _ => choice.i64(0..=largest) >> choice.u32(..bits),
    };
    (if choice.bool() { -magnitude } else { magnitude }) as i32
}

/// A parabola: to an end point on it or near it half of the time, else to any.
fn shape(choice: &mut Rng, bits: u32) -> Option<Shape> {
    let axis = if choice.bool() { Axis::X } else { Axis::Y };
    let across = i64::from(coordinate(choice, bits));
    let parameter = i64::from(coordinate(choice, bits));
    let along = if choice.bool() && parameter != 0 {
        across * across / (2 * parameter.abs()) + choice.i64(-2..=2)
    } else {
        i64::from(coordinate(choice, bits))
    };
    let along = along.abs() * parameter.signum();
    let [along, across, parameter] = [along, across, parameter].map(i32::try_from);
    let end = match axis {
        Axis::X => [along.ok()?, across.ok()?],
        Axis::Y => [across.ok()?, along.ok()?],
    };
    Shape::new(axis, parameter.ok()?, end).ok()
}

/// An arc that circuits of this width serve most of the time: between lattice points of one
/// circle, or ending off it.
fn arc(choice: &mut Rng, bits: u32) -> ([i32; 2], [i32; 2], Direction) {
    let direction = if choice.bool() { Direction::Cw } else { Direction::Ccw };
    let small = choice.u32(2..bits.min(31));
    let start = [0; 2].map(|_| coordinate(choice, small));
    let [x, y] = start;
    let end = match choice.u8(..12) {
        0 => start,
        1 => [-x, -y],
        2 => [y, -x],
        3 => [-y, x],
        4 => [x, -y],
        5 => [y, x],
        6 => [x.saturating_add(choice.i32(-2..=2)), y.saturating_add(choice.i32(-2..=2))],
        7 => [y.saturating_add(choice.i32(-2..=2)), x],
        8 => [-x, y],
        // Off the circle, on an axis: there one axis stands and feeds the other nothing.
        9 => [0, y.saturating_add(choice.i32(-9..=9))],
        10 => [x.saturating_add(choice.i32(-9..=9)), 0],
        _ => [0; 2].map(|_| coordinate(choice, small)),
    };
    (start, end, direction)
}
