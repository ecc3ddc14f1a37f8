//! What a run hands on: columns of numbers over time, worked out from its samples.

use glam::{DQuat, DVec3};

use super::Samples;
use super::clearance::clearance;
use super::presence::Presence;
use crate::audit::{KINDS, kinds_of};
use crate::constraint::AnyConstraint;
use crate::constraint::facing::Facing;
use crate::constraint::rope::Rope;
use crate::contact::spot::Spot;
use crate::event::EventLog;
use crate::force;
use crate::rope::part::Straight;
use crate::rope::seat::Seat;
use crate::system::System;
use crate::tree::Tree;
use crate::tree::bias::{NewtonEuler, Wrench};
use crate::tree::kinematics::Kinematics;

/// Chords of a drawn half turn.
pub const ARC_SAMPLES: usize = 12;

/// Everything that follows from samples. Shapes are (samples, …) in row-major order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Columns {
    /// (rope) [N].
    pub rope_tension: Vec<f64>,
    /// (rope) by how much adjusting has lengthened it [m]; empty where nothing is adjusted.
    pub rope_lengthening: Vec<f64>,
    /// (segment) [N].
    pub segment_tension: Vec<f64>,
    /// (segment) [m].
    pub segment_length: Vec<f64>,
    /// (rope point, xyz) [m].
    pub rope_point: Vec<f64>,
    /// (sheave) wrap angle of sheaves with true tangents [rad], 0 where the rope runs straight past.
    pub wrap_angle: Vec<f64>,
    /// (sheave, arriving and leaving) angle of the rope to the sheave's plane [rad], positive to where the axis
    /// points.
    pub fleet_angle: Vec<f64>,
    /// (body, xyz) centre of gravity [m].
    pub body_position: Vec<f64>,
    /// (body, wxyz) unit quaternion.
    pub body_orientation: Vec<f64>,
    /// (body, xyz) of the centre of gravity [m/s].
    pub body_velocity: Vec<f64>,
    /// (body, xyz) [rad/s], world axes.
    pub body_angular_velocity: Vec<f64>,
    /// (xyz) of all bodies together [kg m/s].
    pub momentum: Vec<f64>,
    /// (xyz) of all bodies together about the world's origin [kg m²/s].
    pub angular_momentum: Vec<f64>,
    /// (hinge or slider) [rad or m].
    pub joint_position: Vec<f64>,
    /// (body, xyz) force of the parent on the body through its joint [N].
    pub joint_force: Vec<f64>,
    /// (contact) normal force [N].
    pub contact_force: Vec<f64>,
    /// What contacts bear of the weight of the body of their group (samples, contacts) [N].
    pub contact_lift: Vec<f64>,
    /// (pin) force that it holds, or moment, positive where that would move the joint forwards [N or N m].
    pub pin_force: Vec<f64>,
    /// (pair) smallest distance [m], not positive where they touch.
    pub clearance: Vec<f64>,
    /// (hull) volume below still water, of a load below the waves [m³].
    pub displaced_volume: Vec<f64>,
    /// (pair, side, xyz) where the two are nearest to each other [m].
    pub clearance_point: Vec<f64>,
    /// (energy kind) [J].
    pub energy: Vec<f64>,
    /// Largest e of an inextensible rope beyond its length [m].
    pub constraint_residual: Vec<f64>,
}

impl Columns {
    /// The columns of `samples` of a run whose events are `log`.
    pub fn of(system: &System, samples: &Samples, log: &EventLog) -> Self {
        let mut columns = Self::with_room(system, samples.time.len());
        let mut sampled = Sampled {
            kinematics: Kinematics::new(&system.tree),
            dynamics: NewtonEuler::new(&system.tree),
            applied: vec![Wrench::default(); system.tree.bodies.len()],
            unused: vec![0.0; system.tree.velocities],
            straights: Vec::new(),
            turns: vec![DQuat::IDENTITY; system.tree.bodies.len()],
            presence: Presence::of(system, log),
        };
        let (positions, velocities) = (system.tree.positions, system.tree.velocities);
        let rows = system.rows.count();
        for index in 0..samples.time.len() {
            let q = &samples.q[index * positions..][..positions];
            let v = &samples.v[index * velocities..][..velocities];
            let acceleration = &samples.acceleration[index * velocities..][..velocities];
            let tension = &samples.tension[index * rows..][..rows];
            let (seats, spots) = (samples.seats.of(index), samples.spots.of(index));
            sampled.kinematics.update(&system.tree, q, samples.time[index]);
            let states = sampled.kinematics.past.len();
            sampled.kinematics.past.copy_from_slice(&samples.past[index * states..][..states]);
            sampled.mark_parted(system, samples.time[index]);
            sampled.add_rows(system, samples.time[index], [q, tension], (seats, spots), &mut columns);
            sampled.add_moorings(system, v, &mut columns);
            sampled.add_clearances(system, samples.time[index], seats, &mut columns);
            sampled.add_bodies(system, [q, v, acceleration], &mut columns);
            sampled.add_hulls(&system.tree, &mut columns);
        }
        columns.rope_lengthening = lengthenings(system, samples);
        let kinds = kinds_of(system);
        let energies = samples.energy.chunks_exact(KINDS.len());
        columns.energy = energies.flat_map(|all| kinds.iter().map(|&kind| all[kind])).collect();
        columns
    }

