//! The equations of motion at one point of a step, with the modes of the rows frozen.
//!
//! ```text
//! φ̇ = v (rotation vectors: see [`rate_of_rotation`])      0 = τ(q, v, a) + D v + Gᵀ T
//! T = T* = (e + τ ė)/ε for rows that act, 0 for slack ones, μ N T*/|T*| for sliding contacts
//! α̇ = (ε/τ) (T* − T), the motion of their anchors, which e counts from
//! G v̇ + Ġ v = 0 for inextensible ropes that act, whose T is an unknown of its own
//! ```
//!
//! τ is inverse dynamics; q = q₀ ⊕ φ with q₀ the configuration at the start of the step.

use glam::DVec3;

use super::light::Light;
use super::point::{Point, Schedule};
use crate::clock::Stage;
use crate::constraint::brake::At;
use crate::constraint::{AnyConstraint, Law, Line, Moving};
use crate::rope::guide::Attachment;
use crate::solver::complementarity::Mode;
use crate::stepper::coils;
use crate::stepper::frame::Frame;
use crate::system::System;
use crate::tree::Body;
use crate::tree::bias::NewtonEuler;
use crate::tree::joint::Joint;
use crate::tree::kinematics::Twist;

/// Everything at one point. Reused from point to point.
#[derive(Debug, Clone)]
pub struct Evaluation {
    /// Configuration.
    pub q: Vec<f64>,
    /// Poses, rows and gradients there.
    pub frame: Frame,
    /// Inverse dynamics.
    pub dynamics: NewtonEuler,
    /// φ̇.
    pub phi_rate: Vec<f64>,
    /// ė of every row.
    pub rate: Vec<f64>,
    /// What the law asks of every row without its bound [N].
    pub trial: Vec<f64>,
    /// Force of every row with its frozen mode [N].
    pub tension: Vec<f64>,
    /// τ + D v + Gᵀ T: what is missing from equilibrium of every degree of freedom.
    pub imbalance: Vec<f64>,
    /// G v̇ + Ġ v of every inextensible rope [m/s²], by [`System::rigid`].
    pub pull: Vec<f64>,
    /// Largest force of every brake [N].
    pub bound: Vec<f64>,
    /// Velocity that the drive of a motor asks for, by the row of its brake [m/s]; 0 for other rows.
    pub asked: Vec<f64>,
    /// What a brake holds in place of a motor, by its row [N].
    pub held: Vec<Option<f64>>,
    /// α̇ of the anchors of sliding contacts [m/s], by [`System::friction`].
    pub anchor_rate: Vec<f64>,
    /// Velocities; of light sheaves those that follow from the others.
    pub v: Vec<f64>,
    /// What passes light sheaves, by [`System::light`].
    pub light: Vec<Light>,
    /// w, −∂g/∂L and L of every span of a rope over light sheaves, by row.
    pub answers: Vec<[f64; 3]>,
    /// Work space by row: what spans of their ropes are stretched by, and how they answer.
    pub(super) stretch: Vec<f64>,
    pub(super) compliance: Vec<f64>,
    /// Where the forces of the rows act; not set by [`Evaluation::all`].
    pub(super) lines: Vec<Line>,
    /// First degree of freedom of every joint's rotations in body axes.
    pub(super) rotations: Vec<usize>,
    /// Newtons that a metre of length counts for where an inextensible rope is slack.
    pub rigid_scale: f64,
}

impl Evaluation {
    /// Room for `system`.
    pub fn new(system: &System) -> Self {
        let (rows, size) = (system.rows.count(), system.tree.velocities);
        Self {
            q: vec![0.0; system.tree.positions],
            frame: Frame::new(system),
            dynamics: NewtonEuler::new(&system.tree),
            phi_rate: vec![0.0; system.tree.increments()],
            rate: vec![0.0; rows],
            trial: vec![0.0; rows],
            tension: vec![0.0; rows],
            imbalance: vec![0.0; size],
            pull: vec![0.0; system.rigid.len()],
            bound: vec![0.0; rows],
            asked: vec![0.0; rows],
            held: vec![None; rows],
            anchor_rate: vec![0.0; system.friction.len()],
            v: vec![0.0; size],
            light: Light::all(system),
            answers: vec![[0.0; 3]; rows],
            stretch: vec![0.0; rows],
            compliance: vec![0.0; rows],
            lines: vec![Line::default(); system.rows.lines.last().copied().unwrap_or(0)],
            rotations: system.tree.bodies.iter().filter_map(first_rotation).collect(),
            rigid_scale: 1e6,
        }
    }

