//! The way of a lift at rest to a time of its plan: at once, or from rest to rest where what has been matters.

use super::{GoesOn, StaticLift, placed};
use crate::event::{Event, EventLog};
use crate::plan::condition::Seen;
use crate::plan::switching::Switching;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::statics::losses::Losses;
use crate::statics::{NoEquilibrium, Rest, Statics};
use crate::stepper::flows;
use crate::system::System;

/// Time between looks at the condition of a step while another one ends [s].
const LOOK: f64 = 0.1;
/// Farthest look ahead: where a condition holds there, what lies before it is looked at by halves [s].
const AHEAD: f64 = 16.0 * LOOK;
/// Longest and shortest part of a plan that is followed at once; when a condition is met is known to the latter [s].
const LONGEST: f64 = 5.0;
const SHORTEST: f64 = 1e-3;
/// Unstretched rope, wound in one part, that may be in doubt [m]: the error is of second order in it.
const DOUBT: f64 = 1e-6;

/// Where a lift that was followed has got to, so that the same way need not be gone twice. No part before that ends because
/// of the time that was asked for: whoever goes on from here finds the same as from the start, to the last bit.
#[derive(Debug, Clone)]
pub(super) struct Trail {
    increment: Option<Vec<f64>>,
    losses: Losses,
    stride: f64,
    state: State,
    statics: Statics,
    events: Vec<Event>,
    slides: Vec<(f64, usize)>,
}

impl Trail {
    /// Whether it is part of the way to `time` [s] of a lift that begins `increment` from its start.
    fn leads_to(&self, time: f64, increment: Option<&[f64]>, losses: Losses) -> bool {
        self.state.time <= time && self.increment.as_deref() == increment && self.losses == losses
    }
}

impl StaticLift {
    /// Whether what the lift comes to at `time` [s] of its plan depends on the way: where that waits for a condition or
    /// follows what there is to see before, or has put in a pin, which holds its joint where it had come to by then.
    pub(super) fn has_way(&self, time: f64) -> bool {
        let mut ahead = self.state.plan.clone();
        ahead.advance(&self.system.plan, 0.0, time, None, &mut EventLog::new());
        let is_put_in = |pin: &Switching| matches!(pin.wanted(ahead.begun()), (true, Some(_)));
        ahead.has_looked(&self.system.plan) || self.system.pins.iter().any(is_put_in)
    }

    /// At once.
    pub(super) fn jump(&mut self, time: f64, losses: Losses) -> Result<Rest, NoEquilibrium> {
        let Self { system, state, statics, log, .. } = self;
        log.events.clear();
        state.plan.advance(&system.plan, 0.0, time, None, log);
        state.time = time;
        part(system, state);
        statics.settle(system, state, losses)
    }

    /// From rest to rest, the start being where `increment` has brought it. A condition is met within `SHORTEST` of where
    /// it begins to hold: what holds for less than `AHEAD`, and not at its end, may be missed.
    pub(super) fn follow(
        &mut self,
        time: f64,
        increment: Option<&[f64]>,
        losses: Losses,
        goes_on: GoesOn,
    ) -> Result<Rest, NoEquilibrium> {
        let known = self.trail.take().filter(|trail| trail.leads_to(time, increment, losses));
        let (mut rest, mut stride) = match known {
            Some(trail) => (None, self.take_up(trail)),
            None => (Some(self.set_out(losses)?), LONGEST),
        };
        let leave = |stride, state: &State, statics: &Statics, events: &[Event], slides: &[(f64, usize)]| {
            let (state, statics, slides) = (state.clone(), statics.clone(), slides.to_vec());
            let (increment, events) = (increment.map(<[f64]>::to_vec), events.to_vec());
            Trail { increment, losses, stride, state, statics, events, slides }
        };
        let mut trail = None;
        let mut before = self.state.clone();
        let Self { system, state, statics, log, slides, .. } = self;
        let mut support = vec![0.0; system.groups.len()];
        while state.time < time {
            unless_stopped(goes_on)?;
            before.copy_from(state);
            let (now, stride_before) = (state.time, stride);
            flows::supports(system, &state.tension, &mut support);
            // What is due now begins now, so that it is known what that waits for.
            let known = log.events.len();
            flows::advance_plan(system, state, &placed(system, state), (now.next_up(), &support), log);
            let waits = state.plan.waits_for_condition();
            stride = stride.min(if waits { AHEAD } else { LONGEST });
            let mut due = state.plan.next_time(&system.plan, now);
            if waits {
                // Nothing but the condition may come in between.
                stride = if due < now + stride { stride.min(LOOK) } else { stride };
                due = f64::INFINITY;
            }
            let end = (now + stride).min(due);
            let next = end.min(time);
            if next < end && trail.is_none() {
                trail = Some(leave(stride_before, &before, statics, &log.events[..known], slides));
            }
            flows::advance_plan(system, state, &placed(system, state), (next, &support), log);
            state.time = next;
            part(system, state);
            let is_short = next - now <= SHORTEST;
            // Held as long as there is a way on.
            statics.may_slide = is_short;
            let found = statics.follow(system, state, losses);
            statics.may_slide = true;
            let is_late = found.is_ok() && waits && is_fulfilled(system, state, &mut support);
            if is_short || (found.is_ok() && statics.doubt <= DOUBT && !is_late) {
                found?;
                note(slides, statics, next);
                rest = None;
                // The doubt is of second order in the length of a part: twice as long, four times as much.
                stride *= if statics.doubt > 0.25 * DOUBT { 1.0 } else { 2.0 };
            } else {
                state.copy_from(&before);
                log.events.truncate(known);
                statics.resume(system, state);
                stride = 0.5 * (next - now);
            }
        }
        self.trail = trail.or_else(|| Some(leave(stride, state, statics, &log.events, slides)));
        rest.map_or_else(|| self.statics.rest(&self.system, &self.state), Ok)
    }

