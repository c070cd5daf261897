//! Line by rate multiplier: B1, N1 for every width up to 32 bits.
//!
//! Stage t (from the source, t = 0 the fastest) is due at the clocks k·2^(t+1) + 2^t, so of the first
//! k clocks it has passed ⌊(k + 2^t)/2^(t+1)⌋. An axis' train is the sum of the stages that its value
//! gates; one stage at most passes a clock, so no two of its pulses fall together.

use crate::any::any_binary_register;
use onepulse_core::brm::Line;

/// Clocks that a stage has passed of the first `clocks`.
fn passed(stage: u32, clocks: u64) -> u64 {
    (clocks + (1 << stage)) >> (stage + 1)
}

pub(crate) fn any_end(modulus: u64) -> i32 {
    kani::any_where(|end: &i32| u64::from(end.unsigned_abs()) < modulus)
}

/// A clock sends an axis a pulse if, and only if, its value gates the stage that passes the clock.
#[kani::proof]
#[kani::unwind(34)]
fn brm_step_passes_one_stage() {
    let register = any_binary_register();
    let end = any_end(register.modulus());
    let clock = kani::any_where(|clock: &u64| *clock <= register.modulus());
    let mut line = Line::after_clocks([end], register, clock);
    let position = line.position()[0];
    let gate = line.gate();
    let Some(pulse) = line.step() else {
        assert!(clock == register.modulus());
        return;
    };
    kani::cover!(pulse.0[0] == -1);
    kani::cover!(gate == 1 && line.is_done() == (register.digits() == 1));
    assert!(gate & gate.wrapping_sub(1) == 0);
    assert!((pulse.0[0] != 0) == (u64::from(end.unsigned_abs()) & gate != 0));
    assert!(pulse.0[0] == 0 || i32::from(pulse.0[0]) == end.signum());
    assert!(line.position()[0] == position + i64::from(pulse.0[0]));
    assert!(line.residual()[0] == i64::from(end) - line.position()[0]);
    assert!(line.clock() == clock + 1);
    assert!(line.remaining() + 1 == register.modulus() - clock);

    // The stage of each weight counts the clocks that are due to it, and no others.
    let stage = u32::from(kani::any_where(|stage: &u8| u32::from(*stage) < register.digits()));
    let is_open = gate == register.modulus() >> (stage + 1);
    kani::cover!(is_open);
    assert!(passed(stage, clock + 1) == passed(stage, clock) + u64::from(is_open));
}

/// After 2ⁿ clocks a stage has passed as many as its weight, so that an axis has had exactly its
/// value.
#[kani::proof]
fn brm_stages_pass_their_weights() {
    let register = any_binary_register();
    let stage = u32::from(kani::any_where(|stage: &u8| u32::from(*stage) < register.digits()));
    kani::cover!(stage == 31);
    assert!(passed(stage, 0) == 0);
    assert!(passed(stage, register.modulus()) == register.modulus() >> (stage + 1));
}

#[kani::proof]
fn brm_new_starts_at_nothing() {
    let register = any_binary_register();
    let end: i32 = kani::any();
    match Line::new([end], register.digits()) {
        Ok(line) => {
            kani::cover!(end == i32::MIN);
            assert!(line.position()[0] == 0 && line.clock() == 0);
            assert!(line.values()[0] == u64::from(end.unsigned_abs()));
            assert!(line.values()[0] < register.modulus());
            assert!(line.residual()[0] == i64::from(end));
        }
        Err(_) => assert!(u64::from(end.unsigned_abs()) >= register.modulus()),
    }
}
