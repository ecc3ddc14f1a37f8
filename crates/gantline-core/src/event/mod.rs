//! What happens at a moment: ropes going taut or slack, lift-off, flooding, steps of the plan.

pub mod afloat;
pub mod standstill;

use serde::{Deserialize, Serialize};

use crate::plan::heave::HeaveLimit;
use crate::system::System;

/// Kinds of events; names are those of the recording.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum EventKind {
    /// A rope starts to carry.
    Taut,
    /// A rope stops carrying.
    Slack,
    /// A rope has been cut.
    Cut,
    /// A rope has reached its breaking force.
    Broken,
    /// A rope has been taken off.
    Detached,
    /// A rope has been put on.
    Attached,
    /// The last contact force of a load has become zero.
    LiftOff,
    /// A load that hung free touches again.
    SetDown,
    /// A contact stops sliding.
    Stick,
    /// A contact starts to slide.
    Slip,
    /// The load has left a support beyond its edge.
    OffSupport,
    /// A support has been taken away.
    SupportRemoved,
    /// The wrap of a rope on a sheave has become zero.
    RopeOffSheave,
    /// A rope that was off a sheave touches it again.
    RopeOnSheave,
    /// A joint meets a stop.
    StopHit,
    /// A joint leaves a stop.
    StopLeft,
    /// A locking pin has been pulled.
    PinPulled,
    /// A locking pin has been put in.
    PinPutIn,
    /// A motor, or the brake in its place, pulls all it can, and its drum does not follow its drive.
    DrumSlips,
    /// It follows again.
    DrumHolds,
    /// A deck's edge or an opening of a vessel goes under water.
    Flooding,
    /// It comes out again.
    Surfacing,
    /// A vessel has turned over.
    Capsized,
    /// A step of the plan begins.
    StepBegin,
    /// A step of the plan ends.
    StepEnd,
    /// A tank is empty or full, so that the pumps of a step have stopped.
    PumpStopped,
    /// Heave compensation is at a limit.
    CompensationLimit(HeaveLimit),
    /// All drives are stopped, and the plan with them; the subject is the step that began last.
    EmergencyStop,
}

impl EventKind {
    /// True where a rope carries nothing from then on.
    pub fn parts_a_rope(self) -> bool {
        matches!(self, Self::Cut | Self::Broken | Self::Detached)
    }

    /// Name in recordings.
    pub fn name(self) -> &'static str {
        match self {
            Self::Taut => "taut",
            Self::Slack => "slack",
            Self::Cut => "cut",
            Self::Broken => "broken",
            Self::Detached => "detached",
            Self::Attached => "attached",
            Self::LiftOff => "lift_off",
            Self::SetDown => "set_down",
            Self::Stick => "stick",
            Self::Slip => "slip",
            Self::OffSupport => "off_support",
            Self::SupportRemoved => "support_removed",
            Self::RopeOffSheave => "rope_off_sheave",
            Self::RopeOnSheave => "rope_on_sheave",
            Self::StopHit => "stop_hit",
            Self::StopLeft => "stop_left",
            Self::PinPulled => "pin_pulled",
            Self::PinPutIn => "pin_put_in",
            Self::DrumSlips => "drum_slips",
            Self::DrumHolds => "drum_holds",
            Self::Flooding => "flooding",
            Self::Surfacing => "surfacing",
            Self::Capsized => "capsized",
            Self::StepBegin => "step_begin",
            Self::StepEnd => "step_end",
            Self::PumpStopped => "pump_stopped",
            Self::CompensationLimit(HeaveLimit::Speed) => "compensation_speed_limit",
            Self::CompensationLimit(HeaveLimit::Acceleration) => "compensation_acceleration_limit",
            Self::CompensationLimit(HeaveLimit::Stroke) => "compensation_stroke_limit",
            Self::EmergencyStop => "emergency_stop",
        }
    }
}

/// One event. `subject` is the index of a constraint, a contact group, a sheave, a mark, a vessel, a compensator or a step, as the kind says.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// Time [s].
    pub time: f64,
    /// Kind.
    pub kind: EventKind,
    /// Whom it concerns.
    pub subject: usize,
}

impl Event {
    /// Name of what it concerns.
    pub fn subject_name(&self, system: &System) -> String {
        match self.kind {
            EventKind::Cut | EventKind::Broken | EventKind::Detached | EventKind::Attached => {
                system.rope_name(self.subject).to_owned()
            }
            EventKind::Taut
            | EventKind::Slack
            | EventKind::Stick
            | EventKind::Slip
            | EventKind::OffSupport
            | EventKind::SupportRemoved
            | EventKind::StopHit
            | EventKind::StopLeft
            | EventKind::PinPulled
            | EventKind::PinPutIn
            | EventKind::DrumSlips
            | EventKind::DrumHolds => system.constraints[self.subject].name().to_owned(),
            EventKind::LiftOff | EventKind::SetDown => system.groups[self.subject].name.clone(),
            EventKind::RopeOffSheave | EventKind::RopeOnSheave => system.sheave_name(self.subject),
            EventKind::Flooding | EventKind::Surfacing => system.marks[self.subject].name.clone(),
            EventKind::CompensationLimit(_) => system.plan.compensators[self.subject].name.clone(),
            EventKind::Capsized => system.vessels[self.subject].name.clone(),
            EventKind::StepBegin | EventKind::StepEnd | EventKind::PumpStopped | EventKind::EmergencyStop => {
                let step = system.plan.steps.get(self.subject);
                step.map_or_else(String::new, |step| step.name.clone())
            }
        }
    }
}

/// Events in the order in which they were found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EventLog {
    /// The events.
    pub events: Vec<Event>,
}

impl EventLog {
    /// An empty log with room for a usual lift.
    pub fn new() -> Self {
        Self { events: Vec::with_capacity(4096) }
    }

    /// When a step of the plan began [s].
    pub fn begin_of(&self, step: usize) -> Option<f64> {
        let begins = |event: &&Event| event.kind == EventKind::StepBegin && event.subject == step;
        self.events.iter().rev().find(begins).map(|event| event.time)
    }

    /// Adds an event.
    pub fn push(&mut self, time: f64, kind: EventKind, subject: usize) {
        self.events.push(Event { time, kind, subject });
    }
}

impl Default for EventLog {
    fn default() -> Self {
        Self::new()
    }
}