    fn with_room(system: &System, samples: usize) -> Self {
        let names = super::names::Names::new(system);
        let room = |width: usize| Vec::with_capacity(samples * width);
        let (segments, bodies) = (names.segment.len(), names.body.len());
        Self {
            rope_tension: room(names.rope.len()),
            rope_lengthening: Vec::new(),
            segment_tension: room(segments),
            segment_length: room(segments),
            rope_point: room(3 * names.rope_point.len()),
            wrap_angle: room(names.wrapped_sheave.len()),
            fleet_angle: room(2 * names.wrapped_sheave.len()),
            body_position: room(3 * bodies),
            body_orientation: room(4 * bodies),
            body_velocity: room(3 * bodies),
            body_angular_velocity: room(3 * bodies),
            momentum: room(3),
            angular_momentum: room(3),
            joint_position: room(names.joint.len()),
            joint_force: room(3 * bodies),
            contact_force: room(names.contact.len()),
            contact_lift: room(names.contact.len()),
            pin_force: room(names.pin.len()),
            clearance: room(names.pair.len()),
            displaced_volume: room(names.hull.len()),
            clearance_point: room(6 * names.pair.len()),
            energy: Vec::new(),
            constraint_residual: room(1),
        }
    }
}

/// Mean tension over the straight parts of a rope [N] under the forces of its rows.
fn mean_tension(rope: &Rope, force: &[f64], q: &[f64], kinematics: &Kinematics) -> f64 {
    rope.mean(|span| rope.tension(span, kinematics, q, force[span]))
}

/// Lengthening of all ropes (samples, ropes) [m], zero of those that are not adjusted; empty where none is.
fn lengthenings(system: &System, samples: &Samples) -> Vec<f64> {
    let adjusted: Vec<usize> = system
        .adjusters
        .iter()
        .flat_map(|adjuster| adjuster.rows.iter().map(|&row| system.constraint_index(row)))
        .collect();
    let count = if adjusted.is_empty() { 0 } else { samples.time.len() };
    let mut all = vec![0.0; count * system.all_ropes()];
    for sample in 0..count {
        for (index, rope) in adjusted.iter().enumerate() {
            all[sample * system.all_ropes() + rope] = samples.lengthening[sample * adjusted.len() + index];
        }
    }
    all
}

/// Tensions of all ropes (samples, ropes) [N], without all that [`Columns`] works out.
pub fn rope_tensions(system: &System, samples: &Samples) -> Vec<f64> {
    let (positions, rows) = (system.tree.positions, system.rows.count());
    let mut tensions = Vec::with_capacity(samples.time.len() * system.rope_count);
    // Only ropes with a curve ask where their ends are.
    let has_curves = system.ropes().any(Rope::has_curve);
    let mut kinematics = Kinematics::new(&system.tree);
    for index in 0..samples.time.len() {
        let q = &samples.q[index * positions..][..positions];
        if has_curves {
            kinematics.update(&system.tree, q, 0.0);
        }
        tensions.extend(tensions_of(system, &samples.tension[index * rows..][..rows], q, &kinematics));
    }
    tensions
}

/// Tension of every rope [N] at one moment, from the forces of all rows, the joint coordinates and `kinematics` there.
pub fn tensions_of(
    system: &System,
    force: &[f64],
    q: &[f64],
    kinematics: &Kinematics,
) -> impl Iterator<Item = f64> {
    let ropes = system.ropes().zip(&system.rows.first);
    ropes.map(move |(rope, &first)| mean_tension(rope, &force[first..], q, kinematics))
}

