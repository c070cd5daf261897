//! Arcs by the methods that move both axes in a step.

use super::Language;
use super::steps::{Steps, against_zero, fed, standing};
use onepulse_core::{Axis, Pulse, Walk, comparison, minimum_deviation, vector};

/// An arc on which F = x² + y² − R² decides, and how.
trait Judges: Iterator<Item = Pulse> + Copy {
    fn place(&self) -> &Walk;

    /// What F is held against, while neither axis stands.
    fn freely_judged(&self, step: u64) -> String;
}

impl Judges for minimum_deviation::Arc {
    fn place(&self) -> &Walk {
        self.walk()
    }

    fn freely_judged(&self, _: u64) -> String {
        candidates(self.walk())
    }
}

impl Judges for vector::Arc {
    fn place(&self) -> &Walk {
        self.walk()
    }

    fn freely_judged(&self, step: u64) -> String {
        let [x, y] = self.walk().position().map(i64::abs);
        let octant = match x.cmp(&y) {
            std::cmp::Ordering::Less => "|x| < |y|",
            std::cmp::Ordering::Equal => "|x| = |y|",
            std::cmp::Ordering::Greater => "|x| > |y|",
        };
        format!("{}, {octant}", against_zero("F", step, self.walk().deviation_function()))
    }
}

impl Judges for comparison::Arc {
    fn place(&self) -> &Walk {
        self.walk()
    }

    fn freely_judged(&self, step: u64) -> String {
        let (f, level) = (
            self.walk().deviation_function(),
            comparison::Interval::level(self.walk().magnitudes()),
        );
        let sign = match f.cmp(&level) {
            std::cmp::Ordering::Less => "<",
            std::cmp::Ordering::Equal => "=",
            std::cmp::Ordering::Greater => ">",
        };
        // The coordinate that shrinks, less the one that grows, less 1.
        let axis = |axis: Axis| if axis == Axis::X { "|x|" } else { "|y|" };
        let feeds = self.walk().sweep().feeds();
        let [towards, away] = [feeds.towards, feeds.away].map(|feed| axis(feed.axis));
        format!("F{step} = {f} {sign} {towards} - {away} - 1 = {level}")
    }
}

/// The steps in question, with the F that each leads to.
fn candidates(walk: &Walk) -> String {
    let feeds = walk.sweep().feeds();
    let single = [feeds.towards, feeds.away].map(|feed| Pulse::on(feed.axis, feed.sign));
    let [Pulse([x, y]), Pulse([other_x, other_y])] = single;
    let candidates = [single[0], single[1], Pulse([x + other_x, y + other_y])];
    let position = walk.position();
    let candidate = |pulse: Pulse| {
        let change = |axis: usize| match i64::from(pulse.0[axis]) {
            0 => 0,
            sign => 2 * sign * position[axis] + 1,
        };
        format!("{}: F = {}", fed(pulse), walk.deviation_function() + change(0) + change(1))
    };
    candidates.map(candidate).join(", ")
}

impl<M: Judges> Steps<2> for M {
    fn first(&self) -> String {
        "F0 = 0".into()
    }

    fn judged(&self, step: u64, language: Language) -> String {
        let walk = self.place();
        if walk.is_free() {
            return self.freely_judged(step);
        }
        let f = walk.deviation_function();
        format!("F{step} = {f}, {}", standing(walk.sweep().stands(walk.position()), language))
    }

    fn updated(&self, before: &Self, step: u64) -> String {
        let (from, to) = (before.place(), self.place());
        let (position, moved) = (from.position(), to.position());
        let (mut formula, mut numbers) = (String::new(), String::new());
        for (axis, name) in ["x", "y"].into_iter().enumerate() {
            if moved[axis] != position[axis] {
                // A pulse towards zero takes 2c − 1 from F, one away from it adds 2c + 1.
                let c = position[axis].abs();
                let sign = if moved[axis].abs() > c { '+' } else { '-' };
                formula += &format!(" {sign} 2|{name}| + 1");
                numbers += &format!(" {sign} {} + 1", 2 * c);
            }
        }
        let (f, after) = (from.deviation_function(), to.deviation_function());
        format!("F{step} = F{}{formula} = {f}{numbers} = {after}", step - 1)
    }

    fn position(&self) -> [i64; 2] {
        self.place().position()
    }

    fn to_go(&self) -> [u64; 2] {
        self.place().residual().map(i64::unsigned_abs)
    }
}
