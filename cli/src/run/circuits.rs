//! The circuits in the wave of a run.

use super::config::Config;
use super::survey::Survey;
use crate::choice::{Method, UpdateName};
use onepulse_core::{Direction, Error};
use onepulse_hwmodel::trace::SignalList;
use onepulse_hwmodel::{self as hw, Circuit};

/// The circuits that a method needs: those of a plane, and that of lines in space if the program has any.
#[derive(Debug)]
pub(super) struct Circuits(Vec<Declared>);

#[derive(Debug)]
struct Declared {
    name: &'static str,
    axes: usize,
    /// Its first signal.
    first: usize,
}

impl Circuits {
    /// Adds their signals to the list, a scope each. They are loaded with the smallest curves there are.
    pub(super) fn declare(
        list: &mut SignalList,
        config: &Config,
        method: &Method,
        survey: &Survey,
    ) -> Result<Self, Error> {
        let mut circuits = Self(Vec::new());
        circuits.add_of_plane(list, config, method)?;
        if survey.has_lines_in_space {
            circuits.add_of_space(list, config.bits, method)?;
        }
        Ok(circuits)
    }

    /// The first signal of the circuit of this name and so many axes.
    pub(super) fn first<C: Circuit<AXES>, const AXES: usize>(&self) -> usize {
        let is_it = |circuit: &&Declared| circuit.name == C::NAME && circuit.axes == AXES;
        self.0.iter().find(is_it).map_or(0, |circuit| circuit.first)
    }

    fn add<C: Circuit<AXES>, const AXES: usize>(
        &mut self,
        list: &mut SignalList,
        scope: &'static str,
        circuit: &C,
    ) {
        let first = list.add_circuit_in(scope, circuit);
        self.0.push(Declared { name: C::NAME, axes: AXES, first });
    }

    fn add_named<C: Circuit<2>>(&mut self, list: &mut SignalList, circuit: &C) {
        self.add(list, C::NAME, circuit);
    }

    fn add_of_plane(
        &mut self,
        list: &mut SignalList,
        config: &Config,
        method: &Method,
    ) -> Result<(), Error> {
        let (x, y, direction, bits) = ([1, 0], [0, 1], Direction::Ccw, config.bits);
        match *method {
            Method::Ppc { end_rule } => {
                self.add_named(list, &hw::ppc::Line::new(x, bits, end_rule)?);
                self.add_named(list, &hw::ppc::Arc::new(x, y, direction, bits, end_rule)?);
            }
            Method::Dda { preset, normalize, update, .. } => {
                let preset = preset.unwrap_or_default();
                self.add_named(list, &hw::dda::Line::new(x, bits, preset, normalize)?);
                match update {
                    // Of arcs too it makes lines.
                    _ if config.two_level.is_some() => {}
                    UpdateName::Staggered => {
                        self.add_named(
                            list,
                            &hw::dda::CentredArc::new(x, y, direction, bits, normalize)?,
                        );
                    }
                    UpdateName::Simultaneous => {
                        let arc = hw::dda::Arc::new(x, y, direction, bits, preset, normalize)?;
                        self.add_named(list, &arc);
                    }
                }
            }
            Method::Brm { .. } => self.add_named(list, &hw::brm::Line::new(x, bits)?),
            Method::MinDeviation => {
                self.add_named(list, &hw::minimum_deviation::Line::new(x, bits)?);
                self.add_named(list, &hw::minimum_deviation::Arc::new(x, y, direction, bits)?);
            }
            Method::CompareIntegral => {
                self.add_named(list, &hw::comparison::Line::new(x, bits)?);
                self.add_named(list, &hw::comparison::Arc::new(x, y, direction, bits)?);
            }
            // A run by it is refused before.
            Method::Vector => {}
        }
        Ok(())
    }

    fn add_of_space(
        &mut self,
        list: &mut SignalList,
        bits: u32,
        method: &Method,
    ) -> Result<(), Error> {
        let x = [1, 0, 0];
        match *method {
            Method::Dda { preset, normalize, .. } => {
                let line = hw::dda::Line::new(x, bits, preset.unwrap_or_default(), normalize)?;
                self.add(list, "dda_line_xyz", &line);
            }
            Method::Brm { .. } => self.add(list, "brm_line_xyz", &hw::brm::Line::new(x, bits)?),
            Method::MinDeviation => {
                let line = hw::minimum_deviation::Line::new(x, bits)?;
                self.add(list, "minimum_deviation_line_xyz", &line);
            }
            // A line in space by them is refused before.
            Method::Ppc { .. } | Method::Vector | Method::CompareIntegral => {}
        }
        Ok(())
    }
}
