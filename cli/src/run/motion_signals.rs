//! The planned motion in the wave: the commanded speed and the following errors.

use crate::motion_settings::MotionSettings;
use crate::profile::Row;
use crate::pulses::AXES;
use onepulse_hwmodel::trace::{Kind, SignalList, Tracer, Wave};

/// Signals that have, from the time of a record on, what the record says.
#[derive(Debug)]
pub(super) struct MotionSignals {
    /// The commanded speed in micrometres a second.
    speed: (usize, u64),
    /// The following error of each axis in nanometres; empty if there are no position loops.
    errors: Vec<(usize, i64)>,
}

/// Up to 4 km/s and 500 m. What is more is shown as that.
const SPEED_BITS: u32 = 32;
const ERROR_BITS: u32 = 40;

impl MotionSignals {
    /// Adds those of so many axes to the list; at rest.
    pub(super) fn declare(list: &mut SignalList, settings: &MotionSettings, axes: usize) -> Self {
        let speed = (list.add("speed", Kind::Ramp(SPEED_BITS)), 0);
        let axes = if settings.servo.is_some() { &AXES[..axes] } else { &[] };
        let error = |axis| (list.add(&format!("error_{axis}"), Kind::SignedRamp(ERROR_BITS)), 0);
        Self { speed, errors: axes.iter().map(error).collect() }
    }

    /// Comes to the time of a record.
    pub(super) fn reach(&mut self, record: &Row) {
        let most = 2_f64.powi(SPEED_BITS as i32) - 1.0;
        self.speed.1 = (record.speed * 1e3).round().min(most) as u64;
        // A block's end between two periods has none: the last ones stay.
        if let Some(millimetres) = record.following_errors {
            let most = 2_f64.powi(ERROR_BITS as i32 - 1) - 1.0;
            for (error, millimetres) in self.errors.iter_mut().zip(millimetres) {
                error.1 = (millimetres * 1e6).round().clamp(-most, most) as i64;
            }
        }
    }

    /// Traces what they are now.
    pub(super) fn trace<W: Wave>(&self, tracer: &mut Tracer<W>) {
        tracer.set(self.speed.0, self.speed.1);
        for &(signal, error) in &self.errors {
            tracer.set(signal, error as u64);
        }
    }
}
