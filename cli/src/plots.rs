//! Plots over the same quantity, one under the other.

use crate::failure::Failure;
use clap::ValueEnum;
use plotters::prelude::*;

/// How what can be plotted is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Comma separated values
    #[default]
    Csv,
    /// A plot
    Svg,
}

/// Tells lines apart in print too, and for those who see colours differently (Okabe and Ito's set).
const COLOURS: [RGBColor; 3] = [RGBColor(0, 114, 178), RGBColor(213, 94, 0), RGBColor(0, 158, 115)];

const WIDTH: u32 = 900;
const HEIGHT_OF_ONE: u32 = 200;

/// One plot: a quantity over another, up to three curves.
#[derive(Debug)]
pub(crate) struct Plot {
    /// With its unit.
    pub(crate) quantity: &'static str,
    /// With a name each; a single one needs none.
    pub(crate) curves: Vec<(&'static str, Vec<Point>)>,
}

/// A point of a curve; where there is none the curve is broken.
pub(crate) type Point = Option<(f64, f64)>;

/// The plots as SVG; `over` is what all of them run over, with its unit.
pub(crate) fn svg(plots: &[Plot], over: &str) -> Result<String, Failure> {
    let mut text = String::new();
    draw(plots, over, &mut text).map_err(|error| Failure::Fault(format!("the plot: {error}")))?;
    Ok(text)
}

fn draw(plots: &[Plot], over: &str, text: &mut String) -> Result<(), Box<dyn std::error::Error>> {
    let size = (WIDTH, HEIGHT_OF_ONE * plots.len() as u32);
    let root = SVGBackend::with_string(text, size).into_drawing_area();
    root.fill(&WHITE)?;
    let last = plots.iter().flat_map(points).fold(0.0_f64, |most, (at, _)| most.max(at));
    let last = if last > 0.0 { last } else { 1.0 };
    for (plot, area) in plots.iter().zip(root.split_evenly((plots.len(), 1))) {
        let range =
            |(low, high): (f64, f64), (_, value): (_, f64)| (value.min(low), value.max(high));
        let (low, high) = points(plot).fold((0.0, 0.0), range);
        // No room between them if nothing moves.
        let high = if high > low { high } else { low + 1.0 };
        let mut chart = ChartBuilder::on(&area)
            .margin(8)
            .x_label_area_size(28)
            .y_label_area_size(80)
            .build_cartesian_2d(0.0..last, low..high)?;
        chart
            .configure_mesh()
            .x_desc(over)
            .y_desc(plot.quantity)
            .y_labels(5)
            .light_line_style(TRANSPARENT)
            .draw()?;
        for ((name, points), colour) in plot.curves.iter().zip(COLOURS) {
            let style = colour.stroke_width(1);
            let lines = unbroken(points).into_iter().map(|line| PathElement::new(line, style));
            let series = chart.draw_series(lines)?;
            series.label(*name).legend(move |(x, y)| {
                PathElement::new([(x, y), (x + 16, y)], colour.stroke_width(2))
            });
        }
        if plot.curves.len() > 1 {
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

fn points(plot: &Plot) -> impl Iterator<Item = (f64, f64)> {
    plot.curves.iter().flat_map(|(_, points)| points.iter().flatten().copied())
}

/// The points in lines, each as far as it is not broken.
fn unbroken(points: &[Point]) -> Vec<Vec<(f64, f64)>> {
    let lines = points.split(Option::is_none);
    lines
        .filter(|line| !line.is_empty())
        .map(|line| line.iter().flatten().copied().collect())
        .collect()
}
