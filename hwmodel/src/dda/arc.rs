//! The textbook's circuit of an arc by digital integration.

use crate::probe::{Kind, Probe};
use crate::word::{mask, signed};
use crate::{Circuit, Sweep};
use onepulse_core::dda::{self, Preset, Radix, Register};
use onepulse_core::{Direction, Error, Pulse};

/// Two crossed integrators: JVx follows |y|, JVy follows |x|, and each pulse corrects the
/// integrand that follows its axis. Two clocks a cycle, with the sum registers between them, so
/// that a carry does not have to run through two adders in one clock.
///
/// ```text
///         ┌─────┐   ┌───────┐  Sx                  ┌─────┐   ┌───────┐  Sy
///    ┌───▶│ JVx ├──▶│ + JRx ├───────▶ Δx ──┐  ┌───▶│ JVy ├──▶│ + JRy ├───────▶ Δy ──┐
///    │    └─────┘   └───────┘   carry      │  │    └─────┘   └───────┘   carry      │
///    │    ±2^Q                             └──┘    ±2^Q                             │
///    └──────────────────────────────────────────────────────────────────────────────┘
///
///  add       Sx ← JRx + JVx, Sy ← JRy + JVy, n + 1 bits each
///  correct   JRx, JRy take the sums; their carries are the pulses, which the integrands and
///            the end counters take
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arc {
    registers: Registers,
    /// What a pulse corrects its integrand by, 2^Q; loaded once.
    unit: u64,
    bits: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Registers {
    beat: Beat,
    /// Of the x axis and of the y axis.
    integrators: [Integrator; 2],
    sweep: Sweep,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Integrator {
    /// Integrand, n bits: |y|·2^Q in that of x, |x|·2^Q in that of y.
    jv: u64,
    /// Remainder, n bits.
    jr: u64,
    /// Sum, n + 1 bits.
    sum: u64,
}

/// The beats of a cycle, a clock each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Beat {
    Add,
    Correct,
}

impl Arc {
    /// The circuit, loaded with the arc from `start` to `end`, in registers of `bits` bits.
    ///
    /// # Errors
    /// As [`onepulse_core::dda::Arc::new`] with a binary register.
    pub fn new(
        start: [i32; 2],
        end: [i32; 2],
        direction: Direction,
        bits: u32,
        preset: Preset,
        normalize: bool,
    ) -> Result<Self, Error> {
        let register = Register::new(Radix::Binary, bits)?;
        let software = dda::Arc::new(start, end, direction, register, preset, normalize)?;
        let shift = software.shift();
        let load = |c: i32| (u64::from(c.unsigned_abs()) << shift) & mask(bits);
        let jv = [load(start[1]), load(start[0])];
        let preset = match preset {
            Preset::Zero => 0,
            Preset::Half => 1 << (bits - 1),
            Preset::Full => mask(bits),
        };
        Ok(Self::loaded(jv, preset, 1 << shift, Sweep::new(start, end, direction, bits)?, bits))
    }

    /// The circuit after a load of these contents.
    pub(crate) const fn loaded(
        jv: [u64; 2],
        preset: u64,
        unit: u64,
        sweep: Sweep,
        bits: u32,
    ) -> Self {
        let [jvx, jvy] = jv;
        let x = Integrator { jv: jvx, jr: preset, sum: 0 };
        let integrators = [x, Integrator { jv: jvy, ..x }];
        let registers = Registers { beat: Beat::Add, integrators, sweep };
        Self { registers, unit, bits }
    }

    /// The circuit in this state at the start of a cycle, reachable or not.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(
        [jvx, jvy]: [u64; 2],
        [jrx, jry]: [u64; 2],
        [sx, sy]: [u64; 2],
        unit: u64,
        sweep: Sweep,
        bits: u32,
    ) -> Self {
        let x = Integrator { jv: jvx, jr: jrx, sum: sx };
        let y = Integrator { jv: jvy, jr: jry, sum: sy };
        Self { registers: Registers { beat: Beat::Add, integrators: [x, y], sweep }, unit, bits }
    }

    /// Whether every register agrees with that of another circuit, but for the sums and what the
    /// sweep control last looked at: each cycle begins by writing them.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub fn agrees_with(&self, other: &Self) -> bool {
        let (q, r) = (&self.registers, &other.registers);
        let mut agrees = q.beat == r.beat && self.unit == other.unit && self.bits == other.bits;
        for axis in 0..2 {
            agrees &= q.integrators[axis].jv == r.integrators[axis].jv;
            agrees &= q.integrators[axis].jr == r.integrators[axis].jr;
        }
        agrees && q.sweep.agrees_before_look(&r.sweep)
    }

    /// The circuit after a reset.
    pub(crate) fn reset(bits: u32) -> Self {
        Self::loaded([0; 2], 0, 0, Sweep::reset(bits), bits)
    }

    /// Whether each axis is sent a pulse in this clock.
    #[inline(always)]
    const fn pulse(&self) -> [bool; 2] {
        let q = &self.registers;
        let is_correct = matches!(q.beat, Beat::Correct);
        let ([x, y], [x_stands, y_stands]) = (q.sweep.at_end(), q.sweep.stands());
        if q.sweep.is_stepping_out() {
            return [is_correct & !x, is_correct & !y];
        }
        let [x, y] = q.integrators;
        let (x_carries, y_carries) = (x.sum >> self.bits == 1, y.sum >> self.bits == 1);
        [is_correct & x_carries & !x_stands, is_correct & y_carries & !y_stands]
    }

    /// The clock edge. No beat writes what another of its registers is made of, so they can be
    /// written one by one.
    #[inline(always)]
    fn edge(&mut self, pulse: [bool; 2]) {
        let q = &mut self.registers;
        match q.beat {
            Beat::Add => {
                if !q.sweep.done() {
                    q.beat = Beat::Correct;
                }
                for integrator in &mut q.integrators {
                    integrator.sum = integrator.jr + integrator.jv;
                }
                // A coordinate is zero when the integrand that follows it is.
                let [x, y] = q.integrators;
                q.sweep.look([y.jv == 0, x.jv == 0]);
            }
            Beat::Correct => {
                q.beat = Beat::Add;
                for axis in 0..2 {
                    if !q.sweep.is_stepping_out() && !q.sweep.stands()[axis] {
                        let integrator = &mut q.integrators[axis];
                        integrator.jr = integrator.sum & mask(self.bits);
                    }
                    // A pulse of x moves |x|, which JVy holds, and the other way round.
                    let unit = self.unit as i64 * i64::from(pulse[axis]);
                    let jv = &mut q.integrators[1 - axis].jv;
                    *jv = jv.wrapping_add_signed(signed(unit, q.sweep.shrinks(axis)));
                    *jv &= mask(self.bits);
                    q.sweep.count(axis, pulse[axis], q.sweep.is_negative(axis));
                }
            }
        }
    }

    /// The pulses with the sweep's directions.
    #[inline(always)]
    fn directed(&self, pulse: [bool; 2]) -> Pulse {
        let sweep = &self.registers.sweep;
        let directed = |axis: usize| signed(i64::from(pulse[axis]), sweep.is_negative(axis)) as i8;
        Pulse([directed(0), directed(1)])
    }
}

