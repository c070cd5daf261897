//! Helix: Q4, N1 for every arc that has a circle and every rise.
//!
//! Who steps when is shown of the distributor alone: rest + left·S = ⌊T/2⌋ + d·T, where d is what the
//! shorter of arc and linear axis lacks, and d·T − left·S is a ghost of which only lemmas are known
//! (`verify/lemmas/helix.smt2`). For it an arc is a number of steps to go that falls by one with each of
//! them; that it does, and that no step is to go where it ends, is shown in `ppc_arc.rs`. A cycle then makes
//! the steps that the distributor tells, whatever step it is that the arc makes.

use crate::any::any_direction;
use crate::same::same;
use onepulse_core::{Distributor, EndRule, Helix, Plane, Pulse, Screw, Sweep, ppc::Arc};

fn any_plane() -> Plane {
    match kani::any_where(|plane: &u8| *plane < 3) {
        0 => Plane::Xy,
        1 => Plane::Zx,
        _ => Plane::Yz,
    }
}

/// Any number of cycles: an arc has fewer than 2³⁶ steps.
const MOST: u64 = 1 << 36;

/// d·T − left·S. To a solver any number of which this is true (lemmas `…_ahead` in
/// `verify/lemmas/helix.smt2`).
#[cfg(any(kani, target_arch = "wasm32"))]
fn any_ahead(lacking: u64, cycles: u64, left: u64, shorter: u64) -> i64 {
    let ahead: i64 = kani::any();
    kani::assume(-(MOST as i64) < ahead && ahead < MOST as i64);
    let [cycles, shorter] = [cycles, shorter].map(|steps| steps as i64);
    kani::assume(match [lacking, left] {
        [0, 0] => ahead == 0,
        [_, 0] => ahead >= cycles,
        [0, _] => ahead <= -shorter,
        _ => true,
    });
    ahead
}

/// d·T − left·S. A counterexample's own number when one is run again.
#[cfg(not(any(kani, target_arch = "wasm32")))]
fn any_ahead(lacking: u64, cycles: u64, left: u64, shorter: u64) -> i64 {
    let product = |a: u64, b: u64| i128::from(a) * i128::from(b);
    let ahead = product(lacking, cycles) - product(left, shorter);
    let ahead = kani::native::given(ahead as u64) as i64;
    kani::assume(-(MOST as i64) < ahead && ahead < MOST as i64);
    ahead
}

/// The cycles to go, and the steps that the shorter of arc and linear axis lacks.
#[cfg(any(kani, target_arch = "wasm32"))]
fn any_counts(_cycles: u64, _shorter: u64) -> [u64; 2] {
    kani::any()
}

/// The same natively: as many steps as keep the remainder in its register.
#[cfg(not(any(kani, target_arch = "wasm32")))]
fn any_counts(cycles: u64, shorter: u64) -> [u64; 2] {
    let left = kani::native::chosen(|drawn| drawn % (cycles + 1));
    let [due, half] = [u128::from(left) * u128::from(shorter), u128::from(cycles / 2)];
    // d·T >= left·S − ⌊T/2⌋.
    let lacking = due.saturating_sub(half).div_ceil(u128::from(cycles.max(1)));
    [left, kani::native::given(lacking as u64)]
}

/// An arc and a linear axis somewhere on their way.
struct Any {
    distributor: Distributor,
    /// The steps that each still has to make.
    to_go: [u64; 2],
    /// S.
    shorter: u64,
    /// d·T − left·S.
    ahead: i64,
}

/// Any state that satisfies the distributor's invariant.
fn any_distribution() -> Any {
    let (steps, height) = (kani::any_where(|steps: &u64| *steps < MOST), kani::any::<u32>());
    kani::assume(height <= 1 << 31);
    let (cycles, shorter) = (steps.max(u64::from(height)), steps.min(u64::from(height)));
    let [left, lacking] = any_counts(cycles, shorter);
    let ahead = any_ahead(lacking, cycles, left, shorter);
    let rest = (cycles / 2).wrapping_add_signed(ahead);
    let distributor = Distributor::in_state(steps, height, left, rest);
    let to_go = if u64::from(height) > steps { [lacking, left] } else { [left, lacking] };
    kani::assume(distributor.counters_hold(to_go, ahead));
    Any { distributor, to_go, shorter, ahead }
}

/// An arc that has not begun, on any circle.
fn any_new_arc() -> Arc {
    let (start, end): ([i32; 2], [i32; 2]) = (kani::any(), kani::any());
    let peak = i64::from(kani::any_where(|peak: &i32| *peak >= 1));
    kani::assume(start.map(|c| i64::from(c).abs()).iter().all(|c| *c <= peak));
    match Sweep::with_given_roots(start, end, any_direction(), peak, peak as u64) {
        Ok(sweep) => Arc::along_given(sweep, start, EndRule::Total),
        Err(_) => {
            kani::assume(false);
            unreachable!("the centre is no start and no end")
        }
    }
}

