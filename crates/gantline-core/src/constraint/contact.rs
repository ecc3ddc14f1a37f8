//! A point of a body against a plane: one normal row and two tangential rows.
//!
//! Normal: e = depth, T = N = max(0, k (e + τ ė)), the law of ropes. Tangential: a spring of the same
//! stiffness between the point and an anchor on the plane (Cundall and Strack 1979), e = s, the distance
//! along the tangent from the anchor, whose coordinate the state remembers. While |T| ≤ μN it sticks: no creep, and corners that are
//! redundant share by their stiffness. Where the bound is reached the anchor slides along so that it holds.

use glam::DVec3;

use super::{Constraint, Law, Line, Moving, Placed};
use crate::contact::plane::Plane;
use crate::tree::bias::Wrench;
use crate::tree::kinematics::Twist;

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

impl Contact {
    /// Values of the rows with the point [m] in the world.
    fn values(&self, point: DVec3, value: &mut [f64]) {
        value[0] = self.plane.depth(point);
        for (k, tangent) in self.plane.tangents.iter().enumerate() {
            value[1 + k] = tangent.dot(point) - value[1 + k];
        }
    }
}

impl Constraint for Contact {
    fn name(&self) -> &str {
        &self.name
    }

    fn row_dofs(&self) -> Vec<Vec<usize>> {
        vec![self.dofs.clone(); 3]
    }

    fn laws(&self, first_row: usize) -> Vec<Law> {
        Law::of_contact(self.compliance, self.damping_time, self.friction, first_row)
    }

    fn lines(&self) -> usize {
        1
    }

    fn locate(&self, at: &Moving, value: &mut [f64], rate: &mut [f64], lines: &mut [Line]) {
        let pose = &at.kinematics.pose[self.body];
        let arm = pose.rotation * self.at;
        lines[0].from = arm;
        self.values(pose.position + arm, value);
        self.rates(at.twists, at.v, lines, rate);
    }

    fn rates(&self, twists: &[Twist], _v: &[f64], lines: &[Line], rate: &mut [f64]) {
        let velocity = twists[self.body].at(lines[0].from);
        rate[0] = -self.plane.normal.dot(velocity);
        rate[1] = self.plane.tangents[0].dot(velocity);
        rate[2] = self.plane.tangents[1].dot(velocity);
    }

    fn apply(&self, tension: &[f64], lines: &[Line], wrenches: &mut [Wrench]) {
        let Plane { normal, tangents, .. } = &self.plane;
        let needed = tangents[0] * tension[1] + tangents[1] * tension[2] - *normal * tension[0];
        wrenches[self.body].add(needed, lines[0].from);
    }

    fn evaluate(&self, at: &Placed, value: &mut [f64], gradient: &mut [f64]) {
        let Placed { tree, kinematics, .. } = *at;
        let point = kinematics.point(Some(self.body), self.at);
        self.values(point, value);
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
    fn curvature(&self, at: &Placed, _value: f64, group: usize, columns: &mut [DVec3], block: &mut [f64]) {
        let Placed { tree, kinematics, .. } = *at;
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
