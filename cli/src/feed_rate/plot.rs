//! The plot.

use super::Curves;
use crate::failure::Failure;
use plotters::prelude::*;

/// Tells lines apart in print too, and for those who see colours differently (Okabe and Ito's set).
const COLOURS: [RGBColor; 4] =
    [RGBColor(0, 114, 178), RGBColor(213, 94, 0), RGBColor(0, 158, 115), RGBColor(204, 121, 167)];

pub(super) fn svg(curves: &Curves) -> Result<String, Failure> {
    let mut text = String::new();
    draw(curves, &mut text).map_err(|error| Failure::Fault(format!("the plot: {error}")))?;
    Ok(text)
}

fn draw(curves: &Curves, text: &mut String) -> Result<(), Box<dyn std::error::Error>> {
    let last = curves.rows.last().map_or(0.0, |(quantity, _)| *quantity);
    let root = SVGBackend::with_string(text, (800, 480)).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .caption(curves.title, ("sans-serif", 20))
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(56)
        .build_cartesian_2d(0.0..last, 0.0..1.05)?;
    chart
        .configure_mesh()
        .x_desc(curves.over)
        .y_desc("v/v_max")
        .light_line_style(TRANSPARENT)
        .draw()?;
    for (index, (name, colour)) in curves.names.iter().zip(COLOURS).enumerate() {
        let points = curves.rows.iter().map(|(quantity, ratios)| (*quantity, ratios[index]));
        chart
            .draw_series(LineSeries::new(points, colour.stroke_width(2)))?
            .label(*name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 20, y)], colour.stroke_width(2)));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerRight)
        .background_style(WHITE)
        .border_style(BLACK)
        .draw()?;
    root.present()?;
    Ok(())
}
