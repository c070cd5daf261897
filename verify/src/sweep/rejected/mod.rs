//! Circuits for circles that were tried and rejected: small models, to measure what each lacks.

mod accumulator;
mod centred_without_headroom;
mod simultaneous_up_down;
mod staggered_full_load;
mod tracker;
mod uncentred_staggered;

pub(crate) use centred_without_headroom::CentredWithoutHeadroom;
pub(crate) use simultaneous_up_down::SimultaneousUpDown;
pub(crate) use staggered_full_load::StaggeredFullLoad;
pub(crate) use uncentred_staggered::UncentredStaggered;
