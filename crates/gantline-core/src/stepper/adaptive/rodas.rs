//! One step of Rodas5P for the equations of motion, as differential-algebraic equations of index 1 in the
//! increments φ of the coordinates, the velocities v and the accelerations a. Numbers as in `docs/concepts/adaptive.md`:
//!
//! ```text
//! φ̇ = v + φ×v/2 + …        v̇ = a        0 = τ(q₀⊕φ, v, a) + D v + Gᵀ T                  (AD1)
//! ```
//!
//! The acceleration is never solved for: the residual of inverse dynamics takes its place, so a mass matrix
//! that changes with q costs nothing extra. With κ = γh stage i asks for k = (k^φ, k^v, k^a). What it knows is
//!
//! ```text
//! r = φ̇ + Σ cᵢⱼ k^φⱼ/h            ρ = a + Σ cᵢⱼ k^vⱼ/h
//! ```
//!
//! and x = r + k^v, the rate of the coordinates, gives all three,
//!
//! ```text
//! k^φ = κ P x        k^v = x − r        k^a = k^v/κ − ρ                                  (AD2)
//! ```
//!
//! so that one system is left, for x and y = κ δT (A, B: see [`super::tangent`]):
//!
//! ```text
//! A x + Gᵀ y = −κ (τ + D v + Gᵀ T) + M (κρ + r) + κ (D + ∂τ/∂v) r
//! B x − ε/(κ(κ+τ)) y = τ G r/(κ+τ)                                                      (AD3)
//! ```
//!
//! For an inextensible rope T is an unknown too, with the equation γ = G a + Ġ v = 0:
//!
//! ```text
//! (G + κ γ_v + κ² γ_q P) x = −κγ + G (κρ + r) + κ γ_v r        k^T = y/κ
//! ```
//!
//! The anchor α of a sliding contact (AD6) is one too, α̇ = (u − εT)/τ, u = e + τ ė of its tangential rows:
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
//! (AD4), the test of what drives alone move, stands in `prescribed`; (AD5), impacts, in `impact`.

mod sides;

use super::course::{Course, Increment};
use super::evaluation::Evaluation;
use super::light::Laying;
use super::point::{Point, Schedule};
use super::tableau::{A, GAMMA, STAGES, TIMES};
use super::tangent::TangentMatrix;
use crate::clock::Stage;
use crate::force;
use crate::force::memory::memories;
use crate::solver::complementarity::Mode;
use crate::solver::symbolic::ZeroPivot;
use crate::state::State;
use crate::system::System;
use crate::tree::mass::MassMatrix;

