//! From blocks to what happens when: planned speeds, sampled, in pulses, followed by the axes.

use crate::action::{Action, Move, standstill};
use crate::motion_settings::MotionSettings;
use onepulse_plan::sampling::Pulses;
use onepulse_plan::speed::{Block, LookAhead, Path, Profile, Sample, Samples, SpeedError};
use onepulse_plan::{Machine, servo};
use std::time::Duration;

/// The motion at the end of a sample period, of a block or of a dwell; millimetres and seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Row {
    pub(crate) time: f64,
    /// The program's line.
    pub(crate) line: u32,
    /// The point commanded.
    pub(crate) point: [f64; 3],
    /// Along the path, as commanded.
    pub(crate) speed: f64,
    pub(crate) acceleration: f64,
    /// The change of the acceleration since the row before, by the time: where that jumps, as with
    /// linear ramps, no more than a sign of it.
    pub(crate) jerk: f64,
    /// The mean time between the pulses of each axis since the row before, where there were any.
    pub(crate) intervals: [Option<f64>; 3],
    /// Command less position of each axis, taken at the end of a sample period.
    pub(crate) following_errors: Option<[f64; 3]>,
    /// Whether a block or a dwell ends here.
    pub(crate) is_end: bool,
}

/// The rows of a program, from its start on. Axes that follow go on until they
/// stand, to half a pulse.
#[derive(Debug)]
pub(crate) struct Rows {
    /// The axes that move: two, or with z three.
    axes: usize,
    stages: Vec<Stage>,
    profiles: Vec<Profile>,
    samples: Samples<std::vec::IntoIter<Profile>>,
    /// Its pulse in millimetres.
    pulse: f64,
    period: f64,
    /// Whole periods so far.
    periods: u64,
    pulses: Pulses<3>,
    last: Row,
    followed: Option<Followed>,
}

/// A part of the motion.
#[derive(Debug)]
struct Stage {
    /// The program's line.
    line: u32,
    way: Way,
}

#[derive(Debug)]
enum Way {
    Along(Path),
    /// Nowhere, for so long.
    Dwell(Duration),
}

impl Rows {
    /// The rows of these actions. On no path the speed is over `highest`, in mm/s, besides the limits.
    ///
    /// # Errors
    /// A block that no speed can be planned for, with its line.
    pub(crate) fn new(
        actions: &[Action],
        machine: &Machine,
        settings: &MotionSettings,
        highest: impl Fn(&Path) -> f64,
    ) -> Result<Self, String> {
        let MotionSettings { limits, period, servo } = *settings;
        let (mut blocks, mut stages) = (Vec::new(), Vec::new());
        let mut axes = 2;
        for action in actions {
            let (way, line) = match action {
                Action::Move(Move { motion, .. }) => {
                    let at_line = |why: SpeedError| format!("line {}: {why}", motion.line);
                    let path = Path::of(motion, machine.pulse).map_err(at_line)?;
                    let block = Block::of(motion, machine, &limits).map_err(at_line)?;
                    let steady = block.steady().min(highest(&path));
                    let [start, end] = path.directions();
                    blocks.push(Block::new(path.length(), steady, start, end).map_err(at_line)?);
                    axes = if motion.moves_z() { 3 } else { axes };
                    (Way::Along(path), motion.line)
                }
                Action::Pause(pause) => {
                    if let Some(block) = blocks.last_mut() {
                        *block = block.stopping();
                    }
                    let Some(dwell) = standstill(pause) else { continue };
                    (Way::Dwell(dwell), pause.place.line)
                }
            };
            stages.push(Stage { line, way });
        }
        let mut planned = LookAhead::new(blocks, limits);
        let profiles = stages.iter().filter_map(|stage| match stage.way {
            Way::Along(_) => planned.next(),
            Way::Dwell(time) => Some(Profile::standing(time)),
        });
        let profiles: Vec<_> = profiles.collect();
        let samples = Samples::new(profiles.clone(), period);
        let samples = samples.map_err(|why| why.to_string())?;
        let start = stages.iter().find_map(|stage| match &stage.way {
            Way::Along(path) => Some(path.point(0.0)),
            Way::Dwell(_) => None,
        });
        let start = start.unwrap_or_default();
        let pulse = machine.pulse.millimetres();
        Ok(Self {
            axes,
            stages,
            profiles,
            samples,
            pulse,
            period,
            periods: 0,
            pulses: Pulses::new(pulse, start),
            last: Row::at(start),
            followed: servo.map(|axis| Followed { start, axes: [axis; 3] }),
        })
    }

    /// The axes that move: two, or with z three.
    pub(crate) const fn axes(&self) -> usize {
        self.axes
    }

    /// The speeds planned over each block, and of each dwell.
    pub(crate) fn profiles(&self) -> &[Profile] {
        &self.profiles
    }

    /// The row of a sample.
    fn commanded(&mut self, sample: &Sample) -> Row {
        let Sample { time, speed, acceleration, block, is_block_end, .. } = *sample;
        let Stage { line, way } = &self.stages[block];
        let (line, point) = match way {
            Way::Along(path) => (*line, path.point(sample.way)),
            Way::Dwell(_) => (*line, self.last.point),
        };
        let passed = time - self.last.time;
        let intervals = self.pulses.to(point).map(|count| match count.unsigned_abs() {
            0 => None,
            count => Some(passed / count as f64),
        });
        let change = acceleration - self.last.acceleration;
        let jerk = if passed > 0.0 { change / passed } else { 0.0 };
        self.periods += u64::from(sample.is_on_grid);
        let followed = self.followed.as_mut().filter(|_| sample.is_on_grid);
        let following_errors = followed.map(|axes| axes.command(point));
        Row {
            time,
            line,
            point,
            speed,
            acceleration,
            jerk,
            intervals,
            following_errors,
            is_end: is_block_end,
        }
    }

    /// After the last: the axes come to the end point, if they are not there yet.
    fn settling(&mut self) -> Option<Row> {
        let Row { line, point, .. } = self.last;
        let axes = self.followed.as_mut()?;
        if axes.stand_at(point, self.pulse / 2.0, self.period) {
            return None;
        }
        self.periods += 1;
        let time = self.periods as f64 * self.period;
        let following_errors = Some(axes.command(point));
        Some(Row { time, line, following_errors, ..Row::at(point) })
    }
}

impl Iterator for Rows {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        let row = match self.samples.next() {
            Some(sample) => self.commanded(&sample),
            None => self.settling()?,
        };
        self.last = row;
        Some(row)
    }
}

impl Row {
    /// At rest.
    fn at(point: [f64; 3]) -> Self {
        Self {
            time: 0.0,
            line: 0,
            point,
            speed: 0.0,
            acceleration: 0.0,
            jerk: 0.0,
            intervals: [None; 3],
            following_errors: None,
            is_end: false,
        }
    }
}

/// The axes, each of which counts its way from the start.
#[derive(Debug)]
struct Followed {
    start: [f64; 3],
    axes: [servo::Axis; 3],
}

impl Followed {
    /// Whether each axis is that near to the point, and will not move further in a period.
    fn stand_at(&self, point: [f64; 3], near: f64, period: f64) -> bool {
        (0..3).all(|axis| {
            let error = point[axis] - self.start[axis] - self.axes[axis].position();
            error.abs() <= near && self.axes[axis].speed().abs() * period <= near
        })
    }

    /// Commands a point for the next period: the following errors it begins with.
    fn command(&mut self, point: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.axes[axis].step(point[axis] - self.start[axis]).following_error)
    }
}
