//! Line by digital integration: D1, D2, D3, N1 for every width up to 32 bits.
//!
//! The axes have nothing in common but the count of accumulations, so the harnesses have one axis;
//! [`dda_line_axes_are_alike`] shows that two are two times one.

use crate::any::{any_binary_register, any_preset};
use onepulse_core::dda::{Line, Register};

/// What the axes of a line have in common.
struct Common {
    register: Register,
    shift: u32,
    left: u64,
}

/// One axis of a line somewhere on its way, and left·JV.
struct Any {
    end: i32,
    jr: u64,
    position: i64,
    due: u64,
}

fn any_common() -> Common {
    let register = any_binary_register();
    let shift = u32::from(kani::any_where(|shift: &u8| u32::from(*shift) < register.digits()));
    let left = kani::any_where(|left: &u64| *left <= register.modulus() >> shift);
    Common { register, shift, left }
}

impl Common {
    /// Any state of an axis that satisfies the invariant, JR + left·JV = preset + lacking·2ⁿ.
    fn any_axis(&self) -> Any {
        let (modulus, bits) = (self.register.modulus(), self.register.digits());
        let end =
            kani::any_where(|end: &i32| u64::from(end.unsigned_abs()) << self.shift < modulus);
        let magnitude = u64::from(end.unsigned_abs());
        let jr = kani::any_where(|jr: &u64| *jr < modulus);
        let due = product(magnitude << self.shift, self.left, magnitude << bits);
        let done = magnitude as i64 - ((due + jr) >> bits) as i64;
        Any { end, jr, position: if end < 0 { -done } else { done }, due }
    }

    fn line<const AXES: usize>(&self, axes: [&Any; AXES]) -> Line<AXES> {
        let (end, jr) = (axes.map(|axis| axis.end), axes.map(|axis| axis.jr));
        let position = axes.map(|axis| axis.position);
        Line::in_state(end, self.register, self.shift, jr, position, self.left)
    }
}

/// Any state of a line of one axis that satisfies the invariant, and left·JV.
fn any_state() -> (Line<1>, u64) {
    let common = any_common();
    let axis = common.any_axis();
    let line = common.line([&axis]);
    kani::assume(line.invariant_given([axis.due]));
    (line, axis.due)
}

/// Any state of a line of two axes that satisfies the invariant.
pub(crate) fn any_state_of_two() -> Line {
    let common = any_common();
    let [x, y] = [common.any_axis(), common.any_axis()];
    let line = common.line([&x, &y]);
    kani::assume(line.invariant_given([x.due, y.due]));
    line
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
    } else {
        assert!(line.shift() == 0);
    }
}

/// D1: an accumulation adds the integrand to what remainder and pulse are worth together, from any
/// contents whatever.
#[kani::proof]
fn dda_line_step_adds_integrand() {
    let (mut line, _) = any_state();
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
    let (mut line, due) = any_state();
    let jv = line.integrands()[0];
    let Some(pulse) = line.step() else { return };
    kani::cover!(pulse.0[0] != 0);
    kani::cover!(line.is_done());
    assert!(line.invariant_given([due - jv]));
}

/// D3.
#[kani::proof]
fn dda_line_done_means_end_point() {
    let (line, _) = any_state();
    kani::cover!(line.is_done() && line.position()[0] < 0);
    if line.is_done() {
        assert!(line.residual()[0] == 0);
    }
}

/// D2, per axis: after i accumulations |pulses − i·J/2ⁿ| = |preset − JR|/2ⁿ by D1, which is below 1,
/// and ½ at most with half load.
#[kani::proof]
fn dda_line_invariant_means_deviation() {
    let (line, _) = any_state();
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
    let common = any_common();
    let axes = [common.any_axis(), common.any_axis()];
    let mut both = common.line([&axes[0], &axes[1]]);
    kani::assume(both.invariant_given([axes[0].due, axes[1].due]));
    let together = both.step();
    kani::cover!(together.is_some_and(|pulse| pulse.0[0] == 1 && pulse.0[1] == -1));
    for axis in 0..2 {
        let mut one = common.line([&axes[axis]]);
        let alone = one.step();
        assert!(together.is_some() == alone.is_some());
        assert!(together.map(|pulse| pulse.0[axis]) == alone.map(|pulse| pulse.0[0]));
        assert!(both.remainders()[axis] == one.remainders()[0]);
        assert!(both.position()[axis] == one.position()[0]);
    }
}
