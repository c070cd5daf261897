//! Speeds planned through the whole program: the motion that two levels then make.

use super::coarse::Reduced;
use super::config::Config;
use super::report::PerAxis;
use crate::action::{Action, Move, standstill};
use crate::motion_settings::MotionSettings;
use crate::profile::{Row, Rows};
use onepulse_plan::gcode::Pause;
use onepulse_plan::sampling::largest_step;
use onepulse_plan::speed::{Path, Profile};
use onepulse_plan::{Curve, Motion};
use serde::Serialize;

/// The motion of a program, record by record.
#[derive(Debug)]
pub(super) struct Plan {
    pub(super) rows: Vec<Row>,
    axes: usize,
    profiles: Vec<Profile>,
    settings: MotionSettings,
    tolerance_mm: Option<f64>,
}

/// A part of a plan.
#[derive(Clone, Copy, Debug)]
pub(super) enum Part<'a> {
    Move(&'a Move, PlannedBlock<'a>),
    /// With the ends of its periods, and its own; none if it takes no time.
    Pause(&'a Pause, &'a [Row]),
}

/// The motion of a block.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlannedBlock<'a> {
    /// When it begins, in seconds since the program's start.
    pub(super) since: f64,
    /// The end of each whole or begun period in it, the last that of the block.
    pub(super) records: &'a [Row],
    pub(super) speeds: Speeds,
    /// Why its steady speed is not the commanded one.
    pub(super) reduced: Option<Reduced>,
}

/// The speeds of a block in mm/s.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Speeds {
    pub(super) entry: f64,
    /// The highest: less than the steady speed if the block is too short to reach that.
    pub(super) peak: f64,
    pub(super) exit: f64,
    pub(super) steady: f64,
}

/// What the report says of the motion of a whole run; millimetres and seconds.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct MotionReport {
    pub(super) largest_speed_mm_per_s: f64,
    /// Along the path, of all records.
    pub(super) largest_acceleration_mm_per_s2: f64,
    /// Likewise, the mean from record to record. Linear changes of speed have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) largest_jerk_mm_per_s3: Option<f64>,
    pub(super) duration_s: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) servo: Option<ServoReport>,
}

/// What it says of the position loops.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct ServoReport {
    /// K_v.
    pub(super) gain_per_s: f64,
    pub(super) largest_following_error_mm: PerAxis<f64>,
}

/// Sample periods that a plan may have: eleven hours of 8 ms. All of it is kept, to be plotted.
const MOST_PERIODS: f64 = 5e6;

impl Plan {
    /// Plans the motion of these blocks, with their pauses.
    ///
    /// # Errors
    /// A block that no speed can be planned for, with its line; a motion of too many sample periods.
    pub(super) fn new(
        actions: &[Action],
        config: &Config,
        settings: MotionSettings,
    ) -> Result<Self, String> {
        let tolerance_mm = config.two_level.and_then(|levels| levels.tolerance_mm);
        let highest = |path: &Path| steady(f64::INFINITY, path.radius(), &settings, tolerance_mm).0;
        let rows = Rows::new(actions, &config.machine, &settings, highest)?;
        let profiles = rows.profiles().to_vec();
        let seconds: f64 = profiles.iter().map(Profile::duration).sum();
        if seconds > MOST_PERIODS * settings.period {
            return Err(format!(
                "the motion takes {seconds:.0} s, over {MOST_PERIODS} sample periods: --period can \
                 make them longer"
            ));
        }
        let axes = rows.axes();
        Ok(Self { rows: rows.collect(), axes, profiles, settings, tolerance_mm })
    }

