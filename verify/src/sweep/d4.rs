//! D4: arcs by digital integration end exactly, and always end.

use super::driver::{Driver, Findings, Item};
use super::outcome::Outcome;
use super::rejected::StaggeredFullLoad;
use super::rings::{DIRECTIONS, all_arcs};
use super::table::{Table, count, widths};
use super::tally::Tally;
use super::walk::{Circuit, Drawing, walk};
use onepulse_core::dda::{Arc, CentredArc, Preset, Radix, Register};
use onepulse_core::{Direction, Error};
use std::ops::RangeInclusive;

/// What is swept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameters {
    /// n, for all arcs.
    pub bits: RangeInclusive<u32>,
    /// n, for quarter circles.
    pub circle_bits: RangeInclusive<u32>,
}

impl Default for Parameters {
    fn default() -> Self {
        Self { bits: 2..=7, circle_bits: 2..=10 }
    }
}

/// A circuit that the core offers.
#[derive(Clone, Copy)]
struct Offered {
    /// None for the centred staggered circuit, which has its own.
    preset: Option<Preset>,
    is_normalized: bool,
}

/// Where the starving circuit is counted: quarter circles of R = 2 … 2ⁿ − 1.
const STARVING_BITS: RangeInclusive<u32> = 4..=10;

const STARVING: [(&str, bool); 2] =
    [("staggered with full load", false), ("staggered with full load, normalized", true)];

/// What was measured earlier: n = 10, normalized.
const EARLIER: u64 = 382;

impl Offered {
    fn all() -> impl Iterator<Item = Self> {
        let presets = [Some(Preset::Zero), Some(Preset::Half), Some(Preset::Full), None];
        presets
            .into_iter()
            .flat_map(|preset| [false, true].map(|is_normalized| Self { preset, is_normalized }))
    }

    fn name(self) -> String {
        let circuit = match self.preset {
            Some(Preset::Zero) => "textbook, zero",
            Some(Preset::Half) => "textbook, half load",
            Some(Preset::Full) => "textbook, full load",
            None => "centred staggered",
        };
        format!("{circuit}{}", if self.is_normalized { ", normalized (Q > 0)" } else { "" })
    }

    /// Draws an arc, if the constructor accepts it for this width. Normalized with Q = 0 it is the same
    /// machine as without, and not drawn twice.
    fn draw(self, drawing: &Drawing, tally: &mut Tally) {
        let Drawing { start, end, direction, bits, .. } = *drawing;
        let drawn = Register::new(Radix::Binary, bits).and_then(|register| {
            let normalize = self.is_normalized;
            match self.preset {
                Some(preset) => {
                    let arc = Arc::new(start, end, direction, register, preset, normalize)?;
                    self.walk(arc, arc.shift(), drawing, tally);
                }
                None => {
                    let arc = CentredArc::new(start, end, direction, register, normalize)?;
                    self.walk(arc, arc.shift(), drawing, tally);
                }
            }
            Ok(())
        });
        match drawn {
            Ok(()) | Err(Error::RegisterTooNarrow { .. }) => {}
            Err(why) => tally.fault(drawing.curve(), bits, why.to_string()),
        }
    }

    fn walk(self, arc: impl Circuit, shift: u32, drawing: &Drawing, tally: &mut Tally) {
        if shift > 0 || !self.is_normalized {
            walk(arc, &Drawing { shift, ..*drawing }, tally);
        }
    }

    /// Quarter circles between the axes, in every quadrant and both senses.
    fn quarters(self, bits: u32) -> Item {
        Item::new(format!("quarters {} n={bits}", self.name()), move || {
            let mut tally = Tally::default();
            for r in 1..1 << bits {
                let axes = [[r, 0], [0, r], [-r, 0], [0, -r]];
                for at in 0..4 {
                    for direction in DIRECTIONS {
                        let to = match direction {
                            Direction::Ccw => at + 1,
                            Direction::Cw => at + 3,
                        };
                        let [start, end] = [axes[at], axes[to % 4]];
                        self.draw(&Drawing { start, end, direction, bits, shift: 0 }, &mut tally);
                    }
                }
            }
            tally
        })
    }
}

/// The items of the sweep.
fn items(parameters: &Parameters) -> Vec<Item> {
    let mut items = Vec::new();
    for circuit in Offered::all() {
        items.extend(parameters.circle_bits.clone().map(|bits| circuit.quarters(bits)));
        for bits in parameters.bits.clone() {
            let draw = move |drawing: &Drawing, tally: &mut Tally| circuit.draw(drawing, tally);
            let name = format!("arcs {}", circuit.name());
            // R < 2ⁿ: the registers hold no larger coordinate, and the constructor decides.
            items.extend(all_arcs(&name, bits, (1 << (2 * bits)) - 1, draw));
        }
    }
    for (name, normalize) in STARVING {
        items.extend(STARVING_BITS.map(|bits| {
            Item::new(format!("{name} n={bits}"), move || {
                let starves = |&r: &u64| StaggeredFullLoad::new(r, bits, normalize).starves();
                let radii = 2..1_u64 << bits;
                let curves = radii.end - radii.start;
                let faults = radii.filter(starves).count() as u64;
                Tally { curves, faults, ..Tally::default() }
            })
        }));
    }
    items
}

