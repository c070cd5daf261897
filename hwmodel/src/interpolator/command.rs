//! What an interpolator is asked for, and why it refuses.

use onepulse_core::Direction;
use onepulse_core::dda::Preset;

/// A command as it stands on the interpolator's ports; of every field the port takes the low bits.
///
/// The constructors make commands of each curve. A line starts at the origin, an arc runs about
/// it; the period is the number of clocks from one interpolation cycle to the next, and so the feed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Command<const AXES: usize = 2> {
    /// Curve and method, 3 bits: a code of [`Curve`], or one that there is not.
    pub curve: u8,
    /// The start of an arc, n + 1 bits, signed (32 at most).
    pub start: [i64; 2],
    /// The end, of that width.
    pub end: [i64; AXES],
    /// The sense of an arc.
    pub cw: bool,
    /// Remainder preset of `dda_line` and `dda_arc`, 2 bits: 0 zero, 1 half, 2 full.
    pub preset: u8,
    /// Left-shift normalization, of the DDA curves.
    pub normalize: bool,
    /// The period, 24 bits, at least 6.
    pub period: u32,
}

/// The curves by their codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curve {
    /// [`dda::Line`](crate::dda::Line), all axes.
    DdaLine,
    /// [`dda::Arc`](crate::dda::Arc).
    DdaArc,
    /// [`dda::CentredArc`](crate::dda::CentredArc).
    DdaCentredArc,
    /// [`ppc::Line`](crate::ppc::Line) with two end counters.
    PpcLine,
    /// [`ppc::Arc`](crate::ppc::Arc) with two end counters.
    PpcArc,
    /// [`brm::Line`](crate::brm::Line), all axes.
    BrmLine,
}

impl Curve {
    /// The curve of a code.
    #[must_use]
    pub const fn from_code(code: u8) -> Option<Self> {
        Some(match code {
            0 => Self::DdaLine,
            1 => Self::DdaArc,
            2 => Self::DdaCentredArc,
            3 => Self::PpcLine,
            4 => Self::PpcArc,
            5 => Self::BrmLine,
            _ => return None,
        })
    }
}

/// Why a command was refused, in the order of the codes on the port `error`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// It was not.
    None,
    /// There is no such curve.
    Curve,
    /// There is no such preset.
    Preset,
    /// A coordinate is out of range, or of an axis that the curve does not have.
    Coordinate,
    /// An arc from or to its centre.
    Centre,
    /// The registers do not hold the circle.
    TooLarge,
    /// The period is too short.
    Period,
}

impl Refusal {
    /// The reasons as words, in the order of their codes.
    pub const WORDS: &[&str] =
        &["NONE", "CURVE", "PRESET", "COORDINATE", "CENTRE", "TOO_LARGE", "PERIOD"];
}

impl<const AXES: usize> Command<AXES> {
    const fn line(curve: Curve, end: [i32; AXES], period: u32) -> Self {
        let mut wide = [0; AXES];
        let mut axis = 0;
        while axis < AXES {
            wide[axis] = end[axis] as i64;
            axis += 1;
        }
        Self {
            curve: curve as u8,
            start: [0; 2],
            end: wide,
            cw: false,
            preset: 0,
            normalize: false,
            period,
        }
    }

    const fn arc(
        curve: Curve,
        start: [i32; 2],
        [x, y]: [i32; 2],
        direction: Direction,
        period: u32,
    ) -> Self {
        let mut end = [0; AXES];
        end[0] = x;
        end[1] = y;
        let command = Self::line(curve, end, period);
        let start = [start[0] as i64, start[1] as i64];
        Self { start, cw: matches!(direction, Direction::Cw), ..command }
    }

    /// A line by digital integration.
    #[must_use]
    pub const fn dda_line(end: [i32; AXES], preset: Preset, normalize: bool, period: u32) -> Self {
        let command = Self::line(Curve::DdaLine, end, period);
        Self { preset: code(preset), normalize, ..command }
    }

    /// A line by rate multiplication.
    #[must_use]
    pub const fn brm_line(end: [i32; AXES], period: u32) -> Self {
        Self::line(Curve::BrmLine, end, period)
    }

    /// A line by point-by-point comparison; only x and y may move.
    #[must_use]
    pub const fn ppc_line(end: [i32; AXES], period: u32) -> Self {
        Self::line(Curve::PpcLine, end, period)
    }

    /// An arc by point-by-point comparison.
    #[must_use]
    pub const fn ppc_arc(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        period: u32,
    ) -> Self {
        Self::arc(Curve::PpcArc, start, end, direction, period)
    }

    /// An arc by digital integration, the textbook's circuit.
    #[must_use]
    pub const fn dda_arc(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        preset: Preset,
        normalize: bool,
        period: u32,
    ) -> Self {
        let command = Self::arc(Curve::DdaArc, start, end, direction, period);
        Self { preset: code(preset), normalize, ..command }
    }

    /// An arc by digital integration, staggered and centred.
    #[must_use]
    pub const fn dda_centred_arc(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        normalize: bool,
        period: u32,
    ) -> Self {
        Self { normalize, ..Self::arc(Curve::DdaCentredArc, start, end, direction, period) }
    }
}

const fn code(preset: Preset) -> u8 {
    match preset {
        Preset::Zero => 0,
        Preset::Half => 1,
        Preset::Full => 2,
    }
}
