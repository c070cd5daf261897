//! The textbook's worked example, O A B C D E, with coordinates on a grid.

use super::{assert_path, lines};
use crate::compensation::{Corners, Role, Side, c_type};

#[test]
fn the_worked_example() {
    use Role::{Cancel, Corner, Establish, Offset};
    // G42, the tool on the right, r = 5. Of all directions the slope is 0, 3/4 or 4/3, so that the radius
    // vectors are (±3, ±4), (±4, ±3), (0, ±5) or (±5, 0).
    //
    // O → A goes (0.8, 0.6), A → B to the left and back, (-1, 0): α < 90°.
    // B → C goes (0.6, -0.8), again more than a right angle to the left: α < 90°.
    // C → D goes (-0.8, -0.6), to the right: α > 180°.
    // D → E goes (0, -1), to the left by less than a right angle: 90° < α < 180°.
    let o = [0.0, 0.0];
    let a = [80.0, 60.0];
    let b = [20.0, 60.0];
    let c = [50.0, 20.0];
    let d = [10.0, -10.0];
    let e = [10.0, -50.0];
    let section = lines(&[o, a, b, c, d, e]);

    // The right normal of (x, y) is (y, -x).
    let tip_a = [80.0 + 3.0, 60.0 - 4.0];
    let lengthened_a = [83.0 + 4.0, 56.0 + 3.0];
    // Of A → B it is (0, 1); its offset starts 5 early, against its direction.
    let second_a = [80.0 + 5.0, 60.0 + 5.0];
    // At B: the offset of A → B goes on by 5; that of B → C, with the normal (-0.8, -0.6), starts 5 early.
    let first_b = [20.0 - 5.0, 60.0 + 5.0];
    let second_b = [20.0 - 4.0 - 3.0, 60.0 - 3.0 + 4.0];
    // At C: the normals are (-0.8, -0.6) and (-0.6, 0.8), at right angles: the offsets meet in their sum.
    let f = [50.0 - 4.0 - 3.0, 20.0 - 3.0 + 4.0];
    // At D: n·g = 25 for both normals, (-3, 4) and (-5, 0), gives g = (-5, 2.5).
    let g = [10.0 - 5.0, -10.0 + 2.5];
    let h = [10.0 - 5.0, -10.0];
    assert_path(
        &c_type(&section, Side::Right, 5.0, Corners::Straight),
        o,
        &[
            (Establish, 0, tip_a),
            (Corner, 0, lengthened_a),
            (Corner, 0, second_a),
            (Offset, 1, first_b),
            (Corner, 1, second_b),
            (Offset, 2, f),
            (Offset, 3, g),
            (Corner, 3, h),
            (Cancel, 4, e),
        ],
    );
}
