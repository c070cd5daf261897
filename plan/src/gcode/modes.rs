//! The modes that stay from block to block, and what a block makes of them.

use super::arc::{self, ProgrammedArc};
use super::block::{Block, MotionMode, Stop, Value};
use super::step::{Cutter, Move, Pause, Phase, Step};
use super::word::{Fault, Number};
use crate::compensation::Side;
use crate::{Curve, Integers, Length, LengthError, Machine, Motion, Place, Rate, Tools};
use onepulse_core::Plane;
use std::collections::VecDeque;
use std::ops::Range;
use std::time::Duration;

#[derive(Clone, Debug)]
pub(super) struct Modes {
    machine: Machine,
    tools: Tools,
    motion: Option<MotionMode>,
    plane: Plane,
    is_absolute: bool,
    is_metric: bool,
    feed: Option<Length>,
    spindle: Option<f64>,
    /// The tool in use, T.
    tool: Option<u32>,
    /// The tool whose radius counts, D; that in use if there is none.
    offset: Option<u32>,
    compensation: Compensation,
    /// The programmed point, exactly.
    position: [Length; 3],
    /// What is known of it: a block with an error may have gone anywhere.
    is_known: [bool; 3],
}

/// How far compensation is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Compensation {
    Off,
    /// The next line in the plane establishes it.
    Due {
        side: Side,
        radius: f64,
    },
    On {
        side: Side,
        radius: f64,
    },
    /// The next line in the plane cancels it.
    Leaving {
        side: Side,
        radius: f64,
    },
}

impl Modes {
    /// A program's start: G17 G21 G40 G90 in (0,0,0), no motion mode and no feed yet.
    pub(super) const fn new(machine: Machine, tools: Tools) -> Self {
        Self {
            machine,
            tools,
            motion: None,
            plane: Plane::Xy,
            is_absolute: true,
            is_metric: true,
            feed: None,
            spindle: None,
            tool: None,
            offset: None,
            compensation: Compensation::Off,
            position: [Length::ZERO; 3],
            is_known: [true; 3],
        }
    }

    /// Takes a block: changes the modes, and adds the steps that it asks for.
    ///
    /// Adds what is wrong with it to `faults`. Where there are some, in it or before, its steps are
    /// of no use, and it is read for more faults only.
    pub(super) fn run(
        &mut self,
        block: &Block,
        place: &Place,
        steps: &mut VecDeque<Step>,
        faults: &mut Vec<Fault>,
    ) {
        let is_clean = faults.is_empty();
        self.set(block, faults);
        let action = match &block.dwell {
            Some((_, span)) => self.dwell(block, span, place).map(Some),
            None if is_clean => self.motion(block, place),
            None => {
                self.pass(block);
                Ok(None)
            }
        };
        match action {
            Ok(step) => steps.extend(step),
            Err(fault) => faults.push(fault),
        }
        if let Some((Stop::Program, _)) = block.stop {
            steps.push_back(Step::Pause(Pause { place: place.clone(), dwell: None }));
        }
    }

    /// What is wrong with a program that ends now, in a word or at the end of a line.
    pub(super) fn end(&self, span: Range<usize>) -> Option<Fault> {
        (self.compensation != Compensation::Off).then(|| {
            Fault::new(
                span,
                "the program ends while the cutter is compensated",
                "cancel it before, on a line: G40 with G00 or G01 and an end point",
            )
        })
    }

    /// Everything but the motion.
    fn set(&mut self, block: &Block, faults: &mut Vec<Fault>) {
        if let Some((is_metric, _)) = block.is_metric {
            self.is_metric = is_metric;
        }
        if let Some((is_absolute, _)) = block.is_absolute {
            self.is_absolute = is_absolute;
        }
        if let Some((mode, _)) = block.motion {
            self.motion = Some(mode);
        }
        let mut take = |result: Result<(), Fault>| faults.extend(result.err());
        take(self.set_feed(block));
        take(self.set_spindle(block));
        take(whole(block.t.as_ref()).map(|tool| self.tool = tool.or(self.tool)));
        take(self.set_plane(block));
        take(self.set_compensation(block));
        if let (Some(word), None) = (&block.p, &block.dwell) {
            take(Err(Fault::new(
                word.span.clone(),
                "P without a dwell",
                "P is the time of G04, in seconds: write G04 P0.5, or remove the word",
            )));
        }
    }

