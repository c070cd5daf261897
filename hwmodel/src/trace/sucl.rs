//! A command file for the viewer Surfer that lays out a trace.

use super::{Kind, SignalList};
use std::fmt::Write;

/// Height of a curve in lines.
const CURVE_LINES: u32 = 3;

/// The command file for a wave file of these signals, of the name `wave_file`; to be used as
/// `surfer --command-file FILE.sucl WAVE_FILE`.
///
/// The order is that of [`gtkw`](super::gtkw): every scope begins with a divider of its name, the
/// pulses come first; states read as words, numbers in decimal, and remainders are drawn as curves.
///
/// A command changes the item that has the focus, and a new item is put below it: so each one is
/// focused as soon as it is there. Versions of Surfer that cannot draw curves (before 0.5) pass over
/// the commands for them, and show numbers.
#[must_use]
pub fn sucl(wave_file: &str, list: &SignalList) -> String {
    let is_fst = wave_file.ends_with(".fst");
    let mut text = String::new();
    let mut rows = 0;
    let mut add = |text: &mut String, command: &str, name: &str| {
        let _ = writeln!(text, "{command} {name}\nitem_focus {}", row_name(rows));
        rows += 1;
    };
    let mut scope = None;
    for signal in list.signals() {
        if scope != Some(signal.scope) {
            scope = Some(signal.scope);
            let heading = if signal.scope.is_empty() { SignalList::TOP } else { signal.scope };
            add(&mut text, "divider_add", heading);
        }
        let dot = if signal.scope.is_empty() { "" } else { "." };
        let (top, scope, name) = (SignalList::TOP, signal.scope, &signal.name);
        add(&mut text, "variable_add", &format!("{top}.{scope}{dot}{name}"));
        let format = match signal.kind {
            Kind::Bit => continue,
            Kind::Unsigned(_) | Kind::Ramp(_) => "Unsigned",
            Kind::Signed(_) | Kind::SignedRamp(_) => "Signed",
            Kind::Word(_) if is_fst => "ASCII",
            Kind::Word(_) => "String",
        };
        let _ = writeln!(text, "item_set_format {format}");
        if let Kind::Ramp(_) | Kind::SignedRamp(_) = signal.kind {
            let _ = writeln!(text, "item_set_height {CURVE_LINES}\nitem_set_analog step");
        }
    }
    text + "item_unfocus\nzoom_fit\n"
}

/// Surfer's name of a row: its number in hexadecimal, with the digits a to p.
fn row_name(row: usize) -> String {
    let digits = format!("{row:x}");
    digits.chars().filter_map(|c| char::from_u32('a' as u32 + c.to_digit(16)?)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_named_as_surfer_reads_them() {
        let names = [0, 9, 10, 15, 16, 0x2f0].map(row_name);
        assert_eq!(names, ["a", "j", "k", "p", "ba", "cpa"]);
    }
}
