//! How the steps of a plan go on: when they begin, what they ask of drives, when they end.

mod heaving;
mod holed;
mod looks;

use serde::{Deserialize, Serialize};

use super::condition::Seen;
use super::drive::Timeline;
use super::follow::SETTLING;
use super::heave::Compensating;
use super::holes::Running;
use super::step::{DriveStop, EmergencyStop, Leading, Move, Plan, Step, StopAt, Until};
use crate::event::{EventKind, EventLog};
use looks::{Following, look_every};

/// What a step may go beyond the end of a range by rounding.
const ROUNDING: f64 = 1e-9;
/// Share of the time by which ramps that add up to it may miss it by rounding.
const SAME_TIME: f64 = 1e-12;

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
enum Phase {
    /// It has not begun.
    Ahead,
    /// Until a condition holds, or until this time, at which a drive has come to the end of its range.
    UntilCondition(f64),
    /// Until this time.
    UntilTime(f64),
    /// Until this time, at which a drive has come to the end of its range.
    UntilLimit(f64),
    /// It never ends.
    Open,
    /// It ended at this time.
    Ended(f64),
    /// A drive follows until all that began with its step has ended.
    Following(Following),
}

/// Where the plan stands, and the course of every drive.
///
/// Steps that begin with one another are a stage; a step that does not waits until all of the stage before have
/// ended. Steps begin in their order. A drive that a program commands is moved by no step any more.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanState {
    /// Course of every drive.
    pub timelines: Vec<Timeline>,
    phases: Vec<Phase>,
    /// What every compensator does.
    compensating: Vec<Compensating>,
    /// What is known of every tank with holes.
    running: Vec<Running>,
    /// First step of the stage that is under way or comes next.
    stage: usize,
    /// How many steps have begun.
    begun: usize,
    /// When the step that began last did [s].
    begin: f64,
    /// When the emergency stop is due [s], as far as that is known; after it infinity.
    stop_at: f64,
    stopped: bool,
}

/// What is due next.
#[derive(Debug, Clone, Copy)]
enum Due {
    End(usize),
    /// The same at the end of a range.
    Limit(usize),
    /// A glance of a drive that follows.
    Glance(usize),
    /// It has followed long enough.
    Rest(usize),
    /// A glance of a compensator, or its rest.
    Compensate(usize),
    Begin,
    Stop,
}

impl PlanState {
    /// Takes over what `other` has of the same plan.
    pub fn copy_from(&mut self, other: &Self) {
        for (timeline, other) in self.timelines.iter_mut().zip(&other.timelines) {
            timeline.copy_from(other);
        }
        self.phases.copy_from_slice(&other.phases);
        self.compensating.copy_from_slice(&other.compensating);
        for (running, other) in self.running.iter_mut().zip(&other.running) {
            running.copy_from(other);
        }
        (self.stage, self.begun, self.begin) = (other.stage, other.begun, other.begin);
        (self.stop_at, self.stopped) = (other.stop_at, other.stopped);
    }

    /// Gives back what a saved state does not hold, from `other`, one of the same lift.
    pub fn reattach(&mut self, other: &Self) {
        for (timeline, other) in self.timelines.iter_mut().zip(&other.timelines) {
            timeline.reattach(other);
        }
    }

    /// Before the first step of `plan`.
    pub fn new(plan: &Plan, timelines: Vec<Timeline>) -> Self {
        let stop_at = match plan.stop {
            Some(EmergencyStop { at: StopAt::Time(at), .. }) => at,
            _ => f64::MAX,
        };
        let phases = vec![Phase::Ahead; plan.steps.len()];
        let compensating = vec![Compensating::Off; plan.compensators.len()];
        let running = plan.holed.iter().map(Running::new).collect();
        let (stage, begun, begin, stopped) = (0, 0, 0.0, false);
        Self { timelines, phases, compensating, running, stage, begun, begin, stop_at, stopped }
    }

