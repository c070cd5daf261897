//! `onepulse run`: a G-code program through software and hardware model.

mod block;
mod checker;
mod circuits;
mod coarse;
mod config;
mod deviation;
mod interpolated;
mod motion_signals;
mod outputs;
mod picture;
mod placed;
mod planned;
mod report;
mod speed;
mod survey;
#[cfg(test)]
mod tests;
mod two_level;

use crate::args::RunArguments;
use crate::choice::Method;
use crate::curve::Curve;
use crate::failure::Failure;
use crate::machine::{SOFTWARE_ONLY, with_machines};
use block::BlockRun;
use checker::Checker;
use coarse::Microsegment;
use config::Config;
use deviation::Deviation;
use indicatif::{ProgressBar, ProgressStyle};
use interpolated::Interpolated;
use onepulse_plan::centre_path::Step;
use onepulse_plan::gcode::MOST_ERRORS;
use onepulse_plan::{Motion, Place};
use outputs::{Outputs, Pace};
use planned::{Plan, PlannedBlock};
use report::{BlockReport, Summary};
use std::fs::File;
use std::io::{self, BufReader, Seek};
use survey::Survey;

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
    let fault = |error| Failure::file(&arguments.program, &error);
    let mut input = File::open(&arguments.program).and_then(rewindable).map_err(fault)?;
    let length = input.metadata().map_err(fault)?.len();
    let wrong = |error| Failure::program(&arguments.program, error);
    let name = arguments.program.display().to_string();
    let checker = Checker { config: &config, method: &method, name: &name };
    let bar = progress(length);
    let begin = |survey: Survey| -> Result<_, Failure> {
        let outputs = Outputs::create(arguments, &config, &method, &survey)?;
        let axes = survey.axes();
        let summary = Summary::new(axes);
        Ok(Run { checker, axes, outputs, summary, short: [0; 3] })
    };

    // All of the program first: it says which axes move, and is refused before anything is made of it.
    let mut survey = Survey::new(config.machine.pulse);
    let run = match config.motion {
        None => {
            let mut refused = Vec::new();
            for step in config.cutters.path(BufReader::new(&input), &config.machine) {
                let Step::Move(step) = step.map_err(wrong)? else { continue };
                survey.backdrop.add(&step);
                for motion in step.motions() {
                    survey.add(&motion);
                    refused.extend(checker.check(&motion, &step.place, None).err());
                }
                if refused.len() >= MOST_ERRORS {
                    break;
                }
            }
            if !refused.is_empty() {
                return Err(checker.failure(refused));
            }
            input.rewind().map_err(fault)?;
            let input = BufReader::new(bar.wrap_read(input));
            let mut run = begin(survey)?;
            for step in config.cutters.path(input, &config.machine) {
                let Step::Move(step) = step.map_err(wrong)? else { continue };
                for motion in step.motions() {
                    run.block(&motion, &step.place, None)?;
                }
            }
            run
        }
        // And what comes later bounds the speeds before.
        Some(settings) => {
            let (mut motions, mut places) = (Vec::new(), Vec::new());
            let input = BufReader::new(bar.wrap_read(input));
            for step in config.cutters.path(input, &config.machine) {
                let Step::Move(step) = step.map_err(wrong)? else { continue };
                survey.backdrop.add(&step);
                for motion in step.motions() {
                    survey.add(&motion);
                    motions.push(motion);
                    places.push(step.place.clone());
                }
            }
            let plan = Plan::new(&motions, &config, settings);
            let plan = plan.map_err(|why| Failure::Fault(format!("{name}: {why}")))?;
            let blocks = || motions.iter().zip(&places).zip(plan.blocks(&motions, &config));
            let refused = blocks().filter_map(|((motion, place), planned)| {
                checker.check(motion, place, Some(&planned)).err()
            });
            let refused: Vec<_> = refused.take(MOST_ERRORS).collect();
            if !refused.is_empty() {
                return Err(checker.failure(refused));
            }
            let mut run = begin(survey)?;
            run.outputs.plot(&plan.rows)?;
            run.summary.motion = Some(plan.report());
            for ((motion, place), planned) in blocks() {
                run.block(motion, place, Some(&planned))?;
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

/// A program that can be read twice: the file, or a copy of what comes through a pipe.
fn rewindable(mut input: File) -> io::Result<File> {
    if input.rewind().is_ok() {
        return Ok(input);
    }
    let mut copy = tempfile::tempfile()?;
    io::copy(&mut input, &mut copy)?;
    copy.rewind()?;
    Ok(copy)
}

/// A run under way.
struct Run<'a> {
    checker: Checker<'a>,
    /// Of all files: x and y, and z if it ever moves.
    axes: usize,
    outputs: Outputs,
    summary: Summary,
    /// What earlier blocks left short of their end points shifts all later positions.
    short: [i64; 3],
}

impl Run<'_> {
    /// Makes a block that stands in this place.
    fn block(
        &mut self,
        motion: &Motion,
        place: &Place,
        planned: Option<&PlannedBlock<'_>>,
    ) -> Result<(), Failure> {
        let Checker { config, method, .. } = self.checker;
        let refused = |why| self.checker.refused(place, &why);
        let interpolated = Interpolated::of(motion);
        let speed = config.speed(motion);
        let coarse = self.checker.coarse(motion, &interpolated, planned).map_err(refused)?;
        let since = planned.map_or(0.0, |planned| planned.since);
        let outputs = &mut self.outputs;
        let mut block = BlockRun::begin(motion, &interpolated, self.short, since, outputs)?;
        match &coarse {
            None => {
                let curve = &interpolated.curve;
                let cycles_per_second = speed.cycles_per_second(curve, method, config.bits);
                let run = block.curve(Pace::Even { cycles_per_second }, None);
                with_machines(curve, method, Some(config.bits), run).map_err(refused)??;
            }
            Some(coarse) => {
                let (cycles, cycles_per_second) = (coarse.cycles(), coarse.cycles_per_second());
                let axes = if interpolated.is_in_space() { 3 } else { 2 };
                for Microsegment { to, record } in coarse.microsegments() {
                    let pace = match record {
                        None => Pace::Even { cycles_per_second },
                        Some(record) => Pace::Until { record, cycles },
                    };
                    let line = Curve::Line { to: to[..axes].to_vec() };
                    let run = block.curve(pace, Some(Deviation::from_line(to.map(i64::from))));
                    with_machines(&line, method, Some(coarse.report.bits), run)
                        .map_err(refused)??;
                    if !block.agrees() {
                        break;
                    }
                }
            }
        }
        let result = block.end()?;
        self.short = [0, 1, 2].map(|axis| self.short[axis] + result.residual[axis]);
        let report = BlockReport::new(motion, method, speed, &result, coarse, self.axes);
        let position = [0, 1, 2].map(|axis| i64::from(motion.to[axis]) - self.short[axis]);
        self.summary.add(&report, position);
        self.outputs.report.block(&report)
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
