//! `onepulse run`: a G-code program through software and hardware model.

mod block;
mod coarse;
mod config;
mod deviation;
mod motion_signals;
mod outputs;
mod picture;
mod planned;
mod report;
mod speed;
mod two_level;

use crate::args::RunArguments;
use crate::choice::Method;
use crate::curve::Curve;
use crate::failure::Failure;
use crate::machine::{Refusal, SOFTWARE_ONLY, with_machines};
use block::BlockRun;
use coarse::{Coarse, Microsegment};
use config::Config;
use deviation::Deviation;
use indicatif::{ProgressBar, ProgressStyle};
use onepulse_plan::gcode::Program;
use onepulse_plan::{self as plan, Diagnostic, Motion};
use outputs::{Outputs, Pace};
use planned::{Plan, PlannedBlock};
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
    let open = |error| Failure::file(&arguments.program, &error);
    let input = File::open(&arguments.program).map_err(open)?;
    let length = input.metadata().map_err(open)?.len();
    let bar = progress(length);
    let mut program = Program::new(BufReader::new(bar.wrap_read(input)), &config.machine);
    let wrong = |error| Failure::program(&arguments.program, error);
    let name = arguments.program.display().to_string();
    let begin = || -> Result<_, Failure> {
        let outputs = Outputs::create(arguments, &config, &method)?;
        let (summary, short) = (Summary::default(), [0; 2]);
        Ok(Run { config: &config, method: &method, name: &name, outputs, summary, short })
    };

    let run = match config.motion {
        None => {
            let mut run = begin()?;
            while let Some(motion) = program.next() {
                run.block(&motion.map_err(wrong)?, program.text(), None)?;
            }
            run
        }
        // All of the program first: what comes later bounds the speeds before.
        Some(settings) => {
            let (mut motions, mut texts) = (Vec::new(), Vec::new());
            while let Some(motion) = program.next() {
                motions.push(motion.map_err(wrong)?);
                texts.push(program.text().to_owned());
            }
            let plan = Plan::new(&motions, &config, settings);
            let plan = plan.map_err(|why| Failure::Fault(format!("{name}: {why}")))?;
            let mut run = begin()?;
            run.outputs.plot(&plan.rows)?;
            run.summary.motion = Some(plan.report());
            for ((motion, text), planned) in
                motions.iter().zip(&texts).zip(plan.blocks(&motions, &config))
            {
                run.block(motion, text, Some(&planned))?;
            }
            run
        }
    };
    bar.finish_and_clear();
    let Run { outputs, summary, .. } = run;
    outputs.finish(&summary, &config)?;
    summary.print(&name, &arguments.out, &config)?;
    if summary.agrees {
        Ok(())
    } else {
        Err(Failure::Fault("the hardware model and the software disagree: see report.json".into()))
    }
}

/// A run under way.
struct Run<'a> {
    config: &'a Config,
    method: &'a Method,
    /// The program's.
    name: &'a str,
    outputs: Outputs,
    summary: Summary,
    /// What earlier blocks left short of their end points shifts all later positions.
    short: [i64; 2],
}

impl Run<'_> {
    /// Makes a block that stands in this text.
    fn block(
        &mut self,
        motion: &Motion,
        text: &str,
        planned: Option<&PlannedBlock<'_>>,
    ) -> Result<(), Failure> {
        let Self { config, method, .. } = *self;
        let (curve, deviation) = curve(motion);
        let speed = config.speed(motion);
        let file = self.name;
        let refused = |why: Refusal| {
            let diagnostic = Box::new(refused_block(motion, text, &why));
            Failure::Program { file: file.to_owned(), diagnostic }
        };
        let coarse = config.two_level.map(|levels| match planned {
            None => Coarse::new(&curve, speed, &levels, config.bits),
            Some(planned) => {
                let origin = block::origin(motion);
                Coarse::planned(&curve, origin, speed, planned, &levels, config.bits)
            }
        });
        let coarse = coarse.transpose().map_err(refused)?;
        let since = planned.map_or(0.0, |planned| planned.since);
        let mut block = BlockRun::begin(motion, self.short, deviation, since, &mut self.outputs)?;
        match &coarse {
            None => {
                let cycles_per_second = speed.cycles_per_second(&curve, method, config.bits);
                let run = block.curve(Pace::Even { cycles_per_second }, None);
                with_machines(&curve, method, Some(config.bits), run).map_err(refused)??;
            }
            Some(coarse) => {
                let (cycles, cycles_per_second) = (coarse.cycles(), coarse.cycles_per_second());
                for Microsegment { to, record } in coarse.microsegments() {
                    let pace = match record {
                        None => Pace::Even { cycles_per_second },
                        Some(record) => Pace::Until { record, cycles },
                    };
                    let line = Curve::Line { to: to.to_vec() };
                    let run = block.curve(pace, Some(Deviation::from_line(to)));
                    with_machines(&line, method, Some(coarse.report.bits), run)
                        .map_err(refused)??;
                    if !block.agrees() {
                        break;
                    }
                }
            }
        }
        let result = block.end()?;
        self.short = [0, 1].map(|axis| self.short[axis] + result.residual[axis]);
        let report = BlockReport::new(motion, method, speed, &result, coarse);
        let position = [0, 1].map(|axis| i64::from(motion.to[axis]) - self.short[axis]);
        self.summary.add(&report, position);
        self.outputs.report.block(&report)
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