    fn set_feed(&mut self, block: &Block) -> Result<(), Fault> {
        let Some(value) = &block.f else { return Ok(()) };
        let feed = self.in_units(value);
        // Wrong as it is, it is no feed that is missing.
        self.feed = feed.clone().ok().or(self.feed).or(Some(Length::ZERO));
        if feed? <= Length::ZERO {
            return Err(Fault::new(
                value.span.clone(),
                "a feed rate is more than zero",
                "write a positive F; G00 needs none",
            ));
        }
        Ok(())
    }

    fn set_spindle(&mut self, block: &Block) -> Result<(), Fault> {
        let Some(Value { number: Number { digits, decimals, .. }, span }) = &block.s else {
            return Ok(());
        };
        if *digits < 0 {
            return Err(Fault::new(
                span.clone(),
                "a spindle speed is not negative",
                "write S without the sign",
            ));
        }
        self.spindle = Some(*digits as f64 / 10_f64.powi((*decimals).min(400) as i32));
        Ok(())
    }

    fn set_plane(&mut self, block: &Block) -> Result<(), Fault> {
        let Some((plane, span)) = &block.plane else { return Ok(()) };
        let is_new = std::mem::replace(&mut self.plane, *plane) != *plane;
        if is_new && self.compensation != Compensation::Off {
            return Err(Fault::new(
                span.clone(),
                "the plane changes while the cutter is compensated",
                "cancel with G40 on a line before",
            ));
        }
        Ok(())
    }

    fn set_compensation(&mut self, block: &Block) -> Result<(), Fault> {
        use Compensation::{Due, Leaving, Off, On};
        let before = self.offset;
        let chosen = whole(block.d.as_ref())?;
        self.offset = chosen.or(self.offset);
        if let (Due { .. } | On { .. } | Leaving { .. }, Some(word)) = (self.compensation, &block.d)
        {
            if before != self.offset {
                return Err(Fault::new(
                    word.span.clone(),
                    "the cutter's radius changes while it is compensated",
                    "cancel with G40 on a line before, and then compensate with the new one",
                ));
            }
        }
        let Some((word, span)) = &block.side else { return Ok(()) };
        self.compensation = match (self.compensation, *word) {
            (Off | Due { .. }, None) => Off,
            (On { side, radius } | Leaving { side, radius }, None) => Leaving { side, radius },
            (Off, Some(side)) => Due { side, radius: self.radius(block, span)? },
            (same @ (Due { side, .. } | On { side, .. }), Some(new)) if side == new => same,
            (Due { .. } | On { .. }, Some(_)) => {
                return Err(Fault::new(
                    span.clone(),
                    "the side changes while the cutter is compensated",
                    "cancel with G40 on a line before, and then compensate on the other side",
                ));
            }
            (Leaving { .. }, Some(_)) => {
                return Err(Fault::new(
                    span.clone(),
                    "the compensation before is not cancelled yet",
                    "between G40 and this block a line in the plane is needed, on which it is cancelled",
                ));
            }
        };
        Ok(())
    }

    /// The radius that compensation takes.
    fn radius(&self, block: &Block, span: &Range<usize>) -> Result<f64, Fault> {
        let wrong = |message: String, help: &str| {
            let span = block.d.as_ref().map_or(span, |word| &word.span);
            Err(Fault::new(span.clone(), message, help))
        };
        match (&self.tools, self.offset.or(self.tool)) {
            (Tools::Radius(radius), _) => Ok(*radius),
            // By convention the number of no offset, if it is no tool's.
            (Tools::Table(table), Some(tool)) => match table.diameter(tool) {
                Some(diameter) => Ok(diameter.millimetres() / 2.0),
                None if tool == 0 => Ok(0.0),
                None => wrong(
                    format!("tool {tool} is not in the tool table"),
                    "correct D, or add the tool to the table",
                ),
            },
            (Tools::Table(_), None) => wrong(
                "compensation without a tool".into(),
                "add D and the tool's number, or T in a block before",
            ),
            (Tools::Unknown, _) => wrong(
                "the cutter's radius is not known".into(),
                "give a tool table with --tool-table, or the radius with --radius",
            ),
        }
    }

