//! Exhaustive sweeps: what holds for every curve of narrow registers, and what does not.
//!
//! Whether a claim holds is decided in integers; decimals are for reading.
//!
//! | claim | sweep |
//! |---|---|
//! | D4 | arcs by digital integration end exactly, and always end: [`d4`] |
//! | D5 | how far the textbook's circle strays: [`d5`] |
//! | D6 | the centred staggered circle keeps one pulse: [`d6`], and for small radii [`d6_small`] |
//! | B2 | how far lines of the rate multiplier stray: [`b2`] |
//! | RUNS | whole runs of every machine against independent formulas: [`runs`] |
//!
//! Long sweeps are divided and resumed: `--shard 2/4 --resume part-2.txt` does a quarter and keeps
//! what is finished; afterwards `--resume part-1.txt --resume part-2.txt …` without a shard puts the
//! parts together.

pub mod b2;
mod command;
mod curve;
pub mod d4;
pub mod d5;
pub mod d6;
pub mod d6_small;
mod driver;
mod notes;
mod outcome;
mod rejected;
mod rings;
pub mod runs;
mod table;
mod tally;
mod walk;

pub use command::{Id, Options, run};
pub use curve::{Case, Curve};
pub use driver::{Driver, Shard};
pub use outcome::Outcome;
pub(crate) use outcome::described;
pub use table::Table;
pub use tally::{Fault, Share, Tally};
