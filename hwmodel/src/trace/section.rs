//! A section of an FST file: the value changes of a stretch of time, signal by signal.
//!
//! ```text
//! 8 | length | start | end | memory | frame | changes | offsets of the changes | times
//! ```
//!
//! The frame has every signal's value at the start. A signal's changes are a chain of (times gone
//! by since the last one, value), packed into bytes, then by LZ4; the times are kept once for all.

use super::Kind;
use super::digits::{LONGEST_BINARY, put_binary};

/// A section that is being filled.
#[derive(Debug)]
pub(super) struct Section {
    start: u64,
    end: u64,
    frame: Vec<u8>,
    chains: Vec<Chain>,
    /// For each time, what it lies after the one before.
    times: Vec<u8>,
    /// How many times there are.
    count: u64,
    /// Bytes in the chains.
    held: usize,
}

/// The changes of one signal.
#[derive(Debug)]
struct Chain {
    kind: Kind,
    bytes: Vec<u8>,
    /// The number of times at the last change; 1 is the first of the section.
    changed_at: u64,
    last: Option<u64>,
}

/// Shorter chains do not become shorter by compression.
const WORTH_PACKING: usize = 32;

impl Section {
    /// The first section of a file with such signals.
    pub(super) fn first(kinds: impl Iterator<Item = Kind>) -> Self {
        let chain = |kind| Chain { kind, bytes: Vec::new(), changed_at: 1, last: None };
        let chains = kinds.map(chain).collect();
        let mut section =
            Self { start: 0, end: 0, frame: vec![], chains, times: vec![], count: 0, held: 0 };
        section.begin(0);
        section
    }

    /// Empties the section, for what follows on the time `start`.
    fn begin(&mut self, start: u64) {
        self.start = start;
        self.end = start;
        self.times.clear();
        self.count = 0;
        self.held = 0;
        self.frame.clear();
        for Chain { kind, bytes, changed_at, last } in &mut self.chains {
            bytes.clear();
            *changed_at = 1;
            match *last {
                Some(value) => push_digits(&mut self.frame, *kind, value),
                None => self.frame.resize(self.frame.len() + bits(*kind) as usize, b'x'),
            }
        }
    }

    /// The last time.
    pub(super) const fn end(&self) -> u64 {
        self.end
    }

    /// Bytes that are held back.
    pub(super) fn size(&self) -> usize {
        self.held + self.times.len()
    }

    /// All following changes happen at `time`, which lies after the last one.
    pub(super) fn time(&mut self, time: u64) {
        // A section's first time is counted from 0.
        let before = if self.count == 0 { 0 } else { self.end };
        push_number(&mut self.times, time - before);
        self.count += 1;
        self.end = time;
    }

    pub(super) fn change(&mut self, signal: usize, value: u64) {
        let Chain { kind, bytes, changed_at, last } = &mut self.chains[signal];
        let gone_by = self.count - *changed_at;
        *changed_at = self.count;
        *last = Some(value);
        let held = bytes.len();
        match *kind {
            // The lowest bits tell values of more than two states from these.
            Kind::Bit => push_number(bytes, gone_by << 2 | (value & 1) << 1),
            Kind::Unsigned(bits)
            | Kind::Ramp(bits)
            | Kind::Signed(bits)
            | Kind::SignedRamp(bits) => {
                push_number(bytes, gone_by << 1);
                let end = bytes.len() + bits.div_ceil(8) as usize;
                bytes.extend_from_slice(&(value << (64 - bits)).to_be_bytes());
                bytes.truncate(end);
            }
            Kind::Word(words) => {
                push_number(bytes, gone_by << 1);
                push_word(bytes, words, value);
            }
        }
        self.held += bytes.len() - held;
    }

