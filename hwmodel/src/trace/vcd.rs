//! Value change dump (IEEE 1364), the wave format that every viewer reads.

use super::digits::Decimal;
use super::encoded::{Encoded, ROOM};
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
    /// Lines that are not written yet, and what they have come to.
    lines: Vec<u8>,
    length: usize,
}

/// How many bytes are written at a time: as many as stay in a first level cache.
const BLOCK: usize = 1 << 14;

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
                Kind::Unsigned(_) | Kind::Ramp(_) | Kind::Signed(_) | Kind::SignedRamp(_) => {
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
        let lines = vec![0; BLOCK];
        Ok(Self { out, signals, time: None, stamp: Decimal::ZERO, lines, length: 0 })
    }

    /// The output of a finished wave.
    pub fn into_output(self) -> W {
        self.out
    }

    /// Makes room for so many lines, which a block has room for.
    #[inline(always)]
    fn make_room(&mut self, lines: usize) -> io::Result<()> {
        if self.lines.len() - self.length < lines * ROOM { self.write_lines() } else { Ok(()) }
    }

    #[cold]
    fn write_lines(&mut self) -> io::Result<()> {
        self.out.write_all(&self.lines[..self.length])?;
        self.length = 0;
        Ok(())
    }
}

impl<W: Write> Wave for Vcd<W> {
    fn time(&mut self, time: u64) -> io::Result<()> {
        if self.time.is_some_and(|last| time <= last) {
            return Err(io::Error::other("the time of a wave cannot run backwards"));
        }
        self.time = Some(time);
        self.stamp.set(time);
        self.make_room(1)?;
        if let Some([mark, room @ ..]) = self.lines[self.length..].first_chunk_mut::<ROOM>() {
            *mark = b'#';
            let digits = self.stamp.put(room);
            room[digits] = b'\n';
            self.length += digits + 2;
        }
        Ok(())
    }

    fn change(&mut self, signal: usize, value: u64) -> io::Result<()> {
        self.changes(&[(signal, value)])
    }

    fn changes(&mut self, changes: &[(usize, u64)]) -> io::Result<()> {
        for changes in changes.chunks(BLOCK / ROOM) {
            self.make_room(changes.len())?;
            let Self { signals, lines, .. } = self;
            let mut length = self.length;
            for &(signal, value) in changes {
                if let Some(room) = lines[length..].first_chunk_mut() {
                    length += signals[signal].put(value, room);
                }
            }
            self.length = length;
        }
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
