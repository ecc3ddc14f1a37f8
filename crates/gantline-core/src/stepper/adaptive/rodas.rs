//! One step of Rodas5P for the equations of motion, as differential-algebraic equations of index 1 in the
//! increments φ of the coordinates, the velocities v and the accelerations a:
//!
//! ```text
//! φ̇ = v + φ×v/2 + …        v̇ = a        0 = τ(q₀⊕φ, v, a) + D v + Gᵀ T
//! ```
//!
//! Stage i, with κ = γh, ρ = a + Σ cᵢⱼ k^aⱼ/h replaced by its velocity part, x = k^φ as a rate:
//!
//! ```text
//! r = φ̇ + Σ cᵢⱼ k^φⱼ/h            ρ = a + Σ cᵢⱼ k^vⱼ/h
//! A x + Gᵀ y = −κ (τ + D v + Gᵀ T) + M (κρ + r) + κ (D + ∂τ/∂v) r
//! B x − ε/(κ(κ+τ)) y = τ G r/(κ+τ)          (A, B: see `tangent`)
//! k^φ = κ P x        k^v = x − r        k^a = k^v/κ − ρ
//! ```
//!
//! For an inextensible rope T is an unknown too, with the equation γ = G a + Ġ v = 0:
//!
//! ```text
//! (G + κ γ_v + κ² γ_q P) x = −κγ + G (κρ + r) + κ γ_v r        k^T = y/κ
//! ```
//!
//! The anchor α of a sliding contact is one too, α̇ = (u − εT)/τ, u = e + τ ė of its tangential rows:
//!
//! ```text
//! r_α = α̇ + Σ cᵢⱼ k^αⱼ/h            k^α = (κτ r_α + κ δu − ε y)/(κ + τ), δu at rest of the anchor
//! ```
//!
//! Water that remembers ([`crate::force::memory`]) has the states z with ż = p z + ν(q, v), τ holding Jᵀ Re Σ R z. They
//! are eliminated: the matrix has Jᵀ K̂ (∂ν/∂v + κ ∂ν/∂q P) in place of a damping, K̂ = κ Re Σ R (1 − κp)⁻¹, and
//!
//! ```text
//! r_z = ż + Σ cᵢⱼ k^zⱼ/h           k^z = κ (1 − κp)⁻¹ (r_z + ∂ν/∂q k^φ + ∂ν/∂v k^v)
//! ```
//!
//! whose part without x goes to the right side, −κ Jᵀ Re Σ R κ (1 − κp)⁻¹ (r_z − ∂ν/∂v r).
//!
//! Where waves push, τ depends on time too, and −κ h dᵢ ∂τ/∂t joins the first right side.
//!
//! The acceleration is never solved for: the residual of inverse dynamics takes its place, so a mass matrix
//! that changes with q costs nothing extra.

use super::evaluation::Evaluation;
use super::light::{self, Laying};
use super::point::{Point, Schedule};
use super::tableau::{A, C, D, GAMMA, H, STAGES, TIMES};
use super::tangent::TangentMatrix;
use super::tangent::rows::{brake_of, slip_weights};
use crate::clock::Stage;
use crate::constraint::Law;
use crate::force;
use crate::force::memory::{self, memories};
use crate::solver::complementarity::Mode;
use crate::solver::symbolic::ZeroPivot;
use crate::state::State;
use crate::stepper::coils;
use crate::system::System;
use crate::tree::mass::MassMatrix;

/// Increments of coordinates, velocities, accelerations, tensions of inextensible ropes, and anchors.
#[derive(Debug, Clone)]
pub struct Increment {
    /// φ.
    pub phi: Vec<f64>,
    /// Of v.
    pub v: Vec<f64>,
    /// Of a.
    pub a: Vec<f64>,
    /// Of T, by [`System::rigid`].
    pub rigid: Vec<f64>,
    /// α, by [`System::friction`].
    pub anchor: Vec<f64>,
    /// z of all forces that remember.
    pub past: Vec<f64>,
}

