//! Where the lift was as steps of its plan ended: what rights a vessel is asked for there once the run is over.

use serde::{Deserialize, Serialize};

use super::Simulation;
use crate::state::State;

/// The state of a lift as a step of its plan ended, before what begins then has changed anything.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Waypoint {
    /// The step, by its number; of several that ended at once the last.
    pub step: usize,
    /// The state.
    pub state: State,
}

impl Simulation {
    /// Keeps where the step that has been made began, if a step of the plan has ended since. Only what floats is asked for
    /// later, so that other lifts keep nothing.
    pub(super) fn note_waypoint(&mut self) {
        let had_ended = self.before.plan.ended().count();
        if self.system.vessels.is_empty() || self.state.plan.ended().count() == had_ended {
            return;
        }
        let before = |index: &usize| self.before.plan.ended().any(|one| one == *index);
        if let Some(step) = self.state.plan.ended().filter(|index| !before(index)).last() {
            self.waypoints.push(Waypoint { step, state: self.before.clone() });
        }
    }

    /// Where steps of the plan have ended so far, but for those that end with the run.
    pub fn waypoints(&self) -> &[Waypoint] {
        &self.waypoints
    }
}
