//! D6: the centred staggered circle by digital integration keeps one pulse, with one headroom bit.

use super::driver::{Driver, Item};
use super::outcome::Outcome;
use super::rejected::{CentredWithoutHeadroom, SimultaneousUpDown, UncentredStaggered};
use super::rings::{DIRECTIONS, all_arcs};
use super::table::{Table, count, place, widths, worst};
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
        Self { bits: 4..=7, circle_bits: 4..=12 }
    }
}

/// A row of the comparison: a circuit and what is drawn with it.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Row {
    letter: char,
    circuit: Kind,
    drawn: Drawn,
    domain: Domain,
    earlier: &'static str,
}

/// A circuit.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Rejected.
    SimultaneousUpDown,
    /// Rejected.
    UncentredStaggered,
    /// The core's.
    Centred,
    /// The core's, with integrands shifted left.
    CentredNormalized,
    /// Rejected: the same without the constructor's limit.
    CentredWithoutHeadroom,
}

/// What is drawn.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Drawn {
    /// Every arc between lattice points of one circle, both senses.
    AllArcs,
    /// Full circles from (R, 0), both senses.
    Circles,
    /// Full circles from the four axes, both senses.
    CirclesFromAxes,
}

/// Which radii.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Domain {
    /// Every R that the constructor accepts, which must be R ≤ 2^(n−1) − 1 at least.
    Accepted,
    /// R ≤ 2^(n−k) − 1.
    AtMost(u32),
    /// R < 2^(n−k): the irrational radii between 2^(n−k) − 1 and 2^(n−k) too.
    Below(u32),
}

const fn row(
    letter: char,
    circuit: Kind,
    drawn: Drawn,
    domain: Domain,
    earlier: &'static str,
) -> Row {
    Row { letter, circuit, drawn, domain, earlier }
}

use Domain::{Accepted, AtMost, Below};
use Drawn::{AllArcs, Circles, CirclesFromAxes};

const ROWS: [Row; 10] = [
    row('a', Kind::SimultaneousUpDown, Circles, AtMost(1), "over 2"),
    row('b', Kind::UncentredStaggered, Circles, AtMost(0), "0.981 (n = 8 … 12, 14), closes"),
    row('c', Kind::UncentredStaggered, AllArcs, AtMost(1), "1.026 (n = 6)"),
    row('d', Kind::UncentredStaggered, AllArcs, Below(1), ""),
    row('e', Kind::Centred, AllArcs, Accepted, "0.931 (n = 4 … 8)"),
    row('f', Kind::CentredNormalized, AllArcs, Accepted, ""),
    row('g', Kind::Centred, CirclesFromAxes, Accepted, ""),
    row('h', Kind::CentredWithoutHeadroom, AllArcs, Below(1), "1.06 (n = 6)"),
    row('i', Kind::CentredWithoutHeadroom, AllArcs, AtMost(0), "1.103 (n = 4 … 8)"),
    row('j', Kind::CentredWithoutHeadroom, AllArcs, Below(0), ""),
];

impl Domain {
    /// The largest R² in it.
    const fn most(self, bits: u32) -> i64 {
        match self {
            AtMost(less) => ((1_i64 << (bits - less)) - 1).pow(2),
            Below(less) => (1 << (2 * (bits - less))) - 1,
            // The constructor decides; its registers hold no larger coordinate.
            Accepted => (1 << (2 * bits)) - 1,
        }
    }
}

impl Row {
    /// Whether it is the core's circuit: the others are shown, not demanded.
    fn is_claimed(self) -> bool {
        matches!(self.circuit, Kind::Centred | Kind::CentredNormalized)
    }

    fn name(self) -> String {
        let circuit = match self.circuit {
            Kind::SimultaneousUpDown => "up/down, both at once, half load",
            Kind::UncentredStaggered => "up/down, staggered, half load",
            Kind::Centred | Kind::CentredWithoutHeadroom => "centred staggered",
            Kind::CentredNormalized => "centred staggered, normalized with Q > 0",
        };
        let drawn = match self.drawn {
            AllArcs => "all arcs",
            Circles => "full circles from (R, 0)",
            CirclesFromAxes => "full circles from the axes",
        };
        let power =
            |less: u32| if less == 0 { "2ⁿ".to_owned() } else { format!("2^(n−{less})") };
        let domain = match self.domain {
            Accepted => "R ≤ 2^(n−1) − 1, as accepted".to_owned(),
            AtMost(less) => format!("R ≤ {} − 1", power(less)),
            Below(less) => format!("R < {}", power(less)),
        };
        format!("{circuit}: {drawn}, {domain}")
    }

    /// How its items' names begin.
    fn key(self, bits: u32) -> String {
        format!("{} n={bits}", self.letter)
    }

