//! Vessels that take water or turn over: seen along the course of a step, whatever the method made it.
//!
//! Water that reaches a mark, the edge of a deck or an opening, changes nothing here: it does not come in. So no step has
//! to end where that happens, and what a method leaves of its step tells when it was.

use glam::DVec3;

use super::{EventKind, EventLog};
use crate::force;
use crate::force::trains::Trains;
use crate::record::{Sample, Span};
use crate::stepper::StepError;
use crate::system::System;
use crate::tree::Tree;
use crate::tree::kinematics::Kinematics;
use crate::tree::pose::Pose;

/// A body that should stay upright.
#[derive(Debug, Clone, PartialEq)]
pub struct Vessel {
    /// Name.
    pub name: String,
    /// Index of its body.
    pub body: usize,
    /// Height of the water's surface above the world's origin [m].
    pub level: f64,
    /// Angle of its z axis from plumb beyond which it has capsized [rad].
    pub capsized_beyond: f64,
    /// Corners of the edge of its bottom, in the frame of its body [m].
    pub bottom: Vec<DVec3>,
}

/// Points of a vessel that should stay above the water.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Name.
    pub name: String,
    /// Index of its vessel.
    pub vessel: usize,
    /// The points, in the frame of the vessel's body [m].
    pub points: Vec<DVec3>,
}

impl Vessel {
    /// Upwards, in the frame of its body.
    fn up(&self, pose: &Pose, gravity: DVec3) -> DVec3 {
        pose.rotation.transpose() * (-gravity / gravity.length())
    }

    /// Heights of points of its body above the water [m].
    fn heights(&self, points: &[DVec3], pose: &Pose, gravity: DVec3) -> impl Iterator<Item = f64> {
        let up = self.up(pose, gravity);
        let origin = -pose.position.dot(gravity) / gravity.length() - self.level;
        points.iter().map(move |point| up.dot(*point) + origin)
    }

    /// Height of the highest corner of its bottom above the water [m]; none where it has none.
    pub fn bottom_height(&self, pose: &Pose, gravity: DVec3) -> Option<f64> {
        self.heights(&self.bottom, pose, gravity).reduce(f64::max)
    }

    /// How far it is beyond the angle at which it has capsized [rad]; not positive while it has not.
    pub fn beyond(&self, pose: &Pose, gravity: DVec3) -> f64 {
        let up = self.up(pose, gravity);
        up.x.hypot(up.y).atan2(up.z) - self.capsized_beyond
    }
}

impl Mark {
    /// Height of its lowest point above the level of still water [m].
    pub fn height(&self, vessel: &Vessel, pose: &Pose, gravity: DVec3) -> f64 {
        vessel.heights(&self.points, pose, gravity).fold(f64::INFINITY, f64::min)
    }

    /// The same above the water at `time` [s], where waves pass as if the vessel were not there; not less than that where
    /// no wave can reach it.
    fn height_in_waves(
        &self,
        vessel: &Vessel,
        pose: &Pose,
        gravity: DVec3,
        (sea, time): (&Trains, f64),
    ) -> f64 {
        let (still, highest) = (self.height(vessel, pose, gravity), sea.highest());
        if highest == 0.0 || still > highest {
            return still;
        }
        let heights = vessel.heights(&self.points, pose, gravity).zip(&self.points);
        let over =
            heights.map(|(height, point)| height - sea.passing(pose.point(*point).truncate(), time).value);
        over.fold(f64::INFINITY, f64::min)
    }
}

/// Parts of a step at whose ends is looked, at least.
const PARTS: usize = 4;
/// Halvings of a part of a step, down to the last bit.
const HALVINGS: usize = 50;

/// Looks along steps; its work arrays.
#[derive(Debug, Clone)]
pub struct Lookout {
    kinematics: Kinematics,
    sample: Sample,
    /// What is positive as long as nothing has happened: the marks' heights [m], then how far vessels are from capsizing [rad].
    before: Vec<f64>,
    after: Vec<f64>,
}

impl Lookout {
    /// A lookout over `system`.
    pub fn new(system: &System) -> Self {
        let zeros = vec![0.0; system.marks.len() + system.vessels.len()];
        let tree = &system.tree;
        let motion = || vec![0.0; tree.velocities];
        let tension = vec![0.0; system.rows.count()];
        let past = vec![0.0; force::states(tree)];
        let sample =
            Sample { q: vec![0.0; tree.positions], v: motion(), acceleration: motion(), tension, past };
        Self { kinematics: Kinematics::new(tree), sample, before: zeros.clone(), after: zeros }
    }