    /// Positions, velocities and forces of the rows at q₀ ⊕ φ, v; no accelerations, no gradients.
    pub fn rows(&mut self, system: &System, at: &Point, modes: &[Mode]) {
        self.place(system, at, modes);
        system.clock.time(Stage::Assembly, || {
            self.frame.kinematics.twists(&system.tree, at.v, &mut self.dynamics.twists);
            self.divide(system, at, modes);
            self.locate(system, at, modes);
            self.tensions(system, at, modes);
        });
    }

    /// The same and the imbalance.
    pub fn forces(&mut self, system: &System, at: &Point, modes: &[Mode]) {
        self.place(system, at, modes);
        system.clock.time(Stage::Assembly, || self.add_forces(system, at, modes));
    }

    fn add_forces(&mut self, system: &System, at: &Point, modes: &[Mode]) {
        self.dynamics.forward(&system.tree, &self.frame.kinematics, at.v, Some(at.a));
        self.divide(system, at, modes);
        self.locate(system, at, modes);
        self.tensions(system, at, modes);
        self.push(system, at);
    }

    /// The imbalance after [`Evaluation::rows`] at the same point.
    pub fn follow_rows(&mut self, system: &System, at: &Point) {
        system.clock.time(Stage::Assembly, || {
            self.dynamics.forward(&system.tree, &self.frame.kinematics, at.v, Some(at.a));
            self.push(system, at);
        });
    }

    /// Lets the rows act on what the motion asks for.
    fn push(&mut self, system: &System, at: &Point) {
        let rows = &system.rows;
        for (index, constraint) in system.exerting().iter().enumerate() {
            let tension = &self.tension[rows.first[index]..rows.first[index + 1]];
            if tension.iter().any(|tension| *tension != 0.0) {
                let lines = &self.lines[rows.lines[index]..rows.lines[index + 1]];
                constraint.apply(tension, lines, &mut self.dynamics.wrenches);
            }
        }
        self.balance(system, at);
        for &index in system.fed.iter().take_while(|&&index| index < system.first_light) {
            let tension = &self.tension[rows.first[index]..rows.first[index + 1]];
            let lines = &self.lines[rows.lines[index]..rows.lines[index + 1]];
            system.constraints[index].feed(tension, lines, &mut self.imbalance);
        }
        for (index, place) in system.coils.iter().enumerate() {
            let pull = self.frame.passing[index].supply * self.frame.feeding[index];
            self.imbalance[place.dof] += self.tension[place.row] * pull;
        }
    }

    /// The same and gradients. Here the wrenches of the dynamics are without the forces of the rows.
    pub fn all(&mut self, system: &System, at: &Point, modes: &[Mode]) {
        self.place(system, at, modes);
        system.clock.time(Stage::Assembly, || self.add_all(system, at, modes));
    }

    fn add_all(&mut self, system: &System, at: &Point, modes: &[Mode]) {
        self.dynamics.forward(&system.tree, &self.frame.kinematics, at.v, Some(at.a));
        self.divide(system, at, modes);
        self.frame.rows(system, &self.q, &at.remembered(modes));
        self.move_anchors(system, at);
        for (row, rate) in self.rate.iter_mut().enumerate().take(system.first_light_row()) {
            *rate = system.rows.rate(&self.frame.gradient, row, &self.v);
        }
        self.follow(system, at);
        self.tensions(system, at, modes);
        self.balance(system, at);
        for (row, &tension) in self.tension.iter().enumerate().take(system.first_light_row()) {
            if tension != 0.0 {
                for (dof, entry) in system.rows.entries(&self.frame.gradient, row) {
                    self.imbalance[dof] += entry * tension;
                }
            }
        }
    }

