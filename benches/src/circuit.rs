//! Runs of a circuit of any number of clocks: when it is done, the command is loaded again, which
//! takes a clock as in its Verilog twin.

use onepulse_core::Pulse;
use onepulse_hwmodel::Circuit;
use onepulse_hwmodel::trace::{BackgroundWriter, Bench, Clock, Fst, SignalList, Tracer, Vcd, Wave};
use std::fs::File;
use std::io::{self, BufWriter};
use std::path::Path;

/// The clock of the waves: half periods of 1 ns.
const HERTZ: u64 = 500_000_000;

/// Runs a circuit without a wave. Returns the sum of its pulse wires, as a number, over the
/// clocks.
#[must_use]
pub fn untraced<C: Circuit<AXES> + Clone, const AXES: usize>(loaded: &C, clocks: u64) -> u64 {
    let mut circuit = loaded.clone();
    let mut sum = 0;
    for _ in 0..clocks {
        if circuit.done() {
            circuit = loaded.clone();
        } else {
            sum += wires(circuit.clock());
        }
    }
    sum
}

/// Runs a circuit with its wave in a VCD file.
///
/// # Errors
/// The file's.
pub fn vcd<C: Circuit<AXES> + Clone, const AXES: usize>(
    loaded: &C,
    clocks: u64,
    file: &Path,
) -> io::Result<u64> {
    traced(loaded, clocks, |list, unit| {
        Vcd::new(BackgroundWriter::new(File::create(file)?)?, list, unit)
    })
}

/// Runs a circuit with its wave in an FST file.
///
/// # Errors
/// The file's.
pub fn fst<C: Circuit<AXES> + Clone, const AXES: usize>(
    loaded: &C,
    clocks: u64,
    file: &Path,
) -> io::Result<u64> {
    traced(loaded, clocks, |list, unit| Fst::new(BufWriter::new(File::create(file)?), list, unit))
}

fn traced<W: Wave, C: Circuit<AXES> + Clone, const AXES: usize>(
    loaded: &C,
    clocks: u64,
    open: impl FnOnce(&SignalList, i8) -> io::Result<W>,
) -> io::Result<u64> {
    let mut list = SignalList::new();
    let mut bench = Bench::declare(&mut list, &[0; AXES]);
    let first = list.add_circuit(loaded);
    let clock = Clock::new(HERTZ).ok_or(io::ErrorKind::InvalidInput)?;
    let mut tracer = Tracer::new(open(&list, clock.exponent())?, &list);
    let mut circuit = loaded.clone();
    let mut sum = 0;
    for k in 0..clocks {
        let is_done = circuit.done();
        sum += wires(bench.clock(&mut tracer, first, &mut circuit, clock.rise(k), clock.fall(k)));
        tracer.check()?;
        if is_done {
            circuit = loaded.clone();
        }
    }
    tracer.finish(clock.rise(clocks))?;
    Ok(sum)
}

/// The pulse wires as a number, without the directions.
fn wires<const AXES: usize>(Pulse(pulses): Pulse<AXES>) -> u64 {
    (0..AXES).map(|axis| u64::from(pulses[axis] as u8 & 1) << axis).sum()
}
