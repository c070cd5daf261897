//! The S-curve: a trapezoid whose corners are rounded.

use super::Limits;
use super::phase::Phase;
use super::speeds::Speeds;
use crate::Error;

/// Pulses of one axis, from standstill to standstill, without a jump of the acceleration.
///
/// On each clock it moves by the mean of what a [`Trapezoid`](super::Trapezoid) within the same limits
/// moves on it and on the WINDOW − 1 clocks before: w(k), 0 before its first clock and after its last. A
/// mean is no whole number of units, so the phase register counts units of 2⁻ⁿ/WINDOW pulses, in which
/// the axis moves by the sum S(k) = w(k − WINDOW + 1) + … + w(k). Each w is in WINDOW of these sums: the
/// pulses are exactly as many as the trapezoid's, however few, and take WINDOW − 1 clocks more.
///
/// Let T be the trapezoid's clocks and e(k) = w(k) − w(k − 1). It starts with e(1) = w(1) ≤ start. Its last
/// clock moves what is left over, w(T) ≤ start; if that is less than start, it comes down to it from
/// start, so that e(T) and e(T + 1) are −start together. All other e are within ±a. The speed is S/WINDOW.
/// In units of 2⁻ⁿ pulses and clocks,
///
/// * the speed is at most the largest, and from one pulse to the next are ⌊2ⁿ/largest⌋ clocks at least: the
///   register holds less than one clock's way after a pulse, so that (clocks + 1)·largest > 2ⁿ;
/// * the speed changes by (w(k) − w(k − WINDOW))/WINDOW, the mean of WINDOW of the e, among which is the
///   start speed once at most. So **the acceleration is at most a + max(0, start − a)/WINDOW**, at both
///   ends too, where the trapezoid jumps by start;
/// * the acceleration changes by (e(k) − e(k − WINDOW))/WINDOW. So **the jerk is at most
///   2·max(a, start)/WINDOW**, and comes to that where a rise of the trapezoid leaves the mean as a fall
///   enters it. It is half of that at most if there are more than WINDOW clocks from the trapezoid's last
///   rise to its first fall.
///
/// With start ≤ a the acceleration is a at most, then, and the jerk 2a/WINDOW. S-curves as means of
/// trapezoids: L. Biagiotti, C. Melchiorri, FIR filters for online trajectory planning with time- and
/// frequency-domain specifications, Control Engineering Practice 20 (2012).
///
/// WINDOW is a power of two and at least 2; another does not compile.
///
/// ```
/// use onepulse_core::ramp::{Limits, SCurve, Trapezoid};
/// let limits = Limits { bits: 8, start: 4, acceleration: 4, largest: 128 };
/// let clocks = Trapezoid::new(100, limits)?.count();
/// let ramp = SCurve::<16>::new(100, limits)?;
/// assert_eq!(ramp.clone().count(), clocks + 15);
/// assert_eq!(ramp.filter(|pulse| *pulse).count(), 100);
/// # Ok::<(), onepulse_core::Error>(())
/// ```
///
/// ```compile_fail,E0080
/// # use onepulse_core::ramp::{Limits, SCurve};
/// # let limits = Limits { bits: 8, start: 4, acceleration: 4, largest: 128 };
/// let ramp = SCurve::<12>::new(100, limits)?;
/// # Ok::<(), onepulse_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SCurve<const WINDOW: usize> {
    speeds: Speeds,
    /// The last ways, in a ring.
    ways: [u32; WINDOW],
    /// Where the earliest of them is, which the next one takes the place of.
    earliest: usize,
    /// Their sum.
    sum: u32,
    phase: Phase,
}

impl<const WINDOW: usize> SCurve<WINDOW> {
    /// w, of WINDOW = 2^w.
    const BITS: u32 = {
        assert!(WINDOW >= 2 && WINDOW.is_power_of_two(), "a window is 2, 4, 8 … clocks");
        WINDOW.trailing_zeros()
    };

    /// So many pulses within the limits.
    ///
    /// # Errors
    /// Limits out of their ranges; n + w over 31, where WINDOW = 2^w.
    pub fn new(pulses: u32, limits: Limits) -> Result<Self, Error> {
        let limits = limits.checked()?;
        let digits = limits.bits + Self::BITS;
        if digits > 31 {
            return Err(Error::RegisterWidth { digits, widest: 31 });
        }
        Ok(Self {
            speeds: Speeds::new(pulses, limits),
            ways: [0; WINDOW],
            earliest: 0,
            sum: 0,
            phase: Phase::new(digits),
        })
    }