impl Increment {
    /// Zero, for `system`.
    pub fn zero(system: &System) -> Self {
        let size = system.tree.velocities;
        let (rigid, anchor) = (vec![0.0; system.rigid.len()], vec![0.0; system.friction.len()]);
        Self {
            phi: vec![0.0; system.tree.increments()],
            v: vec![0.0; size],
            a: vec![0.0; size],
            rigid,
            anchor,
            past: vec![0.0; memory::states(&system.tree)],
        }
    }

    fn set(&mut self, weights: &[f64], terms: &[Self], base: &Self) {
        self.phi.copy_from_slice(&base.phi);
        self.v.copy_from_slice(&base.v);
        self.a.copy_from_slice(&base.a);
        self.rigid.copy_from_slice(&base.rigid);
        self.anchor.copy_from_slice(&base.anchor);
        self.past.copy_from_slice(&base.past);
        for (&weight, term) in weights.iter().zip(terms) {
            if weight != 0.0 {
                add(&mut self.phi, weight, &term.phi);
                add(&mut self.v, weight, &term.v);
                add(&mut self.a, weight, &term.a);
                add(&mut self.rigid, weight, &term.rigid);
                add(&mut self.anchor, weight, &term.anchor);
                add(&mut self.past, weight, &term.past);
            }
        }
    }
}

fn add(out: &mut [f64], weight: f64, values: &[f64]) {
    for (out, value) in out.iter_mut().zip(values) {
        *out += weight * value;
    }
}

/// A step that has been computed and not yet made: a course in time from `start` on.
#[derive(Debug, Clone)]
pub struct Course {
    /// Length [s].
    pub h: f64,
    /// v, a and z at the start; φ and α are 0.
    start: Increment,
    /// Motion at the end: φ, v, a.
    pub end: Increment,
    /// Error estimate.
    pub error: Increment,
    /// Terms of the dense output.
    dense: [Increment; 3],
}

impl Course {
    /// Motion at the share `theta` of the step.
    pub fn at(&self, theta: f64, out: &mut Increment) {
        let rest = 1.0 - theta;
        let [first, second, third] = [theta * rest, theta * theta * rest, theta * theta * theta * rest];
        let mix = |k: usize, start: f64, end: &[f64], z: [&[f64]; 3]| {
            rest * start + theta * end[k] + first * z[0][k] + second * z[1][k] + third * z[2][k]
        };
        let [z1, z2, z3] = &self.dense;
        for k in 0..out.phi.len() {
            out.phi[k] = mix(k, 0.0, &self.end.phi, [&z1.phi, &z2.phi, &z3.phi]);
        }
        for k in 0..out.v.len() {
            out.v[k] = mix(k, self.start.v[k], &self.end.v, [&z1.v, &z2.v, &z3.v]);
            out.a[k] = mix(k, self.start.a[k], &self.end.a, [&z1.a, &z2.a, &z3.a]);
        }
        for k in 0..out.rigid.len() {
            let terms: [&[f64]; 3] = [&z1.rigid, &z2.rigid, &z3.rigid];
            out.rigid[k] = mix(k, self.start.rigid[k], &self.end.rigid, terms);
        }
        for k in 0..out.anchor.len() {
            out.anchor[k] = mix(k, 0.0, &self.end.anchor, [&z1.anchor, &z2.anchor, &z3.anchor]);
        }
        for k in 0..out.past.len() {
            out.past[k] = mix(k, self.start.past[k], &self.end.past, [&z1.past, &z2.past, &z3.past]);
        }
    }

