//! From what CBMC prints to a verdict. What is not understood is never a proof.

use super::module::{Harness, Module};
use super::source::{self, cover_property};
use serde::Deserialize;
use std::collections::BTreeSet;

/// One element of the array that `cbmc --json-ui` prints.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
struct Printed {
    message_text: Option<String>,
    message_type: Option<String>,
    result: Option<Vec<Property>>,
    c_prover_status: Option<String>,
}

/// A property and what became of it.
#[derive(Debug, Deserialize)]
struct Property {
    description: String,
    property: String,
    status: String,
    #[serde(default)]
    trace: Vec<Step>,
}

/// A step of a counterexample.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
struct Step {
    #[serde(default)]
    hidden: bool,
    #[serde(default)]
    lhs: String,
    #[serde(default)]
    step_type: String,
    value: Option<Value>,
}

#[derive(Debug, Deserialize)]
struct Value {
    binary: Option<String>,
}

/// What the properties say together.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// Everything as it should be, all covers met.
    Proved,
    /// A property fails: its name for CBMC and its text.
    Fails {
        /// For `--property`.
        property: String,
        /// What it says.
        text: String,
    },
    /// Why nothing may have been checked.
    Vacuous(String),
    /// Why there is no verdict.
    Unclear(String),
}

/// The verdict on a harness, and how many of its covers are met.
pub(crate) fn verdict(module: &Module, harness: &Harness, output: &str) -> (Verdict, usize) {
    match read(output) {
        Ok(properties) => judge(module, harness, &properties),
        Err(why) => (Verdict::Unclear(why), 0),
    }
}

/// The properties, if CBMC came to its end and complained of nothing.
fn read(output: &str) -> Result<Vec<Property>, String> {
    let printed: Vec<Printed> =
        serde_json::from_str(output).map_err(|why| format!("CBMC's output is cut off: {why}"))?;
    let mut properties = None;
    let mut has_ended = false;
    for part in printed {
        if let Some(status) = &part.c_prover_status {
            if !["success", "failure"].contains(&status.as_str()) {
                return Err(format!("CBMC ended with {status}"));
            }
            has_ended = true;
        }
        if let (Some(kind), Some(text)) = (&part.message_type, &part.message_text) {
            if kind != "STATUS-MESSAGE" || text.contains("not available") {
                return Err(format!("CBMC says: {text}"));
            }
        }
        if part.result.is_some() && std::mem::replace(&mut properties, part.result).is_some() {
            return Err("CBMC printed two results".to_owned());
        }
    }
    match properties {
        Some(properties) if has_ended => Ok(properties),
        _ => Err("CBMC printed no result".to_owned()),
    }
}

fn judge(module: &Module, harness: &Harness, properties: &[Property]) -> (Verdict, usize) {
    let entry = format!("{}.", source::entry(&harness.name));
    let mut unmet = BTreeSet::new();
    let mut met = 0;
    let mut seen = BTreeSet::new();
    let mut fails = None;
    let mut unclear = None;
    let mut is_end_reached = false;
    for property in properties {
        let holds = match property.status.as_str() {
            "SUCCESS" => true,
            "FAILURE" => false,
            other => {
                unclear = Some(format!("{}: {other}", property.description));
                continue;
            }
        };
        let text = property.description.as_str();
        seen.insert(text);
        let cover = (0..module.covers.len()).find(|index| cover_property(*index) == text);
        if let Some(index) = cover {
            if harness.covers.contains(&index) {
                if holds {
                    unmet.insert(index);
                } else {
                    met += 1;
                }
            } else if !holds {
                unclear = Some(format!("{} is met unexpectedly", module.cover_text(index)));
            }
        } else if text == source::END {
            if property.property.starts_with(&entry) {
                is_end_reached = !holds;
            }
        } else if !holds {
            if text == source::PANIC || text == source::TRAP {
                fails.get_or_insert((property.property.clone(), text.to_owned()));
            } else if text.contains("unwinding assertion") {
                let why = "a loop may run more often than it was unwound: #[kani::unwind(n)]";
                unclear = Some(why.to_owned());
            } else {
                unclear = Some(format!("{text} ({})", property.property));
            }
        }
    }
    for text in [source::END, source::PANIC, source::TRAP, source::KNOWN_COVER] {
        if !seen.contains(text) {
            unclear = Some(format!("CBMC says nothing of the property `{text}`"));
        }
    }
    if met + unmet.len() != harness.covers.len() {
        unclear = Some("CBMC says nothing of a cover".to_owned());
    }
    let verdict = if let Some((property, text)) = fails {
        // A counterexample is one, whatever else is left open.
        Verdict::Fails { property, text }
    } else if let Some(why) = unclear {
        Verdict::Unclear(why)
    } else if !is_end_reached {
        Verdict::Vacuous("no run comes to its end".to_owned())
    } else if let Some(index) = unmet.first() {
        Verdict::Vacuous(format!("the cover at {} is never met", module.cover_text(*index)))
    } else if harness.covers.is_empty() && harness.assumes > 0 {
        Verdict::Vacuous("it assumes something and covers nothing".to_owned())
    } else {
        Verdict::Proved
    };
    (verdict, met)
}

/// What a counterexample's trace tells.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Trace {
    /// Values drawn, in order.
    pub(crate) values: Vec<u64>,
    /// Address of the panic's location.
    pub(crate) location: Option<u32>,
}

/// Reads the trace of the property that fails.
pub(crate) fn trace(output: &str) -> Result<Trace, String> {
    let properties = read(output)?;
    let Some(property) = properties.iter().find(|property| !property.trace.is_empty()) else {
        return Err("CBMC printed no counterexample".to_owned());
    };
    let mut trace = Trace::default();
    for step in &property.trace {
        // A hidden step declares the variable.
        if step.step_type != "assignment" || step.hidden {
            continue;
        }
        let value = || {
            let binary = step.value.as_ref()?.binary.as_ref()?;
            u64::from_str_radix(binary, 2).ok()
        };
        match step.lhs.as_str() {
            "drawn_32" | "drawn_64" => {
                trace.values.push(value().ok_or("a value of the counterexample is missing")?);
            }
            "panic_location" => {
                trace.location = value().and_then(|address| u32::try_from(address).ok());
            }
            _ => {}
        }
    }
    Ok(trace)
}

#[cfg(test)]
mod tests;
