//! The whole interpolator: commands in, step and direction signals out.

mod command;
mod decoder;
mod engines;
mod source;

pub use command::{Command, Curve, Refusal};

use crate::probe::{Kind, Probe};
use crate::{Fifo, StepDir, Timing};
use decoder::{Contents, Decoder};
use engines::Engines;
use onepulse_core::dda::{Radix, Register};
use onepulse_core::{Error, Pulse};
use source::PulseSource;

/// Decoder, queue, pulse source, engines, and an output stage an axis, as one circuit.
///
/// ```text
///  command ─▶ decoder ─▶ queue ─▶ engine ─▶ step and direction, one an axis
///                                   ▲
///                              pulse source
/// ```
///
/// Commands come by a ready/valid handshake, are checked and turned into first register contents,
/// and wait in the queue as such: so one curve follows the other without a gap, as long as the queue
/// does not run empty. A command that cannot be done is refused with its reason, before it moves
/// anything; those before it are carried out, and no other is taken until the reason was seen.
///
/// One engine runs at a time. Every period (of its command) the pulse source begins a cycle, but not
/// while an output stage still has a pulse waiting: the stages' times are kept, and no pulse is lost,
/// by making the source wait. From the last cycle of a curve to the first of the next it is one
/// period, too.
///
/// A pulse of an engine is in the pulse register a clock later, and at the step output two clocks
/// after that if nothing holds it up.
///
/// ```
/// use onepulse_core::Direction;
/// use onepulse_hwmodel::Timing;
/// use onepulse_hwmodel::interpolator::{Command, Inputs, Interpolator};
///
/// let mut interpolator = Interpolator::<2>::new(16)?;
/// let timing = Timing { length: 3, space: 3, setup: 5, hold: 5 };
/// let quarter = Command::dda_centred_arc([5, 0], [0, 5], Direction::Ccw, true, 20);
/// let mut command = Some(quarter);
/// let mut rises = [0, 0];
/// while command.is_some() || !interpolator.done() {
///     let inputs = Inputs { command, timing, ..Inputs::default() };
///     if interpolator.ready() {
///         command = None;
///     }
///     let before = interpolator.steps();
///     interpolator.clock(&inputs);
///     for axis in 0..2 {
///         rises[axis] += u32::from(!before[axis] && interpolator.steps()[axis]);
///     }
/// }
/// assert_eq!(rises, [5, 5]);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interpolator<const AXES: usize = 2> {
    decoder: Decoder<AXES>,
    fifo: Fifo<Contents<AXES>>,
    source: PulseSource,
    engines: Engines<AXES>,
    stages: [StepDir; AXES],
    /// A curve is being run, or was until the clock before.
    is_running: bool,
    /// Its code and its period.
    curve: u8,
    period: u32,
    /// The pulse register.
    pulse: Pulse<AXES>,
    bits: u32,
}

/// What stands on an interpolator's ports during a clock.
#[derive(Clone, Copy, Debug, Default)]
pub struct Inputs<const AXES: usize = 2> {
    /// Back to the start; nothing else matters then.
    pub reset: bool,
    /// A command and its valid; it is taken if the interpolator is ready.
    pub command: Option<Command<AXES>>,
    /// The reason of a refusal was seen.
    pub clear: bool,
    /// The drives' times.
    pub timing: Timing,
}

impl<const AXES: usize> Interpolator<AXES> {
    /// The name of the Verilog module.
    pub const NAME: &'static str = "interpolator";

    /// Bits of the output stages' timers.
    pub const TIMER_BITS: u32 = 16;

    /// Bits of a period.
    pub const PERIOD_BITS: u32 = Decoder::<AXES>::PERIOD_BITS;

    /// The interpolator after a reset, with engines of `bits` bits. It has 2 to 4 axes: with any other
    /// number it does not compile.
    ///
    /// # Errors
    /// Fewer than 2 or more than 32 bits.
    pub fn new(bits: u32) -> Result<Self, Error> {
        const { assert!(2 <= AXES && AXES <= 4) };
        Register::new(Radix::Binary, bits)?;
        if bits < 2 {
            return Err(Error::RegisterTooNarrow { digits: bits, needed: 2 });
        }
        Ok(Self {
            decoder: Decoder::reset(bits),
            fifo: Fifo::new(),
            source: PulseSource::reset(),
            engines: Engines::reset(bits),
            stages: [StepDir::new(Self::TIMER_BITS)?; AXES],
            is_running: false,
            curve: 0,
            period: 0,
            pulse: Pulse::NONE,
            bits,
        })
    }

