//! The registers of digital integration, accumulation by accumulation.

use super::{Language, Table, pulse_name};
use crate::pulses::AXES;
use onepulse_core::{Pulse, dda, parabola};

/// The table of a line.
pub(super) struct LineTable<const N: usize> {
    pub(super) machine: dda::Line<N>,
}

/// The table of an arc by the textbook's circuit.
pub(super) struct ArcTable {
    pub(super) machine: dda::Arc,
}

/// The table of an arc by the centred staggered circuit.
pub(super) struct CentredArcTable {
    pub(super) machine: dda::CentredArc,
}

/// The table of a parabola.
pub(super) struct ParabolaTable {
    pub(super) machine: parabola::Dda,
}

/// Cycle; integrand, remainder and overflow of each axis; then the end counters.
fn headings(axes: usize, counters: &[&str], language: Language) -> Vec<String> {
    let mut headings = vec![language.pick("cycle", "累加次数").to_owned()];
    for axis in &AXES[..axes] {
        headings.push(format!("{} JV{axis}", language.pick("integrand", "被积函数")));
        headings.push(format!("{} JR{axis}", language.pick("remainder", "余数")));
        headings.push(format!("{} Δ{axis}", language.pick("overflow", "溢出")));
    }
    let counter = language.pick("end counter", "终点计数器");
    headings.extend(counters.iter().map(|name| format!("{counter} {name}")));
    headings
}

fn row<const N: usize>(
    cycle: u64,
    integrands: [String; N],
    remainders: [u64; N],
    Pulse(pulse): Pulse<N>,
    counters: &[u64],
) -> Vec<String> {
    let mut row = vec![cycle.to_string()];
    for (axis, integrand) in integrands.into_iter().enumerate() {
        row.push(integrand);
        row.push(remainders[axis].to_string());
        row.push(pulse_name(pulse[axis], axis));
    }
    row.extend(counters.iter().map(u64::to_string));
    row
}

impl<const N: usize> Table for LineTable<N> {
    fn headings(&self, language: Language) -> Vec<String> {
        headings(N, &["JE"], language)
    }

    fn rows(&self, _: Language) -> impl Iterator<Item = Vec<String>> {
        let show = |cycle, machine: &dda::Line<N>, pulse| {
            let integrands = machine.integrands().map(|jv| jv.to_string());
            row(cycle, integrands, machine.remainders(), pulse, &[machine.remaining()])
        };
        let mut machine = self.machine;
        let first = show(0, &machine, Pulse::NONE);
        let rest = (1..).map_while(move |cycle| {
            let pulse = machine.step()?;
            Some(show(cycle, &machine, pulse))
        });
        std::iter::once(first).chain(rest)
    }
}

impl Table for ArcTable {
    fn headings(&self, language: Language) -> Vec<String> {
        headings(2, &["JEx", "JEy"], language)
    }

    fn rows(&self, _: Language) -> impl Iterator<Item = Vec<String>> {
        curve_rows(self.machine, |arc| Shown {
            integrands: arc.integrands().map(|jv| jv.to_string()),
            remainders: arc.remainders(),
            to_go: arc.residual(),
        })
    }
}

impl Table for CentredArcTable {
    fn headings(&self, language: Language) -> Vec<String> {
        headings(2, &["JEx", "JEy"], language)
    }

    fn rows(&self, _: Language) -> impl Iterator<Item = Vec<String>> {
        curve_rows(self.machine, |arc| Shown {
            integrands: arc.integrands().map(|jv| jv.to_string()),
            remainders: arc.remainders(),
            to_go: arc.residual(),
        })
    }
}

impl Table for ParabolaTable {
    fn headings(&self, language: Language) -> Vec<String> {
        headings(2, &["JEx", "JEy"], language)
    }

    fn rows(&self, _: Language) -> impl Iterator<Item = Vec<String>> {
        curve_rows(self.machine, |curve| Shown {
            integrands: curve.integrands().map(|jv| jv.to_string()),
            remainders: curve.remainders(),
            to_go: curve.residual(),
        })
    }
}

/// What a row shows of a curve's registers.
struct Shown {
    integrands: [String; 2],
    remainders: [u64; 2],
    to_go: [i64; 2],
}

fn curve_rows<M: Iterator<Item = Pulse>>(
    mut machine: M,
    shown: impl Fn(&M) -> Shown,
) -> impl Iterator<Item = Vec<String>> {
    let show = move |cycle, machine: &M, pulse| {
        let Shown { integrands, remainders, to_go } = shown(machine);
        row(cycle, integrands, remainders, pulse, &to_go.map(i64::unsigned_abs))
    };
    let first = show(0, &machine, Pulse::NONE);
    let rest = (1..).map_while(move |cycle| {
        let pulse = machine.next()?;
        Some(show(cycle, &machine, pulse))
    });
    std::iter::once(first).chain(rest)
}
