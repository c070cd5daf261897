//! Arc by vector discrimination: V1, the judgement. What does not depend on it: `circle.rs`.

use crate::judgement::{any_within, keeps_its_bounds};
use onepulse_core::circle::{Due, Judgement};
use onepulse_core::vector::Octant;

#[kani::proof]
fn vector_arc_keeps_its_bounds() {
    let due = keeps_its_bounds::<Octant>();
    kani::cover!(due == Due::Towards);
    kani::cover!(due == Due::Away);
    kani::cover!(due == Due::Both);
}

/// The smaller coordinate's axis always, the other one to get back over the circle.
#[kani::proof]
fn vector_arc_judges_by_its_rule() {
    let (f, [t, a]) = any_within::<Octant>();
    let due = Octant::due(f, [t, a]);
    kani::cover!(due == Due::Away);
    let leads_out = t > a;
    assert!(due != if leads_out { Due::Towards } else { Due::Away });
    assert!((due == Due::Both) == (leads_out == (f >= 0)));
}

/// −2m ≤ F < 2m, m = max(t, a).
#[kani::proof]
fn vector_arc_bounds_mean_deviation() {
    let (f, [t, a]) = any_within::<Octant>();
    kani::cover!(f == -2 * t.max(a) && t > 2 && a > 2);
    assert!(-2 * t.max(a) <= f && f < 2 * t.max(a));
}
