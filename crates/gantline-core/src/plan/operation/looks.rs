//! Looks of drives that follow: how fast they go on until the next one, and when that is.

use serde::{Deserialize, Serialize};

use super::{Phase, PlanState};
use crate::plan::condition::Seen;
use crate::plan::follow::{CALM, Follow, Glances, Look, View, within};
use crate::plan::step::{Plan, Step, Until};
use crate::spec::RampShape;

/// Share of its velocity in the plan below which a drive has stood still.
const STILL: f64 = 1e-6;

/// A drive that follows, between looks.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Following {
    /// Time of the next glance [s].
    pub(super) next: f64,
    /// When a glance is the last one of a look [s].
    look: f64,
    /// When the last look ended [s].
    looked: f64,
    /// What it saw at the last look.
    before: Option<Look>,
    /// What it has seen since.
    glances: Glances,
}

impl Following {
    /// From a time [s] on, which is that of the first glance.
    pub(super) fn from(begin: f64, follow: &Follow) -> Self {
        let look = begin + (follow.every - apart(follow));
        Self { next: begin, look, looked: begin, before: None, glances: Glances::default() }
    }
}

/// Time between glances [s].
fn apart(follow: &Follow) -> f64 {
    follow.every / f64::from(follow.glances)
}

impl PlanState {
    /// A drive that follows glances at where it should be. The last glance of a look lets it come to another velocity until
    /// the next one. It rests once it is calm and nothing goes on beside it.
    pub(super) fn glance(&mut self, plan: &Plan, (index, at): (usize, f64), seen: Option<&Seen>) {
        let Phase::Following(mut following) = self.phases[index] else { return };
        let step = &plan.steps[index];
        let (Until::Follow(follow), Some(first)) = (&step.until, step.moves.first()) else { return };
        let now = self.timelines[first.drive].motion(at);
        let seen = seen.filter(|_| self.timelines[first.drive].commanded().is_none());
        let view = seen.and_then(|seen| follow.view(seen));
        match view {
            Some(view) => following.glances.add(at, now.position + view.lag),
            None => following.glances = Glances::default(),
        }
        if at < following.look {
            let next = at + apart(follow);
            // Of a glance and a look that rounding has set apart it is the look.
            let is_look = next > following.look - 0.5 * apart(follow);
            following.next = if is_look { following.look } else { next };
            self.phases[index] = Phase::Following(following);
            return;
        }
        let mut is_calm = self.led_until(plan) < at;
        if seen.is_some() {
            let look = following.glances.mean();
            let wanted = match (view, look) {
                (Some(view), Some(look)) => {
                    let place = now.position + view.lag;
                    let (along, gone) = self.going_on(plan, (following.before, look), (at, follow.every));
                    let view = View { lag: view.lag + (look.place + gone - place), ..view };
                    view.velocity(along, now.velocity, first.acceleration, follow.every)
                }
                _ => 0.0,
            };
            let (velocity, duration) = within(wanted, now, first, follow.every);
            for motion in &step.moves {
                let timeline = &mut self.timelines[motion.drive];
                timeline.forget(at);
                timeline.ramp(at, duration, velocity, RampShape::Linear);
            }
            following.before = look;
            let fastest = velocity.abs().max(now.velocity.abs());
            is_calm &= fastest * view.map_or(1.0, |view| view.rate) <= CALM;
        }
        self.phases[index] = if is_calm {
            Phase::UntilTime(self.brake(step, at))
        } else {
            let (next, look) = (at + apart(follow), at + follow.every);
            let glances = Glances::default();
            Phase::Following(Following { next, look, looked: at, glances, before: following.before })
        };
    }

    /// How fast the place of a drive that follows goes on until the next look, `every` [s] from now, and how far it has
    /// gone since the mean of this one: as between the looks, as far as what goes on beside it does.
    fn going_on(
        &self,
        plan: &Plan,
        (before, look): (Option<Look>, Look),
        (now, every): (f64, f64),
    ) -> (f64, f64) {
        let Some(before) = before else { return (0.0, 0.0) };
        let along = (look.place - before.place) / (look.at - before.at);
        let was = [before.at, look.at];
        let share = |will: [f64; 2]| self.share(plan, was, will);
        let gone = if now > look.at { along * share([look.at, now]) * (now - look.at) } else { 0.0 };
        (along * share([now, now + every]), gone)
    }

    /// How fast what goes on beside drives that follow goes in the time `will` over how fast it went in the time `was`
    /// [s], as far as the plan knows it: of the drive that slows down least. 1 where nothing went on.
    fn share(&self, plan: &Plan, was: [f64; 2], will: [f64; 2]) -> f64 {
        let stage = self.stage..self.begun;
        let leading = plan.steps[stage].iter().filter(|step| !matches!(step.until, Until::Follow(_)));
        let shares = leading.flat_map(|step| &step.moves).filter_map(|motion| {
            let timeline = &self.timelines[motion.drive];
            let mean = |[from, to]: [f64; 2]| {
                (timeline.motion(to).position - timeline.motion(from).position) / (to - from)
            };
            let (was, will) = (mean(was), mean(will));
            (was.abs() > STILL * motion.velocity.abs()).then(|| (will / was).clamp(0.0, 1.0))
        });
        shares.reduce(f64::max).unwrap_or(1.0)
    }

    /// What goes on beside drives that follow has changed at a time [s]: they look at once, though no sooner than half
    /// the usual time after the look before.
    pub(super) fn look_soon(&mut self, plan: &Plan, at: f64) {
        for index in self.stage..self.begun {
            if let Phase::Following(following) = &mut self.phases[index]
                && following.before.is_some()
            {
                let soon = at.max(following.looked + 0.5 * look_every(&plan.steps[index]));
                following.look = following.look.min(soon);
                following.next = following.next.min(following.look);
            }
        }
    }
}

/// Time between looks of a drive that follows [s].
pub(super) fn look_every(step: &Step) -> f64 {
    if let Until::Follow(follow) = &step.until { follow.every } else { f64::INFINITY }
}
