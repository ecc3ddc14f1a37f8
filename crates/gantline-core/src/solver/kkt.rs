//! The symmetric matrix of a step over velocities and impulses,
//!
//! ```text
//! [ M + hD + h²αK   Gᵀ           ]
//! [ G              −ε/(h (h+τ))  ]
//! ```
//!
//! with the driven degrees of freedom moved to the right side. The pattern is found once; a row that does
//! not act is an identity row, so the pattern stays while ropes go slack and contacts open.

use super::ldl::{Ldl, ZeroPivot};
use super::order::{Node, NodeKind, elimination_order};
use super::stiffness::Stiffness;
use crate::system::System;
use crate::tree::mass::MassMatrix;

/// Entries that touch a driven degree of freedom have no place in the matrix.
const NONE: usize = usize::MAX;

/// The matrix, its pattern and its factors.
#[derive(Debug, Clone)]
pub struct Kkt {
    /// Degrees of freedom that are unknown.
    free: Vec<usize>,
    /// Geometric stiffness of the step.
    pub stiffness: Stiffness,
    ldl: Ldl,
    mass_slots: Vec<usize>,
    row_slots: Vec<usize>,
    diagonal_slots: Vec<usize>,
    /// Slots of the lower triangle of every stiffness group, group after group.
    stiffness_slots: Vec<usize>,
    base: Vec<f64>,
    right: Vec<f64>,
    solution: Vec<f64>,
}

impl Kkt {
    /// Pattern and elimination order for `system`.
    pub fn new(system: &System) -> Self {
        let free: Vec<usize> =
            (0..system.tree.velocities).filter(|&dof| system.driven[dof].is_none()).collect();
        let mut unknown = vec![NONE; system.tree.velocities];
        for (index, &dof) in free.iter().enumerate() {
            unknown[dof] = index;
        }
        let mass = MassMatrix::new(&system.tree);
        let stiffness = Stiffness::new(system);
        let pairs = Pairs::new(system, &mass, &stiffness, &unknown, free.len());
        let order = unknown_order(system, &unknown, free.len(), &pairs);
        let ldl = Ldl::new(order, pairs.all());
        let slot = |&(a, b): &(usize, usize)| {
            if a == NONE || b == NONE { NONE } else { ldl.slot(a, b).unwrap_or(NONE) }
        };
        let size = ldl.size();
        Self {
            mass_slots: pairs.mass.iter().map(slot).collect(),
            row_slots: pairs.rows.iter().map(slot).collect(),
            stiffness_slots: pairs.stiffness.iter().map(slot).collect(),
            diagonal_slots: (0..size).map(|index| slot(&(index, index))).collect(),
            base: vec![0.0; ldl.clone().values_mut().len()],
            right: vec![0.0; size],
            solution: vec![0.0; size],
            free,
            stiffness,
            ldl,
        }
    }

    /// Entries of L, a measure of cost.
    pub fn fill(&self) -> usize {
        self.ldl.fill()
    }

    /// Sets the matrix of a step of length `h` with all rows acting.
    pub fn assemble(&mut self, system: &System, mass: &MassMatrix, gradient: &[f64], h: f64) {
        self.base.fill(0.0);
        add(&mut self.base, &self.mass_slots, mass.values.iter().copied());
        add(&mut self.base, &self.row_slots, gradient.iter().copied());
        let mut cursor = 0;
        for group in 0..self.stiffness.factor.len() {
            let scale = h * h * self.stiffness.implicit[group] * self.stiffness.factor[group];
            let columns =
                &self.stiffness.columns[self.stiffness.start[group]..self.stiffness.start[group + 1]];
            for (i, a) in columns.iter().enumerate() {
                for b in &columns[..=i] {
                    let slot = self.stiffness_slots[cursor];
                    cursor += 1;
                    if slot != NONE {
                        self.base[slot] += scale * a.dot(*b);
                    }
                }
            }
        }
        for (index, &dof) in self.free.iter().enumerate() {
            self.base[self.diagonal_slots[index]] += h * system.tree.damping[dof];
        }
        for (row, law) in system.rows.laws.iter().enumerate() {
            let diagonal = self.diagonal_slots[self.free.len() + row];
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
            for &slot in &self.row_slots[system.rows.start[row]..system.rows.start[row + 1]] {
                if slot != NONE {
                    values[slot] = 0.0;
                }
            }
            values[self.diagonal_slots[self.free.len() + row]] = -1.0;
        }
        self.ldl.factorise()
    }

