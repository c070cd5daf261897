//! The quantities of a profile over time.

use super::Row;
use crate::failure::Failure;
use crate::plots::{self, Plot, Point};
use crate::pulses::AXES;

/// All quantities that the rows have, of so many axes.
pub(crate) fn svg(rows: &[Row], axes: usize) -> Result<String, Failure> {
    let over_time = |value: &dyn Fn(&Row) -> Option<f64>| -> Vec<Point> {
        rows.iter().map(|row| Some((row.time, value(row)?))).collect()
    };
    let along = |quantity, value: fn(&Row) -> f64| Plot {
        quantity,
        curves: vec![("", over_time(&|row| Some(value(row))))],
    };
    let of_axes = |quantity, curve: &dyn Fn(usize) -> Vec<Point>| {
        let curves = AXES[..axes].iter().enumerate();
        Plot { quantity, curves: curves.map(|(axis, name)| (*name, curve(axis))).collect() }
    };
    let mut plots = vec![
        along("speed, mm/s", |row| row.speed),
        along("acceleration, mm/s²", |row| row.acceleration),
        along("jerk, mm/s³", |row| row.jerk),
        of_axes("pulse interval, s", &|axis| over_time(&|row| row.intervals[axis])),
    ];
    if rows.iter().any(|row| row.following_errors.is_some()) {
        // A block's end between two periods has none.
        let rows: Vec<Row> =
            rows.iter().filter(|row| row.following_errors.is_some()).copied().collect();
        plots.push(of_axes("following error, mm", &|axis| {
            let errors = rows.iter();
            errors.map(|row| Some((row.time, row.following_errors?[axis]))).collect()
        }));
    }
    plots::svg(&plots, "s")
}
