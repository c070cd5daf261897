//! What the fuzzers have found worth keeping, once more: fuzz/corpus/TARGET, of which tools/fuzz says more.
#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "promises/drawn.rs"]
mod drawn;
mod promises;

use drawn::Case;
use std::fs;
use std::path::Path;

/// Checks every file of a target's corpus. What fails is shown.
fn replay(target: &str, case: fn(&[u8]) -> Option<Case>) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus").join(target);
    let mut count = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if let Some(case) = case(&fs::read(&path).unwrap()) {
            println!("{}:\n{}", path.display(), String::from_utf8_lossy(&case.text));
            case.check();
        }
        count += 1;
    }
    assert!(count >= 50, "of the corpus there are {count} files");
}

#[test]
fn programs() {
    replay("program", Case::program);
}

#[test]
fn paths() {
    replay("path", Case::path);
}