    /// Derivative over time of φ, v and α at the share `theta`, in `out.phi`, `out.v` and `out.anchor`.
    pub fn rate_at(&self, theta: f64, out: &mut Increment) {
        // d/dθ of (1−θ) y + θ y₊ + (θ − θ²) z₁ + (θ² − θ³) z₂ + (θ³ − θ⁴) z₃.
        let slopes = [1.0 - 2.0 * theta, theta * (2.0 - 3.0 * theta), theta * theta * (3.0 - 4.0 * theta)];
        let [z1, z2, z3] = &self.dense;
        for k in 0..out.phi.len() {
            let phi = self.end.phi[k] + slopes[0] * z1.phi[k] + slopes[1] * z2.phi[k] + slopes[2] * z3.phi[k];
            out.phi[k] = phi / self.h;
        }
        for k in 0..out.v.len() {
            let v = self.end.v[k] - self.start.v[k]
                + slopes[0] * z1.v[k]
                + slopes[1] * z2.v[k]
                + slopes[2] * z3.v[k];
            out.v[k] = v / self.h;
        }
        for k in 0..out.anchor.len() {
            let terms = slopes[0] * z1.anchor[k] + slopes[1] * z2.anchor[k] + slopes[2] * z3.anchor[k];
            out.anchor[k] = (self.end.anchor[k] + terms) / self.h;
        }
    }
}

/// The method with its work arrays.
#[derive(Debug, Clone)]
pub struct Rodas {
    /// The start of the step.
    pub here: Evaluation,
    /// The step.
    pub course: Course,
    /// The matrix of the stages.
    pub matrix: TangentMatrix,
    stage: Evaluation,
    k: Vec<Increment>,
    point: Increment,
    none: Increment,
    r: Vec<f64>,
    rho: Vec<f64>,
    /// r_α, by [`System::friction`].
    slid: Vec<f64>,
    /// What is known of k^z.
    recalled: Vec<f64>,
    sum: Vec<f64>,
    force: Vec<f64>,
    /// ∂τ/∂t at the start of the step, by waves alone; empty without any.
    drift: Vec<f64>,
    rows: Vec<f64>,
    x: Vec<f64>,
}

impl Rodas {
    /// Room for `system`.
    pub fn new(system: &System) -> Self {
        let size = system.tree.velocities;
        let zero = || Increment::zero(system);
        Self {
            here: Evaluation::new(system),
            course: Course {
                h: 0.0,
                start: zero(),
                end: zero(),
                error: zero(),
                dense: [zero(), zero(), zero()],
            },
            matrix: TangentMatrix::new(system),
            stage: Evaluation::new(system),
            k: vec![zero(); STAGES],
            point: zero(),
            none: zero(),
            r: vec![0.0; system.tree.increments()],
            rho: vec![0.0; size],
            slid: vec![0.0; system.friction.len()],
            recalled: vec![0.0; memory::states(&system.tree)],
            sum: vec![0.0; size],
            force: vec![0.0; size],
            drift: if force::knows_time(&system.tree) { vec![0.0; size] } else { Vec::new() },
            rows: vec![0.0; system.rows.count()],
            x: vec![0.0; size],
        }
    }

    /// Evaluates the motion at the start of a step.
    pub fn evaluate(&mut self, system: &System, state: &State) {
        for (tension, &row) in self.point.rigid.iter_mut().zip(&system.rigid) {
            *tension = state.tension[row];
        }
        let point = Point {
            schedule: Schedule::after(state, 0.0),
            base: &state.q,
            memory: &state.memory,
            seats: &state.seats,
            spots: &state.spots,
            coils: &state.coils,
            phi: &self.none.phi,
            v: &state.v,
            a: &state.acceleration,
            rigid: &self.point.rigid,
            anchor: &self.none.anchor,
            past: &state.past,
            laying: Laying::Anew,
        };
        self.here.all(system, &point, &state.modes);
    }

    /// Evaluates the tangents there.
    pub fn linearise(&mut self, system: &System, state: &State, mass: &MassMatrix) {
        system.clock.time(Stage::Assembly, || self.matrix.linearise(system, &self.here, mass, state));
        if !self.drift.is_empty() {
            force::drift(&system.tree, &self.here.frame.kinematics, &state.v, &mut self.drift);
        }
    }

