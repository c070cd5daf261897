//! What cannot work is refused with a reason that names the numbers it is about.

use onepulse_core::dda::{self, CentredArc, Preset, Radix, Register};
use onepulse_core::{Direction, EndRule, Error, ppc};

/// The reason of a refusal; an empty one if there was none.
fn reason<T>(refused: Result<T, Error>) -> String {
    refused.err().map(|why| why.to_string()).unwrap_or_default()
}

#[test]
fn reasons_name_their_numbers() -> Result<(), Error> {
    let arc = |start, end| reason(ppc::Arc::new(start, end, Direction::Cw, EndRule::Total));
    assert!(arc([0, 0], [1, 0]).contains("starts in its centre"));
    assert!(arc([1, 0], [0, 0]).contains("ends in its centre"));
    let too_large = arc([i32::MAX, -9], [1, 0]);
    assert!(too_large.contains("2147483647,-9") && too_large.contains("32-bit"));

    let width = reason(Register::new(Radix::Decimal, 11));
    assert!(width.contains("11 digits") && width.contains("1 to 10"));
    let three = Register::new(Radix::Binary, 3)?;
    let narrow = reason(dda::Line::new([8, 1], three, Preset::Half, false));
    assert!(narrow.contains("3 digits") && narrow.contains("needs 4"));

    let decimal = Register::new(Radix::Decimal, 2)?;
    assert!(reason(dda::Line::new([8, 1], decimal, Preset::Half, true)).contains("normalization"));
    let arc = CentredArc::new([5, 0], [0, 5], Direction::Ccw, decimal, false);
    assert!(reason(arc).contains("binary"));
    Ok(())
}
