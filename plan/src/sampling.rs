//! Data sampling: the way of one sample period.

use crate::Length;

/// The step f = v·T: the way, in millimetres, of one sample period of `period_s` seconds at a
/// feed of so much a minute. (FANUC 7M: T = 8 ms, f = 2v/15 µm with v in mm/min.)
#[must_use]
pub fn step(feed: Length, period_s: f64) -> f64 {
    feed.millimetres() / 60.0 * period_s
}
