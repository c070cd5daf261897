//! Trapezoidal ramps: A1, N1 for every number of pulses and all limits.
//!
//! With m steps of the acceleration above the start speed, the speed is start + m·a; m·a is a ghost of
//! [`product`]. What stopping takes, D = m·start + a·m(m − 1)/2, is any number of which no more is known
//! than that it is 0 for m = 0, the start speed for m = 1, and otherwise at least that and the next speed
//! down; how it changes with m is shown.

use crate::product::product;
use onepulse_core::ramp::{Limits, Trapezoid};

/// Any limits within their ranges.
fn any_limits() -> Limits {
    let bits = u32::from(kani::any_where(|bits: &u8| (1..=31).contains(bits)));
    let [start, acceleration, largest]: [u32; 3] = kani::any();
    kani::assume(start >= 1 && acceleration >= 1 && largest >> bits == 0);
    kani::assume(start <= largest && acceleration <= largest);
    Limits { bits, start, acceleration, largest }
}

/// Any speed with what stopping takes and what is left, before the first pulse. The phase is the only one
/// that makes whole pulses of it.
pub(crate) fn any_speeds() -> (Trapezoid, Limits) {
    let limits = any_limits();
    let moves: bool = kani::any();
    let (speed, stopping) = if moves {
        let steps: u32 = kani::any();
        let above = product(limits.acceleration, steps);
        kani::assume(above <= u64::from(limits.largest));
        let speed = limits.start + above as u32;
        let stopping: u64 = kani::any();
        // The sum of the speeds below: of none, of the start speed, of the next one down and it.
        let [start, next] = [limits.start, speed.wrapping_sub(limits.acceleration)].map(u64::from);
        kani::assume(match steps {
            0 => stopping == 0,
            1 => stopping == start,
            _ => stopping >= start + next,
        });
        (speed, stopping)
    } else {
        (0, 0)
    };
    let left: u64 = kani::any();
    kani::assume(left < 1 << 63);
    let phase = left.wrapping_neg() as u32 & ((1 << limits.bits) - 1);
    let ramp = Trapezoid::in_state(limits, left, speed, stopping, phase, 0);
    kani::assume(ramp.invariant());
    (ramp, limits)
}

/// Any state that satisfies the invariant.
fn any_state() -> (Trapezoid, Limits) {
    let (first, limits) = any_speeds();
    // No more pulses than there were to make.
    let pulses = kani::any_where(|pulses: &u32| *pulses < u32::MAX);
    let [left, stopping] = [first.left(), first.stopping()];
    (Trapezoid::in_state(limits, left, first.speed(), stopping, first.phase(), pulses), limits)
}

#[kani::proof]
fn ramp_trapezoid_new_establishes_invariant() {
    let bits: u32 = kani::any_where(|bits: &u32| *bits <= 40);
    let [start, acceleration, largest]: [u32; 3] = kani::any();
    let pulses: u32 = kani::any();
    let limits = Limits { bits, start, acceleration, largest };
    let is_served = (1..=31).contains(&bits)
        && (start >= 1 && acceleration >= 1 && largest >> bits == 0)
        && (start <= largest && acceleration <= largest);
    let Ok(ramp) = Trapezoid::new(pulses, limits) else {
        kani::cover!(start == 0);
        assert!(!is_served);
        return;
    };
    kani::cover!(bits == 31 && pulses == u32::MAX);
    assert!(is_served);
    assert!(ramp.left() == u64::from(pulses) << bits);
    assert!(ramp.speed() == 0 && ramp.pulses() == 0 && ramp.phase() == 0);
    assert!(ramp.invariant());
}

/// A clock moves by some of the way that is left, and what it moves is in the pulses and the phase.
#[kani::proof]
fn ramp_trapezoid_step_counts_its_way() {
    let (mut ramp, limits) = any_state();
    let before = ramp;
    let Some(pulse) = ramp.step() else {
        assert!(before.left() == 0);
        return;
    };
    kani::cover!(pulse && ramp.is_done());
    let way = before.left() - ramp.left();
    assert!(ramp.left() < before.left() && way <= u64::from(limits.largest));
    let modulus = 1_u64 << limits.bits;
    let carried = if pulse { modulus } else { 0 };
    assert!(u64::from(ramp.phase()) + carried == u64::from(before.phase()) + way);
    assert!(ramp.pulses() == before.pulses() + u32::from(pulse));
}

/// The speed changes by the acceleration at most, or begins with the start speed; the way of stopping
/// changes with it; and the end is reached from the start speed.
#[kani::proof]
fn ramp_trapezoid_step_preserves_invariant() {
    let (mut ramp, limits) = any_state();
    let before = ramp;
    if ramp.step().is_none() {
        return;
    }
    assert!(ramp.invariant());
    let (speed, after) = (u64::from(before.speed()), u64::from(ramp.speed()));
    let acceleration = u64::from(limits.acceleration);
    kani::cover!(speed > 0 && after == speed + acceleration);
    kani::cover!(after > 0 && after + acceleration == speed);
    kani::cover!(ramp.is_done());
    if ramp.is_done() {
        assert!(before.left() <= u64::from(limits.start));
    } else {
        let starts = speed == 0 && after == u64::from(limits.start);
        let rises = speed > 0 && after == speed + acceleration;
        let falls = after > 0 && after + acceleration == speed;
        assert!(starts || rises || falls || after == speed);
        // As fast as it can be.
        let next = if speed == 0 { u64::from(limits.start) } else { speed + acceleration };
        let can_stop = before.stopping() + speed + next <= before.left();
        assert!((starts || rises) == (next <= u64::from(limits.largest) && can_stop));
        assert!(falls == (speed > 0 && before.stopping() + speed > before.left()));
        let stopping = if rises {
            before.stopping() + speed
        } else if falls {
            before.stopping() - after
        } else {
            before.stopping()
        };
        assert!(ramp.stopping() == stopping);
    }
}

/// All pulses are made at the end, and none is left in the phase.
#[kani::proof]
fn ramp_trapezoid_done_means_all_pulses() {
    let (ramp, _) = any_state();
    kani::cover!(ramp.is_done() && ramp.pulses() > 0);
    if ramp.is_done() {
        assert!(ramp.phase() == 0);
    }
}
