//! D6 for small radii: what the argument for every n leaves to enumeration.

use super::driver::{Driver, Item};
use super::outcome::Outcome;
use super::rings::{DIRECTIONS, circles};
use super::table::{Table, count, place, worst};
use super::tally::Tally;
use super::walk::{Drawing, walk};
use onepulse_core::dda::{CentredArc, Radix, Register};
use onepulse_core::{Direction, Error};

/// What is swept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameters {
    /// The largest radius.
    pub radius: u32,
    /// How many widths for each radius, beginning with the narrowest that has four headroom bits,
    /// R ≤ 2^(n−4).
    pub widths: u32,
}

impl Default for Parameters {
    fn default() -> Self {
        Self { radius: 64, widths: 5 }
    }
}

/// The narrowest register with R ≤ 2^(n−4).
fn narrowest(r_squared: i64) -> u32 {
    (4..32).find(|n| r_squared <= 1_i64 << (2 * (n - 4))).unwrap_or(32)
}

fn draw(start: [i32; 2], direction: Direction, bits: u32, tally: &mut Tally) -> Result<(), Error> {
    let drawing = Drawing { start, end: start, direction, bits, shift: 0 };
    let register = Register::new(Radix::Binary, bits)?;
    walk(CentredArc::new(start, start, direction, register, false)?, &drawing, tally);
    Ok(())
}

fn name(more: u32) -> String {
    format!("full circles {more} bits more")
}

/// Runs the sweep.
///
/// # Errors
/// Files of finished items that cannot be used.
pub fn run(parameters: &Parameters, driver: &Driver) -> Result<Outcome, String> {
    let Parameters { radius, widths } = *parameters;
    let most = i64::from(radius).pow(2);
    let mut items = Vec::new();
    for more in 0..widths {
        for ring in 1..=radius as i32 {
            items.push(Item::new(format!("{} R={ring}..", name(more)), move || {
                let mut tally = Tally::default();
                for (square, circle) in circles(ring, most) {
                    let bits = narrowest(square) + more;
                    for start in circle {
                        for direction in DIRECTIONS {
                            if let Err(why) = draw(start, direction, bits, &mut tally) {
                                let end = start;
                                let drawing = Drawing { start, end, direction, bits, shift: 0 };
                                tally.fault(drawing.curve(), bits, why.to_string());
                            }
                        }
                    }
                }
                tally
            }));
        }
    }
    let findings = driver.run(&format!("D6-small radius {radius} widths {widths}"), &items)?;
    let about = findings.of("full circles");
    let statement = format!(
        "With four headroom bits, R ≤ 2^(n−4), the centred staggered circle keeps within one pulse and \
         closes exactly: every lattice circle with R ≤ {radius}, full turns from each of its points in \
         both senses, {widths} widths beginning with the narrowest that has the four bits."
    );
    let mut outcome = Outcome::new("D6-small", statement, &findings, &about);
    outcome.demand_no_fault("centred staggered", &about);
    outcome.demand_one_pulse("centred staggered", &about);

    let header = ["headroom bits", "circles", "worst", "where"];
    let mut table = Table::new("Worst radial deviation by width:", &header);
    for more in 0..widths {
        let tally = findings.of(&name(more));
        table.row([format!("{}", 4 + more), count(tally.curves), worst(&tally), place(&tally)]);
    }
    outcome.tables.push(table);
    Ok(outcome)
}
