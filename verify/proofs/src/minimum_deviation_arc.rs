//! Arc by minimum deviation: M1, the judgement. What does not depend on it: `circle.rs`.

use crate::judgement::{any_within, keeps_its_bounds};
use onepulse_core::circle::{Due, Judgement};
use onepulse_core::minimum_deviation::Nearest;

#[kani::proof]
fn minimum_deviation_arc_keeps_its_bounds() {
    let due = keeps_its_bounds::<Nearest>();
    kani::cover!(due == Due::Towards);
    kani::cover!(due == Due::Away);
    kani::cover!(due == Due::Both);
}

/// No other step that leads on would leave less of F: in whole numbers the least |F| is that of one step
/// alone.
#[kani::proof]
fn minimum_deviation_arc_judges_by_its_rule() {
    let (f, [t, a]) = any_within::<Nearest>();
    let in_towards = (f - 2 * t + 1).abs();
    let in_away = (f + 2 * a + 1).abs();
    let in_both = (f - 2 * t + 1 + 2 * a + 1).abs();
    let due = Nearest::due(f, [t, a]);
    kani::cover!(due == Due::Away);
    match due {
        Due::Towards => assert!(in_towards < in_away && in_towards < in_both),
        Due::Away => assert!(in_away < in_towards && in_away < in_both),
        Due::Both => assert!(in_both < in_towards && in_both < in_away),
    }
}

/// |F| ≤ max(t, a).
#[kani::proof]
fn minimum_deviation_arc_bounds_mean_deviation() {
    let (f, [t, a]) = any_within::<Nearest>();
    kani::cover!(f == t.max(a) && t > 2 && a > 2);
    assert!(f.abs() <= t.max(a));
}