    /// Solves for velocities and impulses. `force` is the right side of every degree of freedom with the
    /// driven columns already moved there; `rows` that of every row. Driven entries of `v` stay.
    pub fn solve(&mut self, force: &[f64], rows: &[f64], v: &mut [f64], impulse: &mut [f64]) {
        for (index, &dof) in self.free.iter().enumerate() {
            self.right[index] = force[dof];
        }
        self.right[self.free.len()..].copy_from_slice(rows);
        self.ldl.solve(&self.right, &mut self.solution);
        for (index, &dof) in self.free.iter().enumerate() {
            v[dof] = self.solution[index];
        }
        impulse.copy_from_slice(&self.solution[self.free.len()..]);
    }

    /// Name of the body or constraint that an unknown belongs to.
    pub fn element<'a>(&self, system: &'a System, unknown: usize) -> &'a str {
        match unknown.checked_sub(self.free.len()) {
            Some(row) => system.constraint_of_row(row).name(),
            None => &system.tree.bodies[system.tree.owner[self.free[unknown]]].name,
        }
    }
}

fn add(base: &mut [f64], slots: &[usize], values: impl Iterator<Item = f64>) {
    for (&slot, value) in slots.iter().zip(values) {
        if slot != NONE {
            base[slot] += value;
        }
    }
}

/// Pairs of unknowns that couple, in the order in which their values come.
struct Pairs {
    mass: Vec<(usize, usize)>,
    rows: Vec<(usize, usize)>,
    stiffness: Vec<(usize, usize)>,
}

impl Pairs {
    fn new(
        system: &System,
        mass: &MassMatrix,
        stiffness: &Stiffness,
        unknown: &[usize],
        free: usize,
    ) -> Self {
        let mass = (0..system.tree.velocities)
            .flat_map(|dof| (mass.row_start[dof]..mass.row_start[dof + 1]).map(move |slot| (dof, slot)))
            .map(|(dof, slot)| (unknown[dof], unknown[mass.columns[slot]]))
            .collect();
        let rows = (0..system.rows.count())
            .flat_map(|row| (system.rows.start[row]..system.rows.start[row + 1]).map(move |e| (row, e)))
            .map(|(row, entry)| (free + row, unknown[system.rows.dofs[entry]]))
            .collect();
        let mut pairs = Vec::new();
        for window in stiffness.start.windows(2) {
            let dofs = &stiffness.dofs[window[0]..window[1]];
            for (i, &a) in dofs.iter().enumerate() {
                pairs.extend(dofs[..=i].iter().map(|&b| (unknown[a], unknown[b])));
            }
        }
        Self { mass, rows, stiffness: pairs }
    }

    fn all(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let pairs = self.mass.iter().chain(&self.rows).chain(&self.stiffness);
        pairs.copied().filter(|&(a, b)| a != NONE && b != NONE)
    }
}

/// Elimination order of the unknowns: joints and rows as blocks.
fn unknown_order(system: &System, unknown: &[usize], free: usize, pairs: &Pairs) -> Vec<usize> {
    let tree = &system.tree;
    let mut node_of_body = vec![NONE; tree.bodies.len()];
    let mut nodes: Vec<Node> = Vec::new();
    let mut members: Vec<Vec<usize>> = Vec::new();
    for (index, body) in tree.bodies.iter().enumerate() {
        let own = body.first_velocity..body.first_velocity + body.joint.velocities();
        let unknowns: Vec<usize> = own.map(|dof| unknown[dof]).filter(|&unknown| unknown != NONE).collect();
        let above = body.parent.map(|parent| node_of_body[parent]).filter(|&node| node != NONE);
        if unknowns.is_empty() {
            node_of_body[index] = above.unwrap_or(NONE);
            continue;
        }
        node_of_body[index] = nodes.len();
        nodes.push(Node { size: unknowns.len(), kind: NodeKind::Joint { above } });
        members.push(unknowns);
    }
    for (row, law) in system.rows.laws.iter().enumerate() {
        nodes.push(Node { size: 1, kind: NodeKind::Row { compliant: law.compliance() > 0.0 } });
        members.push(vec![free + row]);
    }
    let mut node_of_unknown = vec![0; free + system.rows.count()];
    for (node, unknowns) in members.iter().enumerate() {
        for &unknown in unknowns {
            node_of_unknown[unknown] = node;
        }
    }
    let mut edges: Vec<(usize, usize)> =
        pairs.all().map(|(a, b)| (node_of_unknown[a], node_of_unknown[b])).collect();
    edges.sort_unstable();
    edges.dedup();
    elimination_order(&nodes, &edges).into_iter().flat_map(|node| members[node].clone()).collect()
}