    /// The ready wire: a command is taken in this clock.
    #[must_use]
    pub fn ready(&self) -> bool {
        self.decoder.ready()
    }

    /// Why the last command was refused.
    #[must_use]
    pub const fn error(&self) -> Refusal {
        self.decoder.error()
    }

    /// The done wire: all commands are carried out, to the last step.
    #[must_use]
    pub fn done(&self) -> bool {
        // A curve still counts as running when its last pulse is in the pulse register.
        !self.is_running
            && self.fifo.head().is_none()
            && self.decoder.is_idle()
            && self.stages.iter().all(StepDir::is_idle)
    }

    /// The step outputs.
    #[must_use]
    pub fn steps(&self) -> [bool; AXES] {
        self.stages.map(|stage| stage.step())
    }

    /// The direction outputs, set for negative.
    #[must_use]
    pub fn dirs(&self) -> [bool; AXES] {
        self.stages.map(|stage| stage.dir())
    }

    /// The pulse register: what the engines sent in the clock before.
    #[must_use]
    pub const fn pulses(&self) -> Pulse<AXES> {
        self.pulse
    }

    /// The code of the curve that runs; `None` while none does.
    #[must_use]
    pub fn running(&self) -> Option<u8> {
        self.is_running.then_some(self.curve)
    }

    /// A clock edge.
    pub fn clock(&mut self, inputs: &Inputs<AXES>) {
        if inputs.reset {
            self.reset();
            return;
        }
        // The wires, from the registers as they are.
        let is_ready = self.is_running && self.stages.iter().all(StepDir::ready);
        let tick = self.source.tick(is_ready);
        let started = self.fifo.head().filter(|_| !self.is_running);
        let decoded = self.decoder.decoded();
        let has_room = self.fifo.ready();
        let is_done = self.engines.done(self.curve);

        // The edge.
        for (stage, pulse) in self.stages.iter_mut().zip(self.pulse.0) {
            stage.clock(&inputs.timing, pulse);
        }
        self.pulse = self.engines.clock(self.curve, tick);
        self.source.clock(tick, self.period, Self::PERIOD_BITS);
        self.decoder.clock(inputs.command.as_ref(), inputs.clear, has_room);
        self.fifo.clock(decoded, started.is_some());
        if let Some(contents) = started {
            self.engines.load(&contents, self.bits);
            self.curve = contents.curve;
            self.period = contents.period;
            self.is_running = true;
        } else if is_done {
            self.is_running = false;
        }
    }

    fn reset(&mut self) {
        self.decoder = Decoder::reset(self.bits);
        self.fifo.reset();
        self.source = PulseSource::reset();
        self.engines = Engines::reset(self.bits);
        self.stages.iter_mut().for_each(StepDir::reset);
        self.is_running = false;
        self.curve = 0;
        self.period = 0;
        self.pulse = Pulse::NONE;
    }

    /// Shows every register and every wire worth seeing, in one fixed order, part by part.
    pub fn probe(&self, probe: &mut impl Probe) {
        probe.scope(Self::NAME);
        probe.signal("ready", Kind::Bit, u64::from(self.ready()));
        probe.signal("error", Kind::Word(Refusal::WORDS), self.error() as u64);
        probe.signal("done", Kind::Bit, u64::from(self.done()));
        probe.signal("running", Kind::Bit, u64::from(self.is_running));
        probe.signal("curve", Kind::Unsigned(3), u64::from(self.curve));
        probe.signal("period", Kind::Unsigned(Self::PERIOD_BITS), u64::from(self.period));
        for axis in 0..AXES {
            probe.axis_signal("pulse_", axis, Kind::Bit, u64::from(self.pulse.0[axis] != 0));
        }
        for axis in 0..AXES {
            probe.axis_signal("negative_", axis, Kind::Bit, u64::from(self.pulse.0[axis] < 0));
        }
        self.source.probe(Self::PERIOD_BITS, probe);
        for (axis, stage) in self.stages.iter().enumerate() {
            stage.probe(axis, probe);
        }
        self.fifo.probe(probe);
        probe.scope("decoder");
        self.decoder.probe(probe);
        self.engines.probe(probe);
    }
}
