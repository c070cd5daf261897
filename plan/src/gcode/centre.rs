//! The centre of an arc that is given by its radius.

use crate::Length;
use num_bigint::BigInt;

/// Why no circle of a radius joins two points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NoCentre {
    /// Start and end are the same point: any circle through it would do.
    SamePoint,
    /// The points lie further apart than the diameter, by more than the tolerance.
    TooFarApart,
}

/// The centre, seen from the start in whole pulses, of the circle of `radius` through the
/// start and the point `chord` away from it: on the left of the chord or on its right.
///
/// It is the nearest pulse to the exact centre, computed in integers throughout. A chord longer
/// than the diameter by no more than `tolerance` has its centre halfway.
pub(super) fn centre(
    chord: [Length; 2],
    radius: Length,
    is_left: bool,
    pulse: Length,
    tolerance: Length,
) -> Result<[i64; 2], NoCentre> {
    let big = |length: Length| BigInt::from(length.picometres());
    let zero = BigInt::ZERO;
    let [dx, dy] = chord.map(big);
    let chord_squared = &dx * &dx + &dy * &dy;
    if chord_squared == zero {
        return Err(NoCentre::SamePoint);
    }
    let diameter = BigInt::from(2 * u128::from(radius.picometres().unsigned_abs()));
    let mut excess = &diameter * &diameter - &chord_squared;
    if excess < zero {
        let widest = &diameter + big(tolerance);
        if &widest * &widest < chord_squared {
            return Err(NoCentre::TooFarApart);
        }
        excess = zero.clone();
    }
    // The centre lies at chord/2 ± (−dy, dx)·√(excess/chord²)/2. In pulses of δ, a coordinate is
    // (along ± √(across²·excess/chord²)) / 2δ; it is rounded to the nearest by adding δ and
    // dividing downwards, which an integer square root (rounded to the right side) decides exactly.
    let coordinate = |along: &BigInt, across: &BigInt, adds: bool| {
        let square = across * across * &excess;
        let floor = (&square / &chord_squared).sqrt();
        let numerator = along + big(pulse);
        let numerator = if adds {
            numerator + floor
        } else {
            let is_exact = &floor * &floor * &chord_squared == square;
            numerator - floor - BigInt::from(u8::from(!is_exact))
        };
        div_floor(&numerator, &(2 * big(pulse)))
    };
    let left_x_adds = dy < zero;
    let left_y_adds = dx >= zero;
    Ok([coordinate(&dx, &dy, left_x_adds == is_left), coordinate(&dy, &dx, left_y_adds == is_left)])
}

/// The quotient rounded down, within `i64` (a centre further away serves no `i32` circle).
fn div_floor(numerator: &BigInt, denominator: &BigInt) -> i64 {
    let quotient = numerator / denominator;
    let rest = numerator % denominator;
    let floor = if rest < BigInt::ZERO { quotient - 1 } else { quotient };
    i64::try_from(&floor).unwrap_or(if floor < BigInt::ZERO { i64::MIN } else { i64::MAX })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const PULSE: Length = Length::from_picometres(1000);

    fn pulses(dx: i64, dy: i64) -> [Length; 2] {
        [dx, dy].map(|c| Length::from_picometres(c * 1000))
    }

    fn centre_of(dx: i64, dy: i64, radius: i64, is_left: bool) -> Result<[i64; 2], NoCentre> {
        let tolerance = Length::from_picometres(2000);
        centre(pulses(dx, dy), Length::from_picometres(radius * 1000), is_left, PULSE, tolerance)
    }

    #[test]
    fn quarter_circles() {
        // From (5,0) to (0,5): about (0,0) on the left, about (5,5) on the right.
        assert_eq!(centre_of(-5, 5, 5, true), Ok([-5, 0]));
        assert_eq!(centre_of(-5, 5, 5, false), Ok([0, 5]));
        assert_eq!(centre_of(-5, -5, 5, true), Ok([0, -5]));
        assert_eq!(centre_of(5, 5, 5, false), Ok([5, 0]));
        assert_eq!(centre_of(8, 0, 5, true), Ok([4, 3]));
        assert_eq!(centre_of(0, 8, 5, true), Ok([-3, 4]));
    }

    #[test]
    fn the_edge_cases() {
        assert_eq!(centre_of(0, 0, 5, true), Err(NoCentre::SamePoint));
        assert_eq!(centre_of(10, 0, 5, true), Ok([5, 0]));
        assert_eq!(centre_of(11, 0, 5, true), Ok([6, 0]));
        assert_eq!(centre_of(13, 0, 5, true), Err(NoCentre::TooFarApart));
        assert_eq!(centre_of(-8, 0, -5, true), Ok([-4, -3]));
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        /// Against floating point, where that is far finer than a pulse.
        #[test]
        fn the_nearest_pulse(dx in -9999_i64..9999, dy in -9999_i64..9999, extra in 0..20_000_i64, left: bool) {
            prop_assume!((dx, dy) != (0, 0));
            let (x, y) = (dx as f64, dy as f64);
            let chord = x.hypot(y);
            let radius = (chord / 2.0).ceil() + extra as f64;
            let h = (radius * radius - chord * chord / 4.0).sqrt() * if left { 1.0 } else { -1.0 };
            let [cx, cy] = centre_of(dx, dy, radius as i64, left).unwrap();
            prop_assert!((x / 2.0 - h * y / chord - cx as f64).abs() <= 0.5 + 1e-6);
            prop_assert!((y / 2.0 + h * x / chord - cy as f64).abs() <= 0.5 + 1e-6);
        }
    }
}
