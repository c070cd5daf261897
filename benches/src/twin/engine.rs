//! Building simulators.

use super::{Simulator, Twin};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What a twin runs under.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// Verilator, without waves.
    Verilator,
    /// Verilator, writing a VCD file.
    VerilatorVcd,
    /// Verilator, writing an FST file.
    VerilatorFst,
    /// Yosys' CXXRTL, without waves.
    Cxxrtl,
}

const RTL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../hwmodel/rtl");
const CPP: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/cpp");

/// For the compiler; Verilator's makefile by itself optimises little, and its library less.
const TUNED: &str = "-O3 -march=native -flto";

impl Engine {
    /// The name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Verilator => "Verilator",
            Self::VerilatorVcd => "Verilator VCD",
            Self::VerilatorFst => "Verilator FST",
            Self::Cxxrtl => "CXXRTL",
        }
    }

    /// Builds the twin's simulator in a folder below `build` and starts it. What is there already
    /// and up to date is not built again.
    ///
    /// Without a wave it is the module as it is, with all its ports, as anybody would simulate it;
    /// with one there is a wrapper, for the same signals to be traced on both sides. Either way the
    /// command comes from the C++ program: tied to constants, it would let the simulator fold
    /// half of the module.
    ///
    /// # Errors
    /// A program that is missing, with the package to install; one that fails, with its words.
    pub fn simulator(self, twin: &Twin, build: &Path) -> Result<Simulator, String> {
        let folder = build.join(format!("{}-{self:?}", twin.module));
        fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        write(&folder.join("command.h"), &twin.command_header(self))?;
        match self {
            Self::Cxxrtl => cxxrtl(twin, &folder)?,
            Self::Verilator => verilator(twin, &folder, None)?,
            Self::VerilatorVcd => verilator(twin, &folder, Some("--trace"))?,
            Self::VerilatorFst => verilator(twin, &folder, Some("--trace-fst"))?,
        }
        Simulator::start(&folder.join("Vonepulse"))
    }
}

impl Twin {
    /// The macro `COMMAND`, which puts the command at the inputs of a simulated module.
    fn command_header(&self, engine: Engine) -> String {
        let mut text = "#define COMMAND(top)".to_owned();
        for (port, value) in &self.command {
            text += &match engine {
                Engine::Cxxrtl => {
                    format!(" top.p_{}.set<uint64_t>({value}u);", port.replace('_', "__"))
                }
                _ => format!(" top.{port} = {value}u;"),
            };
        }
        text + "\n"
    }
}

/// Writes a file, unless it has that text already: then it would only be compiled again.
fn write(file: &Path, text: &str) -> Result<(), String> {
    if fs::read_to_string(file).is_ok_and(|before| before == text) {
        return Ok(());
    }
    fs::write(file, text).map_err(|e| format!("{}: {e}", file.display()))
}

fn verilator(twin: &Twin, folder: &Path, trace: Option<&str>) -> Result<(), String> {
    let mut command = Command::new("verilator");
    command.args(["--cc", "--exe", "--build", "--prefix", "Vonepulse", "-y", RTL]);
    // Lint is a check of its own; the wrapper leaves outputs open and inputs too wide.
    command.args(["-Wno-lint", "-Wno-fatal", "-O3", "--noassert"]);
    command.args(["--x-assign", "fast", "--x-initial", "fast", "--trace-depth", "1"]).args(trace);
    command.args(["-CFLAGS", TUNED, "-LDFLAGS", TUNED, "-MAKEFLAGS"]);
    command.arg(format!("OPT_FAST='{TUNED}' OPT_SLOW='{TUNED}' OPT_GLOBAL='{TUNED}'"));
    command.arg("--Mdir").arg(folder);
    if trace.is_some() {
        let wrapper = folder.join("onepulse.v");
        write(&wrapper, &twin.wrapper())?;
        command.args(["--top-module", "onepulse"]).arg(wrapper);
    } else {
        command.args(["--top-module", twin.module]).arg(source(twin));
        command.args(twin.parameters.iter().map(|(name, value)| format!("-G{name}={value}")));
    }
    command.arg(Path::new(CPP).join("verilator.cpp"));
    succeed(command, "verilator")
}

fn source(twin: &Twin) -> PathBuf {
    Path::new(RTL).join(format!("{}.v", twin.module))
}

fn cxxrtl(twin: &Twin, folder: &Path) -> Result<(), String> {
    let mut yosys = Command::new("yosys");
    let parameters: String =
        (twin.parameters.iter()).map(|(name, value)| format!(" -chparam {name} {value}")).collect();
    yosys.arg("-q").arg("-p").arg(format!(
        "read_verilog {}; hierarchy -libdir {RTL} -top {}{parameters}; rename -top onepulse; \
         write_cxxrtl -O6 -g0 {}",
        source(twin).display(),
        twin.module,
        folder.join("onepulse.cc").display()
    ));
    succeed(yosys, "yosys")?;
    let mut include = Command::new("yosys-config");
    let include = include
        .args(["--datdir/include"])
        .output()
        .map_err(|e| format!("yosys-config: {e} (Debian package yosys-dev)"))?;
    let include = String::from_utf8_lossy(&include.stdout);
    let mut compiler = Command::new("g++");
    compiler.args(["-std=c++14", "-O3", "-march=native", "-DNDEBUG", "-w"]);
    compiler.arg("-I").arg(include.trim()).arg("-I").arg(folder).arg("-o");
    compiler.arg(folder.join("Vonepulse")).arg(Path::new(CPP).join("cxxrtl.cpp"));
    succeed(compiler, "g++")
}

fn succeed(mut command: Command, package: &str) -> Result<(), String> {
    let output = command.output().map_err(|e| {
        format!("{package}: {e}; it is the peer, install the Debian package {package}")
    })?;
    if output.status.success() {
        return Ok(());
    }
    let said = String::from_utf8_lossy(&output.stderr);
    Err(format!("{command:?} failed:\n{said}"))
}