    fn dwell(&self, block: &Block, span: &Range<usize>, place: &Place) -> Result<Step, Fault> {
        let [x, y, z] = &block.coordinates;
        let stray = [y, z].into_iter().flatten().chain(block.arc_word()).next();
        if let Some((_, span)) = &block.motion {
            return Err(Fault::new(
                span.clone(),
                "a dwell and a motion in one block",
                "write two blocks",
            ));
        }
        if let Some(word) = stray {
            return Err(Fault::new(
                word.span.clone(),
                "a dwell moves nothing",
                "remove the word; the time is P or X, in seconds",
            ));
        }
        let value = match (&block.p, x) {
            (Some(value), None) | (None, Some(value)) => value,
            (Some(_), Some(second)) => {
                return Err(Fault::new(
                    second.span.clone(),
                    "a dwell of two times",
                    "leave P or X",
                ));
            }
            (None, None) => {
                return Err(Fault::new(
                    span.clone(),
                    "a dwell without a time",
                    "add P and the seconds, as in G04 P0.5",
                ));
            }
        };
        let dwell = seconds(value.number).ok_or_else(|| {
            Fault::new(
                value.span.clone(),
                "this is no time of a dwell",
                "0 to 1000000 seconds are, with at most 9 decimals",
            )
        })?;
        Ok(Step::Pause(Pause { place: place.clone(), dwell: Some(dwell) }))
    }

    /// Passes over a block with an error as if it were right otherwise.
    fn pass(&mut self, block: &Block) {
        // What is wrong with its coordinates is not told besides.
        if self.end_point(block).is_err() || block.coordinates.iter().all(Option::is_none) {
            return;
        }
        self.compensation = match self.compensation {
            Compensation::Due { side, radius } => Compensation::On { side, radius },
            Compensation::Leaving { .. } => Compensation::Off,
            other => other,
        };
    }

    /// The motion that a block asks for.
    fn motion(&mut self, block: &Block, place: &Place) -> Result<Option<Step>, Fault> {
        let has_end = block.coordinates.iter().any(Option::is_some);
        if !has_end && block.arc_word().is_none() {
            return match &block.motion {
                Some((MotionMode::Arc(_), span)) => Err(Fault::new(
                    span.clone(),
                    "an arc without end point and centre",
                    "add X Y and I J, or I J alone for a full circle",
                )),
                _ => Ok(None),
            };
        }
        let from = self.position;
        let [first, second, _] = self.plane.axes();
        let knows_start = self.is_known[first] && self.is_known[second];
        let to = self.end_point(block)?;
        let rate = self.rate(block)?;
        let arc = match (self.motion, block.arc_word()) {
            (Some(MotionMode::Arc(direction)), Some(_)) => match self.arc(block, from, to) {
                Ok(arc) => Some((arc, direction)),
                // From who knows where it may be an arc.
                Err(_) if !knows_start => return Ok(None),
                Err(fault) => return Err(fault),
            },
            (Some(MotionMode::Arc(_)), None) => {
                return Err(Fault::new(
                    block.span.clone(),
                    "an arc without a centre",
                    "add I J (the centre seen from the start) or R; or say G01 for a line",
                ));
            }
            (_, Some(word)) => {
                return Err(Fault::new(
                    word.span.clone(),
                    "I, J, K and R belong to arcs, and this is a line",
                    "remove the word, or say G02 or G03",
                ));
            }
            (_, None) => None,
        };
        let cutter = self.cutter(block, from, to, arc.is_some())?;
        let ends = [self.pulses(from, &block.span)?, self.pulses(to, &block.span)?];
        let mut planned = Move {
            place: place.clone(),
            from,
            to,
            plane: self.plane,
            rate,
            tool: self.tool,
            spindle: self.spindle,
            cutter,
            arc,
            motions: [None; 2],
        };
        if cutter == Cutter::Off {
            planned.motions = planned.in_pulses(ends, self.machine.pulse)?;
        }
        Ok(Some(Step::Move(planned)))
    }

    /// Where a block goes; it is taken to be there whatever else is wrong with it.
    fn end_point(&mut self, block: &Block) -> Result<[Length; 3], Fault> {
        let mut result = Ok(());
        for axis in 0..3 {
            let Some(value) = &block.coordinates[axis] else {
                self.is_known[axis] &= !block.is_garbled;
                continue;
            };
            match self.coordinate(value, self.position[axis]) {
                Ok(to) => {
                    self.position[axis] = to;
                    self.is_known[axis] |= self.is_absolute;
                }
                Err(fault) => {
                    self.is_known[axis] = false;
                    result = result.and(Err(fault));
                }
            }
        }
        result.map(|()| self.position)
    }

