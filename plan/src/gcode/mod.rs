//! NC programs in G-code (ISO 6983), as far as supported.
//!
//! Two styles: the textbooks' blocks without blanks whose integers are pulses
//! (`N3G01X-45000Y-75000F150`), and ordinary programs in millimetres or inches.
//!
//! | words | meaning |
//! |---|---|
//! | G00 G01 | rapid and feed along a line |
//! | G02 G03 | arc clockwise, counter-clockwise; centre by I J (from the start) or radius by R (negative: the longer way) |
//! | G17 | the XY plane |
//! | G20 G21 | inches, millimetres |
//! | G90 G91 | absolute, incremental coordinates |
//! | F | feed in units a minute |
//! | M02 M30 | end of program |
//! | N, (…), ;…, % | line number, comments, tape mark |
//!
//! Everything else is refused by name, line and column.

mod arc;
mod block;
mod centre;
mod modes;
mod program;
mod word;

pub use program::{Program, ProgramError};
