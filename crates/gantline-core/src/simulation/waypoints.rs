//! Where the lift was as steps of its plan ended: what rights a vessel is asked for there once the run is over.

use serde::{Deserialize, Serialize};

use super::Simulation;
use crate::state::State;

/// The state of a lift as a step of its plan ended, before what begins then has changed anything, but for what that does within
/// a step of fixed length.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Waypoint {
    /// The step, by its number; of several that ended at once the last.
    pub step: usize,
    /// The state.
    pub state: State,
}

impl Simulation {
    /// Keeps where a step of the plan has ended in the step that has been made: where that began, if it ended then, else where
    /// it led. Only what floats is asked for later, so that other lifts keep nothing.
    pub(super) fn note_waypoint(&mut self) {
        let (before, after) = (&self.before, &self.state);
        if self.system.vessels.is_empty() || after.plan.ended().count() == before.plan.ended().count() {
            return;
        }
        let is_new = |index: usize| before.plan.ended().all(|(one, _)| one != index);
        if let Some((step, at)) = after.plan.ended().filter(|(index, _)| is_new(*index)).last() {
            let state = if at > before.time { after } else { before };
            self.waypoints.push(Waypoint { step, state: state.clone() });
        }
    }
}
