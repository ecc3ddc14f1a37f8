//! The symmetric matrix of statics over increments of coordinates and forces of rows,
//!
//! ```text
//! [ λM + K   Gᵀ ]        K = ∂²(V_gravity + U)/∂q² + Σ T ∂G/∂q
//! [ G        −ε ]
//! ```
//!
//! and what wind and current, which have no energy, make of it: [`super::stream`].
//!
//! K is the exact geometric stiffness and not projected. Increments turn by rotation vectors in body axes; the second
//! derivative along them is the symmetric part of ∂(∂V/∂q)/∂q, whose other half is a product of the slope and
//! vanishes in equilibrium. A row that does not follow is an identity row. Forces stay unknowns and the elimination
//! order is the rig's, so the cost is that of the rig's length.

use glam::DVec3;

use super::bearing::Bearing;
use super::potential::Potential;
use super::stream::Stream;
use crate::constraint::Placed;
use crate::force::memory::{form, memories};
use crate::solver::layout::{Layout, NONE};
use crate::solver::ldl::Ldl;
use crate::solver::slots::Slots;
use crate::solver::symbolic::ZeroPivot;
use crate::stepper::frame::Remembered;
use crate::system::System;
use crate::tree::mass::MassMatrix;
use crate::tree::tangent::DynamicsTangent;

/// The matrix, its pattern and its factors.
#[derive(Debug, Clone)]
pub struct Matrix {
    /// Unknowns.
    pub layout: Layout,
    ldl: Ldl,
    dynamics: DynamicsTangent,
    slots: Slots,
    /// M by slot.
    mass: Vec<f64>,
    /// The same with the added mass of infinite frequency.
    fast: Vec<f64>,
    /// K by slot.
    stiffness: Vec<f64>,
    gradient: Vec<f64>,
    /// The other half, where wind or current push.
    stream: Option<Stream>,
    curvature: Vec<f64>,
    columns: Vec<DVec3>,
    right: Vec<f64>,
    solution: Vec<f64>,
    still: Vec<f64>,
    /// What is added to the diagonal of every degree of freedom, see [`super::search`].
    pub extra: Vec<f64>,
    /// Factorisations made.
    pub factorisations: u64,
}

impl Matrix {
    /// Pattern and elimination order for `system`.
    pub fn new(system: &System) -> Self {
        let layout = Layout::new(system);
        let ldl = Ldl::new(layout.symbolic.clone());
        let slots = Slots::new(system, &layout, layout.groups.iter().map(|group| group.dofs.as_slice()));
        let size = layout.symbolic.size();
        let largest = layout.groups.iter().map(|group| group.dofs.len()).max().unwrap_or(0);
        let by_slot = vec![0.0; layout.symbolic.rows.len()];
        Self {
            dynamics: DynamicsTangent::new(&system.tree, &MassMatrix::new(&system.tree)),
            mass: by_slot.clone(),
            fast: by_slot.clone(),
            stiffness: by_slot,
            gradient: vec![0.0; system.rows.dofs.len()],
            stream: Stream::new(system, &layout, &slots),
            curvature: vec![0.0; largest * largest],
            columns: vec![DVec3::ZERO; largest],
            right: vec![0.0; size],
            solution: vec![0.0; size],
            still: vec![0.0; system.tree.velocities],
            extra: vec![0.0; system.tree.velocities],
            factorisations: 0,
            slots,
            ldl,
            layout,
        }
    }

    /// Evaluates M, K and G where `here` has been updated, its mass matrix too.
    pub fn linearise(&mut self, system: &System, here: &Potential, by: &Remembered) {
        let mass = &here.frame.mass;
        self.dynamics.update(&system.tree, &here.frame.kinematics, mass, &here.dynamics, &self.still);
        self.mass.fill(0.0);
        self.stiffness.fill(0.0);
        self.gradient.copy_from_slice(&here.frame.gradient);
        let turned = &self.dynamics.position;
        if let Some(stream) = &mut self.stream {
            stream.take_dynamics(turned);
        }
        for bounds in mass.row_start.windows(2) {
            let (row, diagonal) = (bounds[0]..bounds[1], bounds[1] - 1 - bounds[0]);
            let (lower, upper) = (&turned.lower[row.clone()], &turned.upper[row.clone()]);
            let numbers =
                self.slots.mass[row.clone()].iter().zip(&mass.values[row]).zip(lower.iter().zip(upper));
            for (place, ((&to, mass), (lower, upper))) in numbers.enumerate() {
                // Driven degrees of freedom have no place.
                if let (Some(known), Some(stiffness)) = (self.mass.get_mut(to), self.stiffness.get_mut(to)) {
                    *known += mass;
                    *stiffness += 0.5 * (lower + if place == diagonal { lower } else { upper });
                }
            }
        }
        self.fast.copy_from_slice(&self.mass);
        self.add_curvature(system, here, by);
        self.climb(system, here);
    }

