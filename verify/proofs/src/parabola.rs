//! Parabolas: Q1, Q2, Q3, N1 for every `i32` parameter and end point.
//!
//! F = v² − 2|p|·u holds throughout; v² and |p|·u are the ghosts of [`square`] and [`product`]. Nothing
//! of them is needed but that F does not overflow: its bounds follow from its sign and the rule. What
//! the bounds mean is in `verify/lemmas/parabola.smt2`.
//!
//! Q3 is the integrators' own: with a and b their remainders less 2ⁿ⁻¹, across and along,
//! Φ = 2ⁿ·v² + 2av − 2|p|(2ⁿ·u + b) grows at pulses across only, by less than 2|p|. The step is here; the
//! algebra is in `verify/lemmas/parabola_dda.smt2`, the argument in `docs/proofs/parabola_dda.md`.

use crate::any::{any_axis, any_binary_register, any_preset};
use crate::product::{product, square};
use crate::same::same;
use onepulse_core::Pulse;
use onepulse_core::dda::{Radix, Register};
use onepulse_core::parabola::{Dda, MinimumDeviation, Ppc, Shape};

/// Any parabola.
fn any_shape() -> Shape {
    match Shape::new(any_axis(), kani::any(), kani::any()) {
        Ok(shape) => shape,
        Err(_) => {
            kani::assume(false);
            unreachable!("what has no parameter or ends behind its vertex is refused")
        }
    }
}

/// Any point.
#[cfg(any(kani, target_arch = "wasm32"))]
fn any_point(_p: u32, _end: [u32; 2]) -> [u32; 2] {
    kani::any()
}

/// Any point that is near the parabola, or where an axis stands.
#[cfg(not(any(kani, target_arch = "wasm32")))]
fn any_point(p: u32, [along, across]: [u32; 2]) -> [u32; 2] {
    let (p, most) = (u64::from(p), u64::from(across));
    let v = kani::native::chosen(|drawn| (drawn % (1 << 33)).min(drawn % (most + 1)));
    let nearest = v * v / (2 * p);
    let u = kani::native::chosen(|drawn| (nearest + drawn % 3).min(u64::from(along)));
    [u as u32, v as u32]
}

/// A parabola and a point on the way to its end, in magnitudes along the axis of symmetry and across
/// it.
struct Place {
    shape: Shape,
    p: u32,
    end: [u32; 2],
    point: [u32; 2],
    /// v².
    square: i64,
    /// |p|·u.
    product: u64,
}

impl Place {
    fn any() -> Self {
        let shape = any_shape();
        let along = shape.axis();
        let end = [along.of(shape.end()), along.other().of(shape.end())].map(i32::unsigned_abs);
        let p = shape.parameter().unsigned_abs();
        let point = any_point(p, end);
        kani::assume(point[0] <= end[0] && point[1] <= end[1]);
        // |p|·u from |p|·(u + 1) where there is a pulse left.
        let product = if point[0] < end[0] {
            product(p, point[0] + 1) - u64::from(p)
        } else {
            product(p, point[0])
        };
        Self { shape, p, end, point, square: square(point[1]), product }
    }

    fn f(&self) -> i64 {
        (self.square as u64).wrapping_sub(2 * self.product) as i64
    }

    fn stands(&self) -> [bool; 2] {
        [self.point[0] == self.end[0], self.point[1] == self.end[1]]
    }

    /// F after pulses on these axes, by the ghosts.
    fn f_after(&self, [along, across]: [bool; 2]) -> i64 {
        let product = self.product + if along { u64::from(self.p) } else { 0 };
        let square = self.square + if across { 2 * i64::from(self.point[1]) + 1 } else { 0 };
        (square as u64).wrapping_sub(2 * product) as i64
    }

    /// The axes that a pulse is for; it leads towards the end point on both.
    fn feeds(&self, pulse: Pulse) -> [bool; 2] {
        let (axis, end) = (self.shape.axis(), self.shape.end());
        let feeds = |axis: onepulse_core::Axis| {
            let (pulse, end) = (axis.of(pulse.0), axis.of(end));
            assert!(pulse == 0 || i32::from(pulse) == end.signum());
            pulse != 0
        };
        [feeds(axis), feeds(axis.other())]
    }
}