/// Runs the sweep.
///
/// # Errors
/// Files of finished items that cannot be used.
pub fn run(parameters: &Parameters, driver: &Driver) -> Result<Outcome, String> {
    let Parameters { bits, circle_bits } = parameters;
    let findings =
        driver.run(&format!("D4 bits {bits:?} circle-bits {circle_bits:?}"), &items(parameters))?;
    let mut about = Tally::default();
    let mut of = |kind: &str, circuit: Offered| {
        let mut sum = Tally::default();
        let bits = if kind == "arcs" { bits } else { circle_bits };
        for bits in bits.clone() {
            sum.add(&findings.of(&format!("{kind} {} n={bits}", circuit.name())));
        }
        about.add(&sum);
        sum
    };
    let quarters = format!(
        "Quarter circles between the axes, every quadrant, both senses, n = {}:",
        widths(circle_bits)
    );
    let arcs = format!(
        "All arcs between lattice points of one circle, both senses, n = {}:",
        widths(bits)
    );
    let figures = [("quarters", quarters), ("arcs", arcs)].map(|(kind, title)| {
        (title, Offered::all().map(|circuit| (circuit, of(kind, circuit))).collect::<Vec<_>>())
    });

    let statement = format!(
        "Arcs by digital integration end exactly on their end point, never wait 2^(n−Q) cycles for \
         a pulse, and need no stepping out: every lattice circle that the constructor accepts, all arcs for n = {}, \
         quarter circles for n = {}.",
        widths(bits),
        widths(circle_bits)
    );
    let mut outcome = Outcome::new("D4", statement, &findings, &about);
    for (title, rows) in figures {
        let header = [
            "circuit",
            "arcs",
            "at fault",
            "longest wait, 2^(n−Q)",
            "longest arc, 2^(n−Q)",
            "stepped out",
        ];
        let mut table = Table::new(&title, &header);
        for (circuit, tally) in rows {
            table.row([
                circuit.name(),
                count(tally.curves),
                count(tally.faults),
                format!("{:.3}", tally.wait.ratio()),
                format!("{:.2}", tally.longest.ratio()),
                count(tally.stepped_out),
            ]);
            outcome.demand_no_fault(&circuit.name(), &tally);
            outcome.demand(tally.stepped_out == 0, || {
                format!("{}: {} arcs had to be stepped out", circuit.name(), tally.stepped_out)
            });
            outcome.demand(tally.curves > 0 || !findings.is_complete(), || {
                format!("{}: no arc was drawn", circuit.name())
            });
        }
        outcome.tables.push(table);
    }
    outcome.remarks.push(
        "\"Stepped out\" would be an arc whose integrators starve, or overshoot, before the end point, and \
         whose last pulses the core counts out: only end points off the circle need that."
            .to_owned(),
    );
    starving(&mut outcome, &findings);
    Ok(outcome)
}

/// Why the core does not offer every combination.
fn starving(outcome: &mut Outcome, findings: &Findings) {
    let title = "A rejected combination: the textbook's circuit staggered and fully loaded, quarter \
                 circles from (R, 0), R = 2 … 2ⁿ − 1:";
    let header = ["n", "radii", "starve", "starve, normalized to the top bit", "measured earlier"];
    let mut table = Table::new(title, &header);
    for bits in STARVING_BITS {
        let [plain, normalized] =
            STARVING.map(|(name, _)| findings.of(&format!("{name} n={bits}")));
        table.row([
            bits.to_string(),
            count(plain.curves),
            count(plain.faults),
            count(normalized.faults),
            if bits == 10 { format!("{EARLIER} of 1022") } else { String::new() },
        ]);
        if findings.is_complete() {
            outcome.demand(plain.faults > 0 && normalized.faults > 0, || {
                format!(
                    "staggered, full load, n = {bits}: no radius starves; it was rejected for it"
                )
            });
            outcome.demand(bits != 10 || normalized.faults == EARLIER, || {
                format!("staggered, full load, n = 10: not {EARLIER} radii starve")
            });
        }
    }
    outcome.tables.push(table);
    outcome.remarks.push(
        "Measured earlier were the normalized ones: without normalization more radii starve."
            .to_owned(),
    );
}
