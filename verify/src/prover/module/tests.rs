use super::super::data::Location;
use super::{Cover, Module};
use std::collections::BTreeSet;

/// Two harnesses, a function that both call, one that only the second calls, and one through the
/// table.
const MODULE: &str = r#"(module
    (import "kani" "any32" (func $any (result i32)))
    (import "kani" "assume" (func $assume (param i32)))
    (import "kani" "cover" (func $cover (param i32 i32 i32 i32)))
    (import "kani" "fail" (func $fail (param i32)))
    (memory 1)
    (table 1 funcref)
    (elem (i32.const 0) $pointed)
    (type $plain (func))
    (func $shared (call $assume (call $any)) (call $fail (i32.const 2056)))
    (func $deep
        (call $cover (call $any) (i32.const 2048) (i32.const 6) (i32.const 40))
        (call_indirect (type $plain) (i32.const 0)))
    (func $pointed (call $assume (i32.const 1)))
    (func (export "proof:first")
        (call $cover (call $any) (i32.const 2048) (i32.const 6) (i32.const 7))
        (call $shared))
    (func (export "proof:second") (call $shared) (call $deep))
    (func (export "unwind:first:9"))
    (func (export "solver:second:cadical"))
    (data (i32.const 2048) "src.rs\00\00\00\08\00\00\06\00\00\00\2a\00\00\00\05\00\00\00"))"#;

fn read(text: &str) -> Result<Module, super::Error> {
    Module::read(&wat::parse_str(text).unwrap())
}

#[test]
fn what_a_harness_may_reach() {
    let module = read(MODULE).unwrap();
    let at = |line| Cover { file: 2048, length: 6, line };
    assert_eq!(module.covers, [at(7), at(40)]);
    let [first, second] = &module.harnesses[..] else { panic!("two harnesses") };
    assert_eq!((first.name.as_str(), first.unwind, first.assumes), ("first", Some(9), 1));
    assert_eq!(first.covers, BTreeSet::from([0]));
    assert_eq!((second.name.as_str(), second.assumes), ("second", 2));
    assert_eq!(second.solver.as_deref(), Some("cadical"));
    assert_eq!(second.covers, BTreeSet::from([1]));
    assert_eq!(module.cover_text(1), "src.rs:40");
    assert_eq!(module.table, 1);
}

#[test]
fn locations_of_panics() {
    let data = read(MODULE).unwrap().data;
    let expected = Location { file: "src.rs".to_owned(), line: 42, column: 5 };
    assert_eq!(data.location(2056), Some(expected));
    assert_eq!(data.location(0), None);
    assert_eq!(data.location(2064), None);
    assert_eq!(data.location(u32::MAX), None);
}

#[test]
fn modules_without_a_meaning() {
    let merged = MODULE.replace("(i32.const 6) (i32.const 40)", "(i32.const 6) (call $any)");
    assert!(read(&merged).unwrap_err().to_string().contains("merged"));
    let unknown = MODULE.replace("\"any32\"", "\"any128\"");
    assert!(read(&unknown).unwrap_err().to_string().contains("kani.any128"));
    let number = MODULE.replace("unwind:first:9", "unwind:first:many");
    assert!(read(&number).unwrap_err().to_string().contains("many"));
    let low = MODULE.replace("(data (i32.const 2048)", "(data (i32.const 16)");
    assert!(read(&low).unwrap_err().to_string().contains("stack"));
    assert!(Module::read(b"\0asm\x01\0\0\0\xff").is_err());
}
