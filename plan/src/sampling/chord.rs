//! What a chord is off its circle.

/// The chord error (sagitta) e_r = r − √(r² − f²/4) of a chord of length `step`, exactly (but for
/// rounding): written as f²/4 over the sum of the two, as their difference would cancel.
///
/// Infinite for a chord longer than the diameter, which there is not.
#[must_use]
pub fn chord_error(radius: f64, step: f64) -> f64 {
    let half = step / 2.0;
    let to_chord = radius * radius - half * half;
    if to_chord < 0.0 { f64::INFINITY } else { half * half / (radius + to_chord.sqrt()) }
}

/// The textbooks' f²/(8r): the chord error's lower bound, not a guarantee. (13 % low for
/// f = 1.33·r.)
#[must_use]
pub fn textbook_chord_error(radius: f64, step: f64) -> f64 {
    step * step / (8.0 * radius)
}

/// The longest step with a chord error of at most `tolerance`: f ≤ 2·√(2re − e²), which over the
/// sample period is the feed limit. The diameter if the tolerance is the radius or more.
#[must_use]
pub fn largest_step(radius: f64, tolerance: f64) -> f64 {
    let tolerance = tolerance.clamp(0.0, radius);
    2.0 * (tolerance * (2.0 * radius - tolerance)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chord_of_the_3_4_5_triangle() {
        assert!((chord_error(5.0, 6.0) - 1.0).abs() < 1e-15);
        assert!((largest_step(5.0, 1.0) - 6.0).abs() < 1e-15);
        assert!((textbook_chord_error(5.0, 6.0) - 0.9).abs() < 1e-15);
        assert_eq!(chord_error(5.0, 10.1), f64::INFINITY);
    }

    #[test]
    fn the_textbook_is_low() {
        // "13 % low at FT = 1.33 r".
        let ratio = textbook_chord_error(1.0, 1.33) / chord_error(1.0, 1.33);
        assert!((0.86..0.88).contains(&ratio), "{ratio}");
        for step in (1..=200).map(|k| f64::from(k) / 100.0) {
            assert!(textbook_chord_error(1.0, step) <= chord_error(1.0, step) + 1e-16);
        }
    }

    #[test]
    fn a_small_chord_keeps_its_digits() {
        // To second order f²/(8r) is exact: a difference of squares would have lost everything here.
        let (radius, step) = (1000.0, 1e-5);
        let error = chord_error(radius, step);
        assert!((error / textbook_chord_error(radius, step) - 1.0).abs() < 1e-12);
    }
}