    /// How fast a block moves; what is missing is missed once.
    fn rate(&mut self, block: &Block) -> Result<Rate, Fault> {
        match (self.motion, self.feed) {
            (None, _) => {
                self.motion = Some(MotionMode::Rapid);
                Err(Fault::new(
                    block.span.clone(),
                    "coordinates before any motion mode",
                    "say how to go there: G00, G01, G02 or G03",
                ))
            }
            (Some(MotionMode::Rapid), _) => Ok(Rate::Rapid),
            (Some(_), Some(feed)) => Ok(Rate::Feed(feed)),
            (Some(_), None) => {
                self.feed = Some(Length::ZERO);
                Err(Fault::new(
                    block.span.clone(),
                    "a feed motion before any feed rate",
                    "add F, for example F150",
                ))
            }
        }
    }

    /// The arc of a block.
    fn arc(
        &self,
        block: &Block,
        from: [Length; 3],
        to: [Length; 3],
    ) -> Result<ProgrammedArc, Fault> {
        let [first, second, across] = self.plane.axes();
        if let Some(word) = &block.coordinates[across] {
            if from[across] != to[across] {
                return Err(Fault::new(
                    word.span.clone(),
                    format!(
                        "an arc of the plane {} does not move {}",
                        name(self.plane),
                        "XYZ".as_bytes()[across] as char
                    ),
                    "there are no helices in programs: write the arc and a line",
                ));
            }
        }
        if let Some(word) = &block.offsets[across] {
            return Err(Fault::new(
                word.span.clone(),
                format!("this is no coordinate of the plane {}", name(self.plane)),
                "arcs of G17 have I and J, of G18 I and K, of G19 J and K",
            ));
        }
        let centre = [&block.offsets[first], &block.offsets[second]];
        let ends = [from, to].map(|point| [point[first], point[second]]);
        match (&block.r, centre.into_iter().flatten().next()) {
            (Some(_), Some(word)) => Err(Fault::new(
                word.span.clone(),
                "an arc with both a radius and a centre",
                "leave R, or leave the centre",
            )),
            (Some(r), None) => arc::by_radius(ends, self.length(r)?, &r.span),
            (None, _) => {
                let offset = [self.offset(centre[0])?, self.offset(centre[1])?];
                arc::by_centre(ends, offset, self.machine.pulse, &block.span)
            }
        }
    }

    /// What compensation makes of a motion, and how far it is after it.
    fn cutter(
        &mut self,
        block: &Block,
        from: [Length; 3],
        to: [Length; 3],
        is_arc: bool,
    ) -> Result<Cutter, Fault> {
        let [first, second, _] = self.plane.axes();
        let moves = is_arc || from[first] != to[first] || from[second] != to[second];
        let line_only = |message: &str, help: &str| match is_arc {
            true => Err(Fault::new(block.span.clone(), message, help)),
            false => Ok(()),
        };
        let (side, radius, phase, is_line) = match self.compensation {
            Compensation::Off => return Ok(Cutter::Off),
            Compensation::Due { .. } if !moves => return Ok(Cutter::Off),
            Compensation::Due { side, radius } => {
                self.compensation = Compensation::On { side, radius };
                let is_line = line_only(
                    "compensation is established on a line, and this is an arc",
                    "move to the arc's start on a line in the block of G41 or G42, or after it",
                );
                (side, radius, Phase::Establish, is_line)
            }
            Compensation::On { side, radius } | Compensation::Leaving { side, radius }
                if !moves =>
            {
                (side, radius, Phase::Across, Ok(()))
            }
            Compensation::On { side, radius } => (side, radius, Phase::Contour, Ok(())),
            Compensation::Leaving { side, radius } => {
                self.compensation = Compensation::Off;
                let is_line = line_only(
                    "compensation is cancelled on a line, and this is an arc",
                    "leave the contour on a line in the block of G40, or after it",
                );
                (side, radius, Phase::Cancel, is_line)
            }
        };
        is_line.map(|()| Cutter::On { side, radius, phase })
    }

    fn coordinate(&self, value: &Value, from: Length) -> Result<Length, Fault> {
        if self.is_absolute {
            return self.length(value);
        }
        from.checked_add(self.length(value)?).ok_or_else(|| too_far(&value.span))
    }

