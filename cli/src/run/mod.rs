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

use crate::action::{Action, Move};
use crate::args::RunArguments;
use crate::choice::Method;
use crate::curve::Curve;
use crate::failure::Failure;
use crate::machine::{SOFTWARE_ONLY, with_machines};
use crate::profile::Row;
use block::BlockRun;
use checker::Checker;
use coarse::Microsegment;
use config::Config;
use deviation::Deviation;
use indicatif::{ProgressBar, ProgressStyle};
use interpolated::Interpolated;
use onepulse_plan::gcode::{MOST_ERRORS, Pause};
use outputs::{Outputs, Pace};
use planned::{Part, Plan, PlannedBlock};
use report::{BlockReport, PauseReport, Summary};
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
                let step = step.map_err(wrong)?;
                survey.draw(&step);
                for action in Action::of(step) {
                    let Action::Move(step) = action else { continue };
                    survey.add(&step.motion);
                    refused.extend(checker.check(&step.motion, &step.place, None).err());
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
                for action in Action::of(step.map_err(wrong)?) {
                    match action {
                        Action::Move(step) => run.block(&step, None)?,
                        Action::Pause(pause) => run.pause(&pause, &[])?,
                    }
                }
            }
            run
        }
        // And what comes later bounds the speeds before.
        Some(settings) => {
            let mut actions = Vec::new();
            let input = BufReader::new(bar.wrap_read(input));
            for step in config.cutters.path(input, &config.machine) {
                let step = step.map_err(wrong)?;
                survey.draw(&step);
                for action in Action::of(step) {
                    if let Action::Move(step) = &action {
                        survey.add(&step.motion);
                    }
                    actions.push(action);
                }
            }
            let plan = Plan::new(&actions, &config, settings);
            let plan = plan.map_err(|why| Failure::Fault(format!("{name}: {why}")))?;
            let parts = || plan.parts(&actions, &config);
            let refused = parts().filter_map(|part| match part {
                Part::Move(step, planned) => {
                    checker.check(&step.motion, &step.place, Some(&planned)).err()
                }
                Part::Pause(..) => None,
            });
            let refused: Vec<_> = refused.take(MOST_ERRORS).collect();
            if !refused.is_empty() {
                return Err(checker.failure(refused));
            }
            let mut run = begin(survey)?;
            run.outputs.plot(&plan.rows)?;
            run.summary.motion = Some(plan.report());
            for part in parts() {
                match part {
                    Part::Move(step, planned) => run.block(step, Some(&planned))?,
                    Part::Pause(pause, records) => run.pause(pause, records)?,
                }
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
    /// Makes a block.
    fn block(&mut self, step: &Move, planned: Option<&PlannedBlock<'_>>) -> Result<(), Failure> {
        let Move { motion, place, .. } = step;
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
        let report = BlockReport::new(step, method, speed, &result, coarse, self.axes);
        let position = [0, 1, 2].map(|axis| i64::from(motion.to[axis]) - self.short[axis]);
        self.summary.add(&report, position);
        self.outputs.report.block(&report)
    }

    /// Stands still, where speeds are planned with these records.
    fn pause(&mut self, pause: &Pause, records: &[Row]) -> Result<(), Failure> {
        self.summary.pause(PauseReport::new(pause));
        self.outputs.pause(pause, records)
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
