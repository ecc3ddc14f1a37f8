//! Unknowns of a step, the pairs that couple, and the order in which they are eliminated. Shared by all
//! matrices of one system.

use super::order::{Node, NodeKind, elimination_order};
use super::symbolic::Symbolic;
use crate::constraint::{AnyConstraint, Law};
use crate::system::System;
use crate::tree::mass::MassMatrix;

/// Entries that touch a driven degree of freedom have no place in the matrix.
pub const NONE: usize = usize::MAX;

/// Unknowns: the free degrees of freedom, then the rows.
#[derive(Debug, Clone)]
pub struct Layout {
    /// Unknown of every degree of freedom, [`NONE`] for driven ones.
    pub unknown: Vec<usize>,
    /// Degrees of freedom that are unknown.
    pub free: Vec<usize>,
    /// Groups of degrees of freedom that the turning of gradients couples.
    pub groups: Vec<Group>,
    /// Pattern and elimination order.
    pub symbolic: Symbolic,
}

/// One group of [`crate::constraint::Constraint::curvature_groups`].
#[derive(Debug, Clone)]
pub struct Group {
    /// Index of the constraint.
    pub constraint: usize,
    /// Number of the group within the constraint.
    pub number: usize,
    /// Row that it belongs to.
    pub row: usize,
    /// Degrees of freedom.
    pub dofs: Vec<usize>,
}

impl Layout {
    /// Layout of `system`.
    pub fn new(system: &System) -> Self {
        Self::of(system, &system.rows.laws, |_| true)
    }

    /// The same for matrices in which the losses of light sheaves are no rows: these stand alone, and the rows of their flows
    /// say whether they hold or how they slip.
    pub fn without_light(system: &System) -> Self {
        Self::of(system, system.exerting_laws(), |_| true)
    }

    /// The same where gradients turn as bodies move, and not as rope is fed.
    pub fn of_bodies(system: &System) -> Self {
        Self::of(system, system.exerting_laws(), |dof| !system.flows.contains(&dof))
    }

    /// With the couplings of the first rows, whose `laws` these are, and of the degrees of freedom that turn gradients.
    fn of(system: &System, laws: &[Law], turns: impl Fn(usize) -> bool) -> Self {
        let free: Vec<usize> =
            (0..system.tree.velocities).filter(|&dof| system.driven[dof].is_none()).collect();
        let mut unknown = vec![NONE; system.tree.velocities];
        for (index, &dof) in free.iter().enumerate() {
            unknown[dof] = index;
        }
        let mut groups = Vec::new();
        for (index, constraint) in system.constraints.iter().enumerate() {
            for (number, (row, mut dofs)) in constraint.curvature_groups().into_iter().enumerate() {
                let row = system.rows.first[index] + row;
                dofs.retain(|&dof| turns(dof));
                groups.push(Group { constraint: index, number, row, dofs });
            }
        }
        let pairs = pairs(system, laws, &groups, (&unknown, free.len()));
        let order = unknown_order(system, &unknown, free.len(), &pairs);
        Self { symbolic: Symbolic::new(order, pairs), unknown, free, groups }
    }

    /// Unknown of a row.
    pub fn row(&self, row: usize) -> usize {
        self.free.len() + row
    }

    /// Name of the body or constraint that an unknown belongs to.
    pub fn element<'a>(&self, system: &'a System, unknown: usize) -> &'a str {
        match unknown.checked_sub(self.free.len()) {
            Some(row) => system.constraint_of_row(row).name(),
            None => &system.tree.bodies[system.tree.owner[self.free[unknown]]].name,
        }
    }
}

/// Pairs of unknowns that couple through inertia, gradients and their turning.
fn pairs(
    system: &System,
    laws: &[Law],
    groups: &[Group],
    (unknown, free): (&[usize], usize),
) -> Vec<(usize, usize)> {
    let mass = MassMatrix::new(&system.tree);
    let mut pairs = Vec::new();
    for dof in 0..system.tree.velocities {
        let slots = mass.row_start[dof]..mass.row_start[dof + 1];
        pairs.extend(mass.columns[slots].iter().map(|&other| (unknown[dof], unknown[other])));
    }
    for (row, law) in laws.iter().enumerate() {
        let entries = system.rows.start[row]..system.rows.start[row + 1];
        pairs.extend(system.rows.dofs[entries].iter().map(|&dof| (free + row, unknown[dof])));
        pairs.extend(law.bounded_by().map(|other| (free + row, free + other)));
    }
    for group in groups {
        for (i, &a) in group.dofs.iter().enumerate() {
            pairs.extend(group.dofs[..=i].iter().map(|&b| (unknown[a], unknown[b])));
        }
    }
    pairs.retain(|&(a, b)| a != NONE && b != NONE);
    pairs
}

/// Elimination order of the unknowns: joints and rows as blocks.
fn unknown_order(system: &System, unknown: &[usize], free: usize, pairs: &[(usize, usize)]) -> Vec<usize> {
    let tree = &system.tree;
    let mut node_of_body = vec![NONE; tree.bodies.len()];
    let mut nodes: Vec<Node> = Vec::new();
    let mut members: Vec<Vec<usize>> = Vec::new();
    for (index, body) in tree.bodies.iter().enumerate() {
        let unknowns: Vec<usize> =
            body.dofs().map(|dof| unknown[dof]).filter(|&unknown| unknown != NONE).collect();
        let above = body.parent.map(|parent| node_of_body[parent]).filter(|&node| node != NONE);
        if unknowns.is_empty() {
            node_of_body[index] = above.unwrap_or(NONE);
            continue;
        }
        node_of_body[index] = nodes.len();
        nodes.push(Node { size: unknowns.len(), kind: NodeKind::Joint { above, after: None } });
        members.push(unknowns);
    }
    let first_row = nodes.len();
    for light in &system.light {
        for (&dof, row) in light.dofs.iter().zip(light.rows.clone()) {
            if let NodeKind::Joint { after, .. } = &mut nodes[node_of_body[tree.owner[dof]]].kind {
                *after = Some(first_row + row);
            }
        }
    }
    for (row, law) in system.rows.laws.iter().enumerate() {
        let holds = match system.constraint_of_row(row) {
            AnyConstraint::Brake(brake) => Some(node_of_body[tree.owner[brake.dof]]),
            AnyConstraint::Pin(pin) => Some(node_of_body[tree.owner[pin.dof]]),
            AnyConstraint::Rope(_)
            | AnyConstraint::Contact(_)
            | AnyConstraint::Touch(_)
            | AnyConstraint::Stop(_) => None,
        };
        nodes.push(Node { size: 1, kind: NodeKind::Row { compliant: law.compliance() > 0.0, holds } });
        members.push(vec![free + row]);
    }
    let mut node_of_unknown = vec![0; free + system.rows.count()];
    for (node, unknowns) in members.iter().enumerate() {
        for &unknown in unknowns {
            node_of_unknown[unknown] = node;
        }
    }
    let mut edges: Vec<(usize, usize)> =
        pairs.iter().map(|&(a, b)| (node_of_unknown[a], node_of_unknown[b])).collect();
    edges.sort_unstable();
    edges.dedup();
    elimination_order(&nodes, &edges).into_iter().flat_map(|node| members[node].clone()).collect()
}
