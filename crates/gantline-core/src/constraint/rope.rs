//! Length of a rope: g = Σ parts + Σ arcs − L (paper eqs. 16, 19, 20).
//!
//! With n the unit direction of a part from A to B, ġ = Σ n·(v_B − v_A): each part adds n·(J_B − J_A), the
//! sum of eqs. (18) and (22). A degree of freedom that moves A and B as one rigid whole cannot change
//! |B − A| and is left out of the pattern: so the sheaves of an equalizer do not couple to what carries
//! the whole of it.

use glam::DVec3;

use super::{Constraint, Law};
use crate::rope::material::Material;
use crate::rope::route::{Route, Straight};
use crate::tree::Tree;
use crate::tree::kinematics::Kinematics;

/// Which degrees of freedom move which end of a straight part.
#[derive(Debug, Clone)]
struct PartDofs {
    /// (degree of freedom, entry of the row) that move the start only.
    from: Vec<(usize, usize)>,
    /// (degree of freedom, entry of the row) that move the end only.
    to: Vec<(usize, usize)>,
}

/// A rope as a constraint.
#[derive(Debug, Clone)]
pub struct Rope {
    /// Unique name.
    pub name: String,
    /// Its way.
    pub route: Route,
    /// Unstretched length L [m].
    pub length: f64,
    /// What it is made of.
    pub material: Material,
    dofs: Vec<usize>,
    part_dofs: Vec<PartDofs>,
}

/// Members of `a` that `b` has not; both ascending.
fn without(a: &[usize], b: &[usize]) -> Vec<usize> {
    a.iter().copied().filter(|dof| b.binary_search(dof).is_err()).collect()
}

/// Adds `direction`·J of a world point [m] to the row's entries: l·n + a·((x − o)×n), the moment once per joint.
fn pull(
    tree: &Tree,
    kinematics: &Kinematics,
    dofs: &[(usize, usize)],
    point: DVec3,
    direction: DVec3,
    gradient: &mut [f64],
) {
    let mut owner = usize::MAX;
    let mut moment = DVec3::ZERO;
    for &(dof, entry) in dofs {
        if tree.owner[dof] != owner {
            owner = tree.owner[dof];
            moment = (point - kinematics.pose[owner].position).cross(direction);
        }
        let column = &kinematics.columns[dof];
        gradient[entry] += column.linear.dot(direction) + column.angular.dot(moment);
    }
}

impl Rope {
    /// A rope in `tree`.
    pub fn new(name: String, route: Route, length: f64, material: Material, tree: &Tree) -> Self {
        let ends: Vec<(Vec<usize>, Vec<usize>)> = route
            .parts
            .iter()
            .map(|part| {
                let (from, to) = (tree.support_of(part.from.body), tree.support_of(part.to.body));
                (without(from, to), without(to, from))
            })
            .collect();
        let mut dofs: Vec<usize> =
            ends.iter().flat_map(|(from, to)| from.iter().chain(to)).copied().collect();
        dofs.sort_unstable();
        dofs.dedup();
        let entries = |list: &[usize]| {
            list.iter().map(|&dof| (dof, dofs.partition_point(|&other| other < dof))).collect()
        };
        let part_dofs =
            ends.iter().map(|(from, to)| PartDofs { from: entries(from), to: entries(to) }).collect();
        Self { name, route, length, material, dofs, part_dofs }
    }

    /// Where the straight parts lie now.
    pub fn straights<'a>(&'a self, kinematics: &'a Kinematics) -> impl Iterator<Item = Straight> + 'a {
        self.route.parts.iter().map(move |part| part.locate(kinematics))
    }