    /// Lets the plan act on the interval from `from` to `to` [s]: everything that is due before `to`.
    /// Conditions see what there is at `from`; none holds where nothing is seen.
    pub fn advance(&mut self, plan: &Plan, from: f64, to: f64, seen: Option<&Seen>, log: &mut EventLog) {
        self.let_run(plan, to, seen);
        let mut last = from;
        while !self.stopped {
            for index in self.stage..self.begun {
                let step = &plan.steps[index];
                if matches!(self.phases[index], Phase::UntilCondition(_)) && is_met(step, seen) {
                    self.phases[index] = Phase::UntilTime(self.brake(step, from));
                    self.look_soon(plan, from);
                }
            }
            let (at, due) = self.next_due(plan);
            if at >= to {
                // What ends and what begins at one time go on from one another, so that this is looked at once all of it is
                // done. Where nothing is seen nothing heaves.
                if seen.is_some() && self.switch_compensators(plan, last) {
                    continue;
                }
                return;
            }
            last = at.max(from);
            match due {
                Due::End(index) => self.end(index, at, log),
                Due::Limit(index) => {
                    log.push(at, EventKind::PumpStopped, index);
                    self.end(index, at, log);
                }
                Due::Glance(index) => self.glance(plan, (index, at), seen),
                Due::Rest(index) => {
                    self.phases[index] = Phase::UntilTime(self.brake(&plan.steps[index], at));
                }
                Due::Compensate(index) => self.compensate(plan, (index, at), seen, log),
                Due::Begin => {
                    self.put_right(&plan.steps[self.begun], from, seen);
                    self.begin_next(plan, (at, seen.is_some()), log);
                }
                Due::Stop => self.stop(plan, at, log),
            }
        }
    }

    /// Ends what ends with the run at `end` [s], within rounding: no interval follows in which it would be due.
    pub fn close(&mut self, end: f64, log: &mut EventLog) {
        for index in self.stage..self.begun {
            if let Phase::UntilTime(at) = self.phases[index]
                && !self.stopped
                && at <= end + SAME_TIME * end
            {
                self.end(index, at.min(end), log);
            }
        }
    }

    fn end(&mut self, index: usize, at: f64, log: &mut EventLog) {
        log.push(at, EventKind::StepEnd, index);
        self.phases[index] = Phase::Ended(at);
    }

    /// What is due next, and when [s]; infinity where nothing is known to be.
    fn next_due(&self, plan: &Plan) -> (f64, Due) {
        let mut next = (f64::INFINITY, Due::Begin);
        for index in self.stage..self.begun {
            let (end, due) = match self.phases[index] {
                Phase::UntilTime(end) => (end, Due::End(index)),
                Phase::UntilLimit(end) => (end, Due::Limit(index)),
                Phase::UntilCondition(end) if end < f64::MAX => (end, Due::Limit(index)),
                Phase::Following(Following { next, .. }) => {
                    let rest = self.led_until(plan) + SETTLING * look_every(&plan.steps[index]);
                    if rest <= next { (rest, Due::Rest(index)) } else { (next, Due::Glance(index)) }
                }
                _ => continue,
            };
            if end < next.0 {
                next = (end, due);
            }
        }
        for (index, compensating) in self.compensating.iter().enumerate() {
            let at = match compensating {
                Compensating::Off => continue,
                Compensating::On(watch) => watch.next,
                Compensating::Stopping(end) => *end,
            };
            if at < next.0 {
                next = (at, Due::Compensate(index));
            }
        }
        let begin = self.next_begin(plan);
        if begin < next.0 {
            next = (begin, Due::Begin);
        }
        if self.stop_at < next.0.min(f64::MAX) {
            next = (self.stop_at, Due::Stop);
        }
        next
    }

    /// When the next step begins [s]; infinity while that is not known.
    fn next_begin(&self, plan: &Plan) -> f64 {
        let Some(step) = plan.steps.get(self.begun) else { return f64::INFINITY };
        let ready = if step.with_previous && self.begun > self.stage {
            self.begin
        } else {
            self.phases[self.stage..self.begun].iter().map(ended).fold(0.0, f64::max)
        };
        ready.max(step.start_at.unwrap_or(ready))
    }

    /// When all that goes on beside drives that follow has ended [s]; infinity while that is not known.
    fn led_until(&self, plan: &Plan) -> f64 {
        let beside = |step: &&Step| step.with_previous;
        let stage = 1 + plan.steps[self.stage + 1..].iter().take_while(beside).count();
        let steps = plan.steps[self.stage..][..stage].iter().zip(&self.phases[self.stage..]);
        let leading = steps.filter(|(step, _)| !matches!(step.until, Until::Follow(_)));
        leading.map(|(_, phase)| ended(phase)).fold(0.0, f64::max)
    }

    /// Drums that have slipped since are where they are, and not where the plan has brought them: ways of a step count
    /// from there, positions as they are.
    fn put_right(&mut self, step: &Step, now: f64, seen: Option<&Seen>) {
        let Some(seen) = seen else { return };
        for motion in &step.moves {
            if let Some(place) = motion.slips {
                let timeline = &mut self.timelines[motion.drive];
                timeline.put_right(seen.kinematics.q[place] - timeline.motion(now).position);
            }
        }
    }

