//! The whole interpolator against the software: every command that the software serves is carried
//! out pulse for pulse and step for step, every other is refused, and nothing is lost in between.
#![allow(clippy::unwrap_used)]

use onepulse_core::dda::{self, Preset, Radix, Register};
use onepulse_core::{Direction, EndRule, Error, Pulse, brm, ppc};
use onepulse_hwmodel::Timing;
use onepulse_hwmodel::interpolator::{Command, Curve, Inputs, Interpolator, Refusal};
use std::collections::VecDeque;

/// A pulse of one axis: the axis, and whether it is negative.
type Step = (usize, bool);

/// The number of cycles, and the single pulses in their order; both axes of a cycle in that of the
/// axes.
fn steps<const N: usize>(pulses: impl Iterator<Item = Pulse<N>>) -> (u64, Vec<Step>) {
    let mut steps = Vec::new();
    let mut cycles = 0;
    for Pulse(pulse) in pulses {
        let moving = pulse.into_iter().enumerate().filter(|(_, p)| *p != 0);
        steps.extend(moving.map(|(axis, p)| (axis, p < 0)));
        cycles += 1;
    }
    (cycles, steps)
}

/// What the software makes of a command: its cycles, and the pulses in them.
fn software<const N: usize>(command: &Command<N>, bits: u32) -> Result<(u64, Vec<Step>), Error> {
    let narrow = |c: i64| c as i32;
    let all = command.end.map(narrow);
    let (start, end) = (command.start.map(narrow), [all[0], all[1]]);
    let direction = if command.cw { Direction::Cw } else { Direction::Ccw };
    let preset = [Preset::Zero, Preset::Half, Preset::Full][usize::from(command.preset % 3)];
    let register = Register::new(Radix::Binary, bits)?;
    let normalize = command.normalize;
    Ok(match Curve::from_code(command.curve).unwrap() {
        Curve::DdaLine => steps(dda::Line::new(all, register, preset, normalize)?),
        Curve::BrmLine => steps(brm::Line::new(all, bits)?),
        Curve::PpcLine => steps(ppc::Line::new(end, EndRule::PerAxis)?),
        Curve::PpcArc => {
            let needed = onepulse_hwmodel::ppc::Arc::bits(start, end, direction)?;
            if needed > bits {
                return Err(Error::RegisterTooNarrow { digits: bits, needed });
            }
            steps(ppc::Arc::new(start, end, direction, EndRule::PerAxis)?)
        }
        Curve::DdaArc => steps(dda::Arc::new(start, end, direction, register, preset, normalize)?),
        Curve::DdaCentredArc => {
            steps(dda::CentredArc::new(start, end, direction, register, normalize)?)
        }
    })
}

fn coordinate(random: &mut fastrand::Rng, bits: u32) -> i64 {
    let largest = (1_i64 << bits) - 1;
    let magnitude = match random.u8(..8) {
        0 => 0,
        1 => 1,
        2 => largest,
        _ => random.i64(0..=largest) >> random.u32(..bits),
    };
    if random.bool() { -magnitude } else { magnitude }
}

fn command<const N: usize>(random: &mut fastrand::Rng, bits: u32) -> Command<N> {
    let curve = random.u8(..6);
    let is_flat = !matches!(Curve::from_code(curve), Some(Curve::DdaLine | Curve::BrmLine));
    let mut end = [0; N].map(|_| coordinate(random, bits));
    if is_flat {
        end[2..].fill(0);
    }
    let start = [0; 2].map(|_| coordinate(random, bits));
    let [x, y] = start;
    let end_of_arc = match random.u8(..8) {
        0 => Some(start),
        1 => Some([-x, -y]),
        2 => Some([y, -x]),
        3 => Some([-y, x]),
        4 => Some([-x, y]),
        _ => None,
    };
    if let Some(on_circle) = end_of_arc {
        end[..2].copy_from_slice(&on_circle);
    }
    Command {
        curve,
        start,
        end,
        cw: random.bool(),
        preset: random.u8(..3),
        normalize: random.bool(),
        period: random.u32(6..12),
    }
}

