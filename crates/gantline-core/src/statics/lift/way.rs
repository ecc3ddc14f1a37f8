//! The way of a lift at rest to a time of its plan: at once, or from rest to rest where what has been matters.

use super::pace::{LONGEST, MET, Pace, SHORTEST};
use super::{GoesOn, StaticLift, placed};
use crate::event::{Event, EventKind, EventLog};
use crate::plan::condition::{Seen, Support};
use crate::plan::switching::Switching;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::statics::losses::Losses;
use crate::statics::{NoEquilibrium, Rest, Statics};
use crate::stepper::frame::Frame;
use crate::stepper::{flows, slinging};
use crate::system::System;
use crate::tree::kinematics::Kinematics;

/// Time between looks at the condition of a step while another one ends [s].
const LOOK: f64 = 0.1;
/// Farthest look ahead: where a condition holds there, what lies before it is looked at [s].
const AHEAD: f64 = 16.0 * LOOK;
/// How much too short a sling may seem where it is put on, since friction of sheaves is left out there [m].
const REACH: f64 = 0.01;
/// Unstretched rope, wound in one part, that may be in doubt [m]: the error is of second order in it.
const DOUBT: f64 = 2e-6;

/// Where a lift that was followed has come by, so that the same way need not be gone twice: where steps of its plan began or
/// ended, and how far it got last. No part before these ends because of the time that was asked for: whoever goes on from there
/// finds the same as from the start, to the last bit.
#[derive(Debug, Clone, Default)]
pub(super) struct Trail {
    /// Of the lift that was followed, from its start.
    increment: Option<Vec<f64>>,
    losses: Losses,
    /// In the order of time.
    steps: Vec<Mark>,
    /// Events that were known at the last of these.
    events: usize,
    last: Option<Mark>,
}

/// A place on the way.
#[derive(Debug, Clone)]
struct Mark {
    pace: Pace,
    state: State,
    statics: Statics,
    events: Vec<Event>,
    slides: Vec<(f64, usize)>,
}

impl Trail {
    /// Is of the lift that begins `increment` from its start from now on; what was known of others is forgotten.
    fn is_of(&mut self, increment: Option<&[f64]>, losses: Losses) {
        if self.increment.as_deref() != increment || self.losses != losses {
            *self = Self { increment: increment.map(<[f64]>::to_vec), losses, ..Self::default() };
        }
    }

    /// The place known that is nearest before `time` [s].
    fn before(&self, time: f64) -> Option<Mark> {
        let known = self.steps.iter().chain(&self.last).filter(|mark| mark.state.time <= time);
        known.max_by(|one, other| one.state.time.total_cmp(&other.state.time)).cloned()
    }

    /// Keeps a place where there are as many events, if that is news.
    fn keep(&mut self, events: usize, mark: impl FnOnce() -> Mark) {
        if self.events < events {
            self.events = events;
            self.steps.push(mark());
        }
    }
}

impl StaticLift {
    /// Whether what the lift comes to at `time` [s] of its plan depends on the way: where that waits for a condition or
    /// follows what there is to see before, or has put in a pin, which holds its joint where it had come to by then, or has put
    /// on a sling, which has to reach there.
    pub(super) fn has_way(&self, time: f64) -> bool {
        let mut ahead = self.state.plan.clone();
        ahead.advance(&self.system.plan, 0.0, time, None, &mut EventLog::new());
        let is_put_in = |pin: &Switching| matches!(pin.wanted(ahead.begun()), (true, Some(_)));
        ahead.has_looked(&self.system.plan)
            || self.system.pins.iter().chain(&self.system.slings).any(is_put_in)
    }

    /// At once.
    pub(super) fn jump(&mut self, time: f64, losses: Losses) -> Result<Rest, NoEquilibrium> {
        self.advance(time);
        let Self { system, state, statics, .. } = self;
        part(system, state);
        statics.settle(system, state, losses)
    }

    /// The plan alone, to `time` [s].
    pub(super) fn advance(&mut self, time: f64) {
        let Self { system, state, log, .. } = self;
        log.events.clear();
        state.plan.advance(&system.plan, 0.0, time, None, log);
        state.time = time;
    }

