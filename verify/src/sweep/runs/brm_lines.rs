//! Lines of the rate multiplier.

use super::{Machine, demand, every_end, path, take};
use crate::brm_line;
use crate::sweep::curve::Curve;
use crate::sweep::tally::Tally;
use onepulse_core::brm;

const NAME: &str = "BRM lines";

pub(super) fn machine(bits: u32) -> Machine {
    let draw = move |end, tally: &mut Tally| draw(end, bits, tally);
    let items = every_end(NAME, (1 << bits) - 1, draw);
    Machine { name: NAME.to_owned(), bound: "as many pulses as the values, 2ⁿ clocks", items }
}

fn draw(end: [i32; 2], bits: u32, tally: &mut Tally) {
    let to = end.map(i64::from);
    let curve = Curve::Line { end: to };
    match brm::Line::new(end, bits) {
        Ok(line) => {
            let walked = path([0, 0], line, 1 << bits);
            take(tally, curve, bits, &walked, check(to, bits, &walked));
        }
        Err(why) => tally.fault(curve, bits, why.to_string()),
    }
}

fn check(end: [i64; 2], bits: u32, walked: &[[i64; 2]]) -> Result<(), String> {
    let clocks = walked.len() as u64 - 1;
    demand(clocks == 1 << bits, || format!("takes {clocks} clocks"))?;
    for axis in 0..2 {
        let pulses = walked.windows(2).filter(|pair| pair[0][axis] != pair[1][axis]).count();
        let value = end[axis].unsigned_abs();
        demand(pulses as u64 == value, || format!("has {pulses} pulses for {value}"))?;
        for (k, point) in walked.iter().enumerate() {
            let due = brm_line::pulses(value, bits, k as u64) as i64 * end[axis].signum();
            demand(point[axis] == due, || format!("is at {} after {k} clocks", point[axis]))?;
        }
    }
    demand(walked.last() == Some(&end), || "misses its end point".to_owned())
}
