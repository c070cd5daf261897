//! The lattice circles of a ring, the unit of work in sweeps over all arcs.

use super::driver::Item;
use super::tally::Tally;
use super::walk::Drawing;
use onepulse_core::Direction;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Both senses.
pub(crate) const DIRECTIONS: [Direction; 2] = [Direction::Ccw, Direction::Cw];

/// The lattice points of every circle with `ring` ≤ R < `ring` + 1 and R² ≤ `most`, circle by circle
/// in the order of their radii.
pub(crate) fn circles(ring: i32, most: i64) -> BTreeMap<i64, Vec<[i32; 2]>> {
    let mut circles = BTreeMap::<i64, Vec<_>>::new();
    let [least, beyond] = [ring, ring + 1].map(|r| i64::from(r).pow(2));
    for x in -ring - 1..=ring + 1 {
        for y in -ring - 1..=ring + 1 {
            let square = i64::from(x).pow(2) + i64::from(y).pow(2);
            if (least..beyond).contains(&square) && square <= most {
                circles.entry(square).or_default().push([x, y]);
            }
        }
    }
    circles
}

/// One item a ring, for every arc with R² ≤ `most` between lattice points of one circle, in both
/// senses; `draw` draws one.
pub(crate) fn all_arcs(
    circuit: &str,
    bits: u32,
    most: i64,
    draw: impl Fn(&Drawing, &mut Tally) + Send + Sync + 'static,
) -> Vec<Item> {
    let draw = Arc::new(draw);
    let rings = 1..=most.isqrt() as i32;
    let item = |ring| {
        let draw = Arc::clone(&draw);
        Item::new(format!("{circuit} n={bits} R={ring}.."), move || {
            let mut tally = Tally::default();
            for circle in circles(ring, most).values() {
                for &start in circle {
                    for &end in circle {
                        for direction in DIRECTIONS {
                            draw(&Drawing { start, end, direction, bits, shift: 0 }, &mut tally);
                        }
                    }
                }
            }
            tally
        })
    };
    rings.map(item).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rings_hold_every_circle_once() {
        let mut together = BTreeMap::new();
        for ring in 1..=9 {
            for (square, circle) in circles(ring, 81) {
                assert_eq!(together.insert(square, circle), None);
            }
        }
        assert_eq!(together, crate::circles(9));
    }
}
