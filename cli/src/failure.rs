//! How a command fails: what is said, and with which exit status.

use ariadne::{Config, IndexType, Label, Report, ReportKind, Source};
use onepulse_plan::Diagnostic;
use onepulse_plan::gcode::ProgramError;
use std::io::{self, IsTerminal};
use std::path::Path;
use std::process::ExitCode;

/// Why a command did not do what was asked.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The command line is wrong.
    Usage(String),
    /// A file or a check is at fault.
    Fault(String),
    /// A program is at fault.
    Program { file: String, diagnostic: Box<Diagnostic> },
    /// Whoever reads standard output has had enough.
    Unread,
}

impl Failure {
    /// A file that cannot be read or written.
    pub(crate) fn file(path: &Path, error: &io::Error) -> Self {
        Self::Fault(format!("{}: {error}", path.display()))
    }

    /// A G-code program that cannot be read, or is wrong.
    pub(crate) fn program(path: &Path, error: ProgramError) -> Self {
        match error {
            ProgramError::Input(error) => Self::file(path, &error),
            ProgramError::Program(diagnostic) => {
                Self::Program { file: path.display().to_string(), diagnostic }
            }
        }
    }

    /// Standard output that cannot be written.
    pub(crate) fn stdout(error: &io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::Unread,
            _ => Self::Fault(format!("standard output: {error}")),
        }
    }

    /// Says it on standard error.
    pub(crate) fn report(self) -> ExitCode {
        match self {
            Self::Unread => ExitCode::SUCCESS,
            Self::Usage(message) => {
                eprintln!("error: {message}\n\nFor more information, try '--help'.");
                ExitCode::from(2)
            }
            Self::Fault(message) => {
                eprintln!("error: {message}");
                ExitCode::from(1)
            }
            Self::Program { file, diagnostic } => {
                eprint!("{}", underlined(&file, &diagnostic, io::stderr().is_terminal()));
                ExitCode::from(1)
            }
        }
    }
}

/// The error with its place, the line of the program, and the offending text underlined.
fn underlined(file: &str, diagnostic: &Diagnostic, in_colour: bool) -> String {
    let Diagnostic { line, source, span, message, help } = diagnostic;
    let column = diagnostic.column();
    // The lines before are left empty: they give this one its number.
    let before = *line as usize - 1;
    let place = (file, before + span.start..before + span.end);
    let config = Config::default().with_color(in_colour).with_index_type(IndexType::Byte);
    let report = Report::build(ReportKind::Error, place.clone())
        .with_config(config)
        .with_message(format!("{file}:{line}:{column}: {message}"))
        .with_label(Label::new(place).with_message(format!("line {line}, column {column}")))
        .with_help(help)
        .finish();
    let source = Source::from(format!("{}{source}", "\n".repeat(before)));
    let mut text = Vec::new();
    match report.write((file, source), &mut text) {
        Ok(()) => String::from_utf8_lossy(&text).into_owned(),
        Err(_) => format!("error: {file}: {diagnostic}\n"),
    }
}