    /// Notes what happened in a step that has been made; `motion` gives the sample at a share of it.
    ///
    /// # Errors
    /// [`StepError`] where a vessel has capsized.
    pub fn look(
        &mut self,
        system: &System,
        span: &Span,
        log: &mut EventLog,
        motion: &mut dyn FnMut(&Span, f64, &mut Sample),
    ) -> Result<(), StepError> {
        if self.before.is_empty() {
            return Ok(());
        }
        let (start, length) = (span.before.time, span.after.time - span.before.time);
        self.kinematics.update(&system.tree, &span.before.q, start);
        self.margins(system);
        if span.before.steps == 0 {
            let under = (0..system.marks.len()).filter(|&mark| self.after[mark] < 0.0);
            under.for_each(|mark| log.push(start, EventKind::Flooding, mark));
        }
        let mut from = 0.0;
        let parts = PARTS.max(system.sea.looks(length));
        for part in 1..=parts {
            let to = part as f64 / parts as f64;
            std::mem::swap(&mut self.before, &mut self.after);
            self.at(system, span, to, motion);
            for place in 0..self.after.len() {
                if (self.before[place] < 0.0) != (self.after[place] < 0.0) {
                    let share = self.crossing(system, span, place, [from, to], motion);
                    self.note(system, log, place, start + share * length);
                    self.at(system, span, to, motion);
                }
            }
            from = to;
        }
        let fallen = self.after.iter().skip(system.marks.len()).position(|margin| *margin < 0.0);
        fallen.map_or(Ok(()), |vessel| Err(self.capsized(system, log, vessel, span.after.time)))
    }

    /// Sets `after` to what it is at a share of the step.
    fn at(
        &mut self,
        system: &System,
        span: &Span,
        share: f64,
        motion: &mut dyn FnMut(&Span, f64, &mut Sample),
    ) {
        let (start, end) = (span.before.time, span.after.time);
        if share == 1.0 {
            self.kinematics.update(&system.tree, &span.after.q, end);
        } else {
            motion(span, share, &mut self.sample);
            self.kinematics.update(&system.tree, &self.sample.q, start + share * (end - start));
        }
        self.margins(system);
    }

    fn margins(&mut self, system: &System) {
        let Tree { gravity, .. } = system.tree;
        let pose = |vessel: &Vessel| &self.kinematics.pose[vessel.body];
        let heights = system.marks.iter().map(|mark| {
            let vessel = &system.vessels[mark.vessel];
            mark.height_in_waves(vessel, pose(vessel), gravity, (&system.sea, self.kinematics.time))
        });
        let upright = system.vessels.iter().map(|vessel| -vessel.beyond(pose(vessel), gravity));
        self.after.iter_mut().zip(heights.chain(upright)).for_each(|(margin, value)| *margin = value);
    }

    /// Share of the step between two others at which the margin `place` changes its sign.
    fn crossing(
        &mut self,
        system: &System,
        span: &Span,
        place: usize,
        [mut low, mut high]: [f64; 2],
        motion: &mut dyn FnMut(&Span, f64, &mut Sample),
    ) -> f64 {
        let was_under = self.before[place] < 0.0;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            self.at(system, span, middle, motion);
            if (self.after[place] < 0.0) == was_under { low = middle } else { high = middle }
        }
        high
    }

    fn note(&self, system: &System, log: &mut EventLog, place: usize, time: f64) {
        let went_under = self.before[place] >= 0.0;
        match place.checked_sub(system.marks.len()) {
            None if went_under => log.push(time, EventKind::Flooding, place),
            None => log.push(time, EventKind::Surfacing, place),
            Some(vessel) if went_under => log.push(time, EventKind::Capsized, vessel),
            Some(_) => {}
        }
    }

    fn capsized(&self, system: &System, log: &EventLog, vessel: usize, end: f64) -> StepError {
        let fell = |event: &&super::Event| event.kind == EventKind::Capsized && event.subject == vessel;
        let time = log.events.iter().find(fell).map_or(end, |event| event.time);
        let whose = &system.vessels[vessel];
        let up = whose.up(&self.kinematics.pose[whose.body], system.tree.gravity);
        let side = match (up.x.abs() > up.y.abs(), up.x > 0.0, up.y > 0.0) {
            (true, true, _) => "its stern",
            (true, false, _) => "its bow",
            (false, _, true) => "its starboard side",
            (false, _, false) => "its port side",
        };
        let angle = whose.capsized_beyond.to_degrees();
        let cause = format!(
            "it has capsized over {side}, more than {angle:.0}° from upright; {}",
            story(system, log, vessel)
        );
        StepError { time, element: whose.name.clone(), cause }
    }
}

/// What happened before a vessel capsized, as far as that may be why.
fn story(system: &System, log: &EventLog, vessel: usize) -> String {
    let mut parts = Vec::new();
    let parted = |event: &&super::Event| event.kind.parts_a_rope();
    if let Some(event) = log.events.iter().rfind(parted) {
        let how = match event.kind {
            EventKind::Cut => "was cut",
            EventKind::Detached => "was taken off",
            _ => "broke",
        };
        parts.push(format!("{} {how} at {:.2} s", system.rope_name(event.subject), event.time));
    }
    let is_own = |event: &&super::Event| {
        event.kind == EventKind::Flooding && system.marks[event.subject].vessel == vessel
    };
    if let Some(event) = log.events.iter().find(is_own) {
        parts.push(format!("{} went under at {:.2} s", system.marks[event.subject].name, event.time));
    }
    if parts.is_empty() {
        return "its weight is too high above its hull, or too far to one side".to_owned();
    }
    format!("before that {}", parts.join(", and "))
}
