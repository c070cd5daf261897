//! The signals of a trace.

use super::bench::AXIS_LETTERS;
use super::{Kind, Probe};
use crate::Circuit;
use std::collections::HashSet;
use std::io;

/// One signal of a trace.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signal {
    /// The scope below the top one; empty for the top scope itself.
    pub scope: &'static str,
    /// The signal's name.
    pub name: String,
    /// What its value means.
    pub kind: Kind,
}

/// The signals of a trace, in the order of their numbers.
///
/// As a [`Probe`] it takes in what is shown to it, in the scope that was named last.
#[derive(Clone, Debug, Default)]
pub struct SignalList {
    signals: Vec<Signal>,
    scope: &'static str,
}

impl SignalList {
    /// The name of the scope that contains all others.
    pub const TOP: &str = "onepulse";

    /// An empty list.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The signals.
    #[must_use]
    pub fn signals(&self) -> &[Signal] {
        &self.signals
    }

    /// Adds a signal to the top scope; its number.
    pub fn add(&mut self, name: &str, kind: Kind) -> usize {
        self.signals.push(Signal { scope: "", name: name.to_owned(), kind });
        self.signals.len() - 1
    }

    /// Some of the signals, in another order, for a layout: those of each scope that is named, or
    /// the one signal (`scope.name`), unless they came before.
    #[must_use]
    pub fn arranged(&self, parts: &[&str]) -> Self {
        let mut signals: Vec<Signal> = Vec::new();
        for part in parts {
            for signal in &self.signals {
                let is_part = match part.split_once('.') {
                    Some(path) => path == (signal.scope, signal.name.as_str()),
                    None => *part == signal.scope,
                };
                if is_part && !signals.contains(signal) {
                    signals.push(signal.clone());
                }
            }
        }
        Self { signals, scope: self.scope }
    }

    /// Adds the signals of a circuit, in a scope of its name; the number of the first one.
    pub fn add_circuit<C: Circuit<AXES>, const AXES: usize>(&mut self, circuit: &C) -> usize {
        self.add_circuit_in(C::NAME, circuit)
    }

    /// Likewise, in a scope of this name: for a second circuit of one name, as with more axes.
    pub fn add_circuit_in<C: Circuit<AXES>, const AXES: usize>(
        &mut self,
        scope: &'static str,
        circuit: &C,
    ) -> usize {
        let first = self.signals.len();
        self.scope(scope);
        circuit.probe(self);
        first
    }

    /// Refuses what a wave file would take without a word and no viewer could show: two signals
    /// of one name in one scope, a blank in a name or a word, a width that is not 1 to 64.
    pub(super) fn check(&self) -> io::Result<()> {
        let refuse = |why: String| Err(io::Error::new(io::ErrorKind::InvalidInput, why));
        let mut seen = HashSet::new();
        for Signal { scope, name, kind } in &self.signals {
            if !seen.insert((scope, name)) {
                return refuse(format!("two signals are named {scope}.{name}"));
            }
            let is_blank = |text: &str| text.is_empty() || text.contains(char::is_whitespace);
            let words: &[&str] = if let Kind::Word(words) = kind { words } else { &[] };
            if is_blank(name) || words.iter().any(|word| is_blank(word)) {
                return refuse(format!("a name or a word of {scope}.{name} is blank"));
            }
            if !(1..=64).contains(&kind.bits()) {
                return refuse(format!("{scope}.{name} is {} bits wide", kind.bits()));
            }
        }
        Ok(())
    }
}

impl Probe for SignalList {
    fn axis_signal(&mut self, stem: &'static str, axis: usize, kind: Kind, _: u64) {
        let letter = AXIS_LETTERS[axis];
        self.signals.push(Signal { scope: self.scope, name: format!("{stem}{letter}"), kind });
    }

    fn scope(&mut self, name: &'static str) {
        self.scope = name;
    }

    fn signal(&mut self, name: &'static str, kind: Kind, _: u64) {
        self.signals.push(Signal { scope: self.scope, name: name.to_owned(), kind });
    }
}
