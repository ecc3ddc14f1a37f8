//! Where wind or current turn something slowly, such as a module in one hook, what turns it is a millionth of what holds it
//! otherwise, and pulls it aside as it turns: energies tell nothing, steps by the symmetric half of the tangent circle, and
//! no step that turns it brings all forces nearer to balance. So it goes as the lift would go by itself,
//!
//! ```text
//! (λM + K) Δ + Gᵀ δT = −∇V      G Δ − ε δT = 0
//! ```
//!
//! with all of K ([`crate::statics::stream`]): implicit steps in time from rest, 1/√λ long, whatever that makes of the forces
//! meanwhile. They get longer as forces come to balance (Mulder and van Leer 1985), and end as Newton's method.

use super::{BALANCED, LEAST, MOST, ROUNDED, SLOWER, Search};
use crate::state::State;
use crate::statics::bearing::Bearing;
use crate::stepper::frame::Remembered;
use crate::system::System;
use crate::tree::joint::Motion;

/// λ of the first step [1/s²].
const FIRST: f64 = 1e-3;
/// Steps, at most.
const STEPS: usize = 300;
/// Farthest turn of a joint in one [rad].
const TURN: f64 = 0.3;
/// λ changes as what is left of the imbalance, within these.
const PACE: (f64, f64) = (0.1, 2.0);

impl Search {
    /// From `state` to where forces balance; false, and nothing moved, where nothing streams or that leads nowhere.
    pub(super) fn relax(&mut self, system: &System, state: &mut State, bearings: &mut [Bearing]) -> bool {
        if self.here.pushed.is_empty() {
            return false;
        }
        let start = self.here.q.clone();
        let mut lambda = FIRST;
        for _ in 0..STEPS {
            let before = self.here.residual(system);
            self.here.turn_bearings(system, bearings);
            self.linearise(system, state);
            if before <= ROUNDED || !self.step_whole(system, state, bearings, &mut lambda) {
                break;
            }
            let after = self.there.residual(system);
            if before <= BALANCED && after > 0.5 * before {
                break;
            }
            lambda = (lambda * (after / before).clamp(PACE.0, PACE.1)).max(LEAST);
            self.go_there(state);
            self.seat(system, state, bearings);
            self.find_spots(system, state, bearings);
        }
        if self.here.residual(system) <= BALANCED {
            return true;
        }
        self.return_to(&start, system, state, bearings);
        false
    }

    /// Everything as it was at `start`.
    pub(super) fn return_to(
        &mut self,
        start: &[f64],
        system: &System,
        state: &mut State,
        bearings: &[Bearing],
    ) {
        self.here.q.copy_from_slice(start);
        state.q.copy_from_slice(start);
        self.here.place(system);
        self.evaluate(system, state, bearings);
    }

    /// Sets `there` to where the next step leads, with rows on the sides where they are; λ is raised until nothing turns too
    /// far. False where none will do.
    pub(super) fn step_whole(
        &mut self,
        system: &System,
        state: &State,
        bearings: &[Bearing],
        lambda: &mut f64,
    ) -> bool {
        self.matrix.extra.fill(0.0);
        while *lambda <= MOST {
            let Self { matrix, here, force, right, step, tension, .. } = self;
            let compliance = |row: usize| here.follows[row].then_some(bearings[row].compliance);
            let is_solved = matrix.factorise_whole(system, *lambda, compliance).is_ok();
            if is_solved {
                for (force, slope) in force.iter_mut().zip(&here.slope) {
                    *force = -slope;
                }
                right.fill(0.0);
                matrix.solve_whole(force, right, step, tension);
            }
            let turns = system.tree.motions.iter().zip(&self.step);
            let is_far = turns.clone().any(|(motion, turn)| *motion == Motion::Turn && turn.abs() > TURN);
            if is_solved && !is_far && self.is_passable(system) {
                self.there.evaluate(system, bearings, &Remembered::of(state));
                return self.there.energy.is_finite();
            }
            *lambda = (SLOWER * *lambda).max(FIRST);
        }
        false
    }
}
