//! What to say of an overcut, and what to do about it.

use crate::compensation::{Overcut, OvercutKind};
use crate::{Diagnostic, Place};

/// The error of an overcut in a contour whose steps stand in these places.
pub(super) fn diagnostic(overcut: &Overcut, places: &[&Place]) -> Diagnostic {
    let place = |line: u32| places.iter().find(|place| place.line == line).copied().cloned();
    let unknown = || Place { line: overcut.line, text: "".into(), span: 0..0 };
    let help = match overcut.kind {
        OvercutKind::SmallArc { .. } => "take a smaller cutter, or a larger arc",
        OvercutKind::ShortBlock { .. } => "take a smaller cutter, or leave the short block out",
        OvercutKind::NoMeeting { .. } => "take a smaller cutter, or open the corner",
        OvercutKind::InsideCorner { .. } => {
            "put an arc of at least the cutter's radius between the blocks, or compensate by the C type"
        }
        OvercutKind::Interference { .. } => {
            "take a smaller cutter, or change one of the two blocks"
        }
        OvercutKind::NotALine | OvercutKind::NoLength => {
            "give G41 or G42 a line to the contour, and G40 one from it"
        }
        OvercutKind::Radius { .. } => "correct the tool table or --radius",
        _ => "correct the block's coordinates",
    };
    Diagnostic {
        place: place(overcut.line).unwrap_or_else(unknown),
        also: overcut.other_line.and_then(place).into_iter().collect(),
        message: match (overcut.kind, overcut.other_line) {
            (OvercutKind::Interference { distance, radius }, Some(other)) => format!(
                "along line {} the cutter cuts {:.6} mm into line {other}",
                overcut.line,
                radius - distance
            ),
            (kind, _) => kind.to_string(),
        },
        help: help.into(),
    }
}