    fn offset(&self, value: &Option<Value>) -> Result<Length, Fault> {
        value.as_ref().map_or(Ok(Length::ZERO), |value| self.length(value))
    }

    /// A length in the program's unit, or in pulses where integers count those.
    fn length(&self, value: &Value) -> Result<Length, Fault> {
        if value.number.has_point || self.machine.integers == Integers::Units {
            return self.in_units(value);
        }
        let Number { digits, decimals, .. } = value.number;
        Length::of(digits, decimals, self.machine.pulse).map_err(|why| bad_length(why, value))
    }

    fn in_units(&self, value: &Value) -> Result<Length, Fault> {
        let Number { digits, decimals, .. } = value.number;
        let unit = if self.is_metric { Length::MILLIMETRE } else { Length::INCH };
        Length::of(digits, decimals, unit).map_err(|why| bad_length(why, value))
    }

    fn pulses(&self, point: [Length; 3], span: &Range<usize>) -> Result<[i32; 3], Fault> {
        in_pulses(point, self.machine.pulse).ok_or_else(|| too_far(span))
    }
}

impl Move {
    /// The path in pulses between these ends.
    pub(crate) fn in_pulses(
        &self,
        ends: [[i32; 3]; 2],
        pulse: Length,
    ) -> Result<[Option<Motion>; 2], Fault> {
        let line = self.place.line;
        let rate = self.rate;
        let Some((arc, direction)) = self.arc else {
            let [from, to] = ends;
            let motion = Motion { line, from, to, curve: Curve::Line, rate };
            return Ok([(from != to).then_some(motion), None]);
        };
        let [first, second, across] = self.plane.axes();
        let in_plane = ends.map(|point| [point[first], point[second]]);
        let pieces = arc.in_pulses(in_plane, direction, pulse, &self.place.span)?;
        Ok(pieces.map(|piece| {
            let ([from, to], centre) = piece?;
            let place = |[a, b]: [i32; 2]| self.plane.place([a, b, ends[0][across]]);
            let curve = match centre {
                None => Curve::Line,
                Some(centre) => Curve::Arc { plane: self.plane, centre, direction },
            };
            Some(Motion { line, from: place(from), to: place(to), curve, rate })
        }))
    }
}

/// The nearest pulses. They are kept within half of the `i32` range, so that any two points are an
/// `i32` apart; none is further away.
pub(crate) fn in_pulses(point: [Length; 3], pulse: Length) -> Option<[i32; 3]> {
    let pulses = point.map(|length| length.in_pulses(pulse));
    let is_near = pulses.iter().all(|count| count.unsigned_abs() <= i32::MAX as u64 / 2);
    is_near.then(|| pulses.map(|count| count as i32))
}

pub(crate) fn too_far(span: &Range<usize>) -> Fault {
    Fault::new(
        span.clone(),
        format!("further than {} pulses away", i32::MAX / 2),
        "stay nearer to the program's origin, or take a coarser pulse equivalent",
    )
}

fn bad_length(why: LengthError, value: &Value) -> Fault {
    Fault::new(value.span.clone(), format!("this length is {why}"), "write it shorter")
}

/// A plane as programs call it.
const fn name(plane: Plane) -> &'static str {
    match plane {
        Plane::Xy => "XY (G17)",
        Plane::Zx => "ZX (G18)",
        Plane::Yz => "YZ (G19)",
    }
}

/// The number of a tool.
fn whole(value: Option<&Value>) -> Result<Option<u32>, Fault> {
    let Some(Value { number, span }) = value else { return Ok(None) };
    let whole = number.as_integer().and_then(|number| u32::try_from(number).ok());
    match whole {
        Some(tool) if !number.has_point => Ok(Some(tool)),
        _ => Err(Fault::new(
            span.clone(),
            "a tool's number is a whole number",
            "write T1 or D1, without sign and point",
        )),
    }
}

/// A time in seconds, up to a million.
fn seconds(Number { digits, decimals, .. }: Number) -> Option<Duration> {
    let nanoseconds =
        u128::try_from(digits).ok()? * 10_u128.checked_pow(9_u32.checked_sub(decimals)?)?;
    let seconds = u64::try_from(nanoseconds / 1_000_000_000).ok()?;
    let is_short = nanoseconds <= 1_000_000 * 1_000_000_000;
    is_short.then(|| Duration::new(seconds, (nanoseconds % 1_000_000_000) as u32))
}
