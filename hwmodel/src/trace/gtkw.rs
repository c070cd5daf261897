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
    /// A curve of steps, in decimal.
    pub(super) const CURVE: u32 = 0x8024;
    /// The same of signed numbers.
    pub(super) const SIGNED_CURVE: u32 = 0x8420;
    /// A line that gives its room to the curve above.
    pub(super) const CURVE_ROOM: u32 = 0x20000;
}

/// Clock periods that are seen when the file is opened, in a window of some 500 pixels.
const PERIODS: f64 = 14.0;
const PIXELS: f64 = 500.0;

/// GTKWave's zoom is a power of two: so many units of time in this many pixels.
const FRAME: f64 = 200.0;

/// The save file for a wave file of these signals, which lies beside it under `wave_file`; its
/// clock has a period of `period` (see [`Clock::viewer_period`](super::Clock::viewer_period)).
///
/// Every scope is a group with its name as heading, the pulses in the first; states read as words,
/// numbers in decimal, and remainders are drawn as curves.
#[must_use]
pub fn gtkw(wave_file: &str, list: &SignalList, period: f64) -> String {
    let is_fst = wave_file.ends_with(".fst");
    let zoom = (period * PERIODS / PIXELS * FRAME).log2();
    let mut text = format!("[dumpfile] \"{wave_file}\"\n[timestart] 0\n*{:.6} -1\n", -zoom);
    let mut shown = 0;
    let mut scope = None;
    for signal in list.signals() {
        if scope != Some(signal.scope) {
            scope = Some(signal.scope);
            let heading = if signal.scope.is_empty() { SignalList::TOP } else { signal.scope };
            let _ = writeln!(text, "@{:x}\n-{heading}", flag::BLANK);
            shown = flag::BLANK;
        }
        let range = |bits: u32| format!("[{}:0]", bits - 1);
        let (flags, range) = match signal.kind {
            Kind::Bit => (flag::BINARY, String::new()),
            Kind::Unsigned(bits) => (flag::DECIMAL, range(bits)),
            Kind::Ramp(bits) => (flag::CURVE, range(bits)),
            Kind::Signed(bits) => (flag::SIGNED, range(bits)),
            Kind::SignedRamp(bits) => (flag::SIGNED_CURVE, range(bits)),
            Kind::Word(words) if is_fst => {
                let longest = words.iter().map(|word| word.len()).max().unwrap_or(1);
                (flag::ASCII, range(8 * longest as u32))
            }
            Kind::Word(_) => (flag::HEXADECIMAL, String::new()),
        };
        if flags != shown {
            let _ = writeln!(text, "@{flags:x}");
            shown = flags;
        }
        let dot = if signal.scope.is_empty() { "" } else { "." };
        let (top, scope, name) = (SignalList::TOP, signal.scope, &signal.name);
        let _ = writeln!(text, "{top}.{scope}{dot}{name}{range}");
        if matches!(flags, flag::CURVE | flag::SIGNED_CURVE) {
            let _ = writeln!(text, "@{:x}\n-\n-", flag::CURVE_ROOM);
            shown = flag::CURVE_ROOM;
        }
    }
    text
}