    /// Adds what turns gradients as bodies move, times the force.
    fn add_curvature(&mut self, system: &System, here: &Potential, by: &Remembered) {
        let mut cursor = 0;
        let (kinematics, feeding) = (&here.frame.kinematics, here.frame.feeding.as_slice());
        let Remembered { seats, spots, .. } = *by;
        let at = Placed { tree: &system.tree, kinematics, q: &here.q, seats, spots, feeding };
        for group in &self.layout.groups {
            let size = group.dofs.len();
            let first = cursor;
            let slots = &self.slots.blocks[first..first + size * (size + 1) / 2];
            cursor += slots.len();
            let tension = here.tension[group.row];
            if tension == 0.0 || size == 0 {
                continue;
            }
            let block = &mut self.curvature[..size * size];
            let value = here.frame.value[group.row];
            system.constraints[group.constraint].curvature(
                &at,
                value,
                group.number,
                &mut self.columns,
                block,
            );
            if let Some(stream) = &mut self.stream {
                stream.take_block(first, block, tension);
            }
            let mut rest = slots;
            for (j, row) in block.chunks_exact(size).enumerate() {
                let (slots, below) = rest.split_at(j + 1);
                rest = below;
                for ((&slot, one), other) in slots.iter().zip(row).zip(block[j..].iter().step_by(size)) {
                    if let Some(stiffness) = self.stiffness.get_mut(slot) {
                        *stiffness += 0.5 * tension * (one + other);
                    }
                }
            }
        }
    }

    /// Adds what the radius of a drum does where its rope climbs onto the next layer: the same tension turns it with more
    /// the more it has wound.
    fn climb(&mut self, system: &System, here: &Potential) {
        for (place, passing) in system.coils.iter().zip(&here.frame.passing) {
            let slope = passing.supply * place.rate_slope(&here.q) / (1.0 + passing.strain);
            let diagonal = self.slots.diagonal.get(self.layout.unknown[place.dof]);
            if let Some(stiffness) = diagonal.and_then(|&slot| self.stiffness.get_mut(slot)) {
                *stiffness += here.tension[place.row] * slope;
            }
        }
    }

    /// Puts the added mass at the frequency `omega` [rad/s] into M, where water remembers ([`crate::force::memory`]); none is
    /// infinite frequency.
    pub fn take_water(&mut self, system: &System, here: &Potential, omega: Option<f64>) {
        self.mass.copy_from_slice(&self.fast);
        let Some(omega) = omega else { return };
        let tree = &system.tree;
        for memory in memories(tree) {
            let change = memory.at_frequency(omega)[1].rows();
            let columns = memory.columns(tree, &here.frame.kinematics);
            let support = &tree.support[memory.body];
            for (index, &row) in support.iter().enumerate() {
                for (other, &dof) in support[..=index].iter().enumerate() {
                    let slot = self.slots.mass[here.frame.mass.slot(row, dof)];
                    if let Some(mass) = self.mass.get_mut(slot) {
                        *mass += form(&change, &columns[index], &columns[other]);
                    }
                }
            }
        }
    }

    /// Factorises with `shift` for λ; a row whose compliance is none does not act.
    ///
    /// # Errors
    /// [`ZeroPivot`] where the matrix is singular.
    pub fn factorise(
        &mut self,
        system: &System,
        shift: f64,
        compliance: impl Fn(usize) -> Option<f64>,
    ) -> Result<(), ZeroPivot> {
        self.fill(system, shift, compliance);
        self.ldl.factorise()
    }

    /// The same with both halves of what wind and current push with, for [`Matrix::solve_whole`].
    ///
    /// # Errors
    /// [`ZeroPivot`] where the matrix is singular.
    pub fn factorise_whole(
        &mut self,
        system: &System,
        shift: f64,
        compliance: impl Fn(usize) -> Option<f64>,
    ) -> Result<(), ZeroPivot> {
        self.fill(system, shift, compliance);
        match &mut self.stream {
            Some(stream) => stream.factorise(self.ldl.values_mut()),
            None => self.ldl.factorise(),
        }
    }

    fn fill(&mut self, system: &System, shift: f64, compliance: impl Fn(usize) -> Option<f64>) {
        self.factorisations += 1;
        let values = self.ldl.values_mut();
        for ((value, mass), stiffness) in values.iter_mut().zip(&self.mass).zip(&self.stiffness) {
            *value = shift * mass + stiffness;
        }
        for (index, &dof) in self.layout.free.iter().enumerate() {
            values[self.slots.diagonal[index]] += self.extra[dof];
        }
        for row in 0..system.rows.count() {
            let answer = compliance(row);
            let diagonal = self.slots.diagonal[self.layout.row(row)];
            values[diagonal] = answer.map_or(-1.0, |compliance| -compliance);
            let entries = system.rows.start[row]..system.rows.start[row + 1];
            for (&slot, entry) in self.slots.rows[entries.clone()].iter().zip(&self.gradient[entries]) {
                if let Some(value) = values.get_mut(slot) {
                    *value = if answer.is_some() { *entry } else { 0.0 };
                }
            }
        }
    }

    /// How many eigenvalues ω² of K, with the rows that act, lie below −λ of the last factorisation (Sylvester).
    pub fn below(&self, system: &System) -> usize {
        self.ldl.negative_pivots().saturating_sub(system.rows.count())
    }

