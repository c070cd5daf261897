//! The lines of a value change dump.

use super::Kind;
use super::digits::put_binary;
use std::io;

/// How the changes of a signal are written.
#[derive(Debug)]
pub(super) enum Encoded {
    Bit(Ending),
    Number(u32, Ending),
    /// The whole line of each word, and last that of a value without a word.
    Word(Vec<Line>),
}

/// What ends a change: the identifier and the line feed, then nothing.
#[derive(Debug)]
pub(super) struct Ending {
    bytes: [u8; Self::ROOM],
    length: usize,
}

#[derive(Debug)]
pub(super) struct Line {
    bytes: [u8; ROOM],
    length: usize,
}

/// Room for any line: a fixed number of bytes is faster to copy than the exact one.
pub(super) const ROOM: usize = 96;

impl Encoded {
    pub(super) fn new(kind: Kind, id: &str) -> io::Result<Self> {
        Ok(match kind {
            Kind::Bit => Self::Bit(Ending::new(&format!("{id}\n"))?),
            Kind::Unsigned(bits)
            | Kind::Ramp(bits)
            | Kind::Signed(bits)
            | Kind::SignedRamp(bits) => Self::Number(bits, Ending::new(&format!(" {id}\n"))?),
            Kind::Word(words) => {
                let words = words.iter().chain([&"?"]);
                let lines = words.map(|word| Line::new(&format!("s{word} {id}\n")));
                Self::Word(lines.collect::<io::Result<_>>()?)
            }
        })
    }

    /// Puts the line of a change; how many bytes it has.
    #[inline(always)]
    pub(super) fn put(&self, value: u64, room: &mut [u8; ROOM]) -> usize {
        match self {
            Self::Bit(ending) => {
                room[0] = b'0' + (value & 1) as u8;
                ending.put(room, 1)
            }
            Self::Number(bits, ending) => {
                // Leading zeros may be left out.
                let bits = 64 - (value & low_bits(*bits) | 1).leading_zeros();
                room[0] = b'b';
                put_binary(&mut room[1..], value, bits);
                ending.put(room, 1 + bits as usize)
            }
            Self::Word(lines) => {
                let line = lines.get(value as usize).or(lines.last());
                line.map_or(0, |line| line.put(room))
            }
        }
    }
}

impl Ending {
    /// Identifiers of five characters are enough for any `u32` of signals.
    const ROOM: usize = 8;

    fn new(text: &str) -> io::Result<Self> {
        Ok(Self { bytes: padded(text)?, length: text.len() })
    }

    /// Puts it behind so many bytes; how many there are then.
    #[inline(always)]
    fn put(&self, room: &mut [u8; ROOM], before: usize) -> usize {
        if let Some(room) = room[before..].first_chunk_mut() {
            *room = self.bytes;
        }
        before + self.length
    }
}

impl Line {
    fn new(text: &str) -> io::Result<Self> {
        Ok(Self { bytes: padded(text)?, length: text.len() })
    }

    /// Puts it; how many bytes it has.
    #[inline(always)]
    fn put(&self, room: &mut [u8; ROOM]) -> usize {
        const SHORT: usize = 16;
        room[..SHORT].copy_from_slice(&self.bytes[..SHORT]);
        if self.length > SHORT {
            *room = self.bytes;
        }
        self.length
    }
}

/// A text and then nothing.
fn padded<const N: usize>(text: &str) -> io::Result<[u8; N]> {
    let mut bytes = [0; N];
    let room = bytes.get_mut(..text.len()).ok_or(io::ErrorKind::InvalidInput)?;
    room.copy_from_slice(text.as_bytes());
    Ok(bytes)
}

const fn low_bits(bits: u32) -> u64 {
    u64::MAX >> (64 - bits)
}
