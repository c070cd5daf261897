//! A GTKWave save file that lays out a trace.

use super::{Kind, SignalList};
use std::fmt::Write;

/// GTKWave's display flags: right-justified, and the radix.
mod flag {
    pub(super) const HEXADECIMAL: u32 = 0x22;
    pub(super) const DECIMAL: u32 = 0x24;
    pub(super) const BINARY: u32 = 0x28;
    pub(super) const BLANK: u32 = 0x200;
    pub(super) const SIGNED: u32 = 0x420;
    pub(super) const ASCII: u32 = 0x820;
}

/// The save file for a wave file of these signals, which lies beside it under `wave_file`.
///
/// Every scope is a group with its name as heading; states read as words, numbers in decimal.
#[must_use]
pub fn gtkw(wave_file: &str, list: &SignalList) -> String {
    let is_fst = wave_file.ends_with(".fst");
    let mut text = format!("[dumpfile] \"{wave_file}\"\n[timestart] 0\n");
    let mut shown = 0;
    let mut scope = None;
    for signal in list.signals() {
        if scope != Some(signal.scope) {
            scope = Some(signal.scope);
            let heading = if signal.scope.is_empty() { SignalList::TOP } else { signal.scope };
            let _ = writeln!(text, "@{:x}\n-{heading}", flag::BLANK);
            shown = flag::BLANK;
        }
        let (flags, range) = match signal.kind {
            Kind::Bit => (flag::BINARY, String::new()),
            Kind::Unsigned(bits) => (flag::DECIMAL, format!("[{}:0]", bits - 1)),
            Kind::Signed(bits) => (flag::SIGNED, format!("[{}:0]", bits - 1)),
            Kind::Word(words) if is_fst => {
                let longest = words.iter().map(|word| word.len()).max().unwrap_or(1);
                (flag::ASCII, format!("[{}:0]", 8 * longest - 1))
            }
            Kind::Word(_) => (flag::HEXADECIMAL, String::new()),
        };
        if flags != shown {
            let _ = writeln!(text, "@{flags:x}");
            shown = flags;
        }
        let dot = if signal.scope.is_empty() { "" } else { "." };
        let _ = writeln!(text, "{}.{}{dot}{}{range}", SignalList::TOP, signal.scope, signal.name);
    }
    text
}
