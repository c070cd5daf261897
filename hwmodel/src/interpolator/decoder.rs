//! Turns a command into the first contents of an engine's registers, or refuses it.

use super::command::{Command, Curve, Refusal};
use crate::probe::{Kind, Probe};
use crate::word::{mask, wrap};

/// The decoder's registers and the beats of its work.
///
/// A command is what the software gives: end points in pulses, signed. The engines want
/// magnitudes, quadrants, shifts. That takes some clocks, and one adder at a time:
///
/// ```text
///  idle       takes a command
///  magnitude  |start|, |end|; end counters ← end − start
///  check      what can be refused at once is; quadrants, crossings
///  square     R² = x² + y², a bit of each in two clocks, from the lowest; with it the sign of the
///             vector product of start and end, which tells a full turn from none when both lie in
///             one quadrant
///  turn       four crossings if the end does not lie ahead
///  root       R, a bit a clock
///  round      R, rounded up
///  end_x, _y  the largest coordinate: that of the circle or of the end point
///  grow       what the textbook's arc grows by when it crosses an axis
///  fits       refused if the registers do not hold it
///  shift      left-shift normalization, a bit a clock
///  finish     presets, signs
///  put        into the queue
/// ```
///
/// From the clock that takes it, an arc needs up to 4n + 13 clocks, a DDA line n + 5, any other 5.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Decoder<const AXES: usize> {
    registers: Registers<AXES>,
    bits: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Registers<const AXES: usize> {
    state: State,
    error: Refusal,
    /// What goes into the queue.
    contents: Contents<AXES>,
    preset: u8,
    normalize: bool,
    /// The coordinates as the command has them, then their magnitudes.
    start: [u64; 2],
    end: [u64; AXES],
    start_negative: [bool; 2],
    count: u32,
    /// Bits of |x| and |y| that are still to be multiplied.
    bits: [u64; 2],
    /// The square: what is summed up, w + 1 bits, moves down into the lower half, w bits.
    high: u64,
    low: u64,
    /// The vector product of the magnitudes of start and end, w + 2 bits, signed; what moves out below
    /// it leaves a trace.
    turn: i64,
    turn_rest: bool,
    /// R, then the largest coordinate.
    root: u64,
    /// What the root leaves of the square.
    rest: u64,
}

/// First register contents: what an engine is loaded with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Contents<const AXES: usize> {
    /// The code of the curve.
    pub(super) curve: u8,
    pub(super) period: u32,
    /// Integrands, values, magnitudes of the end point, or coordinates.
    pub(super) first: First<AXES>,
    pub(super) jr: [u64; 2],
    pub(super) unit: u64,
    /// Accumulations of a DDA line.
    pub(super) accumulations: u64,
    pub(super) quadrant: u8,
    pub(super) crossings: u8,
    pub(super) cw: bool,
    pub(super) je: [i64; 2],
}

/// A register and a sign flip-flop an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct First<const AXES: usize> {
    pub(super) content: [u64; AXES],
    pub(super) negative: [bool; AXES],
}

impl<const AXES: usize> Default for First<AXES> {
    fn default() -> Self {
        Self { content: [0; AXES], negative: [false; AXES] }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Idle,
    Magnitude,
    Check,
    Square,
    Turn,
    Root,
    Round,
    EndX,
    EndY,
    Grow,
    Fits,
    Shift,
    Finish,
    Put,
}

impl State {
    const WORDS: &[&str] = &[
        "IDLE",
        "MAGNITUDE",
        "CHECK",
        "SQUARE",
        "TURN",
        "ROOT",
        "ROUND",
        "END_X",
        "END_Y",
        "GROW",
        "FITS",
        "SHIFT",
        "FINISH",
        "PUT",
    ];
}

/// How far the textbook's circle may grow, see [`onepulse_core::dda::Arc::bits`].
const GROWTH: u64 = 5;

/// The shortest period: a cycle of every engine and the change to the next curve fit into it.
const SHORTEST: u32 = 6;

impl<const AXES: usize> Decoder<AXES> {
    /// Bits of a period.
    pub(super) const PERIOD_BITS: u32 = 24;

