//! The ports of each module, and the command that it is benchmarked with.

use super::{Registers, Twin};
use crate::{LINE, RADIUS};
use onepulse_core::dda::{self as software, Preset, Radix, Register};
use onepulse_core::{Direction, Error};
use onepulse_hwmodel::dda;

/// The width of the registers.
const BITS: u32 = 24;

const CIRCLE: ([i32; 2], [i32; 2], Direction) = ([RADIUS, 0], [RADIUS, 0], Direction::Ccw);

/// A long line.
///
/// # Errors
/// None: the line fits.
pub fn dda_line() -> Result<(dda::Line<2>, Twin), Error> {
    let circuit = dda::Line::new(LINE, BITS, Preset::Half, true)?;
    let registers = Registers::of(&circuit);
    let loaded = |name| registers.loaded(name);
    let twin = Twin {
        module: "dda_line",
        parameters: vec![("N", BITS.into()), ("AXES", 2)],
        axes: 2,
        command: vec![
            ("i_jv", loaded("jvy") << BITS | loaded("jvx")),
            ("i_preset", loaded("jrx")),
            ("i_je", loaded("je")),
            ("i_negative", 0),
        ],
        shown: vec![("o_jv", &["jvy", "jvx"]), ("o_jr", &["jry", "jrx"]), ("o_je", &["je"])],
        registers,
    };
    Ok((circuit, twin))
}

/// A full circle by the textbook's circuit.
///
/// # Errors
/// None: the circle fits.
pub fn dda_arc() -> Result<(dda::Arc, Twin), Error> {
    let (start, end, direction) = CIRCLE;
    let preset = Preset::Half;
    let circuit = dda::Arc::new(start, end, direction, BITS, preset, true)?;
    let register = Register::new(Radix::Binary, BITS)?;
    let shift = software::Arc::new(start, end, direction, register, preset, true)?.shift();
    let registers = Registers::of(&circuit);
    let loaded = |name| registers.loaded(name);
    let mut command = vec![
        ("i_jvx", loaded("jvx")),
        ("i_jvy", loaded("jvy")),
        ("i_preset", loaded("jrx")),
        ("i_unit", 1 << shift),
    ];
    command.extend(sweep_command(&registers, direction));
    let mut shown: Vec<(_, &[_])> =
        vec![("o_jvx", &["jvx"]), ("o_jvy", &["jvy"]), ("o_jrx", &["jrx"]), ("o_jry", &["jry"])];
    shown.extend(SWEEP);
    let parameters = vec![("N", BITS.into())];
    Ok((circuit, Twin { module: "dda_arc", parameters, axes: 2, command, shown, registers }))
}

/// A full circle by the centred circuit.
///
/// # Errors
/// None: the circle fits.
pub fn dda_centred_arc() -> Result<(dda::CentredArc, Twin), Error> {
    let (start, end, direction) = CIRCLE;
    let circuit = dda::CentredArc::new(start, end, direction, BITS, true)?;
    let register = Register::new(Radix::Binary, BITS)?;
    let shift = software::CentredArc::new(start, end, direction, register, true)?.shift();
    let registers = Registers::of(&circuit);
    let loaded = |name| registers.loaded(name);
    let mut command = vec![
        ("i_x", loaded("x")),
        ("i_y", loaded("y")),
        ("i_jrx", loaded("jrx")),
        ("i_jry", loaded("jry")),
        ("i_unit", 1 << shift),
    ];
    command.extend(sweep_command(&registers, direction));
    let mut shown: Vec<(_, &[_])> =
        vec![("o_x", &["x"]), ("o_y", &["y"]), ("o_jrx", &["jrx"]), ("o_jry", &["jry"])];
    shown.extend(SWEEP);
    let parameters = vec![("N", BITS.into())];
    Ok((
        circuit,
        Twin { module: "dda_centred_arc", parameters, axes: 2, command, shown, registers },
    ))
}

/// The registers of the sweep control that arcs contain.
const SWEEP: [(&str, &[&str]); 4] = [
    ("o_quadrant", &["quadrant"]),
    ("o_crossings", &["crossings"]),
    ("o_jex", &["jex"]),
    ("o_jey", &["jey"]),
];

/// The sweep's part of an arc's command.
fn sweep_command(registers: &Registers, direction: Direction) -> [(&'static str, u64); 5] {
    [
        ("i_quadrant", registers.loaded("quadrant")),
        ("i_crossings", registers.loaded("crossings")),
        ("i_cw", u64::from(direction == Direction::Cw)),
        ("i_jex", registers.loaded("jex")),
        ("i_jey", registers.loaded("jey")),
    ]
}