/// The method with its work arrays.
#[derive(Debug, Clone)]
pub struct Rodas {
    /// The start of the step.
    pub here: Evaluation,
    /// The step.
    pub course: Course,
    /// The matrix of the stages.
    pub matrix: TangentMatrix,
    /// The place of a stage, and what is evaluated there.
    point: Increment,
    stage: Evaluation,
    /// k of all stages.
    k: Vec<Increment>,
    none: Increment,
    /// r and ρ, and κρ + r.
    r: Vec<f64>,
    rho: Vec<f64>,
    sum: Vec<f64>,
    /// r_α, by [`System::friction`].
    slid: Vec<f64>,
    /// What is known of k^z.
    recalled: Vec<f64>,
    /// Rows and degrees of freedom of brakes that hold these alone, and at rest; of motors their drives.
    resting: Vec<(usize, usize, Option<usize>)>,
    /// ∂τ/∂t at the start of the step, by waves alone; empty without any.
    over_time: Vec<f64>,
    /// Right sides of (AD3), of degrees of freedom and of rows, and x.
    force: Vec<f64>,
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
            course: Course::new(system),
            matrix: TangentMatrix::new(system),
            point: zero(),
            stage: Evaluation::new(system),
            k: vec![zero(); STAGES],
            none: zero(),
            r: vec![0.0; system.tree.increments()],
            rho: vec![0.0; size],
            sum: vec![0.0; size],
            slid: vec![0.0; system.friction.len()],
            recalled: vec![0.0; force::states(&system.tree)],
            resting: resting(system),
            over_time: if force::knows_time(&system.tree) { vec![0.0; size] } else { Vec::new() },
            force: vec![0.0; size],
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
        if !self.over_time.is_empty() {
            let Evaluation { frame, dynamics, .. } = &self.here;
            force::over_time(&system.tree, &frame.kinematics, dynamics, &mut self.over_time);
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
        self.course.begin(system, state);
        system
            .clock
            .time(Stage::Factorisation, || self.matrix.factorise(system, &self.here, state, kappa))?;
        for stage in 0..STAGES {
            self.point.set(A[stage], &self.k, &self.course.start);
            // The first stage is at the start of the step, which has been evaluated.
            if stage > 0 {
                let laying = Laying::Frozen(&self.here.light);
                let point = Point { laying, ..Point::of(state, &self.point, TIMES[stage] * h) };
                self.stage.forces(system, &point, &state.modes);
            }
            self.know(system, state, stage, h);
            self.motion_side(system, mass, stage, h);
            self.row_sides(system, state, stage, h);
            self.recall(system, stage, h);
            system.clock.time(Stage::Solution, || self.matrix.solve(&self.force, &self.rows, &mut self.x));
            self.increments(system, state, stage, kappa);
            self.slide(system, state, stage, kappa);
            self.remember(system, stage, kappa);
        }
        self.course.finish(h, &self.point, &self.k);
        Ok(())
    }

    /// (AD2): the stage's increments from x, and those of the tensions of inextensible ropes.
    fn increments(&mut self, system: &System, state: &State, stage: usize, kappa: f64) {
        let k = &mut self.k[stage];
        self.matrix.spins.increments(kappa, &self.x, &mut k.phi);
        for dof in 0..self.x.len() {
            k.v[dof] = self.x[dof] - self.r[dof];
            k.a[dof] = k.v[dof] / kappa - self.rho[dof];
        }
        for (tension, &row) in k.rigid.iter_mut().zip(&system.rigid) {
            *tension = self.matrix.row_solution(row) / kappa;
        }
        self.keep_at_rest(state, stage);
        let Increment { phi, v, .. } = &mut self.k[stage];
        self.matrix.coils.increments(system, &self.here.frame, kappa, (phi, v, &self.r));
    }

    /// What brakes hold does not move at all: rounding that adds up would decide which rope a drum pays out first as it
    /// lets go.
    fn keep_at_rest(&mut self, state: &State, stage: usize) {
        for &(row, dof, drive) in &self.resting {
            let is_driven = drive.is_some_and(|drive| !state.plan.timelines[drive].rests(state.time));
            if state.modes[row] == Mode::Acting && state.v[dof] == 0.0 && !is_driven {
                let k = &mut self.k[stage];
                (k.phi[dof], k.v[dof], k.a[dof]) = (0.0, 0.0, 0.0);
            }
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

    /// The stage's increments of what water remembers.
    fn remember(&mut self, system: &System, stage: usize, kappa: f64) {
        let Increment { phi, past, .. } = &mut self.k[stage];
        for (memory, tangent) in memories(&system.tree).zip(&self.matrix.memories) {
            memory.answer(kappa, &tangent.motion(Some(phi), &self.x), past);
        }
    }
}

/// Brakes and motors of a flow or joint by itself, beside those of light sheaves, whose flows follow from lengths.
fn resting(system: &System) -> Vec<(usize, usize, Option<usize>)> {
    let alone = system.exerting_brakes().filter(|(_, brake)| brake.spin.is_none());
    let drive = |row: usize| system.motors.iter().find(|(other, _)| *other == row).map(|&(_, drive)| drive);
    alone.map(|(row, brake)| (row, brake.dof, drive(row))).collect()
}
