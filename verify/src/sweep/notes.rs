//! The file of finished items, from which a sweep that was broken off is resumed.
//!
//! ```text
//! # finished items of an exhaustive sweep
//! # D6 bits 4..=7 circle-bits 4..=12
//! centred n=4 R=1..: curves = 32; cycles = 1604; …
//! ```
//!
//! It belongs to one state of the program: whoever changes a circuit begins anew.

use super::tally::Tally;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What the first line says.
const TITLE: &str = "# finished items of an exhaustive sweep";

/// How long finished items may wait to be written.
const PAUSE: Duration = Duration::from_secs(1);

/// Finished items by name.
pub(crate) struct Notes {
    parameters: String,
    file: Option<PathBuf>,
    written: Instant,
    tallies: BTreeMap<String, Tally>,
}

impl Notes {
    /// What the files have; one that does not exist yet has nothing.
    ///
    /// # Errors
    /// A file that cannot be read, or was made for other parameters.
    pub(crate) fn read(parameters: &str, files: &[PathBuf]) -> Result<Self, String> {
        let mut tallies = BTreeMap::new();
        for file in files.iter().filter(|file| file.exists()) {
            let text = fs::read_to_string(file).map_err(|e| format!("{}: {e}", file.display()))?;
            parse(parameters, &text, &mut tallies)
                .map_err(|why| format!("{}: {why}", file.display()))?;
        }
        let file = files.first().cloned();
        Ok(Self { parameters: parameters.to_owned(), file, written: Instant::now(), tallies })
    }

    /// What an item has found, if it is finished.
    pub(crate) fn get(&self, item: &str) -> Option<&Tally> {
        self.tallies.get(item)
    }

    /// Takes note of a finished item; the file follows within a second or with the next item.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub(crate) fn take(&mut self, item: &str, tally: Tally) -> Result<(), String> {
        self.tallies.insert(item.to_owned(), tally);
        if self.written.elapsed() >= PAUSE {
            self.write()?;
            self.written = Instant::now();
        }
        Ok(())
    }

    /// Writes the file beside its place and renames it, so that it is never half written.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub(crate) fn write(&self) -> Result<(), String> {
        let Some(file) = &self.file else { return Ok(()) };
        let mut text = format!("{TITLE}\n# {}\n", self.parameters);
        for (item, tally) in &self.tallies {
            let _ = writeln!(text, "{item}: {tally}");
        }
        replace(file, &text)
    }
}

/// Writes a text beside its place and renames it.
///
/// # Errors
/// A file that cannot be written.
pub(crate) fn replace(file: &Path, text: &str) -> Result<(), String> {
    let mut beside = file.as_os_str().to_owned();
    beside.push(".part");
    fs::write(&beside, text)
        .and_then(|()| fs::rename(&beside, file))
        .map_err(|e| format!("{}: {e}", file.display()))
}

fn parse(
    parameters: &str,
    text: &str,
    tallies: &mut BTreeMap<String, Tally>,
) -> Result<(), String> {
    let mut lines = text.lines();
    let others = match (lines.next(), lines.next()) {
        (Some(TITLE), Some(second)) => second.trim_start_matches("# "),
        _ => return Err("not a file of finished items".to_owned()),
    };
    if others != parameters {
        return Err(format!("made for \"{others}\", not for \"{parameters}\""));
    }
    for (index, line) in lines.enumerate() {
        let read =
            line.split_once(": ").and_then(|(item, tally)| Some((item, Tally::parse(tally)?)));
        let Some((item, tally)) = read else {
            return Err(format!("line {} is not an item and its figures", index + 3));
        };
        tallies.insert(item.to_owned(), tally);
    }
    Ok(())
}
