//! How long a step is: attempts until the error of one is small enough.

use super::{Adaptive, FIRST_STEP, STEP_FLOOR, prescribed, tableau};
use crate::state::State;
use crate::stepper::{StepError, StepReport, spots};
use crate::system::System;
use crate::tree::mass::MassMatrix;

impl Adaptive {
    /// Length of the first attempt [s], not beyond `stop` [s].
    fn first_length(&mut self, system: &System, state: &State, stop: f64) -> f64 {
        let mut h = if state.next_step > 0.0 { state.next_step } else { FIRST_STEP };
        if state.engaged {
            h = h.min(2.0 * state.engaged_step);
        }
        h = h.min(self.ringing_limit(system, state)).min(self.winding_limit(system, state));
        h = h.min(self.crest_limit(system)).min(prescribed::wave_limit(state));
        h = prescribed::turning_limit(system, state, h.min(stop - state.time));
        if !system.finders.is_empty() {
            let here = &self.rodas.here;
            let (kinematics, twists) = (&here.frame.kinematics, &here.dynamics.twists);
            h = h.min(spots::limit(system, kinematics, twists, state, self.tolerance.position));
        }
        h
    }

    /// Computes steps until one is right, into the course; the norm of its error, in tolerances.
    pub(super) fn compute(
        &mut self,
        system: &System,
        state: &State,
        mass: &MassMatrix,
        stop: f64,
        report: &mut StepReport,
    ) -> Result<f64, StepError> {
        let (reach, mut last) = (stop - state.time, f64::INFINITY);
        let mut h = self.first_length(system, state, stop);
        loop {
            // Never leave a sliver before a stop.
            h = if h >= reach { reach } else { h.min(0.5 * reach) };
            let solved = self.rodas.attempt(system, state, mass, h);
            report.factorisations += 1;
            if let Err(pivot) = solved {
                // Beside the inertia the compliance of rows counts by 1/h²: corners that share a load at rest look as if
                // each repeated the others once that is rounding. What is singular at any step is so at a short one.
                if h <= FIRST_STEP {
                    return Err(self.singular(system, state, pivot));
                }
                report.rejected += 1;
                h = (0.1 * h).max(FIRST_STEP);
                continue;
            }
            let missed = self.end_on_curves(system, state, h);
            let error = self.weights.norm(system, state, &self.rodas, &self.tolerance);
            let error = error.max(missed).max(self.foretell(system, state, h));
            if error <= 1.0 && self.has_tangents(system, state) {
                return Ok(error);
            }
            report.rejected += 1;
            // Where the estimate does not fall with the step, the step is far too long.
            let wanted = 0.9 * error.powf(-1.0 / tableau::ERROR_ORDER);
            h *= if error < 0.5 * last { wanted.clamp(0.1, 0.8) } else { 0.1 };
            last = error;
            if h < STEP_FLOOR {
                return Err(self.too_short(system, state));
            }
        }
    }
}