    /// Computes a step of length `h` [s] from `state`, where [`Rodas::evaluate`] and [`Rodas::linearise`] have been called.
    ///
    /// # Errors
    /// [`ZeroPivot`] where the matrix is singular.
    pub fn attempt(
        &mut self,
        system: &System,
        state: &State,
        mass: &MassMatrix,
        h: f64,
    ) -> Result<(), ZeroPivot> {
        let kappa = GAMMA * h;
        self.course.start.v.copy_from_slice(&state.v);
        self.course.start.a.copy_from_slice(&state.acceleration);
        self.course.start.past.copy_from_slice(&state.past);
        for (tension, &row) in self.course.start.rigid.iter_mut().zip(&system.rigid) {
            *tension = state.tension[row];
        }
        let modes = &state.modes;
        system
            .clock
            .time(Stage::Factorisation, || self.matrix.factorise(system, &self.here, state, kappa))?;
        for stage in 0..STAGES {
            self.point.set(A[stage], &self.k, &self.course.start);
            if stage > 0 {
                let laying = Laying::Frozen(&self.here.light);
                let point = Point { laying, ..Point::of(state, &self.point, TIMES[stage] * h) };
                self.stage.forces(system, &point, modes);
            }
            self.stage_sides(system, state, mass, stage, h);
            self.recall(system, stage, h);
            system.clock.time(Stage::Solution, || self.matrix.solve(&self.force, &self.rows, &mut self.x));
            let k = &mut self.k[stage];
            self.matrix.spins.increments(kappa, &self.x, &mut k.phi);
            for dof in 0..self.x.len() {
                k.v[dof] = self.x[dof] - self.r[dof];
                k.a[dof] = k.v[dof] / kappa - self.rho[dof];
            }
            for (tension, &row) in k.rigid.iter_mut().zip(&system.rigid) {
                *tension = self.matrix.row_solution(row) / kappa;
            }
            let Increment { phi, v, .. } = k;
            self.matrix.coils.increments(system, &self.here.frame, kappa, (phi, v, &self.r));
            self.slide(system, state, stage, kappa);
            self.remember(system, stage, kappa);
        }
        self.finish(h);
        Ok(())
    }

