//! Formal checks of the Verilog twins: the asserts of `hwmodel/rtl/formal/*_props.v`, for every
//! command and every pattern of the pulse source, from reset (bounded) and by induction.

use crate::in_parallel::in_parallel;
use crate::mutant::{Mutant, is_verilog};
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// What to check.
#[derive(Debug, Args)]
pub struct Options {
    /// Only this module, for example dda_line
    #[arg(long)]
    module: Option<String>,
    /// Instead, change the Verilog in small ways and demand a counterexample for each change
    #[arg(long)]
    mutants: bool,
    /// The folder of the Verilog files
    #[arg(long, default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/../hwmodel/rtl"))]
    rtl: PathBuf,
    /// The folder for what the tools leave
    #[arg(long, default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/rtl-formal"))]
    build: PathBuf,
}

impl Options {
    fn is_asked(&self, module: &str) -> bool {
        self.module.as_ref().is_none_or(|asked| asked == module)
    }
}

/// The modules with properties.
const MODULES: [&str; 15] = [
    "dda_line",
    "dda_arc",
    "dda_centred_arc",
    "ppc_line",
    "ppc_arc",
    "brm_line",
    "minimum_deviation_line",
    "comparison_line",
    "comparison_arc",
    "minimum_deviation_arc",
    "parabola_ppc",
    "step_dir",
    "command_fifo",
    "pulse_source",
    "interpolator",
];

/// The register widths that are checked.
const WIDTHS: [u32; 3] = [NARROWEST, 24, 32];

/// Where every property is asked for, and mutants are looked for: those of wide sums hold for narrow
/// registers alone, as a solver takes minutes for wide ones.
const NARROWEST: u32 = 8;

/// Steps from reset, and steps of the induction. One step of induction is all that an invariant
/// needs; in the interpolator a pulse takes some clocks from the tick to its axis' slot.
const DEPTH: u32 = 8;

/// The module whose properties must show the mutant, and the mutant.
const fn mutant(
    module: &'static str,
    file: &'static str,
    from: &'static str,
    to: &'static str,
) -> (&'static str, Mutant) {
    (module, Mutant::new(file, from, to))
}

