//! The command `sweep`.

use super::driver::{Driver, Shard};
use super::notes::replace;
use super::outcome::Outcome;
use super::{b2, d4, d5, d6, d6_small, runs};
use clap::{Args, ValueEnum};
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::time::Instant;

/// A sweep, by the claim that it checks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Id {
    /// Arcs by digital integration end exactly, and always end
    #[value(name = "D4")]
    D4,
    /// How far the textbook's circle by digital integration strays
    #[value(name = "D5")]
    D5,
    /// The centred staggered circle keeps one pulse
    #[value(name = "D6")]
    D6,
    /// The same for small radii, with four headroom bits and more
    #[value(name = "D6-small")]
    D6Small,
    /// How far lines of the rate multiplier stray
    #[value(name = "B2")]
    B2,
    /// Whole runs of every machine at narrow widths
    #[value(name = "RUNS")]
    Runs,
}

/// What to sweep.
#[derive(Debug, Args)]
pub struct Options {
    /// D4, D5, D6, D6-small, B2, RUNS, or all with their default ranges
    #[arg(value_parser = ids)]
    id: Ids,
    /// Register widths, A..=B: of all arcs (D4, D6), of quarter and full circles (D5), of lines (B2,
    /// and one for RUNS)
    #[arg(long, value_parser = range)]
    bits: Option<RangeInclusive<u32>>,
    /// Register widths of the rest: of quarter circles (D4), of full circles from an axis (D6), of the
    /// closed form's pair (B2)
    #[arg(long, value_parser = range)]
    circle_bits: Option<RangeInclusive<u32>>,
    /// The largest radius (D6-small, RUNS)
    #[arg(long)]
    radius: Option<u32>,
    /// How many widths for each radius (D6-small)
    #[arg(long)]
    widths: Option<u32>,
    /// The largest coordinate of lines by point-by-point comparison (RUNS)
    #[arg(long)]
    coordinate: Option<u32>,
    /// Only the i-th of n parts
    #[arg(long, value_name = "I/N", default_value = "1/1")]
    shard: Shard,
    /// Keep finished items in this file and do not do them again; of several files all are read and
    /// the first is kept
    #[arg(long, value_name = "FILE")]
    resume: Vec<PathBuf>,
    /// Write the tables to this Markdown file too
    #[arg(long, value_name = "FILE")]
    write: Option<PathBuf>,
}

/// One or all.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Ids(Vec<Id>);

fn ids(text: &str) -> Result<Ids, String> {
    if text == "all" {
        return Ok(Ids(Id::value_variants().to_vec()));
    }
    Id::from_str(text, true).map(|id| Ids(vec![id]))
}

fn range(text: &str) -> Result<RangeInclusive<u32>, String> {
    let (first, last) = text.split_once("..").unwrap_or((text, text));
    let last = last.trim_start_matches('=');
    match (first.parse(), last.parse()) {
        (Ok(first), Ok(last)) if (1..=last).contains(&first) && last <= 30 => Ok(first..=last),
        _ => Err("wanted widths from 1 to 30, for example 8 or 4..=7".to_owned()),
    }
}

impl Id {
    /// Sweeps with the default ranges, which takes seconds.
    ///
    /// # Errors
    /// Files of finished items that cannot be used; none if the driver has none.
    pub fn sweep(self, driver: &Driver) -> Result<Outcome, String> {
        match self {
            Self::D4 => d4::run(&d4::Parameters::default(), driver),
            Self::D5 => d5::run(&d5::Parameters::default(), driver),
            Self::D6 => d6::run(&d6::Parameters::default(), driver),
            Self::D6Small => d6_small::run(&d6_small::Parameters::default(), driver),
            Self::B2 => b2::run(&b2::Parameters::default(), driver),
            Self::Runs => runs::run(&runs::Parameters::default(), driver),
        }
    }

    /// The options that choose what this sweep does.
    const fn choices(self) -> &'static [&'static str] {
        match self {
            Self::D4 | Self::D6 | Self::B2 => &["--bits", "--circle-bits"],
            Self::D5 => &["--bits"],
            Self::D6Small => &["--radius", "--widths"],
            Self::Runs => &["--bits", "--radius", "--coordinate"],
        }
    }
}

impl Options {
    /// Sweeps as the options say.
    fn sweep(&self, id: Id, driver: &Driver) -> Result<Outcome, String> {
        let bits = |default: RangeInclusive<u32>| self.bits.clone().unwrap_or(default);
        let circle_bits =
            |default: RangeInclusive<u32>| self.circle_bits.clone().unwrap_or(default);
        match id {
            Id::D4 => {
                let default = d4::Parameters::default();
                let [bits, circle_bits] = [bits(default.bits), circle_bits(default.circle_bits)];
                d4::run(&d4::Parameters { bits, circle_bits }, driver)
            }
            Id::D5 => {
                let bits = bits(d5::Parameters::default().bits);
                d5::run(&d5::Parameters { bits }, driver)
            }
            Id::D6 => {
                let default = d6::Parameters::default();
                let [bits, circle_bits] = [bits(default.bits), circle_bits(default.circle_bits)];
                d6::run(&d6::Parameters { bits, circle_bits }, driver)
            }
            Id::D6Small => {
                let default = d6_small::Parameters::default();
                let radius = self.radius.unwrap_or(default.radius);
                let widths = self.widths.unwrap_or(default.widths);
                d6_small::run(&d6_small::Parameters { radius, widths }, driver)
            }
            Id::B2 => {
                let default = b2::Parameters::default();
                let [bits, closed_bits] = [bits(default.bits), circle_bits(default.closed_bits)];
                b2::run(&b2::Parameters { bits, closed_bits }, driver)
            }
            Id::Runs => {
                let default = runs::Parameters::default();
                let bits = self.bits.as_ref().map_or(default.bits, |bits| *bits.end());
                let radius = self.radius.unwrap_or(default.radius);
                let coordinate = self.coordinate.unwrap_or(default.coordinate);
                runs::run(&runs::Parameters { bits, radius, coordinate }, driver)
            }
        }
    }

