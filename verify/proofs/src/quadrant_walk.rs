//! What the two arcs by digital integration have in common: a sweep, a point in the quadrant that
//! it says, and how far it is from being done.

use crate::any::{any_direction, any_sweep};
use onepulse_core::{Feed, Feeds, Sweep};

/// A sweep and a point on its way: in the quadrant, where the coordinate that is fed towards zero
/// has not come there yet, or in the last quadrant wherever an end point off the circle leads.
pub(crate) fn any_place() -> (Sweep, [i64; 2]) {
    let sweep = any_sweep();
    let position = kani::any::<[i32; 2]>().map(i64::from);
    let Feeds { towards, away } = sweep.feeds();
    let (t, a) = (towards.axis.of(position), away.axis.of(position));
    kani::assume(is_side(towards, t, -1) && is_side(away, a, 1));
    kani::assume(t != 0 || sweep.crossings_left() == 0);
    (sweep, position)
}

/// The sweep from any start that has a circle to any end that has a direction, and the start. Of the
/// radius no more is known than that no coordinate of the start exceeds it.
pub(crate) fn any_start() -> (Sweep, [i32; 2]) {
    let (start, end): ([i32; 2], [i32; 2]) = (kani::any(), kani::any());
    let radius = kani::any_where(|radius: &i32| *radius >= 1);
    kani::assume(start.map(|c| i64::from(c).abs()).iter().all(|c| *c <= i64::from(radius)));
    let rounded_up = u64::from(radius.unsigned_abs());
    match Sweep::with_given_roots(start, end, any_direction(), i64::from(radius), rounded_up) {
        Ok(sweep) => (sweep, start),
        Err(_) => {
            kani::assume(false);
            unreachable!("the centre is no start and no end")
        }
    }
}

/// Whether a coordinate is zero, or on the side that its feed comes from (−1) or leads to (1).
fn is_side(feed: Feed, coordinate: i64, side: i64) -> bool {
    coordinate == 0 || (coordinate > 0) == (i64::from(feed.sign) == side)
}

/// Whether the place is one that [`any_place`] may give.
pub(crate) fn is_place(sweep: &Sweep, position: [i64; 2]) -> bool {
    let Feeds { towards, away } = sweep.feeds();
    let (t, a) = (towards.axis.of(position), away.axis.of(position));
    is_side(towards, t, -1)
        && is_side(away, a, 1)
        && (t != 0 || sweep.crossings_left() == 0)
        && sweep.invariant()
}

/// How far an arc is from its end, the most important first: a step makes it less, in the order of
/// the dictionary, and so an arc ends from wherever it is.
///
/// 1. quadrants to go;
/// 2. how many axes have not come to stand;
/// 3. pulses to go of the axis that the progress is measured by: of the one fed towards zero, or if
///    that one stands, of both;
/// 4. whether that axis has nothing to add yet, because the other coordinate is zero;
/// 5. what the remainder that grows is short of its next pulse, which it gets by at least 1 a cycle
///    (but for the steps straight to an end point off the circle, which are progress of the third
///    kind).
pub(crate) fn distance(
    sweep: &Sweep,
    position: [i64; 2],
    short_of_pulse: impl Fn(Feed) -> u64,
) -> [u64; 5] {
    let Feeds { towards, away } = sweep.feeds();
    let (t, a) = (towards.axis.of(position), away.axis.of(position));
    let (t_end, a_end) = (towards.axis.of(sweep.end()), away.axis.of(sweep.end()));
    let [x_stands, y_stands] = sweep.stands(position);
    let (t_stands, a_stands) =
        (towards.axis.of([x_stands, y_stands]), away.axis.of([x_stands, y_stands]));
    let quadrants = u64::from(sweep.crossings_left());
    let going = u64::from(!t_stands) + u64::from(!a_stands);
    let (to_go, waits, grows) = if t_stands {
        (t.abs_diff(t_end) + a.abs_diff(a_end), false, away)
    } else if a == 0 {
        (t.unsigned_abs(), true, away)
    } else {
        (t.unsigned_abs(), false, towards)
    };
    [quadrants, going, to_go, u64::from(waits), short_of_pulse(grows)]
}

/// Whether one distance comes before another in the order of the dictionary.
pub(crate) fn is_less(left: [u64; 5], right: [u64; 5]) -> bool {
    let mut is_less = false;
    for place in (0..5).rev() {
        is_less = left[place] < right[place] || left[place] == right[place] && is_less;
    }
    is_less
}
