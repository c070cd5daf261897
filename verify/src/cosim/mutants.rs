//! Proof that the comparison sees: every mutant of the Verilog must be told from the circuit.

use super::engine::Engine;
use super::fault::Fault;
use crate::mutant::Mutant;
use std::path::Path;

/// The engine that must show the mutant, and the mutant.
const fn mutant(
    engine: Engine,
    file: &'static str,
    from: &'static str,
    to: &'static str,
) -> (Engine, Mutant) {
    (engine, Mutant { file, from, to })
}

/// At least one for every register and every decision.
const MUTANTS: &[(Engine, Mutant)] = &[
    mutant(
        Engine::DdaLine,
        "integrator.v",
        "{1'b0, o_jr} + {1'b0, i_jv}",
        "{1'b0, o_jr} - {1'b0, i_jv}",
    ),
    mutant(Engine::DdaLine, "integrator.v", "o_jr <= i_preset;", "o_jr <= {N{1'b0}};"),
    mutant(Engine::DdaLine, "dda_line.v", "o_je <= o_je - 1'b1;", "o_je <= o_je - 2'd2;"),
    mutant(
        Engine::DdaLine4,
        "dda_line.v",
        "o_negative <= i_negative;",
        "o_negative <= ~i_negative;",
    ),
    mutant(Engine::DdaLine4, "dda_line.v", "carry & {AXES{run}}", "carry & {AXES{i_en}}"),
    mutant(
        Engine::DdaArc,
        "sweep.v",
        "i_load ? i_quadrant[0] ^ i_cw",
        "i_load ? i_quadrant[1] ^ i_cw",
    ),
    mutant(Engine::DdaArc, "sweep.v", "crosses & o_towards_is_y", "crosses & ~o_towards_is_y"),
    mutant(Engine::DdaArc, "sweep.v", "~o_last & towards_is_zero", "towards_is_zero"),
    mutant(Engine::DdaCentredArc, "sweep.v", "| (~i_load & x_stands & i_x_is_zero)", ""),
    mutant(
        Engine::DdaCentredArc,
        "sweep.v",
        "o_cw ? o_quadrant - 2'd1",
        "o_cw ? o_quadrant + 2'd1",
    ),
    mutant(Engine::DdaCentredArc, "sweep.v", "o_crossings <= o_crossings - 3'd1;", ""),
    mutant(Engine::DdaCentredArc, "sweep.v", "x_at_end | (x_back ^ feeds_nx)", "x_at_end"),
    mutant(
        Engine::DdaCentredArc,
        "sweep.v",
        "o_jey <= o_jey + count_y;",
        "o_jey <= o_jey - count_y;",
    ),
    mutant(Engine::DdaArc, "dda_arc.v", "o_unit ^ {N{o_shrinks_x}}", "o_unit"),
    mutant(
        Engine::DdaArc,
        "dda_arc.v",
        "~o_stepping_out & ~o_stands_y) o_jry",
        "~o_stepping_out) o_jry",
    ),
    mutant(Engine::DdaArc, "dda_arc.v", "o_unit <= i_unit;", "o_unit <= 1;"),
    mutant(Engine::DdaCentredArc, "dda_centred_arc.v", "is_y == o_cw", "is_y != o_cw"),
    mutant(
        Engine::DdaCentredArc,
        "dda_centred_arc.v",
        "~o_stepping_out & ~o_stands_x) o_jrx",
        "~o_stepping_out) o_jrx",
    ),
    mutant(Engine::DdaCentredArc, "dda_centred_arc.v", "o_unit ^ {N{nx}}", "o_unit"),
    mutant(Engine::PpcLine, "ppc_line.v", "~o_f[N] & ~x_done", "~o_f[N]"),
    mutant(Engine::PpcLine, "ppc_line.v", "~{1'b0, o_end_y} + 1'b1", "~{1'b0, o_end_y}"),
    mutant(Engine::PpcLine, "ppc_line.v", "o_larger_is_y ^ o_fx", "o_larger_is_y == o_fx"),
    mutant(Engine::PpcArc, "ppc_arc.v", "~o_f[N+1] & ~towards_stands", "~o_f[N+1]"),
    mutant(Engine::PpcArc, "ppc_arc.v", "shrinks ? FEED : UPDATE", "UPDATE"),
    mutant(Engine::PpcArc, "ppc_arc.v", "o_stands_x & o_stands_y ? ~o_at_end_x :", ""),
    mutant(Engine::PpcArc, "ppc_arc.v", "if (counts) o_e", "o_e"),
    mutant(Engine::BrmLine, "brm_line.v", "N-1-stage", "stage"),
    mutant(Engine::BrmLine, "brm_line.v", "o_tg      <= ~o_overflow;", "o_tg      <= 1'b1;"),
];

/// Runs every mutant until it is found out.
///
/// # Errors
/// A mutant that stays hidden, cannot be built, or does not fit the source any more.
pub(super) fn run(
    rtl: &Path,
    build: &Path,
    check: impl Fn(&Path, &Path, Engine) -> Result<(), Fault>,
) -> Result<(), String> {
    let folder = build.join("mutant");
    for (engine, mutant) in MUTANTS {
        mutant.copy(rtl, &folder)?;
        let name = mutant.name();
        match check(&folder, &folder.join("build"), *engine) {
            Ok(()) => return Err(format!("the co-simulation does not see the mutant {name}")),
            Err(Fault::Differs(why)) => println!("mutant {name}\n    found: {why}"),
            Err(Fault::Broken(why)) => return Err(format!("mutant {name}: {why}")),
        }
    }
    println!("{} mutants, all found", MUTANTS.len());
    Ok(())
}