    fn begin_next(&mut self, plan: &Plan, (at, is_seen): (f64, bool), log: &mut EventLog) {
        let (index, step) = (self.begun, &plan.steps[self.begun]);
        if !step.with_previous {
            self.stage = index;
        }
        log.push(at, EventKind::StepBegin, index);
        (self.begun, self.begin) = (index + 1, at);
        // What it does not compensate any more comes to rest first, and places count from there.
        self.phases[index] = Phase::Open;
        if is_seen {
            self.switch_compensators(plan, at);
        }
        self.phases[index] = self.begin_step(plan, step, at);
        if let Some(EmergencyStop { at: StopAt::InStep(step, after), .. }) = plan.stop
            && step == index
        {
            self.stop_at = at + after;
        }
    }

    /// True after an emergency stop; programs command no drive any more then.
    pub fn is_stopped(&self) -> bool {
        self.stopped
    }

    /// All drives brake, and the plan ends.
    fn stop(&mut self, plan: &Plan, at: f64, log: &mut EventLog) {
        // Before the first step it is in none, which has no name.
        log.push(at, EventKind::EmergencyStop, self.begun.checked_sub(1).unwrap_or(plan.steps.len()));
        for timeline in &mut self.timelines {
            if let Some(how) = timeline.commanded() {
                timeline.stop(at, &how);
            }
        }
        for of in &plan.compensators {
            self.stop_compensating(of, at);
        }
        // Of one drive in several steps the last that has begun has the last word.
        let begun = |one: &&DriveStop| one.step == 0 || one.step < self.begun;
        for one in plan.stop.iter().flat_map(|stop| &stop.drives).filter(begun) {
            self.timelines[one.drive].stop(at, &one.how);
        }
        self.stopped = true;
    }

    /// The next time after `time` [s] at which something is due that is known now: the start or end of a step,
    /// of a ramp, an emergency stop.
    pub fn next_time(&self, plan: &Plan, time: f64) -> f64 {
        let due = if self.stopped { f64::INFINITY } else { self.next_due(plan).0 };
        let breaks = self.timelines.iter().map(|timeline| timeline.next_break(time));
        let glances = self.running.iter().map(|running| running.next);
        [due].into_iter().chain(glances).filter(|&at| at > time).chain(breaks).fold(f64::INFINITY, f64::min)
    }

    /// True where a step under way ends on a condition.
    pub fn waits_for_condition(&self) -> bool {
        let waits = |phase: &Phase| matches!(phase, Phase::UntilCondition(_));
        !self.stopped && self.phases[self.stage..self.begun].iter().any(waits)
    }

    /// True where a step that has begun ends on a condition, or would have, or follows what there is to see.
    pub fn has_looked(&self, plan: &Plan) -> bool {
        let looks = |step: &Step| matches!(step.until, Until::Condition(_) | Until::Follow(_));
        plan.steps[..self.begun].iter().any(looks)
    }

    /// True where a step under way waits for a condition that holds by what is `seen`.
    pub fn is_fulfilled(&self, plan: &Plan, seen: &Seen) -> bool {
        self.lacks(plan, seen) <= 0.0
    }

    /// The least that a condition lacks to hold, by what is `seen`, of those for which steps under way wait, see
    /// [`super::condition::Condition::lacks`]; infinite where none does.
    pub fn lacks(&self, plan: &Plan, seen: &Seen) -> f64 {
        let waits = |index: &usize| matches!(self.phases[*index], Phase::UntilCondition(_));
        let under_way = (self.stage..self.begun).filter(|_| !self.stopped).filter(waits);
        let lacks = under_way.filter_map(|index| match &plan.steps[index].until {
            Until::Condition(condition) => Some(condition.lacks(seen)),
            _ => None,
        });
        lacks.fold(f64::INFINITY, f64::min)
    }

    /// How many steps have begun.
    pub fn begun(&self) -> usize {
        self.begun
    }

    /// The steps that have ended, by their numbers, and when they did [s].
    pub fn ended(&self) -> impl Iterator<Item = (usize, f64)> {
        let end = |phase: &Phase| if let Phase::Ended(at) = phase { Some(*at) } else { None };
        self.phases.iter().enumerate().filter_map(move |(index, phase)| Some((index, end(phase)?)))
    }

    /// The step that began last, by its number, and when it did [s].
    pub fn begun_last(&self) -> Option<(usize, f64)> {
        Some((self.begun.checked_sub(1)?, self.begin))
    }

