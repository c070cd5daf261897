//! The ports of each module, and the command that it is benchmarked with.

use super::Twin;
use crate::{LINE, RADIUS};
use onepulse_core::dda::Preset;
use onepulse_core::{Direction, EndRule, Error};
use onepulse_hwmodel::{brm, dda, ppc};

/// The width of the registers.
pub(super) const BITS: u32 = 24;

const CIRCLE: ([i32; 2], [i32; 2], Direction) = ([RADIUS, 0], [RADIUS, 0], Direction::Ccw);

/// The ports of the sweep control that arcs contain.
const SWEEP: [&str; 5] = ["quadrant", "crossings", "cw", "jex", "jey"];

/// A long line.
///
/// # Errors
/// None: the line fits.
pub fn dda_line() -> Result<(dda::Line<2>, Twin), Error> {
    let circuit = dda::Line::new(LINE, BITS, Preset::Half, true)?;
    let twin = Twin::of(&circuit)
        .with_axes()
        .without("carry_")
        .with_bus("o_jv", "jv")
        .with_bus("o_jr", "jr")
        .with_bus("o_negative", "negative_")
        .with_input_bus("i_jv", "jv")
        .with_input_bus("i_negative", "negative_")
        .with_inputs(&["je"]);
    let preset = twin.registers.loaded("jrx");
    Ok((circuit, twin.with_input("i_preset", preset)))
}

/// A full circle by the textbook's circuit.
///
/// # Errors
/// None: the circle fits.
pub fn dda_arc() -> Result<(dda::Arc, Twin), Error> {
    let (start, end, direction) = CIRCLE;
    let circuit = dda::Arc::new(start, end, direction, BITS, Preset::Half, true)?;
    let twin = Twin::of(&circuit).with_inputs(&["jvx", "jvy", "unit"]).with_inputs(&SWEEP);
    let preset = twin.registers.loaded("jrx");
    Ok((circuit, twin.with_input("i_preset", preset)))
}

/// A full circle by the centred circuit.
///
/// # Errors
/// None: the circle fits.
pub fn dda_centred_arc() -> Result<(dda::CentredArc, Twin), Error> {
    let (start, end, direction) = CIRCLE;
    let circuit = dda::CentredArc::new(start, end, direction, BITS, true)?;
    let twin = Twin::of(&circuit).with_inputs(&["x", "y", "jrx", "jry", "unit"]);
    Ok((circuit, twin.with_inputs(&SWEEP)))
}

/// A long line by point-by-point comparison, with one counter for both axes.
///
/// # Errors
/// None: the line fits.
pub fn ppc_line() -> Result<(ppc::Line, Twin), Error> {
    let circuit = ppc::Line::new(LINE, BITS, EndRule::Total)?;
    let twin = Twin::of(&circuit)
        .with_bus("o_negative", "negative_")
        .with_input_bus("i_negative", "negative_")
        .with_inputs(&["end_x", "end_y", "rule", "larger_is_y", "e"]);
    Ok((circuit, twin))
}

/// A full circle by point-by-point comparison, with a counter for each axis.
///
/// # Errors
/// None: the circle fits.
pub fn ppc_arc() -> Result<(ppc::Arc, Twin), Error> {
    let (start, end, direction) = CIRCLE;
    let circuit = ppc::Arc::new(start, end, direction, BITS, EndRule::PerAxis)?;
    let twin = Twin::of(&circuit)
        .with_inputs(&["cx", "cy", "rule", "larger_is_y", "e"])
        .with_inputs(&SWEEP);
    Ok((circuit, twin))
}

/// A long line by rate multiplication.
///
/// # Errors
/// None: the line fits.
pub fn brm_line() -> Result<(brm::Line<2>, Twin), Error> {
    let circuit = brm::Line::new(LINE, BITS)?;
    let twin = Twin::of(&circuit)
        .with_axes()
        .without("train_")
        .with_bus("o_value", "value_")
        .with_bus("o_negative", "negative_")
        .with_input_bus("i_value", "value_")
        .with_input_bus("i_negative", "negative_");
    Ok((circuit, twin))
}
