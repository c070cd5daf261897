//! A judgement of an arc that judges F, asked by itself: it is a function of F and two magnitudes, and
//! how a step carries it out is shown in `circle.rs`.

use onepulse_core::circle::{Due, Judgement};

/// Any F within the judgement's bounds, with the magnitudes of the coordinate that is fed towards zero
/// and of the one that is fed away from it: as the invariant has them while F decides.
#[inline(always)]
pub(crate) fn any_within<J: Judgement>() -> (i64, [i64; 2]) {
    let [t, a] = kani::any::<[u32; 2]>().map(i64::from);
    // More than the bounds of any judgement.
    let f = kani::any_where(|f: &i64| f.unsigned_abs() <= 1 << 62);
    kani::assume(t >= 1 && t.max(a) <= 1 << 31);
    kani::assume(J::is_within(f, [t, a]) && (t > 1 || a > 0 || f <= 0));
    (f, [t, a])
}

/// At the start of an arc F is 0. What is due keeps F within the bounds, and does not lead to the centre;
/// where it leads to an axis the two magnitudes change their roles.
#[inline(always)]
pub(crate) fn keeps_its_bounds<J: Judgement>() -> Due {
    let (f, [t, a]) = any_within::<J>();
    assert!(J::is_within(0, [t, a]));
    let due = J::due(f, [t, a]);
    let (in_t, in_a) = (f - 2 * t + 1, 2 * a + 1);
    let (f, [t, a]) = match due {
        Due::Towards => (in_t, [t - 1, a]),
        Due::Away => (f + in_a, [t, a + 1]),
        Due::Both => (in_t + in_a, [t - 1, a + 1]),
    };
    assert!(J::is_within(f, [t, a]) && J::is_within(f, [a, t]));
    assert!(t != 0 || a != 0);
    due
}
