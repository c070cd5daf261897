//! The claims: `verify/claims.toml`.

use serde::Deserialize;
use std::collections::BTreeSet;

/// All claims.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Claims {
    #[serde(rename = "claim")]
    pub(crate) claims: Vec<Claim>,
}

/// One claim and what discharges it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Claim {
    pub(crate) id: String,
    pub(crate) statement: String,
    /// Widths, methods.
    pub(crate) domain: String,
    /// The file in `core/src` that it is about, without its ending.
    pub(crate) machine: String,
    /// Names of harnesses; with a `*` at the end, all whose names begin so.
    #[serde(default)]
    pub(crate) harnesses: Vec<String>,
    /// Files in `verify/lemmas`, without their ending.
    #[serde(default)]
    pub(crate) lemmas: Vec<String>,
    /// Ids of sweeps.
    #[serde(default)]
    pub(crate) sweeps: Vec<String>,
    /// Tests, as PACKAGE:TEST.
    #[serde(default)]
    pub(crate) tests: Vec<String>,
    /// The claim is false: with what. Its sweeps find it.
    pub(crate) false_with: Option<String>,
    #[serde(default)]
    pub(crate) notes: String,
}

/// What is wrong with the list.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// Not TOML, or not of this form.
    #[error("{0}")]
    Form(String),
    /// Two claims of one name about one machine.
    #[error("claim {id} ({machine}) is there twice")]
    Twice {
        /// Of the claim.
        id: String,
        /// Of the claim.
        machine: String,
    },
    /// A machine that the core does not have.
    #[error("claim {id}: there is no core/src/{machine}.rs")]
    NoMachine {
        /// Of the claim.
        id: String,
        /// What is named.
        machine: String,
    },
    /// A harness that is not there.
    #[error("claim {id}: there is no harness {harness}")]
    NoHarness {
        /// Of the claim.
        id: String,
        /// What is named.
        harness: String,
    },
    /// A claim said to be false without a search for its counterexample.
    #[error("claim {id} is said to be false and has no sweep that finds its counterexample")]
    NoSearch {
        /// Of the claim.
        id: String,
    },
    /// A test that is not of the form PACKAGE:TEST.
    #[error("claim {id}: the test {test} is not named as PACKAGE:TEST")]
    TestForm {
        /// Of the claim.
        id: String,
        /// What is named.
        test: String,
    },
    /// A harness that proves nothing that is claimed.
    #[error("the harness {0} belongs to no claim")]
    Unclaimed(String),
    /// A machine of the core of which nothing is claimed.
    #[error("core/src/{0}.rs has a `step` and no claim")]
    Unguarded(String),
}

impl Claims {
    /// Reads the list's text.
    pub(crate) fn read(text: &str) -> Result<Self, Error> {
        let claims: Self = toml::from_str(text).map_err(|why| Error::Form(why.to_string()))?;
        let mut seen = BTreeSet::new();
        for claim in &claims.claims {
            let (id, machine) = (claim.id.clone(), claim.machine.clone());
            if !seen.insert((id.clone(), machine.clone())) {
                return Err(Error::Twice { id, machine });
            }
            if claim.false_with.is_some() && claim.sweeps.is_empty() {
                return Err(Error::NoSearch { id });
            }
            if let Some(test) = claim.tests.iter().find(|test| !test.contains(':')) {
                return Err(Error::TestForm { id, test: test.clone() });
            }
        }
        Ok(claims)
    }

    /// The list against what there is: harnesses, the core's files, and those of them with a `step`.
    pub(crate) fn check(
        &self,
        harnesses: &[String],
        core: &[String],
        machines: &[String],
    ) -> Result<(), Error> {
        for claim in &self.claims {
            if !core.contains(&claim.machine) {
                let (id, machine) = (claim.id.clone(), claim.machine.clone());
                return Err(Error::NoMachine { id, machine });
            }
            for harness in &claim.harnesses {
                if !harnesses.iter().any(|name| is_named(harness, name)) {
                    let (id, harness) = (claim.id.clone(), harness.clone());
                    return Err(Error::NoHarness { id, harness });
                }
            }
        }
        let unclaimed =
            harnesses.iter().find(|name| !self.claims.iter().any(|claim| claim.has(name)));
        if let Some(harness) = unclaimed {
            return Err(Error::Unclaimed(harness.clone()));
        }
        let unguarded = machines
            .iter()
            .find(|machine| !self.claims.iter().any(|claim| claim.machine == **machine));
        match unguarded {
            Some(machine) => Err(Error::Unguarded(machine.clone())),
            None => Ok(()),
        }
    }
}

impl Claim {
    /// Whether the harness belongs to the claim.
    pub(crate) fn has(&self, harness: &str) -> bool {
        self.harnesses.iter().any(|pattern| is_named(pattern, harness))
    }
}

fn is_named(pattern: &str, name: &str) -> bool {
    match pattern.strip_suffix('*') {
        Some(prefix) => name.starts_with(prefix),
        None => pattern == name,
    }
}

#[cfg(test)]
mod tests;
