//! Any value of the core's types, as far as their own invariants go.

use onepulse_core::dda::{Preset, Radix, Register};
use onepulse_core::{Axis, Direction, EndRule, Quadrant, Sweep};

/// Any end rule.
pub(crate) fn any_rule() -> EndRule {
    match kani::any_where(|rule: &u8| *rule < 3) {
        0 => EndRule::Total,
        1 => EndRule::PerAxis,
        _ => EndRule::Larger,
    }
}

/// Either sense.
pub(crate) fn any_direction() -> Direction {
    if kani::any() { Direction::Cw } else { Direction::Ccw }
}

/// Either axis.
pub(crate) fn any_axis() -> Axis {
    if kani::any() { Axis::X } else { Axis::Y }
}

/// Any remainder register preset.
pub(crate) fn any_preset() -> Preset {
    match kani::any_where(|preset: &u8| *preset < 3) {
        0 => Preset::Zero,
        1 => Preset::Half,
        _ => Preset::Full,
    }
}

/// A binary register of any width there is.
pub(crate) fn any_binary_register() -> Register {
    let bits = kani::any_where(|bits: &u8| (1..=32).contains(bits));
    match Register::new(Radix::Binary, u32::from(bits)) {
        Ok(register) => register,
        Err(_) => panic!("widths from 1 to 32 are offered"),
    }
}

/// Any place on the way round any circle. Its radius, rounded up, is `i32::MAX` at most; the largest
/// coordinate of point-by-point comparison is that too, or 1 less.
pub(crate) fn any_sweep() -> Sweep {
    let direction = any_direction();
    let end = kani::any::<[i32; 2]>().map(i64::from);
    let crossings_left = kani::any_where(|crossings: &u8| *crossings <= 4);
    // As many quadrants before the end point's.
    let Some(mut quadrant) = Quadrant::left(end, direction) else {
        kani::assume(false);
        unreachable!("the centre is no end point");
    };
    for turn in 1..=4 {
        if turn <= 4 - crossings_left {
            quadrant = quadrant.next(direction);
        }
    }
    let peak = kani::any_where(|peak: &i32| *peak >= 1);
    let is_less: bool = kani::any();
    kani::assume(!is_less || peak < i32::MAX);
    let sweep = Sweep::in_state(
        direction,
        quadrant,
        crossings_left,
        end,
        i64::from(peak),
        u64::from(peak.unsigned_abs()) + u64::from(is_less),
    );
    kani::assume(sweep.invariant());
    sweep
}
