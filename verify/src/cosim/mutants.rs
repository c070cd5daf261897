//! Proof that the comparison sees: every mutant of the Verilog must be told from the circuit.

use super::Twin;
use super::engine::Engine;
use super::fault::Fault;
use crate::in_parallel::in_parallel;
use crate::mutant::Mutant;
use std::fs;
use std::path::Path;

/// The twin that must show the mutant, and the mutant.
const fn mutant(
    twin: Twin,
    file: &'static str,
    from: &'static str,
    to: &'static str,
) -> (Twin, Mutant) {
    (twin, Mutant::new(file, from, to))
}

/// An engine at the width at which mutants are looked for.
const fn engine(engine: Engine) -> Twin {
    Twin::Engine { engine, bits: BITS }
}

/// The whole interpolator, the same.
const MACHINE: Twin = Twin::Machine { bits: BITS, axes: 2 };

const BITS: u32 = 8;

/// The decisions. (The registers are changed one by one besides.)
const MUTANTS: &[(Twin, Mutant)] = &[
    mutant(
        engine(Engine::DdaLine),
        "integrator.v",
        "{1'b0, o_jr} + {1'b0, i_jv}",
        "{1'b0, o_jr} - {1'b0, i_jv}",
    ),
    mutant(engine(Engine::DdaLine), "integrator.v", "o_jr <= i_preset;", "o_jr <= {N{1'b0}};"),
    mutant(engine(Engine::DdaLine), "dda_line.v", "o_je <= o_je - 1'b1;", "o_je <= o_je - 2'd2;"),
    mutant(
        engine(Engine::DdaLine4),
        "dda_line.v",
        "o_negative <= i_negative;",
        "o_negative <= ~i_negative;",
    ),
    mutant(engine(Engine::DdaLine4), "dda_line.v", "carry & {AXES{run}}", "carry & {AXES{i_en}}"),
    mutant(engine(Engine::DdaArc), "sweep.v", "= i_quadrant[0] ^ i_cw", "= i_quadrant[1] ^ i_cw"),
    mutant(
        engine(Engine::DdaArc),
        "sweep.v",
        "o_feeds_nx ^ o_towards_is_y",
        "o_feeds_nx ^ ~o_towards_is_y",
    ),
    mutant(engine(Engine::DdaArc), "sweep.v", "~o_last & towards_is_zero", "towards_is_zero"),
    mutant(engine(Engine::DdaCentredArc), "sweep.v", "| (x_stands & i_x_is_zero)", ""),
    mutant(
        engine(Engine::DdaCentredArc),
        "sweep.v",
        "o_cw ? o_quadrant - 2'd1",
        "o_cw ? o_quadrant + 2'd1",
    ),
    mutant(engine(Engine::DdaCentredArc), "sweep.v", "o_crossings <= o_crossings - 3'd1;", ""),
    mutant(
        engine(Engine::DdaCentredArc),
        "sweep.v",
        "o_last & (x_at_end | (x_back ^ o_feeds_nx))",
        "o_last & x_at_end",
    ),
    mutant(
        engine(Engine::DdaCentredArc),
        "sweep.v",
        "o_jey <= o_jey + count_y;",
        "o_jey <= o_jey - count_y;",
    ),
    mutant(engine(Engine::DdaArc), "dda_arc.v", "o_unit ^ {N{o_shrinks_x}}", "o_unit"),
    mutant(
        engine(Engine::DdaArc),
        "dda_arc.v",
        "~o_stepping_out & ~o_stands_y) o_jry",
        "~o_stepping_out) o_jry",
    ),
    mutant(engine(Engine::DdaArc), "dda_arc.v", "o_unit <= i_unit;", "o_unit <= 1;"),
    mutant(engine(Engine::DdaCentredArc), "dda_centred_arc.v", "is_y == o_cw", "is_y != o_cw"),
    mutant(
        engine(Engine::DdaCentredArc),
        "dda_centred_arc.v",
        "~o_stepping_out & ~o_stands_x) o_jrx",
        "~o_stepping_out) o_jrx",
    ),
    mutant(engine(Engine::DdaCentredArc), "dda_centred_arc.v", "o_unit ^ {N{nx}}", "o_unit"),
    mutant(engine(Engine::PpcLine), "ppc_line.v", "~o_f[N] & ~x_done", "~o_f[N]"),
    mutant(engine(Engine::PpcLine), "ppc_line.v", "~{1'b0, o_end_y} + 1'b1", "~{1'b0, o_end_y}"),
    mutant(engine(Engine::PpcLine), "ppc_line.v", "o_larger_is_y ^ o_fx", "o_larger_is_y == o_fx"),
    mutant(engine(Engine::PpcArc), "ppc_arc.v", "~o_f[N+1] & ~towards_stands", "~o_f[N+1]"),
    mutant(engine(Engine::PpcArc), "ppc_arc.v", "shrinks ? FEED : UPDATE", "UPDATE"),
    mutant(engine(Engine::PpcArc), "ppc_arc.v", "o_stands_x & o_stands_y ? ~o_at_end_x :", ""),
    mutant(engine(Engine::PpcArc), "ppc_arc.v", "if (counts) o_e", "o_e"),
    mutant(engine(Engine::BrmLine), "brm_line.v", "N-1-stage", "stage"),
    mutant(
        engine(Engine::BrmLine),
        "brm_line.v",
        "o_tg      <= ~o_overflow;",
        "o_tg      <= 1'b1;",
    ),
    mutant(
        engine(Engine::MinimumDeviationLine),
        "minimum_deviation_line.v",
        "is_due = ~d[N+1];",
        "is_due = ~d[N+1] & d != 0;",
    ),
    mutant(
        engine(Engine::MinimumDeviationLine),
        "minimum_deviation_line.v",
        "is_due ? ~o_rest",
        "is_due ? ~o_end",
    ),
    mutant(
        engine(Engine::MinimumDeviationLine4),
        "minimum_deviation_line.v",
        "run = i_en & ~o_done",
        "run = i_en",
    ),
    mutant(engine(Engine::ComparisonLine), "comparison_line.v", "o_d[N+1] | o_d == 0", "o_d[N+1]"),
    mutant(
        engine(Engine::ComparisonLine),
        "comparison_line.v",
        "o_end_x & {N{feeds_y}}",
        "o_end_x & {N{~feeds_x}}",
    ),
    mutant(engine(Engine::ComparisonLine), "comparison_line.v", "o_jex == 0 & o_jey", "o_jey"),
    mutant(engine(Engine::ComparisonArc), "comparison_arc.v", "level + 1'b1", "level"),
    mutant(engine(Engine::ComparisonArc), "comparison_arc.v", "= level[N+2]", "= ahead[N+2]"),
    mutant(
        engine(Engine::MinimumDeviationArc),
        "minimum_deviation_arc.v",
        "level + {3'b000, away} + 1'b1",
        "level + {3'b000, away}",
    ),
    mutant(
        engine(Engine::MinimumDeviationArc),
        "minimum_deviation_arc.v",
        "level - {3'b000, towards} + 1'b1",
        "level - {3'b000, towards}",
    ),
    mutant(engine(Engine::ComparisonArc), "walk.v", "o_towards_is_y ^ crosses", "o_towards_is_y"),
    mutant(engine(Engine::ComparisonArc), "walk.v", "both_stand ? ~o_at_end_x :", ""),
    mutant(
        engine(Engine::ComparisonArc),
        "walk.v",
        "~o_stands_y & (o_stands_x | o_due_y)",
        "o_due_y",
    ),
    mutant(
        engine(Engine::MinimumDeviationArc),
        "walk.v",
        "~o_stands_x & (o_stands_y |",
        "(o_stands_y |",
    ),
    mutant(engine(Engine::MinimumDeviationArc), "walk.v", " + (change_y & {(N+2){moves_y}})", ""),
    mutant(engine(Engine::ParabolaPpc), "parabola_ppc.v", "~o_f[N+1] & ~stands_along", "~o_f[N+1]"),
    mutant(engine(Engine::ParabolaPpc), "parabola_ppc.v", ") | stands_across;", ");"),
    mutant(
        engine(Engine::ParabolaPpc),
        "parabola_ppc.v",
        "along == o_axis_is_y",
        "along != o_axis_is_y",
    ),
    mutant(engine(Engine::ParabolaPpc), "parabola_ppc.v", "{1'b0, o_v, 1'b1}", "{1'b0, o_v, 1'b0}"),
    mutant(
        engine(Engine::ParabolaPpc),
        "parabola_ppc.v",
        "~{1'b0, o_p, 1'b0}",
        "{1'b0, o_p, 1'b0}",
    ),
    mutant(
        engine(Engine::ParabolaPpc),
        "parabola_ppc.v",
        "stands_along & stands_across",
        "stands_along",
    ),
    mutant(MACHINE, "command_decoder.v", "i_valid & o_ready", "i_valid"),
    mutant(MACHINE, "command_decoder.v", "(cw ? nx | zx : nx)", "nx"),
    mutant(MACHINE, "command_decoder.v", "(cw ? nx : nx | zx)", "nx"),
    mutant(MACHINE, "command_decoder.v", "nx ? (cw ? 2'd1 : 2'd2)", "nx ? 2'd2"),
    mutant(MACHINE, "command_decoder.v", "~o_cw);", "o_cw);"),
    mutant(MACHINE, "command_decoder.v", "o_curve > BRM_LINE", "o_curve > 3'd6"),
    mutant(MACHINE, "command_decoder.v", "o_preset == 2'd3", "1'b0"),
    mutant(MACHINE, "command_decoder.v", "|end_is_wide | ", "1'b0 | "),
    mutant(MACHINE, "command_decoder.v", "(start_zx & start_zy) |", "1'b0 |"),
    mutant(MACHINE, "command_decoder.v", "o_period < SHORTEST", "1'b0"),
    mutant(MACHINE, "command_decoder.v", "(o_turn != 0 | o_turn_rest) & ", "1'b1 & "),
    mutant(MACHINE, "command_decoder.v", "(o_quadrant[0] ^ o_cw)", "o_cw"),
    mutant(
        MACHINE,
        "command_decoder.v",
        "is_one    = ~rest_left[N+4]",
        "is_one    = rest_left[N+4]",
    ),
    mutant(MACHINE, "command_decoder.v", "if (o_rest != 0)", "if (o_rest > 1)"),
    mutant(MACHINE, "command_decoder.v", "end_now > o_root", "end_now < o_root"),
    mutant(MACHINE, "command_decoder.v", "(o_curve == DDA_CENTRED_ARC & o_root[N-1])", "1'b0"),
    mutant(MACHINE, "command_decoder.v", "~some[N-1] & some != 0", "~some[N-1]"),
    mutant(MACHINE, "command_decoder.v", "& ~some[N-2] ", ""),
    mutant(MACHINE, "command_decoder.v", "~some[N-2] & ~o_root[N-1]", "~some[N-2]"),
    mutant(MACHINE, "command_decoder.v", "o_start_negative[1] ^ o_cw;", "o_start_negative[1];"),
    mutant(
        MACHINE,
        "command_decoder.v",
        "o_curve == DDA_ARC & o_crossings != 0",
        "o_curve == DDA_ARC",
    ),
    mutant(MACHINE, "command_decoder.v", "o_state == IDLE & o_error == NONE", "o_state == IDLE"),
    mutant(MACHINE, "pulse_source.v", "o_due & i_ready", "o_due"),
    mutant(MACHINE, "pulse_source.v", "localparam [P-1:0] TWO = 2", "localparam [P-1:0] TWO = 1"),
    mutant(MACHINE, "interpolator.v", "has_entry & ~o_running;", "has_entry;"),
    mutant(MACHINE, "interpolator.v", "o_running & &stage_ready", "o_running"),
    mutant(MACHINE, "interpolator.v", "else if (is_done)", "else if (is_done & ~has_entry)"),
    mutant(MACHINE, "interpolator.v", "& &stage_idle;", ";"),
    mutant(MACHINE, "step_dir.v", "(~o_turned | guard_is_out)", "1'b1"),
    mutant(MACHINE, "step_dir.v", "waits & ~agrees & guard_is_out", "waits & ~agrees"),
    mutant(MACHINE, "command_fifo.v", "same_place & ~same_round", "same_place & same_round & 1'b0"),
    mutant(
        Twin::Machine { bits: BITS, axes: 4 },
        "command_decoder.v",
        "is_flat & |(~end_is_zero & ~flat_axes)",
        "1'b0",
    ),
    mutant(
        Twin::Machine { bits: BITS, axes: 4 },
        "command_decoder.v",
        "o_curve == PPC_LINE;",
        "1'b0;",
    ),
];

