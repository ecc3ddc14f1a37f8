//! The symmetric matrix of a step over velocities and impulses,
//!
//! ```text
//! [ M + hD + h²αK   Gᵀ           ]
//! [ G              −ε/(h (h+τ))  ]
//! ```
//!
//! with the driven degrees of freedom moved to the right side. The pattern is found once; a row that does
//! not act is an identity row, so the pattern stays while ropes go slack and contacts open.

use super::layout::{Layout, NONE};
use super::ldl::Ldl;
use super::slots::Slots;
use super::stiffness::Stiffness;
use super::symbolic::ZeroPivot;
use crate::system::System;
use crate::tree::mass::MassMatrix;

/// The matrix, its pattern and its factors.
#[derive(Debug, Clone)]
pub struct Kkt {
    layout: Layout,
    /// Geometric stiffness of the step.
    pub stiffness: Stiffness,
    ldl: Ldl,
    slots: Slots,
    base: Vec<f64>,
    right: Vec<f64>,
    solution: Vec<f64>,
}

impl Kkt {
    /// Pattern and elimination order for `system`.
    pub fn new(system: &System) -> Self {
        let layout = Layout::new(system);
        let stiffness = Stiffness::new(system);
        let ldl = Ldl::new(layout.symbolic.clone());
        let blocks = stiffness.start.windows(2).map(|window| &stiffness.dofs[window[0]..window[1]]);
        let slots = Slots::new(system, &layout, blocks);
        let size = ldl.pattern().size();
        Self {
            slots,
            base: vec![0.0; ldl.pattern().rows.len()],
            right: vec![0.0; size],
            solution: vec![0.0; size],
            layout,
            stiffness,
            ldl,
        }
    }

    /// Entries of L, a measure of cost.
    pub fn fill(&self) -> usize {
        self.ldl.pattern().l_rows.len()
    }

    /// Sets the matrix of a step of length `h` with all rows acting.
    pub fn assemble(&mut self, system: &System, mass: &MassMatrix, gradient: &[f64], h: f64) {
        self.base.fill(0.0);
        add(&mut self.base, &self.slots.mass, mass.values.iter().copied());
        add(&mut self.base, &self.slots.rows, gradient.iter().copied());
        let mut cursor = 0;
        for group in 0..self.stiffness.factor.len() {
            let scale = h * h * self.stiffness.implicit[group] * self.stiffness.factor[group];
            let columns =
                &self.stiffness.columns[self.stiffness.start[group]..self.stiffness.start[group + 1]];
            for (i, a) in columns.iter().enumerate() {
                for b in &columns[..=i] {
                    let slot = self.slots.blocks[cursor];
                    cursor += 1;
                    if slot != NONE {
                        self.base[slot] += scale * a.dot(*b);
                    }
                }
            }
        }
        for (index, &dof) in self.layout.free.iter().enumerate() {
            self.base[self.slots.diagonal[index]] += h * system.tree.damping[dof];
        }
        for (row, law) in system.rows.laws.iter().enumerate() {
            let diagonal = self.slots.diagonal[self.layout.row(row)];
            self.base[diagonal] = -law.compliance() / (h * (h + law.damping_time()));
        }
    }

    /// Factorises with the rows for which `acts` is false replaced by identity rows.
    ///
    /// # Errors
    /// [`ZeroPivot`] with the unknown: see [`Kkt::element`].
    pub fn factorise(&mut self, system: &System, acts: impl Fn(usize) -> bool) -> Result<(), ZeroPivot> {
        let values = self.ldl.values_mut();
        values.copy_from_slice(&self.base);
        for row in (0..system.rows.count()).filter(|&row| !acts(row)) {
            for &slot in &self.slots.rows[system.rows.start[row]..system.rows.start[row + 1]] {
                if slot != NONE {
                    values[slot] = 0.0;
                }
            }
            values[self.slots.diagonal[self.layout.row(row)]] = -1.0;
        }
        self.ldl.factorise()
    }

    /// Solves for velocities and impulses. `force` is the right side of every degree of freedom with the
    /// driven columns already moved there; `rows` that of every row. Driven entries of `v` stay.
    pub fn solve(&mut self, force: &[f64], rows: &[f64], v: &mut [f64], impulse: &mut [f64]) {
        for (index, &dof) in self.layout.free.iter().enumerate() {
            self.right[index] = force[dof];
        }
        self.right[self.layout.free.len()..].copy_from_slice(rows);
        self.ldl.solve(&self.right, &mut self.solution);
        for (index, &dof) in self.layout.free.iter().enumerate() {
            v[dof] = self.solution[index];
        }
        impulse.copy_from_slice(&self.solution[self.layout.free.len()..]);
    }

    /// Name of the body or constraint that an unknown belongs to.
    pub fn element<'a>(&self, system: &'a System, unknown: usize) -> &'a str {
        self.layout.element(system, unknown)
    }
}

fn add(base: &mut [f64], slots: &[usize], values: impl Iterator<Item = f64>) {
    for (&slot, value) in slots.iter().zip(values) {
        if slot != NONE {
            base[slot] += value;
        }
    }
}
