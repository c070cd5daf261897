//! Every machine is an iterator over its pulses: together they lead from the start to the end point.

use onepulse_core::dda::{self, Preset, Radix, Register};
use onepulse_core::{Direction, EndRule, Error, Pulse, brm, ppc};

/// Where pulses lead.
fn sum(pulses: impl Iterator<Item = Pulse>) -> [i64; 2] {
    pulses.fold([0; 2], |[x, y], Pulse([dx, dy])| [x + i64::from(dx), y + i64::from(dy)])
}

const END: [i32; 2] = [7, -4];

#[test]
fn the_pulses_of_lines_sum_up_to_the_end_point() -> Result<(), Error> {
    let binary = Register::new(Radix::Binary, 3)?;
    let decimal = Register::new(Radix::Decimal, 1)?;
    assert_eq!(sum(ppc::Line::new(END, EndRule::Total)?), [7, -4]);
    assert_eq!(sum(brm::Line::new(END, 3)?), [7, -4]);
    for register in [binary, decimal] {
        assert_eq!(sum(dda::Line::new(END, register, Preset::Half, false)?), [7, -4]);
    }
    Ok(())
}

/// A quarter of a circle, over an axis.
#[test]
fn the_pulses_of_arcs_sum_up_to_the_chord() -> Result<(), Error> {
    let (start, end, sense) = ([4, 3], [-3, 4], Direction::Ccw);
    let register = Register::new(Radix::Binary, 4)?;
    assert_eq!(sum(ppc::Arc::new(start, end, sense, EndRule::Total)?), [-7, 1]);
    assert_eq!(sum(dda::Arc::new(start, end, sense, register, Preset::Full, false)?), [-7, 1]);
    assert_eq!(sum(dda::CentredArc::new(start, end, sense, register, false)?), [-7, 1]);
    Ok(())
}

/// An accumulation for each number of the register, and then no more.
#[test]
fn a_line_is_done_after_the_last_accumulation() -> Result<(), Error> {
    let mut line = dda::Line::new([5, 3], Register::new(Radix::Binary, 3)?, Preset::Half, false)?;
    for _ in 0..8 {
        assert!(!line.is_done());
        assert!(line.step().is_some());
    }
    assert!(line.is_done());
    assert_eq!(line.step(), None);
    Ok(())
}
