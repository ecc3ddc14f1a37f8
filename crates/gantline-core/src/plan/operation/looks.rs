//! Looks of drives that follow: how fast they go on until the next one, and when that is.

use super::{Phase, PlanState};
use crate::plan::condition::Seen;
use crate::plan::follow::{CALM, Glance, within};
use crate::plan::step::{Plan, Step, Until};
use crate::spec::RampShape;

/// Share of its velocity in the plan below which a drive has stood still.
const STILL: f64 = 1e-6;

impl PlanState {
    /// A drive that follows looks, and comes to another velocity until it looks again. It rests once it is calm and
    /// nothing goes on beside it.
    pub(super) fn look(&mut self, plan: &Plan, (index, at): (usize, f64), seen: Option<&Seen>) {
        let Phase::Following { mut before, .. } = self.phases[index] else { return };
        let step = &plan.steps[index];
        let (Until::Follow(follow), Some(first)) = (&step.until, step.moves.first()) else { return };
        let mut is_calm = self.led_until(plan) < at;
        if let Some(seen) = seen
            && self.timelines[first.drive].commanded().is_none()
        {
            let (view, now) = (follow.view(seen), self.timelines[first.drive].motion(at));
            let place = view.map(|view| now.position + view.lag);
            let along = match (before, place) {
                (Some(before), Some(place)) => {
                    (place - before.place) / (at - before.at)
                        * self.going_on(plan, [before.at, at, at + follow.every])
                }
                _ => 0.0,
            };
            let wanted =
                view.map_or(0.0, |view| view.velocity(along, now.velocity, first.acceleration, follow.every));
            let (velocity, duration) = within(wanted, now, first, follow.every);
            for motion in &step.moves {
                let timeline = &mut self.timelines[motion.drive];
                timeline.forget(at);
                timeline.ramp(at, duration, velocity, RampShape::Linear);
            }
            before = place.map(|place| Glance { at, place });
            let fastest = velocity.abs().max(now.velocity.abs());
            is_calm &= fastest * view.map_or(1.0, |view| view.rate) <= CALM;
        }
        self.phases[index] = if is_calm {
            Phase::UntilTime(self.brake(step, at))
        } else {
            Phase::Following { next: at + follow.every, before }
        };
    }

    /// How fast what goes on beside drives that follow will go until the next look, over how fast it went since the
    /// look before, as far as the plan knows it: of the drive that slows down least. 1 where nothing went on.
    ///
    /// `looks` are the look before, this one and the next [s].
    fn going_on(&self, plan: &Plan, looks: [f64; 3]) -> f64 {
        let stage = self.stage..self.begun;
        let leading = plan.steps[stage].iter().filter(|step| !matches!(step.until, Until::Follow(_)));
        let shares = leading.flat_map(|step| &step.moves).filter_map(|motion| {
            let timeline = &self.timelines[motion.drive];
            let [first, now, next] = looks.map(|time| timeline.motion(time).position);
            let (was, will) = ((now - first) / (looks[1] - looks[0]), (next - now) / (looks[2] - looks[1]));
            (was.abs() > STILL * motion.velocity.abs()).then(|| (will / was).clamp(0.0, 1.0))
        });
        shares.reduce(f64::max).unwrap_or(1.0)
    }

    /// What goes on beside drives that follow has changed at a time [s]: they look at once, though no sooner than half
    /// the usual time after the look before.
    pub(super) fn look_soon(&mut self, plan: &Plan, at: f64) {
        for index in self.stage..self.begun {
            if let Phase::Following { next, before: Some(before) } = &mut self.phases[index] {
                *next = next.min(at.max(before.at + 0.5 * look_every(&plan.steps[index])));
            }
        }
    }
}

/// Time between looks of a drive that follows [s].
pub(super) fn look_every(step: &Step) -> f64 {
    if let Until::Follow(follow) = &step.until { follow.every } else { f64::INFINITY }
}
