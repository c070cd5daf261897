//! `onepulse contour-error`: what ramps after interpolation and position loops take from a path.

mod measured;

use crate::failure::Failure;
use crate::machine_file::positive;
use crate::table::{Format, Language, Table, layout};
use clap::Args;
use onepulse_plan::after_interpolation::{Exponential, Linear};
use onepulse_plan::servo::{Axis, Settings};
use std::f64::consts::E;
use std::io;

#[derive(Debug, Args)]
pub(crate) struct ContourErrorArguments {
    /// The radius of the circle in millimetres
    #[arg(long, value_name = "MM", default_value = "20", allow_negative_numbers = true)]
    radius: String,
    /// The feed in millimetres a minute
    #[arg(long, value_name = "MM_PER_MIN", default_value = "3000", allow_negative_numbers = true)]
    feed: String,
    /// The sample period in milliseconds
    #[arg(long, value_name = "MS", default_value = "8", allow_negative_numbers = true)]
    period: String,
    /// The time of both ramps in milliseconds, for the linear one rounded to whole periods
    #[arg(long, value_name = "MS", default_value = "64", allow_negative_numbers = true)]
    ramp_time: String,
    /// The gain K_v of the position loops in 1/s
    #[arg(long, value_name = "PER_S", default_value_t = 30.0, allow_negative_numbers = true)]
    servo_gain: f64,
    /// The time constant of the drives in milliseconds
    #[arg(long, value_name = "MS", default_value_t = 0.0, allow_negative_numbers = true)]
    servo_drive: f64,
    /// How to write the table
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// The language of the headings
    #[arg(long, value_enum, default_value_t)]
    lang: Language,
}

/// One cause of an error, in millimetres.
struct Row {
    cause: [&'static str; 2],
    /// The textbooks' formula, and what it gives.
    formula: &'static str,
    textbook: f64,
    /// Period by period.
    exact: f64,
    /// Of a path that was run through.
    measured: f64,
}

struct ContourErrors(Vec<Row>);

pub(crate) fn contour_error(arguments: &ContourErrorArguments) -> Result<(), Failure> {
    let number = |option: &str, text: &str| {
        let length = positive(option, text).map_err(Failure::Usage)?;
        Ok(length.millimetres())
    };
    let radius = number("--radius", &arguments.radius)?;
    let speed = number("--feed", &arguments.feed)? / 60.0;
    let period = number("--period", &arguments.period)? / 1000.0;
    let time = number("--ramp-time", &arguments.ramp_time)? / 1000.0;
    let periods = (time / period).round();
    // Longer steps are no circle, and shorter ones take long to run.
    if !(1e-5..=0.25).contains(&(speed * period / radius)) {
        return Err(Failure::Usage(format!(
            "a sample period's way, {} mm, is not between 1/100000 and 1/4 of the radius",
            speed * period
        )));
    }
    if !(1.0..=1000.0).contains(&periods) {
        return Err(Failure::Usage("--ramp-time: 1 to 1000 sample periods are needed".into()));
    }
    let wrong = |why: &dyn std::fmt::Display| Failure::Usage(why.to_string());
    let linear = Linear::new(periods as u32, period).map_err(|why| wrong(&why))?;
    // A rest this small is far below any pulse.
    let exponential = Exponential::new(time, period, 1e-9).map_err(|why| wrong(&why))?;
    let (gain, drive_time_constant) = (arguments.servo_gain, arguments.servo_drive / 1000.0);
    let axis =
        Axis::new(Settings { gain, drive_time_constant, period }).map_err(|why| wrong(&why))?;

    let squared = speed * speed / radius;
    let lines = |mm: f64| (mm / (speed * period)).ceil() as usize;
    let settled = lines(speed * (20.0 * time)).max(10);
    let mut rows = vec![
        Row {
            cause: ["position loop: following error", "位置环: 跟随误差"],
            formula: "v/K_v",
            textbook: speed / gain,
            exact: axis.steady_error(speed),
            measured: measured::following_error(axis, speed * period),
        },
        Row {
            cause: ["position loop: circle", "位置环: 圆"],
            formula: "v²/(2R·K_v²)",
            textbook: squared / (2.0 * gain * gain),
            exact: axis.radius_loss(radius, speed),
            measured: measured::circle_followed(axis, radius, speed * period),
        },
        Row {
            cause: ["exponential ramp: circle", "指数加减速: 圆"],
            formula: "τ²v²/(2R)",
            textbook: time * time * squared / 2.0,
            exact: exponential.circle_error(radius, speed),
            measured: measured::circle(radius, speed * period, |way| exponential.ramp(way)),
        },
        Row {
            cause: ["exponential ramp: corner of 90°", "指数加减速: 90° 拐角"],
            formula: "v·τ/e",
            textbook: speed * time / E,
            exact: exponential.corner_error(speed),
            measured: measured::corner(speed * period, settled, |way| exponential.ramp(way)),
        },
    ];
    let time = periods * period;
    rows.extend([
        Row {
            cause: ["linear ramp: circle", "直线加减速: 圆"],
            formula: "τ²v²/(24R)",
            textbook: time * time * squared / 24.0,
            exact: linear.circle_error(radius, speed),
            measured: measured::circle(radius, speed * period, |way| linear.ramp(way)),
        },
        Row {
            cause: ["linear ramp: corner of 90°", "直线加减速: 90° 拐角"],
            formula: "v·τ/8",
            textbook: speed * time / 8.0,
            exact: linear.corner_error(speed),
            measured: measured::corner(speed * period, settled, |way| linear.ramp(way)),
        },
    ]);
    let out = io::stdout().lock();
    let written = layout::write(out, &ContourErrors(rows), arguments.format, arguments.lang);
    written.map_err(|error| Failure::stdout(&error))
}

impl Table for ContourErrors {
    fn headings(&self, language: Language) -> Vec<String> {
        [
            ("error, mm", "误差, mm"),
            ("formula", "公式"),
            ("by the formula", "公式值"),
            ("period by period", "逐周期精确值"),
            ("measured", "实测"),
        ]
        .map(|(english, chinese)| language.pick(english, chinese).to_owned())
        .into()
    }

    fn rows(&self, language: Language) -> impl Iterator<Item = Vec<String>> {
        self.0.iter().map(move |row| {
            let [english, chinese] = row.cause;
            let mut cells =
                vec![language.pick(english, chinese).to_owned(), row.formula.to_owned()];
            cells.extend([row.textbook, row.exact, row.measured].map(|mm| format!("{mm:.6}")));
            cells
        })
    }
}
