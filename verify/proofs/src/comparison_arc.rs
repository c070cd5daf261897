//! Arc by comparison integration: C1, the judgement. What does not depend on it: `circle.rs`.

use crate::judgement::{any_within, keeps_its_bounds};
use onepulse_core::circle::{Due, Judgement};
use onepulse_core::comparison::Interval;

#[kani::proof]
fn comparison_arc_keeps_its_bounds() {
    let due = keeps_its_bounds::<Interval>();
    kani::cover!(due == Due::Towards);
    kani::cover!(due == Due::Away);
    kani::cover!(due == Due::Both);
}

/// The axis of which the pulse is due first: past intervals and half of the present one differ by
/// (−2F + (2t − 1) − (2a + 1))/4, which is below zero where F > t − a − 1.
#[kani::proof]
fn comparison_arc_judges_by_its_rule() {
    let (f, [t, a]) = any_within::<Interval>();
    let due = Interval::due(f, [t, a]);
    kani::cover!(due == Due::Both);
    let level = t - a - 1;
    assert!((due != Due::Away) == (f >= level) && (due != Due::Towards) == (f <= level));
}

/// |F| ≤ t + a.
#[kani::proof]
fn comparison_arc_bounds_mean_deviation() {
    let (f, [t, a]) = any_within::<Interval>();
    kani::cover!(f == -t - a && t > 2 && a > 2);
    assert!(f.abs() <= t + a);
}
