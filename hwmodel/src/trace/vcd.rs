//! Value change dump (IEEE 1364), the wave format that every viewer reads.

use super::digits::{Decimal, push_binary};
use super::{Kind, SignalList, Wave};
use std::io::{self, Write};

/// A VCD file being written. Header and identifiers come from the `vcd` crate; the value changes,
/// which are nearly all of the file, are put together here as bytes.
#[derive(Debug)]
pub struct Vcd<W> {
    out: W,
    signals: Vec<Encoded>,
    time: Option<u64>,
    /// The time in decimal.
    stamp: Decimal,
    /// Lines that are not written yet.
    lines: Vec<u8>,
}

#[derive(Debug)]
struct Encoded {
    kind: Kind,
    /// What ends a change of the signal: its identifier and the line feed, then nothing.
    ending: [u8; ENDING],
    length: usize,
}

/// Identifiers of five characters are enough for any `u32` of signals. A fixed number of bytes is
/// faster to copy than the exact one.
const ENDING: usize = 8;

/// How many bytes are written at a time.
const BLOCK: usize = 1 << 16;

impl<W: Write> Vcd<W> {
    /// Writes the header; the time axis counts units of 10^`exponent` seconds (0 to −15).
    ///
    /// # Errors
    /// The output's; a list of signals that no viewer could show; an exponent out of range.
    pub fn new(mut out: W, list: &SignalList, exponent: i8) -> io::Result<Self> {
        list.check()?;
        let mut header = vcd::Writer::new(&mut out);
        header.version(concat!("onepulse-hwmodel ", env!("CARGO_PKG_VERSION")))?;
        let (factor, unit) = timescale(exponent)?;
        header.timescale(factor, unit)?;
        header.add_module(SignalList::TOP)?;
        let mut scope = "";
        let mut signals = Vec::new();
        for signal in list.signals() {
            if signal.scope != scope {
                if !scope.is_empty() {
                    header.upscope()?;
                }
                if !signal.scope.is_empty() {
                    header.add_module(signal.scope)?;
                }
                scope = signal.scope;
            }
            let bits = signal.kind.bits();
            let (var_type, range) = match signal.kind {
                Kind::Bit => (vcd::VarType::Wire, None),
                Kind::Word(_) => (vcd::VarType::String, None),
                Kind::Unsigned(_) | Kind::Ramp(_) | Kind::Signed(_) => {
                    (vcd::VarType::Reg, Some(vcd::ReferenceIndex::Range(bits as i32 - 1, 0)))
                }
            };
            let id = header.add_var(var_type, bits, &signal.name, range)?;
            signals.push(Encoded::new(signal.kind, &id.to_string())?);
        }
        if !scope.is_empty() {
            header.upscope()?;
        }
        header.upscope()?;
        header.enddefinitions()?;
        let lines = Vec::with_capacity(2 * BLOCK);
        Ok(Self { out, signals, time: None, stamp: Decimal::ZERO, lines })
    }

    /// The output of a finished wave.
    pub fn into_output(self) -> W {
        self.out
    }

    fn write_lines(&mut self) -> io::Result<()> {
        self.out.write_all(&self.lines)?;
        self.lines.clear();
        Ok(())
    }
}

impl Encoded {
    fn new(kind: Kind, id: &str) -> io::Result<Self> {
        let text = format!("{}{id}\n", if kind == Kind::Bit { "" } else { " " });
        let mut ending = [0; ENDING];
        let length = text.len();
        let room = ending.get_mut(..length).ok_or(io::ErrorKind::InvalidInput)?;
        room.copy_from_slice(text.as_bytes());
        Ok(Self { kind, ending, length })
    }
}

impl<W: Write> Wave for Vcd<W> {
    fn time(&mut self, time: u64) -> io::Result<()> {
        if self.time.is_some_and(|last| time <= last) {
            return Err(io::Error::other("the time of a wave cannot run backwards"));
        }
        self.stamp.add(time - self.time.unwrap_or(0));
        self.time = Some(time);
        if self.lines.len() >= BLOCK {
            self.write_lines()?;
        }
        self.lines.push(b'#');
        self.stamp.push(&mut self.lines);
        self.lines.push(b'\n');
        Ok(())
    }

    fn change(&mut self, signal: usize, value: u64) -> io::Result<()> {
        let Encoded { kind, ending, length } = &self.signals[signal];
        let lines = &mut self.lines;
        match *kind {
            Kind::Bit => lines.push(b'0' + (value & 1) as u8),
            Kind::Unsigned(bits) | Kind::Ramp(bits) | Kind::Signed(bits) => {
                lines.push(b'b');
                // Leading zeros may be left out.
                let bits = bits.min(64 - (value & low_bits(bits)).leading_zeros()).max(1);
                push_binary(lines, value, bits);
            }
            Kind::Word(words) => {
                lines.push(b's');
                lines.extend_from_slice(words.get(value as usize).unwrap_or(&"?").as_bytes());
            }
        }
        let end = lines.len() + length;
        lines.extend_from_slice(ending);
        lines.truncate(end);
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        self.write_lines()?;
        self.out.flush()
    }
}

/// The `$timescale` of a unit of 10^`exponent` seconds: 1, 10 or 100 of a named unit.
fn timescale(exponent: i8) -> io::Result<(u32, vcd::TimescaleUnit)> {
    use vcd::TimescaleUnit::{FS, MS, NS, PS, S, US};
    let digits = usize::from(exponent.unsigned_abs());
    match [S, MS, US, NS, PS, FS].get(digits.div_ceil(3)) {
        Some(unit) if exponent <= 0 => {
            let factor = 10_u32.pow((digits.div_ceil(3) * 3 - digits) as u32);
            Ok((factor, *unit))
        }
        _ => Err(io::Error::new(
            io::ErrorKind::InvalidInput,
            format!("a VCD time axis cannot count units of 10^{exponent} s"),
        )),
    }
}

const fn low_bits(bits: u32) -> u64 {
    u64::MAX >> (64 - bits)
}
