//! Steps of a plan: which drives move, and what ends them.

use serde::{Deserialize, Serialize};

use super::drive::Timeline;
use crate::event::{EventKind, EventLog};
use crate::spec::RampShape;

/// One drive in a step.
#[derive(Debug, Clone, PartialEq)]
pub struct Move {
    /// Index of the drive.
    pub drive: usize,
    /// Signed velocity [m/s or rad/s].
    pub velocity: f64,
    /// Acceleration limit [m/s² or rad/s²].
    pub acceleration: f64,
    /// Course of the ramps.
    pub shape: RampShape,
    /// Acceleration with which it brakes at the end, where that is another, and what holds it from then on [N].
    pub emergency: Option<Emergency>,
}

/// How a drive is stopped in an emergency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Emergency {
    /// With which it is asked to stop [m/s² or rad/s²].
    pub acceleration: f64,
    /// What the brake holds [N]; none is the motor's capacity.
    pub brake: Option<f64>,
}

/// What ends a step; drives then brake to rest.
#[derive(Debug, Clone, PartialEq)]
pub enum Until {
    /// Brakes from this time [s] on.
    BrakeFrom(f64),
    /// At rest after this signed distance [m or rad].
    Distance(f64),
    /// Brakes after this time [s] in the step.
    Duration(f64),
    /// The contacts of a group have lost a share of the weight.
    LoadTransferred {
        /// Index of the group.
        group: usize,
        /// Weight [N].
        weight: f64,
        /// Share.
        at_least: f64,
    },
    /// No contact of the group carries.
    Clear(usize),
    /// Never.
    EndOfRun,
}

/// A step of the plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Name, shown in events.
    pub name: String,
    /// Drives that move; none holds.
    pub moves: Vec<Move>,
    /// Earliest time [s].
    pub start_at: Option<f64>,
    /// What ends it.
    pub until: Until,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
enum Phase {
    /// Until the step may begin, at the earliest at this time.
    Waiting(f64),
    /// Until a condition holds.
    UntilCondition,
    /// Until this time.
    UntilTime(f64),
    /// All steps are done, or the last never ends.
    Done,
}

/// Where the plan stands, and the course of every drive.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlanState {
    /// Course of every drive.
    pub timelines: Vec<Timeline>,
    step: usize,
    phase: Phase,
}

impl PlanState {
    /// Takes over what `other` has of the same plan.
    pub fn copy_from(&mut self, other: &Self) {
        for (timeline, other) in self.timelines.iter_mut().zip(&other.timelines) {
            timeline.copy_from(other);
        }
        self.step = other.step;
        self.phase = other.phase;
    }

    /// Before the first step.
    pub fn new(timelines: Vec<Timeline>) -> Self {
        Self { timelines, step: 0, phase: Phase::Waiting(0.0) }
    }

    /// Lets the plan act on the interval from `from` to `to` [s]: everything that is due before `to`.
    /// Conditions see `support`, the normal force of each contact group [N] at `from`.
    pub fn advance(&mut self, plan: &[Step], from: f64, to: f64, support: &[f64], log: &mut EventLog) {
        while let Some(step) = plan.get(self.step) {
            match self.phase {
                Phase::Waiting(ready) => {
                    let begin = ready.max(step.start_at.unwrap_or(ready));
                    if begin >= to {
                        return;
                    }
                    log.push(begin, EventKind::StepBegin, self.step);
                    self.phase = self.begin(step, begin);
                }
                Phase::UntilCondition => {
                    if !holds(&step.until, support) {
                        return;
                    }
                    self.phase = Phase::UntilTime(self.brake(step, from));
                }
                Phase::UntilTime(end) => {
                    if end >= to {
                        return;
                    }
                    log.push(end, EventKind::StepEnd, self.step);
                    self.step += 1;
                    self.phase = Phase::Waiting(end);
                }
                Phase::Done => return,
            }
        }
    }

    /// The next time after `time` [s] at which something is due that is known now: the start or end of a step,
    /// of a ramp.
    pub fn next_time(&self, plan: &[Step], time: f64) -> f64 {
        let due = match (self.phase, plan.get(self.step)) {
            (Phase::Waiting(ready), Some(step)) => ready.max(step.start_at.unwrap_or(ready)),
            (Phase::UntilTime(end), Some(_)) => end,
            _ => f64::INFINITY,
        };
        let due = if due > time { due } else { f64::INFINITY };
        self.timelines.iter().map(|timeline| timeline.next_break(time)).fold(due, f64::min)
    }

    /// True where the step under way ends on a condition.
    pub fn waits_for_condition(&self) -> bool {
        self.phase == Phase::UntilCondition
    }

    /// True where the step under way waits for a condition and `support`, the normal force of each contact group
    /// [N], fulfils it.
    pub fn is_fulfilled(&self, plan: &[Step], support: &[f64]) -> bool {
        self.phase == Phase::UntilCondition
            && plan.get(self.step).is_some_and(|step| holds(&step.until, support))
    }

    /// How many steps have begun.
    pub fn begun(&self) -> usize {
        match self.phase {
            Phase::Waiting(_) => self.step,
            _ => self.step + 1,
        }
    }

    /// Name of the step that has begun and not ended, if any.
    pub fn current<'a>(&self, plan: &'a [Step]) -> Option<&'a str> {
        match self.phase {
            Phase::UntilCondition | Phase::UntilTime(_) => plan.get(self.step).map(|step| step.name.as_str()),
            Phase::Waiting(_) | Phase::Done => None,
        }
    }

    fn begin(&mut self, step: &Step, begin: f64) -> Phase {
        if let Until::Distance(distance) = step.until {
            let end = step.moves.iter().map(|motion| {
                let Move { drive, velocity, acceleration, shape, .. } = *motion;
                self.timelines[drive].travel(begin, distance, velocity, acceleration, shape)
            });
            return Phase::UntilTime(end.fold(begin, f64::max));
        }
        for motion in &step.moves {
            let Move { drive, velocity, acceleration, shape, .. } = *motion;
            self.timelines[drive].change(begin, velocity, acceleration, shape);
        }
        match step.until {
            Until::BrakeFrom(time) => Phase::UntilTime(self.brake(step, time.max(begin))),
            Until::Duration(duration) => Phase::UntilTime(self.brake(step, begin + duration)),
            Until::LoadTransferred { .. } | Until::Clear(_) => Phase::UntilCondition,
            Until::EndOfRun | Until::Distance(_) => Phase::Done,
        }
    }

    fn brake(&mut self, step: &Step, at: f64) -> f64 {
        let ends = step.moves.iter().map(|motion| {
            let acceleration = motion.emergency.map_or(motion.acceleration, |stop| stop.acceleration);
            let timeline = &mut self.timelines[motion.drive];
            let end = timeline.change(at, 0.0, acceleration, motion.shape);
            if let Some(brake) = motion.emergency.and_then(|stop| stop.brake) {
                timeline.brake(at, brake);
            }
            end
        });
        ends.fold(at, f64::max)
    }
}

fn holds(until: &Until, support: &[f64]) -> bool {
    match *until {
        Until::LoadTransferred { group, weight, at_least } => 1.0 - support[group] / weight >= at_least,
        Until::Clear(group) => support[group] <= 0.0,
        _ => false,
    }
}
