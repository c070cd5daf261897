//! Lines by minimum deviation, vector discrimination and comparison integration.

use super::{Machine, demand, every_end, path, take};
use crate::step_lines;
use crate::sweep::curve::Curve;
use crate::sweep::tally::Tally;
use onepulse_core::{Error, Pulse, comparison, minimum_deviation, vector};

pub(super) fn machines(most: i32) -> [Machine; 3] {
    let machine = |name: &str, bound, draw: fn([i32; 2], &mut Tally)| {
        let items = every_end(name, most, draw);
        Machine { name: name.to_owned(), bound, items }
    };
    [
        machine(
            "minimum deviation lines",
            "≤ ½ along the shorter axis, a step for each pulse of the longer",
            |end, tally| {
                let [a, _] = lengths(end);
                let points = (1..=a).map(|k| step_lines::nearest(end, k as u64)).collect();
                draw(end, minimum_deviation::Line::new(end), points, a, tally);
            },
        ),
        machine(
            "vector lines",
            "< 1 along the shorter axis, a step for each pulse of the longer",
            |end, tally| {
                let [a, b] = lengths(end);
                let points = (1..=a).map(|k| step_lines::by_vectors(end, k as u64)).collect();
                draw(end, vector::Line::new(end), points, 2 * (a - b).max(b - 1), tally);
            },
        ),
        machine("comparison lines", "≤ (x_e + y_e − 1)/2L", |end, tally| {
            let [a, b] = lengths(end);
            let points = step_lines::by_intervals(end).collect();
            draw(end, comparison::Line::new(end), points, a + b - 1, tally);
        }),
    ]
}

/// The lengths of the longer axis and the shorter one.
fn lengths([x, y]: [i32; 2]) -> [i64; 2] {
    [x.abs().max(y.abs()), x.abs().min(y.abs())].map(i64::from)
}

/// One line: its points are the expected ones, and 2·|F| is `bound` at most, 0 on an axis.
fn draw(
    end: [i32; 2],
    line: Result<impl Iterator<Item = Pulse>, Error>,
    expected: Vec<[i64; 2]>,
    bound: i64,
    tally: &mut Tally,
) {
    let [xe, ye] = end.map(i64::from);
    let curve = Curve::Line { end: [xe, ye] };
    let line = match line {
        Ok(line) => line,
        Err(why) => return tally.fault(curve, 0, why.to_string()),
    };
    let walked = path([0, 0], line, expected.len());
    let bound = if xe == 0 || ye == 0 { 0 } else { bound };
    let strays = |&&[x, y]: &&[i64; 2]| 2 * (xe * y - ye * x).abs() > bound;
    let checked = demand(walked.last() == Some(&[xe, ye]), || "misses its end point".to_owned())
        .and_then(|()| match walked.iter().find(strays) {
            Some([x, y]) => Err(format!("leaves its bound at {x},{y}")),
            None => Ok(()),
        })
        .and_then(|()| {
            demand(walked[1..] == expected, || "is not the path of the formula".to_owned())
        });
    take(tally, curve, 0, &walked, checked);
}
