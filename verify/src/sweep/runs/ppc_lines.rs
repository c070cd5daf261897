//! Lines by point-by-point comparison.

use super::{Machine, demand, every_end, path, take};
use crate::ppc_line;
use crate::sweep::curve::Curve;
use crate::sweep::tally::Tally;
use onepulse_core::{EndRule, ppc};

const NAME: &str = "PPC lines";

pub(super) fn machine(most: i32) -> Machine {
    let bound = "≤ 1, a step for each pulse";
    Machine { name: NAME.to_owned(), bound, items: every_end(NAME, most, draw) }
}

fn draw(end: [i32; 2], tally: &mut Tally) {
    for rule in [EndRule::Total, EndRule::PerAxis] {
        let to = end.map(i64::from);
        let line = ppc::Line::new(end, rule);
        let longest = end.iter().map(|c| c.unsigned_abs() as usize).sum();
        let walked = line.map(|line| path([0, 0], line, longest)).unwrap_or_else(|_| vec![[0, 0]]);
        let checked = check(to, &walked).and_then(|()| {
            let follows = walked[1..].iter().copied().eq(ppc_line::path(end));
            demand(follows, || "is not the path of the formula".to_owned())
        });
        take(tally, Curve::Line { end: to }, 0, &walked, checked);
    }
}

fn check([xe, ye]: [i64; 2], walked: &[[i64; 2]]) -> Result<(), String> {
    let steps = walked.len() as i64 - 1;
    demand(steps == xe.abs() + ye.abs(), || format!("takes {steps} steps"))?;
    demand(walked.last() == Some(&[xe, ye]), || "misses its end point".to_owned())?;
    // |F|/L ≤ 1, squared.
    let strays = |&&[x, y]: &&[i64; 2]| (xe * y - ye * x).pow(2) > xe * xe + ye * ye;
    match walked.iter().find(strays) {
        Some([x, y]) => Err(format!("leaves the pulse at {x},{y}")),
        None => Ok(()),
    }
}
