//! What water that remembers the motion of a body ([`crate::force::memory`]) adds to the matrix: Jᵀ K̂ (∂ν/∂v + κ ∂ν/∂q P),
//! K̂ = κ Re Σ R (1 − κp)⁻¹. It changes with κ otherwise than by a factor, so its numbers are put in with each κ.

use super::super::places::Places;
use crate::force::memory::{Memory, form, memories};
use crate::system::System;
use crate::tree::bias::NewtonEuler;
use crate::tree::kinematics::Kinematics;
use crate::tree::mass::MassMatrix;
use crate::tree::tangent::DynamicsTangent;

/// Of one body.
#[derive(Debug, Clone)]
pub struct MemoryTangent {
    /// Degrees of freedom that move the body.
    dofs: Vec<usize>,
    /// ∂ν/∂q and ∂ν/∂v of each; ∂ν/∂v is J too.
    position: Vec<[f64; 6]>,
    velocity: Vec<[f64; 6]>,
    /// ∂ν/∂t.
    pub over_time: [f64; 6],
    /// Place of (j, k) at j · size + k.
    places: Vec<u32>,
    /// What else is there of damping and stiffness.
    beside: Vec<[f64; 2]>,
}

impl MemoryTangent {
    /// Those of `system`.
    pub fn all(system: &System, places: &Places) -> Vec<Self> {
        let mass = MassMatrix::new(&system.tree);
        let of = |memory: &Memory| {
            let dofs = system.tree.support[memory.body].clone();
            let place = |row: usize, dof: usize| {
                if row >= dof { places.lower[mass.slot(row, dof)] } else { places.upper[mass.slot(dof, row)] }
            };
            let places: Vec<u32> = dofs
                .iter()
                .flat_map(|&row| dofs.iter().map(move |&dof| (row, dof)))
                .map(|(row, dof)| place(row, dof))
                .collect();
            Self {
                position: vec![[0.0; 6]; dofs.len()],
                velocity: vec![[0.0; 6]; dofs.len()],
                over_time: [0.0; 6],
                beside: vec![[0.0; 2]; places.len()],
                places,
                dofs,
            }
        };
        memories(&system.tree).map(of).collect()
    }

    /// Evaluates ∂ν/∂q, ∂ν/∂v and ∂ν/∂t.
    pub fn linearise(
        &mut self,
        (system, memory): (&System, &Memory),
        (kinematics, mass, dynamics): (&Kinematics, &MassMatrix, &NewtonEuler),
        v: &[f64],
        tangent: &mut DynamicsTangent,
    ) {
        let here = dynamics.at(&system.tree, kinematics, memory.body);
        self.over_time = memory.motion_over_time(&here);
        for (index, &dof) in self.dofs.iter().enumerate() {
            let changes =
                tangent.of_motion(&system.tree, (kinematics, mass, dynamics), v, (dof, memory.body));
            let over = kinematics.columns[dof].angular;
            let [position, velocity] = memory.changes_of_motion(&here, changes, over);
            (self.position[index], self.velocity[index]) = (position, velocity);
        }
    }

    /// Notes what else there is in its places.
    pub fn note(&mut self, damping: &[f64], stiffness: &[f64]) {
        for (beside, &place) in self.beside.iter_mut().zip(&self.places) {
            *beside = [damping[place as usize], stiffness[place as usize]];
        }
    }

    /// Leaves in its places nothing but that.
    pub fn clear(&self, damping: &mut [f64], stiffness: &mut [f64]) {
        for (beside, &place) in self.beside.iter().zip(&self.places) {
            [damping[place as usize], stiffness[place as usize]] = *beside;
        }
    }

    /// Adds what it is for κ = `kappa` [s].
    pub fn add(&self, memory: &Memory, kappa: f64, damping: &mut [f64], stiffness: &mut [f64]) {
        let rows = memory.damping(kappa).rows();
        for (row, places) in self.velocity.iter().zip(self.places.chunks_exact(self.dofs.len())) {
            for ((&place, velocity), position) in places.iter().zip(&self.velocity).zip(&self.position) {
                damping[place as usize] += form(&rows, row, velocity);
                stiffness[place as usize] += form(&rows, row, position);
            }
        }
    }

    /// ∂ν/∂q φ + ∂ν/∂v v.
    pub fn motion(&self, phi: Option<&[f64]>, v: &[f64]) -> [f64; 6] {
        let mut sum = [0.0; 6];
        for (index, &dof) in self.dofs.iter().enumerate() {
            let turn = phi.map_or(0.0, |phi| phi[dof]);
            for (k, sum) in sum.iter_mut().enumerate() {
                *sum += self.velocity[index][k] * v[dof] + self.position[index][k] * turn;
            }
        }
        sum
    }

    /// `out` += scale · Jᵀ Re Σ R z for the states `past` of all forces.
    pub fn push(&self, memory: &Memory, past: &[f64], scale: f64, out: &mut [f64]) {
        for (&dof, motion) in self.dofs.iter().zip(&self.velocity) {
            out[dof] += scale * memory.along(past, motion);
        }
    }
}
