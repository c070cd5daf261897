//! Arcs by point-by-point comparison, between lattice points of one circle.

use super::{Machine, demand, path, take};
use crate::ppc_arc;
use crate::sweep::curve::Case;
use crate::sweep::rings::all_arcs;
use crate::sweep::tally::Tally;
use crate::sweep::walk::Drawing;
use onepulse_core::{EndRule, ppc};

const NAME: &str = "PPC arcs";

pub(super) fn machine(radius: i32) -> Machine {
    let bound = "(R−1)² ≤ x² + y² ≤ (R+1)², the closed form's steps";
    let items = all_arcs(NAME, 0, i64::from(radius).pow(2), draw);
    Machine { name: NAME.to_owned(), bound, items }
}

fn draw(drawing: &Drawing, tally: &mut Tally) {
    let Drawing { start, end, direction, bits, .. } = *drawing;
    let curve = drawing.curve();
    let arc = match ppc::Arc::new(start, end, direction, EndRule::Total) {
        Ok(arc) => arc,
        Err(why) => return tally.fault(curve, bits, why.to_string()),
    };
    let walked = path(start.map(i64::from), arc, arc.remaining() as usize);
    let steps = walked.len() - 1;
    let leaves =
        |point: &&[i64; 2]| Case { curve, bits, cycle: 0, point: **point }.leaves_one_pulse();
    let checked =
        demand(walked.last() == Some(&end.map(i64::from)), || "misses its end point".to_owned())
            .and_then(|()| {
                demand(arc.remaining() == steps as u64, || format!("takes {steps} steps"))
            })
            .and_then(|()| match walked.iter().find(leaves) {
                Some([x, y]) => Err(format!("leaves the pulse at {x},{y}")),
                None => Ok(()),
            })
            .and_then(|()| {
                let follows = walked[1..] == ppc_arc::path(start, end, direction);
                demand(follows, || "is not the path of the formula".to_owned())
            });
    take(tally, curve, bits, &walked, checked);
}
