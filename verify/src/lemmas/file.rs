//! The lemmas as they stand in their files.
//!
//! A file is plain SMT-LIB, with its logic at the top. A lemma begins with a comment `; lemma:` and
//! its name; further comments state it; then, between `(push 1)` and `(pop 1)`,
//!
//! ```text
//! declarations and hypotheses
//! (check-sat) ; expect sat
//! (assert (not conclusion))
//! (check-sat) ; expect unsat
//! ```
//!
//! A comment `; mutant: replace "…" by "…"` is an error to be made in the lemma, at the only place
//! where the text stands.

use std::fs;
use std::path::Path;

/// A small error.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mutant {
    /// What stands in the lemma.
    pub from: String,
    /// What is put there.
    pub to: String,
}

/// One lemma.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lemma {
    /// The file, without its ending.
    pub file: String,
    /// Its name.
    pub name: String,
    /// What it says, in words.
    pub sentence: String,
    /// Its errors.
    pub mutants: Vec<Mutant>,
    logic: String,
    given: String,
    denial: String,
}

const HYPOTHESES_END: &str = "(check-sat) ; expect sat\n";
const DENIAL_ENDS: &str = "(check-sat) ; expect unsat\n";

impl Lemma {
    /// The lemmas of all files in a folder.
    ///
    /// # Errors
    /// A file that cannot be read, or is not written as it should be.
    pub fn read_all(folder: &Path) -> Result<Vec<Self>, String> {
        let text = |e: std::io::Error| format!("{}: {e}", folder.display());
        let mut paths = Vec::new();
        for entry in fs::read_dir(folder).map_err(text)? {
            let path = entry.map_err(text)?.path();
            if path.extension().is_some_and(|extension| extension == "smt2") {
                paths.push(path);
            }
        }
        paths.sort();
        let mut lemmas = Vec::new();
        for path in paths {
            let source = fs::read_to_string(&path).map_err(text)?;
            let file = path.file_stem().unwrap_or_default().to_string_lossy();
            lemmas.extend(Self::read(&file, &source)?);
        }
        Ok(lemmas)
    }

    /// The lemmas of one file.
    fn read(file: &str, source: &str) -> Result<Vec<Self>, String> {
        let mut parts = source.split("\n; lemma: ");
        let logic = without_comments(parts.next().unwrap_or_default());
        if !logic.starts_with("(set-logic ") {
            return Err(format!("{file}: names no logic"));
        }
        let lemma = |part| {
            Self::read_one(file, &logic, part).map_err(|why| {
                let name = str::lines(part).next().unwrap_or_default();
                format!("{file}, lemma {name}: {why}")
            })
        };
        parts.map(lemma).collect()
    }

    fn read_one(file: &str, logic: &str, part: &str) -> Result<Self, &'static str> {
        let (head, body) = part.split_once("(push 1)\n").ok_or("has no (push 1)")?;
        let (body, after) = body.split_once("(pop 1)\n").ok_or("has no (pop 1)")?;
        if !without_comments(after).is_empty() {
            return Err("is followed by something else");
        }
        let (given, denial) = body.split_once(HYPOTHESES_END).ok_or("expects no sat")?;
        let denial = denial.strip_suffix(DENIAL_ENDS).ok_or("does not end by expecting unsat")?;
        if !denial.starts_with("(assert (not ") {
            return Err("denies no conclusion");
        }
        let mut head = head.lines();
        let name = head.next().unwrap_or_default().to_owned();
        let (mut mutants, mut sentence) = (Vec::new(), Vec::new());
        for line in head {
            let comment = line.strip_prefix(';').ok_or("has more than comments at its head")?;
            match comment.trim().strip_prefix("mutant: ") {
                Some(mutant) => {
                    mutants.push(read_mutant(mutant).ok_or("has a mutant I cannot read")?);
                }
                None => sentence.push(comment.trim()),
            }
        }
        let lemma = Self {
            file: file.to_owned(),
            name,
            sentence: sentence.join(" "),
            mutants,
            logic: logic.to_owned(),
            given: without_comments(given),
            denial: without_comments(denial),
        };
        match [&lemma.given, &lemma.denial].iter().any(|text| text.contains("check-sat")) {
            true => Err("asks more than it should"),
            false => Ok(lemma),
        }
    }

    /// The question whether the hypotheses can hold.
    #[must_use]
    pub fn hypotheses(&self) -> String {
        let Self { logic, given, .. } = self;
        format!("{logic}{given}(check-sat)\n")
    }

    /// The question whether they can hold without the conclusion.
    #[must_use]
    pub fn denied(&self) -> String {
        let Self { logic, given, denial, .. } = self;
        format!("{logic}{given}{denial}(check-sat)\n")
    }

    /// The lemma with an error in it.
    ///
    /// # Errors
    /// The text does not stand in the lemma just once.
    pub fn with(&self, mutant: &Mutant) -> Result<Self, String> {
        let Mutant { from, to } = mutant;
        let count = |text: &str| text.matches(from.as_str()).count();
        if count(&self.given) + count(&self.denial) != 1 {
            return Err(format!("{}/{}: {from:?} does not stand there once", self.file, self.name));
        }
        let mut changed = self.clone();
        changed.given = self.given.replace(from, to);
        changed.denial = self.denial.replace(from, to);
        Ok(changed)
    }
}

