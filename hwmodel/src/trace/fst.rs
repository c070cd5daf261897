//! FST, GTKWave's own compressed wave format.

use super::section::{Section, bits};
use super::{Kind, SignalList, Wave};
use fst_writer::{
    FstFileType, FstHeaderWriter, FstInfo, FstScopeType, FstSignalType, FstVarDirection,
    FstVarType, FstWriteError,
};
use std::io::{self, Cursor, Seek, SeekFrom, Write};

/// An FST file being written. The declarations come from the `fst-writer` crate; the sections of
/// value changes, which are nearly all of the file, are put together here, as the crate takes
/// values in digits and sorts them by signal only in the end.
///
/// The crate has no strings: a word becomes a vector of its ASCII bytes, as Verilog test benches
/// do it, which viewers show as text.
#[derive(Debug)]
pub struct Fst<W> {
    out: W,
    section: Section,
    sections: u64,
    is_stamped: bool,
}

/// What may be held back before a section is written, in bytes: it should stay in a cache.
const SECTION: usize = 1 << 20;

/// Where the header has the end of the time axis, and the number of sections.
const END: u64 = 17;
const SECTIONS: u64 = 65;

impl<W: Write + Seek> Fst<W> {
    /// Writes the header; the time axis counts units of 10^`exponent` seconds.
    ///
    /// # Errors
    /// The output's; a list of signals that no viewer could show.
    pub fn new(mut out: W, list: &SignalList, exponent: i8) -> io::Result<Self> {
        list.check()?;
        out.write_all(&declarations(list, exponent).map_err(io::Error::other)?)?;
        let section = Section::first(list.signals().iter().map(|signal| signal.kind));
        Ok(Self { out, section, sections: 0, is_stamped: false })
    }

    fn write_section(&mut self) -> io::Result<()> {
        self.sections += 1;
        self.out.write_all(&self.section.close())
    }
}

impl<W: Write + Seek> Wave for Fst<W> {
    fn time(&mut self, time: u64) -> io::Result<()> {
        if self.is_stamped && time <= self.section.end() {
            return Err(io::Error::other("the time of a wave cannot run backwards"));
        }
        self.is_stamped = true;
        if self.section.size() > SECTION {
            self.write_section()?;
        }
        self.section.time(time);
        Ok(())
    }

    fn change(&mut self, signal: usize, value: u64) -> io::Result<()> {
        if !self.is_stamped {
            return Err(io::Error::other("a change of a wave needs a time"));
        }
        self.section.change(signal, value);
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        let end = self.section.end();
        self.write_section()?;
        for (place, number) in [(END, end), (SECTIONS, self.sections)] {
            self.out.seek(SeekFrom::Start(place))?;
            self.out.write_all(&number.to_be_bytes())?;
        }
        self.out.seek(SeekFrom::End(0))?;
        self.out.flush()
    }
}

/// Everything that comes before the first section.
fn declarations(list: &SignalList, exponent: i8) -> Result<Vec<u8>, FstWriteError> {
    let info = FstInfo {
        start_time: 0,
        timescale_exponent: exponent,
        version: concat!("onepulse-hwmodel ", env!("CARGO_PKG_VERSION")).to_owned(),
        date: String::new(),
        file_type: FstFileType::Verilog,
    };
    let mut header = FstHeaderWriter::new(Cursor::new(Vec::new()), &info)?;
    header.scope(SignalList::TOP, "", FstScopeType::Module)?;
    let mut scope = "";
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
        let kind = FstSignalType::bit_vec(bits);
        header.var(name, kind, var_type, FstVarDirection::Implicit, None)?;
    }
    if !scope.is_empty() {
        header.up_scope()?;
    }
    header.up_scope()?;
    let mut file = header.finish()?.finish()?.into_inner();
    // The crate ends with a section without changes.
    file.truncate(first_section(&file));
    Ok(file)
}

/// Where the first section of value changes begins. Every block of a file is a byte that tells
/// what it is, and a length that counts itself.
fn first_section(file: &[u8]) -> usize {
    const CHANGES: u8 = 8;
    let mut at = 0;
    while file.get(at).is_some_and(|kind| *kind != CHANGES) {
        let length = file[at + 1..].first_chunk().map_or(0, |length| u64::from_be_bytes(*length));
        at += 1 + length as usize;
    }
    at
}
