//! The two waves of a run, the model's and the one of Icarus, read back and compared change by
//! change.

use super::fault::Fault;
use super::ports::Ports;
use super::reading::place;
use super::wave::rise;
use onepulse_hwmodel::trace::{Kind, Signal, SignalList};
use std::collections::HashMap;
use std::path::Path;

/// What was compared.
#[derive(Clone, Copy, Debug)]
pub(super) struct Compared {
    pub(super) signals: usize,
    pub(super) changes: usize,
}

/// A signal's changes: when, and to which value, if all bits are known.
type Changes = Vec<(u64, Option<u64>)>;

/// One side's file, read back.
#[derive(Debug)]
struct Wave {
    /// The unit of the time axis.
    timescale: Option<String>,
    /// The changes of every signal as text, by the signal's full name.
    signals: HashMap<String, Vec<(u64, String)>>,
}

/// Compares the clock and every output over so many clocks. `list` has the signals of the model's
/// wave.
///
/// # Errors
/// The first difference: time, signal and both values.
pub(super) fn compare(
    ports: &Ports,
    list: &SignalList,
    clocks: u64,
    model: &Path,
    twin: &Path,
) -> Result<Compared, Fault> {
    let [model, twin] = [read(model)?, read(twin)?];
    if model.timescale != twin.timescale {
        return Err(Fault::Differs("the waves have not the same unit of time".to_owned()));
    }
    let mut compared = Compared { signals: 0, changes: 0 };
    let mut first: Option<(u64, String)> = None;
    for name in ports.outputs.iter().map(|output| &*output.signal).chain(["clk"]) {
        let at = place(list, name).ok_or_else(|| format!("the model has no {name}"))?;
        let signal = &list.signals()[at];
        let ours = model.changes(&model_name(signal), signal.kind)?;
        // Icarus knows no words.
        let theirs = twin.changes(&format!("bench.{name}"), Kind::Unsigned(64))?;
        // Before the first reset the model shows nothing.
        let begin = ours.first().map_or(0, |(time, _)| *time);
        let [ours, theirs] = [ours, theirs].map(|changes| between(&changes, begin, rise(clocks)));
        compared.signals += 1;
        compared.changes += ours.len();
        let Some((time, values)) = difference(&ours, &theirs) else { continue };
        if first.as_ref().is_none_or(|(earliest, _)| time < *earliest) {
            let [ours, theirs] =
                values.map(|value| value.map_or("unknown".to_owned(), |value| value.to_string()));
            let text = format!("{name} is {ours} in the model's wave, {theirs} in the twin's");
            first = Some((time, text));
        }
    }
    match first {
        Some((time, text)) => Err(Fault::Differs(format!("{time} ns: {text}"))),
        None => Ok(compared),
    }
}

/// A signal's name in the model's file.
fn model_name(Signal { scope, name, .. }: &Signal) -> String {
    let dot = if scope.is_empty() { "" } else { "." };
    format!("{}.{scope}{dot}{name}", SignalList::TOP)
}

fn read(path: &Path) -> Result<Wave, String> {
    let mut wave = wellen::simple::read(path).map_err(|e| format!("{}: {e}", path.display()))?;
    let hierarchy = wave.hierarchy();
    let timescale = hierarchy.timescale().map(|scale| format!("{scale:?}"));
    let name = |var: &wellen::Var| (var.full_name(hierarchy), var.signal_ref());
    let signals: Vec<_> = hierarchy.iter_vars().map(name).collect();
    wave.load_signals(&signals.iter().map(|(_, signal)| *signal).collect::<Vec<_>>());
    let times = wave.time_table();
    let changes = |signal| {
        let changes = wave.get_signal(signal).into_iter().flat_map(wellen::Signal::iter_changes);
        changes.map(|(at, value)| (times[at as usize], value.to_string())).collect()
    };
    let signals = signals.into_iter().map(|(name, signal)| (name, changes(signal))).collect();
    Ok(Wave { timescale, signals })
}

impl Wave {
    fn changes(&self, name: &str, kind: Kind) -> Result<Changes, String> {
        let changes = self.signals.get(name).ok_or_else(|| format!("{name} is in no wave"))?;
        let value = |text: &str| match kind {
            Kind::Word(words) => words.iter().position(|word| *word == text).map(|at| at as u64),
            _ => u64::from_str_radix(text, 2).ok(),
        };
        Ok(changes.iter().map(|(time, text)| (*time, value(text))).collect())
    }
}

/// The changes in a span of time, with the value that stands at its begin as the first. Of several
/// changes at one time the last one counts, and one to the same value is none.
fn between(changes: &[(u64, Option<u64>)], begin: u64, end: u64) -> Changes {
    let mut span = Changes::new();
    for &(time, value) in changes.iter().filter(|(time, _)| *time < end) {
        let time = time.max(begin);
        if span.last().is_some_and(|(last, _)| *last == time) {
            span.pop();
        }
        if span.last().is_none_or(|(_, last)| *last != value) {
            span.push((time, value));
        }
    }
    span
}

/// Where two lists of changes first differ: the time, and what each shows then.
fn difference(ours: &Changes, theirs: &Changes) -> Option<(u64, [Option<u64>; 2])> {
    let at = (0..ours.len().max(theirs.len())).find(|at| ours.get(*at) != theirs.get(*at))?;
    let time = [ours, theirs].iter().filter_map(|changes| Some(changes.get(at)?.0)).min()?;
    let value = |changes: &Changes| {
        changes.iter().rev().find(|(change, _)| *change <= time).and_then(|(_, value)| *value)
    };
    Some((time, [value(ours), value(theirs)]))
}

#[cfg(test)]
mod tests {
    use super::*;

    const WAVE: [(u64, Option<u64>); 5] =
        [(0, None), (2, Some(1)), (4, Some(5)), (4, Some(2)), (7, Some(2))];

    #[test]
    fn a_span_begins_with_what_stands_there() {
        assert_eq!(between(&WAVE, 2, 9), [(2, Some(1)), (4, Some(2))]);
        assert_eq!(between(&WAVE, 3, 4), [(3, Some(1))]);
    }

    #[test]
    fn the_earlier_of_two_changes_is_the_difference() {
        let wave = between(&WAVE, 0, 9);
        assert_eq!(difference(&wave, &wave), None);
        let late = vec![(0, None), (2, Some(1)), (6, Some(2))];
        assert_eq!(difference(&wave, &late), Some((4, [Some(2), Some(1)])));
        let short = vec![(0, None), (2, Some(1))];
        assert_eq!(difference(&short, &wave), Some((4, [Some(1), Some(2)])));
        let wrong = vec![(0, None), (2, Some(3)), (4, Some(2))];
        assert_eq!(difference(&wrong, &wave), Some((2, [Some(3), Some(1)])));
    }
}
