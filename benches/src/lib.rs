//! What the benchmarks share: the curves, the plain loops and the simulated Verilog twins that they
//! are compared with, and a stopwatch that interleaves its runners.
//!
//! `cargo bench -p onepulse-benches` runs them. Absolute figures depend on the machine; the benches
//! `ratios` (software) and `circuits` (the hardware model) print every bar as a ratio to a peer
//! measured in the same run.

pub mod circuit;
pub mod loops;
pub mod stopwatch;
pub mod twin;

/// The line that is benchmarked: long, and at an angle that repeats late.
pub const LINE: [i32; 2] = [1_000_003, 618_034];

/// The radius of the circle that is benchmarked.
pub const RADIUS: i32 = 200_000;
