//! What a machine's axes bear and how they follow: options, and keys of `machine.toml`.

use crate::failure::Failure;
use crate::machine_file::{MachineFile, positive};
use clap::Args;
use onepulse_plan::servo;
use onepulse_plan::speed::Limits;

/// Limits of the motion, and the position loops.
#[derive(Debug, Args)]
#[command(next_help_heading = "Motion")]
pub(crate) struct MotionOptions {
    /// The largest acceleration along the path in mm/s² [default: 1000]
    #[arg(long, value_name = "MM_PER_S2", allow_negative_numbers = true)]
    acceleration: Option<f64>,
    /// The largest jerk along the path in mm/s³: speeds change along S-curves [default: linearly]
    #[arg(long, value_name = "MM_PER_S3", allow_negative_numbers = true)]
    jerk: Option<f64>,
    /// The largest jump of the velocity in a corner in mm/s [default: 10]
    #[arg(long, value_name = "MM_PER_S", allow_negative_numbers = true)]
    corner: Option<f64>,
    /// The largest centripetal acceleration in mm/s² [default: that along the path]
    #[arg(long, value_name = "MM_PER_S2", allow_negative_numbers = true)]
    centripetal: Option<f64>,
    /// The gain K_v of the position loops in 1/s [default: the axes are where they are told to be]
    #[arg(long, value_name = "PER_S", allow_negative_numbers = true)]
    servo_gain: Option<f64>,
    /// The time constant of the drives in milliseconds [default: 0]
    #[arg(long, value_name = "MS", allow_negative_numbers = true)]
    servo_drive: Option<f64>,
}

impl MotionOptions {
    /// The first option that is given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let options = [
            (self.acceleration, "--acceleration"),
            (self.jerk, "--jerk"),
            (self.corner, "--corner"),
            (self.centripetal, "--centripetal"),
            (self.servo_gain, "--servo-gain"),
            (self.servo_drive, "--servo-drive"),
        ];
        options.into_iter().find_map(|(value, option)| value.map(|_| option))
    }
}

/// What they come to, with the defaults of a machine that says nothing else.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MotionSettings {
    pub(crate) limits: Limits,
    /// The sample period in seconds.
    pub(crate) period: f64,
    /// The position loops, if there are any.
    pub(crate) servo: Option<servo::Axis>,
}

const PERIOD_MS: f64 = 8.0;
const ACCELERATION: f64 = 1000.0;
const CORNER: f64 = 10.0;

impl MotionSettings {
    /// From the command line, or else the machine file.
    pub(crate) fn load(
        options: &MotionOptions,
        period: Option<&str>,
        file: &MachineFile,
    ) -> Result<Self, Failure> {
        let keys = &file.content;
        let period_ms = match (period, keys.period_ms) {
            // A decimal of milliseconds is read as one of millimetres is.
            (Some(text), _) => positive("--period", text).map_err(Failure::Usage)?.millimetres(),
            (None, Some(number)) => {
                let read = positive("period_ms", &number.to_string());
                read.map_err(|why| file.fault(why))?.millimetres()
            }
            (None, None) => PERIOD_MS,
        };
        let period = period_ms / 1000.0;
        let MotionOptions { acceleration, jerk, corner, centripetal, servo_gain, servo_drive } =
            *options;
        let is_given = [acceleration, jerk, corner, centripetal].iter().any(Option::is_some);
        let acceleration = acceleration.or(keys.acceleration_mm_per_s2).unwrap_or(ACCELERATION);
        let limits = Limits::new(
            acceleration,
            jerk.or(keys.jerk_mm_per_s3),
            corner.or(keys.corner_mm_per_s).unwrap_or(CORNER),
            centripetal.or(keys.centripetal_mm_per_s2).unwrap_or(acceleration),
        );
        let limits = limits.map_err(|why| wrong(is_given, why, file))?;
        let gain = servo_gain.or(keys.servo_gain_per_s);
        let drive = servo_drive.or(keys.servo_drive_ms);
        if servo_drive.is_some() && gain.is_none() {
            return Err(Failure::Usage("--servo-drive belongs to --servo-gain".into()));
        }
        let is_given = servo_gain.is_some() || servo_drive.is_some();
        let servo = gain.map(|gain| {
            let drive_time_constant = drive.unwrap_or(0.0) / 1000.0;
            servo::Axis::new(servo::Settings { gain, drive_time_constant, period })
        });
        let servo = servo.transpose().map_err(|why| wrong(is_given, why, file))?;
        Ok(Self { limits, period, servo })
    }
}

/// A number that does not go, of the command line or of the file.
fn wrong(is_given: bool, why: impl std::fmt::Display, file: &MachineFile) -> Failure {
    if is_given { Failure::Usage(why.to_string()) } else { file.fault(why) }
}