    /// The part of each action; these are the actions that were planned.
    pub(super) fn parts<'a>(
        &'a self,
        actions: &'a [Action],
        config: &'a Config,
    ) -> impl Iterator<Item = Part<'a>> {
        let mut since = 0.0;
        // What comes after the last end is of no action.
        let mut timed = self.rows.split_inclusive(|row| row.is_end).zip(&self.profiles);
        actions.iter().filter_map(move |action| {
            if let Action::Pause(pause) = action {
                if standstill(pause).is_none() {
                    return Some(Part::Pause(pause, &[]));
                }
            }
            let (records, profile) = timed.next()?;
            let part = match action {
                Action::Pause(pause) => Part::Pause(pause, records),
                Action::Move(step) => {
                    let (speeds, reduced) = self.speeds(&step.motion, profile, config);
                    Part::Move(step, PlannedBlock { since, records, speeds, reduced })
                }
            };
            since = records.last().map_or(since, |row| row.time);
            Some(part)
        })
    }

    /// The speeds of a block, and why its steady speed is not the commanded one.
    fn speeds(
        &self,
        motion: &Motion,
        profile: &Profile,
        config: &Config,
    ) -> (Speeds, Option<Reduced>) {
        let commanded = config.speed(motion).millimetres_per_minute() / 60.0;
        let radius = match motion.curve {
            Curve::Line => None,
            Curve::Arc { plane, centre, .. } => {
                let [from, _] = motion.ends_in(plane);
                let [x, y] = [0, 1].map(|axis| i64::from(from[axis]) - centre[axis]);
                Some((x as f64).hypot(y as f64) * config.machine.pulse.millimetres())
            }
        };
        let (steady, reduced) = steady(commanded, radius, &self.settings, self.tolerance_mm);
        let (entry, peak, exit) = (profile.entry(), profile.peak(), profile.exit());
        (Speeds { entry, peak, exit, steady }, reduced)
    }

    /// What the report says of it.
    pub(super) fn report(&self) -> MotionReport {
        let largest = |values: &mut dyn Iterator<Item = f64>| {
            values.fold(0.0, |most: f64, value| most.max(value.abs()))
        };
        let MotionSettings { limits, period, servo } = self.settings;
        // Over a much shorter time, as next to a block's end, rounding would be taken for jerk.
        let pairs = self.rows.windows(2).filter(|pair| pair[1].time - pair[0].time > period / 1e3);
        let jerk = largest(&mut pairs.map(|pair| pair[1].jerk));
        let error = |axis: usize| {
            let errors = self.rows.iter().filter_map(|row| row.following_errors);
            largest(&mut errors.map(|errors| errors[axis]))
        };
        MotionReport {
            largest_speed_mm_per_s: largest(&mut self.profiles.iter().map(Profile::peak)),
            largest_acceleration_mm_per_s2: largest(
                &mut self.rows.iter().map(|row| row.acceleration),
            ),
            largest_jerk_mm_per_s3: limits.jerk().map(|_| jerk),
            duration_s: self.rows.iter().rfind(|row| row.is_end).map_or(0.0, |row| row.time),
            servo: servo.map(|axis| ServoReport {
                gain_per_s: axis.settings().gain,
                largest_following_error_mm: PerAxis::of([0, 1, 2].map(error), self.axes),
            }),
        }
    }
}

/// The steady speed of a block in mm/s, and what makes it less than the commanded one.
fn steady(
    commanded: f64,
    radius: Option<f64>,
    settings: &MotionSettings,
    tolerance_mm: Option<f64>,
) -> (f64, Option<Reduced>) {
    let Some(radius) = radius else { return (commanded, None) };
    let tolerated = tolerance_mm.map_or(f64::INFINITY, |mm| largest_step(radius, mm));
    [
        (settings.limits.arc_speed(radius), Reduced::Centripetal),
        (radius / 4.0 / settings.period, Reduced::Radius),
        (tolerated / settings.period, Reduced::Tolerance),
    ]
    .into_iter()
    .fold(
        (commanded, None),
        |(speed, reduced), (bound, why)| {
            if bound < speed { (bound, Some(why)) } else { (speed, reduced) }
        },
    )
}
