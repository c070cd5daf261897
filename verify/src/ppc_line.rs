//! The path of point-by-point comparison along a line, by its columns.

/// The points of the path from the origin to `end`, the origin left out.
///
/// A point is on the line or above it (F ≥ 0) when y·|x_e| ≥ |y_e|·x, so in column x the path
/// climbs to y = ⌈|y_e|·x/|x_e|⌉ and only then steps into the next column.
pub fn path(end: [i32; 2]) -> impl Iterator<Item = [i64; 2]> {
    let [xe, ye] = end.map(|c| i128::from(c.unsigned_abs()));
    let sign = end.map(|c| i64::from(c.signum()));
    let top = move |x: i128| if xe == 0 { ye } else { (ye * x + xe - 1) / xe };
    let (mut x, mut y) = (0, 0);
    std::iter::from_fn(move || {
        if y < top(x) {
            y += 1;
        } else if x < xe {
            x += 1;
        } else {
            return None;
        }
        Some([x as i64 * sign[0], y as i64 * sign[1]])
    })
}
