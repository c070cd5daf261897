//! The comparison as text, CSV or JSON.

use super::Format;
use super::measure::{Feed, Measured};
use super::truth::Truth;
use super::variants::Variant;
use crate::curve::Curve;
use crate::failure::Failure;
use crate::pulses::AXES;
use crate::table::{self, Language, Table, layout};
use serde::{Serialize, Serializer};
use std::io::{self, Write};

/// Writes the comparison to standard output.
pub(super) fn print(
    curve: &Curve,
    truth: &Truth,
    rows: &[(Variant, Measured)],
    format: Format,
) -> Result<(), Failure> {
    let out = io::stdout().lock();
    let written = match format {
        Format::Text => text(out, curve, truth, rows),
        Format::Csv => {
            let sheet = Sheet { rows, axes: curve.end().len(), is_for_reading: false };
            layout::write(out, &sheet, table::Format::Csv, Language::En)
        }
        Format::Json => json(out, curve, truth, rows),
    };
    written.map_err(|error| Failure::stdout(&error))
}

fn text(
    mut out: impl Write,
    curve: &Curve,
    truth: &Truth,
    rows: &[(Variant, Measured)],
) -> io::Result<()> {
    writeln!(out, "{}: {:.3} pulses long\n", curve, truth.length())?;
    let sheet = Sheet { rows, axes: curve.end().len(), is_for_reading: true };
    layout::write(out, &sheet, table::Format::Text, Language::En)
}

/// The rows and columns.
struct Sheet<'a> {
    rows: &'a [(Variant, Measured)],
    axes: usize,
    /// With short headings and numbers, not for another program.
    is_for_reading: bool,
}

impl Sheet<'_> {
    fn pick(&self, read: &str, processed: &str) -> String {
        if self.is_for_reading { read } else { processed }.to_owned()
    }

    fn number(&self, number: Option<f64>) -> String {
        match number {
            Some(number) if self.is_for_reading => format!("{number:.4}"),
            Some(number) => format!("{number:.9}"),
            None => self.pick("-", ""),
        }
    }
}

impl Table for Sheet<'_> {
    fn headings(&self, _: Language) -> Vec<String> {
        let mut headings = vec!["method".into(), "variant".into(), "cycles".into()];
        let axes = &AXES[..self.axes];
        headings.extend(axes.iter().map(|axis| self.pick(axis, &format!("pulses_{axis}"))));
        headings.extend(
            [
                ("deviation", "deviation"),
                ("r.m.s.", "deviation_rms"),
                ("v/v_max", "feed"),
                ("least", "feed_least"),
                ("largest", "feed_largest"),
                ("spread", "feed_spread"),
            ]
            .map(|(read, processed)| self.pick(read, processed)),
        );
        headings.extend(
            axes.iter().map(|axis| self.pick(&format!("jitter {axis}"), &format!("jitter_{axis}"))),
        );
        headings.push("end".into());
        headings
    }

    fn rows(&self, _: Language) -> impl Iterator<Item = Vec<String>> {
        self.rows.iter().map(|(variant, measured)| {
            let mut row = vec![
                variant.method.name().to_owned(),
                variant.name.to_owned(),
                measured.cycles.to_string(),
            ];
            row.extend(measured.axes.iter().map(|axis| axis.pulses.to_string()));
            let feed = measured.feed;
            let numbers = [
                Some(measured.largest_deviation),
                Some(measured.rms_deviation),
                feed.map(|feed| feed.mean),
                feed.map(|feed| feed.least),
                feed.map(|feed| feed.largest),
                feed.and_then(spread),
            ];
            row.extend(numbers.map(|number| self.number(number)));
            row.extend(measured.axes.iter().map(|axis| self.number(axis.jitter)));
            row.push(if is_exact(measured) {
                "exact".to_owned()
            } else {
                let short = measured.axes.iter().map(|axis| axis.residual.to_string());
                short.collect::<Vec<_>>().join(",")
            });
            row
        })
    }
}

fn is_exact(measured: &Measured) -> bool {
    measured.axes.iter().all(|axis| axis.residual == 0)
}

/// How many times the least speed the largest is; none where the path stands still or turns back.
fn spread(feed: Feed) -> Option<f64> {
    (feed.least > 0.0).then(|| feed.largest / feed.least)
}

/// The comparison for other programs.
#[derive(Serialize)]
struct Comparison {
    curve: String,
    /// In pulses.
    length: f64,
    methods: Vec<MethodReport>,
}

#[derive(Serialize)]
struct MethodReport {
    method: &'static str,
    variant: &'static str,
    cycles: u64,
    pulses: PerAxis<u64>,
    deviation: DeviationReport,
    feed: Option<FeedReport>,
    jitter: PerAxis<Option<f64>>,
    endpoint_exact: bool,
    residual: PerAxis<i64>,
}

#[derive(Serialize)]
struct DeviationReport {
    largest: f64,
    rms: f64,
}

#[derive(Serialize)]
struct FeedReport {
    mean: f64,
    least: f64,
    largest: f64,
    spread: Option<f64>,
}

/// Values by the letters of their axes.
struct PerAxis<T>(Vec<T>);

impl<T: Serialize> Serialize for PerAxis<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(AXES.iter().zip(&self.0))
    }
}

impl MethodReport {
    fn new((variant, measured): &(Variant, Measured)) -> Self {
        let axes = &measured.axes;
        Self {
            method: variant.method.name(),
            variant: variant.name,
            cycles: measured.cycles,
            pulses: PerAxis(axes.iter().map(|axis| axis.pulses).collect()),
            deviation: DeviationReport {
                largest: measured.largest_deviation,
                rms: measured.rms_deviation,
            },
            feed: measured.feed.map(|feed| FeedReport {
                mean: feed.mean,
                least: feed.least,
                largest: feed.largest,
                spread: spread(feed),
            }),
            jitter: PerAxis(axes.iter().map(|axis| axis.jitter).collect()),
            endpoint_exact: is_exact(measured),
            residual: PerAxis(axes.iter().map(|axis| axis.residual).collect()),
        }
    }
}

fn json(
    mut out: impl Write,
    curve: &Curve,
    truth: &Truth,
    rows: &[(Variant, Measured)],
) -> io::Result<()> {
    let comparison = Comparison {
        curve: curve.to_string(),
        length: truth.length(),
        methods: rows.iter().map(MethodReport::new).collect(),
    };
    serde_json::to_writer_pretty(&mut out, &comparison)?;
    writeln!(out)?;
    out.flush()
}
