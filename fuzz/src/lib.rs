//! The bodies of the fuzz targets are those of the tests: [plan/tests/promises](../../plan/tests/promises).

#[path = "../../plan/tests/promises/mod.rs"]
mod promises;

#[path = "../../plan/tests/promises/drawn.rs"]
mod drawn;

use drawn::Case;

/// A machine and the text of a program: it is read to its end.
pub fn program(data: &[u8]) {
    if let Some(case) = Case::program(data) {
        case.check();
    }
}

/// A program drawn block by block: its path keeps its promises, if it is accepted.
pub fn path(data: &[u8]) {
    if let Some(case) = Case::path(data) {
        case.check();
    }
}
