//! Harnesses by the prover, in a copy of the repository.

use super::workspace::Workspace;
use crate::prover::tools::{ROOT, search_path};
use std::process::Command;

/// What the prover said of the harnesses that were given to it.
#[derive(Debug, Default)]
pub(super) struct Solved {
    /// Those that do not hold, or hold of nothing.
    pub(super) failed: Vec<String>,
    /// Those that were not decided.
    pub(super) undecided: Vec<String>,
}

/// Gives harnesses to the prover.
pub(super) fn solve(
    workspace: &Workspace,
    harnesses: &[String],
    seconds: u64,
) -> Result<Solved, String> {
    let prover = std::env::current_exe().map_err(|why| why.to_string())?;
    let mut command = Command::new(prover);
    command.args(["prove", "--jobs", "1", "--timeout", &seconds.to_string()]);
    for harness in harnesses {
        command.args(["--harness", harness]);
    }
    let output = command
        .current_dir(&workspace.folder)
        .env(ROOT, &workspace.folder)
        .env("PATH", search_path())
        .output()
        .map_err(|why| why.to_string())?;
    let said = String::from_utf8_lossy(&output.stderr);
    let solved = Solved::of(&said, harnesses);
    let all_hold = solved.failed.is_empty() && solved.undecided.is_empty();
    if output.status.success() != all_hold {
        return Err(format!("the prover cannot be understood: {said}"));
    }
    Ok(solved)
}

impl Solved {
    /// Reads a line for each harness: the verdict first, its name last.
    fn of(said: &str, harnesses: &[String]) -> Self {
        let mut solved = Self::default();
        for line in said.lines() {
            let Some(name) = line.split_whitespace().next_back() else { continue };
            if !harnesses.iter().any(|harness| harness == name) {
                continue;
            }
            if line.starts_with("fails") || line.starts_with("vacuous") {
                solved.failed.push(name.to_owned());
            } else if !line.starts_with("proved") {
                solved.undecided.push(name.to_owned());
            }
        }
        solved
    }
}

#[cfg(test)]
mod tests {
    use super::Solved;

    #[test]
    fn verdicts_are_read() {
        let said = "proved            1.0 s  a\nfails            2.0 s  b\n\
            could not run    3.0 s  c\nfails     1.0 s  d\n";
        let solved = Solved::of(said, &["a", "b", "c"].map(str::to_owned));
        assert_eq!((solved.failed, solved.undecided), (vec!["b".into()], vec!["c".into()]));
    }
}
