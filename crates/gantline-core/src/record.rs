//! Columns of numbers over time: what a run hands on.

use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

use crate::audit::KINDS;
use crate::constraint::AnyConstraint;
use crate::constraint::contact::Contact;
use crate::constraint::rope::Rope;
use crate::rope::route::Straight;
use crate::state::State;
use crate::system::System;
use crate::tree::bias::{NewtonEuler, Wrench};
use crate::tree::kinematics::{Kinematics, Twist};

/// Chords of a drawn half turn.
pub const ARC_SAMPLES: usize = 12;

/// Samples taken so far. Shapes are (samples, …) in row-major order.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Columns {
    /// Time [s].
    pub time: Vec<f64>,
    /// (rope) [N].
    pub rope_tension: Vec<f64>,
    /// (segment) [N].
    pub segment_tension: Vec<f64>,
    /// (segment) [m].
    pub segment_length: Vec<f64>,
    /// (rope point, xyz) [m].
    pub rope_point: Vec<f64>,
    /// (body, xyz) centre of gravity [m].
    pub body_position: Vec<f64>,
    /// (body, wxyz) unit quaternion.
    pub body_orientation: Vec<f64>,
    /// (body, xyz) of the centre of gravity [m/s].
    pub body_velocity: Vec<f64>,
    /// (body, xyz) [rad/s], world axes.
    pub body_angular_velocity: Vec<f64>,
    /// (hinge or slider) [rad or m].
    pub joint_position: Vec<f64>,
    /// (body, xyz) force of the parent on the body through its joint [N].
    pub joint_force: Vec<f64>,
    /// (contact) normal force [N].
    pub contact_force: Vec<f64>,
    /// (kind) [J].
    pub energy: Vec<f64>,
    /// Largest e of an inextensible rope beyond its length [m].
    pub constraint_residual: Vec<f64>,
    /// Largest distance of a force from its law [N].
    pub complementarity_residual: Vec<f64>,
    /// (rope) largest tension over all steps so far [N].
    pub rope_peak_tension: Vec<f64>,
    /// (rope) when that was [s].
    pub rope_peak_time: Vec<f64>,
}

/// What a step leaves for samples within it.
#[derive(Debug, Clone, Copy)]
pub struct Span<'a> {
    /// State at its start.
    pub before: &'a State,
    /// State at its end.
    pub after: &'a State,
    /// Complementarity residual of the step [N].
    pub residual: f64,
}

/// Takes samples. Reused from sample to sample.
#[derive(Debug, Clone)]
pub struct Recorder {
    /// Time between samples [s].
    pub interval: f64,
    kinematics: Kinematics,
    dynamics: NewtonEuler,
    twists: Vec<Twist>,
    applied: Vec<Wrench>,
    unused: Vec<f64>,
    straights: Vec<Straight>,
    sample: State,
}

impl Recorder {
    /// A recorder for `system`; `state` is any of its states.
    pub fn new(system: &System, state: &State, interval: f64) -> Self {
        Self {
            interval,
            kinematics: Kinematics::new(&system.tree),
            dynamics: NewtonEuler::new(&system.tree),
            twists: vec![Twist::default(); system.tree.bodies.len()],
            applied: vec![Wrench::default(); system.tree.bodies.len()],
            unused: vec![0.0; system.tree.velocities],
            straights: Vec::new(),
            sample: state.clone(),
        }
    }

    /// Takes all samples that are due up to the end of the step. `motion` sets the configuration, velocities,
    /// accelerations and forces of a state at a share of the step.
    pub fn record(
        &mut self,
        system: &System,
        span: &Span,
        columns: &mut Columns,
        motion: &mut dyn FnMut(&Span, f64, &mut State),
    ) {
        let (from, to) = (span.before.time, span.after.time);
        loop {
            let time = columns.time.len() as f64 * self.interval;
            // A sample at the end of the step by intention must not miss it by rounding.
            if time > to + 1e-9 * (to - from) {
                break;
            }
            let share = ((time - from) / (to - from)).clamp(0.0, 1.0);
            self.sample.time = time;
            motion(span, share, &mut self.sample);
            self.take(system, span, share, columns);
        }
    }

    /// Keeps the largest tension of every rope: `peak` gives that of a step and its time [s], where it is more than
    /// what is known.
    pub fn note_peaks(
        system: &System,
        columns: &mut Columns,
        mut peak: impl FnMut(usize, f64) -> Option<(f64, f64)>,
    ) {
        columns.rope_peak_tension.resize(system.rope_count, 0.0);
        columns.rope_peak_time.resize(system.rope_count, 0.0);
        for rope in 0..system.rope_count {
            if let Some((tension, time)) = peak(rope, columns.rope_peak_tension[rope]) {
                columns.rope_peak_tension[rope] = tension;
                columns.rope_peak_time[rope] = time;
            }
        }
    }

