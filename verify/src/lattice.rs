//! The lattice points of circles about the origin.

use std::collections::BTreeMap;

/// The lattice points of every circle about the origin with a radius of 1 to `radius`, circle by
/// circle, in the order of their squared radii.
#[must_use]
pub fn circles(radius: i32) -> BTreeMap<i64, Vec<[i32; 2]>> {
    let most = i64::from(radius).pow(2);
    let mut circles = BTreeMap::<i64, Vec<_>>::new();
    for x in -radius..=radius {
        for y in -radius..=radius {
            let square = i64::from(x).pow(2) + i64::from(y).pow(2);
            if (1..=most).contains(&square) {
                circles.entry(square).or_default().push([x, y]);
            }
        }
    }
    circles
}
