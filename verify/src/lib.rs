//! What the interpolators are checked against: the path of each method by a formula that is not
//! its recurrence.
//!
//! | module | formula |
//! |---|---|
//! | [`ppc_line`] | over column x the path rises to ⌈y_e·x/x_e⌉ |
//! | [`ppc_arc`] | over the column t before an axis the path rises to ⌈√(R² − t²)⌉ |
//! | [`dda_line`] | after k accumulations an axis has had ⌊(preset + k·J)/2ⁿ⌋ pulses |
//! | [`dda_arc`] | the same with the sum of the integrand over the path for k·J |
//! | [`brm_line`] | a stage whose first clock is 2^t has passed ⌊(k + 2^t)/2^(t+1)⌋ of k clocks |
//! | [`step_lines`] | minimum deviation: the nearest whole number; vectors: the first beyond the line; intervals: pulses by their times |
//!
//! The tests of this crate hold the machines of `onepulse-core` against them, exhaustively at
//! narrow widths and at random at full width.
//!
//! Beside them stand [`prover`], which holds the claims of `verify/claims.toml` to their harnesses and
//! writes the ledger; [`lemmas`], the mathematics, put to two solvers; [`sweep`], every curve of
//! narrow registers; and [`cosim`] and [`rtl_formal`], the circuits against their Verilog twins.

pub mod brm_line;
pub mod cosim;
pub mod dda_arc;
pub mod dda_line;
mod in_parallel;
mod lattice;
pub mod lemmas;
mod mutant;
pub mod ppc_arc;
pub mod ppc_line;
pub mod proof_mutants;
pub mod prover;
pub mod rtl_formal;
pub mod step_lines;
pub mod sweep;

pub use lattice::circles;