    /// Name of the step that began last of those that have not ended, if any.
    pub fn current<'a>(&self, plan: &'a Plan) -> Option<&'a str> {
        let under_way = |index: &usize| {
            matches!(
                self.phases[*index],
                Phase::UntilCondition(_) | Phase::UntilTime(_) | Phase::UntilLimit(_) | Phase::Following(_)
            )
        };
        let last = (self.stage..self.begun).rev().find(under_way).filter(|_| !self.stopped);
        last.map(|index| plan.steps[index].name.as_str())
    }

    fn begin_step(&mut self, plan: &Plan, step: &Step, begin: f64) -> Phase {
        if let Until::Follow(follow) = &step.until {
            return Phase::Following(Following::from(begin, follow));
        }
        match &step.until {
            Until::Leading(leading) => return Phase::UntilTime(self.lead(step, leading, begin)),
            Until::Distance(distance) => {
                let by = std::slice::from_ref(distance);
                return Phase::UntilTime(self.travel(plan, step, (by, false), begin));
            }
            Until::Positions(to) => return Phase::UntilTime(self.travel(plan, step, (to, true), begin)),
            _ => {}
        }
        let room = self.room(step, begin);
        let most = match step.until {
            Until::Along(wanted) => wanted.min(room),
            Until::Condition(_) => room,
            _ => f64::INFINITY,
        };
        if most < f64::INFINITY {
            let mut last = begin;
            for motion in &step.moves {
                let Move { drive, velocity, acceleration, shape, .. } = *motion;
                let by = most.copysign(velocity);
                last = self.timelines[drive].travel(begin, by, velocity, acceleration, shape).max(last);
            }
            return match step.until {
                Until::Condition(_) => Phase::UntilCondition(last),
                Until::Along(wanted) if wanted > room * (1.0 + ROUNDING) => Phase::UntilLimit(last),
                _ => Phase::UntilTime(last),
            };
        }
        for motion in &step.moves {
            let Move { drive, velocity, acceleration, shape, .. } = *motion;
            if self.timelines[drive].commanded().is_none() {
                self.timelines[drive].change(begin, velocity, acceleration, shape);
            }
        }
        match step.until {
            Until::BrakeFrom(time) => Phase::UntilTime(self.brake(step, time.max(begin))),
            Until::Duration(duration) => Phase::UntilTime(self.brake(step, begin + duration)),
            Until::Condition(_) => Phase::UntilCondition(f64::MAX),
            _ => Phase::Open,
        }
    }

    /// Leads the drives of a step along their series; when the last is there.
    fn lead(&mut self, step: &Step, leading: &Leading, begin: f64) -> f64 {
        let Leading { rate, acceleration, series } = leading;
        let mut last = begin;
        for (motion, series) in step.moves.iter().zip(series) {
            let timeline = &mut self.timelines[motion.drive];
            if timeline.commanded().is_none() {
                last = timeline.lead(begin, series, (*rate, *acceleration)).max(last);
            }
        }
        last
    }

    /// Lets drives go by what is `given`, or to there, one number for all or each; when the last is there.
    fn travel(&mut self, plan: &Plan, step: &Step, (given, is_position): (&[f64], bool), begin: f64) -> f64 {
        let mut last = begin;
        for (motion, given) in step.moves.iter().zip(given.iter().cycle()) {
            let Move { drive, velocity, acceleration, shape, reel, .. } = *motion;
            let here = self.place(plan, drive, begin);
            let timeline = &mut self.timelines[drive];
            if timeline.commanded().is_some() {
                continue;
            }
            let by = match (reel, is_position) {
                (None, true) => given - here,
                (None, false) => *given,
                (Some(reel), true) => reel.position(*given) - here,
                (Some(reel), false) => reel.position(reel.gone(here) + given) - here,
            };
            last = timeline.travel(begin, by, velocity, acceleration, shape).max(last);
        }
        last
    }

    /// How far the drives of a step can go until the first is at the end of its range [kg].
    fn room(&self, step: &Step, begin: f64) -> f64 {
        let rooms = step.moves.iter().filter_map(|motion| {
            let [least, most] = motion.range?;
            let position = self.timelines[motion.drive].planned(begin).position;
            Some(if motion.velocity > 0.0 { most - position } else { position - least })
        });
        rooms.fold(f64::INFINITY, f64::min).max(0.0)
    }

    fn brake(&mut self, step: &Step, at: f64) -> f64 {
        let ends = step.moves.iter().map(|motion| {
            let acceleration = motion.emergency.map_or(motion.acceleration, |stop| stop.acceleration);
            let timeline = &mut self.timelines[motion.drive];
            if timeline.commanded().is_some() {
                return at;
            }
            let end = timeline.change(at, 0.0, acceleration, motion.shape);
            if let Some(brake) = motion.emergency.and_then(|stop| stop.brake) {
                timeline.brake(at, brake);
            }
            end
        });
        ends.fold(at, f64::max)
    }
}

/// When a step ended [s]; infinity while it has not.
fn ended(phase: &Phase) -> f64 {
    if let Phase::Ended(at) = phase { *at } else { f64::INFINITY }
}

fn is_met(step: &Step, seen: Option<&Seen>) -> bool {
    match (&step.until, seen) {
        (Until::Condition(condition), Some(seen)) => condition.holds(seen),
        _ => false,
    }
}
