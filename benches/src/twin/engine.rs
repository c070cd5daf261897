//! Building simulators.

use super::{Simulator, Twin};
use std::fs;
use std::path::Path;
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
    /// # Errors
    /// A program that is missing, with the package to install; one that fails, with its words.
    pub fn simulator(self, twin: &Twin, build: &Path) -> Result<Simulator, String> {
        let folder = build.join(format!("{}-{self:?}", twin.module));
        fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        let wrapper = folder.join("onepulse.v");
        let has_wave = matches!(self, Self::VerilatorVcd | Self::VerilatorFst);
        fs::write(&wrapper, twin.wrapper(has_wave))
            .map_err(|e| format!("{}: {e}", wrapper.display()))?;
        match self {
            Self::Cxxrtl => cxxrtl(&folder)?,
            Self::Verilator => verilator(&folder, None)?,
            Self::VerilatorVcd => verilator(&folder, Some("--trace"))?,
            Self::VerilatorFst => verilator(&folder, Some("--trace-fst"))?,
        }
        Simulator::start(&folder.join("Vonepulse"))
    }
}

fn verilator(folder: &Path, trace: Option<&str>) -> Result<(), String> {
    let mut command = Command::new("verilator");
    command.args(["--cc", "--exe", "--build", "--top-module", "onepulse"]);
    // Lint is a check of its own; the wrapper leaves outputs open and constants unsized.
    command.args(["-Wno-lint", "-Wno-fatal", "-O3", "--noassert"]);
    command.args(["--x-assign", "fast", "--x-initial", "fast", "--trace-depth", "1"]).args(trace);
    command.args(["-CFLAGS", TUNED, "-LDFLAGS", TUNED, "-MAKEFLAGS"]);
    command.arg(format!("OPT_FAST='{TUNED}' OPT_SLOW='{TUNED}' OPT_GLOBAL='{TUNED}'"));
    command.arg("-y").arg(RTL).arg("--Mdir").arg(folder);
    command.arg(folder.join("onepulse.v")).arg(Path::new(CPP).join("verilator.cpp"));
    succeed(command, "verilator")
}

fn cxxrtl(folder: &Path) -> Result<(), String> {
    let (wrapper, model) = (folder.join("onepulse.v"), folder.join("onepulse.cc"));
    let mut yosys = Command::new("yosys");
    yosys.arg("-q").arg("-p").arg(format!(
        "read_verilog {}; hierarchy -libdir {RTL} -top onepulse; write_cxxrtl -O6 -g0 {}",
        wrapper.display(),
        model.display()
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