    /// To the equilibrium of the start.
    fn set_out(&mut self, losses: Losses) -> Result<Rest, NoEquilibrium> {
        self.log.events.clear();
        part(&self.system, &mut self.state);
        let rest = self.statics.settle(&self.system, &mut self.state, losses)?;
        note(&mut self.slides, &mut self.statics, self.state.time);
        Ok(rest)
    }

    /// To where it has been before; how long the next part may be [s].
    fn take_up(&mut self, trail: Trail) -> f64 {
        let Trail { stride, state, statics, events, slides, .. } = trail;
        (self.state, self.statics, self.slides) = (state, statics, slides);
        self.log.events = events;
        stride
    }
}

/// What slid to the equilibrium found last, at `time` [s].
pub(super) fn note(slides: &mut Vec<(f64, usize)>, statics: &mut Statics, time: f64) {
    slides.extend(statics.slid.drain(..).map(|group| (time, group)));
}

fn unless_stopped(goes_on: GoesOn) -> Result<(), NoEquilibrium> {
    if goes_on() {
        return Ok(());
    }
    Err(NoEquilibrium { element: "the search".to_owned(), cause: "it was stopped".to_owned() })
}

/// Whether a step under way waits for what holds now.
fn is_fulfilled(system: &System, state: &State, support: &mut [f64]) -> bool {
    flows::supports(system, &state.tension, support);
    let kinematics = &placed(system, state).kinematics;
    let tension =
        |row: usize| flows::tension_at(system, kinematics, (row, &state.tension), [&state.q, &state.v]);
    state.plan.is_fulfilled(&system.plan, &Seen { support, tension: &tension, kinematics })
}

/// Ropes that have been cut before now; slings and pins as the steps that have begun have them.
fn part(system: &System, state: &mut State) {
    for cut in &system.cuts {
        if cut.due.is_before(state.time, &state.plan) {
            if let Some(line) = cut.rope.checked_sub(system.rope_count) {
                system.moorings().skip(line).take(1).for_each(|mooring| state.q[mooring.mark] = 1.0);
                continue;
            }
            state.modes[system.rows.first[cut.rope]..system.rows.first[cut.rope + 1]].fill(Mode::Parted);
        }
    }
    for removal in system.removals.iter().filter(|removal| removal.due.is_before(state.time, &state.plan)) {
        let rows = system.rows.first[removal.touch]..system.rows.first[removal.touch + 1];
        state.modes[rows].fill(Mode::Parted);
    }
    for sling in &system.slings {
        let (is_on, _) = sling.wanted(state.plan.begun());
        let rows = system.rows.first[sling.constraint]..system.rows.first[sling.constraint + 1];
        for mode in state.modes[rows].iter_mut().filter(|mode| is_on == (**mode == Mode::Off)) {
            *mode = match *mode {
                Mode::Parted => Mode::Parted,
                _ if is_on => Mode::Slack,
                _ => Mode::Off,
            };
        }
    }
    for pinning in &system.pins {
        let (is_in, _) = pinning.wanted(state.plan.begun());
        state.modes[system.rows.first[pinning.constraint]] = if is_in { Mode::Acting } else { Mode::Slack };
    }
}