    fn place(&mut self, system: &System, at: &Point, modes: &[Mode]) {
        system.clock.time(Stage::Kinematics, || {
            self.v.copy_from_slice(at.v);
            self.q.copy_from_slice(at.base);
            system.tree.advance(&mut self.q, at.phi);
            coils::place(system, at.coils, modes, &mut self.q);
            self.frame.kinematics.past.copy_from_slice(at.past);
            self.frame.kinematics.update(&system.tree, &self.q, at.schedule.time);
        });
    }

    /// Values and rates of the rows from the motion of the bodies.
    fn locate(&mut self, system: &System, at: &Point, modes: &[Mode]) {
        let rows = &system.rows;
        let mut light = system.light.iter().map(|light| light.rope).peekable();
        for (index, constraint) in system.exerting().iter().enumerate() {
            let own = rows.first[index]..rows.first[index + 1];
            let lines = &mut self.lines[rows.lines[index]..rows.lines[index + 1]];
            let (value, rate) = (&mut self.frame.value[own.clone()], &mut self.rate[own.clone()]);
            let is_measured = light.next_if_eq(&index).is_some();
            if let (true, AnyConstraint::Rope(rope)) = (is_measured, constraint) {
                while light.next_if_eq(&index).is_some() {}
                rope.answer([&self.q, &self.v], Some(&self.answers[own]), (value, rate, lines));
                continue;
            }
            value.copy_from_slice(&at.memory[own]);
            let (kinematics, twists) = (&self.frame.kinematics, self.dynamics.twists.as_slice());
            let moving =
                Moving { kinematics, twists, q: &self.q, v: &self.v, seats: at.seats, spots: at.spots };
            constraint.locate(&moving, value, rate, lines);
        }
        self.frame.pass(system, &self.q, &at.remembered(modes));
        for (index, place) in system.coils.iter().enumerate() {
            let pull = self.frame.passing[index].supply * self.frame.feeding[index];
            self.rate[place.row] += pull * at.v[place.dof];
        }
        self.move_anchors(system, at);
        self.follow(system, at);
    }

    /// Rates of motors against what their drives ask for.
    fn follow(&mut self, system: &System, at: &Point) {
        for &(row, drive) in &system.motors {
            let timeline = &at.schedule.timelines[drive];
            self.asked[row] = timeline.motion(at.schedule.time).velocity;
            // A brake that comes in where the step ends is the next one's: it may not hold.
            self.held[row] = timeline.braked(at.schedule.from);
            self.rate[row] -= self.asked[row];
        }
    }

    /// Anchors that have slid by α since the start of the step.
    fn move_anchors(&mut self, system: &System, at: &Point) {
        for (anchor, &row) in at.anchor.iter().zip(&system.friction) {
            self.frame.value[row] -= anchor;
        }
    }

    /// Rates of the rows under other velocities, after [`Evaluation::forces`].
    pub fn rates(&self, system: &System, twists: &[Twist], v: &[f64], rate: &mut [f64]) {
        let rows = &system.rows;
        for (index, constraint) in system.exerting().iter().enumerate() {
            let lines = &self.lines[rows.lines[index]..rows.lines[index + 1]];
            constraint.rates(twists, v, lines, &mut rate[rows.first[index]..rows.first[index + 1]]);
        }
    }

    /// Forces of the rows from their values and rates.
    fn tensions(&mut self, system: &System, at: &Point, modes: &[Mode]) {
        let states = self.frame.value.iter().zip(&self.rate);
        for ((law, trial), (value, rate)) in system.exerting_laws().iter().zip(&mut self.trial).zip(states) {
            let compliance = law.compliance();
            *trial = if compliance > 0.0 { (value + law.damping_time() * rate) / compliance } else { 0.0 };
        }
        for (&row, tension) in system.rigid.iter().zip(at.rigid) {
            let acts = modes[row] == Mode::Acting;
            self.trial[row] = if acts { *tension } else { self.frame.value[row] * self.rigid_scale };
        }
        for row in 0..system.first_brake_row() {
            self.tension[row] = match modes[row] {
                Mode::Slack => 0.0,
                Mode::Parted | Mode::Off => {
                    self.trial[row] = 0.0;
                    0.0
                }
                Mode::Acting => self.trial[row],
                Mode::Slipping => self.trial[row] * self.slip_share(&system.rows.laws[row]),
            };
        }
        for (row, brake) in system.exerting_brakes() {
            let slips = modes[row] == Mode::Slipping;
            let direction = if slips { at.memory[row] } else { self.trial[row].signum() };
            let (q, kinematics, seats) = (self.q.as_slice(), &self.frame.kinematics, at.seats);
            let driven = -direction * at.v[brake.dof];
            let at_here = At { q, kinematics, seats };
            self.bound[row] = self.held[row].unwrap_or_else(|| brake.bound(at_here, &self.tension, driven));
            self.tension[row] = if slips { self.bound[row] * direction } else { self.trial[row] };
        }
        for (rate, &row) in self.anchor_rate.iter_mut().zip(&system.friction) {
            *rate = match modes[row] {
                Mode::Slipping => {
                    let law = &system.rows.laws[row];
                    law.compliance() / law.damping_time() * (self.trial[row] - self.tension[row])
                }
                _ => 0.0,
            };
        }
    }