    fn draw(self, drawing: &Drawing, tally: &mut Tally) {
        let drawn = match self.circuit {
            Kind::Centred => centred(drawing, false, tally),
            Kind::CentredNormalized => centred(drawing, true, tally),
            Kind::SimultaneousUpDown => rejected(SimultaneousUpDown::new(drawing), drawing, tally),
            Kind::UncentredStaggered => rejected(UncentredStaggered::new(drawing), drawing, tally),
            Kind::CentredWithoutHeadroom => {
                rejected(CentredWithoutHeadroom::new(drawing), drawing, tally)
            }
        };
        if let Err(why) = drawn {
            tally.fault(drawing.curve(), drawing.bits, why.to_string());
        }
        let radius = i64::from(drawing.start[0]);
        let is_circle = self.circuit == Kind::UncentredStaggered && self.drawn == Circles;
        if is_circle && !UncentredStaggered::closes(radius, drawing.bits) {
            tally.fault(drawing.curve(), drawing.bits, "does not close on itself".to_owned());
        }
    }

    fn items(self, parameters: &Parameters) -> Vec<Item> {
        let draw = move |drawing: &Drawing, tally: &mut Tally| self.draw(drawing, tally);
        let name = self.letter.to_string();
        let bits = self.bits(parameters);
        if self.drawn == AllArcs {
            return bits.flat_map(|n| all_arcs(&name, n, self.domain.most(n), draw)).collect();
        }
        let starts = if self.drawn == Circles { 1 } else { 4 };
        bits.flat_map(|n| full_circles(&name, n, self.domain.most(n).isqrt() as i32, starts, draw))
            .collect()
    }

    fn bits(self, parameters: &Parameters) -> RangeInclusive<u32> {
        if self.drawn == AllArcs { parameters.bits.clone() } else { parameters.circle_bits.clone() }
    }
}

/// Draws an arc that the constructor accepts. Normalized with Q = 0 it is the same machine as without,
/// and not drawn twice.
fn centred(drawing: &Drawing, normalize: bool, tally: &mut Tally) -> Result<(), Error> {
    let Drawing { start, end, direction, bits, .. } = *drawing;
    let register = Register::new(Radix::Binary, bits)?;
    let r_squared = start.map(|c| i64::from(c).pow(2)).iter().sum::<i64>();
    match CentredArc::new(start, end, direction, register, normalize) {
        Err(Error::RegisterTooNarrow { .. }) if r_squared > AtMost(1).most(bits) => {}
        Err(why) => return Err(why),
        Ok(arc) if normalize && arc.shift() == 0 => {}
        Ok(arc) => walk(arc, &Drawing { shift: arc.shift(), ..*drawing }, tally),
    }
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

/// Full circles of integer radius from the first of the four axes' points, both senses.
fn full_circles(
    circuit: &str,
    bits: u32,
    largest: i32,
    starts: usize,
    draw: impl Fn(&Drawing, &mut Tally) + Copy + Send + Sync + 'static,
) -> Vec<Item> {
    let item = move |first: i32| {
        Item::new(format!("{circuit} n={bits} R={first}.."), move || {
            let mut tally = Tally::default();
            for r in (first..=largest).take(RADII) {
                for start in [[r, 0], [0, r], [-r, 0], [0, -r]].into_iter().take(starts) {
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
    let of = |row: Row, bits: u32| findings.of(&row.key(bits));
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
         points of one circle for n = {}, full circles from the axes for n = {}.",
        widths(bits),
        widths(circle_bits)
    );
    let mut outcome = Outcome::new("D6", statement, &findings, &about);
    for row in ROWS.into_iter().filter(|row| row.is_claimed()) {
        let tally = sum(row);
        outcome.demand(tally.curves > 0 || !findings.is_complete(), || {
            format!("{}: no arc was drawn", row.name())
        });
        outcome.demand_no_fault(&row.name(), &tally);
        outcome.demand_one_pulse(&row.name(), &tally);
    }
    outcome.tables.push(comparison(parameters, sum));
    outcome.tables.push(by_width(parameters, of));
    outcome.remarks.push(
        "What was measured earlier for \"R < 2^k\" was measured for R ≤ 2^k − 1. The irrational radii between the \
         two make the difference between rows c and d, e and h, i and j. Of row b's earlier figure only n = 12 \
         reaches 0.981; narrower registers, which were not measured then, reach more."
            .to_owned(),
    );
    Ok(outcome)
}

fn comparison(parameters: &Parameters, sum: impl Fn(Row) -> Tally) -> Table {
    let header =
        ["", "circuit", "n", "arcs", "worst", "measured earlier", "over one pulse", "at fault"];
    let mut table = Table::new("Worst radial deviation, circuit by circuit:", &header);
    for row in ROWS {
        let tally = sum(row);
        table.row([
            row.letter.to_string(),
            row.name(),
            widths(&row.bits(parameters)),
            count(tally.curves),
            worst(&tally),
            row.earlier.to_owned(),
            count(tally.over),
            count(tally.faults),
        ]);
    }
    table
}

fn by_width(parameters: &Parameters, of: impl Fn(Row, u32) -> Tally) -> Table {
    let header = ["", "n", "arcs", "worst", "where"];
    let mut table = Table::new("The same by width, with the worst point:", &header);
    for row in ROWS {
        for bits in row.bits(parameters) {
            let tally = of(row, bits);
            table.row([
                row.letter.to_string(),
                bits.to_string(),
                count(tally.curves),
                worst(&tally),
                place(&tally),
            ]);
        }
    }
    table
}
