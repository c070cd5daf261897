//! D6: the centred staggered circle by digital integration keeps one pulse, with one headroom bit.

use super::driver::{Driver, Item};
use super::outcome::Outcome;
use super::rejected::{CentredWithoutHeadroom, SimultaneousUpDown, UncentredStaggered};
use super::rings::{DIRECTIONS, all_arcs};
use super::table::{Table, count, pulses};
use super::tally::Tally;
use super::walk::{Circuit, Drawing, walk};
use onepulse_core::Error;
use onepulse_core::dda::{CentredArc, Radix, Register};
use std::ops::RangeInclusive;

/// What is swept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameters {
    /// n, for all arcs.
    pub bits: RangeInclusive<u32>,
    /// n, for full circles from an axis.
    pub circle_bits: RangeInclusive<u32>,
}

impl Default for Parameters {
    fn default() -> Self {
        Self { bits: 4..=7, circle_bits: 4..=11 }
    }
}

/// A row of the comparison: a circuit and what is drawn with it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Row {
    CentredArcs,
    CentredNormalizedArcs,
    CentredCircles,
    SimultaneousCircles,
    UncentredCircles,
    UncentredArcs,
    HeadroomArcs,
    NoHeadroomArcs,
}

const ROWS: [Row; 8] = [
    Row::SimultaneousCircles,
    Row::UncentredCircles,
    Row::UncentredArcs,
    Row::CentredArcs,
    Row::CentredNormalizedArcs,
    Row::CentredCircles,
    Row::HeadroomArcs,
    Row::NoHeadroomArcs,
];

impl Row {
    /// Whether it is the core's circuit within its domain: the others are shown, not demanded.
    const fn is_claimed(self) -> bool {
        matches!(self, Self::CentredArcs | Self::CentredNormalizedArcs | Self::CentredCircles)
    }

    const fn name(self) -> &'static str {
        match self {
            Self::CentredArcs => "centred staggered, all arcs, R ≤ 2^(n−1) − 1",
            Self::CentredNormalizedArcs => "the same normalized, R ≤ 2^(n−2) − 1",
            Self::CentredCircles => "the same, full circles from the axes, R ≤ 2^(n−1) − 1",
            Self::SimultaneousCircles => {
                "up/down, both at once, half load, full circles from the axes, R < 2^(n−1)"
            }
            Self::UncentredCircles => {
                "up/down, staggered, half load, full circles from the axes, R < 2ⁿ"
            }
            Self::UncentredArcs => "up/down, staggered, half load, all arcs, R < 2^(n−1)",
            Self::HeadroomArcs => "centred staggered, all arcs, R < 2^(n−1)",
            Self::NoHeadroomArcs => "centred staggered, all arcs, R < 2ⁿ",
        }
    }

    const fn earlier(self) -> &'static str {
        match self {
            Self::CentredArcs => "0.931 (n = 4 … 8)",
            Self::CentredNormalizedArcs | Self::CentredCircles => "",
            Self::SimultaneousCircles => "over 2",
            Self::UncentredCircles => "0.981 (n = 8 … 12, 14)",
            Self::UncentredArcs => "1.026 (n = 6)",
            Self::HeadroomArcs => "1.06 (n = 6)",
            Self::NoHeadroomArcs => "1.103 (n = 4 … 8)",
        }
    }

    const fn has_all_arcs(self) -> bool {
        !matches!(self, Self::CentredCircles | Self::SimultaneousCircles | Self::UncentredCircles)
    }

    /// The largest R² that is drawn.
    fn most(self, bits: u32) -> i64 {
        match self {
            Self::CentredArcs | Self::CentredCircles => ((1_i64 << (bits - 1)) - 1).pow(2),
            Self::CentredNormalizedArcs => ((1_i64 << (bits - 2)) - 1).pow(2),
            Self::SimultaneousCircles | Self::UncentredArcs | Self::HeadroomArcs => {
                (1 << (2 * (bits - 1))) - 1
            }
            Self::UncentredCircles | Self::NoHeadroomArcs => (1 << (2 * bits)) - 1,
        }
    }

    fn draw(self, drawing: &Drawing, tally: &mut Tally) {
        let drawn = match self {
            Self::CentredArcs | Self::CentredCircles => centred(drawing, false, tally),
            Self::CentredNormalizedArcs => centred(drawing, true, tally),
            Self::SimultaneousCircles => rejected(SimultaneousUpDown::new(drawing), drawing, tally),
            Self::UncentredCircles | Self::UncentredArcs => {
                rejected(UncentredStaggered::new(drawing), drawing, tally)
            }
            Self::HeadroomArcs | Self::NoHeadroomArcs => {
                rejected(CentredWithoutHeadroom::new(drawing), drawing, tally)
            }
        };
        if let Err(why) = drawn {
            tally.fault(drawing.curve(), drawing.bits, why.to_string());
        }
    }

    fn items(self, parameters: &Parameters) -> Vec<Item> {
        let draw = move |drawing: &Drawing, tally: &mut Tally| self.draw(drawing, tally);
        if self.has_all_arcs() {
            let arcs = |bits| all_arcs(self.name(), bits, self.most(bits), draw);
            return parameters.bits.clone().flat_map(arcs).collect();
        }
        let circles = |bits| full_circles(self.name(), bits, self.most(bits).isqrt() as i32, draw);
        parameters.circle_bits.clone().flat_map(circles).collect()
    }

    fn bits(self, parameters: &Parameters) -> RangeInclusive<u32> {
        if self.has_all_arcs() { parameters.bits.clone() } else { parameters.circle_bits.clone() }
    }
}

