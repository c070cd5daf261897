//! Programs that would gouge are refused; what is a hair wider passes.

use super::{Point, arc, line, lines, section, unchecked};
use crate::compensation::{Corners, Overcut, OvercutKind, Section, Side, b_type, c_type};
use onepulse_core::Direction::{Ccw, Cw};

const HAIR: f64 = 1e-6;

fn refused(section: &Section, side: Side, radius: f64) -> Vec<Overcut> {
    let overcuts = c_type(section, side, radius, Corners::Straight).unwrap_err();
    for overcut in &overcuts {
        assert!(overcut.at.iter().all(|c| c.is_finite()), "{overcut:?}");
    }
    overcuts
}

fn assert_passes(section: &Section, side: Side, radius: f64) {
    for corners in [Corners::Straight, Corners::Arcs] {
        let path = c_type(section, side, radius, corners);
        assert!(path.is_ok(), "{path:?}");
    }
}

/// A way along the x axis with a smooth hollow in it, between two arcs of 8 mm: down at x = 20 and
/// up again. The tool is above, on the left.
fn hollow(bottom: f64) -> Section {
    let right = 20.0 + 2.0 * bottom;
    section(&[
        line([-10.0, 0.0], [0.0, 0.0]),
        line([0.0, 0.0], [12.0, 0.0]),
        arc([12.0, 0.0], [20.0, -8.0], [12.0, -8.0], Cw),
        line([20.0, -8.0], [20.0, -10.0]),
        arc([20.0, -10.0], [right, -10.0], [20.0 + bottom, -10.0], Ccw),
        line([right, -10.0], [right, -8.0]),
        arc([right, -8.0], [right + 8.0, 0.0], [right + 8.0, -8.0], Cw),
        line([right + 8.0, 0.0], [right + 20.0, 0.0]),
        line([right + 20.0, 0.0], [right + 30.0, 0.0]),
    ])
}

#[test]
fn an_arc_smaller_than_the_tool() {
    assert_passes(&hollow(5.0 + HAIR), Side::Left, 5.0);
    // Just as large: the centre stands still.
    assert_passes(&hollow(5.0), Side::Left, 5.0);
    assert!(b_type(&hollow(5.0), Side::Left, 5.0).is_ok());
    let overcuts = refused(&hollow(5.0 - HAIR), Side::Left, 5.0);
    assert_eq!(overcuts[0].line, 50);
    assert_eq!(overcuts[0].other_line, None);
    let OvercutKind::SmallArc { arc, radius } = overcuts[0].kind else { panic!("{overcuts:?}") };
    assert!((arc - (5.0 - HAIR)).abs() < 1e-12 && radius == 5.0);
    assert!(b_type(&hollow(5.0 - HAIR), Side::Left, 5.0).is_err());
    // On the other side that arc is an outside one, and the others are inside.
    assert_passes(&hollow(5.0 - HAIR), Side::Right, 5.0);
    let overcuts = refused(&hollow(5.0), Side::Right, 8.1);
    let small: Vec<u32> = overcuts
        .iter()
        .filter(|overcut| matches!(overcut.kind, OvercutKind::SmallArc { .. }))
        .map(|overcut| overcut.line)
        .collect();
    assert_eq!(small, [30, 70], "all of them are found");
}

#[test]
fn an_arc_just_as_large_as_the_tool_needs_tangents() {
    let arc = arc([10.0, 0.0], [10.0, 10.0], [10.0, 5.0], Ccw);
    let to = |x: f64, y: f64| {
        let kinked = section(&[
            line([-5.0, 0.0], [0.0, 0.0]),
            line([0.0, 0.0], [10.0, 0.0]),
            arc,
            line([10.0, 10.0], [x, y]),
            line([x, y], [x - 5.0, y]),
        ]);
        c_type(&kinked, Side::Left, 5.0, Corners::Straight)
    };
    assert!(to(1.0, 10.0).is_ok());
    let overcuts = to(1.0, 12.0).unwrap_err();
    assert!(matches!(overcuts[0].kind, OvercutKind::SmallArc { .. }), "{overcuts:?}");
}

/// A pocket with a floor of this width, open at the top; the tool inside, on the left.
fn pocket(floor: f64) -> Section {
    let right = 20.0 + floor;
    lines(&[[20.0, 30.0], [20.0, 20.0], [20.0, 0.0], [right, 0.0], [right, 20.0], [right, 30.0]])
}

