//! The harnesses' WebAssembly module: which harnesses there are, and what each may reach.

use super::Error;
use super::data::Data;
use std::collections::{BTreeMap, BTreeSet};
use wasmparser::{DataKind, ElementItems, ExternalKind, Operator, Parser, Payload, TypeRef};

/// What the module tells of the harnesses.
#[derive(Debug)]
pub(crate) struct Module {
    pub(crate) harnesses: Vec<Harness>,
    /// All covers, in the order in which the glue numbers them.
    pub(crate) covers: Vec<Cover>,
    pub(crate) data: Data,
    /// The size of the table of functions, 0 without one.
    pub(crate) table: u64,
}

/// One harness: an export `proof:NAME`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Harness {
    pub(crate) name: String,
    /// The note `unwind:NAME:n`.
    pub(crate) unwind: Option<u32>,
    /// The note `solver:NAME:solver`.
    pub(crate) solver: Option<String>,
    /// Indices of the covers that it may reach.
    pub(crate) covers: BTreeSet<usize>,
    /// Calls of `assume` in what it may reach.
    pub(crate) assumes: usize,
}

/// One `kani::cover!`, told apart by its file and line.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Cover {
    /// Address of the file's name.
    pub(crate) file: u32,
    /// Length of the file's name.
    pub(crate) length: u32,
    pub(crate) line: u32,
}

/// What a function calls.
#[derive(Default)]
struct Calls {
    functions: BTreeSet<u32>,
    covers: BTreeSet<Cover>,
    assumes: usize,
    is_indirect: bool,
}

/// The imports with a meaning here.
#[derive(Default)]
struct Imports {
    count: u32,
    cover: Option<u32>,
    assume: Option<u32>,
}

impl Module {
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, Error> {
        let mut imports = Imports::default();
        let mut exports = BTreeMap::new();
        let mut calls = Vec::new();
        let mut in_table = BTreeSet::new();
        let mut table = 0;
        let mut data = Data::default();
        for payload in Parser::new(0).parse_all(bytes) {
            match payload? {
                Payload::ImportSection(section) => {
                    for import in section.into_imports() {
                        let import = import?;
                        if !matches!(import.ty, TypeRef::Func(_)) || import.module != "kani" {
                            let name = format!("{}.{}", import.module, import.name);
                            return Err(Error::Module(format!("nothing is known of {name}")));
                        }
                        imports.add(import.name)?;
                    }
                }
                Payload::ExportSection(section) => {
                    for export in section {
                        let export = export?;
                        if export.kind == ExternalKind::Func {
                            exports.insert(export.name.to_owned(), export.index);
                        }
                    }
                }
                Payload::TableSection(section) => {
                    for declared in section {
                        table += declared?.ty.initial;
                    }
                }
                Payload::ElementSection(section) => {
                    for element in section {
                        if let ElementItems::Functions(functions) = element?.items {
                            for function in functions {
                                in_table.insert(function?);
                            }
                        }
                    }
                }
                Payload::CodeSectionEntry(body) => {
                    calls.push(Calls::read(&body, &imports)?);
                }
                Payload::DataSection(section) => {
                    for segment in section {
                        let segment = segment?;
                        data.add(offset_of(&segment.kind)?, segment.data)?;
                    }
                }
                _ => {}
            }
        }
        let covers: Vec<Cover> = calls
            .iter()
            .flat_map(|calls| calls.covers.iter().cloned())
            .collect::<BTreeSet<_>>()
            .into_iter()
            .collect();
        let mut harnesses = Vec::new();
        for (export, function) in &exports {
            let Some(name) = export.strip_prefix("proof:") else { continue };
            let reached = reachable(*function, &imports, &calls, &in_table);
            let reached: Vec<&Calls> = reached
                .iter()
                .filter_map(|index| calls.get(index.checked_sub(imports.count)? as usize))
                .collect();
            let is_met = |cover: &&Cover| reached.iter().any(|calls| calls.covers.contains(*cover));
            let note = |what: &str| {
                let prefix = format!("{what}:{name}:");
                exports.keys().find_map(|export| export.strip_prefix(&prefix)).map(str::to_owned)
            };
            let unwind = match note("unwind") {
                None => None,
                Some(number) => Some(number.parse().map_err(|_| {
                    Error::Module(format!("{name}: unwind({number}) is not a number"))
                })?),
            };
            harnesses.push(Harness {
                name: name.to_owned(),
                unwind,
                solver: note("solver"),
                covers: covers
                    .iter()
                    .enumerate()
                    .filter(|(_, cover)| is_met(cover))
                    .map(|(index, _)| index)
                    .collect(),
                assumes: reached.iter().map(|calls| calls.assumes).sum(),
            });
        }
        Ok(Self { harnesses, covers, data, table })
    }

    /// The cover as a reader finds it, `file:line`.
    pub(crate) fn cover_text(&self, index: usize) -> String {
        let Some(cover) = self.covers.get(index) else { return format!("cover {index}") };
        let file = self.data.text(cover.file, cover.length);
        format!("{}:{}", file.unwrap_or_else(|| format!("file at {}", cover.file)), cover.line)
    }
}

impl Imports {
    fn add(&mut self, name: &str) -> Result<(), Error> {
        match name {
            "cover" => self.cover = Some(self.count),
            "assume" => self.assume = Some(self.count),
            "any32" | "any64" | "fail" => {}
            other => return Err(Error::Module(format!("nothing is known of kani.{other}"))),
        }
        self.count += 1;
        Ok(())
    }
}

impl Calls {
    fn read(body: &wasmparser::FunctionBody<'_>, imports: &Imports) -> Result<Self, Error> {
        let mut calls = Self::default();
        // The constants just before, the last one first; None for anything else.
        let mut before = [None; 3];
        for operator in body.get_operators_reader()? {
            let mut constant = None;
            match operator? {
                Operator::I32Const { value } => constant = Some(value as u32),
                Operator::Call { function_index } => {
                    calls.functions.insert(function_index);
                    if Some(function_index) == imports.cover {
                        let [Some(line), Some(length), Some(file)] = before else {
                            let why = "a cover's file and line are not constants: two covers may \
                                have been merged, write them apart";
                            return Err(Error::Module(why.to_owned()));
                        };
                        calls.covers.insert(Cover { file, length, line });
                    }
                    calls.assumes += usize::from(Some(function_index) == imports.assume);
                }
                Operator::CallIndirect { .. } => calls.is_indirect = true,
                _ => {}
            }
            before = [constant, before[0], before[1]];
        }
        Ok(calls)
    }
}

/// All functions that may run when one is called. What is called indirectly may be any function of
/// the table.
fn reachable(
    from: u32,
    imports: &Imports,
    calls: &[Calls],
    in_table: &BTreeSet<u32>,
) -> BTreeSet<u32> {
    let mut reached = BTreeSet::new();
    let mut left = vec![from];
    while let Some(function) = left.pop() {
        if !reached.insert(function) {
            continue;
        }
        let own = function.checked_sub(imports.count).and_then(|index| calls.get(index as usize));
        if let Some(own) = own {
            left.extend(&own.functions);
            if own.is_indirect {
                left.extend(in_table);
            }
        }
    }
    reached
}

fn offset_of(kind: &DataKind<'_>) -> Result<u32, Error> {
    if let DataKind::Active { memory_index: 0, offset_expr } = kind {
        if let Ok(Operator::I32Const { value }) = offset_expr.get_operators_reader().read() {
            return Ok(value as u32);
        }
    }
    Err(Error::Module("data that are not at a constant place in memory 0".to_owned()))
}

#[cfg(test)]
mod tests;
