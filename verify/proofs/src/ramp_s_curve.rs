//! S-curve ramps: A1, N1 for every number of pulses and all limits, windows of 2 and of 8 clocks.
//!
//! A window of 2 is looked at in full. Of one of 8, no more is known of the sum than that the
//! earliest way and the next are parts of it, and the ring is shown to shift by one place. That the sum
//! stays the ring's then, and that each clock takes what it moves from what is to come, is shown for
//! windows of any size in `verify/lemmas/ramp_s_curve.smt2`; so is how acceleration and jerk follow from
//! the difference of two ways of the trapezoid that follow one another.
//!
//! Where the ring's earliest way lies is a constant of each check, so that no place is looked up.

use crate::ramp_trapezoid::any_speeds;
use onepulse_core::ramp::{Limits, SCurve};

/// Any number from `least` to `most`.
#[cfg(any(kani, target_arch = "wasm32"))]
#[inline(always)]
fn any_within(least: u32, most: u64) -> u32 {
    kani::any_where(|number: &u32| least <= *number && u64::from(*number) <= most)
}

/// Any number from `least` to `most`.
#[cfg(not(any(kani, target_arch = "wasm32")))]
fn any_within(least: u32, most: u64) -> u32 {
    kani::native::chosen(|drawn| u64::from(least) + drawn % (most + 1 - u64::from(least))) as u32
}

/// Any state of a ring, the rest of which is in its bounds, with its earliest way in this place.
#[inline(always)]
fn any_ring<const WINDOW: usize, const EARLIEST: usize>() -> (SCurve<WINDOW>, Limits) {
    let (trapezoid, limits) = any_speeds();
    kani::assume(limits.bits + WINDOW.trailing_zeros() <= 31);
    // As much as can be left of 2³² − 1 pulses.
    kani::assume(trapezoid.left() >> limits.bits <= u64::from(u32::MAX));
    let largest = u64::from(limits.largest);
    let mut ways = [0; WINDOW];
    let mut place = 0;
    while place < WINDOW {
        ways[place] = any_within(0, largest);
        place += 1;
    }
    // All ways but the earliest together; the next one to leave is among them.
    let next = ways[(EARLIEST + 1) % WINDOW];
    let others = if WINDOW == 2 { next } else { any_within(next, (WINDOW as u64 - 1) * largest) };
    let sum = ways[EARLIEST] + others;
    let ramp = SCurve::in_state(trapezoid, ways, EARLIEST, sum, 0, 0);
    let modulus = (WINDOW as u32) << limits.bits;
    let phase = if WINDOW == 2 {
        // The only one that makes whole pulses of what is to come.
        ramp.to_come().wrapping_neg() as u32 & (modulus - 1)
    } else {
        any_within(0, u64::from(modulus) - 1)
    };
    // No more pulses than there were to make.
    let pulses = any_within(0, u64::from(u32::MAX) - 1);
    (SCurve::in_state(trapezoid, ways, EARLIEST, sum, phase, pulses), limits)
}

/// Any state of a window of 2 that satisfies the invariant.
#[inline(always)]
fn any_state<const EARLIEST: usize>() -> (SCurve<2>, Limits) {
    let (ramp, limits) = any_ring::<2, EARLIEST>();
    kani::assume(ramp.invariant());
    (ramp, limits)
}

#[kani::proof]
fn ramp_s_curve_new_establishes_invariant() {
    let bits: u32 = kani::any_where(|bits: &u32| *bits <= 40);
    let [start, acceleration, largest]: [u32; 3] = kani::any();
    let pulses: u32 = kani::any();
    let limits = Limits { bits, start, acceleration, largest };
    let is_served = (1..=28).contains(&bits)
        && (start >= 1 && acceleration >= 1 && largest >> bits == 0)
        && (start <= largest && acceleration <= largest);
    // Values drawn at random hardly ever come to the widest registers.
    let widest = Limits { bits: 28, start: 1, acceleration: 1, largest: 1 };
    assert!(SCurve::<8>::new(pulses, widest).is_ok());
    let Ok(ramp) = SCurve::<8>::new(pulses, limits) else {
        kani::cover!(start == 0);
        assert!(!is_served);
        return;
    };
    kani::cover!(bits == 28 && pulses == u32::MAX);
    assert!(is_served);
    assert!(ramp.to_come() == u64::from(pulses) << (bits + 3));
    assert!(ramp.moved() == 0 && ramp.pulses() == 0 && ramp.phase() == 0);
    assert!(ramp.invariant());
    assert!(ramp.is_done() == (pulses == 0));
}