    /// The S-curve in this state, reachable or not: its trapezoid's speeds, the ring of the last ways,
    /// where its earliest is and what counts as their sum, the phase register and the pulses made.
    #[cfg(feature = "proofs")]
    #[must_use]
    pub const fn in_state(
        trapezoid: super::Trapezoid,
        ways: [u32; WINDOW],
        earliest: usize,
        sum: u32,
        phase: u32,
        pulses: u32,
    ) -> Self {
        let speeds = trapezoid.speeds;
        let bits = speeds.limits.bits + Self::BITS;
        Self { speeds, ways, earliest, sum, phase: Phase { bits, register: phase, pulses } }
    }

    /// One clock: whether there is a pulse; `None` when the axis stands at its end.
    #[inline]
    pub fn step(&mut self) -> Option<bool> {
        if self.is_done() {
            return None;
        }
        let way = self.speeds.next_way().unwrap_or(0);
        // The sum of WINDOW ways is below 2^(n + w), 2³¹ at most.
        self.sum = self.sum - self.ways[self.earliest] + way;
        self.ways[self.earliest] = way;
        self.earliest = (self.earliest + 1) % WINDOW;
        let pulse = self.phase.add(self.sum);
        debug_assert!(self.bounds_hold());
        Some(pulse)
    }

    /// What the last clock moved, in units of 2⁻ⁿ/WINDOW pulses: WINDOW times the speed.
    #[must_use]
    pub const fn moved(&self) -> u32 {
        self.sum
    }

    /// The way that its trapezoid has left, in units of 2⁻ⁿ pulses.
    #[must_use]
    pub const fn left(&self) -> u64 {
        self.speeds.left
    }

    /// The way of `age` clocks ago, from 0 (the last clock's) to WINDOW − 1; later ones begin again.
    #[must_use]
    pub const fn way(&self, age: usize) -> u32 {
        self.ways[(self.earliest + (WINDOW - 1 - age % WINDOW)) % WINDOW]
    }

    /// What the next clocks move in all, in units of 2⁻ⁿ/WINDOW pulses: WINDOW times what the
    /// trapezoid has left, and each way as often as it will still be in the sum.
    #[must_use]
    pub const fn to_come(&self) -> u64 {
        let mut to_come = self.speeds.left * WINDOW as u64;
        let mut age = 0;
        while age < WINDOW {
            to_come += (WINDOW - 1 - age) as u64 * self.way(age) as u64;
            age += 1;
        }
        to_come
    }

    /// The phase register, of n + w bits.
    #[must_use]
    pub const fn phase(&self) -> u32 {
        self.phase.register
    }

    /// Pulses made.
    #[must_use]
    pub const fn pulses(&self) -> u32 {
        self.phase.pulses
    }

    /// Whether the axis stands at its end: the trapezoid does, and only the way that leaves the sum next
    /// is in it.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.speeds.left == 0 && self.sum == self.ways[self.earliest]
    }

    /// What always holds of the registers: stopping does not take more than the way that is left, and
    /// speed, sum and phase are within their limits.
    #[must_use]
    pub const fn bounds_hold(&self) -> bool {
        let largest = self.speeds.limits.largest as u64;
        self.speeds.bounds_hold()
            && self.sum as u64 <= largest * WINDOW as u64
            && self.phase.register >> self.phase.bits == 0
    }

    /// What always holds, the ring with it: no way is above the largest speed, the sum is theirs, and
    /// the phase and what is to come make whole pulses together.
    #[must_use]
    pub const fn invariant(&self) -> bool {
        let mut sum = 0;
        let mut age = 0;
        while age < WINDOW {
            if self.way(age) > self.speeds.limits.largest {
                return false;
            }
            sum += self.way(age) as u64;
            age += 1;
        }
        self.bounds_hold() && self.sum as u64 == sum && self.phase.completes(self.to_come())
    }
}

impl<const WINDOW: usize> Iterator for SCurve<WINDOW> {
    type Item = bool;

    #[inline]
    fn next(&mut self) -> Option<bool> {
        self.step()
    }
}
