//! The signals of a circuit as words.

use onepulse_hwmodel::Circuit;
use onepulse_hwmodel::trace::{Kind, Probe, Signal, SignalList};

/// The values of a circuit's signals, in the circuit's order.
#[derive(Debug)]
pub(super) struct Reading {
    pub(super) words: Vec<u64>,
}

impl Reading {
    /// Puts the signals of a circuit behind these words.
    pub(super) fn after<C: Circuit<AXES>, const AXES: usize>(words: Vec<u64>, circuit: &C) -> Self {
        let mut reading = Self { words };
        circuit.probe(&mut reading);
        reading
    }
}

impl Probe for Reading {
    fn axis_signal(&mut self, stem: &'static str, _: usize, kind: Kind, value: u64) {
        self.signal(stem, kind, value);
    }

    fn signal(&mut self, _: &'static str, kind: Kind, value: u64) {
        // A word's value is its place, whatever the number of bits.
        let bits = if let Kind::Word(_) = kind { 64 } else { kind.bits() };
        self.words.push(value & (u64::MAX >> (64 - bits)));
    }
}

/// The values of a circuit's signals by name.
#[derive(Debug)]
pub(super) struct Registers {
    list: SignalList,
    words: Vec<u64>,
}

impl Registers {
    pub(super) fn of<C: Circuit<AXES>, const AXES: usize>(circuit: &C) -> Self {
        let mut list = SignalList::new();
        list.add_circuit(circuit);
        Self { list, words: Reading::after(Vec::new(), circuit).words }
    }

    /// The value of a signal; 0 if there is none of that name.
    pub(super) fn get(&self, name: &str) -> u64 {
        place(&self.list, name).map_or(0, |at| self.words[at])
    }
}

/// The number of the first signal of that name, alone or with its scope before an underscore.
pub(super) fn place(list: &SignalList, name: &str) -> Option<usize> {
    let is_named = |Signal { scope, name: own, .. }: &Signal| {
        let rest = name.strip_prefix(scope).and_then(|rest| rest.strip_prefix('_'));
        own == name || rest == Some(own)
    };
    list.signals().iter().position(is_named)
}
