//! How a stream turns what hangs in it changes where that is pulled, and where it hangs turns nothing. The symmetric half of
//! the tangent has both alike: a step that swings a load out in wind turns it about its hook as well, by tens of degrees
//! where nothing else holds its heading. So what is left of the way Δq along neutral motions,
//!
//! ```text
//! Δ = (μM + K)⁻¹ μM Δq
//! ```
//!
//! with all of K ([`crate::statics::stream`]), is gone back: of what is held that leaves μ/ω², of what turns a load by itself
//! all, with what balances it then.

use super::{BALANCED, LEAST, Search};
use crate::state::State;
use crate::statics::bearing::Bearing;
use crate::stepper::frame::Remembered;
use crate::system::System;
use crate::tree::joint::Motion;

/// How often Δ takes the place of Δq: what moorings hold with ω² = 1e-3/s² has none of it then.
const TIMES: usize = 3;
/// Ways back, at most.
const WAYS: usize = 100;
/// Farthest turn of a joint on one of them [rad].
const TURN: f64 = 0.05;
/// What is left of them that is near enough [m, rad].
const NEAR: f64 = 1e-5;
/// λ of the steps that balance what is held after each [1/s²]: far above that of what nothing holds, which stays.
const CALM: f64 = 1e-4;
/// Such steps after one way, at most.
const STEPS: usize = 30;
/// Imbalance that may be left of what nothing holds: by less than that it is hardly turned at all.
const LEFT: f64 = 1e-7;

impl Search {
    /// From the equilibrium that a descent has found to the one that is nearest to its start, where streams push and neutral
    /// motions lead there; nothing moved where they do not.
    pub(super) fn come_back(&mut self, system: &System, state: &mut State, bearings: &mut [Bearing]) {
        if self.here.pushed.is_empty() {
            return;
        }
        let found = state.clone();
        for _ in 0..WAYS {
            if !self.find_way_back(system, state, bearings) {
                break;
            }
            if self.step.iter().all(|step| step.abs() <= NEAR) {
                return;
            }
            self.there.evaluate(system, bearings, &Remembered::of(state));
            self.go_there(state);
            self.seat(system, state, bearings);
            self.find_spots(system, state, bearings);
            if !self.rebalance(system, state, bearings) {
                break;
            }
        }
        // Where ropes lie and bodies touch too.
        state.clone_from(&found);
        self.return_to(&found.q, system, state, bearings);
    }

    /// Balances what is held again; false where that leads nowhere.
    fn rebalance(&mut self, system: &System, state: &mut State, bearings: &mut [Bearing]) -> bool {
        for _ in 0..STEPS {
            let before = self.here.residual(system);
            if before <= BALANCED {
                return true;
            }
            self.here.turn_bearings(system, bearings);
            self.linearise(system, state);
            let mut lambda = CALM;
            if !self.step_whole(system, state, bearings, &mut lambda) {
                return false;
            }
            if self.there.residual(system) > 0.5 * before {
                return before <= LEFT;
            }
            self.go_there(state);
            self.seat(system, state, bearings);
            self.find_spots(system, state, bearings);
        }
        false
    }

    /// Sets the step to the way back, or to as much of it as turns nothing too far; false where there is none.
    fn find_way_back(&mut self, system: &System, state: &State, bearings: &[Bearing]) -> bool {
        self.linearise(system, state);
        self.matrix.extra.fill(0.0);
        let Self { matrix, here, gone, force, right, step, tension, .. } = self;
        let compliance = |row: usize| here.follows[row].then_some(bearings[row].compliance);
        if matrix.factorise_whole(system, LEAST, compliance).is_err() {
            return false;
        }
        right.fill(0.0);
        step.copy_from_slice(gone);
        for _ in 0..TIMES {
            here.frame.mass.multiply(step, force);
            force.iter_mut().for_each(|force| *force *= LEAST);
            matrix.solve_whole(force, right, step, tension);
        }
        let turns = system.tree.motions.iter().zip(step.iter());
        let turns = turns.filter(|(motion, _)| **motion == Motion::Turn);
        let share = TURN / turns.fold(TURN, |most, (_, turn)| most.max(turn.abs()));
        step.iter_mut().for_each(|step| *step *= -share);
        self.is_passable(system)
    }
}