    /// What was given and cannot be used: that would be another sweep than the one asked for.
    fn misplaced(&self) -> Option<String> {
        let given = [
            ("--bits", self.bits.is_some()),
            ("--circle-bits", self.circle_bits.is_some()),
            ("--radius", self.radius.is_some()),
            ("--widths", self.widths.is_some()),
            ("--coordinate", self.coordinate.is_some()),
            ("--resume", !self.resume.is_empty()),
        ];
        let is_usable = |option: &str| match &*self.id.0 {
            [id] => option == "--resume" || id.choices().contains(&option),
            _ => false,
        };
        let option = given.iter().find(|(option, is_given)| *is_given && !is_usable(option));
        option.map(|(option, _)| format!("{option} is not an option of this sweep"))
    }
}

/// Runs the command: the tables on standard output, times on standard error.
///
/// # Errors
/// A sweep that does not hold; a file that cannot be used.
pub fn run(options: &Options) -> Result<(), String> {
    if let Some(why) = options.misplaced() {
        clap::Error::raw(clap::error::ErrorKind::ArgumentConflict, why + "\n").exit();
    }
    let driver = Driver { shard: options.shard, resume: options.resume.clone(), has_bar: true };
    let mut page = PAGE.to_owned();
    let mut failed = Vec::new();
    for &id in &options.id.0 {
        let begun = Instant::now();
        let outcome = options.sweep(id, &driver)?;
        println!("{outcome}");
        eprintln!("{}: {:.1} s", outcome.id, begun.elapsed().as_secs_f64());
        page.push_str(&format!("\n{outcome}"));
        if !outcome.passed {
            failed.push(format!("{} does not hold: {}", outcome.id, outcome.failures.join("; ")));
        }
    }
    if !failed.is_empty() {
        return Err(failed.join("\n"));
    }
    options.write.as_ref().map_or(Ok(()), |file| replace(file, &page))
}

/// How the page begins.
const PAGE: &str = "\
# Exhaustive sweeps

What holds for every curve of narrow registers, and what does not. Written by

    cargo run --release -p onepulse-verify -- sweep all --write docs/sweeps.md

One sweep alone is `sweep D6`; `--bits` and the other options that `sweep --help` lists widen it, `--shard 2/4`
does a part, and `--resume FILE` goes on where a sweep was broken off. Parts are put together by giving all
their files: `sweep D6 --bits 8 --resume part-1.txt --resume part-2.txt …`.

Deviations are radial for arcs and square to the line for lines, in pulses. Whether one exceeds a bound is
decided in integers. A point is named with its curve, the register width n and the cycle. \"Measured earlier\" are
figures from programs that were written before these.
";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_of_widths() {
        assert_eq!(range("4..=7"), Ok(4..=7));
        assert_eq!(range("4..7"), Ok(4..=7));
        assert_eq!(range("8"), Ok(8..=8));
        for wrong in ["", "0..=3", "7..=4", "x", "3..=99"] {
            assert!(range(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn sweeps_by_name() {
        assert_eq!(ids("D6-small"), Ok(Ids(vec![Id::D6Small])));
        assert_eq!(ids("all").unwrap().0.len(), 6);
        assert!(ids("D7").is_err());
    }

    #[test]
    fn the_sweeps_hold_at_narrow_widths() {
        let driver = Driver::default();
        let [bits, circle_bits] = [2..=4, 2..=6];
        let outcomes = [
            d4::run(&d4::Parameters { bits, circle_bits }, &driver),
            d5::run(&d5::Parameters { bits: 3..=5 }, &driver),
            d6::run(&d6::Parameters { bits: 4..=5, circle_bits: 4..=6 }, &driver),
            d6_small::run(&d6_small::Parameters { radius: 5, widths: 2 }, &driver),
            b2::run(&b2::Parameters { bits: 1..=6, closed_bits: 2..=12 }, &driver),
            runs::run(&runs::Parameters { bits: 4, radius: 9, coordinate: 12 }, &driver),
        ];
        for outcome in outcomes {
            let outcome = outcome.unwrap();
            assert!(outcome.passed && outcome.is_complete, "{outcome}");
            assert!(outcome.curves > 0 && outcome.cycles > 0);
            // The textbook's arcs and the rate multiplier's lines stray farther.
            let strays = matches!(outcome.id, "D4" | "D5" | "B2");
            assert_eq!(outcome.worst_deviation > 1.0, strays, "{outcome}");
            assert_eq!(outcome.counterexample.is_some(), strays, "{outcome}");
        }
    }

    #[test]
    fn a_counterexample_that_is_not_found_is_a_failure() {
        let driver = Driver::default();
        let d5 = d5::run(&d5::Parameters { bits: 3..=4 }, &driver).unwrap();
        let b2 = b2::run(&b2::Parameters { bits: 1..=4, closed_bits: 2..=4 }, &driver).unwrap();
        for outcome in [d5, b2] {
            assert!(!outcome.passed && outcome.failures.len() == 1, "{outcome}");
        }
    }
}