    /// The decoder after a reset, for engines of `bits` bits.
    pub(super) fn reset(bits: u32) -> Self {
        let registers = Registers {
            state: State::Idle,
            error: Refusal::None,
            contents: Contents::default(),
            preset: 0,
            normalize: false,
            start: [0; 2],
            end: [0; AXES],
            start_negative: [false; 2],
            count: 0,
            bits: [0; 2],
            high: 0,
            low: 0,
            turn: 0,
            turn_rest: false,
            root: 0,
            rest: 0,
        };
        Self { registers, bits }
    }

    /// Bits of a coordinate: those of a register and the sign, but no more than a 32-bit processor
    /// has.
    const fn width(&self) -> u32 {
        if self.bits < 32 { self.bits + 1 } else { 32 }
    }

    /// The ready wire: a command is taken.
    pub(super) fn ready(&self) -> bool {
        self.is_idle() && self.error() == Refusal::None
    }

    pub(super) fn is_idle(&self) -> bool {
        self.registers.state == State::Idle
    }

    pub(super) const fn error(&self) -> Refusal {
        self.registers.error
    }

    /// A decoded command for the queue, if there is one.
    pub(super) fn decoded(&self) -> Option<Contents<AXES>> {
        (self.registers.state == State::Put).then_some(self.registers.contents)
    }

    /// A clock edge: a command on the ports, whether an error was seen, whether the queue is ready.
    pub(super) fn clock(&mut self, command: Option<&Command<AXES>>, clear: bool, is_ready: bool) {
        // Nothing to do, in most clocks.
        if self.registers.state == State::Idle && command.is_none() && !clear {
            return;
        }
        self.registers = self.next(command, clear, is_ready);
    }

    fn next(
        &self,
        command: Option<&Command<AXES>>,
        clear: bool,
        is_ready: bool,
    ) -> Registers<AXES> {
        let q = &self.registers;
        let mut next = *q;
        if clear {
            next.error = Refusal::None;
        }
        match q.state {
            State::Idle => {
                if let Some(command) = command.filter(|_| self.ready()) {
                    next.state = State::Magnitude;
                    self.take(&mut next, command);
                }
            }
            State::Magnitude => {
                next.state = State::Check;
                self.magnitudes(&mut next);
            }
            State::Check => {
                next.error = self.refusal();
                next.state = match self.curve() {
                    _ if next.error != Refusal::None => State::Idle,
                    Some(Curve::DdaArc | Curve::DdaCentredArc | Curve::PpcArc) => State::Square,
                    Some(Curve::DdaLine) => State::Shift,
                    _ => State::Finish,
                };
                self.begin(&mut next);
            }
            State::Square => {
                self.square(&mut next);
                if q.count == 2 * self.width() - 1 {
                    next.state = State::Turn;
                }
            }
            State::Turn => {
                next.state = State::Root;
                next.count = 0;
                if q.contents.crossings == 0 && !self.is_ahead() {
                    next.contents.crossings = 4;
                }
            }
            State::Root => {
                self.root(&mut next);
                if q.count == self.width() - 1 {
                    next.state = State::Round;
                }
            }
            State::Round => {
                next.state = State::EndX;
                next.root += u64::from(q.rest != 0);
            }
            State::EndX => {
                next.state = State::EndY;
                next.root = q.root.max(q.end[0]);
            }
            State::EndY => {
                next.state = State::Grow;
                next.root = q.root.max(q.end[1]);
            }
            State::Grow => {
                if q.root >> (self.width() - 1) != 0 {
                    next.state = State::Idle;
                    next.error = Refusal::TooLarge;
                } else {
                    next.state = State::Fits;
                }
                if self.curve() == Some(Curve::DdaArc) && q.contents.crossings != 0 {
                    next.root += GROWTH;
                }
            }
            State::Fits => {
                // A bit of headroom.
                let bits = match self.curve() {
                    Some(Curve::DdaCentredArc) => self.bits - 1,
                    _ => self.bits,
                };
                next.state = match self.curve() {
                    _ if q.root >> bits != 0 => State::Idle,
                    Some(Curve::PpcArc) => State::Finish,
                    _ => State::Shift,
                };
                if q.root >> bits != 0 {
                    next.error = Refusal::TooLarge;
                }
            }
            State::Shift => {
                if q.normalize && self.has_room() {
                    let content = &mut next.contents.first.content;
                    *content = content.map(|first| first << 1 & mask(self.bits));
                    next.contents.unit = q.contents.unit << 1 & mask(self.bits);
                    next.contents.accumulations >>= 1;
                    next.root = q.root << 1 & mask(self.bits + 2);
                } else {
                    next.state = State::Finish;
                }
            }
            State::Finish => {
                next.state = State::Put;
                self.finish(&mut next);
            }
            State::Put => {
                if is_ready {
                    next.state = State::Idle;
                }
            }
        }
        next
    }

