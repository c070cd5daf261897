//! The smoothed rate multiplier: B3, N1 for every width up to 32 bits together.
//!
//! What the trains are is the business of `brm.rs`: a clock sends an axis a pulse of its train if its
//! value gates the stage that passes the clock, whatever the value, and a stage passes as many clocks as its
//! weight. Here the trains may have come to any count.

use crate::any::any_binary_register;
use onepulse_core::brm::Smoothed;
use onepulse_core::dda::Register;

/// A line of one axis after any clock, its train after any number of pulses.
struct Any {
    line: Smoothed<1>,
    end: i32,
    register: Register,
    smoothing: u32,
    /// Pulses of the train.
    train: u64,
    position: u64,
    divider: u64,
}

/// |end| is below 2ⁿ where n + k stages are those of the register.
fn is_held(end: i32, register: Register, smoothing: u32) -> bool {
    u64::from(end.unsigned_abs()) << smoothing < register.modulus()
}

fn any_smoothing(register: Register) -> u32 {
    u32::from(kani::any_where(|k: &u8| u32::from(*k) < register.digits()))
}

/// The pulses of a train of this value in so many clocks: to a solver any number of them.
#[cfg(any(kani, target_arch = "wasm32"))]
fn any_train(_value: u64, _register: Register, _clocks: u64) -> u64 {
    kani::any()
}

/// The pulses of a train of this value in so many clocks.
#[cfg(not(any(kani, target_arch = "wasm32")))]
fn any_train(value: u64, register: Register, clocks: u64) -> u64 {
    let stages = (0..register.digits()).filter(|t| value & (register.modulus() >> (t + 1)) != 0);
    kani::native::given(stages.map(|t| (clocks + (1 << t)) >> (t + 1)).sum())
}

/// Any state that satisfies the dividers' invariant.
fn any_state() -> Any {
    let register = any_binary_register();
    let smoothing = any_smoothing(register);
    let end = kani::any_where(|end: &i32| is_held(*end, register, smoothing));
    let clock = kani::any_where(|clock: &u64| *clock <= register.modulus());
    let magnitude = u64::from(end.unsigned_abs());
    let train = any_train(magnitude << smoothing, register, clock);
    kani::assume(train <= magnitude << smoothing);
    let load = (1 << smoothing) >> 1;
    let position = (load + train) >> smoothing;
    let divider = load + train - (position << smoothing);
    let signed = |count: u64| if end < 0 { -(count as i64) } else { count as i64 };
    let passed = [signed(train)];
    let line = Smoothed::in_state(
        [end],
        register,
        smoothing,
        clock,
        passed,
        [divider],
        [signed(position)],
    );
    kani::assume(line.dividers_hold());
    Any { line, end, register, smoothing, train, position, divider }
}

#[kani::proof]
fn brm_smoothed_new_establishes_invariant() {
    let register = any_binary_register();
    let smoothing = any_smoothing(register);
    let end: i32 = kani::any();
    let Ok(line) = Smoothed::new([end], register.digits() - smoothing, smoothing) else {
        assert!(!is_held(end, register, smoothing));
        return;
    };
    kani::cover!(end == i32::MIN);
    kani::cover!(smoothing > 3 && end < 0);
    assert!(is_held(end, register, smoothing));
    assert!(line.dividers_hold());
    assert!(line.train().values()[0] == u64::from(end.unsigned_abs()) << smoothing);
    assert!(line.train().register().digits() == register.digits());
    assert!(line.remaining() == register.modulus() && line.clock() == 0);
    assert!(line.position()[0] == 0 && line.train().position()[0] == 0);
    assert!(line.residual()[0] == i64::from(end));
}

/// A pulse of the train goes into the divider, and out of it when it is full.
#[kani::proof]
fn brm_smoothed_step_preserves_invariant() {
    let Any { mut line, end, register, smoothing, train, position, divider } = any_state();
    let (clock, gate) = (line.clock(), line.train().gate());
    let Some(pulse) = line.step() else {
        assert!(clock == register.modulus());
        return;
    };
    let value = u64::from(end.unsigned_abs()) << smoothing;
    let passes = value & gate != 0;
    kani::cover!(pulse.0[0] == -1 && smoothing > 1);
    kani::cover!(passes && pulse.0[0] == 0);
    assert!(line.clock() == clock + 1 && line.remaining() == register.modulus() - clock - 1);
    assert!(line.train().position()[0].unsigned_abs() == train + u64::from(passes));
    assert!(line.dividers_hold());
    let is_sent = pulse.0[0] != 0;
    assert!(is_sent == (passes && divider + 1 == 1 << smoothing));
    assert!(!is_sent || i32::from(pulse.0[0]) == end.signum());
    assert!(line.position()[0].unsigned_abs() == position + u64::from(is_sent));
}

/// What is passed on is the train divided by 2^k, to within half a pulse, and exactly the end when the train
/// has had all its pulses.
#[kani::proof]
fn brm_smoothed_done_means_end_point() {
    let Any { line, end, smoothing, train, position, .. } = any_state();
    kani::cover!(2 * train.abs_diff(position << smoothing) == 1 << smoothing);
    assert!(2 * train.abs_diff(position << smoothing) <= 1 << smoothing);
    assert!(line.position()[0] + line.residual()[0] == i64::from(end));
    if train == u64::from(end.unsigned_abs()) << smoothing {
        kani::cover!(end == i32::MIN);
        assert!(line.residual()[0] == 0);
    }
}