    /// The section as it stands in the file. What follows belongs to the next one.
    pub(super) fn close(&mut self) -> Vec<u8> {
        let mut file = vec![8];
        let memory: usize = self.chains.iter().map(|chain| chain.bytes.len()).sum();
        // The length is put in last.
        for number in [0, self.start, self.end, memory as u64] {
            file.extend_from_slice(&number.to_be_bytes());
        }
        // Twice, as it is not compressed.
        let frame = self.frame.len() as u64;
        for number in [frame, frame, self.chains.len() as u64] {
            push_number(&mut file, number);
        }
        file.extend_from_slice(&self.frame);
        self.push_changes(&mut file);
        self.push_times(&mut file);
        let length = file.len() as u64 - 1;
        file[1..9].copy_from_slice(&length.to_be_bytes());
        self.begin(self.end);
        file
    }

    fn push_changes(&self, file: &mut Vec<u8>) {
        push_number(file, self.chains.len() as u64);
        let mut last = file.len();
        file.push(b'4'); // LZ4
        let mut offsets = Vec::new();
        let mut without = 0;
        for Chain { bytes, .. } in &self.chains {
            if bytes.is_empty() {
                without += 1;
                continue;
            }
            if without > 0 {
                push_number(&mut offsets, without << 1);
                without = 0;
            }
            push_signed(&mut offsets, ((file.len() - last) << 1 | 1) as i64);
            last = file.len();
            let packed = match bytes.len() {
                WORTH_PACKING.. => lz4_flex::compress(bytes),
                _ => Vec::new(),
            };
            if packed.is_empty() || packed.len() >= bytes.len() {
                push_number(file, 0);
                file.extend_from_slice(bytes);
            } else {
                push_number(file, bytes.len() as u64);
                file.extend_from_slice(&packed);
            }
        }
        if without > 0 {
            push_number(&mut offsets, without << 1);
        }
        file.extend_from_slice(&offsets);
        file.extend_from_slice(&(offsets.len() as u64).to_be_bytes());
    }

    fn push_times(&self, file: &mut Vec<u8>) {
        const LEVEL: u8 = 3;
        let packed = miniz_oxide::deflate::compress_to_vec_zlib(&self.times, LEVEL);
        let packed = if packed.len() < self.times.len() { &packed } else { &self.times };
        file.extend_from_slice(packed);
        for number in [self.times.len() as u64, packed.len() as u64, self.count] {
            file.extend_from_slice(&number.to_be_bytes());
        }
    }
}

/// The number of bits in the file: a word is its ASCII characters.
pub(super) fn bits(kind: Kind) -> u32 {
    match kind {
        Kind::Word(words) => 8 * longest(words) as u32,
        _ => kind.bits(),
    }
}

fn longest(words: &[&str]) -> usize {
    words.iter().map(|word| word.len()).max().unwrap_or(1)
}

/// A word in characters, after zeros.
fn push_word(bytes: &mut Vec<u8>, words: &[&str], value: u64) {
    let word = words.get(value as usize).unwrap_or(&"?");
    bytes.resize(bytes.len() + longest(words) - word.len(), 0);
    bytes.extend_from_slice(word.as_bytes());
}

/// A value as a frame has it.
fn push_digits(frame: &mut Vec<u8>, kind: Kind, value: u64) {
    if let Kind::Word(words) = kind {
        let mut characters = Vec::new();
        push_word(&mut characters, words, value);
        for character in characters {
            push_binary(frame, character.into(), 8);
        }
    } else {
        push_binary(frame, value, kind.bits());
    }
}

fn push_binary(frame: &mut Vec<u8>, value: u64, bits: u32) {
    let mut digits = [0; LONGEST_BINARY];
    put_binary(&mut digits, value, bits);
    frame.extend_from_slice(&digits[..bits as usize]);
}

/// A number in groups of seven bits, the lowest first; all but the last are marked.
fn push_number(bytes: &mut Vec<u8>, mut number: u64) {
    while number > 0x7f {
        bytes.push(number as u8 | 0x80);
        number >>= 7;
    }
    bytes.push(number as u8);
}

/// The same in two's complement: the last group's highest bit is the sign.
fn push_signed(bytes: &mut Vec<u8>, mut number: i64) {
    while !(-64..64).contains(&number) {
        bytes.push(number as u8 | 0x80);
        number >>= 7;
    }
    bytes.push(number as u8 & 0x7f);
}
