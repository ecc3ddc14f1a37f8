//! Where the numbers of a symmetric matrix go: the slots of mass matrix, rows and blocks in the pattern of a [`Layout`].

use super::layout::{Layout, NONE};
use crate::system::System;
use crate::tree::mass::MassMatrix;

/// Slots in the order of the numbers; [`NONE`] for what belongs to a driven degree of freedom.
#[derive(Debug, Clone)]
pub struct Slots {
    /// Of the values of the mass matrix.
    pub mass: Vec<usize>,
    /// Of the entries of the rows.
    pub rows: Vec<usize>,
    /// Of the diagonal, by unknown.
    pub diagonal: Vec<usize>,
    /// Of lower triangles of blocks, one after the other, row by row.
    pub blocks: Vec<usize>,
}

impl Slots {
    /// Slots for `system`; `blocks` are the degrees of freedom of every block.
    pub fn new<'a>(system: &System, layout: &Layout, blocks: impl Iterator<Item = &'a [usize]>) -> Self {
        let slot = |a: usize, b: usize| {
            if a == NONE || b == NONE {
                return NONE;
            }
            layout.symbolic.slot(a, b).map_or(NONE, |(slot, _)| slot)
        };
        let unknown = |dof: usize| layout.unknown[dof];
        let pattern = MassMatrix::new(&system.tree);
        let mut mass = Vec::with_capacity(pattern.values.len());
        for dof in 0..system.tree.velocities {
            let columns = &pattern.columns[pattern.row_start[dof]..pattern.row_start[dof + 1]];
            mass.extend(columns.iter().map(|&other| slot(unknown(dof), unknown(other))));
        }
        let mut rows = Vec::with_capacity(system.rows.dofs.len());
        for row in 0..system.rows.count() {
            let dofs = &system.rows.dofs[system.rows.start[row]..system.rows.start[row + 1]];
            rows.extend(dofs.iter().map(|&dof| slot(layout.row(row), unknown(dof))));
        }
        let mut lower = Vec::new();
        for dofs in blocks {
            for (j, &a) in dofs.iter().enumerate() {
                lower.extend(dofs[..=j].iter().map(|&b| slot(unknown(a), unknown(b))));
            }
        }
        let diagonal = (0..layout.symbolic.size()).map(|index| slot(index, index)).collect();
        Self { mass, rows, diagonal, blocks: lower }
    }
}
