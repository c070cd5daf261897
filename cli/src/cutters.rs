//! The path of a program's cutter: options, and the steps with its contours compensated.

use crate::failure::Failure;
use clap::{Args, ValueEnum};
use onepulse_plan::centre_path::{CentrePath, Compensation};
use onepulse_plan::compensation::Corners;
use onepulse_plan::gcode::{MOST_ERRORS, Program};
use onepulse_plan::{Length, Machine, ToolTable, Tools};
use std::fs;
use std::io::BufRead;
use std::path::PathBuf;

/// The cutters of a program, and how its contours are compensated.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Cutter")]
pub(crate) struct CutterOptions {
    /// The tool table, in LinuxCNC's format: T and the diameter D in millimetres on a line for each tool
    #[arg(long, value_name = "tool.tbl", conflicts_with = "radius")]
    tool_table: Option<PathBuf>,
    /// The radius of every cutter in millimetres
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    radius: Option<String>,
    /// The C type, which looks ahead to the next block, or the B type, block by block: arcs about
    /// outside corners, and no inside corners [default: c]
    #[arg(long = "type", value_enum, value_name = "TYPE")]
    kind: Option<TypeName>,
    /// How the C type goes round outside corners [default: straight]
    #[arg(long, value_enum)]
    corners: Option<CornersName>,
    /// Leave out the blocks that begin with a slash
    #[arg(long)]
    block_delete: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum TypeName {
    B,
    C,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum CornersName {
    /// Extended, or with a link inserted, as the textbooks have it
    Straight,
    /// Arcs of the cutter's radius
    Arcs,
}

/// What the options come to.
#[derive(Clone, Debug)]
pub(crate) struct Cutters {
    tools: Tools,
    compensation: Compensation,
    is_deleting: bool,
}

impl CutterOptions {
    /// Reads the tool table and checks the rest.
    pub(crate) fn load(&self) -> Result<Cutters, Failure> {
        let tools = match (&self.tool_table, &self.radius) {
            (Some(path), _) => {
                let text = fs::read(path).map_err(|error| Failure::file(path, &error))?;
                let table = ToolTable::read(&String::from_utf8_lossy(&text));
                let file = || path.display().to_string();
                Tools::Table(table.map_err(|mut wrong| {
                    wrong.truncate(MOST_ERRORS);
                    Failure::Program { file: file(), wrong, gouges: Vec::new() }
                })?)
            }
            (None, Some(text)) => match text.parse::<Length>() {
                Ok(radius) if radius >= Length::ZERO => Tools::Radius(radius.millimetres()),
                Ok(_) => {
                    let why = format!("--radius {text}: a radius is not negative");
                    return Err(Failure::Usage(why));
                }
                Err(why) => return Err(Failure::Usage(format!("--radius {text}: {why}"))),
            },
            (None, None) => Tools::Unknown,
        };
        let compensation = match (self.kind.unwrap_or(TypeName::C), self.corners) {
            (TypeName::B, Some(CornersName::Straight)) => {
                return Err(Failure::Usage(
                    "--corners straight: the B type goes round corners on arcs".into(),
                ));
            }
            (TypeName::B, _) => Compensation::B,
            (TypeName::C, Some(CornersName::Arcs)) => Compensation::C(Corners::Arcs),
            (TypeName::C, _) => Compensation::C(Corners::Straight),
        };
        Ok(Cutters { tools, compensation, is_deleting: self.block_delete })
    }
}

impl Cutters {
    /// The steps of the program in `input`.
    pub(crate) fn path<R: BufRead>(&self, input: R, machine: &Machine) -> CentrePath<Program<R>> {
        let machine = Machine { block_delete: self.is_deleting, ..*machine };
        let program = Program::new(input, &machine, &self.tools);
        CentrePath::new(program, &machine, self.compensation)
    }
}
