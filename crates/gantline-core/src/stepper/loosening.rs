//! Rope over light sheaves that is slack passes them until all its spans are as loose.

use super::frame::Frame;
use crate::rope::light::{Division, Spans};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::System;

/// Passing less than this [m] is rounding.
const NOTHING: f64 = 1e-12;

/// How it is to lie, with the compliance of every span, by [`System::light`].
#[derive(Debug, Clone)]
pub struct Loosening {
    ropes: Vec<(Division, Vec<f64>)>,
}

impl Loosening {
    /// Room for `system`.
    pub fn new(system: &System) -> Self {
        let ropes = system.light.iter().map(|light| {
            let mut division = Division::new(light.dofs.len());
            division.slips.is_loose = true;
            (division, light.rows.clone().map(|row| system.rows.laws[row].compliance()).collect())
        });
        Self { ropes: ropes.collect() }
    }

    /// Lets it pass, by the lengths in `frame`, which belongs to the state before; true where any did.
    pub fn pass(&mut self, system: &System, state: &mut State, frame: &Frame) -> bool {
        let mut any = false;
        for (light, (division, compliance)) in system.light.iter().zip(&mut self.ropes) {
            if state.modes[light.rows.start] != Mode::Slack {
                continue;
            }
            let stretch = &frame.value[light.rows.clone()];
            division.share(Spans { ratio: &light.ratio, stretch, compliance, softening: 0.0 });
            for (&position, passed) in light.positions.iter().zip(&division.passed) {
                if passed.abs() > NOTHING {
                    state.q[position] += passed;
                    any = true;
                }
            }
        }
        any
    }
}
