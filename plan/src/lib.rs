//! Planning: from the text of an NC program to curves in whole pulses.
//!
//! [`gcode`] reads the program, block by block. [`centre_path`] makes of it the path of the cutter's centre,
//! with the geometry of [`compensation`], in whole pulses. The other way of interpolating, in millimetres
//! and seconds, is that of the loops closed by software: [`speed`] plans the acceleration through a whole
//! program, [`sampling`] makes the points of a line or an arc at a constant feed, [`after_interpolation`]
//! gives the axes their ramps, and [`servo`] says what the axes make of it.
//!
//! ```
//! use onepulse_plan::centre_path::{CentrePath, Compensation};
//! use onepulse_plan::{Curve, Machine, Tools, gcode::Program};
//!
//! let text = "G90 G21\nG01 X10.5 Y-2.25 F300\nM02\n";
//! let machine = Machine::with_pulse("0.01".parse()?);
//! let program = Program::new(text.as_bytes(), &machine, &Tools::Unknown);
//! let path = CentrePath::new(program, &machine, Compensation::default());
//! let motions: Vec<_> = path.motions().collect::<Result<_, _>>()?;
//! assert_eq!(motions[0].to, [1050, -225, 0]);
//! assert_eq!(motions[0].curve, Curve::Line);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod after_interpolation;
pub mod centre_path;
pub mod compensation;
mod diagnostic;
pub mod gcode;
mod length;
mod machine;
mod motion;
pub mod sampling;
pub mod servo;
pub mod speed;
mod tools;

pub use diagnostic::{Diagnostic, Place};
pub use length::{Length, LengthError};
pub use machine::{Integers, Machine};
pub use motion::{Curve, Motion, Rate};
pub use tools::{ToolTable, Tools};