/// Gives commands as fast as they are taken, and sees what comes out.
struct Host<const N: usize> {
    interpolator: Interpolator<N>,
    timing: Timing,
    waiting: VecDeque<Command<N>>,
    refused: Vec<(Command<N>, Refusal)>,
    pulses: Vec<Step>,
    stepped: [Vec<bool>; N],
    was_high: [bool; N],
    taken: Option<Command<N>>,
    clock: u64,
    /// The clocks in which there were pulses.
    at: Vec<u64>,
}

impl<const N: usize> Host<N> {
    fn new(bits: u32, timing: Timing, commands: &[Command<N>]) -> Self {
        Self {
            interpolator: Interpolator::new(bits).unwrap(),
            timing,
            waiting: commands.iter().copied().collect(),
            refused: Vec::new(),
            pulses: Vec::new(),
            stepped: std::array::from_fn(|_| Vec::new()),
            was_high: [false; N],
            taken: None,
            clock: 0,
            at: Vec::new(),
        }
    }

    fn run(mut self) -> Self {
        while !self.waiting.is_empty()
            || !self.interpolator.done()
            || self.interpolator.error() != Refusal::None
        {
            let refusal = self.interpolator.error();
            if refusal != Refusal::None {
                self.refused.push((self.taken.unwrap(), refusal));
            }
            let inputs = Inputs {
                reset: false,
                command: self.waiting.front().copied(),
                clear: refusal != Refusal::None,
                timing: self.timing,
            };
            if self.interpolator.ready() {
                self.taken = self.waiting.pop_front().or(self.taken);
            }
            self.interpolator.clock(&inputs);
            let pulse = self.interpolator.pulses();
            if !pulse.is_none() {
                self.at.push(self.clock);
            }
            self.pulses.extend(steps([pulse].into_iter()).1);
            for axis in 0..N {
                let is_high = self.interpolator.steps()[axis];
                if is_high && !self.was_high[axis] {
                    self.stepped[axis].push(self.interpolator.dirs()[axis]);
                }
                self.was_high[axis] = is_high;
            }
            self.clock += 1;
            assert!(self.clock < 100_000_000, "{:?} never ends", self.taken);
        }
        self
    }
}

fn is_equal<const N: usize>(bits: u32, size: u32, count: usize, seed: u64) {
    let mut random = fastrand::Rng::with_seed(seed);
    let commands: Vec<Command<N>> = (0..count).map(|_| command(&mut random, size)).collect();
    let mut time = || random.u32(0..12);
    let timing = Timing { length: time(), space: time(), setup: time(), hold: time() };
    let host = Host::new(bits, timing, &commands).run();
    let mut due = Vec::new();
    let mut refused = Vec::new();
    for command in &commands {
        match software(command, bits) {
            Ok((_, pulses)) => due.extend(pulses),
            Err(why) => refused.push((*command, why)),
        }
    }
    assert_eq!(host.refused.len(), refused.len(), "{:#?} {refused:#?}", host.refused);
    for ((command, refusal), (expected, why)) in host.refused.iter().zip(&refused) {
        assert_eq!(command, expected);
        let word = match why {
            Error::StartInCentre | Error::EndInCentre => Refusal::Centre,
            _ => Refusal::TooLarge,
        };
        assert_eq!(*refusal, word, "{command:?} {why}");
    }
    assert!(host.pulses == due, "{bits} bits, seed {seed}");
    for axis in 0..N {
        let due: Vec<_> = due.iter().filter(|(of, _)| *of == axis).map(|(_, n)| *n).collect();
        assert!(host.stepped[axis] == due, "{bits} bits, seed {seed}, axis {axis}");
    }
}

#[test]
fn it_does_what_the_software_does() {
    for seed in 0..30 {
        is_equal::<2>(5, 5, 60, seed);
        is_equal::<3>(8, 7, 20, seed);
        is_equal::<4>(10, 6, 10, seed);
        is_equal::<2>(2, 2, 40, seed);
        is_equal::<2>(3, 3, 40, seed);
    }
}

