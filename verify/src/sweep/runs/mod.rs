//! RUNS: whole runs of every machine at narrow widths, beside the proofs by induction.
//!
//! Each run is held against the independent formula of this crate, point by point, and its
//! deviation against the method's bound, in integers.

mod brm_lines;
mod dda_lines;
mod ppc_arcs;
mod ppc_lines;
mod ppc_off_circle;
mod step_arcs;
mod step_lines;

use super::curve::{Case, Curve};
use super::driver::{Driver, Item};
use super::outcome::Outcome;
use super::table::{Table, count, worst};
use super::tally::Tally;
use onepulse_core::Pulse;

/// What is swept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameters {
    /// The width of the registers, for lines by digital integration and by the rate multiplier.
    pub bits: u32,
    /// The largest radius, for arcs without registers.
    pub radius: u32,
    /// The largest coordinate, for lines without registers.
    pub coordinate: u32,
}

impl Default for Parameters {
    fn default() -> Self {
        Self { bits: 6, radius: 40, coordinate: 60 }
    }
}

/// A machine, or a machine with one of its options.
pub(crate) struct Machine {
    name: String,
    /// What is demanded of every run.
    bound: &'static str,
    items: Vec<Item>,
}

/// A path, its points cycle by cycle, the start first. One cycle more than the `longest` is not
/// followed any further: the machine does not end.
fn path(start: [i64; 2], cycles: impl Iterator<Item = Pulse>, longest: usize) -> Vec<[i64; 2]> {
    let mut point = start;
    let mut path = vec![start];
    for Pulse([dx, dy]) in cycles.take(longest + 1) {
        point = [point[0] + i64::from(dx), point[1] + i64::from(dy)];
        path.push(point);
    }
    path
}

/// Takes in a path with what was found wrong with it.
fn take(
    tally: &mut Tally,
    curve: Curve,
    bits: u32,
    path: &[[i64; 2]],
    checked: Result<(), String>,
) {
    tally.curves += 1;
    tally.cycles += path.len() as u64 - 1;
    let case =
        |(cycle, &point): (usize, &[i64; 2])| Case { curve, bits, cycle: cycle as u64, point };
    let cases: Vec<_> = path.iter().enumerate().map(case).collect();
    let worst = cases.iter().max_by(|a, b| a.deviation().total_cmp(&b.deviation()));
    tally.stray(worst.map_or(&[], std::slice::from_ref));
    if let Err(why) = checked {
        tally.fault(curve, bits, why);
    }
}

/// For the checks of a path: an error unless it holds.
fn demand(holds: bool, otherwise: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(otherwise()) }
}

/// One item for every x of −`most` … `most`; `draw` is given each end point (x, y).
fn every_end(
    name: &str,
    most: i32,
    draw: impl Fn([i32; 2], &mut Tally) + Copy + Send + Sync + 'static,
) -> Vec<Item> {
    let item = |x: i32| {
        Item::new(format!("{name} x={x}"), move || {
            let mut tally = Tally::default();
            for y in -most..=most {
                draw([x, y], &mut tally);
            }
            tally
        })
    };
    (-most..=most).map(item).collect()
}

/// Runs the sweep.
///
/// # Errors
/// Files of finished items that cannot be used.
pub fn run(parameters: &Parameters, driver: &Driver) -> Result<Outcome, String> {
    let Parameters { bits, radius, coordinate } = *parameters;
    let mut machines =
        vec![ppc_lines::machine(coordinate as i32), ppc_arcs::machine(radius as i32)];
    machines.push(ppc_off_circle::machine());
    machines.extend(step_lines::machines(coordinate as i32));
    machines.extend(step_arcs::machines(radius as i32));
    machines.extend(dda_lines::machines(bits));
    machines.push(brm_lines::machine(bits));
    let mut items = Vec::new();
    for machine in &mut machines {
        items.append(&mut machine.items);
    }
    let findings =
        driver.run(&format!("RUNS bits {bits} radius {radius} coordinate {coordinate}"), &items)?;

    let of = |machine: &Machine| findings.of(&machine.name);
    let mut about = Tally::default();
    for machine in &machines {
        about.add(&of(machine));
    }
    let statement = format!(
        "Whole runs of every machine at narrow widths follow the independent formula of their method point \
         by point, keep its bound, and end exactly: point-by-point comparison, minimum deviation, vector \
         discrimination and comparison integration to ±{coordinate} and on all lattice circles with \
         R ≤ {radius} (through every point of theirs on the way), digital integration and the rate multiplier with {bits} bits."
    );
    let mut outcome = Outcome::new("RUNS", statement, &findings, &about);
    let header = ["machine", "demanded", "runs", "cycles", "worst", "at fault"];
    let mut table = Table::new("Whole runs:", &header);
    for machine in &machines {
        let tally = of(machine);
        table.row([
            machine.name.clone(),
            machine.bound.to_owned(),
            count(tally.curves),
            count(tally.cycles),
            worst(&tally),
            count(tally.faults),
        ]);
        outcome.demand_no_fault(&machine.name, &tally);
        outcome.demand(tally.curves > 0 || !findings.is_complete(), || {
            format!("{}: nothing was run", machine.name)
        });
    }
    outcome.tables.push(table);
    Ok(outcome)
}
