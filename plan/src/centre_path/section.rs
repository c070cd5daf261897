//! One contour, from the line that establishes compensation to the one that cancels it.

use super::gouge::Gouge;
use super::step::{CentreMove, Role, Step, role};
use super::{Compensation, overcut};
use crate::compensation::{self, Block, Cut, Element, Section, Side, b_type, c_type};
use crate::gcode::{
    self, Cutter, Fault, MOST_ERRORS, Move, Phase, ProgrammedArc, in_pulses, too_far,
};
use crate::{Diagnostic, Length, Place, Rate};
use onepulse_core::Direction;

/// The steps of a contour so far.
#[derive(Debug, Default)]
pub(super) struct Gathered {
    steps: Vec<gcode::Step>,
}

/// What is wrong with a contour, and what to draw of it.
type Wrong = (Vec<Diagnostic>, Option<Gouge>);

impl Gathered {
    pub(super) fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    pub(super) fn push(&mut self, step: gcode::Step) {
        self.steps.push(step);
    }

    /// The steps of the cutter's centre. The contour is complete: it begins with the line that
    /// establishes the compensation and ends with the one that cancels it.
    pub(super) fn compensate(
        self,
        compensation: Compensation,
        pulse: Length,
    ) -> Result<Vec<Step>, Wrong> {
        let mut wrong = Vec::new();
        let mut blocks = Vec::new();
        let mut cutter = None;
        let mut plane = None;
        for step in &self.steps {
            let gcode::Step::Move(step) = step else { continue };
            let Cutter::On { side, radius, phase } = step.cutter else { continue };
            if phase == Phase::Across {
                continue;
            }
            cutter.get_or_insert((side, radius));
            plane.get_or_insert(step.plane);
            match element(step, pulse) {
                Ok(element) => {
                    let is_machined = step.rate != Rate::Rapid;
                    blocks.push(Block { element, line: step.place.line, is_machined });
                }
                Err(fault) => wrong.push(diagnostic(fault, &step.place)),
            }
        }
        if !wrong.is_empty() {
            return Err((wrong, None));
        }
        let (Some((side, radius)), Some(plane)) = (cutter, plane) else { return Ok(Vec::new()) };
        let contour: Vec<_> = blocks.iter().map(|block| block.element).collect();
        // At least the two lines at its ends are there.
        let (Some(leave), false) = (blocks.pop(), blocks.is_empty()) else { return Ok(Vec::new()) };
        let approach = blocks.remove(0);
        let section = Section { approach, contour: blocks, leave };
        let cuts = match cuts(&section, side, radius, compensation) {
            Ok(cuts) => cuts,
            Err(mut overcuts) => {
                overcuts.sort_by_key(|overcut| overcut.line);
                overcuts.truncate(MOST_ERRORS);
                let places = self.places();
                let wrong = overcuts.iter().map(|overcut| overcut::diagnostic(overcut, &places));
                return Err((wrong.collect(), Some(Gouge { plane, contour, radius, overcuts })));
            }
        };
        let path =
            Path { pulse, contour: &section.contour, cuts: &cuts, at: None, steps: Vec::new() };
        path.run(&self.steps).map_err(|wrong| (vec![wrong], None))
    }

    fn places(&self) -> Vec<&Place> {
        let places = self.steps.iter().map(|step| match step {
            gcode::Step::Move(step) => &step.place,
            gcode::Step::Pause(pause) => &pause.place,
        });
        places.collect()
    }
}

fn cuts(
    section: &Section,
    side: Side,
    radius: f64,
    compensation: Compensation,
) -> Result<Vec<Cut>, Vec<compensation::Overcut>> {
    match compensation {
        Compensation::B => b_type(section, side, radius),
        Compensation::C(corners) => c_type(section, side, radius, corners),
    }
}

/// The curve of a block in its plane, in millimetres.
fn element(step: &Move, pulse: Length) -> Result<Element, Fault> {
    let [first, second, _] = step.plane.axes();
    let [start, end] = [step.from, step.to].map(|point| [point[first], point[second]]);
    let [from, to] = [start, end].map(|point| point.map(Length::millimetres));
    match step.arc {
        None => Ok(Element::Line { from, to }),
        Some((arc, direction)) => {
            let centre = arc.common_centre(start, direction, pulse, &step.place.span)?;
            Ok(Element::Arc { from, to, centre, direction })
        }
    }
}

/// The path as it grows.
#[derive(Debug)]
struct Path<'a> {
    pulse: Length,
    contour: &'a [Block],
    cuts: &'a [Cut],
    /// Where the centre stands; none before the first step.
    at: Option<[Length; 3]>,
    steps: Vec<Step>,
}

