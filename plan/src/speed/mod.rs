//! Acceleration before interpolation (前加减速): how fast the tool is on its way along the program, known
//! before any point is made, so that the path stays what was programmed.
//!
//! A program becomes samples in three steps, each an iterator over the one before:
//!
//! | | |
//! |---|---|
//! | [`Block`] | as the speed sees it: its length, its steady speed (稳定速度), its directions at both ends |
//! | [`LookAhead`] | speeds at the corners, each low enough for what follows; a [`Profile`] for each block |
//! | [`Samples`] | instantaneous speed (瞬时速度) and way at each sample period and each block's end |
//!
//! and a [`Path`] turns the ways into points. [`Limits`] says what the machine bears. Lengths are
//! millimetres, times seconds.
//!
//! The textbooks go by increments: each period the speed grows or falls by a·T, f_{i+1} = f_i ± a·T; when
//! what is left of the block is no more than s = (f_i² − f_e²)/(2a), the deceleration point (减速点) is
//! reached; and when it is no more than one step, that is the block end (终点判别). Both tests are made once
//! a period: braking begins up to a period off its place, and the last step is whatever is left, in
//! which the speed dips. Here the same quantities are solved for as times: a [`Profile`] knows when
//! it begins to brake and when it ends, and the samples read it on one grid of periods that runs on
//! through all blocks. So every block ends exactly at its length with its exit speed, whatever the
//! period.
//!
//! ```
//! use onepulse_plan::speed::{Block, Limits, LookAhead, Path, Samples};
//! use onepulse_plan::centre_path::{CentrePath, Compensation, Step};
//! use onepulse_plan::{Machine, Motion, Tools, gcode::Program};
//!
//! let machine = Machine::with_pulse("0.001".parse()?);
//! let limits = Limits::new(1000.0, Some(20_000.0), 5.0, 500.0)?;
//! let program = "G91 G01 F3000\nX10.\nG03 X5. Y5. J5.\nG01 Y10.\n";
//! let program = Program::new(program.as_bytes(), &machine, &Tools::Unknown);
//! let mut motions: Vec<Motion> = Vec::new();
//! for step in CentrePath::new(program, &machine, Compensation::default()) {
//!     if let Step::Move(step) = step? {
//!         motions.extend(step.motions());
//!     }
//! }
//! let blocks: Vec<_> =
//!     motions.iter().map(|motion| Block::of(motion, &machine, &limits)).collect::<Result<_, _>>()?;
//! let paths: Vec<_> =
//!     motions.iter().map(|motion| Path::of(motion, machine.pulse)).collect::<Result<_, _>>()?;
//!
//! let samples: Vec<_> = Samples::new(LookAhead::new(blocks, limits), 0.008)?.collect();
//! // The corners are tangent, so nothing stops before the end.
//! assert!(samples.iter().all(|sample| sample.speed > 0.0 || sample.block == 2));
//! let points: Vec<_> = samples.iter().map(|sample| paths[sample.block].point(sample.way)).collect();
//! assert_eq!(points.last(), Some(&[15.0, 15.0, 0.0]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod block;
mod error;
mod limits;
mod look_ahead;
mod path;
mod profile;
mod ramp;
mod samples;

pub use block::Block;
pub use error::{Quantity, SpeedError};
pub use limits::Limits;
pub use look_ahead::{AHEAD, LookAhead};
pub use path::Path;
pub use profile::{Profile, State};
pub use samples::{Sample, Samples};