/// What each property is there to find.
const MUTANTS: &[(&str, Mutant)] = &[
    mutant(
        "dda_line",
        "integrator.v",
        "{1'b0, o_jr} + {1'b0, i_jv};",
        "{1'b0, o_jr} + {1'b0, i_jv} + 1'b1;",
    ),
    mutant("dda_line", "integrator.v", "o_carry = sum[N]", "o_carry = sum[N-1]"),
    mutant("dda_line", "dda_line.v", "run = i_en & ~o_done", "run = i_en"),
    mutant("dda_arc", "dda_arc.v", "o_sumx[N] & ~o_stands_x", "o_sumx[N]"),
    mutant("dda_arc", "sweep.v", "o_jey <= o_jey + count_y;", "o_jey <= o_jey;"),
    mutant("dda_arc", "sweep.v", "o_feeds_nx ^ o_towards_is_y", "o_feeds_nx ^ ~o_towards_is_y"),
    mutant("dda_centred_arc", "dda_centred_arc.v", "is_y ? o_jry : o_jrx", "o_jrx"),
    mutant(
        "dda_centred_arc",
        "dda_centred_arc.v",
        "o_stepping_out ? o_nx : o_sum[N+1]",
        "o_sum[N+1]",
    ),
    mutant("ppc_line", "ppc_line.v", "(~o_f[N] & ~x_done) | y_done", "~o_f[N]"),
    mutant("ppc_line", "ppc_line.v", "o_f <= o_f + change;", "o_f <= o_f - change;"),
    mutant("ppc_arc", "ppc_arc.v", "shrinks ? FEED : UPDATE", "UPDATE"),
    mutant("ppc_arc", "ppc_arc.v", "~o_f[N+1] & ~towards_stands", "~o_f[N+1]"),
    mutant("brm_line", "brm_line.v", "next & ~{1'b0, o_divider}", "next"),
    mutant(
        "minimum_deviation_line",
        "minimum_deviation_line.v",
        "is_due = ~d[N+1];",
        "is_due = ~d[N+1] & d != 0;",
    ),
    mutant(
        "minimum_deviation_line",
        "minimum_deviation_line.v",
        "{{N{1'b0}}, is_due};",
        "{{N{1'b0}}, ~is_due};",
    ),
    mutant(
        "minimum_deviation_line",
        "minimum_deviation_line.v",
        "run = i_en & ~o_done",
        "run = i_en",
    ),
    mutant("comparison_line", "comparison_line.v", "o_d[N+1] | o_d == 0", "o_d[N+1]"),
    mutant("comparison_line", "comparison_line.v", "o_jex == 0 & o_jey", "o_jey"),
    mutant("comparison_line", "comparison_line.v", "+ later_x - later_y", "+ later_x"),
    mutant("comparison_arc", "comparison_arc.v", "= level[N+2]", "= ahead[N+2]"),
    mutant("comparison_arc", "walk.v", "o_towards_is_y ^ crosses", "o_towards_is_y"),
    mutant("comparison_arc", "walk.v", "~o_stands_x & (o_stands_y |", "(o_stands_y |"),
    mutant(
        "minimum_deviation_arc",
        "minimum_deviation_arc.v",
        "level - {3'b000, towards} + 1'b1",
        "level - {3'b000, towards}",
    ),
    mutant("minimum_deviation_arc", "walk.v", " + (change_y & {(N+2){moves_y}})", ""),
    mutant("parabola_ppc", "parabola_ppc.v", "~o_f[N+1] & ~stands_along", "~o_f[N+1]"),
    mutant("parabola_ppc", "parabola_ppc.v", ") | stands_across;", ");"),
    mutant("parabola_ppc", "parabola_ppc.v", "{1'b0, o_v, 1'b1}", "{1'b0, o_v, 1'b0}"),
    mutant("parabola_ppc", "parabola_ppc.v", "{{(N+1){1'b0}}, along};", "{(N+2){1'b0}};"),
    mutant("parabola_ppc", "parabola_ppc.v", "along == o_axis_is_y", "~along == o_axis_is_y"),
    mutant(
        "parabola_ppc",
        "parabola_ppc.v",
        "run           = i_en & ~o_done",
        "run           = i_en",
    ),
    mutant("step_dir", "step_dir.v", "o_step ? i_space : i_length", "i_space"),
    mutant("step_dir", "step_dir.v", "o_step ? i_hold : i_setup", "i_setup"),
    mutant("step_dir", "step_dir.v", "waits & agrees & timer_is_out", "waits & agrees"),
    mutant("step_dir", "step_dir.v", "(~o_turned | guard_is_out)", "1'b1"),
    mutant("step_dir", "step_dir.v", "waits & ~agrees & guard_is_out", "waits & ~agrees"),
    mutant("step_dir", "step_dir.v", "clocks - 1'b1", "clocks - 2'd2"),
    mutant("step_dir", "step_dir.v", "clocks == 0 ? {T{1'b0}} : clocks", "clocks"),
    mutant("step_dir", "step_dir.v", "else if (rises)", "else if (falls)"),
    mutant("step_dir", "step_dir.v", "if (o_ready) begin", "if (o_ready | rises) begin"),
    mutant("step_dir", "step_dir.v", "if (i_pulse) o_want", "if (i_pulse & o_idle) o_want"),
    mutant("step_dir", "step_dir.v", "waits & agrees &", "waits & agrees & ~i_pulse &"),
    mutant("command_fifo", "command_fifo.v", "put  = i_valid & o_ready", "put  = i_valid"),
    mutant("command_fifo", "command_fifo.v", "take = o_valid & i_ready", "take = i_ready"),
    mutant("command_fifo", "command_fifo.v", "same_place & ~same_round", "same_place"),
    mutant("command_fifo", "command_fifo.v", "if (take) o_read", "if (take & ~put) o_read"),
    mutant(
        "command_fifo",
        "command_fifo.v",
        "o_data  = entries[o_read",
        "o_data  = entries[~o_read",
    ),
    mutant("interpolator", "interpolator.v", "o_running & &stage_ready", "o_running"),
    mutant("interpolator", "interpolator.v", "o_done = ~o_running &", "o_done ="),
    mutant("interpolator", "command_decoder.v", "& o_error == NONE", ""),
    mutant("pulse_source", "pulse_source.v", "o_due & i_ready", "o_due"),
    mutant("pulse_source", "pulse_source.v", "[P-1:0] TWO = 2", "[P-1:0] TWO = 1"),
    mutant("pulse_source", "pulse_source.v", "else if (o_count == 0)", "else if (o_count[0] == 0)"),
];

