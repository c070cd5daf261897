//! Arcs by point-by-point comparison whose end point need not lie on their circle.

use super::{Machine, demand, path};
use crate::sweep::driver::Item;
use crate::sweep::rings::DIRECTIONS;
use crate::sweep::tally::Tally;
use crate::sweep::walk::Drawing;
use onepulse_core::{Direction, EndRule, ppc};

const NAME: &str = "PPC to any end point";

/// Start coordinates are −6 … 6, end coordinates −8 … 8.
const START: i32 = 6;
const END: i32 = 8;

pub(super) fn machine() -> Machine {
    let item = |x: i32| {
        Item::new(format!("{NAME} x={x}"), move || {
            let mut tally = Tally::default();
            for y in (-START..=START).filter(|&y| [x, y] != [0, 0]) {
                for end in (-END..=END).flat_map(|x| (-END..=END).map(move |y| [x, y])) {
                    for direction in DIRECTIONS.into_iter().filter(|_| end != [0, 0]) {
                        draw([x, y], end, direction, &mut tally);
                    }
                }
            }
            tally
        })
    };
    let items = (-START..=START).map(item).collect();
    Machine { name: NAME.to_owned(), bound: "exact end, the closed form's steps", items }
}

/// (No deviation is taken: the straight way out to the end point leaves the circle.)
fn draw(start: [i32; 2], end: [i32; 2], direction: Direction, tally: &mut Tally) {
    let curve = Drawing { start, end, direction, bits: 0, shift: 0 }.curve();
    tally.curves += 1;
    let arc = match ppc::Arc::new(start, end, direction, EndRule::Total) {
        Ok(arc) => arc,
        Err(why) => return tally.fault(curve, 0, why.to_string()),
    };
    let walked = path(start.map(i64::from), arc, arc.remaining() as usize);
    let steps = walked.len() as u64 - 1;
    tally.cycles += steps;
    let is_exact = walked.last() == Some(&end.map(i64::from));
    let checked = demand(is_exact, || "misses its end point".to_owned())
        .and_then(|()| demand(arc.remaining() == steps, || format!("takes {steps} steps")));
    if let Err(why) = checked {
        tally.fault(curve, 0, why);
    }
}