    /// What the wrenches of the dynamics leave over, accelerations of inextensible ropes, φ̇.
    fn balance(&mut self, system: &System, at: &Point) {
        self.dynamics.backward(&system.tree, &self.frame.kinematics, &mut self.imbalance);
        let damping = system.tree.damping.iter().zip(at.v);
        for (imbalance, (damping, v)) in self.imbalance.iter_mut().zip(damping) {
            *imbalance += damping * v;
        }
        for &dof in &system.flows {
            self.imbalance[dof] += system.tree.armature[dof] * at.a[dof];
        }
        for (pull, &row) in self.pull.iter_mut().zip(&system.rigid) {
            *pull = match system.constraint_of_row(row) {
                AnyConstraint::Brake(brake) => brake.along(at.a),
                AnyConstraint::Pin(pin) => at.a[pin.dof],
                _ => pull_of(system, &self.frame, &self.dynamics, row),
            };
        }
        for &(row, drive) in &system.motors {
            if let Ok(index) = system.rigid.binary_search(&row) {
                let Schedule { timelines, from, time } = at.schedule;
                self.pull[index] -= timelines[drive].acceleration(from, time).0;
            }
        }
        let (joints, supplies) = self.phi_rate.split_at_mut(at.v.len());
        joints.copy_from_slice(&self.v);
        for (index, (place, rate)) in system.coils.iter().zip(supplies).enumerate() {
            *rate = self.frame.feeding[index] * at.v[place.dof];
            self.imbalance[place.dof] -= self.frame.coil_force(system, index);
        }
        for &first in &self.rotations {
            let range = first..first + 3;
            let phi = DVec3::from_slice(&at.phi[range.clone()]);
            let omega = DVec3::from_slice(&at.v[range.clone()]);
            self.phi_rate[range].copy_from_slice(&rate_of_rotation(phi, omega).to_array());
        }
    }

    /// Part of what the spring and damper of a sliding contact would carry that its bound lets through, μN/|T*|.
    pub fn slip_share(&self, law: &Law) -> f64 {
        let Law::Friction { coefficient, normal, .. } = *law else { return 1.0 };
        let size = self.trial[normal + 1].hypot(self.trial[normal + 2]);
        if size > 0.0 { coefficient * self.trial[normal].max(0.0) / size } else { 0.0 }
    }

    /// Direction of the force of a sliding contact with the given normal row, T*/|T*|.
    pub fn slip_direction(&self, normal: usize) -> [f64; 2] {
        let [x, y] = [1, 2].map(|k| self.trial[normal + k]);
        let size = x.hypot(y).max(f64::MIN_POSITIVE);
        [x / size, y / size]
    }
}