fn centred(drawing: &Drawing, normalize: bool, tally: &mut Tally) -> Result<(), Error> {
    let Drawing { start, end, direction, bits, .. } = *drawing;
    let register = Register::new(Radix::Binary, bits)?;
    let arc = CentredArc::new(start, end, direction, register, normalize)?;
    walk(arc, &Drawing { shift: arc.shift(), ..*drawing }, tally);
    Ok(())
}

fn rejected(
    circuit: Result<impl Circuit, Error>,
    drawing: &Drawing,
    tally: &mut Tally,
) -> Result<(), Error> {
    walk(circuit?, drawing, tally);
    Ok(())
}

/// Radii of full circles in one item.
const RADII: usize = 64;

/// Full circles of integer radius from the four axes, both senses.
fn full_circles(
    circuit: &str,
    bits: u32,
    largest: i32,
    draw: impl Fn(&Drawing, &mut Tally) + Copy + Send + Sync + 'static,
) -> Vec<Item> {
    let item = move |first: i32| {
        Item::new(format!("{circuit} n={bits} R={first}.."), move || {
            let mut tally = Tally::default();
            for r in (first..=largest).take(RADII) {
                for start in [[r, 0], [0, r], [-r, 0], [0, -r]] {
                    for direction in DIRECTIONS {
                        let drawing = Drawing { start, end: start, direction, bits, shift: 0 };
                        draw(&drawing, &mut tally);
                    }
                }
            }
            tally
        })
    };
    (1..=largest).step_by(RADII).map(item).collect()
}

/// Runs the sweep.
///
/// # Errors
/// Files of finished items that cannot be used.
pub fn run(parameters: &Parameters, driver: &Driver) -> Result<Outcome, String> {
    let Parameters { bits, circle_bits } = parameters;
    let items: Vec<_> = ROWS.iter().flat_map(|row| row.items(parameters)).collect();
    let findings = driver.run(&format!("D6 bits {bits:?} circle-bits {circle_bits:?}"), &items)?;
    let of = |row: Row, bits: u32| findings.of(&format!("{} n={bits} ", row.name()));
    let sum = |row: Row| {
        let mut sum = Tally::default();
        for bits in row.bits(parameters) {
            sum.add(&of(row, bits));
        }
        sum
    };

    let mut about = Tally::default();
    for row in ROWS.into_iter().filter(|row| row.is_claimed()) {
        about.add(&sum(row));
    }
    let statement = format!(
        "The centred staggered circle keeps within one pulse and ends exactly, from any lattice start, \
         in either sense, for any sweep up to a full turn, if R ≤ 2^(n−1) − 1: all arcs between lattice \
         points of one circle for n = {bits:?}, full circles from the axes for n = {circle_bits:?}."
    );
    let mut outcome = Outcome::new("D6", statement, &findings, &about);
    for row in ROWS.into_iter().filter(|row| row.is_claimed()) {
        let tally = sum(row);
        outcome.demand_no_fault(row.name(), &tally);
        outcome.demand_one_pulse(row.name(), &tally);
    }
    outcome.tables.push(comparison(parameters, sum));
    outcome.tables.push(by_width(parameters, of));
    Ok(outcome)
}

fn comparison(parameters: &Parameters, sum: impl Fn(Row) -> Tally) -> Table {
    let header = [
        "circuit",
        "n",
        "arcs",
        "worst",
        "measured earlier",
        "over one pulse",
        "stepped out",
        "at fault",
    ];
    let mut table = Table::new("Worst radial deviation, circuit by circuit:", &header);
    for row in ROWS {
        let tally = sum(row);
        table.row([
            row.name().to_owned(),
            format!("{:?}", row.bits(parameters)).replace("..=", " … "),
            count(tally.curves),
            pulses(tally.deviation()),
            row.earlier().to_owned(),
            count(tally.over),
            count(tally.stepped_out),
            count(tally.faults),
        ]);
    }
    table
}

fn by_width(parameters: &Parameters, of: impl Fn(Row, u32) -> Tally) -> Table {
    let header = ["circuit", "n", "arcs", "worst", "where"];
    let mut table = Table::new("The same by width, with the worst point:", &header);
    for row in ROWS {
        for bits in row.bits(parameters) {
            let tally = of(row, bits);
            table.row([
                row.name().to_owned(),
                bits.to_string(),
                count(tally.curves),
                pulses(tally.deviation()),
                tally.worst.map_or(String::new(), |case| case.to_string()),
            ]);
        }
    }
    table
}
