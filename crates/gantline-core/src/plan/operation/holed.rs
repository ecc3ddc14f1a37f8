//! Tanks with holes: what runs through these is no step's, and goes on after an emergency stop.

use super::PlanState;
use crate::plan::condition::Seen;
use crate::plan::holes::EVERY;
use crate::plan::step::Plan;

impl PlanState {
    /// Lets run what runs before `to` [s]; where nothing is seen, in statics, contents stay.
    pub(super) fn let_run(&mut self, plan: &Plan, to: f64, seen: Option<&Seen>) {
        let Some(seen) = seen else { return };
        for (of, running) in plan.holed.iter().zip(&mut self.running) {
            while running.next < to {
                let (at, timeline) = (running.next, &mut self.timelines[of.drive]);
                let rate = running.glance(of, timeline.added(at), seen.kinematics, self.begun);
                timeline.add(seen.kinematics.time, (at, EVERY), rate);
            }
        }
    }
}
