//! What holds of the path of the cutter's centre through every program.

use super::distance::{away, left_of, samples};
use super::program::Lines;
use onepulse_plan::centre_path::{CentreMove, CentrePath, Compensation, PathError, Role, Step};
use onepulse_plan::compensation::{Element, Side};
use onepulse_plan::gcode::{self, Cutter, Phase, Program};
use onepulse_plan::{Curve, Length, Machine, Motion, Rate, Tools};
use std::collections::BTreeMap;

/// How exactly the path keeps its distances, in millimetres.
const EXACTNESS: f64 = 1e-6;

/// The same of closed contours, whose programmed ends are not quite tangent.
const EXACTNESS_OF_SEAMS: f64 = 2e-5;

/// Follows the path of a program to its end. Panics where a promise is broken.
pub(crate) fn check(text: &[u8], machine: &Machine, tools: &Tools, compensation: Compensation) {
    let lines = Lines::of(text);
    let mut path = CentrePath::new(Program::new(text, machine, tools), machine, compensation);
    let programmed = programmed(text, machine, tools);
    let mut followed = Followed::default();
    while let Some(step) = path.next() {
        match step {
            Ok(Step::Move(step)) => {
                lines.check(&step.place);
                let starts = |before: &&gcode::Move| {
                    before.place.line <= step.place.line && phase(before) == Some(Phase::Establish)
                };
                followed.section(programmed.iter().filter(starts).count());
                followed.take(&step);
                assert!(followed.count <= 8 * lines.count(), "it never ends");
            }
            Ok(Step::Pause(pause)) => lines.check(&pause.place),
            Err(PathError::Program { wrong, gouges }) => {
                lines.check_wrong(&wrong);
                for overcut in gouges.iter().flat_map(|gouge| &gouge.overcuts) {
                    assert!(overcut.at.iter().all(|c| c.is_finite()), "{overcut:?}");
                }
                assert!(path.next().is_none(), "something comes after an error");
                return;
            }
            Err(PathError::Input(error)) => panic!("{error}"),
        }
    }
    followed.section(0);
    followed.check_ends(&programmed, machine.pulse);
}

/// The motions of a program that is right, as programmed.
fn programmed(text: &[u8], machine: &Machine, tools: &Tools) -> Vec<gcode::Move> {
    let moves =
        Program::new(text, machine, tools).map_while(Result::ok).filter_map(|step| match step {
            gcode::Step::Move(step) => Some(step),
            gcode::Step::Pause(_) => None,
        });
    moves.collect()
}

fn phase(step: &gcode::Move) -> Option<Phase> {
    match step.cutter {
        Cutter::Off => None,
        Cutter::On { phase, .. } => Some(phase),
    }
}

/// The path so far.
#[derive(Default)]
struct Followed {
    /// Where it is, in millimetres and in pulses.
    point: [f64; 3],
    pulses: [i32; 3],
    /// Where it was at the end of each line.
    ends: BTreeMap<u32, ([f64; 3], [i32; 3])>,
    /// How often compensation has been established, and with which radius.
    section: usize,
    radius: f64,
    /// The contour since then, with what of it is machined, and the path along that.
    contour: Vec<(Element, bool)>,
    path: Vec<Element>,
    /// The blocks of contours.
    blocks: usize,
    /// Steps and motions.
    count: usize,
}

impl Followed {
    fn take(&mut self, step: &CentreMove) {
        // A block makes a curve, a line, and what leads round its corner.
        self.count += 1 + step.motions().count();
        assert!(step.from.iter().chain(&step.to).all(|c| c.is_finite()), "{step:?}");
        for (at, from) in self.point.iter().zip(step.from) {
            assert!((at - from).abs() <= EXACTNESS, "a gap from {at} to {from}: {step:?}");
        }
        self.point = step.to;
        step.motions().for_each(|motion| self.motion(motion, step));
        if let Some(contour) = step.contour {
            self.blocks += 1;
            self.contour.push((contour, step.rate != Rate::Rapid));
        }
        if let Cutter::On { side, radius, .. } = step.cutter {
            self.compensated(step, side, radius);
        }
        let before = self.ends.insert(step.place.line, (self.point, self.pulses));
        let last = self.ends.last_key_value().map(|(line, _)| *line);
        assert!(before.is_some() || last == Some(step.place.line), "out of order: {step:?}");
    }

    /// The motions in pulses run on, and fit what interpolates them.
    fn motion(&mut self, motion: Motion, step: &CentreMove) {
        let Motion { line, from, to, curve, rate } = motion;
        assert_eq!((line, rate), (step.place.line, step.rate));
        assert_eq!(from, self.pulses, "{step:?}");
        assert!(curve != Curve::Line || from != to, "{step:?}");
        if let Curve::Arc { plane, centre, .. } = curve {
            let [_, _, across] = plane.axes();
            assert_eq!(from[across], to[across], "{step:?}");
            for point in motion.ends_in(plane) {
                for axis in 0..2 {
                    let seen = i64::from(point[axis]) - centre[axis];
                    assert!(i32::try_from(seen).is_ok(), "{step:?}");
                }
                assert!(point.map(i64::from) != centre, "{step:?}");
            }
        }
        self.pulses = to;
    }