/// The system at one sample. Reused from sample to sample.
struct Sampled {
    kinematics: Kinematics,
    dynamics: NewtonEuler,
    applied: Vec<Wrench>,
    unused: Vec<f64>,
    straights: Vec<Straight>,
    /// How bodies were turned a sample ago: a quaternion and its opposite are one attitude, and what goes from one sample to
    /// the next shall go the short way.
    turns: Vec<DQuat>,
    presence: Presence,
}

impl Sampled {
    fn add_rows(
        &mut self,
        system: &System,
        time: f64,
        [q, tension]: [&[f64]; 2],
        (seats, spots): (&[Seat], &[Spot]),
        columns: &mut Columns,
    ) {
        self.applied.fill(Wrench::default());
        let mut violation = 0.0_f64;
        for (index, constraint) in system.constraints.iter().enumerate() {
            let row = system.rows.first[index];
            match constraint {
                AnyConstraint::Rope(rope) if !self.presence.is_there(index, time) => {
                    self.add_absent_rope(rope, columns);
                }
                AnyConstraint::Rope(rope) => {
                    let length = self.add_rope(rope, [q, &tension[row..]], seats, columns);
                    if rope.material.is_inextensible() {
                        violation = violation.max(length - rope.length);
                    }
                }
                AnyConstraint::Stop(_) | AnyConstraint::Brake(_) => {}
                AnyConstraint::Pin(_) => columns.pin_force.push(tension[row]),
                AnyConstraint::Contact(contact) => {
                    let forces = [0, 1, 2].map(|k| tension[row + k]);
                    columns.contact_lift.push(system.lift_of(index, &self.kinematics, spots, forces));
                    self.add_touch(&contact.facing, &contact.spot, forces, columns);
                }
                AnyConstraint::Touch(touch) => {
                    let forces = [0, 1, 2].map(|k| tension[row + k]);
                    columns.contact_lift.push(system.lift_of(index, &self.kinematics, spots, forces));
                    self.add_touch(&touch.facing, &spots[touch.spot], forces, columns);
                }
            }
        }
        columns.constraint_residual.push(violation);
    }

    /// Lines that have parted have done so at their times, not where the step that followed ended.
    fn mark_parted(&mut self, system: &System, time: f64) {
        for (line, mooring) in system.moorings().enumerate() {
            if !self.presence.is_there(system.rope_count + line, time) {
                self.kinematics.q[mooring.mark] = 1.0;
            }
        }
    }

    /// Adds the columns of mooring lines: one segment each, as long as the line is stretched.
    fn add_moorings(&mut self, system: &System, v: &[f64], columns: &mut Columns) {
        let (tree, kinematics) = (&system.tree, &self.kinematics);
        for mooring in system.moorings() {
            let tension = mooring.tension_of(tree, kinematics, v);
            columns.rope_tension.push(tension);
            columns.segment_tension.push(tension);
            let pose = &kinematics.pose[mooring.body];
            let length = mooring.draw(pose, tree.gravity, &kinematics.q, |point| {
                columns.rope_point.extend_from_slice(point.as_ref());
            });
            columns.segment_length.push(length);
        }
    }

    /// Adds a rope's columns and its forces on bodies; returns its length [m].
    fn add_rope(
        &mut self,
        rope: &Rope,
        [q, force]: [&[f64]; 2],
        seats: &[Seat],
        columns: &mut Columns,
    ) -> f64 {
        self.straights.clear();
        let straights = &mut self.straights;
        let length = rope.route.length(&self.kinematics, seats, |_, straight| straights.push(*straight));
        columns.rope_tension.push(mean_tension(rope, force, q, &self.kinematics));
        for (index, part) in rope.route.parts.iter().enumerate() {
            let straight = self.straights[index];
            let span = rope.span_of[index];
            let tension = rope.tension(span, &self.kinematics, q, force[span]);
            columns.segment_tension.push(tension);
            columns.segment_length.push(straight.length);
            let [start, end] = straight.couple;
            self.apply(part.from.at.body, straight.from, straight.pull * tension, -start * tension);
            self.apply(part.to.at.body, straight.to, -straight.pull * tension, -end * tension);
        }
        for (index, guide) in rope.route.guides.iter().enumerate() {
            let before = index.checked_sub(1).and_then(|part| self.straights.get(part));
            let parts = [before, self.straights.get(index)];
            guide.draw((&self.kinematics, seats), parts, ARC_SAMPLES, |point| {
                columns.rope_point.extend_from_slice(point.as_ref());
            });
            if let ([Some(before), Some(after)], true) = (parts, guide.is_sheave()) {
                let is_lifted = guide.is_lifted(seats);
                let wrap = guide.wrap(&self.kinematics, seats, before, after);
                let fleet = guide.fleet(&self.kinematics, before, after);
                columns.wrap_angle.push(if is_lifted { 0.0 } else { wrap });
                columns.fleet_angle.extend(if is_lifted { [0.0; 2] } else { fleet });
            }
        }
        length
    }

