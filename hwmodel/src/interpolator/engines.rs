//! The engines of an interpolator, of which one runs at a time.

use super::command::Curve;
use super::decoder::Contents;
use crate::probe::Probe;
use crate::word::wrap;
use crate::{Circuit, Sweep, brm, dda, ppc};
use onepulse_core::{Direction, Pulse, Quadrant};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Engines<const AXES: usize> {
    dda_line: dda::Line<AXES>,
    dda_arc: dda::Arc,
    dda_centred_arc: dda::CentredArc,
    ppc_line: ppc::Line,
    ppc_arc: ppc::Arc,
    brm_line: brm::Line<AXES>,
}

/// A clock edge of one engine. Without a tick it goes on with a cycle that is under way.
fn clock<C: Circuit<N>, const N: usize>(engine: &mut C, tick: bool) -> Pulse<N> {
    if tick || engine.is_mid_cycle() { engine.clock() } else { Pulse::NONE }
}

impl<const AXES: usize> Engines<AXES> {
    pub(super) fn reset(bits: u32) -> Self {
        Self {
            dda_line: dda::Line::reset(bits),
            dda_arc: dda::Arc::reset(bits),
            dda_centred_arc: dda::CentredArc::reset(bits),
            ppc_line: ppc::Line::reset(bits),
            ppc_arc: ppc::Arc::reset(bits),
            brm_line: brm::Line::reset(bits),
        }
    }

    /// A clock edge with load.
    pub(super) fn load(&mut self, contents: &Contents<AXES>, bits: u32) {
        const QUADRANTS: [Quadrant; 4] = [Quadrant::I, Quadrant::II, Quadrant::III, Quadrant::IV];
        let Contents { first, jr, unit, accumulations, .. } = *contents;
        let [a, b] = [first.content[0], first.content[1]];
        let direction = if contents.cw { Direction::Cw } else { Direction::Ccw };
        let quadrant = QUADRANTS[usize::from(contents.quadrant)];
        let sweep = Sweep::loaded(quadrant, contents.crossings, contents.je, direction, bits);
        match Curve::from_code(contents.curve) {
            Some(Curve::DdaLine) => {
                let line = (first.content, jr[0], accumulations, first.negative);
                self.dda_line = dda::Line::loaded(line.0, line.1, line.2, line.3, bits);
            }
            Some(Curve::DdaArc) => {
                self.dda_arc = dda::Arc::loaded([a, b], jr[0], unit, sweep, bits);
            }
            Some(Curve::DdaCentredArc) => {
                let [x, y] = [a, b].map(|c| wrap(c as i64, bits));
                self.dda_centred_arc = dda::CentredArc::loaded([x, y], jr, unit, sweep, bits);
            }
            Some(Curve::PpcLine) => {
                let negative = [first.negative[0], first.negative[1]];
                self.ppc_line = ppc::Line::loaded_per_axis([a, b], negative, bits);
            }
            Some(Curve::PpcArc) => {
                self.ppc_arc = ppc::Arc::loaded_per_axis([a, b], sweep, bits);
            }
            Some(Curve::BrmLine) => {
                self.brm_line = brm::Line::loaded(first.content, first.negative, bits);
            }
            None => {}
        }
    }

    /// Whether the engine of a curve is done; the others always are.
    pub(super) fn done(&self, curve: u8) -> bool {
        match Curve::from_code(curve) {
            Some(Curve::DdaLine) => self.dda_line.done(),
            Some(Curve::DdaArc) => self.dda_arc.done(),
            Some(Curve::DdaCentredArc) => self.dda_centred_arc.done(),
            Some(Curve::PpcLine) => self.ppc_line.done(),
            Some(Curve::PpcArc) => self.ppc_arc.done(),
            Some(Curve::BrmLine) => self.brm_line.done(),
            None => true,
        }
    }

    /// A clock edge of the engine of a curve; the others stand. The pulses of the clock it ends.
    pub(super) fn clock(&mut self, curve: u8, tick: bool) -> Pulse<AXES> {
        let flat = match Curve::from_code(curve) {
            Some(Curve::DdaLine) => return clock(&mut self.dda_line, tick),
            Some(Curve::BrmLine) => return clock(&mut self.brm_line, tick),
            Some(Curve::DdaArc) => clock(&mut self.dda_arc, tick),
            Some(Curve::DdaCentredArc) => clock(&mut self.dda_centred_arc, tick),
            Some(Curve::PpcLine) => clock(&mut self.ppc_line, tick),
            Some(Curve::PpcArc) => clock(&mut self.ppc_arc, tick),
            None => Pulse::NONE,
        };
        let mut pulse = Pulse::NONE;
        pulse.0[..2].copy_from_slice(&flat.0);
        pulse
    }

    pub(super) fn probe(&self, probe: &mut impl Probe) {
        scoped(&self.dda_line, probe);
        scoped(&self.dda_arc, probe);
        scoped(&self.dda_centred_arc, probe);
        scoped(&self.ppc_line, probe);
        scoped(&self.ppc_arc, probe);
        scoped(&self.brm_line, probe);
    }
}

fn scoped<C: Circuit<N>, const N: usize>(engine: &C, probe: &mut impl Probe) {
    probe.scope(C::NAME);
    engine.probe(probe);
}