    /// The path is the radius away from the contour, on its side.
    fn compensated(&mut self, step: &CentreMove, side: Side, radius: f64) {
        let element = curve(step);
        if step.role == Role::Offset && element_moves(&element) {
            let contour = step.contour.expect("a path along a block has the block");
            for point in samples(&element) {
                let left = left_of(&contour, point);
                let away = if side == Side::Left { left } else { -left };
                assert!((away - radius).abs() <= EXACTNESS, "{away} away: {step:?}");
            }
        }
        if matches!(step.role, Role::Offset | Role::Corner) && step.rate != Rate::Rapid {
            self.path.push(element);
        }
        self.radius = radius;
    }

    /// Where another section begins, the path of the one before comes nowhere nearer to the contour than
    /// the radius.
    fn section(&mut self, section: usize) {
        if section == self.section {
            return;
        }
        self.section = section;
        let (contour, path) = (std::mem::take(&mut self.contour), std::mem::take(&mut self.path));
        let leads = leads(&contour);
        let exactness = if leads.is_some() { EXACTNESS_OF_SEAMS } else { EXACTNESS };
        for part in &path {
            for point in samples(part) {
                for (place, (block, is_machined)) in contour.iter().enumerate() {
                    if !is_machined || leads.as_ref().is_some_and(|leads| leads[place]) {
                        continue;
                    }
                    let away = away(block, point);
                    assert!(
                        away >= self.radius - exactness,
                        "{away} from {block:?} in {part:?}, not {}",
                        self.radius
                    );
                }
            }
        }
    }

    /// Blocks without compensation, and those that cancel it, end just where they are programmed to; and the
    /// path has all blocks of the contours.
    fn check_ends(self, programmed: &[gcode::Move], pulse: Length) {
        let contours = programmed.iter().filter(|step| phase(step) == Some(Phase::Contour));
        assert_eq!(self.blocks, contours.count(), "blocks of contours");
        let is_end = |step: &&gcode::Move| matches!(phase(step), None | Some(Phase::Cancel));
        for step in programmed.iter().filter(is_end) {
            let end = self.ends.range(..=step.place.line).next_back();
            let (point, pulses) = end.map_or_else(Default::default, |(_, end)| *end);
            for axis in 0..3 {
                let programmed = step.to[axis];
                let gap = (point[axis] - programmed.millimetres()).abs();
                assert!(gap <= EXACTNESS, "{gap} from the end of {step:?}");
                let nearest = nearest(programmed, pulse);
                assert_eq!(i128::from(pulses[axis]), nearest, "pulses of {step:?}");
            }
        }
    }
}

/// Which blocks of a contour may lead in to a closed part of it or out: two at most, and the one at the closed
/// part is an arc. None if no part is closed.
fn leads(contour: &[(Element, bool)]) -> Option<Vec<bool>> {
    let mut leads = vec![false; contour.len()];
    let mut has_closed = false;
    let is_arc = |block: &(Element, bool)| matches!(block.0, Element::Arc { .. });
    for (before, after) in (0..=2).flat_map(|before| (0..=2).map(move |after| (before, after))) {
        if before + after >= contour.len() {
            continue;
        }
        let end = contour.len() - after;
        let closed = &contour[before..end];
        let is_led =
            (before == 0 || is_arc(&contour[before - 1])) && (after == 0 || is_arc(&contour[end]));
        if is_led && closed[0].0.ends()[0] == closed[closed.len() - 1].0.ends()[1] {
            leads[..before].fill(true);
            leads[end..].fill(true);
            has_closed = true;
        }
    }
    has_closed.then_some(leads)
}

/// A step's curve in its plane.
fn curve(step: &CentreMove) -> Element {
    let [first, second, _] = step.plane.axes();
    let [from, to] = [step.from, step.to].map(|point| [point[first], point[second]]);
    match step.arc {
        None => Element::Line { from, to },
        Some((centre, direction)) => Element::Arc { from, to, centre, direction },
    }
}

/// Whether there is any way to go: the centre of a cutter as large as an arc stands still on it.
fn element_moves(element: &Element) -> bool {
    let [from, to] = element.ends();
    matches!(element, Element::Arc { .. }) || from != to
}

/// The nearest pulses; half a pulse counts away from nothing.
fn nearest(length: Length, pulse: Length) -> i128 {
    let [length, pulse] = [length, pulse].map(|l| i128::from(l.picometres()));
    length.signum() * ((2 * length.abs() + pulse) / (2 * pulse))
}
