//! Line by digital integration: D1, D2, D3, N1 for every width up to 32 bits.
//!
//! The axes have nothing in common but the count of accumulations, so the harnesses have one axis;
//! [`dda_line_axes_are_alike`] shows that two are two times one.

use crate::any::{any_binary_register, any_preset};
use onepulse_core::dda::{Line, Register};

/// A line somewhere on its way, and left·JV.
struct Any {
    line: Line<1>,
    due: u64,
}

/// Any state that satisfies the invariant, with any shift that leaves the integrand in its register.
fn any_state() -> Any {
    let register = any_binary_register();
    let end: i32 = kani::any();
    let shift = u32::from(kani::any_where(|shift: &u8| *shift < 32));
    let (modulus, magnitude) = (register.modulus(), u64::from(end.unsigned_abs()));
    kani::assume(shift < register.digits() && magnitude << shift < modulus);
    let jv = magnitude << shift;
    let left = kani::any_where(|left: &u64| *left <= modulus >> shift);
    let jr = kani::any_where(|jr: &u64| *jr < modulus);
    let due = product(jv, left, magnitude << register.digits());
    // What the invariant makes of it: JR + left·JV = preset + lacking·2ⁿ.
    let lacking = (due + jr) >> register.digits();
    let done = magnitude as i64 - lacking as i64;
    let position = if end < 0 { -done } else { done };
    let line = Line::in_state([end], register, shift, [jr], [position], left);
    kani::assume(line.invariant_given([due]));
    Any { line, due }
}

/// left·JV. To a solver any number with these properties of the product, which is `most` at most
/// (lemmas in `verify/lemmas/product.smt2`).
#[cfg(any(kani, target_arch = "wasm32"))]
fn product(jv: u64, left: u64, most: u64) -> u64 {
    let product: u64 = kani::any();
    kani::assume(product <= most);
    kani::assume(match left {
        0 => product == 0,
        1 => product == jv,
        _ => product >= 2 * jv,
    });
    product
}

/// left·JV. A counterexample's own number when one is run again.
#[cfg(not(any(kani, target_arch = "wasm32")))]
fn product(jv: u64, left: u64, _most: u64) -> u64 {
    kani::native::given(jv * left)
}

/// Every end that the register holds, every preset, normalized or not; 2^(n−Q) accumulations.
#[kani::proof]
fn dda_line_new_establishes_invariant() {
    let register = any_binary_register();
    let end: i32 = kani::any();
    let normalize: bool = kani::any();
    let magnitude = u64::from(end.unsigned_abs());
    let Ok(line) = Line::new([end], register, any_preset(), normalize) else {
        kani::cover!(magnitude == 1 << 31);
        assert!(magnitude >= register.modulus());
        return;
    };
    kani::cover!(normalize && end < 0 && line.shift() > 0);
    kani::cover!(end == i32::MIN);
    assert!(line.remaining() == register.modulus() >> line.shift());
    assert!(line.shift() < register.digits() || end == 0);
    // left·JV at the start: 2^(n−Q) · |end|·2^Q.
    assert!(line.invariant_given([magnitude << register.digits()]));
    assert!(line.position()[0] == 0);
    if normalize && end != 0 {
        assert!(line.integrands()[0] >= register.modulus() / 2);
    }
}

/// D1: an accumulation adds the integrand to what remainder and pulse are worth together, from any
/// contents whatever.
#[kani::proof]
fn dda_line_step_adds_integrand() {
    let Any { mut line, .. } = any_state();
    let before = line;
    let negative = line.residual()[0] < 0 || line.position()[0] < 0;
    let Some(pulse) = line.step() else {
        assert!(before.remaining() == 0);
        return;
    };
    kani::cover!(pulse.0[0] == -1);
    kani::cover!(pulse.0[0] == 0 && before.integrands()[0] > 0);
    assert!(line.remaining() + 1 == before.remaining());
    let carry = pulse.0[0].unsigned_abs();
    assert!(carry <= 1 && (carry == 0 || (pulse.0[0] < 0) == negative));
    let worth = u64::from(carry) << line.register().digits();
    assert!(worth + line.remainders()[0] == before.remainders()[0] + before.integrands()[0]);
    assert!(line.position()[0] == before.position()[0] + i64::from(pulse.0[0]));
    assert!(line.integrands()[0] == before.integrands()[0]);
}

#[kani::proof]
fn dda_line_step_preserves_invariant() {
    let Any { mut line, due } = any_state();
    let jv = line.integrands()[0];
    let Some(pulse) = line.step() else { return };
    kani::cover!(pulse.0[0] != 0);
    kani::cover!(line.is_done());
    assert!(line.invariant_given([due - jv]));
}

/// D3.
#[kani::proof]
fn dda_line_done_means_end_point() {
    let Any { line, .. } = any_state();
    kani::cover!(line.is_done() && line.position()[0] < 0);
    if line.is_done() {
        assert!(line.residual()[0] == 0);
    }
}

/// D2, per axis: after i accumulations |pulses − i·J/2ⁿ| = |preset − JR|/2ⁿ by D1, which is below 1,
/// and ½ at most with half load.
#[kani::proof]
fn dda_line_invariant_means_deviation() {
    let Any { line, .. } = any_state();
    let preset = any_preset();
    let register: Register = line.register();
    let off = preset.value(register).abs_diff(line.remainders()[0]);
    kani::cover!(off > register.modulus() / 2);
    assert!(off < register.modulus());
    if preset == onepulse_core::dda::Preset::Half {
        assert!(2 * off <= register.modulus());
    }
}

/// What an axis does does not depend on the other.
#[kani::proof]
fn dda_line_axes_are_alike() {
    let register = any_binary_register();
    let end: [i32; 2] = kani::any();
    let (modulus, left) = (register.modulus(), u64::from(kani::any::<u32>()));
    kani::assume(end.iter().all(|c| u64::from(c.unsigned_abs()) < modulus));
    let jr = [kani::any_where(|jr: &u64| *jr < modulus), kani::any_where(|jr: &u64| *jr < modulus)];
    let mut both = Line::in_state(end, register, 0, jr, [0; 2], left);
    let together = both.step();
    kani::cover!(together.is_some_and(|pulse| pulse.0[0] == 1 && pulse.0[1] == -1));
    for axis in 0..2 {
        let mut one = Line::in_state([end[axis]], register, 0, [jr[axis]], [0], left);
        let alone = one.step();
        assert!(together.is_some() == alone.is_some());
        assert!(together.map(|pulse| pulse.0[axis]) == alone.map(|pulse| pulse.0[0]));
        assert!(both.remainders()[axis] == one.remainders()[0]);
        assert!(both.position()[axis] == one.position()[0]);
    }
}