    const fn curve(&self) -> Option<Curve> {
        Curve::from_code(self.registers.contents.curve)
    }

    const fn is_arc(&self) -> bool {
        matches!(self.curve(), Some(Curve::DdaArc | Curve::DdaCentredArc | Curve::PpcArc))
    }

    fn take(&self, next: &mut Registers<AXES>, command: &Command<AXES>) {
        let port = |c: i64| c as u64 & mask(self.width());
        next.contents.curve = command.curve & 7;
        next.contents.period = command.period & mask(Self::PERIOD_BITS) as u32;
        next.contents.cw = command.cw;
        next.preset = command.preset & 3;
        next.normalize = command.normalize;
        next.start = command.start.map(port);
        next.end = command.end.map(port);
    }

    fn magnitudes(&self, next: &mut Registers<AXES>) {
        let q = &self.registers;
        let signed = |c: u64| wrap(c as i64, self.width());
        let magnitude = |c: u64| signed(c).unsigned_abs() & mask(self.width());
        for axis in 0..2 {
            let distance = signed(q.end[axis]) - signed(q.start[axis]);
            next.contents.je[axis] = wrap(distance, self.bits + 2);
        }
        next.start_negative = q.start.map(|c| signed(c) < 0);
        next.contents.first.negative = q.end.map(|c| signed(c) < 0);
        next.start = q.start.map(magnitude);
        next.end = q.end.map(magnitude);
    }

    fn refusal(&self) -> Refusal {
        let q = &self.registers;
        // The magnitude of the most negative number has a sign again.
        let is_wide = |c: &u64| c >> (self.width() - 1) != 0;
        let is_arc = self.is_arc();
        let is_flat = is_arc || self.curve() == Some(Curve::PpcLine);
        let has_preset = matches!(self.curve(), Some(Curve::DdaLine | Curve::DdaArc));
        if self.curve().is_none() {
            Refusal::Curve
        } else if has_preset && q.preset == 3 {
            Refusal::Preset
        } else if q.end.iter().any(is_wide)
            || is_flat && q.end.iter().skip(2).any(|c| *c != 0)
            || is_arc && q.start.iter().any(is_wide)
        {
            Refusal::Coordinate
        } else if is_arc && (q.start == [0; 2] || q.end[..2] == [0; 2]) {
            Refusal::Centre
        } else if q.contents.period < SHORTEST {
            Refusal::Period
        } else {
            Refusal::None
        }
    }

