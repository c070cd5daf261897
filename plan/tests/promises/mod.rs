//! What holds of every program, whatever it is: one body for tests and fuzz targets.

mod distance;
pub(crate) mod path;
pub(crate) mod program;
