//! The path as rows.

use onepulse_core::{Direction, Plane};
use onepulse_plan::centre_path::{CentreMove, Role, Step};
use std::fmt::Write;

/// The columns. Those of Z are there if anything moves out of the plane of X and Y.
pub(super) fn csv(steps: &[Step]) -> String {
    let moves = || {
        steps.iter().filter_map(|step| match step {
            Step::Move(step) if step.from != step.to || step.arc.is_some() => Some(step),
            _ => None,
        })
    };
    let is_flat = moves()
        .all(|step| step.from[2] == step.to[2] && (step.arc.is_none() || step.plane == Plane::Xy));
    let mut text = String::from("kind,x0,y0,x1,y1,cx,cy,line,role");
    text.push_str(if is_flat { "\n" } else { ",z0,z1,cz\n" });
    for step in moves() {
        row(&mut text, step, is_flat);
    }
    text
}

fn row(text: &mut String, step: &CentreMove, is_flat: bool) {
    let CentreMove { from, to, arc, plane, .. } = step;
    let kind = match arc {
        None => "line",
        Some((_, Direction::Cw)) => "cw",
        Some((_, Direction::Ccw)) => "ccw",
    };
    let centre = match arc {
        None => [None; 3],
        Some(([first, second], _)) => plane.place([Some(*first), Some(*second), None]),
    };
    let [cx, cy, cz] = centre.map(|c| c.map_or(String::new(), millimetres));
    let [x0, y0, z0] = from.map(millimetres);
    let [x1, y1, z1] = to.map(millimetres);
    let (line, role) = (step.place.line, role(step.role));
    // Writing into a string cannot fail.
    let _ = write!(text, "{kind},{x0},{y0},{x1},{y1},{cx},{cy},{line},{role}");
    if !is_flat {
        let _ = write!(text, ",{z0},{z1},{cz}");
    }
    text.push('\n');
}

/// Far finer than the path is exact, so that nothing is lost; at least six decimals.
fn millimetres(value: f64) -> String {
    let text = format!("{value:.12}");
    let (shortest, tail) = text.split_at(text.len() - 6);
    let text = format!("{shortest}{}", tail.trim_end_matches('0'));
    // No minus before a zero.
    match text.strip_prefix('-') {
        Some(zero) if zero.bytes().all(|byte| matches!(byte, b'0' | b'.')) => zero.to_owned(),
        _ => text,
    }
}

const fn role(role: Role) -> &'static str {
    match role {
        Role::Rapid => "rapid",
        Role::Feed => "feed",
        Role::Establish => "establish",
        Role::Offset => "offset",
        Role::Corner => "corner",
        Role::Cancel => "cancel",
    }
}