#[test]
fn a_block_shorter_than_its_corners() {
    assert_passes(&pocket(10.0 + HAIR), Side::Left, 5.0);
    // Just as wide: the path comes down, touches the floor in one point, and goes up.
    assert_passes(&pocket(10.0), Side::Left, 5.0);
    let overcuts = refused(&pocket(10.0 - HAIR), Side::Left, 5.0);
    assert_eq!(overcuts.len(), 1, "{overcuts:?}");
    assert_eq!((overcuts[0].line, overcuts[0].other_line), (30, None));
    let OvercutKind::ShortBlock { length, taken } = overcuts[0].kind else {
        panic!("{overcuts:?}")
    };
    assert!((length - (10.0 - HAIR)).abs() < 1e-9 && (taken - 10.0).abs() < 1e-9);
    assert!(overcuts[0].to_string().starts_with("line 30: "));
}

#[test]
fn a_meeting_beyond_the_block() {
    // A step of 3 mm, in an inside corner and an outside one.
    let step = |height: f64| {
        lines(&[
            [-10.0, 0.0],
            [0.0, 0.0],
            [20.0, 0.0],
            [20.0, height],
            [40.0, height],
            [50.0, height],
        ])
    };
    assert_passes(&step(5.0 + HAIR), Side::Left, 5.0);
    let overcuts = refused(&step(3.0), Side::Left, 5.0);
    assert_eq!(overcuts.len(), 1, "{overcuts:?}");
    assert_eq!(overcuts[0].line, 30);
    assert!(matches!(overcuts[0].kind, OvercutKind::ShortBlock { .. }));
}

#[test]
fn offsets_that_do_not_meet() {
    // Two arcs of 10 mm, like the tip of a leaf 4 mm wide: a tool inside with a radius over 2 mm
    // fits nowhere, one just smaller does.
    let leaf = |half: f64| {
        let reach = f64::sqrt(100.0 - (10.0 - half).powi(2));
        let [low, high] = [10.0 - half, half - 10.0];
        unchecked(section(&[
            line([-reach, -20.0], [-reach, 0.0]),
            // The lower side, about a centre above the x axis; then the upper one.
            arc([-reach, 0.0], [reach, 0.0], [0.0, low], Ccw),
            arc([reach, 0.0], [-reach, 0.0], [0.0, high], Ccw),
            line([-reach, 0.0], [-reach, -20.0]),
        ]))
    };
    assert_passes(&leaf(2.0 + HAIR), Side::Left, 2.0);
    let overcuts = refused(&leaf(2.0 - HAIR), Side::Left, 2.0);
    assert_eq!(overcuts.len(), 1, "{overcuts:?}");
    assert_eq!(overcuts[0].kind, OvercutKind::NoMeeting { radius: 2.0 });
    assert_eq!((overcuts[0].line, overcuts[0].other_line), (20, Some(30)));
}

/// Round a bottle: the neck, this wide, between two bellies. The tool inside, on the left; the
/// outline is open at the bottom.
fn bottle(neck: f64) -> Section {
    let [left, right] = [-neck / 2.0, neck / 2.0];
    lines(&[
        [10.0, 0.0],
        [20.0, 0.0],
        [40.0, 0.0],
        [40.0, 30.0],
        [right, 40.0],
        [40.0, 50.0],
        [40.0, 80.0],
        [-40.0, 80.0],
        [-40.0, 50.0],
        [left, 40.0],
        [-40.0, 30.0],
        [-40.0, 0.0],
        [-20.0, 0.0],
        [-10.0, 0.0],
    ])
}

