//! The narrowest register of an arc: so wide that it holds the circle, and not wider.

use onepulse_core::dda::{Arc, CentredArc, Preset, Radix, Register};
use onepulse_core::{Direction, Error};

/// Within a quadrant no coordinate exceeds R; beyond it, room is left for the circle to grow by 5.
#[test]
fn the_textbooks_arc() {
    for (radius, within_a_quadrant, beyond) in
        [(1, 1, 3), (2, 2, 3), (3, 2, 4), (10, 4, 4), (11, 4, 5)]
    {
        let sense = Direction::Ccw;
        assert_eq!(Arc::bits([radius, 0], [0, radius], sense), Ok(within_a_quadrant));
        assert_eq!(Arc::bits([radius, 0], [0, -radius], sense), Ok(beyond));
    }
}

/// A signed register holds 2^(n−1) − 1.
#[test]
fn the_centred_arc() {
    for (radius, bits) in [(1, 2), (2, 3), (3, 3), (4, 4), (7, 4), (8, 5)] {
        assert_eq!(CentredArc::bits([0, radius], [radius, 0], Direction::Cw), Ok(bits));
    }
}

#[test]
fn a_register_narrower_than_that_is_refused() -> Result<(), Error> {
    let (start, end, sense) = ([3, 4], [-5, 0], Direction::Ccw);
    for digits in 1..=32 {
        let register = Register::new(Radix::Binary, digits)?;
        let needed = Arc::bits(start, end, sense)?;
        let arc = Arc::new(start, end, sense, register, Preset::Half, false);
        assert_eq!(arc.is_ok(), digits >= needed);
        let needed = CentredArc::bits(start, end, sense)?;
        let arc = CentredArc::new(start, end, sense, register, false);
        assert_eq!(arc.is_ok(), digits >= needed);
    }
    Ok(())
}