/// G v̇ + Ġ v of an inextensible rope at the motion of `dynamics`: each straight part gives
/// n·(ẍ_B − ẍ_A) + |u⊥|²/ℓ, u the relative velocity of its ends.
pub fn pull_of(system: &System, frame: &Frame, dynamics: &NewtonEuler, row: usize) -> f64 {
    let AnyConstraint::Rope(rope) = system.constraint_of_row(row) else { return 0.0 };
    let kinematics = &frame.kinematics;
    let motion = |end: &Attachment, point: DVec3| {
        let Some(body) = end.body else { return (DVec3::ZERO, DVec3::ZERO) };
        let arm = point - kinematics.pose[body].position;
        let (twist, rate) = (dynamics.twists[body], dynamics.accelerations[body]);
        let velocity = kinematics.point_velocity(&dynamics.twists, Some(body), point);
        (velocity, rate.linear + rate.angular.cross(arm) + twist.angular.cross(twist.angular.cross(arm)))
    };
    let mut sum = 0.0;
    for (part, straight) in rope.route.parts.iter().zip(rope.straights(kinematics)) {
        let (from, from_rate) = motion(&part.from.at, straight.from);
        let (to, to_rate) = motion(&part.to.at, straight.to);
        let (relative, along) = (to - from, (to - from).dot(straight.direction));
        sum += straight.direction.dot(to_rate - from_rate);
        if straight.length > 0.0 {
            sum += (relative.length_squared() - along * along) / straight.length;
        }
    }
    sum
}

/// First of the three rotations of a body's joint, where it has them in body axes.
pub fn first_rotation(body: &Body) -> Option<usize> {
    match body.joint {
        Joint::Ball(_) => Some(body.first_velocity),
        Joint::Free(_) => Some(body.first_velocity + 3),
        _ => None,
    }
}

/// φ̇ of a rotation vector φ in body axes under the angular velocity ω in body axes:
/// ω + φ×ω/2 + (1 − (φ/2) cot(φ/2)) φ×(φ×ω)/φ².
pub fn rate_of_rotation(phi: DVec3, omega: DVec3) -> DVec3 {
    let angle = phi.length();
    // The series is right to 1e-16 below an angle of 0.01.
    let share = if angle < 1e-2 {
        1.0 / 12.0 + angle * angle / 720.0
    } else {
        (1.0 - angle / 2.0 / (angle / 2.0).tan()) / (angle * angle)
    };
    let turn = phi.cross(omega);
    omega + turn / 2.0 + phi.cross(turn) * share
}

/// The angular velocity in body axes whose rotation vector φ changes at the rate φ̇, the inverse of [`rate_of_rotation`]:
/// φ̇ − (1 − cos φ) φ×φ̇/φ² + (1 − sin φ/φ) φ×(φ×φ̇)/φ².
pub fn turn_of_rate(phi: DVec3, rate: DVec3) -> DVec3 {
    let square = phi.length_squared();
    let angle = square.sqrt();
    let (first, second) = if angle < 1e-2 {
        (0.5 - square / 24.0, 1.0 / 6.0 - square / 120.0)
    } else {
        ((1.0 - angle.cos()) / square, (1.0 - angle.sin() / angle) / square)
    };
    let turn = phi.cross(rate);
    rate - turn * first + phi.cross(turn) * second
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::{rate_of_rotation, turn_of_rate};

    /// Below and above where the series end, and far beyond.
    fn turns() -> impl Iterator<Item = (DVec3, DVec3)> {
        let along = DVec3::new(2.0, -1.0, 2.0) / 3.0;
        [1e-4, 0.0099, 0.0101, 1.0, 2.5].map(|angle| (along * angle, DVec3::new(0.3, 0.8, -0.5))).into_iter()
    }

    /// R(φ + φ̇ δt) = R(φ) R(ω δt), by central differences: they are off by δt² and rounding over δt, 1e-9 here.
    #[test]
    fn a_rotation_vector_goes_as_its_body_turns() {
        const STEP: f64 = 1e-5;
        for (phi, omega) in turns() {
            let rate = rate_of_rotation(phi, omega);
            let at = |time: f64| DQuat::from_scaled_axis(phi + rate * time);
            let turned = (at(-STEP).conjugate() * at(STEP)).to_scaled_axis() / (2.0 * STEP);
            assert!((turned - omega).length() < 1e-9, "{phi}: {turned}");
        }
    }

    /// Each is the inverse of the other. What the series of (1 − cos φ)/φ² leaves out, φ⁴/720, is 1e-13 of ω at 0.01.
    #[test]
    fn rates_of_rotation_and_turns_are_inverse() {
        for (phi, omega) in turns() {
            let back = turn_of_rate(phi, rate_of_rotation(phi, omega));
            assert!((back - omega).length() < 1e-12, "{phi}: {back}");
        }
    }
}
