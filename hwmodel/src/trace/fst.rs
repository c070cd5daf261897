//! FST, GTKWave's own compressed wave format.

use super::{Kind, SignalList, Wave};
use fst_writer::{
    FstBodyWriter, FstFileType, FstHeaderWriter, FstInfo, FstScopeType, FstSignalId, FstSignalType,
    FstVarDirection, FstVarType, FstWriteError,
};
use std::io::{self, Seek, Write};

/// An FST file being written, with the `fst-writer` crate.
///
/// The crate has no strings: a word becomes a vector of its ASCII bytes, as Verilog test benches
/// do it, which viewers show as text.
pub struct Fst<W: Write + Seek> {
    body: Option<FstBodyWriter<W>>,
    signals: Vec<(Kind, FstSignalId)>,
    digits: Vec<u8>,
}

/// What the writer may hold back before a block of the file is written, in bytes.
const BLOCK: usize = 16 << 20;

impl<W: Write + Seek> Fst<W> {
    /// Writes the header; the time axis counts units of 10^`exponent` seconds.
    ///
    /// # Errors
    /// The output's; a list of signals that no viewer could show.
    pub fn new(out: W, list: &SignalList, exponent: i8) -> io::Result<Self> {
        list.check()?;
        Self::open(out, list, exponent).map_err(io_error)
    }

    fn open(out: W, list: &SignalList, exponent: i8) -> Result<Self, FstWriteError> {
        let info = FstInfo {
            start_time: 0,
            timescale_exponent: exponent,
            version: concat!("onepulse-hwmodel ", env!("CARGO_PKG_VERSION")).to_owned(),
            date: String::new(),
            file_type: FstFileType::Verilog,
        };
        let mut header = FstHeaderWriter::new(out, &info)?;
        header.scope(SignalList::TOP, "", FstScopeType::Module)?;
        let mut scope = "";
        let mut signals = Vec::new();
        for signal in list.signals() {
            if signal.scope != scope {
                if !scope.is_empty() {
                    header.up_scope()?;
                }
                if !signal.scope.is_empty() {
                    header.scope(signal.scope, "", FstScopeType::Module)?;
                }
                scope = signal.scope;
            }
            let bits = bits(signal.kind);
            let (var_type, name) = match signal.kind {
                Kind::Bit => (FstVarType::Wire, signal.name.clone()),
                _ => (FstVarType::Reg, format!("{} [{}:0]", signal.name, bits - 1)),
            };
            let id = header.var(
                name,
                FstSignalType::bit_vec(bits),
                var_type,
                FstVarDirection::Implicit,
                None,
            )?;
            signals.push((signal.kind, id));
        }
        if !scope.is_empty() {
            header.up_scope()?;
        }
        header.up_scope()?;
        let mut body = header.finish()?;
        // The tracer hands on changes only.
        body.set_deduplicate(false);
        Ok(Self { body: Some(body), signals, digits: Vec::new() })
    }
}

impl<W: Write + Seek> Wave for Fst<W> {
    fn time(&mut self, time: u64) -> io::Result<()> {
        let Some(body) = &mut self.body else {
            return Ok(());
        };
        if body.size() > BLOCK {
            body.flush().map_err(io_error)?;
        }
        body.time_change(time).map_err(io_error)
    }

    fn change(&mut self, signal: usize, value: u64) -> io::Result<()> {
        let Some(body) = &mut self.body else {
            return Ok(());
        };
        let (kind, id) = self.signals[signal];
        let digits = &mut self.digits;
        digits.clear();
        match kind {
            Kind::Bit | Kind::Unsigned(_) | Kind::Ramp(_) | Kind::Signed(_) => {
                push_bits(digits, value, kind.bits());
            }
            Kind::Word(words) => {
                let word = words.get(value as usize).unwrap_or(&"?");
                let padding = bits(kind) as usize / 8 - word.len();
                digits.resize(8 * padding, b'0');
                for byte in word.bytes() {
                    push_bits(digits, u64::from(byte), 8);
                }
            }
        }
        body.signal_change(id, digits).map_err(io_error)
    }

    fn finish(&mut self) -> io::Result<()> {
        match self.body.take() {
            Some(body) => body.finish().map_err(io_error)?.flush(),
            None => Ok(()),
        }
    }
}

/// The number of bits in the file.
fn bits(kind: Kind) -> u32 {
    match kind {
        Kind::Word(words) => 8 * words.iter().map(|word| word.len()).max().unwrap_or(1) as u32,
        _ => kind.bits(),
    }
}

fn push_bits(digits: &mut Vec<u8>, value: u64, bits: u32) {
    digits.extend((0..bits).rev().map(|bit| b'0' + (value >> bit & 1) as u8));
}

fn io_error(error: FstWriteError) -> io::Error {
    io::Error::other(error)
}