    fn begin(&self, next: &mut Registers<AXES>) {
        let q = &self.registers;
        let contents = &mut next.contents;
        let [nx, ny] = q.start_negative;
        let [end_nx, end_ny] = [q.contents.first.negative[0], q.contents.first.negative[1]];
        contents.quadrant = entered(nx, q.start[0] == 0, ny, q.start[1] == 0, contents.cw);
        // The quadrant that is left at the end point is the one that the other sense enters there.
        let last = entered(end_nx, q.end[0] == 0, end_ny, q.end[1] == 0, !contents.cw);
        contents.crossings = if contents.cw {
            contents.quadrant.wrapping_sub(last)
        } else {
            last.wrapping_sub(contents.quadrant)
        } & 3;
        let register = |c: u64| c & mask(self.bits) & mask(self.width() - 1);
        contents.first.content = q.end.map(register);
        let [x, y] = q.start.map(register);
        match self.curve() {
            Some(Curve::DdaArc) => contents.first.content[..2].copy_from_slice(&[y, x]),
            Some(Curve::DdaCentredArc | Curve::PpcArc) => {
                contents.first.content[..2].copy_from_slice(&[x, y]);
            }
            _ => {}
        }
        contents.unit = 1;
        contents.accumulations = 1 << self.bits;
        next.count = 0;
        next.bits = q.start;
        next.high = 0;
        next.low = 0;
        next.turn = 0;
        next.turn_rest = false;
        next.root = 0;
        next.rest = 0;
    }

    /// A bit of x, from the lowest, then the same bit of y; then all moves down a place.
    fn square(&self, next: &mut Registers<AXES>) {
        let q = &self.registers;
        let w = self.width();
        if q.count % 2 == 0 {
            let (factor, crossed) =
                if q.bits[0] & 1 == 1 { (q.start[0], q.end[1]) } else { (0, 0) };
            next.high = (q.high + factor) & mask(w + 1);
            next.turn = wrap(q.turn + crossed as i64, w + 2);
        } else {
            let (factor, crossed) =
                if q.bits[1] & 1 == 1 { (q.start[1], q.end[0]) } else { (0, 0) };
            let high = (q.high + factor) & mask(w + 1);
            let turn = wrap(q.turn - crossed as i64, w + 2);
            next.high = high >> 1;
            next.low = q.low >> 1 | (high & 1) << (w - 1);
            next.turn = turn >> 1;
            next.turn_rest = q.turn_rest || turn & 1 == 1;
            next.bits = q.bits.map(|bits| bits >> 1);
        }
        next.count += 1;
    }

    /// Counter-clockwise the end lies ahead if the vector product is positive; that of the
    /// magnitudes has its sign turned in II and IV.
    const fn is_ahead(&self) -> bool {
        let q = &self.registers;
        let is_turned = (q.contents.quadrant & 1 == 1) != q.contents.cw;
        (q.turn != 0 || q.turn_rest) && (q.turn < 0) == is_turned
    }

    /// The next two bits of the square, and whether they leave enough for a one.
    fn root(&self, next: &mut Registers<AXES>) {
        let q = &self.registers;
        let w = self.width();
        let rest = q.rest << 2 | q.high >> (w - 2) & 3;
        let needed = q.root << 2 | 1;
        let is_one = rest >= needed;
        next.rest = if is_one { rest - needed } else { rest } & mask(self.bits + 2);
        next.root = (q.root << 1 | u64::from(is_one)) & mask(self.bits + 2);
        next.high = (q.high << 2 | q.low >> (w - 2)) & mask(w + 1);
        next.low = q.low << 2 & mask(w);
        next.count += 1;
    }

    /// A line is shifted until a top bit is set, the textbook's arc until its second bit is, both
    /// arcs as long as the largest coordinate fits.
    fn has_room(&self) -> bool {
        let q = &self.registers;
        let some = q.contents.first.content.iter().fold(0, |some, first| some | first);
        match self.curve() {
            Some(Curve::DdaLine) => some != 0 && some >> (self.bits - 1) == 0,
            Some(Curve::DdaArc) => {
                some >> (self.bits - 2) == 0 && q.root >> (self.bits - 1) & 1 == 0
            }
            _ => q.root >> (self.bits - 2) & 1 == 0,
        }
    }

