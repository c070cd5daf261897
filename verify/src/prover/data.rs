//! The module's data, where the texts of its panics and covers are.

use super::Error;

/// The stack is below the data. The harnesses' frames are small: what is deeper is a failed property.
pub(crate) const STACK_BYTES: u32 = 1024;

/// The bytes from the end of the stack on.
#[derive(Debug, Default)]
pub(crate) struct Data(Vec<u8>);

/// Where a panic is written, a `core::panic::Location`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Location {
    pub(crate) file: String,
    pub(crate) line: u32,
    pub(crate) column: u32,
}

impl Data {
    /// A segment of the module.
    pub(crate) fn add(&mut self, offset: u32, bytes: &[u8]) -> Result<(), Error> {
        let Some(start) = offset.checked_sub(STACK_BYTES) else {
            return Err(Error::Module(format!("data at {offset}, where the stack should be")));
        };
        let (start, end) = (start as usize, start as usize + bytes.len());
        if self.0.len() < end {
            self.0.resize(end, 0);
        }
        self.0[start..end].copy_from_slice(bytes);
        Ok(())
    }

    pub(crate) fn bytes(&self) -> &[u8] {
        &self.0
    }

    fn at(&self, address: u32, length: u32) -> Option<&[u8]> {
        let start = address.checked_sub(STACK_BYTES)? as usize;
        self.0.get(start..start.checked_add(length as usize)?)
    }

    /// The text of so many bytes at an address.
    pub(crate) fn text(&self, address: u32, length: u32) -> Option<String> {
        String::from_utf8(self.at(address, length)?.to_vec()).ok()
    }

    fn word(&self, address: u32) -> Option<u32> {
        Some(u32::from_le_bytes(self.at(address, 4)?.try_into().ok()?))
    }

    /// The location at an address: pointer and length of the file's name, line, column.
    pub(crate) fn location(&self, address: u32) -> Option<Location> {
        let [file, length, line, column] =
            [0, 4, 8, 12].map(|offset| self.word(address.checked_add(offset)?));
        Some(Location { file: self.text(file?, length?)?, line: line?, column: column? })
    }
}

impl std::fmt::Display for Location {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}
