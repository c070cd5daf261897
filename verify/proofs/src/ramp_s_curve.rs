//! S-curve ramps: A1, N1 for every number of pulses and all limits, windows of 2 and of 8 clocks.
//!
//! The ring is looked at in full. What [`SCurve::to_come`] gives is the sum of all that the next clocks
//! move; that each clock takes what it moves from it, for windows of any size, is in
//! `verify/lemmas/ramp.smt2`. The bounds of acceleration and jerk come from how two ways of the
//! trapezoid that follow one another differ, and from what enters and leaves the sum.

use crate::ramp_trapezoid::any_speeds;
use onepulse_core::ramp::{Limits, SCurve};

/// Any state that satisfies the invariant, with the earliest way anywhere in the ring.
fn any_state<const WINDOW: usize>() -> (SCurve<WINDOW>, Limits) {
    let (trapezoid, limits) = any_speeds();
    kani::assume(limits.bits + WINDOW.trailing_zeros() <= 31);
    // As much as can be left of 2³² − 1 pulses.
    kani::assume(trapezoid.left() >> limits.bits <= u64::from(u32::MAX));
    let ways: [u32; WINDOW] = kani::any();
    let mut place = 0;
    while place < WINDOW {
        kani::assume(ways[place] <= limits.largest);
        place += 1;
    }
    let earliest = kani::any_where(|earliest: &u8| usize::from(*earliest) < WINDOW);
    let [phase, pulses]: [u32; 2] = kani::any();
    // No more pulses than there were to make.
    kani::assume(pulses < u32::MAX);
    let ramp = SCurve::in_state(trapezoid, ways, usize::from(earliest), phase, pulses);
    kani::assume(ramp.invariant());
    (ramp, limits)
}

#[kani::proof]
fn ramp_s_curve_new_establishes_invariant() {
    let bits: u32 = kani::any_where(|bits: &u32| *bits <= 40);
    let [start, acceleration, largest]: [u32; 3] = kani::any();
    let pulses: u32 = kani::any();
    let limits = Limits { bits, start, acceleration, largest };
    let Ok(ramp) = SCurve::<8>::new(pulses, limits) else {
        kani::cover!(start == 0);
        return;
    };
    kani::cover!(bits == 28 && pulses == u32::MAX);
    assert!(bits + 3 <= 31 && start >= 1 && acceleration >= 1 && largest >> bits == 0);
    assert!(start <= largest && acceleration <= largest);
    assert!(ramp.to_come() == u64::from(pulses) << (bits + 3));
    assert!(ramp.moved() == 0 && ramp.pulses() == 0 && ramp.phase() == 0);
    assert!(ramp.invariant());
    assert!(ramp.is_done() == (pulses == 0));
}

/// A clock moves by some of what is to come, and what it moves is in the pulses and the phase: so
/// there is always less to come, and the run ends.
fn step_counts_its_way<const WINDOW: usize>() {
    let (mut ramp, limits) = any_state::<WINDOW>();
    let before = ramp.clone();
    let Some(pulse) = ramp.step() else {
        assert!(before.is_done());
        return;
    };
    kani::cover!(pulse && before.left() == 0 && ramp.is_done());
    kani::cover!(!pulse && ramp.left() > 0);
    let way = u64::from(ramp.moved());
    assert!(ramp.to_come() + way == before.to_come() && way > 0);
    assert!(way <= u64::from(limits.largest) * WINDOW as u64);
    let modulus = (WINDOW as u64) << limits.bits;
    let carried = if pulse { modulus } else { 0 };
    assert!(u64::from(ramp.phase()) + carried == u64::from(before.phase()) + way);
    assert!(ramp.pulses() == before.pulses() + u32::from(pulse));
}

#[kani::proof]
fn ramp_s_curve_step_counts_its_way_of_2() {
    step_counts_its_way::<2>();
}

#[kani::proof]
fn ramp_s_curve_step_counts_its_way_of_8() {
    step_counts_its_way::<8>();
}

#[kani::proof]
fn ramp_s_curve_step_preserves_invariant_of_2() {
    let (mut ramp, _) = any_state::<2>();
    kani::cover!(ramp.left() > 0);
    if ramp.step().is_some() {
        assert!(ramp.invariant());
    }
}

#[kani::proof]
fn ramp_s_curve_step_preserves_invariant_of_8() {
    let (mut ramp, _) = any_state::<8>();
    kani::cover!(ramp.left() > 0);
    if ramp.step().is_some() {
        assert!(ramp.invariant());
    }
}

/// The trapezoid's way comes in, the earliest goes, and the others stay as they are.
#[kani::proof]
fn ramp_s_curve_step_replaces_the_earliest_way() {
    let (mut ramp, _) = any_state::<8>();
    let before = ramp.clone();
    if ramp.step().is_none() {
        return;
    }
    kani::cover!(before.left() > 0 && ramp.left() > 0);
    assert!(u64::from(ramp.way(0)) == before.left() - ramp.left());
    let mut age = 1;
    while age < 8 {
        assert!(ramp.way(age) == before.way(age - 1));
        age += 1;
    }
    assert!(ramp.moved() + before.way(7) == before.moved() + ramp.way(0));
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
    let (ramp, _) = any_state::<8>();
    kani::cover!(ramp.is_done() && ramp.pulses() > 0);
    if ramp.is_done() {
        assert!(ramp.to_come() == 0 && ramp.phase() == 0);
    }
}
