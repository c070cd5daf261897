//! D5: how far the textbook's circle by digital integration strays.

use super::driver::{Driver, Findings, Item};
use super::outcome::{Outcome, described};
use super::rings::{DIRECTIONS, circles};
use super::table::{Table, count, place, widths, worst};
use super::tally::Tally;
use super::walk::{Drawing, walk};
use onepulse_core::dda::{Arc, Preset, Radix, Register};
use onepulse_core::{Direction, Error};
use std::ops::RangeInclusive;

/// What is swept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameters {
    /// n.
    pub bits: RangeInclusive<u32>,
}

impl Default for Parameters {
    fn default() -> Self {
        Self { bits: 3..=10 }
    }
}

const PRESETS: [(Preset, &str); 3] =
    [(Preset::Zero, "zero"), (Preset::Half, "half load"), (Preset::Full, "full load")];

/// What is drawn from (R, 0) and (0, R).
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// One quadrant, R < 2ⁿ.
    Quarter,
    /// The full circle, signs changed at the axes, every R that the constructor accepts.
    Full,
}

const KINDS: [Kind; 2] = [Kind::Quarter, Kind::Full];

impl Kind {
    const fn title(self) -> &'static str {
        match self {
            Self::Quarter => "Quarter circles between the axes, R < 2ⁿ",
            Self::Full => "Full circles from an axis, signs changed at the axes, R + 5 < 2ⁿ",
        }
    }

    /// The figures measured earlier, for each preset.
    const fn earlier(self) -> [&'static str; 3] {
        match self {
            Self::Quarter => ["1.79 (n = 10)", "1.26 (n = 10)", ""],
            Self::Full => ["over 4", "", ""],
        }
    }

    fn name(self, preset: &str, bits: u32) -> String {
        let kind = match self {
            Self::Quarter => "quarters",
            Self::Full => "full circles",
        };
        format!("{kind} {preset} n={bits}")
    }

    fn item(self, preset: Preset, name: &str, bits: u32) -> Item {
        Item::new(self.name(name, bits), move || {
            let mut tally = Tally::default();
            for r in 1..1 << bits {
                for direction in DIRECTIONS {
                    let [start, quarter] = match direction {
                        Direction::Ccw => [[r, 0], [0, r]],
                        Direction::Cw => [[0, r], [r, 0]],
                    };
                    let end = if self == Self::Full { start } else { quarter };
                    let drawing = Drawing { start, end, direction, bits, shift: 0 };
                    match arc(&drawing, preset, false) {
                        Ok(arc) => walk(arc, &drawing, &mut tally),
                        Err(Error::RegisterTooNarrow { .. }) if self == Self::Full => {}
                        Err(why) => tally.fault(drawing.curve(), bits, why.to_string()),
                    }
                }
            }
            tally
        })
    }
}

fn arc(drawing: &Drawing, preset: Preset, normalize: bool) -> Result<Arc, Error> {
    let Drawing { start, end, direction, bits, .. } = *drawing;
    Arc::new(start, end, direction, Register::new(Radix::Binary, bits)?, preset, normalize)
}

const WITHIN: &str = "within a quadrant";

/// All arcs within the first quadrant with half load, normalized, the highest bit kept free for the
/// circle's growth: R ≤ 2^(n−1) − 1.
fn within_a_quadrant(bits: u32) -> Vec<Item> {
    let most = ((1_i64 << (bits - 1)) - 1).pow(2);
    let item = |ring: i32| {
        Item::new(format!("{WITHIN} n={bits} R={ring}.."), move || {
            let mut tally = Tally::default();
            for mut circle in circles(ring, most).into_values() {
                circle.retain(|point| point.iter().all(|c| *c >= 0));
                for &start in &circle {
                    for &end in &circle {
                        let turn = start[0] * end[1] - start[1] * end[0];
                        let direction = match turn {
                            1.. => Direction::Ccw,
                            0 => continue,
                            ..=-1 => Direction::Cw,
                        };
                        let drawing = Drawing { start, end, direction, bits, shift: 0 };
                        match arc(&drawing, Preset::Half, true) {
                            Ok(arc) => {
                                walk(arc, &Drawing { shift: arc.shift(), ..drawing }, &mut tally);
                            }
                            Err(why) => tally.fault(drawing.curve(), bits, why.to_string()),
                        }
                    }
                }
            }
            tally
        })
    };
    (1..=most.isqrt() as i32).map(item).collect()
}