    /// Solves for increments and forces: `force` is the right side of every degree of freedom, `rows` that of every
    /// row. Increments of driven degrees of freedom are zero.
    pub fn solve(&mut self, force: &[f64], rows: &[f64], step: &mut [f64], tension: &mut [f64]) {
        self.solve_by(|this| this.ldl.solve(&this.right, &mut this.solution), (force, rows), (step, tension));
    }

    /// The same with the factors of [`Matrix::factorise_whole`].
    pub fn solve_whole(&mut self, force: &[f64], rows: &[f64], step: &mut [f64], tension: &mut [f64]) {
        let by = |this: &mut Self| match &mut this.stream {
            Some(stream) => {
                this.solution.copy_from_slice(&this.right);
                stream.solve(&mut this.solution);
            }
            None => this.ldl.solve(&this.right, &mut this.solution),
        };
        self.solve_by(by, (force, rows), (step, tension));
    }

    /// The same without refinement.
    pub fn solve_roughly(&mut self, force: &[f64], rows: &[f64], step: &mut [f64], tension: &mut [f64]) {
        let by = |this: &mut Self| this.ldl.solve_roughly(&this.right, &mut this.solution);
        self.solve_by(by, (force, rows), (step, tension));
    }

    fn solve_by(
        &mut self,
        by: impl Fn(&mut Self),
        (force, rows): (&[f64], &[f64]),
        (step, tension): (&mut [f64], &mut [f64]),
    ) {
        let free = self.layout.free.len();
        for (index, &dof) in self.layout.free.iter().enumerate() {
            self.right[index] = force[dof];
        }
        self.right[free..].copy_from_slice(rows);
        by(self);
        step.fill(0.0);
        for (index, &dof) in self.layout.free.iter().enumerate() {
            step[dof] = self.solution[index];
        }
        tension.copy_from_slice(&self.solution[free..]);
    }

    /// ∂²V/∂q² of all free degrees of freedom as a dense matrix, with the rows that act condensed, and M likewise.
    pub fn dense(&self, system: &System, bearings: &[Bearing], follows: &[bool]) -> (Vec<f64>, Vec<f64>) {
        let size = self.layout.free.len();
        let (mut mass, mut stiffness) = (vec![0.0; size * size], vec![0.0; size * size]);
        let symbolic = &self.layout.symbolic;
        for column in 0..symbolic.size() {
            for slot in symbolic.start[column]..symbolic.start[column + 1] {
                let (a, b) = (symbolic.order[symbolic.rows[slot]], symbolic.order[column]);
                if a < size && b < size {
                    for place in [a * size + b, b * size + a] {
                        mass[place] = self.mass[slot];
                        stiffness[place] = self.stiffness[slot];
                    }
                }
            }
        }
        for (row, bearing) in
            bearings.iter().enumerate().filter(|(row, bearing)| follows[*row] && !bearing.is_rigid)
        {
            let entries: Vec<(usize, f64)> = self.row_entries(system, row).collect();
            for &(a, left) in &entries {
                for &(b, right) in &entries {
                    stiffness[a * size + b] += left * right / bearing.compliance;
                }
            }
        }
        (mass, stiffness)
    }

    /// xᵀ K x without what rows add, x over all degrees of freedom.
    pub fn stiffness_along(&self, x: &[f64]) -> f64 {
        let (symbolic, free) = (&self.layout.symbolic, &self.layout.free);
        let mut sum = 0.0;
        for column in 0..symbolic.size() {
            for slot in symbolic.start[column]..symbolic.start[column + 1] {
                let (a, b) = (symbolic.order[symbolic.rows[slot]], symbolic.order[column]);
                if a < free.len() && b < free.len() {
                    let share = self.stiffness[slot] * x[free[a]] * x[free[b]];
                    sum += if a == b { share } else { 2.0 * share };
                }
            }
        }
        sum
    }

    /// Adds to a dense K what wind and current have beyond its symmetric half.
    pub fn add_stream(&self, stiffness: &mut [f64]) {
        if let Some(stream) = &self.stream {
            stream.add_to(&self.layout, self.layout.free.len(), stiffness);
        }
    }

    /// xᵀ D x of the linear resistance of water, over all degrees of freedom.
    pub fn resistance(&self, system: &System, x: &[f64]) -> f64 {
        let mut sum = 0.0;
        self.resistances(system, |[one, other], entry| sum += entry * x[one] * x[other]);
        sum
    }

    /// Entries of that D, by row and column.
    pub fn resistances(&self, system: &System, visit: impl FnMut([usize; 2], f64)) {
        // At rest velocities enter nothing but resistance.
        if !system.tree.forces.is_empty() {
            self.dynamics.over_velocity(&system.tree, visit);
        }
    }

    /// Unknowns and gradient entries of a row, without driven degrees of freedom.
    pub fn row_entries<'a>(
        &'a self,
        system: &'a System,
        row: usize,
    ) -> impl Iterator<Item = (usize, f64)> + 'a {
        let entries = system.rows.entries(&self.gradient, row);
        entries.map(|(dof, entry)| (self.layout.unknown[dof], entry)).filter(|(unknown, _)| *unknown != NONE)
    }
}
