//! The one C file that the model checker reads: the module as wasm2c writes it, with the memory and
//! the imports of `glue/` put in, and an entry for each harness.

use super::Error;
use super::data::STACK_BYTES;
use super::module::Module;
use std::fmt::Write;

/// What wasm2c includes; to be written beside the source.
pub(crate) const RUNTIME: &str = include_str!("glue/wasm-rt.h");
const MEMORY: &str = include_str!("glue/memory.h");
const ARITHMETIC: &str = include_str!("glue/arithmetic.h");
const ENTRY: &str = include_str!("glue/entry.c");

/// Where the module's own code begins, after the prelude of wasm2c.
const FIRST_OF_MODULE: &str = "static void init_globals(";

/// The entry of a harness.
pub(crate) fn entry(harness: &str) -> String {
    format!("check_{harness}")
}

/// The text of a cover's property.
pub(crate) fn cover_property(index: usize) -> String {
    format!("cover {index}")
}

/// The text of the property that the end of a harness is not reached.
pub(crate) const END: &str = "end";
/// The text of the property that nothing panics.
pub(crate) const PANIC: &str = "panic";
/// The text of the property that nothing traps.
pub(crate) const TRAP: &str = "trap";
/// The text of the property that a cover is one of those found in the module.
pub(crate) const KNOWN_COVER: &str = "known cover";

/// The whole source.
pub(crate) fn source(module: &Module, c: &str) -> Result<String, Error> {
    let (prelude, own) = c
        .split_once(FIRST_OF_MODULE)
        .filter(|(_, rest)| !rest.contains(FIRST_OF_MODULE))
        .ok_or_else(|| Error::Source(format!("no single {FIRST_OF_MODULE}")))?;
    let mut text = String::new();
    definitions(module, &mut text);
    text.push_str(prelude);
    text.push_str(MEMORY);
    text.push_str(ARITHMETIC);
    text.push_str(FIRST_OF_MODULE);
    for line in own.lines() {
        text.push_str(&multiplication(line).unwrap_or_else(|| line.to_owned()));
        text.push('\n');
    }
    text.push_str(ENTRY);
    for harness in &module.harnesses {
        let function = exported(c, &harness.name)?;
        let _ = writeln!(text, "CHECK({}, {function})", entry(&harness.name));
    }
    Ok(text)
}

fn definitions(module: &Module, text: &mut String) {
    // An array of C has an element at least.
    let data = module.data.bytes();
    let (bytes, data) = if data.is_empty() { (1, &[0][..]) } else { (data.len(), data) };
    let _ = writeln!(text, "#define STACK_BYTES {STACK_BYTES}");
    let _ = writeln!(text, "#define DATA_BYTES {bytes}");
    let _ = write!(text, "#define DATA ");
    for byte in data {
        let _ = write!(text, "{byte},");
    }
    let _ = writeln!(text, "\n#define TABLE_ELEMENTS {}", module.table.max(1));
    let _ = write!(text, "#define CHECK_COVERS ");
    for (index, cover) in module.covers.iter().enumerate() {
        let _ = write!(
            text,
            "CHECK_COVER({}, {}, \"{}\") ",
            cover.file,
            cover.line,
            cover_property(index)
        );
    }
    text.push('\n');
}

/// `a *= b;` as a call: see glue/arithmetic.h.
fn multiplication(line: &str) -> Option<String> {
    let (left, right) = line.trim_end().strip_suffix(';')?.split_once(" *= ")?;
    let bits = match left.trim_start().get(..5)? {
        "var_i" => 32,
        "var_j" => 64,
        _ => return None,
    };
    Some(format!("{left} = times_{bits}({}, {right});", left.trim_start()))
}

/// The C function of an exported harness: the one below the comment that names the export.
fn exported<'c>(c: &'c str, harness: &str) -> Result<&'c str, Error> {
    let comment = format!("/* export: 'proof:{harness}' */\nvoid ");
    c.split_once(&comment)
        .and_then(|(_, rest)| rest.split_once('('))
        .map(|(function, _)| function)
        .ok_or_else(|| Error::Source(format!("no function of the harness {harness}")))
}
