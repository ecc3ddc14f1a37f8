//! The other half of the tangent where wind, current or mean drift forces push. What streams push with is no slope of an energy: how a vane is
//! turned changes what it is pulled along with, and how it has been pulled along changes nothing of how it is turned.
//!
//! The search goes by the symmetric half, whose pivots tell what leads down. Here is the half of ∂/∂q of all that pushes and
//! pulls that changes its sign when mirrored, for derivatives about the equilibrium that was found. What turns of
//! rotation vectors put into it vanishes there, since nothing is left to turn.

use crate::solver::layout::{Layout, NONE};
use crate::solver::ldu::Ldu;
use crate::solver::slots::Slots;
use crate::solver::symbolic::ZeroPivot;
use crate::system::System;
use crate::tree::mass::MassMatrix;
use crate::tree::tangent::Paired;

/// Half of what an entry is more than its mirror image, and the factors of the whole.
#[derive(Debug, Clone)]
pub struct Stream {
    /// Of the entry in the upper triangle of the elimination order, by slot.
    half: Vec<f64>,
    /// Slots of entries of the mass matrix, and of the lower triangles of blocks: 1 where they lie in that triangle, −1 where
    /// their mirror images do, 0 on the diagonal and for driven degrees of freedom.
    dynamics: Vec<(usize, f64)>,
    blocks: Vec<(usize, f64)>,
    ldu: Ldu,
    values: Vec<f64>,
}

impl Stream {
    /// Room for `system`; none where nothing streams.
    pub fn new(system: &System, layout: &Layout, slots: &Slots) -> Option<Self> {
        if !crate::force::has_stream(&system.tree) {
            return None;
        }
        let place = |dof: usize| layout.unknown[dof];
        let sign = |dof: usize, other: usize| match [place(dof), place(other)] {
            [NONE, _] | [_, NONE] => 0.0,
            [a, b] if a == b => 0.0,
            [a, b] if layout.symbolic.place[a] <= layout.symbolic.place[b] => 1.0,
            _ => -1.0,
        };
        let pattern = MassMatrix::new(&system.tree);
        let rows = pattern.row_start.windows(2).enumerate();
        let of_dynamics = rows.flat_map(|(dof, bounds)| {
            pattern.columns[bounds[0]..bounds[1]].iter().map(move |&other| (dof, other))
        });
        let of_blocks = layout.groups.iter().flat_map(|group| {
            let pair = move |j: usize| group.dofs[..=j].iter().map(move |&other| (group.dofs[j], other));
            (0..group.dofs.len()).flat_map(pair)
        });
        let ldu = Ldu::new(layout.symbolic.clone());
        let signed = |(slot, (dof, other)): (&usize, (usize, usize))| (*slot, sign(dof, other));
        Some(Self {
            half: vec![0.0; layout.symbolic.rows.len()],
            dynamics: slots.mass.iter().zip(of_dynamics).map(signed).collect(),
            blocks: slots.blocks.iter().zip(of_blocks).map(signed).collect(),
            values: vec![0.0; ldu.entries()],
            ldu,
        })
    }

    /// Begins anew with what inverse dynamics has over positions.
    pub fn take_dynamics(&mut self, position: &Paired) {
        self.half.fill(0.0);
        let entries = position.lower.iter().zip(&position.upper).zip(&self.dynamics);
        for ((lower, upper), &(slot, sign)) in entries.filter(|(_, (_, sign))| *sign != 0.0) {
            self.half[slot] += 0.5 * sign * (lower - upper);
        }
    }

    /// Adds a tension times the block of a gradient's derivatives, whose lower triangle begins at the place `from` of all.
    pub fn take_block(&mut self, from: usize, block: &[f64], tension: f64) {
        let size = block.len().isqrt();
        let mut places = self.blocks[from..].iter();
        for j in 0..size {
            for (k, &(slot, sign)) in (0..=j).zip(&mut places) {
                if sign != 0.0 {
                    self.half[slot] += 0.5 * sign * tension * (block[j * size + k] - block[k * size + j]);
                }
            }
        }
    }

    /// Factorises the whole matrix, whose symmetric half is given by slot.
    ///
    /// # Errors
    /// [`ZeroPivot`] where it is singular.
    pub fn factorise(&mut self, symmetric: &[f64]) -> Result<(), ZeroPivot> {
        let (upper, lower) = self.values.split_at_mut(symmetric.len());
        for (place, (mean, half)) in symmetric.iter().zip(&self.half).enumerate() {
            (upper[place], lower[place]) = (mean + half, mean - half);
        }
        self.ldu.factorise(&self.values)
    }

    /// Solves with the factors; `right` becomes the solution, by unknown.
    pub fn solve(&mut self, right: &mut [f64]) {
        self.ldu.solve(right);
    }

    /// Adds this half to a dense matrix over the free degrees of freedom, of which there are `size`.
    pub fn add_to(&self, layout: &Layout, size: usize, dense: &mut [f64]) {
        let symbolic = &layout.symbolic;
        for column in 0..symbolic.size() {
            for slot in symbolic.start[column]..symbolic.start[column + 1] {
                let (a, b) = (symbolic.order[symbolic.rows[slot]], symbolic.order[column]);
                if a < size && b < size {
                    dense[a * size + b] += self.half[slot];
                    dense[b * size + a] -= self.half[slot];
                }
            }
        }
    }
}