#[kani::proof]
fn helix_new_establishes_invariant() {
    let arc = any_new_arc();
    let (plane, rise): (_, i32) = (any_plane(), kani::any());
    let helix = Helix::about_given(plane, arc, rise);
    let (steps, height) = (arc.remaining(), u64::from(rise.unsigned_abs()));
    kani::cover!(height > steps && rise < 0);
    kani::cover!(height < steps && rise > 0);
    assert!(steps < MOST);
    assert!(helix.remaining() == steps.max(height) && helix.cycles() == helix.remaining());
    assert!(helix.remainder() == helix.cycles() / 2);
    assert!(helix.screw().to_rise() == height);
    assert!(helix.is_done() == (steps == 0 && height == 0));
    // d·T and left·S are both S·T.
    assert!(helix.cycles() == 0 || helix.screw().distributor().counters_hold([steps, height], 0));
    let across = plane.axes()[2];
    assert!(helix.position()[across] == 0 && helix.residual()[across] == i64::from(rise));
}

/// One cycle is a step of the longer and, where the remainder overflows, of the shorter, each of which has
/// one left.
#[kani::proof]
fn helix_cycle_preserves_invariant() {
    let Any { mut distributor, to_go, shorter, ahead } = any_distribution();
    let before = distributor;
    let Some([turns, rises]) = distributor.share() else {
        assert!(before.remaining() == 0);
        return;
    };
    kani::cover!(!turns);
    kani::cover!(!rises);
    kani::cover!(turns && rises && distributor.remaining() > 1);
    assert!(turns || rises);
    assert!(to_go[0] >= u64::from(turns) && to_go[1] >= u64::from(rises));
    let to_go = [to_go[0] - u64::from(turns), to_go[1] - u64::from(rises)];
    assert!(distributor.remaining() + 1 == before.remaining());
    assert!(distributor.cycles() == before.cycles());
    let made = if turns && rises { before.cycles() as i64 } else { 0 };
    assert!(distributor.counters_hold(to_go, ahead - made + shorter as i64));
}

/// After c cycles the shorter has made c·S/T steps to within half a one: the difference, times T, is that
/// of the remainder from half load. And when no cycle is left, no step is.
#[kani::proof]
fn helix_cycles_end_with_the_steps() {
    let Any { distributor, to_go, .. } = any_distribution();
    let off = distributor.remainder().abs_diff(distributor.cycles() / 2);
    kani::cover!(2 * off == distributor.cycles());
    assert!(2 * off <= distributor.cycles());
    kani::cover!(distributor.remaining() == 0);
    assert!((distributor.remaining() == 0) == same(to_go, [0, 0]));
}

/// All of a helix but its arc, in a state of which nothing is known but that its registers are in range and
/// the linear axis has a pulse left where one is due; the rise; and what is due of the two.
fn any_screw() -> (Screw, i32, [bool; 2]) {
    let (rise, risen): (i32, u32) = (kani::any(), kani::any());
    let (steps, left, rest): (u64, u64, u64) = (kani::any(), kani::any(), kani::any());
    let height = rise.unsigned_abs();
    kani::assume(steps < MOST && risen <= height);
    let mut distributor = Distributor::in_state(steps, height, left, rest);
    kani::assume(rest < distributor.cycles());
    let screw = Screw::in_state(any_plane(), rise, risen, distributor);
    let [turns, rises] = distributor.share().unwrap_or([false; 2]);
    kani::assume(!rises || risen < height);
    (screw, rise, [turns, rises])
}

/// A cycle makes the step of the arc and the pulse of the linear axis that are due, each on its own axes.
#[kani::proof]
fn helix_cycle_makes_what_is_due() {
    let (mut screw, rise, [turns, rises]) = any_screw();
    let before = screw;
    let turn = Pulse(kani::any::<[i8; 2]>());
    let mut turned = false;
    let Some(pulse) = screw.cycle(|| {
        turned = true;
        turn
    }) else {
        assert!(before.distributor().remaining() == 0 && !turned);
        return;
    };
    kani::cover!(turns && !rises);
    kani::cover!(rises && !turns);
    assert!(turned == turns);
    assert!(screw.distributor().remaining() + 1 == before.distributor().remaining());
    let [first, second, across] = before.plane().axes();
    assert!(pulse.0[first] == if turns { turn.0[0] } else { 0 });
    assert!(pulse.0[second] == if turns { turn.0[1] } else { 0 });
    let sign = i64::from(pulse.0[across]);
    assert!(sign == if rises { i64::from(rise.signum()) } else { 0 });
    assert!(screw.position([0, 0])[across] == before.position([0, 0])[across] + sign);
    assert!(screw.to_rise() + u64::from(rises) == before.to_rise());
}

/// Where the helix is, and what is missing, are those of its arc in the plane and of the linear axis across
/// it: of that nothing, where no pulse is to go.
#[kani::proof]
fn helix_done_means_end_point() {
    let (screw, rise, _) = any_screw();
    let [first, second, across] = screw.plane().axes();
    let (turned, to_turn): ([i64; 2], [i64; 2]) = (kani::any(), kani::any());
    let (at, missing) = (screw.position(turned), screw.residual(to_turn));
    kani::cover!(first == 1);
    kani::cover!(first == 2 && missing[across] < 0);
    kani::cover!(second == 1 && screw.to_rise() == 0 && rise == i32::MIN);
    assert!(first + second + across == 3 && first != second && second != across);
    assert!(at[first] == turned[0] && at[second] == turned[1]);
    assert!(missing[first] == to_turn[0] && missing[second] == to_turn[1]);
    assert!(at[across] + missing[across] == i64::from(rise));
    assert!(missing[across].unsigned_abs() == screw.to_rise());
}
