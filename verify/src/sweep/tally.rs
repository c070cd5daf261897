//! What a work item of a sweep found, and how the findings of several are put together.

use super::curve::{Case, Curve};
use std::fmt;

/// A figure in relation to what bounds it, kept exactly.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Share {
    /// The figure.
    pub part: u64,
    /// The bound, or what it is counted in.
    pub whole: u64,
}

/// A curve that did not do what every curve must.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The curve.
    pub curve: Curve,
    /// The width of the registers; 0 where the method has none.
    pub bits: u32,
    /// What it did.
    pub why: String,
}

/// The figures of many curves.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Curves drawn.
    pub curves: u64,
    /// Their cycles.
    pub cycles: u64,
    /// Cycles of the longest curve, in relation to 2^(n−Q).
    pub longest: Share,
    /// The most cycles in a row without a pulse, in relation to 2^(n−Q).
    pub wait: Share,
    /// Curves whose last pulses came from stepping out, not from the integrators.
    pub stepped_out: u64,
    /// Curves that leave the curve by more than one pulse.
    pub over: u64,
    /// The first of them.
    pub first_over: Option<Case>,
    /// The largest deviation.
    pub worst: Option<Case>,
    /// Curves that did what none may.
    pub faults: u64,
    /// The first of them.
    pub first_fault: Option<Fault>,
}

impl Share {
    /// The larger of two.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        let cross = |a: Self, b: Self| u128::from(a.part) * u128::from(b.whole.max(1));
        if cross(other, self) > cross(self, other) { other } else { self }
    }

    /// To be read.
    #[must_use]
    pub fn ratio(self) -> f64 {
        self.part as f64 / self.whole.max(1) as f64
    }
}

impl Tally {
    /// The largest deviation, in pulses.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.worst.map_or(0.0, |case| case.deviation())
    }

    /// Takes in the extreme points of one curve.
    pub(crate) fn stray(&mut self, cases: &[Case]) {
        for &case in cases {
            if self.worst.is_none_or(|worst| case.deviation() > worst.deviation()) {
                self.worst = Some(case);
            }
        }
        let earliest = cases.iter().filter(|case| case.leaves_one_pulse()).min_by_key(|c| c.cycle);
        if let Some(&case) = earliest {
            self.over += 1;
            self.first_over.get_or_insert(case);
        }
    }

    /// Takes in a curve's fault.
    pub(crate) fn fault(&mut self, curve: Curve, bits: u32, why: String) {
        self.faults += 1;
        // "; " ends a field of the line that is written.
        let why = why.replace("; ", ", ");
        self.first_fault.get_or_insert(Fault { curve, bits, why });
    }

    /// Takes in the findings of a later item.
    pub(crate) fn add(&mut self, later: &Self) {
        self.curves += later.curves;
        self.cycles += later.cycles;
        self.longest = self.longest.max(later.longest);
        self.wait = self.wait.max(later.wait);
        self.stepped_out += later.stepped_out;
        self.over += later.over;
        self.first_over = self.first_over.or(later.first_over);
        if later.deviation() > self.deviation() || self.worst.is_none() {
            self.worst = later.worst;
        }
        self.faults += later.faults;
        if self.first_fault.is_none() {
            self.first_fault.clone_from(&later.first_fault);
        }
    }

    /// Reads what [`Display`](fmt::Display) wrote.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let mut tally = Self::default();
        for field in text.split("; ") {
            let (name, value) = field.split_once(" = ")?;
            match name {
                "curves" => tally.curves = value.parse().ok()?,
                "cycles" => tally.cycles = value.parse().ok()?,
                "longest" => tally.longest = Share::parse(value)?,
                "wait" => tally.wait = Share::parse(value)?,
                "stepped out" => tally.stepped_out = value.parse().ok()?,
                "over" => tally.over = value.parse().ok()?,
                "first over" => tally.first_over = Some(Case::parse(value)?),
                "worst" => tally.worst = Some(Case::parse(value)?),
                "faults" => tally.faults = value.parse().ok()?,
                "first fault" => tally.first_fault = Some(Fault::parse(value)?),
                _ => return None,
            }
        }
        Some(tally)
    }
}

impl Share {
    fn parse(text: &str) -> Option<Self> {
        let (part, whole) = text.split_once('/')?;
        Some(Self { part: part.parse().ok()?, whole: whole.parse().ok()? })
    }
}

impl Fault {
    fn parse(text: &str) -> Option<Self> {
        let (subject, why) = text.split_once(": ")?;
        let (curve, bits) = subject.rsplit_once(" n ")?;
        let curve = Curve::parse(&mut curve.split_whitespace())?;
        Some(Self { curve, bits: bits.parse().ok()?, why: why.to_owned() })
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} n {}: {}", self.curve, self.bits, self.why)
    }
}

/// One line, to be kept in a file and read by people.
impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "curves = {}; cycles = {}", self.curves, self.cycles)?;
        for (name, Share { part, whole }) in [("longest", self.longest), ("wait", self.wait)] {
            write!(f, "; {name} = {part}/{whole}")?;
        }
        write!(f, "; stepped out = {}; over = {}", self.stepped_out, self.over)?;
        for (name, case) in [("first over", self.first_over), ("worst", self.worst)] {
            if let Some(case) = case {
                write!(f, "; {name} = {case}")?;
            }
        }
        write!(f, "; faults = {}", self.faults)?;
        match &self.first_fault {
            Some(fault) => write!(f, "; first fault = {fault}"),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_can_be_read() {
        let curve = Curve::Line { end: [5, 3] };
        let mut tally = Tally { curves: 3, cycles: 99, ..Tally::default() };
        assert_eq!(Tally::parse(&tally.to_string()), Some(tally.clone()));
        tally.longest = Share { part: 7, whole: 8 };
        tally.wait = Share { part: 1, whole: 4 };
        tally.stray(&[Case { curve, bits: 4, cycle: 2, point: [0, 2] }]);
        tally.fault(curve, 4, "stops; at 0,2".to_owned());
        assert_eq!((tally.over, tally.faults), (1, 1));
        assert_eq!(Tally::parse(&tally.to_string()), Some(tally));
        assert_eq!(Tally::parse("curves = many"), None);
    }

    #[test]
    fn the_first_of_the_worst_is_kept() {
        let case =
            |cycle, point| Case { curve: Curve::Line { end: [9, 0] }, bits: 4, cycle, point };
        let tally = |case| {
            let mut tally = Tally::default();
            tally.stray(&[case]);
            tally
        };
        let [first, same, farther] = [case(1, [1, 2]), case(2, [2, 2]), case(3, [3, 3])];
        let mut sum = tally(first);
        sum.add(&tally(same));
        assert_eq!((sum.worst, sum.first_over, sum.over), (Some(first), Some(first), 2));
        sum.add(&tally(farther));
        assert_eq!((sum.worst, sum.first_over), (Some(farther), Some(first)));
    }

    #[test]
    fn shares_are_compared_exactly() {
        let share = |part, whole| Share { part, whole };
        assert_eq!(share(1, 2).max(share(3, 4)), share(3, 4));
        assert_eq!(share(7, 8).max(share(3, 4)), share(7, 8));
        assert_eq!(Share::default().max(share(1, 9)), share(1, 9));
    }
}