#[kani::proof]
fn parabola_new_establishes_invariant() {
    let (axis, p, end): (_, i32, [i32; 2]) = (any_axis(), kani::any(), kani::any());
    let along = axis.of(end);
    let Ok(shape) = Shape::new(axis, p, end) else {
        kani::cover!(p > 0);
        assert!(p == 0 || along < 0 && p > 0 || along > 0 && p < 0);
        return;
    };
    kani::cover!(p == i32::MIN && along == i32::MIN);
    assert!(p != 0 && (along == 0 || along.signum() == p.signum()));
    let (Ok(ppc), Ok(nearest)) = (Ppc::new(shape), MinimumDeviation::new(shape)) else {
        panic!("every shape is served")
    };
    assert!(ppc.bounds_hold() && nearest.bounds_hold());
    assert!(ppc.deviation_function() == 0 && nearest.deviation_function() == 0);
    assert!(same(ppc.position(), [0, 0]) && same(nearest.position(), [0, 0]));
    let to_go = end.map(|c| u64::from(c.unsigned_abs()));
    assert!(same(ppc.pulses_to_go(), to_go) && same(nearest.pulses_to_go(), to_go));
    assert!(ppc.remaining() == to_go[0] + to_go[1]);
}

/// One step is one pulse on one axis that does not stand; F follows it, and until an axis stands it
/// decides and is within its bounds, up to the pulse that makes it stand.
#[kani::proof]
fn parabola_ppc_step_preserves_invariant() {
    let place = Place::any();
    let mut curve = Ppc::in_state(place.shape, place.f(), place.point);
    kani::assume(curve.bounds_hold());
    let before = curve;
    let stands = place.stands();
    kani::cover!(before.deviation_function() < 0 && !stands[0]);
    kani::cover!(before.deviation_function() > 0 && !stands[1]);
    kani::cover!(stands[0] && before.deviation_function() > 0 && !stands[1]);
    let Some(pulse) = curve.step() else {
        assert!(before.is_done());
        return;
    };
    let feeds = place.feeds(pulse);
    assert!(feeds[0] != feeds[1]);
    assert!(!(feeds[0] && stands[0] || feeds[1] && stands[1]));
    assert!(curve.remaining() + 1 == before.remaining());
    let at = [place.point[0] + u32::from(feeds[0]), place.point[1] + u32::from(feeds[1])];
    assert!(same(curve.along_and_across(), at));
    let f = curve.deviation_function();
    assert!(f == place.f_after(feeds));
    assert!(curve.bounds_hold());
    if !stands[0] && !stands[1] {
        assert!(feeds[0] == (before.deviation_function() >= 0));
        assert!(-2 * i64::from(place.p) <= f && f <= (2 * i64::from(at[1]) - 2).max(0));
    }
}

/// Until an axis stands, whatever F is within its bounds: no other step leads to a smaller |F|, and F is
/// within its bounds after it, up to the step that makes an axis stand.
#[kani::proof]
fn parabola_minimum_deviation_step_preserves_invariant() {
    let shape = any_shape();
    let (along, parameter) = (shape.axis(), shape.parameter().unsigned_abs());
    let end = [along.of(shape.end()), along.other().of(shape.end())].map(i32::unsigned_abs);
    let point = any_point(parameter, end);
    let f = any_deviation(parameter, point);
    kani::assume(point[0] < end[0] && point[1] < end[1]);
    let mut curve = MinimumDeviation::in_state(shape, f, point);
    kani::assume(curve.bounds_hold());
    let (p, v) = (i64::from(parameter), i64::from(point[1]));
    let after = |feeds: [bool; 2]| {
        f - if feeds[0] { 2 * p } else { 0 } + if feeds[1] { 2 * v + 1 } else { 0 }
    };
    let Some(pulse) = curve.step() else { panic!("no axis stands") };
    let feeds = [along.of(pulse.0) != 0, along.other().of(pulse.0) != 0];
    kani::cover!(feeds[0] && feeds[1]);
    assert!(feeds[0] || feeds[1]);
    let v = v + i64::from(feeds[1]);
    let at = curve.along_and_across();
    assert!(at[0] == point[0] + u32::from(feeds[0]) && i64::from(at[1]) == v);
    let now = curve.deviation_function();
    assert!(now == after(feeds));
    assert!(-p.max(v) <= now && now <= p.max(v - 1));

    // Of two alike the single pulse, which is the one across.
    let [straight, across, diagonal] =
        [[true, false], [false, true], [true, true]].map(|feeds| after(feeds).abs());
    kani::cover!(across == diagonal && across < straight);
    assert!(now.abs() <= straight && now.abs() <= across && now.abs() <= diagonal);
    assert!(across != diagonal || now.abs() < across || !feeds[0]);
}