/// Runs the sweep.
///
/// # Errors
/// Files of finished items that cannot be used.
pub fn run(parameters: &Parameters, driver: &Driver) -> Result<Outcome, String> {
    let bits = &parameters.bits;
    let mut items = Vec::new();
    for kind in KINDS {
        for (preset, name) in PRESETS {
            items.extend(bits.clone().map(|bits| kind.item(preset, name, bits)));
        }
    }
    items.extend(bits.clone().flat_map(within_a_quadrant));
    let findings = driver.run(&format!("D5 bits {bits:?}"), &items)?;
    let of = |kind: Kind, preset: &str| {
        let mut sum = Tally::default();
        for bits in bits.clone() {
            sum.add(&findings.of(&kind.name(preset, bits)));
        }
        sum
    };

    let statement = format!(
        "The textbook's circle by digital integration leaves the circle by more than one pulse, \
         whatever the preset, already in one quadrant: worst radial deviations for n = {}.",
        widths(bits)
    );
    let mut about = Tally::default();
    for kind in [Kind::Quarter, Kind::Full] {
        for (_, preset) in PRESETS {
            about.add(&of(kind, preset));
        }
    }
    let mut outcome = Outcome::new("D5", statement, &findings, &about);
    for kind in KINDS {
        outcome.tables.push(deviations(kind, bits, &findings));
    }
    outcome.tables.push(within(bits, &findings));
    outcome.demand_no_fault(WITHIN, &findings.of(WITHIN));
    let mut first = Table::new(
        "The smallest counterexample to \"no more than one pulse\" (smallest n, then R):",
        &["preset", "quarter circle", "full circle"],
    );
    for (_, preset) in PRESETS {
        let [quarter, full] = [Kind::Quarter, Kind::Full].map(|kind| of(kind, preset));
        for tally in [&quarter, &full] {
            outcome.demand_no_fault(preset, tally);
        }
        outcome.demand(quarter.over > 0 || !findings.is_complete(), || {
            format!("{preset}: no quarter circle leaves the pulse, which it should")
        });
        let [quarter, full] = [quarter, full]
            .map(|tally| tally.first_over.as_ref().map_or("none".to_owned(), described));
        first.row([preset.to_owned(), quarter, full]);
    }
    outcome.tables.push(first);
    outcome.remarks.push(
        "The 0.953 is not a quarter circle's: it is reached at R² = 16145, between 127² and 128². Normalization \
         looks at the start's larger coordinate, 127, and shifts that circle to where n − Q = 8 bits have \
         R < 2⁷, but not R ≤ 2⁷ − 1."
            .to_owned(),
    );
    Ok(outcome)
}

fn deviations(kind: Kind, bits: &RangeInclusive<u32>, findings: &Findings) -> Table {
    let presets = PRESETS.map(|(_, preset)| preset);
    let mut table =
        Table::new(&format!("{}:", kind.title()), &["n", presets[0], presets[1], presets[2]]);
    for bits in bits.clone() {
        let [zero, half, full] =
            presets.map(|preset| worst(&findings.of(&kind.name(preset, bits))));
        table.row([bits.to_string(), zero, half, full]);
    }
    let [zero, half, full] = kind.earlier().map(str::to_owned);
    table.row(["measured earlier".to_owned(), zero, half, full]);
    table
}

fn within(bits: &RangeInclusive<u32>, findings: &Findings) -> Table {
    let title = "Half load, normalized, with one headroom bit, R ≤ 2^(n−1) − 1: all arcs within the first \
                 quadrant between lattice points, both senses:";
    let mut table = Table::new(title, &["n", "arcs", "worst", "where"]);
    for bits in bits.clone() {
        let tally = findings.of(&format!("{WITHIN} n={bits}"));
        table.row([bits.to_string(), count(tally.curves), worst(&tally), place(&tally)]);
    }
    let earlier = "0.953 (n ≤ 10)".to_owned();
    table.row(["measured earlier".to_owned(), String::new(), earlier, String::new()]);
    table
}