    /// Adds the columns of a rope that has parted or is not on: without force and length, all of it where it began.
    fn add_absent_rope(&mut self, rope: &Rope, columns: &mut Columns) {
        columns.rope_tension.push(0.0);
        for _ in &rope.route.parts {
            columns.segment_tension.push(0.0);
            columns.segment_length.push(0.0);
        }
        let start = rope.route.parts[0].from.at;
        let place = self.kinematics.point(start.body, start.at);
        for guide in &rope.route.guides {
            for _ in 0..guide.drawn_points(ARC_SAMPLES) {
                columns.rope_point.extend_from_slice(place.as_ref());
            }
            if guide.is_sheave() {
                columns.wrap_angle.push(0.0);
                columns.fleet_angle.extend([0.0; 2]);
            }
        }
    }

    fn add_touch(&mut self, facing: &Facing, spot: &Spot, forces: [f64; 3], columns: &mut Columns) {
        columns.contact_force.push(forces[0]);
        let (point, force) = facing.force(&self.kinematics, spot, forces);
        let [first, second] = facing.bodies;
        self.apply(first, point, force, DVec3::ZERO);
        self.apply(second, point, -force, DVec3::ZERO);
    }

    fn add_clearances(&mut self, system: &System, time: f64, seats: &[Seat], columns: &mut Columns) {
        let is_whole = |rope: usize| self.presence.is_there(rope, time);
        for watch in &system.watches {
            let found = clearance(system, &self.kinematics, seats, watch, is_whole);
            columns.clearance.push(found.distance);
            columns.clearance_point.extend(found.points.iter().flat_map(|point| point.to_array()));
        }
    }

    fn add_hulls(&self, tree: &Tree, columns: &mut Columns) {
        for buoyancy in tree.hulls() {
            let pose = &self.kinematics.pose[buoyancy.body];
            columns.displaced_volume.push(buoyancy.below(pose, tree.gravity).volume);
        }
        for load in force::submerged(tree) {
            let pose = &self.kinematics.pose[load.body];
            columns.displaced_volume.push(load.displaced(pose, self.kinematics.time));
        }
    }

    fn apply(&mut self, body: Option<usize>, point: DVec3, force: DVec3, couple: DVec3) {
        if let Some(body) = body {
            let wrench = &mut self.applied[body];
            wrench.force += force;
            wrench.moment += (point - self.kinematics.pose[body].position).cross(force) + couple;
        }
    }

    fn add_bodies(&mut self, system: &System, [q, v, acceleration]: [&[f64]; 3], columns: &mut Columns) {
        let tree = &system.tree;
        let applied = Some(self.applied.as_slice());
        self.dynamics.update(tree, &self.kinematics, v, Some(acceleration), applied, &mut self.unused);
        let NewtonEuler { twists, wrenches, .. } = &self.dynamics;
        let (mut momentum, mut angular_momentum) = (DVec3::ZERO, DVec3::ZERO);
        for (index, body) in tree.bodies.iter().enumerate() {
            if body.joint.has_axis() {
                columns.joint_position.push(q[body.first_position]);
            }
            if !body.joint.moves_body() {
                continue;
            }
            let centre = self.kinematics.centre_of_gravity[index];
            let turn = DQuat::from_mat3(&self.kinematics.pose[index].rotation);
            let turn = turn * self.turns[index].dot(turn).signum();
            self.turns[index] = turn;
            let velocity = self.kinematics.point_velocity(twists, Some(index), centre);
            let rotation = self.kinematics.pose[index].rotation;
            let spin = rotation * (body.inertia * (rotation.transpose() * twists[index].angular));
            momentum += body.mass * velocity;
            angular_momentum += centre.cross(body.mass * velocity) + spin;
            columns.body_position.extend_from_slice(centre.as_ref());
            columns.body_orientation.extend_from_slice(&[turn.w, turn.x, turn.y, turn.z]);
            columns.body_velocity.extend_from_slice(velocity.as_ref());
            columns.body_angular_velocity.extend_from_slice(twists[index].angular.as_ref());
            columns.joint_force.extend_from_slice(wrenches[index].force.as_ref());
        }
        columns.momentum.extend_from_slice(momentum.as_ref());
        columns.angular_momentum.extend_from_slice(angular_momentum.as_ref());
    }
}
