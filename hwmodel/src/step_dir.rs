//! The output stage of one axis: pulses become the step and direction signals of a drive.

use crate::probe::{Kind, Probe};
use crate::word::mask;
use onepulse_core::Error;

/// The times a drive asks for, in clocks; 0 acts as 1.
///
/// They may change at any time: a phase takes the setting of the clock whose edge begins it. Of a
/// setting, the stage's timers keep their low bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Timing {
    /// How long step is high.
    pub length: u32,
    /// How long step is low, at least.
    pub space: u32,
    /// How long the direction stands before step rises, at least.
    pub setup: u32,
    /// How long the direction stands after the last step has fallen, at least.
    pub hold: u32,
}

/// A slot for one pulse, the step and direction flip-flops, and two timers.
///
/// ```text
///           ├─length──┼──────space─────────┤
///           ┌─────────┐                    ┌────
///  step ────┘         └────────────────────┘
///       ────────────────────────╥───────────────
///  dir  ────────────────────────╨───────────────
///                     ├──hold───┼──setup───┤
/// ```
///
/// The slot is free again as soon as step rises: pulses in one direction can come every
/// length + space clocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepDir {
    registers: Registers,
    bits: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
struct Registers {
    step: bool,
    /// Set for negative.
    dir: bool,
    /// The slot: a pulse waits.
    pending: bool,
    /// Its direction.
    want: bool,
    /// The direction has changed for the pulse in the slot.
    turned: bool,
    /// Clocks left of length or space.
    timer: u64,
    /// Clocks left of setup, once turned, or else of hold.
    guard: u64,
}

/// What the next clock edge begins.
struct Wires {
    rises: bool,
    falls: bool,
    turns: bool,
}

impl StepDir {
    /// The widest timers.
    const WIDEST: u32 = u32::BITS;

    /// The stage as a reset leaves it, with timers of so many bits.
    ///
    /// # Errors
    /// [`Error::RegisterWidth`] unless the timers have 1 to 32 bits.
    pub fn new(timer_bits: u32) -> Result<Self, Error> {
        if (1..=Self::WIDEST).contains(&timer_bits) {
            Ok(Self { registers: Registers::default(), bits: timer_bits })
        } else {
            Err(Error::RegisterWidth { digits: timer_bits, widest: Self::WIDEST })
        }
    }

    /// A clock edge with reset: step and direction go back at once, whatever the times.
    pub fn reset(&mut self) {
        self.registers = Registers::default();
    }

    /// The ready wire: the slot is empty, and takes the pulse of this clock.
    #[must_use]
    pub const fn ready(&self) -> bool {
        !self.registers.pending
    }

    /// The step flip-flop.
    #[must_use]
    pub const fn step(&self) -> bool {
        self.registers.step
    }

    /// The direction flip-flop: set for negative.
    #[must_use]
    pub const fn dir(&self) -> bool {
        self.registers.dir
    }

    /// The idle wire: no pulse waits, and step is low.
    #[must_use]
    pub const fn is_idle(&self) -> bool {
        !self.registers.pending && !self.registers.step
    }

    fn wires(&self) -> Wires {
        let Registers { step, dir, pending, want, turned, timer, guard } = self.registers;
        let waits = pending && !step;
        Wires {
            rises: waits && dir == want && timer == 0 && (!turned || guard == 0),
            falls: step && timer == 0,
            turns: waits && dir != want && guard == 0,
        }
    }

    fn next(&self, wires: &Wires, timing: &Timing, pulse: i8) -> Registers {
        let q = &self.registers;
        let &Wires { rises, falls, turns } = wires;
        let setting = |clocks: u32| u64::from(clocks) & mask(self.bits);
        let (phase, phase_guard) = if q.step {
            (setting(timing.space), setting(timing.hold))
        } else {
            (setting(timing.length), setting(timing.setup))
        };
        let is_taken = self.ready() && pulse != 0;
        Registers {
            step: if rises || falls { rises } else { q.step },
            dir: if turns { q.want } else { q.dir },
            pending: is_taken || q.pending && !rises,
            want: if is_taken { pulse < 0 } else { q.want },
            turned: if rises || turns { turns } else { q.turned },
            timer: (if rises || falls { phase } else { q.timer }).saturating_sub(1),
            guard: (if turns || falls { phase_guard } else { q.guard }).saturating_sub(1),
        }
    }

    /// A clock edge, with the settings of the clock that it ends and its pulse: −1, 0 or +1. A
    /// pulse is lost unless the stage is [`ready`](Self::ready).
    #[inline]
    pub fn clock(&mut self, timing: &Timing, pulse: i8) {
        self.registers = self.next(&self.wires(), timing, pulse);
    }