/// `replace "…" by "…"`.
fn read_mutant(text: &str) -> Option<Mutant> {
    let inner = text.strip_prefix("replace \"")?.strip_suffix('"')?;
    let (from, to) = inner.split_once("\" by \"")?;
    Some(Mutant { from: from.to_owned(), to: to.to_owned() })
}

/// The commands alone, line by line.
fn without_comments(text: &str) -> String {
    let command = |line: &str| line.split(';').next().unwrap_or_default().trim_end().to_owned();
    let commands = text.lines().map(command).filter(|line| !line.is_empty());
    commands.map(|line| line + "\n").collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/lemmas");

    #[test]
    fn every_lemma_has_a_name_a_sentence_and_a_mutant_that_fits() {
        let lemmas = Lemma::read_all(Path::new(FOLDER)).unwrap();
        assert!(!lemmas.is_empty());
        let mut names = HashSet::new();
        for lemma in &lemmas {
            assert!(names.insert((&lemma.file, &lemma.name)), "{} twice", lemma.name);
            assert!(!lemma.sentence.is_empty(), "{} says nothing", lemma.name);
            assert!(!lemma.mutants.is_empty(), "{} has no mutant", lemma.name);
            for mutant in &lemma.mutants {
                assert_ne!(lemma.with(mutant).unwrap().denied(), lemma.denied());
            }
        }
    }

    const PLAIN: &str = "; A file.\n(set-logic QF_LIA)\n\n; lemma: less\n; One less is less.\n\
        ; mutant: replace \"- a 1\" by \"- a 0\"\n(push 1)\n(declare-const a Int) ; any\n\
        (check-sat) ; expect sat\n(assert (not (< (- a 1) a)))\n(check-sat) ; expect unsat\n\
        (pop 1)\n";

    #[test]
    fn a_lemma_becomes_two_questions() {
        let [lemma] = &Lemma::read("file", PLAIN).unwrap()[..] else { panic!("one lemma") };
        assert_eq!(lemma.sentence, "One less is less.");
        let asked = "(set-logic QF_LIA)\n(declare-const a Int)\n(check-sat)\n";
        assert_eq!(lemma.hypotheses(), asked);
        assert!(lemma.denied().contains("(assert (not (< (- a 1) a)))\n(check-sat)\n"));
        assert!(lemma.with(&lemma.mutants[0]).unwrap().denied().contains("(- a 0)"));
    }

    #[test]
    fn what_is_written_otherwise_is_refused() {
        for (from, to) in [
            ("(set-logic QF_LIA)", ""),
            ("(push 1)", ""),
            ("(pop 1)\n", ""),
            ("; expect sat", ""),
            ("; expect unsat", ""),
            ("(not (< (- a 1) a))", "(< (- a 1) a)"),
            ("; One", "(assert false) ; One"),
            ("(pop 1)\n", "(pop 1)\n(assert false)\n"),
            ("by \"", "\""),
            ("; any", "(check-sat)"),
        ] {
            let source = PLAIN.replacen(from, to, 1);
            assert_ne!(source, PLAIN);
            assert!(Lemma::read("file", &source).is_err(), "without {from}");
        }
    }
}
