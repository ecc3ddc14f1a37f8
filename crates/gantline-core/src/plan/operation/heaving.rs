//! Heave compensation in the plan: when it goes on, and what it asks of hoists.

use super::{Phase, PlanState};
use crate::event::{EventKind, EventLog};
use crate::plan::condition::Seen;
use crate::plan::course::Motion;
use crate::plan::heave::{Compensating, Compensator, Watch};
use crate::plan::step::Plan;

impl PlanState {
    /// Compensators begin that steps under way ask for, and those stop that none asks for any more. True where one did.
    pub(super) fn switch_compensators(&mut self, plan: &Plan, at: f64) -> bool {
        let mut has_switched = false;
        for (index, of) in plan.compensators.iter().enumerate() {
            let timeline = &self.timelines[of.hoist.drive];
            // What a program moves, or a brake holds, is moved by nobody else.
            let is_free = timeline.commanded().is_none() && timeline.braked(at).is_none();
            let wanted = self.compensates(plan, index).filter(|_| is_free);
            let next = match (self.compensating[index], wanted) {
                (Compensating::On(watch), Some(against)) if watch.against == against => continue,
                (Compensating::On(watch), Some(against)) => Compensating::On(watch.turned_to(at, against)),
                (_, Some(against)) => Compensating::On(Watch::from(at, against)),
                (Compensating::On(_), None) => Compensating::Stopping(self.ease_out(of, at)),
                (_, None) => continue,
            };
            self.compensating[index] = next;
            has_switched = true;
        }
        has_switched
    }

    /// Against which deck the step that began last of those under way wants a compensator to work, or the ground; none
    /// where none wants it.
    fn compensates(&self, plan: &Plan, index: usize) -> Option<Option<usize>> {
        let under_way = (self.stage..self.begun)
            .rev()
            .filter(|&step| !matches!(self.phases[step], Phase::Ahead | Phase::Ended(_)));
        let wants = |step: usize| plan.steps[step].compensates.iter().find(|(wanted, _)| *wanted == index);
        under_way.filter_map(wants).map(|&(_, against)| against).next()
    }

    /// Where a drive is at a time [s] as steps count it: without what compensates heave, but with what of that stays [m or rad].
    pub(super) fn place(&self, plan: &Plan, drive: usize, at: f64) -> f64 {
        let timeline = &self.timelines[drive];
        let stays = |(of, state): (&Compensator, &Compensating)| match state {
            Compensating::Stopping(end) if of.hoist.drive == drive => timeline.added(*end).position,
            _ => 0.0,
        };
        let kept: f64 = plan.compensators.iter().zip(&self.compensating).map(stays).sum();
        timeline.planned(at).position + kept
    }

    /// By how much each compensator has raised its hook at a time [m].
    pub fn compensated(&self, compensators: &[Compensator], time: f64) -> impl Iterator<Item = f64> {
        compensators.iter().map(move |of| {
            let timeline = &self.timelines[of.hoist.drive];
            at_hook(of, timeline.planned(time), timeline.added(time)).0.position
        })
    }

    /// A compensator glances, or has come to rest.
    pub(super) fn compensate(
        &mut self,
        plan: &Plan,
        (index, at): (usize, f64),
        seen: Option<&Seen>,
        log: &mut EventLog,
    ) {
        let of = &plan.compensators[index];
        match (&mut self.compensating[index], seen) {
            (Compensating::Off, _) => {}
            (Compensating::Stopping(_), _) => {
                self.timelines[of.hoist.drive].keep_added(at);
                self.compensating[index] = Compensating::Off;
            }
            (Compensating::On(_), None) => {
                self.compensating[index] = Compensating::Stopping(self.ease_out(of, at));
            }
            (Compensating::On(watch), Some(seen)) => {
                let timeline = &mut self.timelines[of.hoist.drive];
                let (added, ratio) = at_hook(of, timeline.planned(at), timeline.added(at));
                let (velocity, duration) = watch.glance(of, added, seen.kinematics);
                timeline.add(seen.kinematics.time, (at, duration), velocity / ratio);
                if let Some(limit) = watch.comes_to_a_limit() {
                    log.push(at, EventKind::CompensationLimit(limit), index);
                }
            }
        }
    }

    /// A compensator comes to rest without haste; returns when [s].
    fn ease_out(&mut self, of: &Compensator, at: f64) -> f64 {
        let timeline = &mut self.timelines[of.hoist.drive];
        let duration = of.ease(at_hook(of, timeline.planned(at), timeline.added(at)).0);
        timeline.ease_adding(at, duration);
        at + duration
    }

    /// A compensator comes to rest at once.
    pub(super) fn stop_compensating(&mut self, of: &Compensator, at: f64) {
        let timeline = &mut self.timelines[of.hoist.drive];
        let (_, ratio) = at_hook(of, timeline.planned(at), timeline.added(at));
        timeline.stop_adding(at, of.hoist.acceleration / ratio);
    }
}

/// How the hook moves by what is added to its drive, and how fast it goes for each m/s of that.
fn at_hook(of: &Compensator, planned: Motion, added: Motion) -> (Motion, f64) {
    let Some(reel) = &of.hoist.reel else { return (added, 1.0) };
    let place = planned.position + added.position;
    let ratio = reel.ratio(place);
    let position = reel.gone(place) - reel.gone(planned.position);
    (Motion { position, velocity: ratio * added.velocity, ..added }, ratio)
}