    /// The part of the geometric stiffness of one straight part that is positive semidefinite by construction:
    /// fills `columns` with the transversal relative velocity c per degree of freedom of the group and returns
    /// the factor f of K = f Σ cᵢ·cⱼ, f = T/ℓ [N/m].
    pub fn geometric_stiffness(
        &self,
        tree: &Tree,
        kinematics: &Kinematics,
        tension: f64,
        group: usize,
        columns: &mut [DVec3],
    ) -> f64 {
        let straight = self.route.parts[group].locate(kinematics);
        let part = &self.part_dofs[group];
        let across = |vector: DVec3| vector - straight.direction * straight.direction.dot(vector);
        let (from, to) = columns.split_at_mut(part.from.len());
        for (column, &(dof, _)) in from.iter_mut().zip(&part.from) {
            *column = -across(kinematics.point_column(tree, dof, straight.from));
        }
        for (column, &(dof, _)) in to.iter_mut().zip(&part.to) {
            *column = across(kinematics.point_column(tree, dof, straight.to));
        }
        if straight.length > 0.0 { tension / straight.length } else { 0.0 }
    }
}

impl Constraint for Rope {
    fn name(&self) -> &str {
        &self.name
    }

    fn row_dofs(&self) -> Vec<Vec<usize>> {
        vec![self.dofs.clone()]
    }

    fn laws(&self, _first_row: usize) -> Vec<Law> {
        let Material { compliance, damping_time } = self.material;
        vec![Law::Unilateral { compliance, damping_time }]
    }

    fn evaluate(&self, tree: &Tree, kinematics: &Kinematics, value: &mut [f64], gradient: &mut [f64]) {
        gradient.fill(0.0);
        let mut length = self.route.arcs;
        for (straight, dofs) in self.straights(kinematics).zip(&self.part_dofs) {
            length += straight.length;
            pull(tree, kinematics, &dofs.from, straight.from, -straight.direction, gradient);
            pull(tree, kinematics, &dofs.to, straight.to, straight.direction, gradient);
        }
        value[0] = length - self.length;
    }

    fn curvature_groups(&self) -> Vec<(usize, Vec<usize>)> {
        let dofs = |list: &[(usize, usize)]| list.iter().map(|&(dof, _)| dof).collect::<Vec<_>>();
        self.part_dofs.iter().map(|part| (0, [dofs(&part.from), dofs(&part.to)].concat())).collect()
    }

    /// ∂G_j/∂q_k = c_j·c_k/ℓ + n·(∂J_j/∂q_k of the end − of the start): the part turns, and its ends move on
    /// curves.
    fn curvature(
        &self,
        tree: &Tree,
        kinematics: &Kinematics,
        group: usize,
        columns: &mut [DVec3],
        block: &mut [f64],
    ) {
        let straight = self.route.parts[group].locate(kinematics);
        let PartDofs { from, to } = &self.part_dofs[group];
        let inverse = if straight.length > 0.0 { 1.0 / straight.length } else { 0.0 };
        let (direction, size) = (straight.direction, from.len() + to.len());
        let (columns, split) = (&mut columns[..size], from.len());
        for (column, &(dof, _)) in columns.iter_mut().zip(from) {
            *column = kinematics.point_column(tree, dof, straight.from);
        }
        for (column, &(dof, _)) in columns[split..].iter_mut().zip(to) {
            *column = kinematics.point_column(tree, dof, straight.to);
        }
        let ends = [(0..split, from, straight.from, -1.0), (split..size, to, straight.to, 1.0)];
        for (own, dofs, point, sign) in ends {
            for (j, &(row, _)) in own.clone().zip(dofs) {
                let block = &mut block[j * size..(j + 1) * size];
                let turned = (columns[j] - direction * direction.dot(columns[j])) * (sign * inverse);
                for (k, value) in block.iter_mut().enumerate() {
                    *value = turned.dot(columns[k]) * if k < split { -1.0 } else { 1.0 };
                }
                let bent = direction * sign;
                for (k, &(dof, _)) in own.clone().zip(dofs) {
                    let change = kinematics.column_change(tree, (row, columns[j]), (dof, columns[k]), point);
                    block[k] += bent.dot(change);
                }
            }
        }
    }
}
