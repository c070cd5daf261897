//! The worked examples of the textbooks: software and circuits reproduce every number.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use onepulse_core::dda::{self, Preset, Radix, Register};
use onepulse_core::{Direction, EndRule, Pulse, brm, ppc};
use onepulse_hwmodel::{self as hw, Circuit};
use onepulse_plan::{Length, sampling};
use serde::Deserialize;

#[derive(Deserialize)]
struct Golden {
    case: Vec<Case>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case)]
struct Case {
    name: String,
    #[allow(dead_code)]
    source: String,
    curve: Option<String>,
    method: Option<String>,
    start: Option<[i32; 2]>,
    to: Option<[i32; 2]>,
    ccw: Option<bool>,
    bits: Option<u32>,
    radix: Option<u32>,
    digits: Option<u32>,
    preset: Option<String>,
    update: Option<String>,
    accumulations: Option<u64>,
    F: Option<Vec<i64>>,
    x_remainder: Option<Vec<u64>>,
    y_remainder: Option<Vec<u64>>,
    x_clocks: Option<Vec<u64>>,
    y_clocks: Option<Vec<u64>>,
    pulses: Option<Vec<(u64, i8, i8)>>,
    feed_mm_per_min: Option<f64>,
    period_ms: Option<f64>,
    step_um: Option<f64>,
}

/// The cycles that emit a pulse.
fn emitted(cycles: impl Iterator<Item = Pulse>) -> Vec<(u64, i8, i8)> {
    (1..).zip(cycles).filter(|(_, p)| !p.is_none()).map(|(k, Pulse([x, y]))| (k, x, y)).collect()
}

/// The pulses of the software machine and of its circuit.
fn interpolate(case: &Case) -> Vec<Vec<(u64, i8, i8)>> {
    let to = case.to.unwrap();
    match (case.method.as_deref().unwrap(), case.curve.as_deref().unwrap()) {
        ("ppc", "line") => {
            let mut line = ppc::Line::new(to, EndRule::Total).unwrap();
            let cycles = emitted(line);
            let mut f = vec![line.deviation_function()];
            while line.step().is_some() {
                f.push(line.deviation_function());
            }
            assert_eq!(Some(&f), case.F.as_ref(), "{}", case.name);
            vec![cycles, emitted(hw::ppc::Line::new(to, 3, EndRule::Total).unwrap().cycles())]
        }
        ("ppc", "arc") => {
            assert_eq!(case.ccw, Some(true));
            let (start, ccw) = (case.start.unwrap(), Direction::Ccw);
            let mut arc = ppc::Arc::new(start, to, ccw, EndRule::Total).unwrap();
            let cycles = emitted(arc);
            let mut f = vec![arc.deviation_function()];
            while arc.step().is_some() {
                f.push(arc.deviation_function());
            }
            assert_eq!(Some(&f), case.F.as_ref(), "{}", case.name);
            let circuit = hw::ppc::Arc::new(start, to, ccw, 3, EndRule::Total).unwrap();
            vec![cycles, emitted(circuit.cycles())]
        }
        ("dda", "line") if case.radix == Some(10) => {
            let register = Register::new(Radix::Decimal, case.digits.unwrap()).unwrap();
            let mut line = dda::Line::new(to, register, Preset::Zero, false).unwrap();
            let cycles = emitted(line);
            let mut remainders = [vec![], vec![]];
            while line.step().is_some() {
                remainders[0].push(line.remainders()[0]);
                remainders[1].push(line.remainders()[1]);
            }
            let [x, y] = remainders;
            assert_eq!((Some(x), Some(y)), (case.x_remainder.clone(), case.y_remainder.clone()));
            vec![cycles]
        }
        ("dda", "line") => {
            let bits = case.bits.unwrap();
            let register = Register::new(Radix::Binary, bits).unwrap();
            let line = dda::Line::new(to, register, Preset::Zero, false).unwrap();
            assert_eq!(Some(line.remaining()), case.accumulations);
            let circuit = hw::dda::Line::new(to, bits, Preset::Zero, false).unwrap();
            vec![emitted(line), emitted(circuit.cycles())]
        }
        ("dda", "arc") => {
            assert_eq!(case.update.as_deref(), Some("simultaneous"));
            assert_eq!(case.preset.as_deref(), Some("zero"));
            let (start, bits, ccw) = (case.start.unwrap(), case.bits.unwrap(), Direction::Ccw);
            let register = Register::new(Radix::Binary, bits).unwrap();
            let arc = dda::Arc::new(start, to, ccw, register, Preset::Zero, false).unwrap();
            let circuit = hw::dda::Arc::new(start, to, ccw, bits, Preset::Zero, false).unwrap();
            vec![emitted(arc), emitted(circuit.cycles())]
        }
        ("brm", "line") => {
            let bits = case.bits.unwrap();
            let line = brm::Line::new(to, bits).unwrap();
            let clocks = |axis: usize| {
                let train = (1..).zip(line).filter(|(_, pulse)| pulse.0[axis] != 0);
                Some(train.map(|(clock, _)| clock).collect::<Vec<u64>>())
            };
            assert_eq!((clocks(0), clocks(1)), (case.x_clocks.clone(), case.y_clocks.clone()));
            vec![emitted(line), emitted(hw::brm::Line::new(to, bits).unwrap().cycles())]
        }
        (method, curve) => panic!("{}: no machine for {method} {curve}", case.name),
    }
}

#[test]
fn every_worked_example() {
    let text = include_str!("../golden/worked-examples.toml");
    let golden: Golden = toml::from_str(text).unwrap();
    assert_eq!(golden.case.len(), 8);
    for case in &golden.case {
        if let Some(feed) = case.feed_mm_per_min {
            let feed: Length = feed.to_string().parse().unwrap();
            let step = 1000.0 * sampling::step(feed, case.period_ms.unwrap() / 1000.0);
            assert!((step - case.step_um.unwrap()).abs() < 1e-9, "{}: {step}", case.name);
            continue;
        }
        for cycles in interpolate(case) {
            assert_eq!(Some(&cycles), case.pulses.as_ref(), "{}", case.name);
        }
    }
}