    fn take(&mut self, system: &System, span: &Span, share: f64, columns: &mut Columns) {
        self.kinematics.update(&system.tree, &self.sample.q);
        columns.time.push(self.sample.time);
        self.applied.fill(Wrench::default());
        let mut violation = 0.0_f64;
        for (index, constraint) in system.constraints.iter().enumerate() {
            let row = system.rows.first[index];
            match constraint {
                AnyConstraint::Rope(rope) => {
                    let tension = self.sample.tension[row];
                    let length = self.take_rope(rope, tension, columns);
                    if rope.material.compliance == 0.0 {
                        violation = violation.max(length - rope.length);
                    }
                }
                AnyConstraint::Contact(contact) => self.take_contact(contact, row, columns),
            }
        }
        columns.constraint_residual.push(violation);
        columns.complementarity_residual.push(span.residual);
        self.take_bodies(system, columns);
        let (before, after) = (span.before.ledger.values(), span.after.ledger.values());
        for kind in 0..KINDS.len() {
            columns.energy.push(before[kind] + share * (after[kind] - before[kind]));
        }
    }

    /// Adds a rope's columns and its forces on bodies; returns its length [m].
    fn take_rope(&mut self, rope: &Rope, tension: f64, columns: &mut Columns) -> f64 {
        columns.rope_tension.push(tension);
        self.straights.clear();
        let straights = &mut self.straights;
        let length = rope.route.length(&self.kinematics, |_, straight| straights.push(*straight));
        for (index, part) in rope.route.parts.iter().enumerate() {
            let straight = self.straights[index];
            columns.segment_tension.push(tension);
            columns.segment_length.push(straight.length);
            let [start, end] = straight.couple;
            self.apply(part.from.at.body, straight.from, straight.pull * tension, -start * tension);
            self.apply(part.to.at.body, straight.to, -straight.pull * tension, -end * tension);
        }
        for (index, guide) in rope.route.guides.iter().enumerate() {
            let before = index.checked_sub(1).and_then(|part| self.straights.get(part));
            let parts = [before, self.straights.get(index)];
            guide.draw(&self.kinematics, parts, ARC_SAMPLES, |point| {
                columns.rope_point.extend(point.to_array())
            });
        }
        length
    }

    fn take_contact(&mut self, contact: &Contact, row: usize, columns: &mut Columns) {
        let [normal, first, second] = [0, 1, 2].map(|k| self.sample.tension[row + k]);
        columns.contact_force.push(normal);
        let tangents = contact.plane.tangents;
        let force = contact.plane.normal * normal - tangents[0] * first - tangents[1] * second;
        let point = self.kinematics.point(Some(contact.body), contact.at);
        self.apply(Some(contact.body), point, force, DVec3::ZERO);
    }

    fn apply(&mut self, body: Option<usize>, point: DVec3, force: DVec3, couple: DVec3) {
        if let Some(body) = body {
            let wrench = &mut self.applied[body];
            wrench.force += force;
            wrench.moment += (point - self.kinematics.pose[body].position).cross(force) + couple;
        }
    }

    fn take_bodies(&mut self, system: &System, columns: &mut Columns) {
        let tree = &system.tree;
        let State { q, v, acceleration, .. } = &self.sample;
        let applied = Some(self.applied.as_slice());
        self.dynamics.update(tree, &self.kinematics, v, Some(acceleration), applied, &mut self.unused);
        self.kinematics.twists(tree, v, &mut self.twists);
        for (index, body) in tree.bodies.iter().enumerate() {
            let centre = self.kinematics.centre_of_gravity[index];
            let turn = DQuat::from_mat3(&self.kinematics.pose[index].rotation);
            let velocity = self.kinematics.point_velocity(&self.twists, Some(index), centre);
            columns.body_position.extend(centre.to_array());
            columns.body_orientation.extend([turn.w, turn.x, turn.y, turn.z]);
            columns.body_velocity.extend(velocity.to_array());
            columns.body_angular_velocity.extend(self.twists[index].angular.to_array());
            columns.joint_force.extend(self.dynamics.wrenches[index].force.to_array());
            if body.joint.has_axis() {
                columns.joint_position.push(q[body.first_position]);
            }
        }
    }
}

/// Names that go with the columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Names {
    /// Ropes.
    pub rope: Vec<String>,
    /// Straight segments, `rope/number`.
    pub segment: Vec<String>,
    /// Rope of every drawn point.
    pub rope_point: Vec<String>,
    /// Bodies.
    pub body: Vec<String>,
    /// Bodies with a hinge or slider.
    pub joint: Vec<String>,
    /// Contacts.
    pub contact: Vec<String>,
}

impl Names {
    /// Names of `system`.
    pub fn new(system: &System) -> Self {
        let bodies = &system.tree.bodies;
        let mut names = Self {
            rope: Vec::new(),
            segment: Vec::new(),
            rope_point: Vec::new(),
            body: bodies.iter().map(|body| body.name.clone()).collect(),
            joint: bodies.iter().filter(|body| body.joint.has_axis()).map(|body| body.name.clone()).collect(),
            contact: Vec::new(),
        };
        for constraint in &system.constraints {
            match constraint {
                AnyConstraint::Rope(rope) => {
                    let segments = (0..rope.route.parts.len()).map(|part| format!("{}/{part}", rope.name));
                    let points = rope.route.guides.iter().map(|guide| guide.drawn_points(ARC_SAMPLES)).sum();
                    names.segment.extend(segments);
                    names.rope_point.extend(std::iter::repeat_n(rope.name.clone(), points));
                    names.rope.push(rope.name.clone());
                }
                AnyConstraint::Contact(contact) => names.contact.push(contact.name.clone()),
            }
        }
        names
    }
}