impl Path<'_> {
    /// The cuts in the order of the program, with all that it does besides.
    fn run(mut self, steps: &[gcode::Step]) -> Result<Vec<Step>, Diagnostic> {
        let mut block = 0;
        self.at = steps.iter().find_map(|step| match step {
            gcode::Step::Move(step) => Some(step.from),
            gcode::Step::Pause(_) => None,
        });
        for step in steps {
            match step {
                gcode::Step::Pause(pause) => self.steps.push(Step::Pause(pause.clone())),
                gcode::Step::Move(step) => {
                    let is_across = matches!(step.cutter, Cutter::On { phase: Phase::Across, .. });
                    if !is_across {
                        self.block(step, block).map_err(|fault| diagnostic(fault, &step.place))?;
                        block += 1;
                    }
                    self.across(step).map_err(|fault| diagnostic(fault, &step.place))?;
                }
            }
        }
        Ok(self.steps)
    }

    /// What is made of a block, 0 for the line on which compensation is established.
    fn block(&mut self, step: &Move, block: usize) -> Result<(), Fault> {
        let own = self.cuts.iter().take_while(|cut| cut.block == block).count();
        let (own, rest) = self.cuts.split_at(own);
        self.cuts = rest;
        let first = self.steps.len();
        for cut in own {
            self.cut(step, cut)?;
        }
        let Some(contour) = block.checked_sub(1).and_then(|block| self.contour.get(block)) else {
            return if own.is_empty() && block > 0 { self.arrive(step) } else { Ok(()) };
        };
        if own.is_empty() {
            // Nothing of an arc of just the cutter's radius: it stands.
            let at = self.at.unwrap_or(step.from);
            let stands = [at; 2].map(|point| point.map(Length::millimetres));
            self.push(step, Role::Offset, [at; 2], stands, None, None)?;
        }
        if let Some(Step::Move(made)) = self.steps.get_mut(first) {
            made.contour = Some(contour.element);
        }
        Ok(())
    }

    /// The end of a contour that is too near to where compensation ends for a line between: within what
    /// cannot be told from rounding, but pulses may lie between.
    fn arrive(&mut self, step: &Move) -> Result<(), Fault> {
        let from = self.at.unwrap_or(step.from);
        if from == step.to {
            return Ok(());
        }
        let shown = [from, step.to].map(|point| point.map(Length::millimetres));
        self.push(step, Role::Cancel, [from, step.to], shown, None, None)
    }

    /// A cut of a block, and the part of the block's motion across the plane that belongs to it.
    fn cut(&mut self, step: &Move, cut: &Cut) -> Result<(), Fault> {
        let [_, _, across] = step.plane.axes();
        let from = self.at.unwrap_or(step.from);
        let role = match cut.role {
            compensation::Role::Establish => Role::Establish,
            compensation::Role::Offset => Role::Offset,
            compensation::Role::Corner => Role::Corner,
            compensation::Role::Cancel => Role::Cancel,
        };
        let height = if role == Role::Corner { from[across] } else { step.to[across] };
        let (ends, arc) = match cut.element {
            Element::Line { from, to } => ([from, to], None),
            Element::Arc { from, to, centre, direction } => ([from, to], Some((centre, direction))),
        };
        let [first, second] = ends[1].map(Length::nearest);
        let to = match role {
            // Back to what is programmed, to the last digit.
            Role::Cancel => step.to,
            _ => step.plane.place([first, second, height]),
        };
        let heights = [from[across], to[across]].map(Length::millimetres);
        let shown = [0, 1].map(|end| step.plane.place([ends[end][0], ends[end][1], heights[end]]));
        let arc_in_pulses = match arc {
            Some((centre, direction)) if runs(ends, centre, direction, from, to) => {
                let [first, second, _] = step.plane.axes();
                let centre = centre.map(Length::nearest);
                let seen = |point: [Length; 3]| -> Option<[Length; 2]> {
                    Some([
                        point[first].checked_sub(centre[0])?,
                        point[second].checked_sub(centre[1])?,
                    ])
                };
                let (Some(start), Some(end)) = (seen(from), seen(to)) else {
                    return Err(too_far(&step.place.span));
                };
                Some((ProgrammedArc::Centre { start, end, centre }, direction))
            }
            _ => None,
        };
        self.push(step, role, [from, to], shown, arc, arc_in_pulses)
    }

    /// What is left of a block's motion across the plane.
    fn across(&mut self, step: &Move) -> Result<(), Fault> {
        let [_, _, across] = step.plane.axes();
        let from = self.at.unwrap_or(step.from);
        let mut to = from;
        to[across] = step.to[across];
        if from == to {
            return Ok(());
        }
        let shown = [from, to].map(|point| point.map(Length::millimetres));
        self.push(step, role(step.rate), [from, to], shown, None, None)
    }

    fn push(
        &mut self,
        step: &Move,
        role: Role,
        [from, to]: [[Length; 3]; 2],
        shown: [[f64; 3]; 2],
        arc: Option<([f64; 2], Direction)>,
        arc_in_pulses: Option<(ProgrammedArc, Direction)>,
    ) -> Result<(), Fault> {
        let pulses = |point| in_pulses(point, self.pulse).ok_or_else(|| too_far(&step.place.span));
        let ends = [pulses(from)?, pulses(to)?];
        let exact = Move { from, to, arc: arc_in_pulses, ..step.clone() };
        let motions = exact.in_pulses(ends, self.pulse)?;
        self.at = Some(to);
        self.steps.push(Step::Move(CentreMove::new(step, role, shown, arc, motions)));
        Ok(())
    }
}

/// Whether an arc is more than a point once its ends are whole picometres.
fn runs(
    [start, end]: [[f64; 2]; 2],
    centre: [f64; 2],
    direction: Direction,
    from: [Length; 3],
    to: [Length; 3],
) -> bool {
    if from != to || start == end {
        return true;
    }
    let [x, y] = [0, 1].map(|axis| start[axis] - centre[axis]);
    let [x_end, y_end] = [0, 1].map(|axis| end[axis] - centre[axis]);
    let turn = x * y_end - y * x_end;
    if direction == Direction::Ccw { turn < 0.0 } else { turn > 0.0 }
}

fn diagnostic(Fault { span, message, help }: Fault, place: &Place) -> Diagnostic {
    Diagnostic { place: Place { span, ..place.clone() }, also: Vec::new(), message, help }
}