/// Runs the checks that are asked for.
///
/// # Errors
/// A tool that cannot run, an assert that fails (with the file and line), or a mutant without a
/// counterexample.
pub fn run(options: &Options) -> Result<(), String> {
    if options.mutants {
        return mutants(options);
    }
    let modules = MODULES.iter().filter(|module| options.is_asked(module));
    let jobs: Vec<_> = modules.flat_map(|module| WIDTHS.map(|bits| (*module, bits))).collect();
    if jobs.is_empty() {
        return Err("there are no properties of that module".to_owned());
    }
    in_parallel(&jobs, |&(module, bits)| {
        let begun = Instant::now();
        let folder = options.build.join(format!("{module}_{bits}"));
        match check(&options.rtl, &folder, module, bits)? {
            None => {
                let seconds = begun.elapsed().as_secs_f64();
                println!("{module:16} {bits:2} bits: holds, by induction, {seconds:.1} s");
                Ok(())
            }
            Some(failed) => Err(format!("{module} of {bits} bits: {failed}")),
        }
    })
}

fn mutants(options: &Options) -> Result<(), String> {
    let asked = MUTANTS.iter().filter(|(module, _)| options.is_asked(module));
    let jobs: Vec<_> = asked.enumerate().collect();
    in_parallel(&jobs, |(number, (module, mutant))| {
        let folder = options.build.join(format!("mutant_{number}"));
        mutant.copy(&options.rtl, &folder)?;
        let name = mutant.name();
        match check(&folder, &folder, module, NARROWEST)? {
            Some(failed) => {
                println!("mutant {name}\n    found: {failed}");
                Ok(())
            }
            None => Err(format!("the properties hold for the mutant {name}")),
        }
    })?;
    println!("{} mutants, all found", jobs.len());
    Ok(())
}

/// Checks one module at one width; the assert that fails, if one does.
fn check(rtl: &Path, build: &Path, module: &str, bits: u32) -> Result<Option<String>, String> {
    fs::create_dir_all(build).map_err(|e| format!("{}: {e}", build.display()))?;
    let model = build.join(format!("{module}.smt2"));
    let mut files = Vec::new();
    for entry in fs::read_dir(rtl).map_err(|e| format!("{}: {e}", rtl.display()))? {
        let path = entry.map_err(|e| e.to_string())?.path();
        if is_verilog(&path) {
            files.push(path.display().to_string());
        }
    }
    files.sort();
    let script = format!(
        "read_verilog -formal {} {}/formal/{module}_props.v; chparam -set N {bits} {module}_props; \
         prep -top {module}_props; flatten; check -assert; write_smt2 -wires {}",
        files.join(" "),
        rtl.display(),
        model.display()
    );
    let said = run_tool("yosys", &["-q", "-p", &script])?;
    if let Err(output) = said {
        return Err(format!("yosys: {output}"));
    }
    let depth = DEPTH.to_string();
    let model = model.display().to_string();
    for induction in [&[][..], &["-i"][..]] {
        let mut arguments = vec!["-s", "yices", "-t", &depth];
        arguments.extend(induction);
        arguments.push(&model);
        if let Err(output) = run_tool("yosys-smtbmc", &arguments)? {
            let failed = output.lines().find_map(|line| line.split_once("Assert failed in "));
            return match failed {
                Some((_, failed)) => Ok(Some(failed.to_owned())),
                None => Err(format!("yosys-smtbmc: {output}")),
            };
        }
    }
    Ok(None)
}

/// Runs a tool: what it printed, as an error if it failed.
fn run_tool(tool: &str, arguments: &[&str]) -> Result<Result<String, String>, String> {
    let output = Command::new(tool)
        .args(arguments)
        .output()
        .map_err(|e| format!("{tool}: {e} (run tools/install-rtl-tools)"))?;
    let mut text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.push_str(&String::from_utf8_lossy(&output.stderr));
    Ok(if output.status.success() { Ok(text) } else { Err(text) })
}
