//! A point of a body against a plane: one normal row and two tangential rows.
//!
//! Normal: e = depth, T = N = max(0, k (e + τ ė)), the law of ropes. Tangential: a spring of the same
//! stiffness between the point and an anchor on the plane (Cundall and Strack 1979), e = s, the distance
//! along the tangent from the anchor, whose coordinate the state remembers. While |T| ≤ μN it sticks: no creep, and corners that are
//! redundant share by their stiffness. Where the bound is reached the anchor slides along so that it holds.

use glam::DVec3;

use super::{Constraint, Law};
use crate::contact::plane::Plane;
use crate::tree::Tree;
use crate::tree::kinematics::Kinematics;

/// A point that may touch a plane.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Unique name.
    pub name: String,
    /// Index of the group whose forces are added up.
    pub group: usize,
    /// Index of the body.
    pub body: usize,
    /// Point [m], body frame.
    pub at: DVec3,
    /// The plane.
    pub plane: Plane,
    /// 1/k [m/N].
    pub compliance: f64,
    /// τ [s].
    pub damping_time: f64,
    /// μ.
    pub friction: f64,
    /// Degrees of freedom of the body.
    pub dofs: Vec<usize>,
}

impl Constraint for Contact {
    fn name(&self) -> &str {
        &self.name
    }

    fn row_dofs(&self) -> Vec<Vec<usize>> {
        vec![self.dofs.clone(); 3]
    }

    fn laws(&self, first_row: usize) -> Vec<Law> {
        let (compliance, damping_time) = (self.compliance, self.damping_time);
        let friction =
            Law::Friction { compliance, damping_time, coefficient: self.friction, normal: first_row };
        vec![Law::Unilateral { compliance, damping_time }, friction, friction]
    }

    fn evaluate(&self, tree: &Tree, kinematics: &Kinematics, value: &mut [f64], gradient: &mut [f64]) {
        let point = kinematics.point(Some(self.body), self.at);
        value[0] = self.plane.depth(point);
        for (k, tangent) in self.plane.tangents.iter().enumerate() {
            value[1 + k] = tangent.dot(point) - value[1 + k];
        }
        let count = self.dofs.len();
        for (entry, &dof) in self.dofs.iter().enumerate() {
            let column = kinematics.point_column(tree, dof, point);
            gradient[entry] = -self.plane.normal.dot(column);
            gradient[count + entry] = self.plane.tangents[0].dot(column);
            gradient[2 * count + entry] = self.plane.tangents[1].dot(column);
        }
    }

    fn curvature_groups(&self) -> Vec<(usize, Vec<usize>)> {
        (0..3).map(|row| (row, self.dofs.clone())).collect()
    }

    /// The plane is flat: only the point's own path is curved.
    fn curvature(
        &self,
        tree: &Tree,
        kinematics: &Kinematics,
        group: usize,
        columns: &mut [DVec3],
        block: &mut [f64],
    ) {
        let point = kinematics.point(Some(self.body), self.at);
        let direction = [-self.plane.normal, self.plane.tangents[0], self.plane.tangents[1]][group];
        for (column, &dof) in columns.iter_mut().zip(&self.dofs) {
            *column = kinematics.point_column(tree, dof, point);
        }
        let size = self.dofs.len();
        for (j, &row) in self.dofs.iter().enumerate() {
            for (k, &dof) in self.dofs.iter().enumerate() {
                let change = kinematics.column_change(tree, (row, columns[j]), (dof, columns[k]), point);
                block[j * size + k] = direction.dot(change);
            }
        }
    }
}
