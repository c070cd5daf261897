//! Walking a circuit round its arc, with a limit on how long it may take.

use super::curve::{Case, Curve};
use super::tally::{Share, Tally};
use onepulse_core::{Direction, Pulse, Sweep, dda};

/// A circuit that draws an arc.
pub(crate) trait Circuit {
    /// One cycle; `None` at the end.
    fn step(&mut self) -> Option<Pulse>;

    /// Where the arc is on its way round.
    fn sweep(&self) -> &Sweep;
}

impl Circuit for dda::Arc {
    fn step(&mut self) -> Option<Pulse> {
        Self::step(self)
    }

    fn sweep(&self) -> &Sweep {
        Self::sweep(self)
    }
}

impl Circuit for dda::CentredArc {
    fn step(&mut self) -> Option<Pulse> {
        Self::step(self)
    }

    fn sweep(&self) -> &Sweep {
        Self::sweep(self)
    }
}

/// An arc and the registers that it is drawn with.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Drawing {
    /// The start point.
    pub(crate) start: [i32; 2],
    /// The end point.
    pub(crate) end: [i32; 2],
    /// The sense.
    pub(crate) direction: Direction,
    /// n.
    pub(crate) bits: u32,
    /// Q.
    pub(crate) shift: u32,
}

impl Drawing {
    /// What is drawn.
    pub(crate) fn curve(&self) -> Curve {
        let [start, end] = [self.start, self.end].map(|point| point.map(i64::from));
        Curve::Arc { start, end, direction: self.direction }
    }
}

/// An extreme point of a path.
#[derive(Clone, Copy)]
struct Extreme {
    square: i64,
    cycle: u64,
    point: [i64; 2],
}

/// Draws the arc to its end, and takes its figures into the tally: the largest deviation, and a
/// fault if it does not end, or not on its end point.
///
/// An integrating arc that has not ended makes a pulse at least once in 2^(n−Q) cycles. As long as
/// no pulse comes, no coordinate changes, so each remainder changes by the same integrand in each
/// cycle, ±J·2^Q with an integer J. Where J ≠ 0 for an axis that does not stand, 2^(n−Q) cycles
/// change its remainder by 2ⁿ or more, and that is over its range: a carry or a borrow, a pulse.
/// So the only way to wait longer is that every axis that does not stand has J = 0: to *starve*, for
/// ever. (The arcs of the core step out instead.) The pulses are limited too: there are at most five
/// pieces between coordinate axes, in each of them both coordinates are monotone and smaller than
/// 2ⁿ, which makes at most 2·2ⁿ pulses a piece, and as many for stepping out. Hence an arc has ended
/// after at most 12·2ⁿ·2^(n−Q) cycles, or it is at fault; in fact a full turn takes some 2π·2^(n−Q)
/// cycles, and at most 10.4·2^(n−Q) where small radii wait long.
pub(crate) fn walk(mut circuit: impl Circuit, drawing: &Drawing, tally: &mut Tally) {
    let Drawing { start, end, bits, shift, .. } = *drawing;
    let wait_limit = 1_u64 << (bits - shift);
    let pulse_limit = 12_u64 << bits;
    let [start, end] = [start, end].map(|point| point.map(i64::from));
    let curve = drawing.curve();

    let mut point = start;
    let square = point[0] * point[0] + point[1] * point[1];
    let mut inmost = Extreme { square, cycle: 0, point };
    let mut outmost = inmost;
    let (mut cycle, mut pulses, mut last_pulse, mut wait) = (0, 0, 0, 0);
    let mut has_stepped_out = false;
    let mut why = None;
    while let Some(Pulse([dx, dy])) = circuit.step() {
        cycle += 1;
        if [dx, dy] == [0, 0] {
            if cycle - last_pulse >= wait_limit {
                why = Some(format!("starves at {},{}", point[0], point[1]));
                break;
            }
            continue;
        }
        wait = u64::max(wait, cycle - last_pulse - 1);
        last_pulse = cycle;
        pulses += u64::from(dx != 0) + u64::from(dy != 0);
        if pulses > pulse_limit {
            why = Some("makes pulses without end".to_owned());
            break;
        }
        point = [point[0] + i64::from(dx), point[1] + i64::from(dy)];
        let square = point[0] * point[0] + point[1] * point[1];
        if square < inmost.square {
            inmost = Extreme { square, cycle, point };
        }
        if square > outmost.square {
            outmost = Extreme { square, cycle, point };
        }
        has_stepped_out |= point != end && circuit.sweep().is_stepping_out(point);
    }
    if why.is_none() && point != end {
        why = Some(format!("ends at {},{}", point[0], point[1]));
    }

    tally.curves += 1;
    tally.cycles += cycle;
    tally.longest = tally.longest.max(Share { part: cycle, whole: wait_limit });
    tally.wait = tally.wait.max(Share { part: wait, whole: wait_limit });
    tally.stepped_out += u64::from(has_stepped_out);
    let case = |e: Extreme| Case { curve, bits, cycle: e.cycle, point: e.point };
    tally.stray(&[case(inmost), case(outmost)]);
    if let Some(why) = why {
        tally.fault(curve, bits, why);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use onepulse_core::dda::{Preset, Radix, Register};

    /// An arc that never ends, or ends at once.
    struct Idle(Sweep, Option<Pulse>);

    impl Circuit for Idle {
        fn step(&mut self) -> Option<Pulse> {
            self.1
        }

        fn sweep(&self) -> &Sweep {
            &self.0
        }
    }

    const QUARTER: Drawing =
        Drawing { start: [5, 0], end: [0, 5], direction: Direction::Ccw, bits: 3, shift: 0 };

    #[test]
    fn a_good_arc_has_no_fault() {
        let register = Register::new(Radix::Binary, 3).unwrap();
        let arc = dda::Arc::new(
            QUARTER.start,
            QUARTER.end,
            QUARTER.direction,
            register,
            Preset::Zero,
            false,
        )
        .unwrap();
        let mut tally = Tally::default();
        walk(arc, &QUARTER, &mut tally);
        assert_eq!((tally.curves, tally.faults), (1, 0));
        assert_eq!(tally.cycles, arc.count() as u64);
    }

    #[test]
    fn what_does_not_end_there_is_at_fault() {
        let sweep = Sweep::new(QUARTER.start, QUARTER.end, QUARTER.direction).unwrap();
        for (pulse, why) in [
            (None, "ends at 5,0"),
            (Some(Pulse::NONE), "starves at 5,0"),
            (Some(Pulse([0, 1])), "makes pulses without end"),
        ] {
            let mut tally = Tally::default();
            walk(Idle(sweep, pulse), &QUARTER, &mut tally);
            assert_eq!(tally.first_fault.unwrap().why, why);
        }
    }
}
