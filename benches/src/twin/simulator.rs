//! A simulator as a running process.

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// A twin under a simulator, which stays ready for the next run.
#[derive(Debug)]
pub struct Simulator {
    process: Child,
    requests: Option<ChildStdin>,
    answers: BufReader<ChildStdout>,
}

impl Simulator {
    pub(super) fn start(program: &Path) -> Result<Self, String> {
        let failed = |why: String| format!("{}: {why}", program.display());
        let mut process = Command::new(program)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|e| failed(e.to_string()))?;
        let requests = process.stdin.take();
        let answers = process.stdout.take().ok_or_else(|| failed("no output".to_owned()))?;
        Ok(Self { process, requests, answers: BufReader::new(answers) })
    }

    /// Runs a number of clocks from the loading of the command on, with the wave written to
    /// `file`. Returns the sum of the pulse wires, as a number, over the clocks.
    ///
    /// # Errors
    /// A simulator that has died.
    pub fn run(&mut self, clocks: u64, file: &Path) -> Result<u64, String> {
        let ended = || "the simulator has ended".to_owned();
        let requests = self.requests.as_mut().ok_or_else(ended)?;
        writeln!(requests, "{clocks} {}", file.display()).map_err(|e| e.to_string())?;
        let mut answer = String::new();
        self.answers.read_line(&mut answer).map_err(|e| e.to_string())?;
        answer.trim().parse().map_err(|_| ended())
    }
}

impl Drop for Simulator {
    fn drop(&mut self) {
        // Without requests it ends by itself.
        self.requests = None;
        let _ = self.process.wait();
    }
}
