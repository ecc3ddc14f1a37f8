//! The unsymmetric matrix of an implicit step with exact tangents,
//!
//! ```text
//! [ M + κD + κ ∂τ/∂v + κ² (∂τ/∂q + Σ T ∂G/∂q) P    Gᵀ              ]
//! [ ((G + τ Ġ) κP + τ G)/(κ + τ)                   −ε/(κ (κ + τ))  ]
//! ```
//!
//! κ = γh. The unknowns are the rate of the coordinates' increments and κ times those of the forces. P is 1 but
//! for rotation vectors, P = (1 + κ[ω]/2)⁻¹ there, since φ̇ = ω + φ×ω/2 + …; Ġ = ∂ė/∂q. A sliding contact's
//! rows say T = μ N d instead, d = T*/|T*|, with the anchor's own motion eliminated; an inextensible rope's G + κ γ_v + κ² γ_q P and 0, γ = G v̇ + Ġ v; a slack row is
//! an identity row.

pub mod memory;
pub(super) mod rows;

use glam::DVec3;

use super::evaluation::{Evaluation, pull_of};
use super::places::{Block, Places};
use super::spins::Spins;
use crate::constraint::Placed;
use crate::force::memory::memories;
use crate::solver::complementarity::Mode;
use crate::solver::layout::{Group, Layout};
use crate::solver::ldu::Ldu;
use crate::solver::symbolic::ZeroPivot;
use crate::state::State;
use crate::stepper::coils::CoilTangent;
use crate::system::System;
use crate::tree::mass::MassMatrix;
use crate::tree::tangent::DynamicsTangent;
use memory::MemoryTangent;
use rows::brake_of;

/// The matrix, with what is needed to make it anew for another step length.
#[derive(Debug, Clone)]
pub struct TangentMatrix {
    /// Unknowns.
    pub layout: Layout,
    /// P of the last κ.
    pub spins: Spins,
    /// What drums do.
    pub coils: CoilTangent,
    /// What water that remembers does.
    pub memories: Vec<MemoryTangent>,
    ldu: Ldu,
    places: Places,
    dynamics: DynamicsTangent,
    /// M, D + ∂τ/∂v and ∂τ/∂q + Σ T ∂G/∂q, each by place.
    inertia: Vec<f64>,
    damping: Vec<f64>,
    stiffness: Vec<f64>,
    /// The matrix by place.
    values: Vec<f64>,
    /// Ġ = ∂ė/∂q of every row entry.
    turning: Vec<f64>,
    /// γ_v and γ_q of inextensible ropes, by row entry.
    pull_velocity: Vec<f64>,
    pull_position: Vec<f64>,
    /// What κP applies to in a row.
    turned: Vec<f64>,
    /// One block, and the vectors that it is made from.
    curvature: Vec<f64>,
    columns: Vec<DVec3>,
    right: Vec<f64>,
    probe: Evaluation,
    direction: Vec<f64>,
}

impl TangentMatrix {
    /// Pattern for `system`.
    pub fn new(system: &System) -> Self {
        let layout = Layout::without_light(system);
        let ldu = Ldu::new(layout.symbolic.clone());
        let places = Places::new(system, &layout, &ldu);
        let largest = layout.groups.iter().map(|group| group.dofs.len()).max().unwrap_or(0);
        let by_place = vec![0.0; places.count];
        let by_entry = vec![0.0; system.rows.dofs.len()];
        Self {
            spins: Spins::new(system, &places.joints),
            coils: CoilTangent::default(),
            memories: MemoryTangent::all(system, &places),
            dynamics: DynamicsTangent::new(&system.tree, &MassMatrix::new(&system.tree)),
            inertia: by_place.clone(),
            damping: by_place.clone(),
            stiffness: by_place.clone(),
            values: by_place,
            turning: by_entry.clone(),
            pull_velocity: by_entry.clone(),
            pull_position: by_entry.clone(),
            turned: by_entry,
            curvature: vec![0.0; largest * largest],
            columns: vec![DVec3::ZERO; largest],
            right: vec![0.0; layout.symbolic.size()],
            probe: Evaluation::new(system),
            direction: vec![0.0; system.tree.velocities],
            layout,
            ldu,
            places,
        }
    }

