//! What stands round a circuit in a trace: its clock, its pulse outputs and position counters.

use super::{Kind, SignalList, Tracer, Wave};
use crate::Circuit;
use onepulse_core::Pulse;

/// The letters of the axes, in the order of their coordinates.
pub(super) const AXIS_LETTERS: [&str; 9] = ["x", "y", "z", "a", "b", "c", "u", "v", "w"];

/// The top scope of a trace: `clk`, and for each axis the pulse, its direction (1: negative) and
/// an up/down counter of the position, which counts the pulse at the following clock edge.
#[derive(Clone, Debug)]
pub struct Bench {
    clk: usize,
    axes: Vec<Outputs>,
}

#[derive(Clone, Copy, Debug)]
struct Outputs {
    pulse: usize,
    negative: usize,
    position: usize,
    counted: i64,
    is_negative: bool,
}

impl Bench {
    /// Bits of a position counter: any `i32` coordinate, and what an arc may step beyond it.
    const POSITION_BITS: u32 = 34;

    /// Adds the signals of so many axes to the list; the position counters start at `position`.
    pub fn declare(list: &mut SignalList, position: &[i64]) -> Self {
        let clk = list.add("clk", Kind::Bit);
        let mut each = |stem: &str, kind| -> Vec<usize> {
            let letters = AXIS_LETTERS.iter().take(position.len());
            letters.map(|letter| list.add(&format!("{stem}_{letter}"), kind)).collect()
        };
        let pulse = each("pulse", Kind::Bit);
        let negative = each("negative", Kind::Bit);
        let counter = each("position", Kind::Signed(Self::POSITION_BITS));
        let outputs = pulse.into_iter().zip(negative).zip(counter).zip(position);
        let axes = outputs.map(|(((pulse, negative), position), &counted)| Outputs {
            pulse,
            negative,
            position,
            counted,
            is_negative: false,
        });
        Self { clk, axes: axes.collect() }
    }

    /// Traces one clock period of a circuit, whose first signal is number `first`, and lets the
    /// circuit take the edge that ends it. The period begins at the time `rise`, and the clock
    /// falls at `fall`.
    ///
    /// The tracer keeps an error of the output for its [`check`](Tracer::check).
    pub fn clock<W: Wave, C: Circuit<AXES>, const AXES: usize>(
        &mut self,
        tracer: &mut Tracer<W>,
        first: usize,
        circuit: &mut C,
        rise: u64,
        fall: u64,
    ) -> Pulse<AXES> {
        self.sample(tracer, first, circuit, rise);
        tracer.at(fall);
        tracer.set(self.clk, 0);
        self.skip(circuit)
    }

    /// Lets the circuit take a clock edge without a trace.
    pub fn skip<C: Circuit<AXES>, const AXES: usize>(&mut self, circuit: &mut C) -> Pulse<AXES> {
        let pulses = circuit.clock();
        for (axis, pulse) in self.axes.iter_mut().zip(pulses.0) {
            axis.counted += i64::from(pulse);
            if pulse != 0 {
                axis.is_negative = pulse < 0;
            }
        }
        pulses
    }

    /// Traces what stands round a circuit that is given no clocks from `time` on: the clock is low, and
    /// nothing is sent.
    pub fn rest<W: Wave>(&self, tracer: &mut Tracer<W>, time: u64) {
        tracer.at(time);
        tracer.set(self.clk, 0);
        for axis in &self.axes {
            tracer.set(axis.pulse, 0);
            tracer.set(axis.negative, u64::from(axis.is_negative));
            tracer.set(axis.position, axis.counted as u64);
        }
    }

    /// Traces a rising clock edge and what a circuit shows after it.
    pub fn sample<W: Wave, C: Circuit<AXES>, const AXES: usize>(
        &mut self,
        tracer: &mut Tracer<W>,
        first: usize,
        circuit: &C,
        rise: u64,
    ) {
        tracer.at(rise);
        tracer.set(self.clk, 1);
        for (axis, pulse) in self.axes.iter_mut().zip(circuit.pulses().0) {
            tracer.set(axis.pulse, u64::from(pulse != 0));
            if pulse != 0 {
                axis.is_negative = pulse < 0;
            }
            tracer.set(axis.negative, u64::from(axis.is_negative));
            tracer.set(axis.position, axis.counted as u64);
        }
        tracer.sample(first, circuit);
    }
}