#[test]
fn a_neck_narrower_than_the_tool() {
    let radius = 5.0;
    assert_passes(&bottle(20.0), Side::Left, radius);
    let overcuts = refused(&bottle(8.0), Side::Left, radius);
    assert!(!overcuts.is_empty());
    for overcut in &overcuts {
        let OvercutKind::Interference { distance, .. } = overcut.kind else {
            panic!("{overcuts:?}")
        };
        assert!(distance < radius, "{overcut}");
        let lines = [overcut.line, overcut.other_line.unwrap()];
        // The slopes next to the neck: 40 and 50 on the right, 90 and 100 on the left.
        assert!(lines.iter().any(|line| [40, 50].contains(line)), "{overcut}");
        assert!(lines.iter().any(|line| [90, 100].contains(line)), "{overcut}");
    }
    // The slopes rise by φ. Round each edge a link is inserted, r (sin φ + cos φ) away from it, and
    // the other edge must still be the radius away from that.
    let spare = |neck: f64| {
        let slope = f64::atan2(10.0, 40.0 - neck / 2.0);
        neck - radius * (slope.sin() + slope.cos()) - radius
    };
    let (mut narrow, mut wide) = (8.0, 20.0);
    for _ in 0..60 {
        let middle = (narrow + wide) / 2.0;
        *(if spare(middle) < 0.0 { &mut narrow } else { &mut wide }) = middle;
    }
    assert!(c_type(&bottle(wide + HAIR), Side::Left, radius, Corners::Straight).is_ok());
    assert!(c_type(&bottle(wide - HAIR), Side::Left, radius, Corners::Straight).is_err());
    // Round the edges on arcs, the path stays the radius from them: the neck must be twice that.
    assert!(c_type(&bottle(2.0 * radius + HAIR), Side::Left, radius, Corners::Arcs).is_ok());
    assert!(c_type(&bottle(2.0 * radius - HAIR), Side::Left, radius, Corners::Arcs).is_err());
}

#[test]
fn a_corner_that_cuts_a_far_block() {
    // Round the sharp tip at (0, 0) the path goes 5 mm further; a wall stands beyond it.
    let wall = |x: f64| {
        lines(&[
            [-70.0, -10.0],
            [-60.0, -10.0],
            [0.0, 0.0],
            [-60.0, 10.0],
            [-60.0, 60.0],
            [x, 60.0],
            [x, -60.0],
            [x, -70.0],
        ])
    };
    // The tip's two normals are (±1, 6) / √37: lengthened by 5 along (6, 1) / √37.
    let reach = 5.0 * (6.0 + 1.0) / f64::sqrt(37.0);
    let far = |x: f64| c_type(&wall(x), Side::Right, 5.0, Corners::Straight);
    assert!(far(reach + 5.0 + HAIR).is_ok(), "{:?}", far(reach + 5.0 + HAIR));
    let overcuts = far(reach + 5.0 - HAIR).unwrap_err();
    // The block to the tip becomes longer up to the link, and the link begins there.
    let lines: Vec<_> = overcuts.iter().map(|overcut| (overcut.line, overcut.other_line)).collect();
    assert_eq!(lines, [(20, Some(60)), (30, Some(60))]);
    for overcut in &overcuts {
        let OvercutKind::Interference { distance, .. } = overcut.kind else {
            panic!("{overcuts:?}")
        };
        assert!((distance - (5.0 - HAIR)).abs() < 1e-9, "{overcut:?}");
    }
}

#[test]
fn rapids_are_not_protected() {
    // Both slopes of the left edge lifted: neither the path over them nor they themselves count.
    let mut section = bottle(8.0);
    for block in &mut section.contour {
        block.is_machined = ![90, 100].contains(&block.line);
    }
    assert_passes(&section, Side::Left, 5.0);
    // Only one of them: the other is still there.
    section.contour[7].is_machined = true;
    assert_eq!(section.contour[7].line, 90);
    refused(&section, Side::Left, 5.0);
}

#[test]
fn all_overcuts_are_reported_at_once() {
    // A comb of 100 slots, each narrower than the tool.
    let mut points: Vec<Point> = vec![[-20.0, 0.0], [-10.0, 0.0]];
    for tooth in 0..100 {
        let x = 10.0 * f64::from(tooth);
        points.extend([[x, 0.0], [x + 3.0, -40.0], [x + 7.0, -40.0], [x + 9.0, 0.0]]);
    }
    points.extend([[1010.0, 0.0], [1020.0, 0.0]]);
    let overcuts = refused(&lines(&points), Side::Left, 2.5);
    let short = overcuts.iter().filter(|o| matches!(o.kind, OvercutKind::ShortBlock { .. }));
    assert_eq!(short.count(), 100, "every floor");
}

#[test]
fn a_corner_counts_if_one_of_its_blocks_does() {
    // As above: the tip's blocks are lines 20 and 30, the wall is line 60.
    let mut section = lines(&[
        [-70.0, -10.0],
        [-60.0, -10.0],
        [0.0, 0.0],
        [-60.0, 10.0],
        [-60.0, 60.0],
        [10.0, 60.0],
        [10.0, -60.0],
        [10.0, -70.0],
    ]);
    section.contour[0].is_machined = false;
    let refused_lines = |section: &Section| {
        let overcuts = refused(section, Side::Right, 5.0);
        overcuts.iter().map(|o| [o.line, o.other_line.unwrap()]).collect::<Vec<_>>()
    };
    assert_eq!(refused_lines(&section), [[20, 60], [30, 60]]);
    section.contour[0].is_machined = true;
    section.contour[1].is_machined = false;
    assert_eq!(refused_lines(&section), [[20, 60]]);
    section.contour[0].is_machined = false;
    assert!(c_type(&section, Side::Right, 5.0, Corners::Straight).is_ok());
}

