//! The modes that stay from block to block, and what a block makes of them.

use super::arc::{self, ProgrammedArc};
use super::block::{Block, MotionMode, Value};
use super::word::{Fault, Number};
use crate::{Curve, Integers, Length, LengthError, Machine, Motion, Rate};
use std::collections::VecDeque;
use std::ops::Range;

#[derive(Clone, Copy, Debug)]
pub(super) struct Modes {
    machine: Machine,
    motion: Option<MotionMode>,
    is_absolute: bool,
    is_metric: bool,
    feed: Option<Length>,
    /// The programmed point, exactly.
    position: [Length; 2],
}

impl Modes {
    /// A program's start: G17 G21 G90 in (0,0), no motion mode and no feed yet.
    pub(super) const fn new(machine: Machine) -> Self {
        Self {
            machine,
            motion: None,
            is_absolute: true,
            is_metric: true,
            feed: None,
            position: [Length::ZERO; 2],
        }
    }

    /// Takes a block: changes the modes, and adds the motions that it asks for.
    pub(super) fn run(
        &mut self,
        block: &Block,
        line: u32,
        motions: &mut VecDeque<Motion>,
    ) -> Result<(), Fault> {
        self.is_metric = block.is_metric.unwrap_or(self.is_metric);
        self.is_absolute = block.is_absolute.unwrap_or(self.is_absolute);
        if let Some((mode, _)) = &block.motion {
            self.motion = Some(*mode);
        }
        if let Some(f) = &block.f {
            self.feed = Some(self.feed(f)?);
        }
        let has_end = block.x.is_some() || block.y.is_some();
        if !has_end && block.arc_word().is_none() {
            return match &block.motion {
                Some((MotionMode::Arc(_), span)) => Err(Fault::new(
                    span.clone(),
                    "an arc without end point and centre",
                    "add X Y and I J, or I J alone for a full circle",
                )),
                _ => Ok(()),
            };
        }
        let rate = self.rate(block)?;
        let from = self.position;
        let to = [
            self.coordinate(block.x.as_ref(), from[0])?,
            self.coordinate(block.y.as_ref(), from[1])?,
        ];
        let ends = [self.pulses(from, &block.span)?, self.pulses(to, &block.span)?];
        let mut push = |[from, to]: [[i32; 2]; 2], curve| {
            if curve != Curve::Line || from != to {
                let [from, to] = [from, to].map(|[x, y]| [x, y, 0]);
                motions.push_back(Motion { line, from, to, curve, rate });
            }
        };
        match (self.motion, block.arc_word()) {
            (Some(MotionMode::Arc(direction)), Some(_)) => {
                let arc = self.arc(block, from, to)?;
                let [first, rest] =
                    arc.in_pulses(ends, direction, self.machine.pulse, &block.span)?;
                push(first.0, first.1);
                push(rest.0, rest.1);
            }
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
                    "I, J and R belong to arcs, and this is a line",
                    "remove the word, or say G02 or G03",
                ));
            }
            (_, None) => push(ends, Curve::Line),
        }
        self.position = to;
        Ok(())
    }

    fn rate(&self, block: &Block) -> Result<Rate, Fault> {
        match (self.motion, self.feed) {
            (None, _) => Err(Fault::new(
                block.span.clone(),
                "coordinates before any motion mode",
                "say how to go there: G00, G01, G02 or G03",
            )),
            (Some(MotionMode::Rapid), _) => Ok(Rate::Rapid),
            (Some(_), Some(feed)) => Ok(Rate::Feed(feed)),
            (Some(_), None) => Err(Fault::new(
                block.span.clone(),
                "a feed motion before any feed rate",
                "add F, for example F150",
            )),
        }
    }

    fn arc(
        &self,
        block: &Block,
        from: [Length; 2],
        to: [Length; 2],
    ) -> Result<ProgrammedArc, Fault> {
        let Some(r) = &block.r else {
            let offset = [self.offset(block.i.as_ref())?, self.offset(block.j.as_ref())?];
            return arc::by_centre(from, to, offset, self.machine.pulse, &block.span);
        };
        match block.i.as_ref().or(block.j.as_ref()) {
            Some(word) => Err(Fault::new(
                word.span.clone(),
                "an arc with both a radius and a centre",
                "leave R, or leave I and J",
            )),
            None => arc::by_radius(from, to, self.length(r)?, &r.span),
        }
    }

    fn feed(&self, value: &Value) -> Result<Length, Fault> {
        let feed = self.in_units(value)?;
        if feed <= Length::ZERO {
            return Err(Fault::new(
                value.span.clone(),
                "a feed rate is more than zero",
                "write a positive F; G00 needs none",
            ));
        }
        Ok(feed)
    }

    fn coordinate(&self, value: Option<&Value>, from: Length) -> Result<Length, Fault> {
        match value {
            None => Ok(from),
            Some(value) if self.is_absolute => self.length(value),
            Some(value) => {
                from.checked_add(self.length(value)?).ok_or_else(|| too_far(&value.span))
            }
        }
    }

    fn offset(&self, value: Option<&Value>) -> Result<Length, Fault> {
        value.map_or(Ok(Length::ZERO), |value| self.length(value))
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

    /// The nearest pulses. They are kept within half of the `i32` range, so that any two points
    /// are an `i32` apart.
    fn pulses(&self, point: [Length; 2], span: &Range<usize>) -> Result<[i32; 2], Fault> {
        let pulses = point.map(|length| length.in_pulses(self.machine.pulse));
        if pulses.iter().any(|count| count.abs() > i64::from(i32::MAX / 2)) {
            return Err(too_far(span));
        }
        Ok(pulses.map(|count| count as i32))
    }
}

pub(super) fn too_far(span: &Range<usize>) -> Fault {
    Fault::new(
        span.clone(),
        format!("further than {} pulses away", i32::MAX / 2),
        "stay nearer to the program's origin, or take a coarser pulse equivalent",
    )
}

fn bad_length(why: LengthError, value: &Value) -> Fault {
    Fault::new(value.span.clone(), format!("this length is {why}"), "write it shorter")
}