/// Any F.
#[cfg(any(kani, target_arch = "wasm32"))]
fn any_deviation(_p: u32, _point: [u32; 2]) -> i64 {
    kani::any()
}

/// F of the point. (The machine asserts of itself that it is.)
#[cfg(not(any(kani, target_arch = "wasm32")))]
fn any_deviation(p: u32, point: [u32; 2]) -> i64 {
    let [p, u, v] = [p, point[0], point[1]].map(u64::from);
    kani::native::given((v * v).wrapping_sub(2 * p * u)) as i64
}

/// Once an axis stands, the other makes its pulses one by one; F follows without overflow.
#[kani::proof]
fn parabola_minimum_deviation_step_leads_to_the_end() {
    let place = Place::any();
    let stands = place.stands();
    kani::assume(stands[0] || stands[1]);
    let mut curve = MinimumDeviation::in_state(place.shape, place.f(), place.point);
    kani::assume(curve.bounds_hold());
    let before = curve;
    kani::cover!(stands[0] && before.deviation_function() > 0 && !stands[1]);
    let Some(pulse) = curve.step() else {
        assert!(before.is_done());
        return;
    };
    let feeds = place.feeds(pulse);
    kani::cover!(feeds[0]);
    assert!(same(feeds, [!stands[0], !stands[1]]));
    let at = [place.point[0] + u32::from(feeds[0]), place.point[1] + u32::from(feeds[1])];
    assert!(same(curve.along_and_across(), at));
    assert!(curve.deviation_function() == place.f_after(feeds));
    assert!(curve.bounds_hold());
}

#[kani::proof]
fn parabola_done_means_end_point() {
    let place = Place::any();
    let ppc = Ppc::in_state(place.shape, place.f(), place.point);
    let nearest = MinimumDeviation::in_state(place.shape, place.f(), place.point);
    let end = place.shape.end();
    let (at, missing) = (ppc.position(), ppc.residual());
    kani::cover!(ppc.is_done() && end[0] < 0 && end[1] > 0);
    assert!(same(nearest.position(), at) && same(nearest.residual(), missing));
    assert!(ppc.is_done() == nearest.is_done() && ppc.is_done() == (ppc.remaining() == 0));
    for axis in 0..2 {
        assert!(at[axis] + missing[axis] == i64::from(end[axis]));
        assert!(!ppc.is_done() || missing[axis] == 0);
    }
}

/// Any state of the integrators that satisfies their invariant.
fn any_integration() -> (Dda, [u32; 2], [u64; 2]) {
    let shape = any_shape();
    let (point, jr): ([u32; 2], [u64; 2]) = (kani::any(), kani::any());
    let curve = Dda::in_state(shape, any_binary_register(), jr, point);
    kani::assume(curve.register().digits() >= Dda::bits(&shape));
    kani::assume(curve.invariant());
    (curve, point, jr)
}

/// Whatever the register holds is served, what it does not is refused.
#[kani::proof]
fn parabola_dda_new_establishes_invariant() {
    let (shape, register) = (any_shape(), any_binary_register());
    let across = shape.axis().other().of(shape.end()).unsigned_abs();
    let largest = u64::from(across.max(shape.parameter().unsigned_abs()));
    let preset = any_preset();
    let Ok(curve) = Dda::new(shape, register, preset) else {
        kani::cover!(largest == 1 << 31);
        assert!(largest >= register.modulus());
        return;
    };
    kani::cover!(largest == 1 << 31 && register.digits() == 32);
    assert!(largest < register.modulus());
    assert!(curve.invariant());
    assert!(same(curve.remainders(), [preset.value(register); 2]));
    assert!(same(curve.position(), [0, 0]));
    if let Ok(decimal) = Register::new(Radix::Decimal, 10) {
        assert!(Dda::new(shape, decimal, preset).is_err());
    }
}