    /// Right sides of a stage, and the rates of the driven degrees of freedom.
    fn stage_sides(&mut self, system: &System, state: &State, mass: &MassMatrix, stage: usize, h: f64) {
        let kappa = GAMMA * h;
        let at = if stage == 0 { &self.here } else { &self.stage };
        self.r.copy_from_slice(&at.phi_rate);
        self.rho.copy_from_slice(&self.point.a);
        for (&weight, k) in C[stage].iter().zip(&self.k) {
            add(&mut self.r, weight / h, &k.phi);
            add(&mut self.rho, weight / h, &k.v);
        }
        coils::follow(system, &state.coils, &self.here.frame.feeding, &mut self.r);
        light::follow(system, &self.here, &state.modes, (&mut self.r, &mut self.rows));
        for (drive, timeline) in system.prescribed(&state.plan.timelines) {
            let dof = drive.dof;
            let (now, _) = timeline.acceleration(state.time, state.time + TIMES[stage] * h);
            let (_, jerk) = timeline.acceleration(state.time, state.time);
            let k_a = now - self.point.a[dof] + h * D[stage] * jerk;
            self.x[dof] = self.r[dof] + kappa * (k_a + self.rho[dof]);
        }
        for dof in 0..self.sum.len() {
            self.sum[dof] = kappa * self.rho[dof] + self.r[dof];
        }
        mass.multiply(&self.sum, &mut self.force);
        self.matrix.add_damping(system, mass, &self.r[..self.sum.len()], kappa, &mut self.force);
        for (force, imbalance) in self.force.iter_mut().zip(&at.imbalance) {
            *force -= kappa * imbalance;
        }
        add(&mut self.force, -kappa * h * D[stage], &self.drift);
        for &dof in system.light.iter().flat_map(|light| &light.dofs) {
            self.force[dof] = 0.0;
        }
        for (row, law) in system.rows.laws.iter().enumerate() {
            let tau = law.damping_time();
            self.rows[row] = match state.modes[row] {
                Mode::Acting if tau > 0.0 => {
                    tau * system.rows.rate(&self.here.frame.gradient, row, &self.r) / (kappa + tau)
                }
                _ => 0.0,
            };
        }
        for (index, place) in system.coils.iter().enumerate() {
            if state.modes[place.row] == Mode::Acting {
                let feeding = self.here.frame.feeding[index];
                let beside = self.r[self.sum.len() + index] - feeding * self.r[place.dof];
                let known = (kappa, beside);
                self.rows[place.row] -= self.matrix.coils.known(system, &self.here.frame, index, known);
            }
        }
        for (index, &row) in system.friction.iter().enumerate() {
            if state.modes[row] == Mode::Slipping {
                let others = C[stage].iter().zip(&self.k);
                let before: f64 = others.map(|(&weight, k)| weight / h * k.anchor[index]).sum();
                self.slid[index] = at.anchor_rate[index] + before;
            }
        }
        for (index, &row) in system.rigid.iter().enumerate() {
            if state.modes[row] == Mode::Acting {
                let along = system.rows.rate(&self.here.frame.gradient, row, &self.sum);
                let turning = self.matrix.pull_rate(system, index, &self.r);
                self.rows[row] = along + kappa * (turning - at.pull[index]);
            }
        }
        for &(row, drive) in system.motors.iter().filter(|(row, _)| state.modes[*row] == Mode::Acting) {
            let (_, jerk) = state.plan.timelines[drive].acceleration(state.time, state.time);
            self.rows[row] += kappa * h * D[stage] * jerk;
        }
        for &(row, _) in system.motors.iter().filter(|(row, _)| state.modes[*row] == Mode::Slipping) {
            if let (Some(brake), None) = (brake_of(system, row), self.here.held[row]) {
                let driven = -state.memory[row] * state.v[brake.dof];
                self.rows[row] = -kappa * brake.slope(driven) * self.r[brake.dof];
            }
        }
        for index in 0..system.friction.len() {
            self.slip_side(system, state, kappa, index);
        }
    }

    /// Right side of a tangential row, by [`System::friction`], where it slides: what is known of its anchor's
    /// motion and of its damper's turns the force.
    fn slip_side(&mut self, system: &System, state: &State, kappa: f64, index: usize) {
        let row = system.friction[index];
        let law = &system.rows.laws[row];
        let Law::Friction { normal, damping_time, .. } = *law else { return };
        if state.modes[row] == Mode::Slipping {
            let partner = 2 * normal + 3 - row;
            let known = |row: usize, index: usize| {
                let rate = system.rows.rate(&self.here.frame.gradient, row, &self.r);
                damping_time * rate + kappa * self.slid[index]
            };
            let [own, other] = slip_weights(law, &self.here, kappa, row);
            self.rows[row] = own * known(row, index) + other * known(partner, index + partner - row);
        }
    }

    /// The stage's increment of the anchors of sliding contacts.
    fn slide(&mut self, system: &System, state: &State, stage: usize, kappa: f64) {
        for (index, &row) in system.friction.iter().enumerate() {
            self.k[stage].anchor[index] = 0.0;
            if state.modes[row] == Mode::Slipping {
                let (tau, compliance) =
                    (system.rows.laws[row].damping_time(), system.rows.laws[row].compliance());
                let Increment { phi, v, .. } = &self.k[stage];
                let stretch = self.matrix.stretch(system, &self.here, row, phi, v);
                let force = self.matrix.row_solution(row);
                self.k[stage].anchor[index] =
                    (kappa * (tau * self.slid[index] + stretch) - compliance * force) / (kappa + tau);
            }
        }
    }

