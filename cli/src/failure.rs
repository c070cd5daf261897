//! How a command fails: what is said, and with which exit status.

use ariadne::{Config, IndexType, Label, Report, ReportKind, Source};
use onepulse_plan::centre_path::{Gouge, PathError};
use onepulse_plan::gcode::MOST_ERRORS;
use onepulse_plan::{Diagnostic, Place};
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
    /// A program is at fault, or another file of lines.
    Program {
        file: String,
        /// At least one.
        wrong: Vec<Diagnostic>,
        /// The contours that the cutter would cut into.
        gouges: Vec<Gouge>,
    },
    /// Whoever reads standard output has had enough.
    Unread,
}

impl Failure {
    /// A file that cannot be read or written.
    pub(crate) fn file(path: &Path, error: &io::Error) -> Self {
        Self::Fault(format!("{}: {error}", path.display()))
    }

    /// A G-code program that cannot be read, or is wrong.
    pub(crate) fn program(path: &Path, error: PathError) -> Self {
        match error {
            PathError::Input(error) => Self::file(path, &error),
            PathError::Program { wrong, gouges } => {
                Self::Program { file: path.display().to_string(), wrong, gouges }
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
            Self::Program { file, wrong, gouges } => {
                let in_colour = io::stderr().is_terminal();
                for diagnostic in &wrong {
                    eprint!("{}", underlined(&file, diagnostic, in_colour));
                }
                if wrong.len() >= MOST_ERRORS {
                    eprintln!("These are the first {MOST_ERRORS}: there may be more.");
                }
                if !gouges.is_empty() {
                    eprintln!(
                        "A picture of where: onepulse offset --format svg {file}, and the options as here"
                    );
                }
                ExitCode::from(1)
            }
        }
    }
}

/// The error with its places, the lines of the program, and the offending text underlined.
fn underlined(file: &str, diagnostic: &Diagnostic, in_colour: bool) -> String {
    let Diagnostic { place, also, message, help } = diagnostic;
    // The other lines are left empty: they give these their numbers.
    let last = also.iter().map(|other| other.line).fold(place.line, u32::max);
    let mut text = String::new();
    let mut starts = Vec::new();
    for line in 1..=last {
        let known = [place].into_iter().chain(also).find(|known| known.line == line);
        if let Some(known) = known {
            starts.push((line, text.len()));
            text.push_str(&known.text);
        }
        text.push('\n');
    }
    let at = |place: &Place| {
        let start =
            starts.iter().find(|(line, _)| *line == place.line).map_or(0, |(_, start)| *start);
        (file, start + place.span.start..start + place.span.end)
    };
    let name = |place: &Place| format!("line {}, column {}", place.line, place.column());
    // In another order the lines would be shown in pieces.
    let mut labels: Vec<&Place> = [place].into_iter().chain(also).collect();
    labels.sort_by_key(|place| place.line);
    let config = Config::default().with_color(in_colour).with_index_type(IndexType::Byte);
    let report = Report::build(ReportKind::Error, at(place))
        .with_config(config)
        .with_message(format!("{file}:{}:{}: {message}", place.line, place.column()))
        .with_labels(labels.iter().map(|place| Label::new(at(place)).with_message(name(place))))
        .with_help(help)
        .finish();
    let mut shown = Vec::new();
    match report.write((file, Source::from(text)), &mut shown) {
        Ok(()) => String::from_utf8_lossy(&shown).into_owned(),
        Err(_) => format!("error: {file}: {diagnostic}\n"),
    }
}