/// Every clock adds to each remainder what its integrand was, until the axis stands; the registers
/// stay within their width.
#[kani::proof]
fn parabola_dda_step_preserves_invariant() {
    let (mut curve, point, _) = any_integration();
    let before = curve;
    let (to_go, end) = (before.pulses_to_go(), before.shape().end());
    let Some(pulse) = curve.step() else {
        assert!(before.is_done());
        return;
    };
    kani::cover!(pulse.0[0] != 0 && pulse.0[1] != 0);
    assert!(curve.invariant());
    let along = before.shape().axis().index();
    let is_on_the_axis = to_go[1 - along] == 0 && point[1] == 0;
    kani::cover!(is_on_the_axis);
    let parameter = u64::from(before.shape().parameter().unsigned_abs());
    for axis in 0..2 {
        let fed = u64::from(pulse.0[axis].unsigned_abs());
        assert!(curve.pulses_to_go()[axis] + fed == to_go[axis]);
        assert!(fed == 0 || i32::from(pulse.0[axis]) == end[axis].signum());
        let integrand = if axis == along { u64::from(point[1]) } else { parameter };
        assert!(before.integrands()[axis] == integrand);
        if is_on_the_axis {
            assert!(fed == u64::from(axis == along));
        } else if to_go[axis] > 0 {
            let worth = fed << curve.register().digits();
            assert!(worth + curve.remainders()[axis] == before.remainders()[axis] + integrand);
        }
    }
}

/// Q3's step, until an axis stands. A remainder, as a number about zero, takes the integrand of
/// before and gives 2ⁿ to a pulse; and what a pulse across changes Φ by, 2(a + |p|) − 2ⁿ, is from 0 to
/// 2(|p| − 1), twice what its remainder register holds after it.
#[kani::proof]
fn parabola_dda_step_bounds_its_change() {
    let (mut curve, point, jr) = any_integration();
    let shape = *curve.shape();
    let along = shape.axis();
    let to_go = curve.pulses_to_go();
    kani::assume(to_go[0] > 0 && to_go[1] > 0);
    let modulus = curve.register().modulus() as i64;
    let half = modulus / 2;
    let [b, a] = jr.map(|jr| jr as i64 - half);
    let parameter = i64::from(shape.parameter().unsigned_abs());
    let Some(pulse) = curve.step() else { panic!("a curve on its way is not done") };
    let [p, q] = [along.other(), along].map(|axis| i64::from(axis.of(pulse.0).unsigned_abs()));
    kani::cover!(p == 1 && q == 1);
    kani::cover!(p == 0 && q == 0);
    let jr = curve.remainders();
    let [a_after, b_after] = [along.other(), along].map(|axis| axis.of(jr) as i64 - half);
    for (remainder, after, integrand, pulse) in
        [(a, a_after, parameter, p), (b, b_after, i64::from(point[1]), q)]
    {
        assert!(-half <= after && after < half);
        assert!(pulse <= 1);
        assert!(after == remainder + integrand - if pulse == 1 { modulus } else { 0 });
    }
    if p == 1 {
        let change = 2 * (a + parameter) - modulus;
        kani::cover!(change == 2 * (parameter - 1) && parameter == 1 << 31);
        assert!(0 <= change && change <= 2 * (parameter - 1));
        assert!(change == 2 * (a_after + half));
    }
    // The point takes the pulses.
    let now = curve.pulses_to_go();
    assert!(along.of(now) + q as u64 == along.of(to_go));
    assert!(along.other().of(now) + p as u64 == along.other().of(to_go));
}

/// How far the integrators are from their end: a step makes it less, in the order of the dictionary.
/// Pulses to go across the axis of symmetry; when that axis stands, those along it; what the
/// remainder of the one that is counted lacks to its next pulse.
fn distance(curve: &Dda) -> [u64; 3] {
    let (along, to_go) = (curve.shape().axis(), curve.pulses_to_go());
    let (left, left_across) = (along.of(to_go), along.other().of(to_go));
    let counted = if left_across > 0 { along.other() } else { along };
    let short = curve.register().modulus() - counted.of(curve.remainders());
    [left_across, if left_across > 0 { 0 } else { left }, short]
}

#[kani::proof]
fn parabola_dda_step_makes_progress() {
    let (mut curve, _, _) = any_integration();
    let [across, along, short] = distance(&curve);
    if curve.step().is_none() {
        return;
    }
    let [across_after, along_after, short_after] = distance(&curve);
    kani::cover!(across_after == across && across > 0);
    kani::cover!(across == 0 && along_after < along);
    assert!(
        across_after < across
            || across_after == across
                && (along_after < along || along_after == along && short_after < short)
    );
}

#[kani::proof]
fn parabola_dda_done_means_end_point() {
    let (curve, _, _) = any_integration();
    let end = curve.shape().end();
    kani::cover!(curve.is_done() && end[0] < 0 && end[1] > 0);
    assert!(curve.is_done() == (curve.remaining() == 0));
    for axis in 0..2 {
        assert!(curve.position()[axis] + curve.residual()[axis] == i64::from(end[axis]));
        assert!(!curve.is_done() || curve.residual()[axis] == 0);
    }
}
