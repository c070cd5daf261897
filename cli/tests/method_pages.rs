//! The pages of `docs/methods` say what the program prints.
//!
//! A line such as "`onepulse table line --to 5,3 --format md` prints" stands over a table or a block of
//! text, or "draws" over a picture: both are held against the program. With `ONEPULSE_REMAKE=1` in
//! the environment they are written anew.
#![allow(clippy::unwrap_used)]

use assert_cmd::cargo::cargo_bin_cmd;
use std::fs;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/methods")
}

/// What the program prints for a command such as `onepulse table …`.
fn printed(command: &str) -> String {
    let arguments = command.strip_prefix("onepulse ").unwrap().split_whitespace();
    let root = folder().join("../..");
    let output = cargo_bin_cmd!("onepulse").current_dir(root).args(arguments).output().unwrap();
    assert!(output.status.success(), "{command}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The command of a line that announces an output of this kind.
fn announced<'a>(line: &'a str, kind: &str) -> Option<&'a str> {
    let rest = line.strip_prefix('`').filter(|rest| rest.starts_with("onepulse "))?;
    rest.strip_suffix(kind)?.strip_suffix("` ")
}

/// The page as it should be, and how many outputs it has.
fn remade(page: &str) -> (String, usize) {
    let mut lines = page.lines().peekable();
    let (mut text, mut outputs) = (String::new(), 0);
    let mut push = |line: &str| {
        text.push_str(line);
        text.push('\n');
    };
    while let Some(line) = lines.next() {
        push(line);
        if let Some(command) = announced(line, "prints") {
            outputs += 1;
            push(lines.next_if_eq(&"").unwrap());
            let fence = lines.next_if_eq(&"```text");
            // A table ends with an empty line; text in a fence may have some.
            let last = if fence.is_some() { "```" } else { "" };
            while lines.next_if(|line| *line != last).is_some() {}
            if let Some(fence) = fence {
                push(fence);
            }
            printed(command).lines().for_each(&mut push);
            if fence.is_some() {
                push(lines.next_if_eq(&"```").unwrap());
            }
        }
        if let Some(command) = announced(line, "draws") {
            outputs += 1;
            push(lines.next_if_eq(&"").unwrap());
            let image = lines.next().unwrap();
            push(image);
            let name = image.split_once("](").unwrap().1.strip_suffix(')').unwrap();
            held(&folder().join(name), &printed(command));
        }
    }
    (text, outputs)
}

/// Holds a file against what it should be, or makes it so.
fn held(path: &Path, text: &str) {
    if std::env::var_os("ONEPULSE_REMAKE").is_some() {
        fs::write(path, text).unwrap();
    }
    let found = fs::read_to_string(path).unwrap_or_default();
    assert!(found == text, "{}: not what the program prints", path.display());
}

#[test]
fn the_pages_say_what_the_program_prints() {
    let mut pages = 0;
    for entry in fs::read_dir(folder()).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "md") {
            pages += 1;
            let page = fs::read_to_string(&path).unwrap();
            let (text, outputs) = remade(&page);
            assert!(outputs > 0, "{}: shows nothing", path.display());
            held(&path, &text);
        }
    }
    assert!(pages > 0);
}