    /// What is known of the increments of what water remembers before the motion of the stage is, and what that does to
    /// the right side.
    fn recall(&mut self, system: &System, stage: usize, h: f64) {
        if self.recalled.is_empty() {
            return;
        }
        let kappa = GAMMA * h;
        let at = if stage == 0 { &self.here } else { &self.stage };
        self.recalled.fill(0.0);
        for (&weight, k) in C[stage].iter().zip(&self.k) {
            add(&mut self.recalled, weight / h, &k.past);
        }
        for (memory, tangent) in memories(&system.tree).zip(&self.matrix.memories) {
            let place = at.dynamics.at(&system.tree, &at.frame.kinematics, memory.body);
            let (now, before) = (memory.motion(place.pose, &place.twist), tangent.motion(None, &self.r));
            let motion = std::array::from_fn(|k| now[k] - before[k]);
            memory.add_rate(&self.point.past, &motion, 1.0, &mut self.recalled);
        }
        let known = &mut self.k[stage].past;
        for (known, rate) in known.iter_mut().zip(&mut self.recalled) {
            *rate *= kappa;
            *known = *rate;
        }
        for (memory, tangent) in memories(&system.tree).zip(&self.matrix.memories) {
            memory.answer(kappa, &[0.0; 6], &mut self.recalled);
            tangent.push(memory, &self.recalled, -kappa, &mut self.force);
        }
    }

    /// The stage's increments of what water remembers.
    fn remember(&mut self, system: &System, stage: usize, kappa: f64) {
        let Increment { phi, past, .. } = &mut self.k[stage];
        for (memory, tangent) in memories(&system.tree).zip(&self.matrix.memories) {
            memory.answer(kappa, &tangent.motion(Some(phi), &self.x), past);
        }
    }

    fn finish(&mut self, h: f64) {
        let Course { h: length, end, error, dense, .. } = &mut self.course;
        *length = h;
        let last = &self.k[STAGES - 1];
        for dof in 0..self.x.len() {
            end.v[dof] = self.point.v[dof] + last.v[dof];
            end.a[dof] = self.point.a[dof] + last.a[dof];
        }
        for (end, (point, last)) in end.phi.iter_mut().zip(self.point.phi.iter().zip(&last.phi)) {
            *end = point + last;
        }
        error.phi.copy_from_slice(&last.phi);
        error.v.copy_from_slice(&last.v);
        error.a.copy_from_slice(&last.a);
        for (index, end) in end.rigid.iter_mut().enumerate() {
            *end = self.point.rigid[index] + last.rigid[index];
            error.rigid[index] = last.rigid[index];
        }
        for (index, end) in end.anchor.iter_mut().enumerate() {
            *end = self.point.anchor[index] + last.anchor[index];
        }
        error.anchor.copy_from_slice(&last.anchor);
        for (end, (point, last)) in end.past.iter_mut().zip(self.point.past.iter().zip(&last.past)) {
            *end = point + last;
        }
        error.past.copy_from_slice(&last.past);
        for (term, weights) in dense.iter_mut().zip(&H) {
            term.set(weights, &self.k, &self.none);
        }
    }

    /// The course of the flows of light sheaves, as far as it is recorded: straight to where `end` has them.
    pub fn straighten(&mut self, system: &System, share: f64, end: &Increment) {
        for &dof in system.light.iter().flat_map(|light| &light.dofs) {
            for term in &mut self.course.dense {
                (term.phi[dof], term.v[dof], term.a[dof]) = (0.0, 0.0, 0.0);
            }
            self.course.end.phi[dof] = end.phi[dof] / share;
            self.course.end.v[dof] =
                self.course.start.v[dof] + (end.v[dof] - self.course.start.v[dof]) / share;
            (self.course.start.a[dof], self.course.end.a[dof]) = (0.0, 0.0);
        }
    }
}