    /// From rest to rest, the start being where `increment` has brought it; no farther than to where `until` is known, if
    /// that is given. A condition is met within `MET` of where it begins to hold: what holds for less than `AHEAD`,
    /// and not at its end, may be missed.
    pub(super) fn follow(
        &mut self,
        time: f64,
        increment: Option<&[f64]>,
        losses: Losses,
        until: Option<StepEvent>,
        goes_on: GoesOn,
    ) -> Result<Rest, NoEquilibrium> {
        self.trail.is_of(increment, losses);
        let (mut rest, mut pace) = match self.trail.before(time) {
            Some(mark) => (None, self.take_up(mark)),
            None => (Some(self.set_out(losses)?), Pace::new()),
        };
        let leave = |pace, state: &State, statics: &Statics, events: &[Event], slides: &[(f64, usize)]| {
            let (state, statics, slides) = (state.clone(), statics.clone(), slides.to_vec());
            Mark { pace, state, statics, events: events.to_vec(), slides }
        };
        let mut last = None;
        let mut before = self.state.clone();
        let Self { system, state, statics, log, slides, trail, .. } = self;
        let mut support = vec![Support::default(); system.groups.len()];
        while state.time < time && until.is_none_or(|until| until.time(log).is_none()) {
            unless_stopped(goes_on)?;
            before.copy_from(state);
            let (now, pace_before) = (state.time, pace);
            let frame = placed(system, state);
            flows::supports(system, &frame.kinematics, (&state.spots, &state.tension), &mut support);
            // What is due now begins now, so that it is known what that waits for.
            let known = log.events.len();
            flows::advance_plan(system, state, &frame, (now.next_up(), &support), log);
            let waits = state.plan.waits_for_condition();
            pace.stride = pace.stride.min(if waits { AHEAD } else { LONGEST });
            let mut due = state.plan.next_time(&system.plan, now);
            if waits {
                // Nothing but the condition may come in between.
                pace.stride = if due < now + pace.stride { pace.stride.min(LOOK) } else { pace.stride };
                due = f64::INFINITY;
            }
            pace.waits(log.events.len(), now, || lacks(system, state, &frame.kinematics, &support));
            let stride = pace.next(now);
            let end = (now + stride).min(due);
            // The way goes on past the time that is asked for; only where it does is there a part that ends at that time.
            let next = if last.is_some() { end.min(time) } else { end };
            let mark = || leave(pace_before, &before, statics, &log.events[..known], slides);
            let left = (next > time).then(mark);
            if last.is_none() {
                trail.keep(log.events.len(), mark);
            }
            flows::advance_plan(system, state, &placed(system, state), (next, &support), log);
            state.time = next;
            refuse_short(system, state, now)?;
            part(system, state);
            let is_short = next - now <= SHORTEST;
            // Held as long as there is a way on.
            statics.may_slide = is_short;
            let found = statics.follow(system, state, losses);
            statics.may_slide = true;
            let lack =
                if found.is_ok() && waits { lacks_now(system, state, &mut support) } else { f64::INFINITY };
            let is_late = lack <= 0.0;
            let is_good = match is_late {
                true => next - now <= MET,
                false => is_short || (found.is_ok() && statics.doubt <= DOUBT),
            };
            if is_good && next <= time {
                found?;
                note(slides, statics, next);
                rest = None;
                if is_late {
                    pace.is_met()
                } else {
                    pace.look(next, lack)
                }
                // The doubt is of second order in the length of a part: twice as long, four times as much.
                let is_whole = stride == pace.stride;
                pace.stride *= if statics.doubt <= 0.25 * DOUBT && is_whole { 2.0 } else { 1.0 };
                continue;
            }
            statics.slid.clear();
            state.copy_from(&before);
            log.events.truncate(known);
            statics.resume(system, state);
            if is_good {
                last = left;
                pace = pace_before;
            } else if is_late {
                pace.look(next, lack);
                pace.is_late_by(next);
            } else {
                pace.stride = 0.5 * (next - now);
            }
        }
        trail.last = last.or_else(|| Some(leave(pace, state, statics, &log.events, slides)));
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

    /// To where it has been before; how far it goes from there at once.
    fn take_up(&mut self, mark: Mark) -> Pace {
        let Mark { pace, state, statics, events, slides } = mark;
        (self.state, self.statics, self.slides) = (state, statics, slides);
        self.log.events = events;
        pace
    }
}

/// That a step of the plan begins or ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct StepEvent {
    pub kind: EventKind,
    pub step: usize,
}

impl StepEvent {
    /// When it was [s], if it is in the log.
    pub fn time(self, log: &EventLog) -> Option<f64> {
        let mut events = log.events.iter();
        events.find(|event| event.kind == self.kind && event.subject == self.step).map(|event| event.time)
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

/// What a condition lacks to hold now, see [`crate::plan::operation::PlanState::lacks`].
fn lacks_now(system: &System, state: &State, support: &mut [Support]) -> f64 {
    let kinematics = &placed(system, state).kinematics;
    flows::supports(system, kinematics, (&state.spots, &state.tension), support);
    lacks(system, state, kinematics, support)
}

/// The same by what supports do.
fn lacks(system: &System, state: &State, kinematics: &Kinematics, support: &[Support]) -> f64 {
    let tension =
        |row: usize| flows::tension_at(system, kinematics, (row, &state.tension), [&state.q, &state.v]);
    state.plan.lacks(&system.plan, &Seen { support, tension: &tension, kinematics })
}

/// Slings that are put on from here on have to reach: what holds a load before it hangs on them is where `state` has it.
///
/// # Errors
/// [`NoEquilibrium`] where one is too short, as a run ends there.
fn refuse_short(system: &System, state: &State, time: f64) -> Result<(), NoEquilibrium> {
    let row = |sling: &Switching| system.rows.first[sling.constraint];
    let is_put_on =
        |sling: &&Switching| state.modes[row(sling)] == Mode::Off && sling.wanted(state.plan.begun()).0;
    let mut put_on = system.slings.iter().filter(is_put_on).peekable();
    if put_on.peek().is_none() {
        return Ok(());
    }
    let mut frame = Frame::new(system);
    frame.update(system, state);
    let when = format!("at {time:.2} s");
    put_on.try_for_each(|sling| {
        slinging::too_short(system, &frame, &state.q, sling.constraint, REACH, &when)
            .map_or(Ok(()), |cause| {
                Err(NoEquilibrium { element: system.rope_name(sling.constraint).to_owned(), cause })
            })
    })
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
