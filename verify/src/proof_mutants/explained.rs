//! `verify/mutants.toml`: mutants that nothing can find, and mutants made by hand.

use super::mutant::Mutant;
use serde::Deserialize;

/// The whole file.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Explained {
    #[serde(default)]
    pub(super) survivor: Vec<Survivor>,
    #[serde(default)]
    pub(super) by_hand: Vec<ByHand>,
}

/// A mutant that survives, and why that is no hole in the harnesses.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Survivor {
    pub(super) file: String,
    /// The line as it is.
    pub(super) line: String,
    /// The line as the mutant has it.
    pub(super) mutant: String,
    pub(super) why: String,
}

/// A mutant for a harness that none of the systematic ones is for.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ByHand {
    pub(super) harness: String,
    pub(super) file: String,
    /// What stands once in the file.
    pub(super) replace: String,
    pub(super) by: String,
}

impl Explained {
    pub(super) fn read(text: &str) -> Result<Self, String> {
        toml::from_str(text).map_err(|why| format!("verify/mutants.toml: {why}"))
    }

    /// Why a mutant survives, if that is known.
    pub(super) fn why(&self, mutant: &Mutant) -> Option<&str> {
        self.survivor.iter().find(|survivor| survivor.is_of(mutant)).map(|found| &*found.why)
    }

    /// Entries that fit none of the mutants any more.
    pub(super) fn outdated(&self, mutants: &[Mutant]) -> Vec<&Survivor> {
        let fits = |entry: &&Survivor| mutants.iter().any(|mutant| entry.is_of(mutant));
        self.survivor.iter().filter(|entry| !fits(entry)).collect()
    }
}

impl Survivor {
    fn is_of(&self, mutant: &Mutant) -> bool {
        self.file == mutant.file && self.line == mutant.line && self.mutant == mutant.changed
    }
}

impl ByHand {
    /// The file's text with the change.
    pub(super) fn applied(&self, source: &str) -> Result<String, String> {
        if source.matches(&self.replace).count() == 1 {
            return Ok(source.replacen(&self.replace, &self.by, 1));
        }
        Err(format!("{}: \"{}\" does not stand there once", self.file, self.replace))
    }
}
