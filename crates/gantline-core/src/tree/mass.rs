//! Mass matrix by the composite-rigid-body algorithm (Featherstone 2008, section 6.2), with the tree's
//! sparsity: entry (j, k) exists where one of j and k moves the other's body.

use glam::{DMat3, DVec3};

use super::Tree;
use super::bias::Wrench;
use super::joint::Motion;
use super::kinematics::Kinematics;

/// Mass, first and second moment of a composite of bodies about a reference point, world axes.
#[derive(Debug, Clone, Copy)]
struct Composite {
    mass: f64,
    /// Σ m (c − o) [kg m].
    first: DVec3,
    /// Inertia about o [kg m²].
    second: DMat3,
}

/// The mass matrix, lower triangle by rows: row j holds the columns `support(owner(j))` up to j.
#[derive(Debug, Clone)]
pub struct MassMatrix {
    /// Start of every row in `values`; the row of dof j ends with its diagonal.
    pub row_start: Vec<usize>,
    /// Column of every value.
    pub columns: Vec<usize>,
    /// Values [kg, kg m, kg m²].
    pub values: Vec<f64>,
    composites: Vec<Composite>,
}

/// Parallel-axis term of a unit mass: |a|² 1 − a aᵀ.
fn steiner(arm: DVec3) -> DMat3 {
    DMat3::from_diagonal(DVec3::splat(arm.length_squared()))
        - DMat3::from_cols(arm * arm.x, arm * arm.y, arm * arm.z)
}

impl MassMatrix {
    /// The pattern for `tree`, values zero.
    pub fn new(tree: &Tree) -> Self {
        let mut row_start = vec![0];
        let mut columns = Vec::new();
        for dof in 0..tree.velocities {
            let support = &tree.support[tree.owner[dof]];
            columns.extend(support.iter().copied().filter(|&other| other <= dof));
            row_start.push(columns.len());
        }
        let empty = Composite { mass: 0.0, first: DVec3::ZERO, second: DMat3::ZERO };
        let values = vec![0.0; columns.len()];
        Self { row_start, columns, values, composites: vec![empty; tree.bodies.len()] }
    }

    /// Evaluates M at the configuration of `kinematics`.
    pub fn update(&mut self, tree: &Tree, kinematics: &Kinematics) {
        for (index, body) in tree.bodies.iter().enumerate() {
            self.composites[index] = if tree.is_point[index] {
                Composite { mass: body.mass, first: DVec3::ZERO, second: DMat3::ZERO }
            } else {
                let (rotation, lever) = (kinematics.pose[index].rotation, kinematics.lever[index]);
                let turned = rotation * body.inertia * rotation.transpose();
                Composite {
                    mass: body.mass,
                    first: lever * body.mass,
                    second: turned + steiner(lever) * body.mass,
                }
            };
        }
        for index in (0..tree.bodies.len()).rev() {
            if let Some(parent) = tree.bodies[index].parent {
                let child = self.composites[index];
                let shift = kinematics.arm[index];
                let above = &mut self.composites[parent];
                above.mass += child.mass;
                above.first += child.first + shift * child.mass;
                above.second += child.second + shifted(&child, shift);
            }
        }
        for dof in 0..tree.velocities {
            let body = tree.owner[dof];
            let composite = &self.composites[body];
            let origin = kinematics.pose[body].position;
            let column = &kinematics.columns[dof];
            let (momentum, angular) = match tree.motions[dof] {
                Motion::Shift => (column.linear * composite.mass, composite.first.cross(column.linear)),
                Motion::Turn => (column.angular.cross(composite.first), composite.second * column.angular),
            };
            for slot in self.row_start[dof]..self.row_start[dof + 1] {
                let other = self.columns[slot];
                let above = &kinematics.columns[other];
                let linear = kinematics.point_column(tree, other, origin);
                self.values[slot] = angular.dot(above.angular) + momentum.dot(linear);
            }
            self.values[self.row_start[dof + 1] - 1] += tree.armature[dof];
        }
        if !tree.forces.is_empty() {
            self.add_inertia(tree, kinematics);
        }
    }

    /// Where the entry (row, column) is, column ≤ row, the column's joint on the way up from the row's.
    pub fn slot(&self, row: usize, column: usize) -> usize {
        // The joints above are the same for all rows below a column: it stands where its own diagonal does.
        self.row_start[row] + self.row_start[column + 1] - 1 - self.row_start[column]
    }

    /// What accelerates a body and all that hangs on it by `acceleration` [m/s²] without turning, about its
    /// origin.
    pub fn accelerated(&self, body: usize, acceleration: DVec3) -> Wrench {
        let Composite { mass, first, .. } = &self.composites[body];
        Wrench { force: acceleration * *mass, moment: first.cross(acceleration) }
    }

    /// Diagonal entry of a degree of freedom.
    pub fn diagonal(&self, dof: usize) -> f64 {
        self.values[self.row_start[dof + 1] - 1]
    }

    /// `out` = M x.
    pub fn multiply(&self, x: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for row in 0..x.len() {
            let diagonal = self.row_start[row + 1] - 1;
            for slot in self.row_start[row]..diagonal {
                let column = self.columns[slot];
                out[row] += self.values[slot] * x[column];
                out[column] += self.values[slot] * x[row];
            }
            out[row] += self.values[diagonal] * x[row];
        }
    }

    /// xᵀ M x.
    pub fn quadratic(&self, x: &[f64]) -> f64 {
        let mut sum = 0.0;
        for row in 0..x.len() {
            let diagonal = self.row_start[row + 1] - 1;
            let mut off = 0.0;
            for slot in self.row_start[row]..diagonal {
                off += self.values[slot] * x[self.columns[slot]];
            }
            sum += x[row] * (2.0 * off + self.values[diagonal] * x[row]);
        }
        sum
    }
}

/// Change of the second moment when the reference moves by −`shift`.
fn shifted(composite: &Composite, shift: DVec3) -> DMat3 {
    // I' = I + m (|s|² 1 − s sᵀ) + 2 (s·f) 1 − (s fᵀ + f sᵀ), f the first moment.
    let first = composite.first;
    let outer = |a: DVec3, b: DVec3| DMat3::from_cols(a * b.x, a * b.y, a * b.z);
    steiner(shift) * composite.mass + DMat3::from_diagonal(DVec3::splat(2.0 * shift.dot(first)))
        - outer(shift, first)
        - outer(first, shift)
}