    /// Shows every register, as signals of this axis.
    pub fn probe(&self, axis: usize, probe: &mut impl Probe) {
        let Registers { step, dir, pending, want, turned, timer, guard } = self.registers;
        probe.axis_signal("step_", axis, Kind::Bit, u64::from(step));
        probe.axis_signal("dir_", axis, Kind::Bit, u64::from(dir));
        probe.axis_signal("pending_", axis, Kind::Bit, u64::from(pending));
        probe.axis_signal("want_", axis, Kind::Bit, u64::from(want));
        probe.axis_signal("turned_", axis, Kind::Bit, u64::from(turned));
        probe.axis_signal("timer_", axis, Kind::Unsigned(self.bits), timer);
        probe.axis_signal("guard_", axis, Kind::Unsigned(self.bits), guard);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use fastrand::Rng;

    /// What an oscilloscope on the drive's inputs would have recorded.
    struct Scope {
        bits: u32,
        step: Vec<bool>,
        dir: Vec<bool>,
        timing: Vec<Timing>,
        taken: Vec<bool>,
    }

    impl Scope {
        fn new(bits: u32) -> Self {
            Self { bits, step: vec![], dir: vec![], timing: vec![], taken: vec![] }
        }

        fn clock(&mut self, stage: &mut StepDir, timing: Timing, pulse: i8) {
            self.step.push(stage.step());
            self.dir.push(stage.dir());
            self.timing.push(timing);
            if stage.ready() && pulse != 0 {
                self.taken.push(pulse < 0);
            }
            stage.clock(&timing, pulse);
        }

        /// The clocks in which step has just risen or fallen, or dir changed.
        fn edges(signal: &[bool]) -> impl Iterator<Item = usize> {
            (1..signal.len()).filter(|&t| signal[t] != signal[t - 1])
        }

        fn rises(&self) -> Vec<usize> {
            Self::edges(&self.step).filter(|&t| self.step[t]).collect()
        }

        /// All times are kept, and all pulses have come out, in order and in their directions.
        fn check(&self) {
            let asked = |edge: usize, setting: fn(&Timing) -> u32| {
                let clocks = setting(&self.timing[edge - 1]);
                (u64::from(clocks) & mask(self.bits)).max(1) as usize
            };
            let steps: Vec<_> = Self::edges(&self.step).collect();
            for pair in steps.windows(2) {
                let (begun, lasts) = (pair[0], pair[1] - pair[0]);
                if self.step[begun] {
                    assert_eq!(lasts, asked(begun, |t| t.length), "length at {begun}");
                } else {
                    assert!(lasts >= asked(begun, |t| t.space), "space at {begun}");
                }
            }
            for turn in Self::edges(&self.dir) {
                assert!(!self.step[turn - 1] && !self.step[turn], "dir turns in a step, at {turn}");
                if let Some(&fall) = steps.iter().rfind(|&&edge| edge <= turn) {
                    assert!(turn - fall >= asked(fall, |t| t.hold), "hold at {turn}");
                }
                if let Some(&rise) = steps.iter().find(|&&edge| edge >= turn) {
                    assert!(rise - turn >= asked(turn, |t| t.setup), "setup at {turn}");
                }
            }
            let made: Vec<_> = self.rises().iter().map(|&rise| self.dir[rise]).collect();
            assert_eq!(made, self.taken);
        }
    }

    fn random_timing(random: &mut Rng, bits: u32) -> Timing {
        let largest = [1, 4, 20, 1 << bits][random.usize(..4)];
        let mut clocks = || random.u32(..=largest);
        Timing { length: clocks(), space: clocks(), setup: clocks(), hold: clocks() }
    }

    #[test]
    fn all_times_are_kept_and_nothing_is_lost() {
        let mut steps = 0;
        for seed in 0..400 {
            let mut random = Rng::with_seed(seed);
            let bits = random.u32(1..=8);
            let mut stage = StepDir::new(bits).unwrap();
            let mut scope = Scope::new(bits);
            let mut timing = random_timing(&mut random, bits);
            let (busy, turning, changing) = (random.f32(), random.f32(), random.f32());
            for _ in 0..2000 {
                if random.f32() < 0.2 * changing {
                    timing = random_timing(&mut random, bits);
                }
                let pulse = match (random.f32() < busy, random.f32() < turning) {
                    (false, _) => 0,
                    (true, false) => 1,
                    (true, true) => -1,
                };
                scope.clock(&mut stage, timing, pulse);
            }
            while !stage.is_idle() {
                scope.clock(&mut stage, timing, 0);
            }
            scope.check();
            steps += scope.taken.len();
        }
        assert!(steps > 20_000, "only {steps} steps");
    }

    /// The clocks between the ten steps of a source that never waits; equal ones once.
    fn periods(timing: Timing, next: impl Fn(usize) -> i8) -> Vec<usize> {
        let mut stage = StepDir::new(16).unwrap();
        let mut scope = Scope::new(16);
        for _ in 0..4000 {
            let taken = scope.taken.len();
            scope.clock(&mut stage, timing, if taken < 10 { next(taken) } else { 0 });
        }
        assert!(scope.taken.len() == 10 && stage.is_idle());
        scope.check();
        let mut periods: Vec<_> = scope.rises().windows(2).map(|r| r[1] - r[0]).collect();
        periods.dedup();
        periods
    }

    #[test]
    fn steps_come_as_fast_as_the_times_allow() {
        let mut random = Rng::with_seed(1);
        for _ in 0..200 {
            let timing = random_timing(&mut random, 6);
            let [length, space, setup, hold] =
                [timing.length, timing.space, timing.setup, timing.hold].map(|t| t.max(1) as usize);
            assert_eq!(periods(timing, |_| 1), [length + space]);
            let to_and_fro = |taken: usize| if taken % 2 == 0 { 1 } else { -1 };
            assert_eq!(periods(timing, to_and_fro), [length + space.max(hold + setup)]);
        }
    }

    #[test]
    fn timers_of_1_to_32_bits_are_offered() {
        let refused = |digits| Err(Error::RegisterWidth { digits, widest: 32 });
        assert_eq!(StepDir::new(0), refused(0));
        assert_eq!(StepDir::new(33), refused(33));

        // The widest and the narrowest setting that there is.
        let timing = Timing { length: u32::MAX, ..Timing::default() };
        let mut wide = StepDir::new(32).unwrap();
        let mut narrow = StepDir::new(1).unwrap();
        for pulse in [1, 0] {
            wide.clock(&timing, pulse);
            narrow.clock(&timing, pulse);
        }
        assert_eq!(wide.registers.timer, u64::from(u32::MAX - 1));
        assert_eq!(narrow.registers.timer, 0);
        assert!(wide.step() && narrow.step());
    }
}