/// Every command that a width has coordinates for, and the clocks that it may take.
fn is_equal_and_in_time(command: Command<2>, bits: u32) {
    let timing = Timing { length: 2, space: 2, setup: 1, hold: 1 };
    let host = Host::new(bits, timing, &[command]).run();
    let Ok((cycles, due)) = software(&command, bits) else {
        assert_eq!(host.refused.len(), 1, "{command:?}");
        assert!(host.pulses.is_empty());
        return;
    };
    assert!(host.refused.is_empty() && host.pulses == due, "{command:?}");
    // Decoding, the cycles, and the last pulse's way to the end of its step.
    let clocks = u64::from(4 * bits + 13) + cycles * u64::from(command.period) + 16;
    assert!(host.clock <= clocks, "{command:?}: {} clocks, not {clocks}", host.clock);
}

#[test]
fn every_command_of_two_bits_ends_where_and_when_it_should() {
    let coordinates = || -3..=3;
    for (x0, y0) in coordinates().flat_map(|x| coordinates().map(move |y| (x, y))) {
        for (x, y) in coordinates().flat_map(|x| coordinates().map(move |y| (x, y))) {
            for choice in 0..72 {
                let (curve, cw, normalize) =
                    (choice % 6, choice / 6 % 2 == 1, choice / 12 % 2 == 1);
                let is_line = matches!(
                    Curve::from_code(curve).unwrap(),
                    Curve::DdaLine | Curve::PpcLine | Curve::BrmLine
                );
                // A line's start means nothing.
                if is_line && (x0, y0) != (0, 0) {
                    continue;
                }
                let (start, end, preset) = ([x0, y0], [x, y], choice / 24);
                is_equal_and_in_time(
                    Command { curve, start, end, cw, preset, normalize, period: 6 },
                    2,
                );
            }
        }
    }
}

#[test]
fn the_widest_registers_hold_32_bit_coordinates() {
    // Refusals and first contents only: such arcs take hours.
    let mut random = fastrand::Rng::with_seed(7);
    for bits in [24, 31, 32] {
        for _ in 0..2000 {
            let command =
                Command { curve: random.u8(1..5), ..command::<2>(&mut random, bits.min(31)) };
            let mut interpolator = Interpolator::<2>::new(bits).unwrap();
            let inputs = Inputs { command: Some(command), ..Inputs::default() };
            interpolator.clock(&inputs);
            for _ in 0..200 {
                interpolator.clock(&Inputs::default());
            }
            let narrow = |c: [i64; 2]| c.map(|c| c as i32);
            let (start, end) = (narrow(command.start), narrow(command.end));
            let direction = if command.cw { Direction::Cw } else { Direction::Ccw };
            let register = Register::new(Radix::Binary, bits).unwrap();
            let is_served = match Curve::from_code(command.curve).unwrap() {
                Curve::DdaArc => {
                    dda::Arc::new(start, end, direction, register, Preset::Half, false).is_ok()
                }
                Curve::DdaCentredArc => {
                    dda::CentredArc::new(start, end, direction, register, false).is_ok()
                }
                Curve::PpcArc => onepulse_hwmodel::ppc::Arc::bits(start, end, direction)
                    .is_ok_and(|needed| needed <= bits),
                _ => true,
            };
            assert_eq!(interpolator.error() == Refusal::None, is_served, "{bits}: {command:?}");
        }
    }
}

