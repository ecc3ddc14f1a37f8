//! Off an unstable equilibrium: along the motion that leads away fastest, and downhill from there.

use super::losses::Losses;
use super::{NEUTRAL, NoEquilibrium, Rest, Statics};
use crate::state::State;
use crate::system::System;
use crate::tree::joint::Motion;

/// Largest turn [rad] or shift [m] of a joint in the step off.
const STEP: f64 = 0.02;
/// How often a step may lead to what is unstable again.
const STEPS: usize = 20;
/// Entries of a shape that differ by less are alike: the first of them says which way it goes.
const ALIKE: f64 = 1e-6;

impl Statics {
    /// From the unstable equilibrium that was found last to the stable one downhill of a step along the motion that leads
    /// away fastest, in the direction in which the first of the degrees of freedom that move most grows. None where the
    /// equilibrium is not unstable.
    ///
    /// # Errors
    /// [`NoEquilibrium`] as [`Statics::settle`].
    pub fn step_off(
        &mut self,
        system: &System,
        state: &mut State,
        losses: Losses,
    ) -> Result<Option<Rest>, NoEquilibrium> {
        let mut found = None;
        for _ in 0..STEPS {
            let away = self.modes(system, state, Some(1)).into_iter().next();
            let Some(away) = away.filter(|mode| mode.square < -NEUTRAL) else { break };
            let mut step = away.shape;
            let sizes = || step.iter().map(|entry| entry.abs());
            let turns = system.tree.motions.iter().zip(&step).filter(|(motion, _)| **motion == Motion::Turn);
            let turn = turns.map(|(_, entry)| entry.abs()).fold(0.0, f64::max);
            let most = sizes().fold(0.0, f64::max);
            let first = sizes().position(|size| size >= (1.0 - ALIKE) * most).unwrap_or(0);
            // A turn counts before the shifts that it brings, which grow with the size of the lift.
            let factor = STEP / if turn > ALIKE * most { turn } else { most };
            let factor = factor.copysign(step[first]);
            step.iter_mut().for_each(|entry| *entry *= factor);
            system.tree.advance(&mut state.q, &step);
            self.balance(system, state, losses)?;
            found = Some(self.rest(system, state)?);
        }
        Ok(found)
    }
}
