//! `onepulse run`: a G-code program through software and hardware model.

mod block;
mod coarse;
mod config;
mod deviation;
mod outputs;
mod picture;
mod report;
mod speed;
mod two_level;

use crate::args::RunArguments;
use crate::choice::Method;
use crate::curve::Curve;
use crate::failure::Failure;
use crate::machine::{Refusal, SOFTWARE_ONLY, with_machines};
use block::BlockRun;
use coarse::Coarse;
use config::Config;
use deviation::Deviation;
use indicatif::{ProgressBar, ProgressStyle};
use onepulse_plan::gcode::{Program, ProgramError};
use onepulse_plan::{self as plan, Diagnostic, Motion};
use outputs::Outputs;
use report::{BlockReport, Summary};
use std::fs::File;
use std::io::BufReader;

pub(crate) fn run(arguments: &RunArguments) -> Result<(), Failure> {
    let config = Config::load(arguments)?;
    let method = Method::from_options(&config.options).map_err(Failure::Usage)?;
    // What a run is for is to hold the software against the circuit.
    if !method.has_circuit() {
        return Err(match &arguments.config {
            Some(path) if arguments.options.method.is_none() => {
                Failure::Fault(format!("{}: method: {SOFTWARE_ONLY}", path.display()))
            }
            _ => SOFTWARE_ONLY.usage(),
        });
    }
    let name = arguments.program.display().to_string();
    let open = |error| Failure::file(&arguments.program, &error);
    let input = File::open(&arguments.program).map_err(open)?;
    let length = input.metadata().map_err(open)?.len();
    let bar = progress(length);
    let mut program = Program::new(BufReader::new(bar.wrap_read(input)), &config.machine);

    let mut outputs = Outputs::create(arguments, &config, &method)?;
    let mut summary = Summary::default();
    // What earlier blocks left short of their end points shifts all later positions.
    let mut short = [0; 2];
    while let Some(motion) = program.next() {
        let motion = motion.map_err(|error| match error {
            ProgramError::Input(error) => Failure::file(&arguments.program, &error),
            ProgramError::Program(diagnostic) => {
                Failure::Program { file: name.clone(), diagnostic }
            }
        })?;
        let (curve, deviation) = curve(&motion);
        let speed = config.speed(&motion);
        let refused = |why: Refusal| {
            let diagnostic = refused_block(&motion, program.text(), &why);
            Failure::Program { file: name.clone(), diagnostic: Box::new(diagnostic) }
        };
        let coarse =
            config.two_level.map(|levels| Coarse::new(&curve, speed, &levels, config.bits));
        let coarse = coarse.transpose().map_err(refused)?;
        let cycles_per_second = match &coarse {
            None => speed.cycles_per_second(&curve, &method, config.bits),
            Some(coarse) => coarse.cycles_per_second(),
        };
        let mut block =
            BlockRun::begin(&motion, short, deviation, cycles_per_second, &mut outputs)?;
        match &coarse {
            None => with_machines(&curve, &method, Some(config.bits), block.curve(None))
                .map_err(refused)??,
            Some(coarse) => {
                for to in coarse.microsegments() {
                    let line = Curve::Line { to: to.to_vec() };
                    let run = block.curve(Some(Deviation::from_line(to)));
                    with_machines(&line, &method, Some(coarse.report.bits), run)
                        .map_err(refused)??;
                    if !block.agrees() {
                        break;
                    }
                }
            }
        }
        let result = block.end()?;
        short = [0, 1].map(|axis| short[axis] + result.residual[axis]);
        let report = BlockReport::new(&motion, &method, speed, &result, coarse);
        summary.add(&report, [0, 1].map(|axis| i64::from(motion.to[axis]) - short[axis]));
        outputs.report.block(&report)?;
    }
    bar.finish_and_clear();
    outputs.finish(&summary, &config)?;
    summary.print(&name, &arguments.out, &config)?;
    if summary.agrees {
        Ok(())
    } else {
        Err(Failure::Fault("the hardware model and the software disagree: see report.json".into()))
    }
}

/// The curve as the interpolator sees it, a line from its start, an arc about its centre; and the
/// deviation of its path.
fn curve(motion: &Motion) -> (Curve, Deviation) {
    let Motion { from, to, .. } = *motion;
    match motion.curve {
        // Any two points of a program are an i32 apart, and an arc's are from its centre.
        plan::Curve::Line => {
            let to = [to[0] - from[0], to[1] - from[1]];
            (Curve::Line { to: to.to_vec() }, Deviation::from_line(to))
        }
        plan::Curve::Arc { centre, direction } => {
            let seen =
                |point: [i32; 2]| [0, 1].map(|axis| (i64::from(point[axis]) - centre[axis]) as i32);
            let (from, to) = (seen(from), seen(to));
            (Curve::Arc { from, to, direction }, Deviation::from_circle(from))
        }
    }
}

/// A block that the machine's method or registers do not serve.
fn refused_block(motion: &Motion, text: &str, why: &Refusal) -> Diagnostic {
    let start = text.len() - text.trim_start().len();
    Diagnostic {
        line: motion.line,
        source: text.to_owned(),
        span: start..text.trim_end().len().max(start),
        message: why.to_string(),
        help: "change the block, or the machine: --method, --bits or machine.toml".into(),
    }
}

fn progress(length: u64) -> ProgressBar {
    // Drawn on standard error, and only if that is a terminal.
    let bar = ProgressBar::new(length);
    let template = "{bar:40} {bytes}/{total_bytes} {eta}";
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar
}