    /// Evaluates all derivatives at the start of a step.
    pub fn linearise(&mut self, system: &System, here: &Evaluation, mass: &MassMatrix, state: &State) {
        let kinematics = &here.frame.kinematics;
        self.dynamics.update(&system.tree, kinematics, mass, &here.dynamics, &state.v);
        for values in [&mut self.inertia, &mut self.damping, &mut self.stiffness] {
            values.fill(0.0);
        }
        self.place_dynamics(system, mass);
        self.coils.linearise(system, &here.frame, state);
        self.turning.fill(0.0);
        for &row in &system.rigid {
            self.pull_velocity[system.rows.start[row]..system.rows.start[row + 1]].fill(0.0);
        }
        for block in 0..self.places.blocks.len() {
            let Group { row, dofs, .. } = &self.places.blocks[block].group;
            // A part between two points of the world has nothing that moves it.
            if state.modes[*row].carries() && !dofs.is_empty() {
                self.place_block(system, here, state, block);
            }
        }
        for &row in &system.rigid {
            if state.modes[row] == Mode::Acting && row < system.rope_rows() {
                self.linearise_pull(system, state, row);
            }
        }
        for (memory, tangent) in memories(&system.tree).zip(&mut self.memories) {
            let at = (kinematics, mass, &here.dynamics);
            tangent.linearise((system, memory), at, &state.v, &mut self.dynamics);
            tangent.note(&self.damping, &self.stiffness);
        }
    }

    fn place_dynamics(&mut self, system: &System, mass: &MassMatrix) {
        let Places { lower, upper, .. } = &self.places;
        let (velocity, position) = (&self.dynamics.velocity, &self.dynamics.position);
        for dof in 0..system.tree.velocities {
            let diagonal = mass.row_start[dof + 1] - 1;
            for slot in mass.row_start[dof]..diagonal {
                let (below, above) = (lower[slot] as usize, upper[slot] as usize);
                self.inertia[below] = mass.values[slot];
                self.inertia[above] = mass.values[slot];
                self.damping[below] = velocity.lower[slot];
                self.damping[above] = velocity.upper[slot];
                self.stiffness[below] = position.lower[slot];
                self.stiffness[above] = position.upper[slot];
            }
            let place = lower[diagonal] as usize;
            self.inertia[place] = mass.values[diagonal];
            self.damping[place] = velocity.lower[diagonal] + system.tree.damping[dof];
            self.stiffness[place] = position.lower[diagonal];
        }
    }

    /// Geometric stiffness of one group, and what it does to its row's gradient.
    fn place_block(&mut self, system: &System, here: &Evaluation, state: &State, block: usize) {
        let Block { group: Group { constraint, number, row, dofs }, places, entries } =
            &self.places.blocks[block];
        let (size, tension, law) = (dofs.len(), here.tension[*row], &system.rows.laws[*row]);
        let curvature = &mut self.curvature[..size * size];
        let kinematics = &here.frame.kinematics;
        let feeding = &here.frame.feeding;
        let State { q, seats, spots, .. } = state;
        let at = Placed { tree: &system.tree, kinematics, q, seats, spots, feeding };
        let value = here.frame.value[*row];
        system.constraints[*constraint].curvature(&at, value, *number, &mut self.columns, curvature);
        for (place, value) in places.iter().zip(&*curvature) {
            self.stiffness[*place as usize] += tension * value;
        }
        if law.damping_time() > 0.0 {
            for (dof, values) in dofs.iter().zip(curvature.chunks_exact(size)) {
                for (entry, value) in entries.iter().zip(values) {
                    self.turning[*entry as usize] += state.v[*dof] * value;
                }
            }
        }
        if law.compliance() == 0.0 {
            for (j, dof) in dofs.iter().enumerate() {
                for (k, entry) in entries.iter().enumerate() {
                    let both = curvature[j * size + k] + curvature[k * size + j];
                    self.pull_velocity[*entry as usize] += state.v[*dof] * both;
                }
            }
        }
    }

    /// γ_v and γ_q of an inextensible rope. ∂γ/∂q is by central differences; v and v̇ stay. The third derivative of
    /// the length that it holds is the only one that has no formula here.
    fn linearise_pull(&mut self, system: &System, state: &State, row: usize) {
        const STEP: f64 = 1e-6;
        for entry in system.rows.start[row]..system.rows.start[row + 1] {
            let dof = system.rows.dofs[entry];
            let mut at = |step: f64| {
                self.direction[dof] = step;
                self.probe.q.copy_from_slice(&state.q);
                system.tree.advance(&mut self.probe.q, &self.direction);
                self.direction[dof] = 0.0;
                let Evaluation { q, frame, dynamics, imbalance, .. } = &mut self.probe;
                frame.kinematics.update(&system.tree, q, state.time);
                let a = Some(state.acceleration.as_slice());
                dynamics.update(&system.tree, &frame.kinematics, &state.v, a, None, imbalance);
                pull_of(system, frame, dynamics, row)
            };
            self.pull_position[entry] = (at(STEP) - at(-STEP)) / (2.0 * STEP);
        }
    }

    /// γ_v r of an inextensible rope, by its number in [`System::rigid`].
    pub fn pull_rate(&self, system: &System, index: usize, r: &[f64]) -> f64 {
        system.rows.rate(&self.pull_velocity, system.rigid[index], r)
    }

