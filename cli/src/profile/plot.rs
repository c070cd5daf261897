//! The plots: one under the other, over the same time.

use super::Row;
use crate::failure::Failure;
use plotters::prelude::*;

/// Tells lines apart in print too, and for those who see colours differently (Okabe and Ito's set).
const COLOURS: [RGBColor; 2] = [RGBColor(0, 114, 178), RGBColor(213, 94, 0)];

const WIDTH: u32 = 900;
const HEIGHT_OF_ONE: u32 = 200;

/// What a quantity is over time: a line for each of its names.
struct Plot {
    quantity: &'static str,
    names: &'static [&'static str],
    /// Of a row, the value of each name.
    values: fn(&Row) -> [Option<f64>; 2],
}

const AXES: &[&str] = &["x", "y"];

const PLOTS: [Plot; 5] = [
    Plot { quantity: "speed, mm/s", names: &[""], values: |row| [Some(row.speed), None] },
    Plot {
        quantity: "acceleration, mm/s²",
        names: &[""],
        values: |row| [Some(row.acceleration), None],
    },
    Plot { quantity: "jerk, mm/s³", names: &[""], values: |row| [Some(row.jerk), None] },
    Plot { quantity: "pulse interval, s", names: AXES, values: |row| row.intervals },
    Plot {
        quantity: "following error, mm",
        names: AXES,
        values: |row| match row.following_errors {
            Some(errors) => errors.map(Some),
            None => [None; 2],
        },
    },
];

/// All quantities that the rows have.
pub(crate) fn svg(rows: &[Row]) -> Result<String, Failure> {
    let mut text = String::new();
    draw(rows, &mut text).map_err(|error| Failure::Fault(format!("the plot: {error}")))?;
    Ok(text)
}

fn draw(rows: &[Row], text: &mut String) -> Result<(), Box<dyn std::error::Error>> {
    let has_servo = rows.iter().any(|row| row.following_errors.is_some());
    let plots = if has_servo { &PLOTS[..] } else { &PLOTS[..4] };
    let size = (WIDTH, HEIGHT_OF_ONE * plots.len() as u32);
    let root = SVGBackend::with_string(text, size).into_drawing_area();
    root.fill(&WHITE)?;
    let last = rows.last().map_or(1.0, |row| row.time);
    for (plot, area) in plots.iter().zip(root.split_evenly((plots.len(), 1))) {
        let values = |row: &Row| (plot.values)(row).into_iter().flatten();
        let (low, high) = rows
            .iter()
            .flat_map(values)
            .fold((0.0_f64, 0.0_f64), |(low, high), v| (low.min(v), high.max(v)));
        // No room between them if nothing moves.
        let high = if high > low { high } else { low + 1.0 };
        let mut chart = ChartBuilder::on(&area)
            .margin(8)
            .x_label_area_size(28)
            .y_label_area_size(80)
            .build_cartesian_2d(0.0..last, low..high)?;
        chart
            .configure_mesh()
            .x_desc("s")
            .y_desc(plot.quantity)
            .y_labels(5)
            .light_line_style(TRANSPARENT)
            .draw()?;
        for (index, (name, colour)) in plot.names.iter().zip(COLOURS).enumerate() {
            let values = rows.iter().map(|row| Some((row.time, (plot.values)(row)[index]?)));
            let style = colour.stroke_width(1);
            let lines = unbroken(values).into_iter().map(|line| PathElement::new(line, style));
            let series = chart.draw_series(lines)?;
            if !name.is_empty() {
                series.label(*name).legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 16, y)], colour.stroke_width(2))
                });
            }
        }
        if plot.names.len() > 1 {
            chart
                .configure_series_labels()
                .position(SeriesLabelPosition::UpperRight)
                .background_style(WHITE)
                .border_style(BLACK)
                .draw()?;
        }
    }
    root.present()?;
    Ok(())
}

/// The points in lines, each as far as there is a value: where there is none, nothing is drawn.
fn unbroken(points: impl Iterator<Item = Option<(f64, f64)>>) -> Vec<Vec<(f64, f64)>> {
    let mut lines = vec![Vec::new()];
    for point in points {
        match (point, lines.last_mut()) {
            (Some(point), Some(line)) => line.push(point),
            (None, Some(line)) if !line.is_empty() => lines.push(Vec::new()),
            _ => {}
        }
    }
    lines.retain(|line| !line.is_empty());
    lines
}