/// A clock moves by some of what is to come, and by no more than the largest speed: so there is
/// always less to come, and the run ends. The invariant stays.
#[inline(never)]
fn step_takes_its_way<const EARLIEST: usize>() {
    let (mut ramp, limits) = any_state::<EARLIEST>();
    let before = ramp.clone();
    if ramp.step().is_none() {
        assert!(before.is_done());
        return;
    }
    kani::cover!(before.left() == 0 && ramp.is_done());
    let moved = u64::from(ramp.moved());
    assert!(ramp.to_come() + moved == before.to_come() && moved > 0);
    assert!(moved <= 2 * u64::from(limits.largest));
    assert!(ramp.invariant());
}

#[kani::proof]
fn ramp_s_curve_step_takes_its_way_from_first() {
    step_takes_its_way::<0>();
}

#[kani::proof]
fn ramp_s_curve_step_takes_its_way_from_last() {
    step_takes_its_way::<1>();
}

/// What a clock moves is in the pulses and the phase; the trapezoid's way comes in, the earliest
/// goes, and the others stay as they are. It stands when no other is left.
#[inline(never)]
fn step_shifts_ring<const EARLIEST: usize>() {
    let (mut ramp, limits) = any_ring::<8, EARLIEST>();
    let before = ramp.clone();
    let Some(pulse) = ramp.step() else {
        assert!(before.left() == 0 && before.moved() == before.way(7));
        return;
    };
    kani::cover!(pulse && before.left() > 0 && ramp.left() > 0);
    let moved = u64::from(ramp.moved());
    assert!(moved > 0 && moved <= 8 * u64::from(limits.largest));
    let carried = if pulse { 8 << limits.bits } else { 0 };
    assert!(u64::from(ramp.phase()) + carried == u64::from(before.phase()) + moved);
    assert!(ramp.pulses() == before.pulses() + u32::from(pulse));

    assert!(u64::from(ramp.way(0)) == before.left() - ramp.left());
    assert!(ramp.moved() + before.way(7) == before.moved() + ramp.way(0));
    let mut age = 1;
    while age < 8 {
        assert!(ramp.way(age) == before.way(age - 1));
        age += 1;
    }
    assert!(ramp.bounds_hold());
}

#[kani::proof]
fn ramp_s_curve_step_shifts_ring_from_first() {
    step_shifts_ring::<0>();
}

#[kani::proof]
fn ramp_s_curve_step_shifts_ring_from_within() {
    step_shifts_ring::<3>();
}

#[kani::proof]
fn ramp_s_curve_step_shifts_ring_from_last() {
    step_shifts_ring::<7>();
}

/// Two ways of the trapezoid that follow one another differ by the acceleration or the start speed
/// at most; standing is a way of 0.
#[kani::proof]
fn ramp_s_curve_ways_change_within_limits() {
    let (trapezoid, limits) = any_speeds();
    let Limits { start, acceleration, .. } = limits;
    let mut ramp = trapezoid;
    if ramp.step().is_none() {
        return;
    }
    // On the way the speed is what the last clock moved.
    let [last, way] = [u64::from(trapezoid.speed()), trapezoid.left() - ramp.left()];
    kani::cover!(last > 0 && ramp.is_done() && way < last);
    kani::cover!(last == 0 && !ramp.is_done());
    assert!(way == u64::from(ramp.speed()) || ramp.is_done());
    assert!(way.abs_diff(last) <= u64::from(start.max(acceleration)));
    // The end, from which it stops at once; short of the start speed, it came from it.
    if ramp.is_done() {
        assert!(way <= u64::from(start));
        assert!(way == u64::from(start) || last == 0 || last == u64::from(start));
    } else if last > 0 {
        assert!(way.abs_diff(last) <= u64::from(acceleration));
    }
}

/// All pulses are made at the end, and none is left in the phase.
#[kani::proof]
fn ramp_s_curve_done_means_all_pulses() {
    let (ramp, _) = any_state::<0>();
    kani::cover!(ramp.is_done() && ramp.pulses() > 0);
    if ramp.is_done() {
        assert!(ramp.to_come() == 0 && ramp.phase() == 0);
    }
}
