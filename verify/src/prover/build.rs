//! From the harnesses' source to a program for the model checker: rustc, wasm2c, goto-cc.

use super::Error;
use super::data::STACK_BYTES;
use super::module::Module;
use super::source::{RUNTIME, source};
use super::tools::{find, output, root};
use std::fs;
use std::path::PathBuf;
use std::process::Command;

/// The harnesses, compiled.
#[derive(Debug)]
pub(crate) struct Program {
    pub(crate) module: Module,
    /// For CBMC.
    pub(crate) goto: PathBuf,
    /// The loops that compare, copy and fill memory byte by byte, as CBMC names them.
    pub(crate) memory_loops: Vec<String>,
    /// Where files may be left.
    pub(crate) folder: PathBuf,
}

/// Compiles the harnesses, or with the feature `wrong` those that are wrong on purpose.
pub(crate) fn build(wrong: bool) -> Result<Program, Error> {
    let target = root().join("target/proof");
    let folder = target.join(if wrong { "wrong" } else { "right" });
    fs::create_dir_all(&folder).map_err(Error::file(&folder))?;

    let mut flags = vec![
        "-C".to_owned(),
        format!("linker={}", find("wasm-ld")?.display()),
        "-C".to_owned(),
        format!("link-arg=-zstack-size={STACK_BYTES}"),
        // The plainest instructions: the fewest that wasm2c and the glue must give a meaning to.
        "-C".to_owned(),
        "target-cpu=mvp".to_owned(),
    ];
    // A call hands its structures over in memory, and memory is what slows the solvers down most.
    // Everything has to be in one function before anything else is done to it: once a choice of two
    // fields has become a choice of two addresses, they stay in memory. So calls are put in by the
    // front end, whose flags for that are not stable, and the rest by the back end.
    for flag in [
        "-Zmir-opt-level=3",
        "-Zinline-mir=yes",
        "-Zinline-mir-threshold=100000",
        "-Zinline-mir-hint-threshold=100000",
        "-Zinline-mir-forwarder-threshold=100000",
        "-Zcross-crate-inline-threshold=always",
        "-Cllvm-args=-inline-threshold=1000000",
    ] {
        flags.push(flag.to_owned());
    }
    // Panics and covers name their files from the repository's root.
    flags.push(format!("--remap-path-prefix={}/=", root().display()));
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo
        .current_dir(root())
        .args(["rustc", "--locked", "--quiet", "--package", "onepulse-proofs", "--lib"])
        .args(["--profile", "proof", "--crate-type", "cdylib"])
        .args(["--target", "wasm32-unknown-unknown", "--target-dir"])
        .arg(&target)
        .env("RUSTC", find("rustc")?)
        .env("RUSTC_BOOTSTRAP", "1")
        .env("RUSTC_WRAPPER", "")
        .env("CARGO_ENCODED_RUSTFLAGS", flags.join("\u{1f}"));
    if wrong {
        cargo.args(["--features", "wrong"]);
    }
    output(&mut cargo)?;

    let built = target.join("wasm32-unknown-unknown/proof/onepulse_proofs.wasm");
    let wasm = folder.join("proofs.wasm");
    fs::copy(&built, &wasm).map_err(Error::file(&built))?;
    let module = Module::read(&fs::read(&wasm).map_err(Error::file(&wasm))?)?;

    let c = folder.join("proofs.c");
    output(Command::new(find("wasm2c")?).arg(&wasm).args(["-n", "proofs", "-o"]).arg(&c))?;
    let text = fs::read_to_string(&c).map_err(Error::file(&c))?;
    let checked = folder.join("checked.c");
    fs::write(&checked, source(&module, &text)?).map_err(Error::file(&checked))?;
    let runtime = folder.join("wasm-rt.h");
    fs::write(&runtime, RUNTIME).map_err(Error::file(&runtime))?;

    let goto = folder.join("proofs.goto");
    output(
        Command::new(find("goto-cc")?).arg("-I").arg(&folder).arg(&checked).arg("-o").arg(&goto),
    )?;
    let loops = output(Command::new(find("cbmc")?).arg("--show-loops").arg(&goto))?;
    Ok(Program { module, goto, memory_loops: memory_loops(&loops), folder })
}

/// Of the lines `Loop FUNCTION.NUMBER:` those of Rust's own memory functions. They run once a byte,
/// which no harness should have to know of.
fn memory_loops(loops: &str) -> Vec<String> {
    let is_memory = |name: &&str| {
        let function = name.rsplit_once('.').map_or(*name, |(function, _)| function);
        let function = function.trim_start_matches("w2c_proofs_");
        ["memcmp", "bcmp", "memcpy", "memmove", "memset"].contains(&function)
    };
    loops
        .lines()
        .filter_map(|line| line.strip_prefix("Loop ")?.strip_suffix(':'))
        .filter(is_memory)
        .map(str::to_owned)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::memory_loops;

    #[test]
    fn loops_over_memory_are_told_from_others() {
        let printed = "\nLoop w2c_proofs_memcmp.0:\n  file checked.c line 9\n\n\
            Loop w2c_proofs_proof0x3Aa_0.1:\n  file\n\nLoop w2c_proofs_memcmp_like.0:\n";
        assert_eq!(memory_loops(printed), ["w2c_proofs_memcmp.0"]);
    }
}
