//! A line, sample by sample.

use super::SamplingError;

/// The points of a line from the origin, in millimetres, one for each sample period.
///
/// 7M: Δx = f·cos α, Δy = (y_e/x_e)·Δx; 7360: Δx = FRN·λ_t·x_e with FRN = v/L: the same number,
/// f/L of the line. The k-th point is computed from k, not from the one before, so that no error
/// adds up. The last one is the end point itself.
///
/// ```
/// use onepulse_plan::sampling::Line;
/// let points: Vec<_> = Line::new([3.0, 4.0], 2.0)?.collect();
/// assert_eq!(points.last(), Some(&[3.0, 4.0]));
/// assert_eq!(points.len(), 3); // 2 + 2 + 1 mm
/// # Ok::<(), onepulse_plan::sampling::SamplingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<const AXES: usize = 2> {
    end: [f64; AXES],
    /// Samples until the end point.
    samples: u64,
    /// Samples made.
    made: u64,
    /// Steps of the whole length.
    steps: f64,
}

impl<const AXES: usize> Line<AXES> {
    /// The line to `end` in steps of `step`.
    ///
    /// # Errors
    /// A step that is no positive length, or so short that the line has over 2⁵³ of them; an end that is
    /// not finite.
    pub fn new(end: [f64; AXES], step: f64) -> Result<Self, SamplingError> {
        if !end.iter().all(|c| c.is_finite()) {
            return Err(SamplingError::NotFinite);
        }
        // Scaled, as squares may overflow.
        let largest = end.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
        let squares: f64 = end.iter().map(|c| (c / largest).powi(2)).sum();
        let length = if largest > 0.0 { largest * squares.sqrt() } else { 0.0 };
        let steps = length / step;
        // Also where one of them is no number.
        let is_step = step > 0.0 && steps < 2_f64.powi(53);
        if !is_step {
            return Err(SamplingError::NoStep);
        }
        // What rounding adds to a whole number of steps is no sample.
        let samples = (steps * (1.0 - 1e-9)).ceil() as u64;
        Ok(Self { end, samples, made: 0, steps })
    }
}

impl<const AXES: usize> Iterator for Line<AXES> {
    type Item = [f64; AXES];

    fn next(&mut self) -> Option<[f64; AXES]> {
        if self.made == self.samples {
            return None;
        }
        self.made += 1;
        let share = self.made as f64 / self.steps;
        Some(if self.made == self.samples { self.end } else { self.end.map(|c| c * share) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn what_is_no_step_is_refused() {
        for step in [0.0, -1.0, f64::NAN, 1e-300] {
            assert_eq!(Line::new([1.0, 0.0], step), Err(SamplingError::NoStep), "{step}");
        }
        assert_eq!(Line::new([f64::INFINITY, 0.0], 1.0), Err(SamplingError::NotFinite));
        assert_eq!(Line::new([0.0, 0.0], 1.0).unwrap().count(), 0);
    }

    #[test]
    fn what_rounding_adds_to_whole_steps_is_no_sample() {
        // In floats 0.1 + 0.2 is more than 3·0.1.
        let points: Vec<_> = Line::new([0.1 + 0.2], 0.1).unwrap().collect();
        assert_eq!(points.len(), 3);
        assert_eq!(points[2], [0.1 + 0.2]);
    }

    proptest! {
        #[test]
        fn steps_are_even_and_the_last_is_the_end(
            end in [-1000.0..1000.0, -1000.0..1000.0, -1000.0..1000.0],
            step in 0.01..100.0,
        ) {
            let length = end.iter().map(|c: &f64| c * c).sum::<f64>().sqrt();
            let mut last = [0.0; 3];
            let points: Vec<_> = Line::new(end, step).unwrap().collect();
            prop_assert_eq!(points.len(), (length / step).ceil() as usize);
            for (k, point) in points.iter().enumerate() {
                let way = point.iter().zip(last).map(|(c, l)| (c - l).powi(2)).sum::<f64>().sqrt();
                let is_last = k + 1 == points.len();
                let is_right = way <= step + 1e-9 && (is_last || way >= step - 1e-9);
                prop_assert!(is_right, "{}", way);
                // Nothing across the line: the cross products.
                for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                    prop_assert!((end[a] * point[b] - end[b] * point[a]).abs() <= 1e-9 * length);
                }
                last = *point;
            }
            prop_assert_eq!(last, end);
        }
    }
}
