//! The path of point-by-point comparison along an arc, by its columns.

use onepulse_core::Direction;

/// The points of the path from `start` to `end`, the start left out; both lie on one circle about
/// the origin, and equal ends mean a full circle.
///
/// Everything is turned into the first quadrant, counter-clockwise: there, over column t, the path
/// rises to the first point on the circle or outside it, ⌈√(R² − t²)⌉, and only then steps towards
/// the axis. At the axis the picture is turned by a quarter.
pub fn path(start: [i32; 2], end: [i32; 2], direction: Direction) -> Vec<[i64; 2]> {
    // A clockwise arc is the mirror image of a counter-clockwise one.
    let mirror = if direction == Direction::Cw { -1 } else { 1 };
    let seen = |[x, y]: [i32; 2]| [i64::from(x), i64::from(y) * mirror];
    let (end, [mut t, mut a]) = (seen(end), seen(start));
    let radius_squared = t * t + a * a;
    // Quarter turns from the first quadrant (x > 0, y ≥ 0) to the one being entered.
    let mut turns = 0;
    while !(t > 0 && a >= 0) {
        (t, a) = (a, -t);
        turns += 1;
    }
    let mut path = Vec::new();
    loop {
        let top = root_rounded_up((radius_squared - t * t).max(0));
        if t == 0 && a > 0 {
            // On the next axis: turn the picture.
            (t, a) = (a, 0);
            turns += 1;
            continue;
        }
        if a < top {
            a += 1;
        } else {
            t -= 1;
        }
        let (mut x, mut y) = (t, a);
        for _ in 0..turns % 4 {
            (x, y) = (-y, x);
        }
        path.push([x, y * mirror]);
        if [x, y] == end {
            return path;
        }
    }
}

fn root_rounded_up(value: i64) -> i64 {
    let root = value.isqrt();
    root + i64::from(root * root < value)
}