/// Runs every mutant until it is found out: the decisions, and every assignment to a register; or,
/// if not `all` are asked for, the decisions of the engines; in either case of the twins asked for.
///
/// # Errors
/// A mutant that stays hidden, cannot be built, or does not fit the source any more.
pub(super) fn run(
    rtl: &Path,
    build: &Path,
    all: bool,
    is_asked: impl Fn(Twin) -> bool,
    check: impl Fn(&Path, &Path, Twin) -> Result<(), Fault> + Sync,
) -> Result<(), String> {
    let registers = if all { Mutant::of_every_register(rtl)? } else { Vec::new() };
    let registers = registers.into_iter().map(|mutant| (twin_of(&mutant.file), mutant));
    let is_seen = |(twin, _): &&(Twin, Mutant)| all || matches!(twin, Twin::Engine { .. });
    let mutants = MUTANTS.iter().filter(is_seen).cloned().chain(registers);
    let mutants: Vec<_> = mutants.filter(|(twin, _)| is_asked(*twin)).enumerate().collect();
    in_parallel(&mutants, |(number, (twin, mutant))| {
        let folder = build.join(format!("mutant_{number}"));
        mutant.copy(rtl, &folder)?;
        let name = mutant.name();
        match check(&folder, &folder.join("build"), *twin) {
            Ok(()) => return Err(format!("the co-simulation does not see the mutant {name}")),
            Err(Fault::Differs(why)) => println!("mutant {name}\n    found: {why}"),
            Err(Fault::Broken(why)) => return Err(format!("mutant {name}: {why}")),
        }
        fs::remove_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))
    })?;
    println!("{} mutants, all found", mutants.len());
    Ok(())
}

/// The smallest twin that has the module of a file in it.
fn twin_of(file: &str) -> Twin {
    match file {
        "integrator.v" | "dda_line.v" => engine(Engine::DdaLine),
        "dda_arc.v" => engine(Engine::DdaArc),
        "sweep.v" | "dda_centred_arc.v" => engine(Engine::DdaCentredArc),
        "ppc_line.v" => engine(Engine::PpcLine),
        "ppc_arc.v" => engine(Engine::PpcArc),
        "brm_line.v" => engine(Engine::BrmLine),
        "walk.v" | "comparison_arc.v" => engine(Engine::ComparisonArc),
        "minimum_deviation_arc.v" => engine(Engine::MinimumDeviationArc),
        "parabola_ppc.v" => engine(Engine::ParabolaPpc),
        "comparison_line.v" => engine(Engine::ComparisonLine),
        "minimum_deviation_line.v" => engine(Engine::MinimumDeviationLine),
        _ => MACHINE,
    }
}
