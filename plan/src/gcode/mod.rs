//! NC programs in G-code (ISO 6983), as far as supported.
//!
//! Two styles: the textbooks' blocks without blanks whose integers are pulses
//! (`N3G01X-45000Y-75000F150`), and ordinary programs in millimetres or inches.
//!
//! | words | meaning |
//! |---|---|
//! | G00 G01 | rapid and feed along a line, X Y Z |
//! | G02 G03 | arc clockwise, counter-clockwise; centre from the start by I J K, or radius by R (negative: the longer way); equal ends: a full circle |
//! | G04 | dwell of P (or X) seconds |
//! | G17 G18 G19 | the plane of arcs and compensation: XY, ZX, YZ |
//! | G20 G21 | inches, millimetres |
//! | G40 G41 G42 | cutter radius compensation off, left and right of the path |
//! | G90 G91 | absolute, incremental coordinates |
//! | F | feed in units a minute |
//! | S T | spindle speed in turns a minute, tool |
//! | D | the tool whose radius counts; that of T if there is none |
//! | M00 | stop until the operator goes on |
//! | M02 M30 | end of program |
//! | N, / | line number, block that may be left out |
//! | (…), ;…, % | comments, tape mark |
//!
//! Each of these lines but the last three and F S T D is a modal group: a block takes one word of it. Everything
//! else is refused by name, line and column, and all that is wrong with a program in one pass.
//!
//! The radii at the start and the end of an arc may differ by 5 µm, or two pulses if that is more: it
//! then runs on the circle through its start, and still ends on its end point. A compensated arc runs on the
//! circle through both points whose centre is nearest.

mod arc;
mod block;
mod centre;
mod modes;
mod program;
mod step;
mod word;

pub(crate) use arc::ProgrammedArc;
pub(crate) use modes::{in_pulses, too_far};
pub use program::{MOST_ERRORS, Program, ProgramError};
pub use step::{Cutter, Move, Pause, Phase, Step};
pub(crate) use word::{Fault, Number, Words};