    /// What the increments φ of coordinates and v of velocities add to e + τ ė of a row.
    pub fn stretch(&self, system: &System, here: &Evaluation, row: usize, phi: &[f64], v: &[f64]) -> f64 {
        let (gradient, tau) = (&here.frame.gradient, system.rows.laws[row].damping_time());
        let turning = system.rows.rate(&self.turning, row, phi);
        system.rows.rate(gradient, row, phi) + tau * (turning + system.rows.rate(gradient, row, v))
    }

    /// Solution of a row after [`TangentMatrix::solve`]: κ times the increment of its force.
    pub fn row_solution(&self, row: usize) -> f64 {
        self.right[self.layout.row(row)]
    }

    /// Makes and factorises the matrix for κ = `kappa` [s].
    ///
    /// # Errors
    /// [`ZeroPivot`] where it is singular.
    pub fn factorise(
        &mut self,
        system: &System,
        here: &Evaluation,
        state: &State,
        kappa: f64,
    ) -> Result<(), ZeroPivot> {
        self.spins.update(&state.v, kappa);
        for tangent in &self.memories {
            tangent.clear(&mut self.damping, &mut self.stiffness);
        }
        for (memory, tangent) in memories(&system.tree).zip(&self.memories) {
            tangent.add(memory, kappa, &mut self.damping, &mut self.stiffness);
        }
        let square = kappa * kappa;
        let terms = self.inertia.iter().zip(&self.damping).zip(&self.stiffness);
        for (value, ((inertia, damping), stiffness)) in self.values.iter_mut().zip(terms) {
            *value = inertia + kappa * damping + square * stiffness;
        }
        for triple in &self.places.triples {
            let places = triple.places.map(|place| place as usize);
            let plain = places.map(|place| self.stiffness[place]);
            let turned = self.spins.turn(triple.joint, plain);
            for k in 0..3 {
                self.values[places[k]] += square * (turned[k] - plain[k]);
            }
        }
        self.place_rows(system, here, state, kappa);
        self.ldu.factorise(&self.values)
    }

    /// Makes and factorises [M Gᵀ; G 0] with the inextensible ropes that act: for accelerations, projections and
    /// impacts.
    ///
    /// # Errors
    /// [`ZeroPivot`] where a body has no inertia in a direction that it can move, or a rope repeats another.
    pub fn factorise_inertia(
        &mut self,
        system: &System,
        mass: &MassMatrix,
        gradient: &[f64],
        modes: &[Mode],
    ) -> Result<(), ZeroPivot> {
        self.values.fill(0.0);
        let Places { lower, upper, in_row, in_column, diagonal, .. } = &self.places;
        for ((below, above), value) in lower.iter().zip(upper).zip(&mass.values) {
            self.values[*below as usize] = *value;
            self.values[*above as usize] = *value;
        }
        for places in &self.places.light {
            self.values[places.diagonal as usize] = 1.0;
        }
        for row in 0..system.rows.count() {
            let is_light = brake_of(system, row).is_some_and(|brake| system.is_light[brake.dof]);
            let acts = system.rows.laws[row].compliance() == 0.0 && modes[row] == Mode::Acting && !is_light;
            self.values[diagonal[row] as usize] = if acts { 0.0 } else { -1.0 };
            if acts {
                for entry in system.rows.start[row]..system.rows.start[row + 1] {
                    self.values[in_row[entry] as usize] = gradient[entry];
                    self.values[in_column[entry] as usize] = gradient[entry];
                }
            }
        }
        self.ldu.factorise(&self.values)
    }

    /// Solves for the rates `x` of all degrees of freedom. `force` is the right side of every degree of freedom,
    /// `rows` that of every row; driven entries of `x` are given.
    pub fn solve(&mut self, force: &[f64], rows: &[f64], x: &mut [f64]) {
        let free = self.layout.free.len();
        for (right, &dof) in self.right.iter_mut().zip(&self.layout.free) {
            *right = force[dof];
        }
        self.right[free..].copy_from_slice(rows);
        let driven = &self.values[self.places.first_driven..];
        for (&(unknown, dof), value) in self.places.driven.iter().zip(driven) {
            self.right[unknown] -= value * x[dof];
        }
        self.ldu.solve(&mut self.right);
        for (right, &dof) in self.right.iter().zip(&self.layout.free) {
            x[dof] = *right;
        }
    }

    /// `out` += scale · (D + ∂τ/∂v) x.
    pub fn add_damping(&self, system: &System, mass: &MassMatrix, x: &[f64], scale: f64, out: &mut [f64]) {
        let velocity = &self.dynamics.velocity;
        for dof in 0..x.len() {
            let diagonal = mass.row_start[dof + 1] - 1;
            for slot in mass.row_start[dof]..diagonal {
                let other = mass.columns[slot];
                out[dof] += scale * velocity.lower[slot] * x[other];
                out[other] += scale * velocity.upper[slot] * x[dof];
            }
            out[dof] += scale * (velocity.lower[diagonal] + system.tree.damping[dof]) * x[dof];
        }
    }
}
