//! Doing the work items of a sweep: shards, all processors, a progress bar, a file to resume from.

use super::notes::Notes;
use super::tally::Tally;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use std::path::PathBuf;
use std::str::FromStr;
use std::sync::{Mutex, PoisonError};

/// A part of a sweep that can be done by itself.
pub(crate) struct Item {
    name: String,
    work: Box<dyn Fn() -> Tally + Send + Sync>,
}

/// One of several parts of a sweep: every n-th item, beginning with the i-th.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    index: usize,
    count: usize,
}

/// How a sweep is carried out.
#[derive(Clone, Debug, Default)]
pub struct Driver {
    /// The part that is done.
    pub shard: Shard,
    /// Files of finished items. All are read; the first is kept up to date.
    pub resume: Vec<PathBuf>,
    /// Whether to show a progress bar, if standard error is a terminal.
    pub has_bar: bool,
}

/// The items' names with what they found; nothing for items of other shards.
pub(crate) struct Findings(Vec<(String, Option<Tally>)>);

impl Item {
    pub(crate) fn new(name: String, work: impl Fn() -> Tally + Send + Sync + 'static) -> Self {
        Self { name, work: Box::new(work) }
    }
}

impl Default for Shard {
    fn default() -> Self {
        Self { index: 1, count: 1 }
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts =
            text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        match parts {
            Some((index, count)) if (1..=count).contains(&index) => Ok(Self { index, count }),
            _ => Err("wanted i/n with 1 ≤ i ≤ n, for example 2/4".to_owned()),
        }
    }
}

impl Shard {
    fn has(self, item: usize) -> bool {
        item % self.count == self.index - 1
    }
}

impl Driver {
    /// Does the items of this shard that no file has.
    ///
    /// # Errors
    /// A file that cannot be read or written, or was made for another sweep.
    pub(crate) fn run(&self, parameters: &str, items: &[Item]) -> Result<Findings, String> {
        let notes = Notes::read(parameters, &self.resume)?;
        let to_do: Vec<_> = items
            .iter()
            .enumerate()
            .filter(|(index, item)| self.shard.has(*index) && notes.get(&item.name).is_none())
            .map(|(_, item)| item)
            .collect();
        let bar = self.bar(parameters, to_do.len());
        let notes = Mutex::new(notes);
        to_do.par_iter().try_for_each(|item| {
            let tally = (item.work)();
            bar.inc(1);
            notes.lock().unwrap_or_else(PoisonError::into_inner).take(&item.name, tally)
        })?;
        bar.finish_and_clear();
        let notes = notes.into_inner().unwrap_or_else(PoisonError::into_inner);
        notes.write()?;
        let found = |item: &Item| (item.name.clone(), notes.get(&item.name).cloned());
        Ok(Findings(items.iter().map(found).collect()))
    }

    fn bar(&self, parameters: &str, items: usize) -> ProgressBar {
        if !self.has_bar {
            return ProgressBar::hidden();
        }
        // It draws nothing where standard error is not a terminal.
        let bar = ProgressBar::new(items as u64);
        if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len}, {eta} left")
        {
            bar.set_style(style);
        }
        let id = parameters.split_whitespace().next().unwrap_or_default();
        bar.with_message(id.to_owned())
    }
}

impl Findings {
    /// Whether every item was done.
    pub(crate) fn is_complete(&self) -> bool {
        self.0.iter().all(|(_, tally)| tally.is_some())
    }

    /// The findings of all items whose name begins with these words, put together in the items' order.
    pub(crate) fn of(&self, words: &str) -> Tally {
        let mut sum = Tally::default();
        for (name, tally) in &self.0 {
            let rest = name.strip_prefix(words);
            let is_meant = rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(' '));
            if let Some(tally) = tally.as_ref().filter(|_| is_meant) {
                sum.add(tally);
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicU64, Ordering};

    /// Twenty items; the k-th has k curves. How many were worked on is counted.
    fn items(worked_on: &Arc<AtomicU64>) -> Vec<Item> {
        let item = |k: u64| {
            let worked_on = Arc::clone(worked_on);
            Item::new(format!("item {k}"), move || {
                worked_on.fetch_add(1, Ordering::Relaxed);
                Tally { curves: k, ..Tally::default() }
            })
        };
        (1..=20).map(item).collect()
    }

    fn run(
        parameters: &str,
        shard: &str,
        files: &[&PathBuf],
    ) -> Result<(Tally, bool, u64), String> {
        let worked_on = Arc::default();
        let resume = files.iter().map(|&file| file.clone()).collect();
        let driver = Driver { shard: shard.parse()?, resume, has_bar: false };
        let findings = driver.run(parameters, &items(&worked_on))?;
        Ok((findings.of("item"), findings.is_complete(), worked_on.load(Ordering::Relaxed)))
    }

    fn file(name: &str) -> PathBuf {
        let file = std::env::temp_dir().join(format!("onepulse-{}-{name}", std::process::id()));
        let _ = std::fs::remove_file(&file);
        file
    }

    #[test]
    fn shards_cover_every_item_once() {
        for count in 1..=23 {
            for item in 0..20 {
                let shards = (1..=count).filter(|&index| Shard { index, count }.has(item)).count();
                assert_eq!(shards, 1);
            }
        }
        for wrong in ["0/3", "4/3", "1/0", "1", "a/b"] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn items_are_found_by_whole_words() {
        let named = |name: &str| (name.to_owned(), Some(Tally { curves: 1, ..Tally::default() }));
        let findings = Findings(vec![named("a n=1"), named("a n=1 R=2"), named("a n=10")]);
        assert_eq!(findings.of("a n=1").curves, 2);
        assert_eq!(findings.of("a").curves, 3);
    }

    #[test]
    fn shards_put_together_are_the_whole() {
        let [first, second] = [file("first"), file("second")];
        let (whole, _, _) = run("X", "1/1", &[]).unwrap();
        let (part, is_complete, worked_on) = run("X", "1/2", &[&first]).unwrap();
        assert_eq!((part.curves, is_complete, worked_on), (100, false, 10));
        run("X", "2/2", &[&second]).unwrap();
        let (together, is_complete, worked_on) = run("X", "1/1", &[&first, &second]).unwrap();
        assert_eq!((together, is_complete, worked_on), (whole, true, 0));
    }

    #[test]
    fn what_is_in_the_file_is_not_done_again() {
        let file = file("resumed");
        let (whole, _, _) = run("X", "1/1", &[&file]).unwrap();
        // As if it had been broken off.
        let text = std::fs::read_to_string(&file).unwrap();
        let kept: Vec<_> = text.lines().take(9).collect();
        std::fs::write(&file, kept.join("\n") + "\n").unwrap();
        let (resumed, is_complete, worked_on) = run("X", "1/1", &[&file]).unwrap();
        assert_eq!((resumed, is_complete), (whole, true));
        assert_eq!(worked_on, 20 - 7);
        assert_eq!(std::fs::read_to_string(&file).unwrap(), text);
    }

    #[test]
    fn a_file_for_other_parameters_is_refused() {
        let file = file("other");
        run("X bits 4..=6", "1/1", &[&file]).unwrap();
        let why = run("X bits 4..=7", "1/1", &[&file]).unwrap_err();
        assert!(why.contains("X bits 4..=6") && why.contains("X bits 4..=7"), "{why}");
        std::fs::write(&file, "something else\n").unwrap();
        assert!(run("X", "1/1", &[&file]).is_err());
        assert_eq!(std::fs::read_to_string(&file).unwrap(), "something else\n");
    }
}
