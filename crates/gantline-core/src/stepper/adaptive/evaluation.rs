//! The equations of motion at one point of a step, with the modes of the rows frozen.
//!
//! ```text
//! φ̇ = v (rotation vectors: see [`rate_of_rotation`])      0 = τ(q, v, a) + D v + Gᵀ T
//! T = (e + τ ė)/ε for rows that act, 0 for slack ones, μ N d for sliding ones
//! G v̇ + Ġ v = 0 for inextensible ropes that act, whose T is an unknown of its own
//! ```
//!
//! τ is inverse dynamics; q = q₀ ⊕ φ with q₀ the configuration at the start of the step.

use glam::DVec3;

use crate::constraint::{AnyConstraint, Law};
use crate::rope::route::Attachment;
use crate::solver::complementarity::Mode;
use crate::stepper::frame::Frame;
use crate::system::System;
use crate::tree::bias::NewtonEuler;
use crate::tree::joint::Joint;

/// Sliding slower than this, v₀ [m/s], keeps the direction in which it started.
const SLOW: f64 = 1e-4;

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
            phi_rate: vec![0.0; size],
            rate: vec![0.0; rows],
            trial: vec![0.0; rows],
            tension: vec![0.0; rows],
            imbalance: vec![0.0; size],
            pull: vec![0.0; system.rigid.len()],
            rigid_scale: 1e6,
        }
    }

    /// Positions, velocities and forces of the rows at q₀ ⊕ φ, v; no dynamics.
    pub fn rows(&mut self, system: &System, at: &Point, modes: &[Mode], slip: &[f64]) {
        self.q.copy_from_slice(at.base);
        system.tree.advance(&mut self.q, at.phi);
        self.frame.update_rows(system, &self.q, at.memory);
        for row in 0..system.rows.count() {
            let law = &system.rows.laws[row];
            self.rate[row] = system.rows.rate(&self.frame.gradient, row, at.v);
            self.trial[row] = if law.compliance() > 0.0 {
                (self.frame.value[row] + law.damping_time() * self.rate[row]) / law.compliance()
            } else {
                0.0
            };
        }
        for (&row, tension) in system.rigid.iter().zip(at.rigid) {
            let acts = modes[row] == Mode::Acting;
            self.trial[row] = if acts { *tension } else { self.frame.value[row] * self.rigid_scale };
        }
        for (row, mode) in modes.iter().enumerate() {
            self.tension[row] = match mode {
                Mode::Slack => 0.0,
                Mode::Acting => self.trial[row],
                Mode::Slipping => self.slip_force(&system.rows.laws, row, slip),
            };
        }
    }

    /// All of the above and the imbalance.
    pub fn all(&mut self, system: &System, at: &Point, modes: &[Mode], slip: &[f64]) {
        self.rows(system, at, modes, slip);
        let kinematics = &self.frame.kinematics;
        self.dynamics.update(&system.tree, kinematics, at.v, Some(at.a), None, &mut self.imbalance);
        for (dof, damping) in system.tree.damping.iter().enumerate() {
            self.imbalance[dof] += damping * at.v[dof];
        }
        for row in 0..system.rows.count() {
            let tension = self.tension[row];
            if tension != 0.0 {
                for (dof, entry) in system.rows.entries(&self.frame.gradient, row) {
                    self.imbalance[dof] += entry * tension;
                }
            }
        }
        for (pull, &row) in self.pull.iter_mut().zip(&system.rigid) {
            *pull = pull_of(system, &self.frame, &self.dynamics, row);
        }
        self.phi_rate.copy_from_slice(at.v);
        for body in &system.tree.bodies {
            if let Some(first) = rotation(&body.joint) {
                let range = body.first_velocity + first..body.first_velocity + first + 3;
                let phi = DVec3::from_slice(&at.phi[range.clone()]);
                let omega = DVec3::from_slice(&at.v[range.clone()]);
                self.phi_rate[range].copy_from_slice(&rate_of_rotation(phi, omega).to_array());
            }
        }
    }

    /// Force of a sliding contact along one tangent, with its direction against the motion.
    fn slip_force(&self, laws: &[Law], row: usize, slip: &[f64]) -> f64 {
        let Law::Friction { coefficient, normal, .. } = laws[row] else { return 0.0 };
        coefficient * self.trial[normal].max(0.0) * self.slip_direction(normal, slip)[row - normal - 1]
    }

    /// How the force of a sliding contact turns with its velocity: μN/|v + v₀ d₀| [N s/m].
    pub fn turning(&self, coefficient: f64, normal: usize, slip: &[f64]) -> f64 {
        let [x, y] = self.slip_velocity(normal, slip);
        coefficient * self.trial[normal].max(0.0) / x.hypot(y)
    }

    /// Direction of the motion of a sliding contact with the given normal row.
    pub fn slip_direction(&self, normal: usize, slip: &[f64]) -> [f64; 2] {
        let [x, y] = self.slip_velocity(normal, slip);
        let speed = x.hypot(y);
        [x / speed, y / speed]
    }

    /// v + v₀ d₀, d₀ the direction at the start of the step: without v₀ a contact that starts to slide would have
    /// no direction, and one that hardly moves could turn infinitely fast.
    fn slip_velocity(&self, normal: usize, slip: &[f64]) -> [f64; 2] {
        [1, 2].map(|k| self.rate[normal + k] + SLOW * slip[normal + k])
    }
}

/// Where to evaluate.
pub struct Point<'a> {
    /// q₀.
    pub base: &'a [f64],
    /// What rows remember.
    pub memory: &'a [f64],
    /// φ.
    pub phi: &'a [f64],
    /// v.
    pub v: &'a [f64],
    /// v̇.
    pub a: &'a [f64],
    /// Tensions of inextensible ropes [N], by [`System::rigid`].
    pub rigid: &'a [f64],
}

/// G v̇ + Ġ v of an inextensible rope at the motion of `dynamics`: each straight part gives
/// n·(ẍ_B − ẍ_A) + |u⊥|²/ℓ, u the relative velocity of its ends.
pub fn pull_of(system: &System, frame: &Frame, dynamics: &NewtonEuler, row: usize) -> f64 {
    let AnyConstraint::Rope(rope) = &system.constraints[row] else { return 0.0 };
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
        let (from, from_rate) = motion(&part.from, straight.from);
        let (to, to_rate) = motion(&part.to, straight.to);
        let (relative, along) = (to - from, (to - from).dot(straight.direction));
        sum += straight.direction.dot(to_rate - from_rate);
        if straight.length > 0.0 {
            sum += (relative.length_squared() - along * along) / straight.length;
        }
    }
    sum
}

/// Offset of the three rotations among a joint's degrees of freedom, where it has them in body axes.
pub fn rotation(joint: &Joint) -> Option<usize> {
    match joint {
        Joint::Ball(_) => Some(0),
        Joint::Free(_) => Some(3),
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