#[test]
fn what_no_register_can_hold_is_refused_with_its_reason() {
    let refusal = |command: Command<3>| {
        let mut interpolator = Interpolator::<3>::new(8).unwrap();
        interpolator.clock(&Inputs { command: Some(command), ..Inputs::default() });
        for _ in 0..100 {
            interpolator.clock(&Inputs::default());
            assert!(interpolator.pulses().is_none());
        }
        interpolator.error()
    };
    let line = Command::dda_line([3, 4, 5], Preset::Half, false, 1000);
    let arc = Command::dda_centred_arc([5, 0], [0, 5], Direction::Ccw, false, 1000);
    assert_eq!(refusal(Command { curve: 6, ..line }), Refusal::Curve);
    assert_eq!(refusal(Command { curve: 7, ..line }), Refusal::Curve);
    assert_eq!(refusal(Command { preset: 3, ..line }), Refusal::Preset);
    assert_eq!(refusal(Command { end: [3, -256, 5], ..line }), Refusal::Coordinate);
    assert_eq!(refusal(Command { start: [-256, 1], ..arc }), Refusal::Coordinate);
    assert_eq!(refusal(Command { end: [0, 5, 1], ..arc }), Refusal::Coordinate);
    assert_eq!(refusal(Command::ppc_line([3, 4, 1], 1000)), Refusal::Coordinate);
    assert_eq!(refusal(Command { start: [0, 0], ..arc }), Refusal::Centre);
    assert_eq!(refusal(Command { end: [0, 0, 0], ..arc }), Refusal::Centre);
    assert_eq!(refusal(Command { start: [128, 0], ..arc }), Refusal::TooLarge);
    assert_eq!(refusal(Command { period: 5, ..line }), Refusal::Period);
    assert!(Interpolator::<2>::new(1).is_err() && Interpolator::<2>::new(33).is_err());
}

#[test]
fn decoding_takes_no_longer_than_promised() {
    let clocks = |command: Command<2>, bits| {
        let mut interpolator = Interpolator::<2>::new(bits).unwrap();
        interpolator.clock(&Inputs { command: Some(command), ..Inputs::default() });
        let mut clocks = 1;
        while !interpolator.ready() {
            interpolator.clock(&Inputs::default());
            clocks += 1;
        }
        clocks
    };
    for bits in 3..=31 {
        // The smallest circle is shifted most.
        let circle = Command::dda_centred_arc([1, 0], [1, 0], Direction::Ccw, true, 6);
        assert_eq!(clocks(circle, bits), 4 * bits + 13);
        let line = Command::dda_line([1, 0], Preset::Zero, true, 6);
        assert_eq!(clocks(line, bits), bits + 5);
        assert_eq!(clocks(Command::ppc_line([1, 0], 6), bits), 5);
    }
}

#[test]
fn a_refused_command_stops_those_behind_it_until_it_was_seen() {
    let line = Command::ppc_line([3, 2], 8);
    let wrong = Command { curve: 7, ..line };
    let mut interpolator = Interpolator::<2>::new(8).unwrap();
    let mut give = |command, clear, clocks| {
        let mut sent = 0;
        for _ in 0..clocks {
            interpolator.clock(&Inputs { command, clear, ..Inputs::default() });
            sent += u32::from(!interpolator.pulses().is_none());
        }
        (sent, interpolator.error())
    };
    // The line before it is carried out.
    assert_eq!(give(Some(line), false, 1).1, Refusal::None);
    assert_eq!(give(Some(wrong), false, 100), (5, Refusal::Curve));
    assert_eq!(give(Some(line), false, 100), (0, Refusal::Curve));
    assert_eq!(give(None, true, 1), (0, Refusal::None));
    assert_eq!(give(None, false, 100), (0, Refusal::None));
    assert_eq!(give(Some(line), false, 1).0 + give(None, false, 100).0, 5);
}

#[test]
fn curves_follow_each_other_without_a_gap() {
    for period in [6, 7, 50] {
        let commands = [[9, 4], [-3, 8], [1, 0], [0, 1], [-7, -7], [30, 1]]
            .map(|end| Command::<2>::ppc_line(end, period));
        let timing = Timing { length: 2, space: 2, setup: 1, hold: 1 };
        let host = Host::new(16, timing, &commands).run();
        assert_eq!(host.at.len(), 71);
        let gaps: Vec<_> = host.at.windows(2).map(|at| at[1] - at[0]).collect();
        assert_eq!(gaps, vec![u64::from(period); 70]);
    }
}

#[test]
fn a_slow_drive_makes_the_source_wait() {
    let timing = Timing { length: 40, space: 40, setup: 10, hold: 10 };
    let commands = [Command::<2>::ppc_line([5, 0], 6), Command::ppc_line([-5, 0], 6)];
    let host = Host::new(8, timing, &commands).run();
    assert_eq!(host.stepped[0], [[false; 5], [true; 5]].concat());
    assert!(host.clock > 9 * 80 + 40);
}
