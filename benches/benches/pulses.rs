//! The pulse machines, one pulse at a time, with the peers beside them.
#![allow(missing_docs, clippy::unwrap_used)]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use onepulse_benches::{LINE, RADIUS, loops};
use onepulse_core::dda::{self, Preset, Radix, Register};
use onepulse_core::{Direction, EndRule, Pulse, brm, ppc};
use std::hint::black_box;

fn sum(pulses: impl Iterator<Item = Pulse>) -> u64 {
    pulses.fold(0, |sum, Pulse([x, y])| sum + u64::from(x as u8) + 2 * u64::from(y as u8))
}

fn lines(c: &mut Criterion) {
    let register = Register::new(Radix::Binary, 20).unwrap();
    let mut group = c.benchmark_group("line");
    group.throughput(Throughput::Elements((LINE[0] + LINE[1]) as u64));
    let mut bench = |name: &str, run: &dyn Fn([i32; 2]) -> u64| {
        group.bench_function(BenchmarkId::from_parameter(name), |b| {
            b.iter(|| run(black_box(LINE)));
        });
    };
    bench("ppc", &|end| sum(ppc::Line::new(end, EndRule::Total).unwrap()));
    bench("dda", &|end| sum(dda::Line::new(end, register, Preset::Zero, false).unwrap()));
    bench("brm", &|end| sum(brm::Line::new(end, 20).unwrap()));
    bench("peer: firmware loop", &loops::firmware);
    bench("peer: line_drawing", &|end| {
        let points = line_drawing::Bresenham::new((0, 0), (end[0], end[1]));
        points.fold(0, |sum, (x, y)| sum ^ (x as u64) ^ (y as u64))
    });
    bench("peer: bresenham", &|end| {
        let points = bresenham::Bresenham::new((0, 0), (end[0] as isize, end[1] as isize));
        points.fold(0, |sum, (x, y)| sum ^ (x as u64) ^ (y as u64))
    });
}

fn arcs(c: &mut Criterion) {
    let (start, ccw) = ([RADIUS, 0], Direction::Ccw);
    let register = Register::new(Radix::Binary, 19).unwrap();
    let mut group = c.benchmark_group("circle");
    group.throughput(Throughput::Elements(8 * RADIUS as u64));
    group.bench_function("ppc", |b| {
        b.iter(|| sum(ppc::Arc::new(black_box(start), start, ccw, EndRule::Total).unwrap()));
    });
    group.bench_function("dda centred", |b| {
        b.iter(
            || sum(dda::CentredArc::new(black_box(start), start, ccw, register, false).unwrap()),
        );
    });
}

criterion_group!(benches, lines, arcs);
criterion_main!(benches);
