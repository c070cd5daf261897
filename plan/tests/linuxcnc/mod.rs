//! LinuxCNC's interpreter, `rs274`: it prints the moves that it would send to the machine.

use onepulse_core::Direction;
use std::io::Write as _;
use std::process::{Command, Stdio};

/// A move to a point, in millimetres with four decimals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Move {
    pub(crate) to: [f64; 2],
    /// The centre and the sense of an arc.
    pub(crate) arc: Option<([f64; 2], Direction)>,
}

/// The moves at feed while the compensation is on, or the reason why there are none.
pub(crate) fn compensated(program: &str) -> Result<Vec<Move>, String> {
    let mut interpreter = Command::new("rs274")
        .args(["-g", "/dev/stdin"])
        // It maps a file of tools there, over which two interpreters at once may stumble.
        .env("HOME", env!("CARGO_TARGET_TMPDIR"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("LinuxCNC's rs274 is needed (Debian package linuxcnc-uspace; tools/install-tools)");
    // The interpreter may end at an error before it has read all.
    let _ = interpreter.stdin.take().unwrap().write_all(program.as_bytes());
    let output = interpreter.wait_with_output().unwrap();
    if !output.status.success() {
        return Err(format!("{}: {}", output.status, String::from_utf8_lossy(&output.stderr)));
    }
    let printed = String::from_utf8(output.stdout).unwrap();
    let is_compensated = |line: &&str| !line.contains("cutter radius compensation off");
    let lines = printed
        .lines()
        .skip_while(|line| !line.contains("cutter radius compensation on"))
        .take_while(is_compensated);
    Ok(lines.filter_map(read).collect())
}

/// A move, from `12 N..... ARC_FEED(23.0000, 0.0000, 20.0000, 0.0000, 1, …)`: the end, the centre, how
/// many turns counter-clockwise.
fn read(line: &str) -> Option<Move> {
    let (before, after) = line.split_once('(')?;
    let numbers =
        after.trim_end_matches(')').split(", ").map(|number| number.parse::<f64>().unwrap());
    match before.split_whitespace().last()? {
        "STRAIGHT_FEED" => {
            let [x, y] = numbers.take(2).collect::<Vec<_>>().try_into().unwrap();
            Some(Move { to: [x, y], arc: None })
        }
        "ARC_FEED" => {
            let [x, y, i, j, turns] = numbers.take(5).collect::<Vec<_>>().try_into().unwrap();
            assert!(turns == 1.0 || turns == -1.0, "{line}");
            let direction = if turns > 0.0 { Direction::Ccw } else { Direction::Cw };
            Some(Move { to: [x, y], arc: Some(([i, j], direction)) })
        }
        _ => None,
    }
}