#[test]
fn each_pair_of_lines_is_reported_once_and_twenty_at_most() {
    // Along a saw with its teeth up, and back along a wall above, so near that the tool cuts into
    // every tooth.
    let saw = |teeth: u32| {
        let mut points: Vec<Point> = vec![[-40.0, 0.0], [-30.0, 0.0]];
        for tooth in 0..teeth {
            let x = 20.0 * f64::from(tooth);
            points.extend([[x, 0.0], [x + 10.0, -2.0]]);
        }
        let right = 20.0 * f64::from(teeth) + 20.0;
        points.extend([[right, -2.0], [right, 8.0], [-30.0, 8.0], [-40.0, 8.0]]);
        refused(&lines(&points), Side::Left, 4.5)
    };
    // The wall is line 80: line 20 comes to the first tip, 30 to 50 go down and up, 60 and 70 to the wall.
    let overcuts = saw(2);
    let mut pairs: Vec<_> = overcuts
        .iter()
        .map(|o| (o.line.min(o.other_line.unwrap()), o.line.max(o.other_line.unwrap())))
        .collect();
    assert!(pairs.iter().all(|pair| pair.1 == 80), "{pairs:?}");
    pairs.sort_unstable();
    let count = pairs.len();
    pairs.dedup();
    assert_eq!((pairs.len(), count), (4, 4), "{overcuts:?}");
    assert_eq!(saw(100).len(), 20);
}

#[test]
fn a_hundred_thousand_blocks_take_no_time() {
    // A spiral of a hundred turns, a thousand lines each, 20 mm apart, and the tool between.
    let point = |i: u32| {
        let angle = std::f64::consts::TAU / 1000.0 * f64::from(i);
        let radius = 100.0 + 20.0 / std::f64::consts::TAU * angle;
        [radius * angle.cos(), radius * angle.sin()]
    };
    let points: Vec<Point> = (0..=100_000).map(point).collect();
    let spiral = lines(&points);
    let begun = std::time::Instant::now();
    assert_passes(&spiral, Side::Left, 9.0);
    assert!(begun.elapsed().as_secs() < 20);
    assert_eq!(refused(&spiral, Side::Left, 11.0).len(), 20);
}

#[test]
fn what_is_no_section_is_refused() {
    let good = pocket(20.0);
    let kind = |change: &dyn Fn(&mut Section)| {
        let mut section = good.clone();
        change(&mut section);
        refused(&section, Side::Left, 5.0)[0].kind
    };
    let nan =
        |section: &mut Section| section.contour[1].element = line([20.0, f64::NAN], [40.0, 0.0]);
    assert!(matches!(kind(&nan), OvercutKind::OutOfRange { coordinate } if coordinate.is_nan()));
    let far = |section: &mut Section| section.contour[1].element = line([20.0, 0.0], [1.1e7, 0.0]);
    assert_eq!(kind(&far), OvercutKind::OutOfRange { coordinate: 1.1e7 });
    let gap = |section: &mut Section| section.contour[1].element = line([20.0, 3.0], [40.0, 0.0]);
    assert_eq!(kind(&gap), OvercutKind::Disconnected { gap: 3.0 });
    let bent =
        |s: &mut Section| s.approach.element = arc([10.0, 20.0], [20.0, 20.0], [15.0, 20.0], Cw);
    assert_eq!(kind(&bent), OvercutKind::NotALine);
    let short = |section: &mut Section| section.leave.element = line([40.0, 20.0], [40.0, 20.0]);
    assert_eq!(kind(&short), OvercutKind::NoLength);
    let none =
        |s: &mut Section| s.contour[1].element = arc([20.0, 0.0], [40.0, 0.0], [20.0, 0.0], Cw);
    assert_eq!(kind(&none), OvercutKind::NoArc { radii: [0.0, 20.0] });
    for radius in [-1.0, f64::NAN, f64::INFINITY] {
        let overcuts = refused(&good, Side::Left, radius);
        assert!(matches!(overcuts[0].kind, OvercutKind::Radius { .. }));
    }
}
