//! The planned motion in the wave: the commanded speed and the following errors.

use crate::motion_settings::MotionSettings;
use crate::profile::Row;
use onepulse_hwmodel::trace::{Kind, SignalList, Tracer, Wave};

/// Signals that have, from the time of a record on, what the record says.
#[derive(Debug)]
pub(super) struct MotionSignals {
    /// The commanded speed in micrometres a second.
    speed: (usize, u64),
    /// The following error of each axis in nanometres, if there are position loops.
    errors: Option<[(usize, i64); 2]>,
}

/// Up to 4 km/s and 500 m. What is more is shown as that.
const SPEED_BITS: u32 = 32;
const ERROR_BITS: u32 = 40;

impl MotionSignals {
    /// Adds them to the list; at rest.
    pub(super) fn declare(list: &mut SignalList, settings: &MotionSettings) -> Self {
        let speed = (list.add("speed", Kind::Ramp(SPEED_BITS)), 0);
        let mut error = |name| (list.add(name, Kind::SignedRamp(ERROR_BITS)), 0);
        let errors = settings.servo.map(|_| ["error_x", "error_y"].map(&mut error));
        Self { speed, errors }
    }

    /// Comes to the time of a record.
    pub(super) fn reach(&mut self, record: &Row) {
        let most = 2_f64.powi(SPEED_BITS as i32) - 1.0;
        self.speed.1 = (record.speed * 1e3).round().min(most) as u64;
        // A block's end between two periods has none: the last ones stay.
        if let (Some(errors), Some(millimetres)) = (&mut self.errors, record.following_errors) {
            let most = 2_f64.powi(ERROR_BITS as i32 - 1) - 1.0;
            for (error, millimetres) in errors.iter_mut().zip(millimetres) {
                error.1 = (millimetres * 1e6).round().clamp(-most, most) as i64;
            }
        }
    }

    /// Traces what they are now.
    pub(super) fn trace<W: Wave>(&self, tracer: &mut Tracer<W>) {
        tracer.set(self.speed.0, self.speed.1);
        for (signal, error) in self.errors.into_iter().flatten() {
            tracer.set(signal, error as u64);
        }
    }
}
