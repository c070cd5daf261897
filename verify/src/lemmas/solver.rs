//! A solver, as a program that reads one question.

use std::fmt;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A program that reads SMT-LIB.
#[derive(Debug)]
pub struct Solver {
    /// The program.
    pub name: &'static str,
    arguments: &'static [&'static str],
}

/// The solvers that are asked.
pub const SOLVERS: [Solver; 2] = [
    Solver { name: "z3", arguments: &["-smt2", "-in"] },
    Solver { name: "cvc5", arguments: &["--lang=smt2", "-"] },
];

/// Where the project puts its own copies of the solvers.
const TOOLS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/proof-tools/bin");

/// What a solver says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// There is a case in which all that is asserted holds.
    Sat,
    /// There is none.
    Unsat,
    /// It cannot tell.
    Unknown,
    /// It did not answer in time.
    TimedOut,
    /// Something else: an error or a warning.
    Other(String),
}

impl Answer {
    /// Whether the question stays open.
    #[must_use]
    pub const fn is_undecided(&self) -> bool {
        matches!(self, Self::Unknown | Self::TimedOut)
    }

    fn from(output: &str) -> Self {
        match output.trim() {
            "sat" => Self::Sat,
            "unsat" => Self::Unsat,
            "unknown" => Self::Unknown,
            other => Self::Other(other.to_owned()),
        }
    }
}

impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sat => f.write_str("sat"),
            Self::Unsat => f.write_str("unsat"),
            Self::Unknown => f.write_str("unknown"),
            Self::TimedOut => f.write_str("no answer in time"),
            Self::Other(output) => write!(f, "could not run: {output:?}"),
        }
    }
}

impl Solver {
    /// Asks one question.
    ///
    /// # Errors
    /// The program cannot be started.
    pub fn ask(&self, question: &str, limit: Duration) -> Result<Answer, String> {
        let text = |e: std::io::Error| {
            format!(
                "{}: {e} (it is looked for in target/proof-tools/bin and on the PATH)",
                self.name
            )
        };
        let mut child = Command::new(self.program())
            .args(self.arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(text)?;
        if let Some(mut input) = child.stdin.take() {
            // A solver that stops reading says why in its output.
            let _ = input.write_all(question.as_bytes());
        }
        if !ends_in_time(&mut child, limit).map_err(text)? {
            return Ok(Answer::TimedOut);
        }
        let mut output = String::new();
        if let (Some(mut out), Some(mut err)) = (child.stdout.take(), child.stderr.take()) {
            out.read_to_string(&mut output).map_err(text)?;
            err.read_to_string(&mut output).map_err(text)?;
        }
        Ok(Answer::from(&output))
    }

    fn program(&self) -> PathBuf {
        let own = Path::new(TOOLS).join(self.name);
        if own.exists() { own } else { self.name.into() }
    }
}

/// Waits for a program to end, and ends it when it takes too long.
fn ends_in_time(child: &mut Child, limit: Duration) -> std::io::Result<bool> {
    let begun = Instant::now();
    while child.try_wait()?.is_none() {
        if begun.elapsed() > limit {
            child.kill()?;
            child.wait()?;
            return Ok(false);
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    Ok(true)
}

#[cfg(test)]
mod tests {
    use super::Answer;

    #[test]
    fn a_warning_beside_an_answer_is_no_answer() {
        assert_eq!(Answer::from("unsat\n"), Answer::Unsat);
        assert_eq!(Answer::from("unknown\n"), Answer::Unknown);
        for output in ["", "unsat\nwarning: no logic", "(error \"line 1\")\nunsat", "sat\nunsat"] {
            assert_eq!(Answer::from(output), Answer::Other(output.to_owned()));
        }
    }
}
