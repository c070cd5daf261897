//! The quantities of a profile over time.

use super::Row;
use crate::failure::Failure;
use crate::plots::{self, Plot, Point};

/// All quantities that the rows have.
pub(crate) fn svg(rows: &[Row]) -> Result<String, Failure> {
    let over_time = |value: &dyn Fn(&Row) -> Option<f64>| -> Vec<Point> {
        rows.iter().map(|row| Some((row.time, value(row)?))).collect()
    };
    let along = |quantity, value: fn(&Row) -> f64| Plot {
        quantity,
        curves: vec![("", over_time(&|row| Some(value(row))))],
    };
    let by_axis = |quantity, values: fn(&Row) -> [Option<f64>; 2]| {
        let curve = |axis: usize| over_time(&move |row| values(row)[axis]);
        Plot { quantity, curves: vec![("x", curve(0)), ("y", curve(1))] }
    };
    let mut plots = vec![
        along("speed, mm/s", |row| row.speed),
        along("acceleration, mm/s²", |row| row.acceleration),
        along("jerk, mm/s³", |row| row.jerk),
        by_axis("pulse interval, s", |row| row.intervals),
    ];
    if rows.iter().any(|row| row.following_errors.is_some()) {
        // A block's end between two periods has none.
        let rows: Vec<Row> =
            rows.iter().filter(|row| row.following_errors.is_some()).copied().collect();
        let curve = |axis: usize| {
            let errors = rows.iter();
            errors.map(|row| Some((row.time, row.following_errors?[axis]))).collect()
        };
        plots.push(Plot {
            quantity: "following error, mm",
            curves: vec![("x", curve(0)), ("y", curve(1))],
        });
    }
    plots::svg(&plots, "s")
}
