//! The bars of the core, as ratios to peers in the same run.
#![allow(missing_docs, clippy::unwrap_used)]

use onepulse_benches::stopwatch::{Runner, medians};
use onepulse_benches::{LINE, RADIUS, loops};
use onepulse_core::dda::{self, Preset, Radix, Register};
use onepulse_core::{Direction, EndRule, Pulse, ppc};
use std::hint::black_box;

fn sum(pulses: impl Iterator<Item = Pulse>) -> u64 {
    pulses.fold(0, |sum, Pulse([x, y])| sum + u64::from(x as u8) + 2 * u64::from(y as u8))
}

fn main() {
    // `cargo test` builds benches and runs them with --test: there is nothing to time then.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    let pulses = f64::from(LINE[0] + LINE[1]);
    let points = f64::from(LINE[0]);
    let register = Register::new(Radix::Binary, 20).unwrap();
    let (start, ccw) = ([RADIUS, 0], Direction::Ccw);
    let runners = [
        Runner::new("firmware loop", pulses, || loops::firmware(black_box(LINE))),
        Runner::new("point-by-point loop", pulses, || loops::point_by_point(black_box(LINE))),
        Runner::new("two accumulators", pulses, || loops::accumulators(black_box(LINE))),
        Runner::new("line_drawing (points)", points, || {
            let end = black_box(LINE);
            line_drawing::Bresenham::new((0, 0), (end[0], end[1]))
                .fold(0, |sum, (x, y)| sum ^ (x as u64) ^ (y as u64))
        }),
        Runner::new("bresenham (points)", points, || {
            let end = black_box(LINE).map(|c| c as isize);
            bresenham::Bresenham::new((0, 0), (end[0], end[1]))
                .fold(0, |sum, (x, y)| sum ^ (x as u64) ^ (y as u64))
        }),
        Runner::new("onepulse ppc line", pulses, || {
            sum(ppc::Line::new(black_box(LINE), EndRule::Total).unwrap())
        }),
        Runner::new("onepulse dda line", pulses, || {
            sum(dda::Line::new(black_box(LINE), register, Preset::Zero, false).unwrap())
        }),
        Runner::new("onepulse ppc circle", 8.0 * f64::from(RADIUS), || {
            sum(ppc::Arc::new(black_box(start), start, ccw, EndRule::Total).unwrap())
        }),
    ];
    let rates = medians(&runners, 15);
    for (runner, rate) in runners.iter().zip(&rates) {
        println!("{:24} {:7.3} G pulses/s", runner.name, rate / 1e9);
    }
    let peer = rates[..5].iter().copied().fold(0.0, f64::max);
    println!("ppc line  / fastest peer {:5.2}  (bar 1.0)", rates[5] / peer);
    println!("dda line  / fastest peer {:5.2}  (bar 1.0)", rates[6] / peer);
    println!("ppc circle / ppc line    {:5.2}  (bar 0.7)", rates[7] / rates[5]);
}
