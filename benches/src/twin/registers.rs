//! A circuit's registers as it is loaded.

use onepulse_hwmodel::Circuit;
use onepulse_hwmodel::trace::{Kind, Probe, SignalList};

/// Name, width and first content of everything that a circuit shows.
#[derive(Clone, Debug)]
pub(super) struct Registers(Vec<Register>);

#[derive(Clone, Debug)]
struct Register {
    name: String,
    bits: u32,
    loaded: u64,
}

impl Registers {
    pub(super) fn of<C: Circuit<AXES>, const AXES: usize>(circuit: &C) -> Self {
        let mut list = SignalList::new();
        list.add_circuit(circuit);
        let mut contents = Contents(Vec::new());
        circuit.probe(&mut contents);
        let registers = list.signals().iter().zip(contents.0).map(|(signal, content)| {
            let bits = match signal.kind {
                // The circuit has a number where the wave has a word.
                Kind::Word(words) => words.len().next_power_of_two().trailing_zeros().max(1),
                kind => kind.bits(),
            };
            let loaded = content & u64::MAX >> (64 - bits);
            Register { name: signal.name.clone(), bits, loaded }
        });
        Self(registers.collect())
    }

    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|register| register.name.as_str())
    }

    /// The width; 0 if the circuit has no such register.
    pub(super) fn bits(&self, name: &str) -> u32 {
        self.find(name).map_or(0, |register| register.bits)
    }

    /// The first content; 0 if the circuit has no such register.
    pub(super) fn loaded(&self, name: &str) -> u64 {
        self.find(name).map_or(0, |register| register.loaded)
    }

    fn find(&self, name: &str) -> Option<&Register> {
        self.0.iter().find(|register| register.name == name)
    }
}

struct Contents(Vec<u64>);

impl Probe for Contents {
    fn axis_signal(&mut self, stem: &'static str, _: usize, kind: Kind, value: u64) {
        self.signal(stem, kind, value);
    }

    fn signal(&mut self, _: &'static str, _: Kind, value: u64) {
        self.0.push(value);
    }
}