    fn finish(&self, next: &mut Registers<AXES>) {
        let q = &self.registers;
        let half = 1 << (self.bits - 1);
        if self.curve() == Some(Curve::DdaCentredArc) {
            let content = q.contents.first.content;
            let negate = |c: u64, is_negative: bool| {
                if is_negative { c.wrapping_neg() & mask(self.bits) } else { c }
            };
            // Half a step of y ahead.
            let ahead = negate(content[1] / 2, q.start_negative[1] != q.contents.cw);
            next.contents.jr = [(half + ahead) & mask(self.bits), half];
            for axis in 0..2 {
                next.contents.first.content[axis] = negate(content[axis], q.start_negative[axis]);
            }
        } else {
            next.contents.jr = [match q.preset {
                0 => 0,
                1 => half,
                _ => mask(self.bits),
            }; 2];
        }
    }

    pub(super) fn probe(&self, probe: &mut impl Probe) {
        let q = &self.registers;
        let (n, w) = (self.bits, self.width());
        let contents = &q.contents;
        probe.signal("state", Kind::Word(State::WORDS), q.state as u64);
        probe.signal("curve", Kind::Unsigned(3), u64::from(contents.curve));
        probe.signal("period", Kind::Unsigned(Self::PERIOD_BITS), u64::from(contents.period));
        for axis in 0..AXES {
            probe.axis_signal("first_", axis, Kind::Unsigned(n), contents.first.content[axis]);
        }
        for axis in 0..AXES {
            let negative = contents.first.negative[axis];
            probe.axis_signal("negative_", axis, Kind::Bit, u64::from(negative));
        }
        for axis in 0..2 {
            probe.axis_signal("jr", axis, Kind::Unsigned(n), contents.jr[axis]);
        }
        probe.signal("unit", Kind::Unsigned(n), contents.unit);
        probe.signal("je", Kind::Unsigned(n + 1), contents.accumulations);
        probe.signal("quadrant", Kind::Unsigned(2), u64::from(contents.quadrant));
        probe.signal("crossings", Kind::Unsigned(3), u64::from(contents.crossings));
        probe.signal("cw", Kind::Bit, u64::from(contents.cw));
        for axis in 0..2 {
            probe.axis_signal("je", axis, Kind::Signed(n + 2), contents.je[axis] as u64);
        }
        probe.signal("preset", Kind::Unsigned(2), u64::from(q.preset));
        probe.signal("normalize", Kind::Bit, u64::from(q.normalize));
        for axis in 0..2 {
            probe.axis_signal("start_", axis, Kind::Unsigned(w), q.start[axis]);
        }
        for axis in 0..AXES {
            probe.axis_signal("end_", axis, Kind::Unsigned(w), q.end[axis]);
        }
        for axis in 0..2 {
            let negative = q.start_negative[axis];
            probe.axis_signal("start_negative_", axis, Kind::Bit, u64::from(negative));
        }
        probe.signal("count", Kind::Unsigned(7), u64::from(q.count));
        for axis in 0..2 {
            probe.axis_signal("bits_", axis, Kind::Unsigned(w), q.bits[axis]);
        }
        probe.signal("high", Kind::Unsigned(w + 1), q.high);
        probe.signal("low", Kind::Unsigned(w), q.low);
        probe.signal("turn", Kind::Signed(w + 2), q.turn as u64);
        probe.signal("turn_rest", Kind::Bit, u64::from(q.turn_rest));
        probe.signal("root", Kind::Unsigned(n + 2), q.root);
        probe.signal("rest", Kind::Unsigned(n + 2), q.rest);
    }
}

/// The quadrant that a point is in, from its signs and zeros, and on an axis the one that the sense
/// leads into: 0 to 3.
const fn entered(nx: bool, zx: bool, ny: bool, zy: bool, cw: bool) -> u8 {
    match (zy, ny) {
        (true, _) => match (nx, cw) {
            (true, true) => 1,
            (true, false) => 2,
            (false, true) => 3,
            (false, false) => 0,
        },
        (false, true) => {
            if nx || cw && zx {
                2
            } else {
                3
            }
        }
        (false, false) => {
            if nx || !cw && zx {
                1
            } else {
                0
            }
        }
    }
}