impl Circuit for Arc {
    const CLOCKS_PER_CYCLE: u64 = 2;
    const NAME: &'static str = "dda_arc";

    #[inline]
    fn pulses(&self) -> Pulse {
        self.directed(self.pulse())
    }

    #[inline]
    fn done(&self) -> bool {
        self.registers.beat == Beat::Add && self.registers.sweep.done()
    }

    #[inline]
    fn is_mid_cycle(&self) -> bool {
        self.registers.beat != Beat::Add
    }

    // So that a loop of clocks keeps in the processor's registers what it can.
    #[inline(always)]
    fn clock(&mut self) -> Pulse {
        let pulse = self.pulse();
        let pulses = self.directed(pulse);
        self.edge(pulse);
        pulses
    }

    fn probe(&self, probe: &mut impl Probe) {
        const WORDS: &[&str] = &["ADD", "CORRECT"];
        let q = &self.registers;
        probe.signal("beat", Kind::Word(WORDS), q.beat as u64);
        probe.signal("unit", Kind::Unsigned(self.bits), self.unit);
        for axis in 0..2 {
            let Integrator { jv, jr, .. } = q.integrators[axis];
            probe.axis_signal("jv", axis, Kind::Unsigned(self.bits), jv);
            probe.axis_signal("jr", axis, Kind::Ramp(self.bits), jr);
        }
        for axis in 0..2 {
            let sum = q.integrators[axis].sum;
            probe.axis_signal("sum", axis, Kind::Unsigned(self.bits + 1), sum);
        }
        q.sweep.probe(probe);
    }
}
