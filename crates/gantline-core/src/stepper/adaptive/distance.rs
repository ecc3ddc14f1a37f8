//! How far frozen modes are from their laws, and how far the tolerance lets them be.

use super::evaluation::Evaluation;
use super::{Adaptive, SWITCHING};
use crate::constraint::Law;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::stepper::STANDSTILL;
use crate::system::System;

/// How far a place is from what it should be, the worst of each.
#[derive(Debug, Clone, Copy, Default)]
pub struct Far {
    /// As a force [N].
    pub force: f64,
    /// In what the tolerance allows: the step ends before this reaches 1.
    pub share: f64,
}

impl Far {
    /// A force [N] where another is allowed [N].
    pub fn new(force: f64, allowed: f64) -> Self {
        Self { force, share: force / allowed }
    }

    /// The worst of both.
    pub fn or(self, other: Self) -> Self {
        Self { force: self.force.max(other.force), share: self.share.max(other.share) }
    }
}

impl Adaptive {
    /// How far a place is from what it should be.
    pub(super) fn farthest(&self, system: &System, state: &State, at: &Evaluation) -> Far {
        let rows = (0..system.first_light_row())
            .map(|row| Far::new(self.distance(system, state, row, at), self.allowed(system, row, at)));
        rows.fold(self.turned(system, &state.modes, at), Far::or)
    }

    /// How far the tolerance lets a row be from its law [N]. Friction may not be off by more than itself, however loose the
    /// tolerance, unless that is less than what the tolerance sees.
    fn allowed(&self, system: &System, row: usize, at: &Evaluation) -> f64 {
        let tolerance = self.tolerance.tension;
        match system.rows.laws[row] {
            Law::Brake { .. } => at.bound[row].clamp(tolerance, SWITCHING * tolerance),
            _ => SWITCHING * tolerance,
        }
    }

    /// How far the frozen mode of a row is from its law [N]; not positive where it is right.
    pub(super) fn distance(&self, system: &System, state: &State, row: usize, at: &Evaluation) -> f64 {
        match (system.rows.laws[row], state.modes[row]) {
            (_, Mode::Parted | Mode::Off) | (Law::Pin | Law::Spring { .. }, _) => 0.0,
            // An inextensible rope that is loosening need not be caught: only what it is longer than at the start.
            (Law::Unilateral { compliance: 0.0, .. }, Mode::Slack) if at.rate[row] < STANDSTILL => {
                at.trial[row] - self.looks.start(row).max(0.0)
            }
            (Law::Unilateral { .. }, Mode::Slack) => at.trial[row],
            (Law::Unilateral { .. }, _) => -at.trial[row],
            (Law::Friction { normal, .. }, _) if row != normal + 1 => 0.0,
            (Law::Friction { .. }, Mode::Slack) => 0.0,
            (Law::Friction { coefficient, normal, .. }, mode) => {
                let beyond = at.trial[row].hypot(at.trial[row + 1]) - coefficient * at.trial[normal].max(0.0);
                if mode == Mode::Slipping { -beyond } else { beyond }
            }
            (Law::Brake { .. }, Mode::Slack) => 0.0,
            (Law::Brake { .. }, Mode::Acting) => at.trial[row].abs() - at.bound[row],
            (Law::Brake { impedance, .. }, Mode::Slipping) => {
                (-at.rate[row] * state.memory[row] * impedance).min(2.0 * at.bound[row])
            }
        }
    }
}
